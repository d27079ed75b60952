/** @file
 * Scenes: a terrain, a fluid and where the fluid is at the start, from a JSON file or from a
 * painted PNG, or one of the built-in ones.
 *
 * Every file is checked against one registry of fields (skv_scene_field), which also feeds the
 * command line's --set, the panels and the documentation. A scene is immutable once loaded; worlds
 * are built from it as often as wanted (that is what "reset" does).
 */
#ifndef SKVALP_SCENE_H
#define SKVALP_SCENE_H

#include "skvalp/base.h"
#include "skvalp/fields.h"
#include "skvalp/world.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct skv_scene skv_scene;

/** All that a scene file may say, in documentation order; among it all parameters of
 * skv_world_field but those that are the host's (threads, capacity, solver). Null
 * past the last. Static. */
SKV_API const skv_field *skv_scene_field(int i);

/** Options that override a scene while it is loaded. Initialise with skv_default_scene_options. */
typedef struct skv_scene_options {
    uint32_t cookie;
    int particles;               /**< wanted number of particles; 0: what the scene says */
    const skv_setting *settings; /**< applied after the file, in order */
    int setting_count;
    bool cautious; /**< of a replay or a state in memory that a stranger may have sent: it is opened
                      only when it is asked for twice, if its demands are not modest
                      (skvalp/player.h) */
} skv_scene_options;

/** The defaults, and the same for binders ("Definitions" in skvalp/base.h). */
SKV_API skv_scene_options skv_default_scene_options(void);
SKV_API void skv_scene_options_init(skv_scene_options *def, size_t size);

/** Loads a scene: a built-in name ("dam-break"), or a path that ends in .json or .png (any letter
 * case). `options` may be null. On failure `*scene` is null and the message names the file, the
 * line or pixel, the field, and what is allowed. At most 64 MiB of a file are read, and 4 MiB of
 * JSON. */
SKV_API skv_result skv_scene_load(const char *name_or_path, const skv_scene_options *options,
                                  skv_scene **scene, skv_error *error);

/** The same from memory: what a drop, a share link or a test has. `format` is "json" or "png",
 * `label` stands for the file's name in messages. A JSON scene in memory may not refer to a picture
 * file. */
SKV_API skv_result skv_scene_load_memory(const void *data, size_t size, const char *format,
                                         const char *label, const skv_scene_options *options,
                                         skv_scene **scene, skv_error *error);

SKV_API void skv_scene_destroy(skv_scene *scene);

/** Builds the world of a scene with its particles. `threads` as in skv_world_def. */
SKV_API skv_result skv_scene_create_world(const skv_scene *scene, int threads, skv_world **world,
                                          skv_error *error);

/** The two halves of skv_scene_create_world, for a host that wants to change something in between.
 * What the world is like, without its fluid. Its terrain is the scene's, shared: skv_world_create
 * takes it over, or skv_terrain_destroy gives it up. */
SKV_API skv_world_def skv_scene_world_def(const skv_scene *scene);
/** Puts the scene's fluid into such a world, at its speed, and what acts on it; settles it
 * (skv_world_settle) unless the scene says not to. */
SKV_API skv_result skv_scene_fill(const skv_scene *scene, skv_world *world, skv_error *error);

/** Facts of a loaded scene. Texts belong to the scene. */
SKV_API const char *skv_scene_name(const skv_scene *scene);        /**< "dam-break" */
SKV_API const char *skv_scene_title(const skv_scene *scene);       /**< "Dam break" */
SKV_API const char *skv_scene_description(const skv_scene *scene); /**< one or two sentences */
SKV_API int skv_scene_particles(const skv_scene *scene);           /**< what the world will hold */
/** By which number of particles the scene is as fine as it is: those at the start, or, where it
 * begins without fluid, those that half fill it. */
SKV_API int skv_scene_amount(const skv_scene *scene);
SKV_API double skv_scene_seconds(const skv_scene *scene); /**< a fitting length of a recording */

/** The bodies that its worlds begin with, and one's name; null past the last one. In a world of the
 * scene the body with the name i has the id i + 1. */
SKV_API int skv_scene_body_count(const skv_scene *scene);
SKV_API const char *skv_scene_body_name(const skv_scene *scene, int i);

/** The files that a scene was read from, a JSON file and its picture for example, in any order;
 * null when i is past the last one. */
SKV_API const char *skv_scene_file(const skv_scene *scene, int i);

/** What the loader wants to say without failing, such as "2 green areas emit fluid at 1 m/s"; null
 * when i is past the last one. */
SKV_API const char *skv_scene_notice(const skv_scene *scene, int i);

/** The built-in scenes, in the order in which they are presented; null past the last one. They are
 * the files of scenes/, compiled in. */
typedef struct skv_scene_info {
    const char *name;
    const char *title;
    const char *description;
    bool painted; /**< over a picture */
} skv_scene_info;
SKV_API const skv_scene_info *skv_builtin_scene(int i);

#ifdef __cplusplus
}
#endif
#endif
