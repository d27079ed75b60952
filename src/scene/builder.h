/* Builder: takes the entries of a scene, from whatever parser visits them, checks each against the
 * registry, and then makes the scene. Readers know nothing of fields; the builder knows nothing of
 * JSON. */
#ifndef SKV_SCENE_BUILDER_H
#define SKV_SCENE_BUILDER_H

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

typedef struct skv_builder {
    const char *label;  /* the file, for messages */
    const char *folder; /* where pictures are looked for; null: nowhere */
    skv_values values;
} skv_builder;

/* Starts with every field at its default. */
skv_result skv_builder_begin(skv_builder *builder, const char *label, const char *folder,
                             skv_error *error);
void skv_builder_end(skv_builder *builder);

/* Accepts one entry, "fluid.spacing" or "water[0].points[2][1]", from a file's line (0: none). */
skv_result skv_builder_accept(skv_builder *builder, const char *path, const skv_entry *entry,
                              int line, skv_error *error);

/* Accepts a "path=value" setting, its value as text. */
skv_result skv_builder_set(skv_builder *builder, const skv_setting *setting, skv_error *error);

/* Accepts skv_scene_options: the settings in order, then the number of particles. */
skv_result skv_builder_options(skv_builder *builder, const skv_scene_options *options,
                               skv_error *error);

/* Fails with "FILE:LINE: PATH: message", or "--set PATH: message", as the origin asks for. */
skv_result skv_builder_fail(const skv_builder *builder, skv_origin origin, const char *path,
                            skv_error *error, skv_result code, const char *format, ...)
    SKV_PRINTF(6, 7);

#endif
