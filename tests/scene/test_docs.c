/* docs/scenes.md shows the registry as it is, and its examples load.
 *
 * test_docs --write puts the present table into the file. */
#include "support.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scene/fields.h"

#define BEGIN "<!-- The table is made by test_docs --write from src/scene/fields.c. -->\n"
#define END   "<!-- End of the table. -->\n"

static const char path[] = SKV_SOURCE_DIR "/docs/scenes.md";

/* Adds a line of the table. */
static size_t print_field(char *text, size_t size, const skv_field *f)
{
    char range[128], from[32], to[32];
    skv_format_number(f->minimum, from);
    skv_format_number(f->maximum, to);
    const char *space = f->unit[0] != '\0' ? " " : "";
    switch (f->type) {
    case SKV_FIELD_NUMBER:
        snprintf(range, sizeof range, "%s to %s%s%s", from, to, space, f->unit);
        break;
    case SKV_FIELD_INTEGER:
        snprintf(range, sizeof range, "whole, %s to %s", from, to);
        break;
    case SKV_FIELD_TEXT:
        snprintf(range, sizeof range, "text, at most %s bytes", to);
        break;
    case SKV_FIELD_BOOLEAN:
        snprintf(range, sizeof range, "true or false");
        break;
    case SKV_FIELD_CHOICE: {
        size_t used = 0;
        for (const char *c = f->choices; *c != '\0'; c++)
            used +=
                (size_t)snprintf(range + used, sizeof range - used, *c == '|' ? ", " : "%c", *c);
        break;
    }
    }
    return (size_t)snprintf(text, size, "| `%s` | %s | %s | %s |\n", f->path, range,
                            f->default_text, f->help);
}

/* The table between the marks, on the heap. */
static char *make_table(void)
{
    size_t size = 32768, used;
    char *text = calloc(size, 1);
    int count;
    const skv_field *fields = skv_scene_fields(&count);
    used = (size_t)snprintf(text, size,
                            BEGIN "| field | allowed | default | meaning |\n|---|---|---|---|\n");
    for (int i = 0; i < count; i++)
        used += print_field(text + used, size - used, &fields[i]);
    snprintf(text + used, size - used, END);
    return text;
}

/* The document as text, on the heap, and where the table begins and ends in it. */
static char *read_document(size_t *begin, size_t *end)
{
    buffer b = buffer_read(path);
    char *text = calloc(b.size + 1, 1);
    memcpy(text, b.data, b.size);
    buffer_free(&b);
    const char *first = strstr(text, BEGIN), *last = strstr(text, END);
    assert_true(first != NULL && last != NULL && first < last);
    *begin = (size_t)(first - text);
    *end = (size_t)(last - text) + strlen(END);
    return text;
}

static void test_the_table_is_up_to_date(void **state)
{
    (void)state;
    size_t begin, end;
    char *text = read_document(&begin, &end), *table = make_table();
    text[end] = '\0';
    if (strcmp(text + begin, table) != 0)
        fail_msg("docs/scenes.md is out of date: run test_docs --write");
    free(table);
    free(text);
}

/* Every JSON example of the document is a scene. */
static void test_the_examples_load(void **state)
{
    (void)state;
    size_t begin, end;
    char *text = read_document(&begin, &end);
    int examples = 0;
    for (char *at = text; (at = strstr(at, "```json\n")) != NULL;) {
        at += 8;
        char *stop = strstr(at, "```");
        assert_non_null(stop);
        *stop = '\0';
        skv_scene *scene;
        skv_error error = {0};
        if (load_text(at, NULL, &scene, &error) != SKV_OK)
            fail_msg("%s", error.text);
        skv_scene_destroy(scene);
        at = stop + 1;
        examples++;
    }
    assert_true(examples >= 2);
    free(text);
}

static int write_document(void)
{
    size_t begin, end;
    char *text = read_document(&begin, &end), *table = make_table();
    FILE *file = fopen(path, "wb");
    if (file == NULL)
        return 1;
    fwrite(text, 1, begin, file);
    fputs(table, file);
    fputs(text + end, file);
    free(table);
    free(text);
    return fclose(file) == 0 ? 0 : 1;
}

int main(int argc, char **argv)
{
    if (argc == 2 && strcmp(argv[1], "--write") == 0)
        return write_document();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_table_is_up_to_date),
        cmocka_unit_test(test_the_examples_load),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
