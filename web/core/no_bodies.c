/* What stands for rigid bodies in the page's first modules: without them a first visit takes a
 * thirtieth less. Who asks for some is refused, and the host, which is told, brings the modules
 * that have them. Invariant: no field of a scene here is a body's, so no world here gets one, and
 * what a world with bodies asks is never asked.
 */
#include "base/more.h"
#include "render/bodies.h"
#include "scene/bodies.h"
#include "solver/rows/solids.h"
#include "world/bodies/bodies.h"
#include "world/hands.h"

static bool wanted;

/* Whether somebody has wanted more since this was last called. Modules that lack nothing do not
 * export it. */
__attribute__((export_name("skv_wasm_wants_more"))) bool skv_wasm_wants_more(void);

skv_result skv_want_more(skv_error *error)
{
    wanted = true;
    return skv_fail(error, SKV_ERROR_VALUE, "the part for it is yet to come; try again");
}

bool skv_wasm_wants_more(void)
{
    bool was = wanted;
    wanted = false;
    return was;
}

skv_result skv_scene_build_bodies(const skv_draft *draft, const char *picture, skv_scene *scene,
                                  skv_error *error)
{
    (void)draft, (void)picture, (void)scene, (void)error;
    return SKV_OK; /* what is painted is refused by then: no_fluids.c */
}

skv_result skv_scene_add_bodies(const skv_scene *scene, skv_world *world, skv_error *error)
{
    (void)scene, (void)world, (void)error;
    return SKV_OK;
}

bool skv_water_is_covered(const skv_water *water, float x, float y)
{
    (void)water, (void)x, (void)y;
    return false;
}

skv_result skv_bodies_draw(skv_strokes *strokes, const skv_overlay_scene *scene, skv_error *error)
{
    (void)strokes, (void)scene, (void)error;
    return SKV_OK;
}

skv_placed_body skv_body_place(const skv_body *body)
{
    (void)body;
    return (skv_placed_body){0};
}

float skv_placed_body_distance(const skv_placed_body *placed, float x, float y)
{
    (void)placed, (void)x, (void)y;
    return INFINITY;
}

skv_result skv_bodies_check(skv_reader *reader, float spacing, bool with_touches, skv_error *error)
{
    (void)reader, (void)spacing, (void)with_touches;
    return skv_want_more(error);
}

skv_result skv_bodies_load(const skv_world *world, skv_reader reader, bool with_touches,
                           skv_bodies **bodies, skv_error *error)
{
    (void)world, (void)bodies;
    return skv_bodies_check(&reader, 0, with_touches, error);
}

float skv_bodies_distance(const skv_world *world, float x, float y)
{
    (void)world, (void)x, (void)y;
    return INFINITY;
}

bool skv_hands_hold_bodies(const skv_acting *acting)
{
    (void)acting;
    return false;
}

void skv_exchange_held(skv_port *port, skv_hand *hand)
{
    (void)port, (void)hand;
    skv_want_more(NULL);
}

skv_result skv_exchange_holds(skv_port *port, skv_acting *acting, skv_error *error)
{
    (void)acting;
    return skv_bodies_check(port->from, 0, false, error);
}

bool skv_world_grasp(const skv_world *world, float x, float y, float reach, skv_hand *hand)
{
    (void)world, (void)x, (void)y, (void)reach, (void)hand;
    return false;
}

void skv_bodies_take_over(skv_world *world, skv_bodies *bodies)
{
    (void)world, (void)bodies;
}

void skv_bodies_destroy(skv_bodies *bodies)
{
    (void)bodies;
}

void skv_bodies_save(skv_writer *writer, const skv_bodies *bodies)
{
    (void)writer, (void)bodies;
}

void skv_bodies_begin_step(skv_world *world)
{
    (void)world;
}

void skv_bodies_move(skv_world *world, double dt)
{
    (void)world, (void)dt;
}

bool skv_bodies_may_have_films(const skv_world *world)
{
    (void)world;
    return false;
}

void skv_bodies_feel(skv_world *world, double dt, bool moves)
{
    (void)world, (void)dt, (void)moves;
}

void skv_bodies_remove_leavers(skv_world *world)
{
    (void)world;
}

void skv_rows_expect_solids(const skv_rows *rows, int row, const skv_boundary *boundary)
{
    (void)rows, (void)row, (void)boundary;
}

float skv_rows_sample_solids(const skv_boundary *boundary, bool images, float x, float y,
                             skv_near_wall *to)
{
    (void)boundary, (void)images, (void)x, (void)y, (void)to;
    return 0;
}

void skv_rows_way_of_walls(const skv_rows *rows, const skv_near_wall *wall, const skv_constants *c,
                           const skv_boundary *boundary, float *dx, float *dy)
{
    (void)rows, (void)wall, (void)c, (void)boundary, (void)dx, (void)dy;
}

void skv_rows_tell_solids(const skv_rows *rows, const skv_boundary *boundary, skv_impulse *given)
{
    (void)rows, (void)boundary, (void)given;
}

bool skv_bodies_stir(const skv_world *world, int particle)
{
    (void)world, (void)particle;
    return false;
}

int skv_bodies_awake(const skv_world *world)
{
    (void)world;
    return 0;
}

bool skv_bodies_sleep(const skv_world *world)
{
    (void)world;
    return false;
}

bool skv_bodies_are_watched(const skv_bodies *bodies)
{
    (void)bodies;
    return false;
}

void skv_bodies_wake_all(skv_world *world)
{
    (void)world;
}

void skv_bodies_disturb(skv_world *world, int particle, bool look_round)
{
    (void)world, (void)particle, (void)look_round;
}

void skv_bodies_watch(skv_world *world, float most)
{
    (void)world, (void)most;
}

void skv_bodies_show(skv_world *world)
{
    (void)world;
}

void skv_bodies_come_to_rest(skv_world *world)
{
    (void)world;
}

uint64_t skv_bodies_hash(uint64_t hash, const skv_bodies *bodies)
{
    (void)bodies;
    return hash;
}

void skv_rows_book_push(const skv_rows *rows, const skv_near_wall *wall, bool images,
                        const skv_boundary *boundary, float x, float y, float dx, float dy,
                        skv_push_made made, skv_row_given *walls)
{
    (void)rows, (void)wall, (void)images, (void)boundary, (void)x, (void)y, (void)dx, (void)dy;
    (void)made, (void)walls;
}

void skv_rows_book_cuts(const skv_rows *rows, const skv_boundary *boundary, int i, float x, float y,
                        const skv_cuts *cuts, skv_row_given *walls)
{
    (void)rows, (void)boundary, (void)i, (void)x, (void)y, (void)cuts, (void)walls;
}

void skv_rows_book_turns(const skv_rows *rows, int row, const skv_constants *c,
                         const skv_boundary *boundary, const skv_row_samples *samples,
                         skv_row_given *walls)
{
    (void)rows, (void)row, (void)c, (void)boundary, (void)samples, (void)walls;
}

void skv_rows_touch_solids(const skv_rows *rows, int i, const skv_constants *c,
                           const skv_boundary *boundary, skv_row_given *walls)
{
    (void)rows, (void)i, (void)c, (void)boundary, (void)walls;
}

float skv_solids_slide(const skv_boundary *boundary, bool advances, bool on, float *x, float *y,
                       float dx, float dy, float *along_x, float *along_y, float *distance,
                       skv_cuts *cuts)
{
    (void)boundary, (void)advances, (void)on, (void)x, (void)y, (void)dx, (void)dy;
    (void)along_x, (void)along_y, (void)distance, (void)cuts;
    return 1;
}
