/* Loading: finds out what was named, reads it into a draft, and has the scene built from that.
 *
 * Invariant: on failure nothing is left behind and the message has named the file.
 */
#include <string.h>
#include <strings.h>

#include "base/assert.h"
#include "base/defs.h"
#include "base/memory.h"
#include "scene/builtin.h"
#include "scene/read/file.h"
#include "scene/read/json.h"
#include "scene/read/png.h"
#include "scene/recipe.h"
#include "scene/scene_data.h"

enum { OPTIONS_COOKIE = 0x5343 };

skv_scene_options skv_default_scene_options(void)
{
    return (skv_scene_options){.cookie = SKV_COOKIE(OPTIONS_COOKIE, skv_scene_options)};
}

void skv_scene_options_init(skv_scene_options *def, size_t size)
{
    const skv_scene_options standard = skv_default_scene_options();
    skv_def_init(def, size, &standard, sizeof standard);
}

const skv_scene_options *skv_open_scene_options(const skv_scene_options *options,
                                                skv_scene_options *own)
{
    *own = skv_default_scene_options();
    return options ? skv_def_open(options, own, sizeof *own) : own;
}

static bool ends_with(const char *text, const char *ending)
{
    size_t length = strlen(text), cut = strlen(ending);
    return length > cut && strcasecmp(text + length - cut, ending) == 0;
}

/* ---- Pictures -------------------------------------------------------------------------------- */

/* Whether a picture's path stays in the scene's folder. */
static bool is_below(const char *path)
{
    if (path[0] == '/' || strpbrk(path, "\\:") != NULL)
        return false;
    for (const char *part = path; part != NULL;) {
        if (strncmp(part, "..", 2) == 0 && (part[2] == '/' || part[2] == '\0'))
            return false;
        part = strchr(part, '/');
        part = part != NULL ? part + 1 : NULL;
    }
    return true;
}

/* The scene, or without memory for what it has to remember, none. */
static skv_result finish(skv_scene **scene, bool remembered, const char *label, skv_error *error)
{
    if (remembered)
        return SKV_OK;
    skv_scene_destroy(*scene);
    *scene = NULL;
    return skv_fail(error, SKV_ERROR_MEMORY, "%s: out of memory", label);
}

/* Notes down a file that a scene was read from. */
static skv_result remember_file(skv_scene **scene, const char *path, skv_error *error)
{
    size_t size = strlen(path) + 1;
    char *copy = skv_calloc(size, 1);
    if (copy != NULL)
        memcpy(copy, path, size);
    (*scene)->files[(*scene)->files[0] != NULL] = copy;
    return finish(scene, copy != NULL, path, error);
}

/* Builds a scene over the picture in a PNG's content. Where a scene file names the picture, the
 * file and the line come first in a message. */
static skv_result build_over_png(const skv_draft *draft, const void *data, size_t size,
                                 const char *label, skv_scene **scene, skv_error *error)
{
    const skv_value *named = &draft->values.value[SKV_F_WORLD_PICTURE];
    skv_image image;
    skv_error cause;
    skv_result result = skv_png_read(data, size, label, &image, &cause);
    if (result != SKV_OK) {
        if (named->text != NULL)
            skv_draft_fail(draft, named->origin, "world.picture", error, result, "%s", cause.text);
        else
            skv_fail(error, result, "%s", cause.text);
        return result;
    }
    result = skv_scene_build(draft, &image, label, scene, error);
    skv_free(image.pixels);
    return result;
}

/* Builds a scene whose values name a picture beside the file, or one that the recipe brings: after
 * that it has it. */
static skv_result build_with_picture(const skv_draft *draft, skv_recipe *recipe, skv_scene **scene,
                                     skv_error *error)
{
    const skv_value *picture = &draft->values.value[SKV_F_WORLD_PICTURE];
    if (recipe->picture != NULL)
        return build_over_png(draft, recipe->picture, recipe->picture_size, picture->text, scene,
                              error);
    const char *wrong = NULL;
    if (draft->folder == NULL)
        wrong = "needs a scene in a file; a picture is looked for in its folder";
    else if (!is_below(picture->text))
        wrong = "leaves the scene's folder; allowed is a path below it";
    else if (!ends_with(picture->text, ".png"))
        wrong = "is not a PNG; allowed is a name that ends in .png";
    if (wrong != NULL)
        return skv_draft_fail(draft, picture->origin, "world.picture", error, SKV_ERROR_VALUE,
                              "\"%s\" %s", picture->text, wrong);
    char path[4096];
    size_t length = skv_format(path, sizeof path, "%s%s", draft->folder, picture->text);
    skv_error cause;
    uint8_t *data = NULL;
    if (length >= sizeof path)
        return skv_fail(error, SKV_ERROR_FILE, "%s: the path is too long", draft->label);
    skv_result result = skv_file_read(path, SKV_MAX_FILE, &data, &recipe->picture_size, &cause);
    if (result != SKV_OK)
        return skv_draft_fail(draft, picture->origin, "world.picture", error, result, "%s",
                              cause.text);
    recipe->picture = data;
    result = build_over_png(draft, data, recipe->picture_size, path, scene, error);
    return result == SKV_OK ? remember_file(scene, path, error) : result;
}

/* ---- Memory ---------------------------------------------------------------------------------- */

static skv_result build_json(const skv_draft *draft, skv_recipe *recipe, skv_scene **scene,
                             skv_error *error)
{
    const char *picture = draft->values.value[SKV_F_WORLD_PICTURE].text;
    return picture != NULL && picture[0] != '\0' ? build_with_picture(draft, recipe, scene, error)
                                                 : skv_scene_build(draft, NULL, NULL, scene, error);
}

static skv_result build_png(const skv_draft *draft, const skv_recipe *recipe, skv_scene **scene,
                            skv_error *error)
{
    const skv_value *picture = &draft->values.value[SKV_F_WORLD_PICTURE];
    if (picture->text != NULL)
        return skv_draft_fail(draft, picture->origin, "world.picture", error, SKV_ERROR_VALUE,
                              "the scene is a picture itself");
    return build_over_png(draft, recipe->data, recipe->size, draft->label, scene, error);
}

/* Makes the scene of a recipe, whose JSON or PNG is there, and notes the recipe in it. `folder` is
 * where a picture may be, or null. */
static skv_result load(skv_recipe *recipe, const char *label, const char *folder, skv_scene **scene,
                       skv_error *error)
{
    skv_draft draft;
    bool png = recipe->kind == SKV_RECIPE_PNG;
    const uint8_t *brought = recipe->picture;
    skv_result result = skv_draft_begin(&draft, label, folder, error);
    if (result != SKV_OK)
        return result;
    if (!png)
        result = skv_json_read(&draft, (const char *)recipe->data, recipe->size, error);
    if (result == SKV_OK)
        result = skv_draft_options(&draft, &recipe->options, error);
    if (result == SKV_OK)
        result = png ? build_png(&draft, recipe, scene, error)
                     : build_json(&draft, recipe, scene, error);
    skv_draft_end(&draft);
    if (result == SKV_OK)
        result = finish(scene, skv_recipe_note(recipe, *scene), label, error);
    if (recipe->picture != brought)
        skv_free((uint8_t *)recipe->picture);
    return result;
}

static const char *base_name(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash != NULL ? slash + 1 : path;
}

static skv_recipe recipe_of(bool png, const char *label, const void *data, size_t size,
                            const skv_scene_options *options)
{
    return (skv_recipe){.kind = png ? SKV_RECIPE_PNG : SKV_RECIPE_JSON,
                        .name = base_name(label),
                        .options = *options,
                        .data = data,
                        .size = size};
}

skv_result skv_scene_load_memory(const void *data, size_t size, const char *format,
                                 const char *label, const skv_scene_options *options,
                                 skv_scene **scene, skv_error *error)
{
    SKV_ASSERT_OR(scene != NULL, SKV_ERROR_VALUE);
    *scene = NULL;
    SKV_ASSERT_OR(data != NULL && format != NULL && label != NULL, SKV_ERROR_VALUE);
    skv_scene_options own;
    SKV_ASSERT_INITIALISED(options, skv_open_scene_options(options, &own), SKV_ERROR_VALUE);
    if (size > SKV_MAX_FILE)
        return skv_fail(error, SKV_ERROR_LIMIT, "%s: has %zu bytes; allowed are %d", label, size,
                        SKV_MAX_FILE);
    bool png = strcmp(format, "png") == 0;
    if (!png && strcmp(format, "json") != 0)
        return skv_fail(error, SKV_ERROR_FORMAT, "%s: the format is %s; allowed are json and png",
                        label, format);
    skv_recipe recipe = recipe_of(png, label, data, size, options);
    return load(&recipe, label, NULL, scene, error);
}

/* ---- Names and paths ------------------------------------------------------------------------- */

const skv_scene_info *skv_builtin_scene(int i)
{
    return i >= 0 && i < skv_builtin_count ? &skv_builtins[i].info : NULL;
}

static skv_result load_builtin(const char *name, const skv_scene_options *options,
                               skv_scene **scene, skv_error *error)
{
    char names[256];
    size_t used = 0;
    for (int i = 0; i < skv_builtin_count; i++) {
        const skv_builtin *b = &skv_builtins[i];
        if (strcmp(b->info.name, name) == 0) {
            skv_recipe recipe = recipe_of(false, b->info.name, b->text, b->size, options);
            recipe.kind = SKV_RECIPE_BUILTIN;
            recipe.picture = b->picture;
            recipe.picture_size = b->picture_size;
            return load(&recipe, b->info.name, NULL, scene, error);
        }
        if (used < sizeof names)
            used += skv_format(names + used, sizeof names - used, "%s%s", i > 0 ? ", " : "",
                               b->info.name);
    }
    return skv_fail(error, SKV_ERROR_FILE,
                    "%.200s: is no scene; allowed are a file that ends in .json or .png, or one of "
                    "%s",
                    name, names);
}

skv_result skv_scene_load(const char *name_or_path, const skv_scene_options *options,
                          skv_scene **scene, skv_error *error)
{
    SKV_ASSERT_OR(scene != NULL, SKV_ERROR_VALUE);
    *scene = NULL;
    SKV_ASSERT_OR(name_or_path != NULL, SKV_ERROR_VALUE);
    skv_scene_options own;
    SKV_ASSERT_INITIALISED(options, skv_open_scene_options(options, &own), SKV_ERROR_VALUE);
    bool json = ends_with(name_or_path, ".json");
    if (!json && !ends_with(name_or_path, ".png"))
        return load_builtin(name_or_path, options, scene, error);

    uint8_t *data;
    size_t size;
    skv_result result = skv_file_read(name_or_path, SKV_MAX_FILE, &data, &size, error);
    if (result != SKV_OK)
        return result;
    char folder[4096];
    const char *slash = strrchr(name_or_path, '/');
    int length = slash != NULL ? (int)(slash + 1 - name_or_path) : 0;
    if (length >= (int)sizeof folder)
        result = skv_fail(error, SKV_ERROR_FILE, "%s: the path is too long", name_or_path);
    else {
        skv_recipe recipe = recipe_of(!json, name_or_path, data, size, options);
        skv_format(folder, sizeof folder, "%.*s", length, name_or_path);
        result = load(&recipe, name_or_path, json ? folder : NULL, scene, error);
    }
    skv_free(data);
    return *scene != NULL ? remember_file(scene, name_or_path, error) : result;
}

/* Options set over those of a recipe; the list is the caller's to free. Null if memory is out. */
static skv_setting *change(skv_recipe *recipe, const skv_scene_options *changed)
{
    skv_scene_options *options = &recipe->options;
    size_t own = (size_t)options->setting_count, more = (size_t)changed->setting_count;
    skv_setting *settings = skv_calloc(own + more + 1, sizeof *settings);
    if (settings == NULL)
        return NULL;
    for (size_t i = 0; i < own; i++)
        settings[i] = options->settings[i];
    for (size_t i = 0; i < more; i++)
        settings[own + i] = changed->settings[i];
    options->settings = settings;
    options->setting_count += changed->setting_count;
    if (changed->particles > 0)
        options->particles = changed->particles;
    return settings;
}

skv_result skv_recipe_load(const uint8_t *bytes, size_t size, const skv_scene_options *changed,
                           skv_scene **scene, skv_error *error)
{
    skv_recipe recipe;
    skv_setting *settings = NULL, *all = NULL;
    skv_result result;
    *scene = NULL;
    skv_scene_options own;
    if (changed)
        SKV_ASSERT_INITIALISED(changed, skv_open_scene_options(changed, &own), SKV_ERROR_VALUE);
    bool readable = skv_recipe_read(bytes, size, &recipe, &settings);
    if (readable && changed != NULL)
        all = change(&recipe, changed);
    if (!readable)
        result = skv_fail(error, SKV_ERROR_FORMAT, "its scene is damaged; take another copy");
    else if (changed != NULL && all == NULL)
        result = skv_fail(error, SKV_ERROR_MEMORY, "out of memory for a scene");
    else if (recipe.kind == SKV_RECIPE_BUILTIN)
        result = load_builtin(recipe.name, &recipe.options, scene, error);
    else
        result = load(&recipe, recipe.name, NULL, scene, error);
    skv_free(all);
    skv_free(settings);
    return result;
}
