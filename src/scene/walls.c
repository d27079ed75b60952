/* The shapes of walls, drawn over what the picture has. Invariant: none is so thin that it leaks,
 * and none takes seconds to draw. */
#include "scene/walls.h"

#include "scene/notes.h"
#include "scene/raster.h"

#define THINNEST_WALL 1.2 /* pixels */

/* No wall is lost between pixels: the thinnest that leaves solid all along itself, wherever and at
 * whatever angle it lies. */
static void thicken(skv_scene *scene)
{
    double least = THINNEST_WALL * scene->pixel_size;
    int count = 0, last = 0;
    for (int i = 0; i < scene->solid_count; i++) {
        if (!scene->solids[i].carve && skv_shape_thicken(&scene->solids[i], least)) {
            count++;
            last = i;
        }
    }
    char text[32];
    skv_format_number(least, text);
    if (count == 1)
        skv_scene_note(scene, "solid[%d] is made %s m thick, the least that holds water", last,
                       text);
    else if (count > 1)
        skv_scene_note(scene, "%d thin shapes are made %s m thick, the least that holds water",
                       count, text);
}

skv_result skv_scene_draw_walls(const skv_draft *draft, skv_scene *scene, skv_error *error)
{
    thicken(scene);
    int last =
        skv_raster_too_much(scene->solids, scene->solid_count, scene->height, scene->pixel_size);
    if (last == scene->solid_count)
        return skv_raster_solids(scene->solids, scene->solid_count, scene->width, scene->height,
                                 scene->pixel_size, scene->coverage, error);
    const skv_shape_values *shapes = draft->values.list[SKV_LIST_SOLID].shapes;
    return skv_draft_fail(draft, shapes[last].origin, "solid", error, SKV_ERROR_LIMIT,
                          "its lines are too long for pixels so small: all pieces together may go "
                          "through %d rows of pixels; choose larger pixels or fewer points",
                          SKV_RASTER_MOST_ROWS);
}
