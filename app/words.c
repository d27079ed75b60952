/* Words: sentences about a picture, and where translations lie. Invariant: every text a user sees
 * went through gettext; those of the library's tables are in po/ because po/strings.c names them.
 */
#include "words.h"

#include <locale.h>
#include <math.h>
#include <string.h>

static const skv_numerals *numerals;

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
    /* Numbers are those of the language that is spoken: of the translations that were found. */
    const char *head = "", *spoken = strstr(gettext(head), "Language: ");
    numerals = skv_numerals_of(spoken ? spoken + strlen("Language: ") : NULL);
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

char *play_words_of_pace(const skv_stage *stage)
{
    skv_going going = skv_control_going(stage);
    const char *words = _(going.words), *place = strstr(words, "%s");
    return place ? g_strdup_printf("%.*s%s%s", (int)(place - words), words,
                                   play_number_short(going.times, 2).text, place + strlen("%s"))
                 : g_strdup(words);
}

/* Numbers. */

skv_digits play_number(double value, int decimals)
{
    return skv_number(value, decimals, numerals);
}

skv_digits play_number_short(double value, int digits)
{
    return skv_number_short(value, digits, numerals);
}

const skv_numerals *play_numerals(void)
{
    return numerals;
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

skv_unit play_unit_of(const char *si)
{
    return skv_unit_of(si, !si_units);
}

/* The unit comes after the number. */
static char *join(const skv_digits *number, const char *unit)
{
    bool bare = !*unit || g_str_equal(number->text, "–");
    return g_strconcat(number->text, bare ? "" : numerals->group, bare ? "" : play_word(unit),
                       NULL);
}

char *play_words_of_reading(double value, const char *si)
{
    skv_unit unit = play_unit_of(si);
    skv_digits number = skv_number_in(value, unit, numerals);
    return join(&number, unit.name);
}

int play_main_channel(skv_instrument_kind kind)
{
    const skv_gauge *gauge = skv_gauge_of(kind);
    return gauge ? gauge->channel : 0;
}

char *play_words_of_probe(const skv_probe *probe)
{
    int channel = play_main_channel(probe->def.kind);
    const skv_channel *info = skv_instrument_channel(probe->def.kind, channel);
    return isnan(probe->value[channel]) && *probe->lack
               ? g_strdup(play_word(probe->lack))
               : play_words_of_reading(probe->value[channel], info->unit);
}

char *play_words_with(const char *words, double first, double second)
{
    const char *said = play_word(words), *at = strstr(said, "%s");
    const char *next = at ? strstr(at + strlen("%s"), "%s") : NULL;
    if (!next)
        return g_strdup(said);
    return g_strdup_printf("%.*s%s%.*s%s%s", (int)(at - said), said,
                           play_number_short(first, 9).text, (int)(next - at - 2), at + 2,
                           play_number_short(second, 9).text, next + 2);
}

char *play_quantity(double value, int decimals, const char *unit)
{
    skv_digits number = play_number(value, decimals);
    return join(&number, unit);
}

char *play_words_of_quantity(const char *name, const char *si, double *size)
{
    skv_unit unit = play_unit_of(si);
    *size = unit.size;
    return *unit.name ? g_strdup_printf("%s (%s)", play_word(name), play_word(unit.name))
                      : g_strdup(play_word(name));
}

char *play_words_of_amount(const skv_picture *picture)
{
    int count = picture->frame.particles.count;
    /* Translators: the number is written with spaces, such as 12 960. */
    return g_strdup_printf(ngettext("%s particle", "%s particles", (unsigned long)count),
                           play_number(count, 0).text);
}

char *play_words_of_picture(const skv_stage *stage, const skv_picture *picture)
{
    char *amount = play_words_of_amount(picture), *pace = play_words_of_pace(stage);
    char *text = g_strdup_printf("%s, %s", amount, pace);
    g_free(amount);
    g_free(pace);
    return text;
}
