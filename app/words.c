/* Words: sentences about a picture, and where translations lie. Invariant: every text a user sees
 * went through gettext; those of the library's tables are in po/ because po/strings.c names them.
 */
#include "words.h"

#include <locale.h>
#include <string.h>

/* Below this share of its speed a scene counts as slow. */
#define KEEPS_UP 0.95

static bool bind_if_there(const char *folder, const char *below)
{
    char *path = g_build_filename(folder, below, NULL);
    bool there = g_file_test(path, G_FILE_TEST_IS_DIR);
    if (there)
        bindtextdomain("skvalp", path);
    g_free(path);
    return there;
}

void play_words_load(void)
{
    setlocale(LC_ALL, "");
    char *program = g_file_read_link("/proc/self/exe", NULL);
    if (program) {
        char *folder = g_path_get_dirname(program);
        if (!bind_if_there(folder, "po"))
            bind_if_there(folder, "../share/locale");
        g_free(folder);
        g_free(program);
    }
    bind_textdomain_codeset("skvalp", "UTF-8");
    textdomain("skvalp");
}

const char *play_word(const char *text)
{
    return text && *text ? gettext(text) : text; /* "" is the head of the translations */
}

char *play_english_title_of_path(const char *path)
{
    const char *dot = strrchr(path, '.');
    char *title = g_strdup(dot ? dot + 1 : path);
    g_strdelimit(title, "_", ' ');
    title[0] = g_ascii_toupper(title[0]);
    return title;
}

char *play_title_of_path(const char *path)
{
    char *english = play_english_title_of_path(path);
    char *title = g_strdup(play_word(english));
    g_free(english);
    return title;
}

bool play_is_slow(const skv_picture *picture)
{
    return !picture->paused && !picture->at_rest && !picture->seeking && picture->pace < KEEPS_UP;
}

/* "12 960": groups of three digits, with thin spaces that keep together. */
static char *count_text(int count)
{
    if (count >= 1000000)
        return g_strdup_printf("%d\u202f%03d\u202f%03d", count / 1000000, count / 1000 % 1000,
                               count % 1000);
    if (count >= 10000)
        return g_strdup_printf("%d\u202f%03d", count / 1000, count % 1000);
    return g_strdup_printf("%d", count);
}

char *play_words_of_pace(const skv_picture *picture)
{
    if (picture->seeking)
        return g_strdup(_("going back"));
    if (picture->paused)
        return g_strdup(_("paused"));
    if (picture->at_rest)
        return g_strdup(_("at rest"));
    double pace = picture->speed * (play_is_slow(picture) ? picture->pace : 1);
    if (pace == 1)
        return g_strdup(_("real time"));
    /* Translators: how fast the water goes, such as 0.4× of real time. */
    return g_strdup_printf(_("%.2g× of real time"), pace);
}

/* Units. */

static bool si_units;

void play_words_set_si(bool si)
{
    si_units = si;
}

bool play_words_si(void)
{
    return si_units;
}

const char *play_word_of_unit(const char *unit, double *size)
{
    return play_word(skv_reading_unit(unit, !si_units, size));
}

/* The unit comes after the number. */
char *play_words_of_reading(double value, const char *unit)
{
    char text[64];
    skv_format_reading(value, unit, !si_units, text, sizeof text);
    char *space = strchr(text, ' ');
    if (!space)
        return g_strdup(text);
    *space = '\0';
    return g_strdup_printf("%s %s", text, play_word_of_unit(unit, NULL));
}

char *play_words_of_quantity(const char *name, const char *unit, double *size)
{
    const char *shown = play_word_of_unit(unit, size);
    return *shown ? g_strdup_printf("%s (%s)", play_word(name), shown) : g_strdup(play_word(name));
}

char *play_words_of_amount(const skv_picture *picture)
{
    int count = picture->frame.particles.count;
    char *number = count_text(count);
    /* Translators: the number is written with thin spaces, such as 12 960. */
    char *text =
        g_strdup_printf(ngettext("%s particle", "%s particles", (unsigned long)count), number);
    g_free(number);
    return text;
}

char *play_words_of_picture(const skv_picture *picture)
{
    char *amount = play_words_of_amount(picture), *pace = play_words_of_pace(picture);
    char *text = g_strdup_printf("%s, %s", amount, pace);
    g_free(amount);
    g_free(pace);
    return text;
}
