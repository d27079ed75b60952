/* How a moment was shown, as bytes. Invariant: what was read are names of small letters, finite
 * places and kinds of instruments that there are, whoever wrote it. */
#include "session/showing.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"

/* m: no world is so large. */
#define FARTHEST 1e6

enum { PAUSED = 1, APART = 2, ALL = 3 };

/* Small letters, figures and dashes; commas between names. */
static bool are_names(const char *text)
{
    return text[strspn(text, "abcdefghijklmnopqrstuvwxyz0123456789-,")] == '\0';
}

void skv_shown_name(char *to, size_t room, const char *names)
{
    bool fits = names && strlen(names) < room && are_names(names);
    skv_format(to, room, "%s", fits ? names : "");
}

bool skv_showing_is_plain(const skv_showing *s)
{
    return !s->view[0] && !s->overlays[0] && !s->choice[0] && !s->paused && !s->apart &&
           s->probe_count == 0;
}

void skv_showing_put(skv_writer *w, const skv_showing *s)
{
    skv_put(w, (s->paused ? PAUSED : 0) | (s->apart ? APART : 0), 1);
    skv_put_text(w, s->view);
    skv_put_text(w, s->overlays);
    skv_put_text(w, s->choice);
    skv_put(w, (uint64_t)s->probe_count, 1);
    for (int i = 0; i < s->probe_count; i++) {
        const skv_shown_probe *p = &s->probes[i];
        skv_put_text(w, skv_instrument_kind_name(p->kind));
        skv_put_double(w, p->x0);
        skv_put_double(w, p->y0);
        skv_put_double(w, p->x1);
        skv_put_double(w, p->y1);
        skv_put(w, p->watched, 1);
    }
}

static bool get_names(skv_reader *r, char *to, size_t room)
{
    char text[256];
    skv_get_text(r, text);
    bool good = strlen(text) < room && are_names(text);
    if (good)
        skv_format(to, room, "%s", text);
    return good;
}

/* -1 if there is no such kind, or it watches another instrument. */
static int find_kind(const char *name)
{
    const char *known;
    for (int i = 0; (known = skv_instrument_kind_name((skv_instrument_kind)i)); i++)
        if (strcmp(known, name) == 0 && i != SKV_INSTRUMENT_STOPWATCH)
            return i;
    return -1;
}

static bool get_probe(skv_reader *r, skv_shown_probe *probe)
{
    char name[256];
    double at[4];
    skv_get_text(r, name);
    int kind = find_kind(name);
    bool good = kind >= 0;
    for (int i = 0; i < 4; i++) {
        at[i] = skv_get_double(r);
        good = good && fabs(at[i]) <= FARTHEST;
    }
    uint64_t watched = skv_get(r, 1);
    *probe = (skv_shown_probe){good ? (skv_instrument_kind)kind : (skv_instrument_kind)0,
                               at[0],
                               at[1],
                               at[2],
                               at[3],
                               watched == 1};
    return good && watched <= 1;
}

bool skv_showing_get(skv_reader *r, skv_showing *s)
{
    *s = (skv_showing){0};
    unsigned flags = (unsigned)skv_get(r, 1);
    s->paused = flags & PAUSED;
    s->apart = flags & APART;
    bool good = flags <= ALL && get_names(r, s->view, sizeof s->view) &&
                get_names(r, s->overlays, sizeof s->overlays) &&
                get_names(r, s->choice, sizeof s->choice);
    int count = (int)skv_get(r, 1);
    good = good && count <= SKV_MOST_PROBES;
    for (; good && s->probe_count < count; s->probe_count++)
        good = get_probe(r, &s->probes[s->probe_count]);
    return good && !r->failed;
}
