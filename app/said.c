/* What the library says, in the language of the reader: a message is compared with the templates
 * that are translated (scripts/update-po.sh takes them from the library's sources), and what stands
 * where they have %s is filled in. Invariant: what no template fits is as it was, so that nothing
 * is hidden; web/page/ui/said.ts does the same.
 */
#include "said.h"

#include <stdbool.h>
#include <string.h>

#include "words.h"

typedef struct template
{
    char *english;
    GRegex *form;
    int certain; /* characters that are not filled in: the more, the better it fits */
}
template;

static char *say(const char *english);

/* The templates. */

static gint most_certain_first(gconstpointer a, gconstpointer b)
{
    return (*(template *const *)b)->certain - (*(template *const *)a)->certain;
}

static void add(GPtrArray *all, const char *english)
{
    /* What has no words is a form of anything. */
    if (!strstr(english, "%s") ||
        !g_regex_match_simple("[a-z]+ [(]?[a-z]{2,}", english, 0, (GRegexMatchFlags)0))
        return;
    char **parts = g_strsplit(english, "%s", -1);
    GString *form = g_string_new("^");
    int certain = 0;
    for (int i = 0; parts[i]; i++) {
        char *escaped = g_regex_escape_string(parts[i], -1);
        g_string_append_printf(form, "%s%s", i > 0 ? "(.*?)" : "", escaped);
        certain += (int)strlen(parts[i]);
        g_free(escaped);
    }
    g_string_append_c(form, '$');
    GRegex *compiled = g_regex_new(form->str, G_REGEX_DOTALL, (GRegexMatchFlags)0, NULL);
    if (compiled) {
        template *one = g_new(template, 1);
        *one = (template){g_strdup(english), compiled, certain};
        g_ptr_array_add(all, one);
    }
    g_string_free(form, TRUE);
    g_strfreev(parts);
}

/* The file of the translations: gettext finds a text in it, and cannot tell which there are. */
static char *translations_file(void)
{
    const char *head = "", *spoken = strstr(gettext(head), "Language: ");
    if (!spoken)
        return NULL;
    spoken += strlen("Language: ");
    char *language = g_strndup(spoken, strcspn(spoken, "\n"));
    char *path =
        g_build_filename(bindtextdomain("skvalp", NULL), language, "LC_MESSAGES/skvalp.mo", NULL);
    g_free(language);
    return path;
}

/* Its form is in gettext's manual: magic, version, count, and where the places of the texts are. */
static void add_all(GPtrArray *all, const char *bytes, gsize size)
{
    enum { MAGIC, VERSION, COUNT, PLACES, HEAD };
    guint32 head[HEAD], place[2];
    if (size < sizeof head)
        return;
    memcpy(head, bytes, sizeof head);
    for (guint64 i = 0; head[MAGIC] == 0x950412deU && i < head[COUNT]; i++) {
        guint64 at = head[PLACES] + i * sizeof place;
        if (at + sizeof place > size)
            return;
        memcpy(place, bytes + at, sizeof place);
        if ((guint64)place[0] + place[1] < size && bytes[place[0] + place[1]] == '\0')
            add(all, bytes + place[1]);
    }
}

/* Read when something is said first. */
static const GPtrArray *templates(void)
{
    static GPtrArray *all;
    if (all)
        return all;
    char *path = translations_file(), *bytes;
    gsize size;
    all = g_ptr_array_new();
    if (path && g_file_get_contents(path, &bytes, &size, NULL)) {
        add_all(all, bytes, size);
        g_free(bytes);
    }
    g_ptr_array_sort(all, most_certain_first);
    g_free(path);
    return all;
}

/* Messages. */

/* "0.25 m": a number, and a unit if there is one. Null for anything else. */
static char *number_in(const char *text)
{
    const char *space = strchr(text, ' ');
    char *number = space ? g_strndup(text, (gsize)(space - text)) : g_strdup(text), *said = NULL;
    const char *unit = space ? space : "";
    double value;
    if (skv_parse_number(number, &value) && !strchr(space ? space + 1 : "", ' '))
        said = g_strconcat(skv_number_shown(number, play_numerals()).text, unit, NULL);
    g_free(number);
    return said;
}

static char *say_argument(const char *text)
{
    char *number = number_in(text);
    return number ? number : say(text);
}

static char *fill(const char *words, const GMatchInfo *found)
{
    GString *text = g_string_new("");
    const char *at;
    for (int i = 1; (at = strstr(words, "%s")); i++, words = at + strlen("%s")) {
        char *part = g_match_info_fetch(found, i), *said = say_argument(part ? part : "");
        g_string_append_printf(text, "%.*s%s", (int)(at - words), words, said);
        g_free(said);
        g_free(part);
    }
    g_string_append(text, words);
    return g_string_free(text, FALSE);
}

/* What a text fits as a whole, and by how many characters that are not filled in. */
typedef struct fit {
    const char *text;     /* of the whole, what it fits; null: none */
    const template *form; /* null: it is translated as it stands */
    int certain;
} fit;

static fit fit_of(const char *text)
{
    const GPtrArray *all = templates();
    if (play_word(text) != text)
        return (fit){text, NULL, (int)strlen(text)};
    for (guint i = 0; i < all->len; i++) {
        const template *one = g_ptr_array_index(all, i);
        if (g_regex_match(one->form, text, (GRegexMatchFlags)0, NULL))
            return (fit){text, one, one->certain};
    }
    return (fit){0};
}

static char *say_fit(const fit *f)
{
    GMatchInfo *found;
    if (!f->form)
        return g_strdup(play_word(f->text));
    g_regex_match(f->form->form, f->text, (GRegexMatchFlags)0, &found);
    char *said = fill(gettext(f->form->english), found);
    g_match_info_free(found);
    return said;
}

/* By itself, or behind names of files, places and fields: "a.json:2: gravity: is empty". The
 * longest text that fits counts, for a short one takes names for what it is about. Null if none
 * fits. */
static char *say_whole(const char *text)
{
    fit best = fit_of(text);
    for (const char *at = text; (at = strstr(at, ": ")); at++) {
        fit here = fit_of(at + 2);
        if (here.certain > best.certain)
            best = here;
    }
    if (!best.text)
        return NULL;
    char *rest = say_fit(&best);
    if (best.text == text)
        return rest;
    char *names = g_strndup(text, (gsize)(best.text - 2 - text)), *first = say(names);
    char *said = g_strconcat(first, ": ", rest, NULL);
    g_free(names);
    g_free(first);
    g_free(rest);
    return said;
}

/* In two parts, if that helps: "FILE: what is wrong; what to do". */
static char *say_parts(const char *text, const char *between)
{
    const char *at = strstr(text, between);
    if (!at)
        return NULL;
    char *before = g_strndup(text, (gsize)(at - text)), *first = say(before);
    char *rest = say(at + strlen(between)), *said = NULL;
    if (!g_str_equal(first, before) || !g_str_equal(rest, at + strlen(between)))
        said = g_strconcat(first, between, rest, NULL);
    g_free(before);
    g_free(first);
    g_free(rest);
    return said;
}

/* "abc" is not a number: a value, and what is wrong with it. */
static char *say_complaint(const char *text)
{
    const char *at = strstr(text, " is "), *words = at ? gettext(at + 1) : NULL;
    if (!at || words == at + 1)
        return NULL;
    char *value = g_strndup(text, (gsize)(at - text)), *said = say_argument(value);
    char *both = g_strconcat(said, " ", words, NULL);
    g_free(value);
    g_free(said);
    return both;
}

static char *say(const char *text)
{
    char *said = say_whole(text);
    said = said ? said : say_parts(text, "; ");
    said = said ? said : say_parts(text, ": ");
    said = said ? said : say_complaint(text);
    return said ? said : g_strdup(text);
}

/* As people write them: "to 1000 m/s²". */
static char *spell_units(const char *text)
{
    static GRegex *squares;
    if (!squares)
        squares =
            g_regex_new(" (kg/)?m(/s)?\\K\\^2", (GRegexCompileFlags)0, (GRegexMatchFlags)0, NULL);
    return g_regex_replace_literal(squares, text, -1, 0, "²", (GRegexMatchFlags)0, NULL);
}

char *play_said(const char *english)
{
    char *said = templates()->len > 0 ? say(english) : g_strdup(english);
    char *spelt = spell_units(said);
    g_free(said);
    return spelt;
}
