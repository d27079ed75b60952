/* Recipes: what a scene was made of, in one block of bytes (docs/stage.md), so that a replay or a
 * link can have it made again where its files are not. */
#ifndef SKV_SCENE_RECIPE_H
#define SKV_SCENE_RECIPE_H

#include "skvalp/scene.h"

/* A scene made of more than this has no recipe. */
#define SKV_LARGEST_RECIPE (1 << 20)

typedef enum skv_recipe_kind {
    SKV_RECIPE_BUILTIN,
    SKV_RECIPE_JSON,
    SKV_RECIPE_PNG
} skv_recipe_kind;

typedef struct skv_recipe {
    skv_recipe_kind kind;
    const char *name; /* the built-in scene's, else the file's without its folder */
    skv_scene_options options;
    const uint8_t *data; /* JSON or PNG; of a built-in scene it is not written */
    size_t size;
    const uint8_t *picture; /* a PNG that the JSON names; null: none */
    size_t picture_size;
} skv_recipe;

/* Notes in a scene what it was made of; nothing if that is too much. False if memory is out. */
bool skv_recipe_note(const skv_recipe *recipe, skv_scene *scene);

/* The block noted; null if there is none. */
const uint8_t *skv_scene_recipe(const skv_scene *scene, size_t *size);

/* Takes a block apart, whoever wrote it; the recipe points into it. `*settings` is the caller's to
 * free. False if it is none, or memory is out. */
bool skv_recipe_read(const uint8_t *bytes, size_t size, skv_recipe *recipe, skv_setting **settings);

/* read/load.c: the whole of options that a host hands in, which may know less of them: themselves,
 * or `own`; the defaults for null. Null for some that were not initialised. */
const skv_scene_options *skv_open_scene_options(const skv_scene_options *options,
                                                skv_scene_options *own);

/* read/load.c: makes the scene again; with other options, null for none, set over its own. */
skv_result skv_recipe_load(const uint8_t *bytes, size_t size, const skv_scene_options *changed,
                           skv_scene **scene, skv_error *error);

#endif
