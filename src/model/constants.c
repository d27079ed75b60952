/* From a fluid's parameters to the constants of a substep.
 *
 * Invariant: all of it is double precision from +, -, *, /, sqrt and the exact functions, rounded
 * to float once at the end, so every machine steps with the same constants. Formulas and their
 * sources are in docs/model.md.
 */
#include "model/constants.h"

#include "base/exact.h"
#include "model/lattice.h"

#include <math.h>

#define FRAME            (1.0 / 60) /* s: rates "a frame" are meant for this time */
#define COMPRESSION      0.04       /* allowed at the expected depth, calibrated law */
#define CLAVET_LOAD      0.006      /* g H dt^2 / h^2 that the clavet law carries */
#define CLAVET_LOOSE     0.75  /* of the density at rest; P never is positive at rest, either */
#define SPEED_OF_SOUND   0.78  /* of the calibrated law, h per substep that starts cold */
#define WARM_SUBSTEPS    0.75  /* as stiff as one cold one, if they start warm: fewer flicker */
#define MOST_LIVELY      4     /* omega eta^2: what an iteration applies is bounded by it */
#define WARM_LIVELY      3.2   /* the same of a fluid that starts warm */
#define WARM_REACH       0.7   /* of the pressure at the expected depth: more is found cold */
#define WARM_MOST        6     /* pushes that are found, at most; at rest it is up to 1.6 */
#define MAX_COURANT      0.9   /* fastest advance, h per substep */
#define PAIR_LAG         0.7f  /* of the way: waves and jets lose a third of what they would */
#define LAG_FROM         0.010 /* h per substep, from which on it is whole: what rests stays calm */
#define CLAVET_LIMIT     0.2   /* bound of rho N / h, see relaxation.c */
#define LEAST_VISCOSITY  1e-5  /* m^2/s: less is lost in the method's own */
#define MOST_SUBSTEPS    1000  /* a frame, as in a definition */
#define COHESION_FROM    0.25  /* rest densities: a little more than two in one place */
#define COHESION_FULL    0.5   /* rest densities: a little less than at a flat surface */
#define COHESION_BELOW   0.95  /* rest densities: the bulk, which wants for nothing */
#define COHESION_PULL    1.785 /* half of what makes F pull as q did: a crust drags on waves */
#define COHESION_TENSION 0.255 /* of k_coh; more makes drops stiffer, less lets them come apart */
#define TENSION_FROM     0.2   /* of |g| at a flat surface: how uneven the bulk may be */
#define TENSION_UNTIL    0.25  /* of the push at the expected depth: what is pressed so has none */
#define STICKS           0.05  /* wall friction from which on a viscous fluid does not slip */
#define RESIDUAL_CROWD   2     /* how crowded the residual volume is, to the lattice */
#define SLIP_FRICTION    0.2   /* of the friction in contact: it acts on all of the layer */
#define MOST_SPRING      4.05  /* k dt^2 eta^2: at twice as much springs throw the lattice apart */
#define TURN_REACH       1.6f  /* spacings: the next neighbours in the lattice, and no others */
#define COHESION_MARGIN  12    /* how much stiffer than the cohesion the pressure must be */

skv_kernel skv_law_kernel(skv_law law)
{
    return law == SKV_LAW_CLAVET ? SKV_KERNEL_SPIKY : SKV_KERNEL_SMOOTH;
}

bool skv_has_images(const skv_fluid_def *f)
{
    return f->wall_images && f->law == SKV_LAW_CALIBRATED;
}

float skv_contact_distance(const skv_fluid_def *f)
{
    /* Images hold particles off by themselves. What contact adds to that is work from nowhere,
     * which drives fluid along walls. Only what is inside a wall is pushed out. */
    return skv_has_images(f) ? 0 : f->contact_distance * f->spacing;
}

/* The share of a correction that an iteration applies. It takes 0.49 omega eta^2 of the liveliest
 * waves of the lattice; more than 2 makes them grow, and what meets a wall or itself at speed flies
 * apart. */
static double relaxation(const skv_fluid_def *f)
{
    double eta = (double)f->radius_ratio, most = MOST_LIVELY / (eta * eta);
    return (double)f->relaxation < most ? (double)f->relaxation : most;
}

/* The stiffness k that the calibrated law's relaxation amounts to in the bulk, m/s^2: particles
 * push with k C/2. */
static double effective_stiffness(const skv_fluid_def *f, double h, double dt, double response)
{
    return 2 * relaxation(f) * f->iterations * h / (SKV_SMOOTH_GAIN * dt * dt * response);
}

/* A pair at distance r in a shear flow of rate g
 * approaches with r g |sin cos|; the momentum that it passes on, summed over the disc with n0 =
 * (eta/h)^2 particles per area and half of the directions approaching, makes the viscosity
 * nu = pi/640 sigma eta^2 h^2. What is far below the method's own is left out, for it costs a pass.
 */
double skv_linear_viscosity(const skv_fluid_def *f)
{
    double eta = (double)f->radius_ratio, h = (double)f->spacing * eta;
    double sigma = (double)f->viscosity_linear;
    if ((double)f->viscosity >= LEAST_VISCOSITY)
        sigma += SKV_VISCOUS / SKV_PI * (double)f->viscosity / (eta * eta * h * h);
    return sigma;
}

/* A shear by g lengthens a pair by g r sin cos. The energy of springs m k q/2, summed over the disc
 * with n0 = (eta/h)^2 particles per area and half of the pairs, makes the modulus G = pi/320 rho k
 * eta^2 h^2. This is k. */
static double spring_of_modulus(const skv_fluid_def *f, double modulus, double density)
{
    double eta = (double)f->radius_ratio, h = (double)f->spacing * eta;
    return SKV_SPRINGS / SKV_PI * modulus / (density * eta * eta * h * h);
}

static double most_spring(const skv_fluid_def *f)
{
    return MOST_SPRING / (double)(f->radius_ratio * f->radius_ratio);
}

double skv_spring_stiffness(const skv_fluid_def *f, double modulus, double density, double dt)
{
    double stiffness = spring_of_modulus(f, modulus, density) * dt * dt, most = most_spring(f);
    return stiffness < most ? stiffness : most;
}

static int whole_substeps(double substeps)
{
    if (!(substeps < MOST_SUBSTEPS))
        return MOST_SUBSTEPS; /* also of what is no number */
    int whole = (int)ceil(substeps - 1e-9);
    return whole < 1 ? 1 : whole;
}

int skv_spring_rule(const skv_fluid_def *f, double modulus, double density)
{
    return whole_substeps(FRAME * sqrt(spring_of_modulus(f, modulus, density) / most_spring(f)));
}

int skv_substep_rule(const skv_fluid_def *f, double load)
{
    double h = (double)f->spacing * (double)f->radius_ratio;
    double substeps;
    if (f->law == SKV_LAW_CLAVET) {
        substeps = FRAME / h * sqrt(load / CLAVET_LOAD);
    } else {
        substeps = FRAME / (SPEED_OF_SOUND * h) * sqrt(load / COMPRESSION);
        /* Cohesion needs a stiffer pressure to hold it, or small groups gain energy by it. */
        skv_lattice lattice = skv_lattice_sums(SKV_KERNEL_SMOOTH, (double)f->radius_ratio);
        double at_one = effective_stiffness(f, h, FRAME, lattice.response);
        double needed = sqrt(COHESION_MARGIN * COHESION_PULL * (double)f->cohesion / at_one);
        if (substeps < needed)
            substeps = needed;
    }
    /* Of linear viscosity nothing is lost to the solvers' bound. */
    double viscous = skv_linear_viscosity(f) * FRAME / (double)SKV_MOST_VISCOUS;
    if (substeps < viscous)
        substeps = viscous;
    return whole_substeps(substeps);
}

/* Whether a fluid has the margin that warm starts need. Of the liveliest waves an iteration takes
 * 1.5 by default; more, or a single iteration, throws the fluid apart in an impact. */
static bool may_start_warm(const skv_fluid_def *f)
{
    double liveliest = (double)f->relaxation * (double)f->radius_ratio * (double)f->radius_ratio;
    return f->law == SKV_LAW_CALIBRATED && f->iterations > 1 && liveliest <= WARM_LIVELY;
}

int skv_warm_substeps(const skv_fluid_def *f, int cold)
{
    if (!may_start_warm(f))
        return cold;
    /* Cohesion finds fluid that is not compressed, and so is as soft as if it started cold. */
    int least = skv_substep_rule(f, 0), warm = (int)ceil(WARM_SUBSTEPS * cold);
    return warm > least ? warm : least < cold ? least : cold;
}

void skv_set_stiffness(skv_constants *c, float cold)
{
    float square = cold * cold;
    if (c->clavet)
        return;
    if (square <= 1)
        c->lambda_scale *= square;
    else
        c->warm_start = 1 - 1 / square;
    /* What the pressure pushes in a substep at the expected depth. */
    float deep = (float)COMPRESSION * (float)c->iterations * c->lambda_scale * c->rest_density /
                 c->response_floor / (1 - c->warm_start);
    c->warm_limit = (float)WARM_REACH * deep;
    c->tension_until = (float)TENSION_UNTIL * deep;
}

double skv_speed_of_sound(const skv_fluid_def *f, double dt)
{
    double h = (double)f->spacing * (double)f->radius_ratio;
    return f->law == SKV_LAW_CLAVET ? 0 : SPEED_OF_SOUND * h / dt;
}

double skv_surface_gradient(const skv_fluid_def *f)
{
    double eta = (double)f->radius_ratio;
    return eta * eta / skv_kernel_flat(skv_law_kernel(f->law));
}

/* What the clavet law's fluid pushes with at rest, in a lattice that takes so many times its area
 * at the start; of any size. */
static double clavet_push(const skv_fluid_def *f, double area)
{
    skv_lattice l = skv_lattice_sums(SKV_KERNEL_SPIKY, (double)f->radius_ratio / sqrt(area));
    double excess = l.density - (double)f->clavet_rest_density;
    return (double)f->clavet_stiffness * excess * l.virial +
           (double)f->clavet_near_stiffness * l.near_density * l.near_virial;
}

int skv_clavet_swells(const skv_fluid_def *f)
{
    if (f->law != SKV_LAW_CLAVET)
        return 0;
    return clavet_push(f, SKV_CLAVET_WIDEST) > 0         ? 1
           : !(clavet_push(f, SKV_CLAVET_NARROWEST) > 0) ? -1
                                                         : 0;
}

/* A share that is meant for one frame, for a time dt instead. */
static double share_for(double share_a_frame, double dt)
{
    return 1 - skv_pow(1 - share_a_frame, dt / FRAME);
}

/* Walls by images have no friction in contact, which nothing comes to. What holds a viscous fluid
 * is its viscosity, in full at the default friction: half of the directions approach a wall that
 * rests, and half of a pair's impulse is its. */
static void set_images(skv_constants *c, const skv_fluid_def *f, double eta, double dt)
{
    double viscosity = skv_linear_viscosity(f), friction = (double)f->wall_friction;
    double sticks = friction < STICKS ? friction / STICKS : 1;
    c->images = true;
    c->image_gradient = (float)(SKV_PI / SKV_SMOOTH_WHOLE * eta * eta / SKV_SMOOTH_GAIN);
    c->image_virial = (float)(2 * SKV_PI / SKV_SMOOTH_VIRIAL * eta * eta);
    c->image_near_virial = (float)(2 * SKV_PI / SKV_NEAR_VIRIAL * eta * eta);
    /* In a corner D is near 0 and nearly even, so images do not hold a particle off its walls, and
     * those around push it in. The rest of the solid holds it off if it is a crowd; that of the
     * lattice is none. Of 1.6 to 2.7 all do much the same. */
    c->residual_share = (float)RESIDUAL_CROWD * c->near_share;
    c->adhesion = f->adhesion;
    c->friction = 0;
    c->wall_drag = (float)(sticks * viscosity * dt * eta * eta / 4);
    c->bare_slip = (float)share_for(SLIP_FRICTION * friction, dt);
    c->slip_friction = viscosity > 0 ? 0 : c->bare_slip;
    c->wall_stick = (float)(sticks * eta * eta / 4);
}

static void set_calibrated(skv_constants *c, const skv_fluid_def *f, double h, double eta,
                           double dt)
{
    skv_lattice lattice = skv_lattice_sums(SKV_KERNEL_SMOOTH, eta);
    double rest = lattice.density, cohesion = (double)f->cohesion;
    /* A displacement in each iteration that amounts to half an acceleration of 1 in the bulk. */
    double half = dt * dt * lattice.response / (2 * f->iterations);
    c->pair_lag = PAIR_LAG;
    c->lag_rise = (float)(dt * dt / (LAG_FROM * LAG_FROM * h * h));
    c->rest_density = (float)rest;
    c->warm_most = WARM_MOST;
    c->lambda_scale = (float)(relaxation(f) * h / SKV_SMOOTH_GAIN);
    c->response_slope = (float)(lattice.response / rest);
    c->response_floor = (float)lattice.response;
    c->near_lambda_scale = (float)(half * (double)f->near_stiffness);
    c->near_share = (float)(lattice.near_density / rest);
    c->cohesion_scale = (float)(half * COHESION_PULL * cohesion);
    c->cohesion_below = (float)(COHESION_BELOW * rest);
    c->cohesion_from = (float)(COHESION_FROM * rest);
    c->cohesion_slope = (float)(1 / ((COHESION_FULL - COHESION_FROM) * rest));
    c->tension_scale = (float)(dt * dt * COHESION_TENSION * cohesion);
    c->tension_from = (float)(TENSION_FROM * (eta * eta / skv_kernel_flat(SKV_KERNEL_SMOOTH)));
    c->wall_virial = 2.0f / SKV_SMOOTH_GAIN;
    c->loose_lambda = (float)h;
    skv_set_stiffness(c, 1);
    if (skv_has_images(f))
        set_images(c, f, eta, dt);
}

static void set_clavet(skv_constants *c, const skv_fluid_def *f, double h)
{
    /* k has the unit m/s^2 and is given in h/dt^2, so dt^2 k/2 is a length in h. */
    c->rest_density = f->clavet_rest_density;
    c->lambda_scale = (float)(0.5 * (double)f->clavet_stiffness * h);
    c->near_lambda_scale = (float)(0.5 * (double)f->clavet_near_stiffness * h);
    c->lambda_limit = (float)(CLAVET_LIMIT * h);
    c->wall_virial = 2.0f / SKV_SPIKY_GAIN;
    skv_lattice lattice = skv_lattice_sums(SKV_KERNEL_SPIKY, (double)f->radius_ratio);
    c->loose_lambda =
        c->lambda_scale * (float)(CLAVET_LOOSE * lattice.density - (double)f->clavet_rest_density);
}

skv_constants skv_make_constants(const skv_fluid_def *f, float compression, float dt_float)
{
    double dt = (double)dt_float, h = (double)f->spacing * (double)f->radius_ratio;
    double eta = (double)f->radius_ratio / sqrt(1 + (double)compression);
    skv_constants c = {
        .h = (float)h,
        .inv_h = (float)(1 / h),
        .dt = dt_float,
        .max_speed = (float)(MAX_COURANT * h / dt),
        .viscosity_linear = (float)skv_linear_viscosity(f),
        .viscosity_quadratic = f->viscosity_quadratic,
        .clavet = f->law == SKV_LAW_CLAVET,
        .iterations = f->iterations,
        .turn_reach = TURN_REACH / f->radius_ratio,
        .kernel = skv_law_kernel(f->law),
        .softness = (float)share_for((double)f->wall_softness, dt),
        .friction = (float)share_for((double)f->wall_friction, dt),
    };
    if (f->law == SKV_LAW_CLAVET)
        set_clavet(&c, f, h);
    else
        set_calibrated(&c, f, h, eta, dt);
    double load =
        f->law == SKV_LAW_CLAVET ? CLAVET_LOAD : COMPRESSION * SPEED_OF_SOUND * SPEED_OF_SOUND;
    c.design_pressure = (float)((double)f->density * load * h * h / (dt * dt));
    /* Virial pressure in the plane: sum of r f over a particle's pairs / (4 s^2), where f is a mass
     * density s^2 times a displacement over dt^2. */
    c.pressure_scale = (float)((double)f->density / (4 * dt * dt));
    return c;
}
