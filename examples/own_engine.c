/* A physics engine of your own: Chipmunk owns the bodies, with their contacts and joints, and the
 * fluid lifts and drags them. A box floats by itself, a crate rides on a raft of two planks with a
 * hinge, and a rope holds a buoy under water. Prints where they come to rest. */
#include <skvalp/measure.h>
#include <skvalp/skvalp.h>

#include <chipmunk/chipmunk.h>
#include <stdio.h>

enum { BOX, LEFT_PLANK, RIGHT_PLANK, CRATE, BUOY, THINGS };
static const struct {
    const char *name;
    float x, y, width, height, density;
} table[THINGS] = {
    {"box", 0.25f, 0.45f, 0.2f, 0.1f, 500},          {"left plank", 0.7f, 0.45f, 0.19f, 0.06f, 300},
    {"right plank", 0.9f, 0.45f, 0.19f, 0.06f, 300}, {"crate", 0.8f, 0.55f, 0.08f, 0.08f, 400},
    {"buoy", 1.3f, 0.25f, 0.1f, 0.1f, 50},
};

/* A thing in both engines. */
typedef struct thing {
    skv_body_id id;
    skv_body told; /* what the fluid has made of it */
    cpBody *body;
} thing;

typedef struct game {
    cpSpace *space;
    cpConstraint *rope;
    thing things[THINGS];
    float dt;
} game;

/* Chipmunk's step asks for velocities here, before it solves contacts and joints: the fluid has
 * changed them, gravity included. */
static void take_over(cpBody *body, cpVect gravity, cpFloat damping, cpFloat dt)
{
    (void)gravity, (void)damping, (void)dt;
    const skv_body *told = &((thing *)cpBodyGetUserData(body))->told;
    cpBodySetVelocity(body, cpv((double)told->vx, (double)told->vy));
    cpBodySetAngularVelocity(body, (double)told->spin);
}

/* Before each substep of the fluid Chipmunk takes a step as long. With a body the fluid that lies
 * on it moves, too, so that is part of the mass. */
static void step_bodies(skv_world *world, float dt, void *user)
{
    game *g = user;
    g->dt = dt;
    for (thing *t = g->things; t < g->things + THINGS; t++) {
        skv_world_body(world, t->id, &t->told);
        cpBodySetMass(t->body, (double)t->told.moved_mass);
        cpBodySetMoment(t->body, (double)t->told.moved_inertia);
    }
    cpSpaceStep(g->space, (double)dt);
    for (const thing *t = g->things; t < g->things + THINGS; t++) {
        cpVect at = cpBodyGetPosition(t->body), v = cpBodyGetVelocity(t->body);
        skv_world_lead_body(world, t->id, (float)at.x, (float)at.y, (float)cpBodyGetAngle(t->body),
                            (float)v.x, (float)v.y, (float)cpBodyGetAngularVelocity(t->body), NULL);
    }
}

static skv_result add_thing(game *g, skv_world *world, int which, skv_error *error)
{
    thing *t = &g->things[which];
    float width = table[which].width, height = table[which].height;
    skv_body_def def = skv_default_body_def();
    def.shape = skv_box(-width / 2, -height / 2, width / 2, height / 2);
    def.x = table[which].x;
    def.y = table[which].y;
    def.density = table[which].density;
    def.hosted = true;
    skv_result result = skv_world_add_body(world, &def, &t->id, NULL, error);
    skv_world_body(world, t->id, &t->told);
    if (result != SKV_OK)
        return result;
    t->body = cpSpaceAddBody(g->space, cpBodyNew((double)t->told.mass, (double)t->told.inertia));
    cpBodySetPosition(t->body, cpv((double)t->told.x, (double)t->told.y));
    cpBodySetUserData(t->body, t);
    cpBodySetVelocityUpdateFunc(t->body, take_over);
    cpShape *shape = cpBoxShapeNew(t->body, (double)width, (double)height, 0);
    cpShapeSetFriction(cpSpaceAddShape(g->space, shape), 0.5);
    return SKV_OK;
}

static skv_result make(game *g, skv_world *world, skv_error *error)
{
    skv_fill_def pool = skv_default_fill_def();
    pool.y1 = 0.4f;
    skv_result result = skv_world_fill(world, &pool, NULL, error);
    skv_world_set_before_substep(world, step_bodies, g);
    g->space = cpSpaceNew(); /* without gravity of its own: the fluid's world has it */
    cpSpaceSetCollisionSlop(g->space, 3e-4); /* m */
    cpSpaceSetIterations(g->space, 20);
    /* The tank has its sides 0.1 m inside of these lines, which are as thick. */
    cpBody *ground = cpSpaceGetStaticBody(g->space);
    cpVect corner[] = {{-0.1, 1}, {-0.1, -0.1}, {1.7, -0.1}, {1.7, 1}};
    for (int i = 0; i < 3; i++)
        cpSpaceAddShape(g->space, cpSegmentShapeNew(ground, corner[i], corner[i + 1], 0.1));
    for (int i = 0; i < THINGS && result == SKV_OK; i++)
        result = add_thing(g, world, i, error);
    if (result != SKV_OK)
        return result;
    const thing *t = g->things;
    cpSpaceAddConstraint(g->space,
                         cpPivotJointNew(t[LEFT_PLANK].body, t[RIGHT_PLANK].body, cpv(0.8, 0.45)));
    g->rope = cpSpaceAddConstraint(
        g->space, cpSlideJointNew(t[BUOY].body, ground, cpv(0, -0.05), cpv(1.3, 0), 0, 0.1));
    return SKV_OK;
}

static void tell(const game *g, const skv_survey *survey)
{
    double level = 0;
    skv_survey_surface(survey, 1.1, 0, 1.1, 0.8, &level);
    for (int i = 0; i < THINGS; i++) {
        cpVect at = cpBodyGetPosition(g->things[i].body), v = cpBodyGetVelocity(g->things[i].body);
        printf("%-11s at x = %.2f m, its middle %+4.0f mm from the surface, %.1f mm/s\n",
               table[i].name, at.x, 1000 * (at.y - level), 1000 * cpvlength(v));
    }
    double lift = 9.81 * (1000 - (double)table[BUOY].density) * 0.01;
    printf("the rope holds %.2f of the buoy's lift\n",
           cpConstraintGetImpulse(g->rope) / (double)g->dt / lift);
}

int main(void)
{
    game g = {0};
    skv_error error = {0};
    skv_world *world = NULL;
    skv_survey *survey = NULL;
    skv_world_def def = skv_default_world_def();
    def.fluid.spacing = 0.02f;
    bool well =
        skv_world_create(&def, &world, &error) == SKV_OK && make(&g, world, &error) == SKV_OK;
    for (int frame = 0; frame < 480 && well; frame++)
        well = skv_world_step(world, 1.0f / 60, &error) == SKV_OK;
    well = well && skv_survey_create(&survey, &error) == SKV_OK &&
           skv_survey_take(survey, world, &error) == SKV_OK;
    if (well)
        tell(&g, survey);
    else
        fprintf(stderr, "%s\n", error.text);
    skv_survey_destroy(survey);
    skv_world_destroy(world);
    return well ? 0 : 1;
}
