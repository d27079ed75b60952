/* From a draft's checked values to a scene.
 *
 * Invariant: a scene that comes out can build its world: its walls leave air, its fluid lies in it,
 * and its spacing gives the number of particles that it reports.
 */
#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "scene/bodies.h"
#include "scene/fluids.h"
#include "scene/lay.h"
#include "scene/notes.h"
#include "scene/scene_data.h"
#include "scene/shapes.h"
#include "scene/taps.h"
#include "scene/walls.h"
#include "terrain/wall_map.h"
#include "world/parameters.h"

/* Everything a building function needs. */
typedef struct builder {
    const skv_draft *draft;
    const skv_value *value; /* the draft's single values */
    skv_scene *scene;
    bool pictured;
    const char *picture_label;
    skv_taps taps;
    skv_error *error;
} builder;

static bool is_given(const builder *c, skv_field_id id)
{
    return c->value[id].origin.source != SKV_FROM_DEFAULT;
}

/* Fails for a field, where it was given. */
static skv_result fail(const builder *c, skv_field_id id, skv_result code, const char *message)
{
    return skv_draft_fail(c->draft, c->value[id].origin, skv_scene_fields(NULL)[id].path, c->error,
                          code, "%s", message);
}

static skv_result fail_memory(const builder *c)
{
    return skv_fail(c->error, SKV_ERROR_MEMORY, "%s: out of memory", c->draft->label);
}

static char *copy_text(const char *text, size_t length)
{
    char *copy = skv_calloc(length + 1, 1);
    if (copy != NULL)
        memcpy(copy, text, length);
    return copy;
}

/* ---- Texts ----------------------------------------------------------------------------------- */

/* The file's name without folder and ending. */
static char *name_of_file(const char *label)
{
    const char *slash = strrchr(label, '/');
    const char *name = slash != NULL ? slash + 1 : label;
    const char *point = strrchr(name, '.');
    return copy_text(name, point != NULL ? (size_t)(point - name) : strlen(name));
}

static skv_result build_texts(builder *c)
{
    skv_scene *scene = c->scene;
    const char *name = c->value[SKV_F_NAME].text, *title = c->value[SKV_F_TITLE].text;
    const char *description = c->value[SKV_F_DESCRIPTION].text;
    scene->name = name != NULL && name[0] != '\0' ? copy_text(name, strlen(name))
                                                  : name_of_file(c->draft->label);
    if (title == NULL || title[0] == '\0')
        title = scene->name;
    scene->title = title != NULL ? copy_text(title, strlen(title)) : NULL;
    scene->description = copy_text(description != NULL ? description : "",
                                   description != NULL ? strlen(description) : 0);
    scene->seconds = c->value[SKV_F_SECONDS].number;
    /* A file's name may be anything. */
    if (scene->name != NULL && scene->title != NULL) {
        skv_make_plain(scene->name);
        skv_make_plain(scene->title);
    }
    bool complete = scene->name != NULL && scene->title != NULL && scene->description != NULL;
    return complete ? SKV_OK : fail_memory(c);
}

/* ---- Walls ----------------------------------------------------------------------------------- */

/* A picture is as wide as world.width says; one so tall that this would make it too high becomes
 * narrower, unless the width was asked for. */
static skv_result scale_picture(builder *c)
{
    skv_scene *scene = c->scene;
    double most = skv_scene_fields(NULL)[SKV_F_WORLD_HEIGHT].maximum;
    double width = c->value[SKV_F_WORLD_WIDTH].number;
    char message[160], text[32];
    if (width * scene->height / scene->width > most) {
        skv_format_number(width * scene->height / scene->width, text);
        if (is_given(c, SKV_F_WORLD_WIDTH)) {
            skv_format(message, sizeof message,
                       "makes the picture %s m high; allowed are 16 m, so choose a smaller width",
                       text);
            return fail(c, SKV_F_WORLD_WIDTH, SKV_ERROR_VALUE, message);
        }
        width = most * scene->width / scene->height;
        skv_format_number(width, text);
        skv_scene_note(scene, "the picture is so tall that it is made %s m wide", text);
    }
    scene->pixel_size = width / scene->width;
    return SKV_OK;
}

/* Fails for the picture; where a scene file names it, the scene and the line come first. */
static skv_result fail_picture(const builder *c, skv_result code, const char *message)
{
    if (is_given(c, SKV_F_WORLD_PICTURE))
        return fail(c, SKV_F_WORLD_PICTURE, code, message);
    return skv_fail(c->error, code, "%s", message);
}

/* The same for what the picture as a whole is not fit for. */
static skv_result fail_unfit(const builder *c, skv_result code, const char *message)
{
    skv_error named;
    skv_fail(&named, code, "%s: %s", c->picture_label, message);
    return fail_picture(c, code, named.text);
}

/* Takes size, coverage and paint over from a picture, which has served then, and finds its taps. */
static skv_result build_picture(builder *c, skv_image *image)
{
    static const skv_field_id own[] = {SKV_F_WORLD_HEIGHT, SKV_F_WORLD_PIXEL};
    for (int i = 0; i < 2; i++) {
        if (is_given(c, own[i]))
            return fail(c, own[i], SKV_ERROR_VALUE,
                        "has no place beside a picture; its size follows from world.width");
    }
    skv_painting painting;
    skv_error cause;
    skv_result result = skv_paint_read(image, c->picture_label, &painting, &cause);
    if (result != SKV_OK)
        return fail_picture(c, result, cause.text);
    skv_scene *scene = c->scene;
    scene->width = painting.width;
    scene->height = painting.height;
    scene->coverage = painting.coverage;
    scene->paint = painting.paint;
    for (int i = 0; i < SKV_PAINTS; i++)
        scene->marked[i] = painting.count[i];
    skv_free(image->pixels);
    image->pixels = NULL;
    result = scale_picture(c);
    if (result != SKV_OK)
        return result;
    result = skv_scene_paint_oil(scene, c->picture_label, &cause);
    if (result == SKV_OK)
        result = skv_scene_find_taps(scene, c->picture_label, &c->taps, &cause);
    return result == SKV_OK ? SKV_OK : fail_picture(c, result, cause.text);
}

/* Says the size of a pixel, in three digits, that makes just enough of them for the shorter
 * side, or as many as the longer one may have. */
static void offer_pixel(double width, double height, bool few, char *text, size_t size)
{
    double shorter = width < height ? width : height, longer = width + height - shorter;
    double pixel = few ? shorter / SKV_TERRAIN_MIN_PIXELS : longer / SKV_TERRAIN_MAX_PIXELS;
    double unit = 1;
    while (pixel < 100 * unit)
        unit /= 10;
    pixel = few ? floor(pixel / unit + 1e-9) * unit : ceil(pixel / unit - 1e-9) * unit;
    bool fits = longer / pixel < SKV_TERRAIN_MAX_PIXELS + 0.5 &&
                shorter / pixel > SKV_TERRAIN_MIN_PIXELS - 0.5 &&
                pixel >= skv_scene_fields(NULL)[SKV_F_WORLD_PIXEL].minimum;
    char number[32];
    skv_format_float(pixel, number);
    if (fits)
        skv_format(text, size, "%s m would do", number);
    else
        skv_format(text, size, "the sides are too unequal for any pixel");
}

/* Whole pixels of a side; the pixel size fits the width exactly. */
static skv_result build_blank(builder *c)
{
    double width = c->value[SKV_F_WORLD_WIDTH].number;
    double height = c->value[SKV_F_WORLD_HEIGHT].number;
    double pixel = c->value[SKV_F_WORLD_PIXEL].number;
    double columns = floor(width / pixel + 0.5);
    double longest = skv_scene_fields(NULL)[SKV_F_WORLD_HEIGHT].maximum;
    double side = columns > 0.0 ? width / columns : 0.0;
    double rows = columns > 0.0 ? floor(height / side + 0.5) : 0.0;
    if (rows * side > longest * (1 + 1e-6)) /* rounded up beyond what a side may have */
        rows--;
    double least = columns < rows ? columns : rows, most = columns > rows ? columns : rows;
    if (least < SKV_TERRAIN_MIN_PIXELS || most > SKV_TERRAIN_MAX_PIXELS) {
        char offer[64], message[160];
        offer_pixel(width, height, least < SKV_TERRAIN_MIN_PIXELS, offer, sizeof offer);
        skv_format(message, sizeof message,
                   "makes the world %.0f x %.0f pixels; allowed are %d to %d each way; %s", columns,
                   rows, SKV_TERRAIN_MIN_PIXELS, SKV_TERRAIN_MAX_PIXELS, offer);
        return fail(c, SKV_F_WORLD_PIXEL, SKV_ERROR_VALUE, message);
    }
    skv_scene *scene = c->scene;
    scene->width = (int)columns;
    scene->height = (int)rows;
    scene->pixel_size = side;
    scene->coverage = skv_calloc((size_t)scene->width * (size_t)scene->height, 1);
    return scene->coverage != NULL ? SKV_OK : fail_memory(c);
}

/* Makes the shapes of a list; their points move to `points`. */
static skv_result build_list(builder *c, skv_list id, skv_shape **shapes, int *count,
                             double **points)
{
    const skv_shape_list *list = &c->draft->values.list[id];
    if (list->count == 0)
        return SKV_OK;
    skv_scene *scene = c->scene;
    *shapes = skv_calloc((size_t)list->count, sizeof **shapes);
    if (*shapes == NULL)
        return fail_memory(c);
    *count = list->count;
    skv_result result = skv_shapes_make(c->draft, id, scene->width * scene->pixel_size,
                                        scene->height * scene->pixel_size, *shapes, c->error);
    for (int i = 0; result == SKV_OK && i < list->count; i++) {
        skv_shape *shape = &(*shapes)[i];
        size_t size = 2 * (size_t)shape->point_count;
        if (size > 0)
            memcpy(*points, shape->points, size * sizeof **points);
        shape->points = *points;
        *points += size;
    }
    return result;
}

static bool has_air(const skv_scene *scene)
{
    size_t pixels = (size_t)scene->width * (size_t)scene->height;
    for (size_t i = 0; i < pixels; i++) {
        if (scene->coverage[i] < 128)
            return true;
    }
    return false;
}

static skv_result build_walls(builder *c)
{
    skv_scene *scene = c->scene;
    const skv_values *values = &c->draft->values;
    int total = 0;
    for (int i = 0; i < SKV_LISTS; i++)
        total += values->list[i].total_points;
    scene->points = skv_calloc((size_t)total + 1, 2 * sizeof *scene->points);
    if (scene->points == NULL)
        return fail_memory(c);
    double *points = scene->points;
    skv_result result = build_list(c, SKV_LIST_SOLID, &scene->solids, &scene->solid_count, &points);
    if (result == SKV_OK)
        result =
            build_list(c, SKV_LIST_WATER, &scene->water.shapes, &scene->water.shape_count, &points);
    if (result == SKV_OK && scene->solid_count > 0)
        result = skv_scene_draw_walls(c->draft, scene, c->error);
    if (result != SKV_OK)
        return result;
    if (!has_air(scene)) {
        if (c->pictured && scene->solid_count == 0)
            return fail_unfit(c, SKV_ERROR_VALUE,
                              "no pixel is free; paint air dark and fluid blue");
        return skv_draft_fail(c->draft, values->list[SKV_LIST_SOLID].shapes[0].origin, "solid",
                              c->error, SKV_ERROR_VALUE, "fills the whole world; leave some air");
    }
    for (int i = 0; i < 4; i++) {
        static const unsigned sides[] = {SKV_SIDE_LEFT, SKV_SIDE_RIGHT, SKV_SIDE_BOTTOM,
                                         SKV_SIDE_TOP};
        if (c->value[SKV_F_OPEN_LEFT + i].number != 0.0)
            scene->open_sides |= sides[i];
    }
    return SKV_OK;
}

/* Makes the terrain; the coverage has served then. */
static skv_result build_terrain(builder *c)
{
    skv_scene *scene = c->scene;
    skv_terrain_def def = skv_default_terrain_def();
    def.width = scene->width;
    def.height = scene->height;
    def.coverage = scene->coverage;
    def.pixel_size = (float)scene->pixel_size;
    def.open_sides = scene->open_sides;
    skv_result result = skv_terrain_create(&def, &scene->terrain, c->error);
    skv_free(scene->coverage);
    scene->coverage = NULL;
    return result;
}

/* ---- Fluid ----------------------------------------------------------------------------------- */

/* The parameters that were given, over the defaults: first those that set others. */
static void build_parameters(builder *c)
{
    skv_world_def *def = &c->scene->def;
    *def = skv_default_world_def();
    skv_parameter_store(def, SKV_P_FLUID_LAW, c->value[SKV_F_FLUID_LAW].number);
    skv_parameter_store(def, SKV_P_FLUID_MATERIAL, c->value[SKV_F_FLUID_MATERIAL].number);
    for (int i = SKV_F_WORLDS; i < SKV_F_SINGLE; i++) {
        if (i != SKV_F_FLUID_LAW && i != SKV_F_FLUID_MATERIAL && is_given(c, (skv_field_id)i))
            skv_parameter_store(def, i - SKV_F_WORLDS, c->value[i].number);
    }
}

/* Fluid up to a share of the height that walls leave free. */
static void fill_lower(skv_water *water, const skv_terrain *terrain, double share)
{
    float low, high;
    skv_terrain_free_range(terrain, &low, &high);
    water->level = (double)low + share * ((double)high - (double)low);
}

/* Whether the file says itself that there is no fluid at the start. */
static bool is_empty(const builder *c)
{
    const skv_shape_list *water = &c->draft->values.list[SKV_LIST_WATER];
    return water->given && water->count == 0 && !skv_scene_is_painted(c->scene);
}

/* Where the fluid starts. */
static skv_result build_water(builder *c, const skv_terrain *terrain)
{
    skv_scene *scene = c->scene;
    skv_water *water = &scene->water;
    water->width = scene->width;
    water->height = scene->height;
    water->pixel_size = scene->pixel_size;
    if (skv_scene_is_painted(scene)) {
        water->paint = scene->paint;
    } else if (is_empty(c)) {
        fill_lower(water, terrain, 0.5); /* until there is a spacing */
    } else if (water->shape_count == 0) {
        if (!c->pictured)
            return skv_fail(c->error, SKV_ERROR_VALUE,
                            "%s: water: is missing; say where the fluid starts, such as "
                            "[ { \"shape\": \"box\", \"y1\": 0.45 } ]",
                            c->draft->label);
        fill_lower(water, terrain, 0.4);
        skv_scene_note(scene, "no blue pixel: the lower part starts as water");
    }
    skv_water_set_bounds(water);
    return skv_lay_measure(water, terrain, c->error);
}

static skv_result fail_no_fit(const builder *c)
{
    const skv_water *water = &c->scene->water;
    if (water->paint != NULL && water->shape_count == 0)
        return fail_unfit(c, SKV_ERROR_VALUE,
                          "the blue (fluid) pixels have no room for a particle; paint more blue "
                          "or make the passages wider");
    if (c->pictured && water->shape_count == 0)
        return fail_unfit(c, SKV_ERROR_VALUE,
                          "the dark (air) pixels have no room for a particle; make the passages "
                          "wider");
    skv_origin origin = c->draft->values.list[SKV_LIST_WATER].shapes[0].origin;
    return skv_draft_fail(c->draft, origin, "water", c->error, SKV_ERROR_VALUE,
                          "has no room for a particle; it lies in solid or is too small");
}

/* How many particles the water is made of at a spacing: each takes the spacing's square. */
static double count_at(const builder *c, double spacing)
{
    return floor(c->scene->water.area / (spacing * spacing) + 0.5);
}

/* The spacing was given: the number of particles follows. */
static skv_result count_particles(builder *c)
{
    skv_scene *scene = c->scene;
    double count = count_at(c, (double)scene->def.fluid.spacing);
    if (count <= SKV_MAX_PARTICLES) {
        scene->particles = (int)count;
        return count > 0 ? SKV_OK : fail_no_fit(c);
    }
    char message[120], enough[32];
    skv_format_number(ceil(1e5 * sqrt(scene->water.area / SKV_MAX_PARTICLES)) * 1e-5, enough);
    skv_format(message, sizeof message,
               "makes more than %d particles, which are allowed; with %s m it does not",
               SKV_MAX_PARTICLES, enough);
    return fail(c, SKV_F_FLUID_SPACING, SKV_ERROR_LIMIT, message);
}

/* The number of particles is wanted: the spacing follows. A number that nobody asked for gives way
 * where it does not fit: the spacing is at least 1/400 of the width, so that a few blue pixels do
 * not become dust, unless nothing fits then; and it is at most the largest allowed. */
static skv_result choose_spacing(builder *c)
{
    skv_scene *scene = c->scene;
    const skv_field *field = &skv_scene_fields(NULL)[SKV_F_FLUID_SPACING];
    double wanted = c->value[SKV_F_PARTICLES].number, spacing = sqrt(scene->water.area / wanted);
    double fewest = skv_max(1, count_at(c, field->maximum));
    double most = skv_min(count_at(c, field->minimum), SKV_MAX_PARTICLES);
    if (most < 1)
        return fail_no_fit(c);
    if (is_given(c, SKV_F_PARTICLES) && (wanted < fewest || wanted > most)) {
        char message[160];
        skv_format(message, sizeof message, "%.0f %s; allowed are %.0f to %.0f", wanted,
                   wanted < fewest ? "are too few for this much fluid"
                                   : "do not fit into this little fluid",
                   fewest, most);
        return fail(c, SKV_F_PARTICLES, wanted < fewest ? SKV_ERROR_VALUE : SKV_ERROR_LIMIT,
                    message);
    }
    if (!is_given(c, SKV_F_PARTICLES)) {
        double coarse = scene->width * scene->pixel_size / 400.0;
        if (spacing < coarse && count_at(c, coarse) > 0)
            spacing = coarse;
        spacing = skv_max(field->minimum, skv_min(spacing, field->maximum));
        wanted = count_at(c, spacing);
    }
    scene->def.fluid.spacing = (float)spacing;
    scene->particles = (int)wanted;
    return SKV_OK;
}

/* An empty scene is as fine as if its lower half were full, and then loses that fluid. */
static void take_water_out(skv_scene *scene)
{
    scene->water.level = 0;
    skv_water_set_bounds(&scene->water);
    scene->particles = 0;
}

static skv_result build_particles(builder *c)
{
    skv_source number = c->value[SKV_F_PARTICLES].origin.source;
    skv_source spacing = c->value[SKV_F_FLUID_SPACING].origin.source;
    bool both_set = number >= SKV_FROM_SETTING && spacing >= SKV_FROM_SETTING;
    if (spacing != SKV_FROM_DEFAULT && (number == spacing || both_set))
        return fail(c, SKV_F_PARTICLES, SKV_ERROR_VALUE,
                    "follows from fluid.spacing; give only one of them");
    skv_result result = spacing > number ? count_particles(c) : choose_spacing(c);
    c->scene->amount = c->scene->particles;
    if (is_empty(c))
        take_water_out(c->scene);
    return result;
}

/* Bodies that lie in fluid take its place: what is left is measured anew. As many particles in less
 * room lie closer, so the bodies are as fit as they were. */
static skv_result make_room(builder *c)
{
    skv_result result = skv_lay_measure(&c->scene->water, c->scene->terrain, c->error);
    return result == SKV_OK && c->scene->particles > 0 ? build_particles(c) : result;
}

/* Whether a world can have these walls beside so fine a fluid, while little has been made. */
static skv_result check_walls(const builder *c, const skv_terrain *terrain)
{
    const skv_fluid_def *fluid = &c->scene->def.fluid;
    skv_error cause;
    skv_result result = skv_wall_map_check(terrain, fluid->spacing * fluid->radius_ratio, &cause);
    if (result == SKV_OK)
        return SKV_OK;
    return c->pictured ? fail_unfit(c, result, cause.text)
                       : skv_fail(c->error, result, "%s: %s", c->draft->label, cause.text);
}

/* The deepest fluid to expect. Gravity that is not vertical may pile it up anywhere; emitters, or
 * whoever finds it empty, fill the world. */
static void build_depth(builder *c, const skv_terrain *terrain)
{
    skv_scene *scene = c->scene;
    float low, high;
    skv_terrain_free_range(terrain, &low, &high);
    double width = scene->width * scene->pixel_size, height = scene->height * scene->pixel_size;
    double depth = c->value[SKV_F_DEPTH].number;
    bool filled_later = scene->emitter_count > 0 || scene->particles == 0;
    if (depth == 0.0 && filled_later && scene->def.gravity_x == 0)
        depth = (double)high - (double)low;
    else if (depth == 0.0 && scene->def.gravity_x != 0)
        depth = width > height ? width : height;
    else if (depth == 0.0)
        depth = scene->def.gravity_y <= 0 ? (double)scene->water.y1 - (double)low
                                          : (double)high - (double)scene->water.y0;
    double least = (double)scene->def.fluid.spacing;
    scene->def.depth = (float)(depth > least ? depth : least);
}

static void note_taps(skv_scene *scene)
{
    int emitters = scene->emitter_count, drains = scene->drain_count;
    if (emitters > 0)
        skv_scene_note(scene,
                       emitters == 1 ? "%d green area emits fluid at 1 m/s"
                                     : "%d green areas emit fluid at 1 m/s",
                       emitters);
    if (drains > 0)
        skv_scene_note(scene, drains == 1 ? "%d red area drains it" : "%d red areas drain it",
                       drains);
}

/* Painted taps come first, then those of the file. */
static skv_result build_taps(builder *c)
{
    skv_error cause;
    skv_result result = skv_scene_add_emitters(c->scene, &c->taps, c->picture_label, &cause);
    if (result != SKV_OK)
        return fail_picture(c, result, cause.text);
    note_taps(c->scene);
    return skv_scene_build_acting(c->draft, c->scene, c->error);
}

/* ---- All of it ------------------------------------------------------------------------------- */

static skv_result build(builder *c, skv_image *picture)
{
    skv_result result = build_texts(c);
    build_parameters(c);
    if (result == SKV_OK)
        result = skv_scene_build_fluids(c->draft, c->scene, c->error);
    if (result == SKV_OK)
        result = c->pictured ? build_picture(c, picture) : build_blank(c);
    if (result == SKV_OK)
        result = build_walls(c);
    if (result == SKV_OK)
        result = build_terrain(c);
    if (result != SKV_OK)
        return result;
    const skv_terrain *terrain = c->scene->terrain;
    result = build_water(c, terrain);
    if (result == SKV_OK)
        result = build_particles(c);
    if (result == SKV_OK)
        result = check_walls(c, terrain);
    if (result == SKV_OK)
        result = skv_scene_build_bodies(c->draft, c->picture_label, c->scene, c->error);
    if (result == SKV_OK && c->scene->water.cover_count > 0)
        result = make_room(c);
    c->scene->settle = c->value[SKV_F_SETTLE].number != 0.0;
    c->scene->air = (float)(1000 * c->draft->values.air_pressure.number);
    if (result == SKV_OK)
        result = build_taps(c);
    if (result == SKV_OK)
        build_depth(c, terrain);
    return result;
}

skv_result skv_scene_build(const skv_draft *draft, skv_image *picture, const char *picture_label,
                           skv_scene **scene, skv_error *error)
{
    builder c = {.draft = draft,
                 .value = draft->values.value,
                 .scene = skv_calloc(1, sizeof *c.scene),
                 .pictured = picture != NULL,
                 .picture_label = picture_label,
                 .error = error};
    if (c.scene == NULL)
        return fail_memory(&c);
    skv_result result = build(&c, picture);
    if (result == SKV_OK) {
        skv_scene_add_notes(c.scene);
        *scene = c.scene;
    } else {
        skv_scene_destroy(c.scene);
    }
    return result;
}
