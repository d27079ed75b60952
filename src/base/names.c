/* How alike names are: what "did you mean" goes by. */
#include "base/names.h"

#include "skvalp/base.h"

enum { LONGEST = 127 };

static int cut_length(const char *text)
{
    int length = 0;
    while (length < LONGEST && text[length] != '\0')
        length++;
    return length;
}

int skv_edit_distance(const char *a, const char *b)
{
    int row[LONGEST + 1] = {0};
    int width = cut_length(b), height = cut_length(a);
    for (int j = 0; j <= width; j++)
        row[j] = j;
    for (int i = 1; i <= height; i++) {
        int diagonal = row[0];
        row[0] = i;
        for (int j = 1; j <= width; j++) {
            int best = diagonal + (a[i - 1] != b[j - 1]);
            diagonal = row[j];
            if (row[j] + 1 < best)
                best = row[j] + 1;
            if (row[j - 1] + 1 < best)
                best = row[j - 1] + 1;
            row[j] = best;
        }
    }
    return row[width];
}

static bool begins_with(const char *text, const char *beginning)
{
    while (*beginning != '\0' && *text == *beginning) {
        text++;
        beginning++;
    }
    return *beginning == '\0';
}

const char *skv_nearest_name(const char *text, const char *const *names, int count)
{
    const char *nearest = NULL;
    int length = cut_length(text), least = 2 + length / 3;
    for (int i = 0; i < count; i++) {
        /* Who stopped typing early means the whole word. */
        bool begun = length >= 2 && begins_with(names[i], text);
        int distance = begun ? 1 : skv_edit_distance(text, names[i]);
        if (distance < least) {
            least = distance;
            nearest = names[i];
        }
    }
    return nearest;
}
