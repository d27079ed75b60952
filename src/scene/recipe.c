/* Recipes as bytes. Invariant: what is read points into the block, and every text in it ends there.
 */
#include "scene/recipe.h"

#include <string.h>

#include "base/assert.h"
#include "base/bytes.h"
#include "base/memory.h"
#include "scene/scene_data.h"

/* No scene has so many fields that somebody would set more. */
#define MOST_SETTINGS 4096

/* ---- Writing --------------------------------------------------------------------------------- */

static void put_bytes(skv_writer *w, const void *bytes, size_t size)
{
    if (w->bytes && size)
        memcpy(w->bytes + w->used, bytes, size);
    w->used += size;
}

static void put_text(skv_writer *w, const char *text)
{
    put_bytes(w, text, strlen(text) + 1);
}

static void put_block(skv_writer *w, const void *bytes, size_t size)
{
    skv_put(w, size, 4);
    put_bytes(w, bytes, size);
}

/* JSON without the space between its tokens. */
static void put_json(skv_writer *w, const uint8_t *text, size_t size)
{
    skv_writer length = *w;
    bool quoted = false;
    w->used += 4;
    size_t begin = w->used;
    for (size_t i = 0; i < size; i++) {
        bool space = text[i] == ' ' || text[i] == '\t' || text[i] == '\n' || text[i] == '\r';
        if (quoted || !space)
            skv_put(w, text[i], 1);
        if (quoted && text[i] == '\\' && i + 1 < size)
            skv_put(w, text[++i], 1);
        else if (text[i] == '"')
            quoted = !quoted;
    }
    skv_put(&length, w->used - begin, 4);
}

static void put_recipe(skv_writer *w, const skv_recipe *recipe)
{
    const skv_scene_options *options = &recipe->options;
    skv_put(w, (uint64_t)recipe->kind, 1);
    put_text(w, recipe->name);
    skv_put(w, (uint64_t)options->particles, 4);
    skv_put(w, (uint64_t)options->setting_count, 4);
    for (int i = 0; i < options->setting_count; i++) {
        put_text(w, options->settings[i].path);
        put_text(w, options->settings[i].value);
    }
    if (recipe->kind == SKV_RECIPE_JSON)
        put_json(w, recipe->data, recipe->size);
    else
        put_block(w, recipe->data, recipe->kind == SKV_RECIPE_PNG ? recipe->size : 0);
    put_block(w, recipe->picture, recipe->kind == SKV_RECIPE_JSON ? recipe->picture_size : 0);
}

bool skv_recipe_note(const skv_recipe *recipe, skv_scene *scene)
{
    skv_writer writer = {NULL, 0};
    put_recipe(&writer, recipe);
    if (writer.used > SKV_LARGEST_RECIPE || recipe->options.setting_count > MOST_SETTINGS)
        return true;
    uint8_t *bytes = skv_calloc(writer.used, 1);
    if (bytes == NULL)
        return false;
    writer = (skv_writer){bytes, 0};
    put_recipe(&writer, recipe);
    skv_free(scene->recipe);
    scene->recipe = bytes;
    scene->recipe_size = writer.used;
    return true;
}

const uint8_t *skv_scene_recipe(const skv_scene *scene, size_t *size)
{
    SKV_ASSERT_OR(scene != NULL && size != NULL, NULL);
    *size = scene->recipe_size;
    return scene->recipe;
}

/* ---- Reading --------------------------------------------------------------------------------- */

static const uint8_t *get_bytes(skv_reader *r, size_t size)
{
    if (r->failed || size > r->size - r->at) {
        r->failed = true;
        return NULL;
    }
    const uint8_t *bytes = r->bytes + r->at;
    r->at += size;
    return bytes;
}

static const char *get_text(skv_reader *r)
{
    const uint8_t *begin = r->bytes + r->at;
    const uint8_t *end = r->failed ? NULL : memchr(begin, 0, r->size - r->at);
    if (end == NULL) {
        r->failed = true;
        return "";
    }
    r->at += (size_t)(end + 1 - begin);
    return (const char *)begin;
}

static const uint8_t *get_block(skv_reader *r, size_t *size)
{
    *size = (size_t)skv_get(r, 4);
    return get_bytes(r, *size);
}

bool skv_recipe_read(const uint8_t *bytes, size_t size, skv_recipe *recipe, skv_setting **settings)
{
    skv_reader reader = {.bytes = bytes, .size = size}, *r = &reader;
    *recipe = (skv_recipe){.name = ""};
    unsigned kind = (unsigned)skv_get(r, 1);
    recipe->kind = (skv_recipe_kind)kind;
    recipe->name = get_text(r);
    uint64_t particles = skv_get(r, 4), count = skv_get(r, 4);
    *settings = NULL;
    if (r->failed || kind > SKV_RECIPE_PNG || particles > SKV_MAX_PARTICLES ||
        count > MOST_SETTINGS)
        return false;
    *settings = skv_calloc((size_t)count + 1, sizeof **settings);
    if (*settings == NULL)
        return false;
    for (size_t i = 0; i < count; i++) {
        (*settings)[i].path = get_text(r);
        (*settings)[i].value = get_text(r);
    }
    recipe->options.particles = (int)particles;
    recipe->options.settings = *settings;
    recipe->options.setting_count = (int)count;
    recipe->data = get_block(r, &recipe->size);
    recipe->picture = get_block(r, &recipe->picture_size);
    if (recipe->picture_size == 0)
        recipe->picture = NULL;
    return !r->failed && r->at == r->size;
}
