/* A draft: what a scene file says, while it is read. It takes entries from whatever parser visits
 * them, and settings, and checks each against the registry. Readers know nothing of fields; the
 * draft knows nothing of JSON. */
#ifndef SKV_SCENE_DRAFT_H
#define SKV_SCENE_DRAFT_H

#include "scene/values.h"

/* A value as a parser sees it. */
typedef enum skv_entry_kind {
    SKV_ENTRY_NULL,
    SKV_ENTRY_BOOLEAN,
    SKV_ENTRY_NUMBER,
    SKV_ENTRY_TEXT,
    SKV_ENTRY_LIST,  /* its elements follow as entries of their own */
    SKV_ENTRY_OBJECT /* likewise */
} skv_entry_kind;

typedef struct skv_entry {
    skv_entry_kind kind;
    double number; /* SKV_ENTRY_NUMBER */
    bool boolean;
    const char *text; /* SKV_ENTRY_TEXT */
} skv_entry;

typedef struct skv_draft {
    const char *label;  /* the file, for messages */
    const char *folder; /* where pictures are looked for; null: nowhere */
    skv_values values;
} skv_draft;

/* Starts with every field at its default. */
skv_result skv_draft_begin(skv_draft *draft, const char *label, const char *folder,
                           skv_error *error);
void skv_draft_end(skv_draft *draft);

/* Accepts one entry, "fluid.spacing" or "water[0].points[2][1]", from a file's line (0: none). */
skv_result skv_draft_accept(skv_draft *draft, const char *path, const skv_entry *entry, int line,
                            skv_error *error);

/* Accepts a "path=value" setting, its value as text. */
skv_result skv_draft_set(skv_draft *draft, const skv_setting *setting, skv_error *error);

/* Accepts skv_scene_options: the settings in order, then the number of particles. */
skv_result skv_draft_options(skv_draft *draft, const skv_scene_options *options, skv_error *error);

/* Fails with "FILE:LINE: PATH: message", or "--set PATH: message", as the origin asks for. */
skv_result skv_draft_fail(const skv_draft *draft, skv_origin origin, const char *path,
                          skv_error *error, skv_result code, const char *format, ...)
    SKV_PRINTF(6, 7);

#endif
