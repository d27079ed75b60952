/** @file
 * Terrain: the solid world, made from a picture of how much of each pixel is solid.
 *
 * The wall lies where the coverage, interpolated between pixel centres, crosses one half (the
 * marching-squares contour), so grey edge pixels place it with sub-pixel accuracy. Everything
 * outside the picture is solid, except beyond the sides that are opened. Distances are positive in
 * the free region and negative inside solid. Coordinates are metres, the origin is the picture's
 * lower left corner, y is up. See docs/model.md, "Terrain".
 */
#ifndef SKVALP_TERRAIN_H
#define SKVALP_TERRAIN_H

#include "skvalp/base.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Smallest and largest width and height of a picture, in pixels. */
#define SKV_TERRAIN_MIN_PIXELS 16
#define SKV_TERRAIN_MAX_PIXELS 8192
/** At most so many sides of pixels may part solid from air, for walls cost time along these: with
 * all of them in the largest picture a scene still opens in ten seconds. */
#define SKV_TERRAIN_MAX_EDGE 2097152

/** Sides of the picture beyond which there is air instead of solid. Particles that leave through an
 * open side are removed from the world by the next step. */
typedef enum skv_side {
    SKV_SIDE_LEFT = 1,
    SKV_SIDE_RIGHT = 2,
    SKV_SIDE_BOTTOM = 4,
    SKV_SIDE_TOP = 8
} skv_side;

/** How to make a terrain. Initialise with skv_default_terrain_def. */
typedef struct skv_terrain_def {
    uint32_t cookie;
    int width;  /**< pixels, SKV_TERRAIN_MIN_PIXELS..SKV_TERRAIN_MAX_PIXELS */
    int height; /**< pixels, the same range */
    /** width*height bytes, row 0 at the BOTTOM: 0 = air, 255 = solid, with at most
     * SKV_TERRAIN_MAX_EDGE sides between them. Null means all air: a closed tank. Read during
     * creation only, never kept. */
    const uint8_t *coverage;
    float pixel_size;    /**< metres a pixel, 1e-9 or more; width and height in metres at most 16 */
    unsigned open_sides; /**< a set of skv_side bits; default 0 */
} skv_terrain_def;

/** 640 x 360 pixels of air at 2.5 mm: a closed tank of 1.6 x 0.9 m. */
SKV_API skv_terrain_def skv_default_terrain_def(void);
SKV_API void skv_terrain_def_init(skv_terrain_def *def, size_t size);

typedef struct skv_terrain skv_terrain;

/** Builds a terrain; `*terrain` is null on failure. Cost: about 100 ns a pixel. Fails with
 * SKV_ERROR_VALUE (sizes out of range, not finite) or SKV_ERROR_MEMORY. */
SKV_API skv_result skv_terrain_create(const skv_terrain_def *def, skv_terrain **terrain,
                                      skv_error *error);

/** A stroke of a brush: all within `radius` of the straight way from (x0, y0) to (x1, y1). A curve
 * is a series of strokes. Plain data, to be kept or sent: the same strokes make the same terrain
 * everywhere. */
typedef struct skv_brush_stroke {
    float x0, y0, x1, y1; /**< m, each within 1000 m; what lies outside the picture is left out */
    float radius;         /**< m, above 0, at most 100; half a pixel at least is painted */
    bool erase;           /**< makes air instead of solid */
} skv_brush_stroke;

/** Makes another version of a terrain with strokes painted one after the other, their edges as
 * exact as grey pixels tell; the terrain itself stays as it is. It equals, bit for bit, a terrain
 * created from the same picture, but its cost follows the area that changes, apart from one copy of
 * the picture. Without any change `*painted` is the same terrain, shared. On failure it is null:
 * SKV_ERROR_VALUE (a number out of range), SKV_ERROR_LIMIT (more than SKV_TERRAIN_MAX_EDGE sides
 * between solid and air) or SKV_ERROR_MEMORY. Thread-safe. */
SKV_API skv_result skv_terrain_paint(const skv_terrain *terrain, const skv_brush_stroke *strokes,
                                     int count, skv_terrain **painted, skv_error *error);

/** Shares a terrain: returns the same one, to be given to another world or destroyed like one that
 * was created. It never changes, so any number of worlds may hold it and step on threads of their
 * own at the same time. Thread-safe. */
SKV_API skv_terrain *skv_terrain_share(const skv_terrain *terrain);

/** Gives up a terrain that no world has taken over; it is freed when nobody shares it any more.
 * Null is allowed. Thread-safe. */
SKV_API void skv_terrain_destroy(skv_terrain *terrain);

/** Size of the picture in metres and in pixels. Thread-safe on a constant terrain, like all
 * functions below. */
SKV_API float skv_terrain_width(const skv_terrain *terrain);
SKV_API float skv_terrain_height(const skv_terrain *terrain);
SKV_API int skv_terrain_pixels_x(const skv_terrain *terrain);
SKV_API int skv_terrain_pixels_y(const skv_terrain *terrain);
SKV_API float skv_terrain_pixel_size(const skv_terrain *terrain);
SKV_API unsigned skv_terrain_open_sides(const skv_terrain *terrain);

/** Distances are exact up to so many pixels from a wall; inside the picture all that is farther
 * away, on either side, is that far. */
#define SKV_TERRAIN_REACH 48

/** Signed distance in metres from (x, y) to the nearest wall: > 0 in the free region, < 0 inside
 * solid; at most SKV_TERRAIN_REACH pixels, and beyond the picture the way to it more. Bilinear
 * between pixel centres; its error against an analytic wall is below 0.1 pixel for grey pictures
 * and about 0.3 for black and white ones. Any finite point is allowed. */
SKV_API float skv_terrain_distance(const skv_terrain *terrain, float x, float y);

/** Distance as above, and in *nx, *ny the unit normal that points out of the wall into the free
 * region (the 3x3 kernel of the thesis' section 3.4 on the sub-pixel distance, interpolated and
 * renormalised). Where the normal is undefined (the middle of a channel) it is (0, 1). */
SKV_API float skv_terrain_normal(const skv_terrain *terrain, float x, float y, float *nx,
                                 float *ny);

/** How far a straight move from (x0, y0) to (x1, y1) may go before it comes closer to a wall than
 * `margin` metres: a fraction 0..1 of the move. A move that starts closer than that may go on as
 * long as it does not get deeper. A move that begins more than 65536 pixels from the origin, or is
 * longer than 1e9 pixels, is not made. The swept test that keeps fast particles out of thin walls.
 */
SKV_API float skv_terrain_sweep(const skv_terrain *terrain, float x0, float y0, float x1, float y1,
                                float margin);

/** The lowest and highest points, in metres, of the free region; both 0 if there is none. */
SKV_API void skv_terrain_free_range(const skv_terrain *terrain, float *lowest, float *highest);

/** The area of the free region in m^2, to a fraction of a pixel along its walls. */
SKV_API double skv_terrain_free_area(const skv_terrain *terrain);

/** The signed distance at every pixel centre in metres, within SKV_TERRAIN_REACH pixels, row 0
 * at the bottom, width*height floats with the given row stride in floats. For drawing walls. Valid
 * as long as the terrain. */
SKV_API const float *skv_terrain_distances(const skv_terrain *terrain, int *stride);

#ifdef __cplusplus
}
#endif
#endif
