/* Double density relaxation (Algorithm 6 with errata 6 and 6+9), and the calibrated law's surface
 * tension.
 *
 * Invariant: the density reads positions, the displacement reads positions and the P and N of both
 * partners; neither writes what it reads of others. A pair's two displacements are the same
 * expression with the unit vector reversed, so they are opposite.
 */
#include "solver/reference/pair.h"
#include "solver/reference/reference.h"

#include <math.h>

/* Sums over a particle's surroundings. */
typedef struct surroundings {
    double density, near_density;
    double lightness; /* sum of q^3 over mass */
    double gx, gy;    /* sum of F r^ */
} surroundings;

static surroundings look_around(const skv_reference *f, int i)
{
    const skv_kernel kernel = f->constants->kernel;
    surroundings sums = {0};
    for (int k = skv_first_partner(f, i); k < skv_end_of_partners(f, i); k++) {
        int j = skv_partner(f, k);
        skv_pair pair;
        if (!skv_pair_of(f, i, j, &pair))
            continue;
        double q = pair.q, image = skv_image_of(f, i, j, q);
        double force = skv_kernel_force(kernel, q), ahead = skv_density_ahead(f, i, j, &pair);
        sums.density += skv_kernel_density(kernel, q) + skv_kernel_density(kernel, image) +
                        (q * q + image * image) * ahead;
        sums.near_density += q * q * q + image * image * image;
        sums.lightness += (q * q * q + image * image * image) / f->mass[j];
        sums.gx += force * pair.ux;
        sums.gy += force * pair.uy;
    }
    return sums;
}

/* What fluid gains in a substep that rests where pairs of i are taken. */
static void find_fall(const skv_reference *f, int i, double *gx, double *gy)
{
    const double dt = (double)f->constants->dt;
    *gx = *gy = 0;
    skv_apply_forces(f, f->x[i] - f->behind_x[i], f->y[i] - f->behind_y[i], gx, gy);
    *gx += dt * f->gravity_x;
    *gy += dt * f->gravity_y;
}

/* How much of a wall's pull i is let fall from: all of it where it hangs, none where it rests below
 * a surface, or water would be driven along walls that lean over it. It hangs if what its gradient
 * exceeds the bulk's unevenness by points against what has it fall; from twice that unevenness on
 * wholly. Rises smoothly, so rounding decides nothing. */
static double find_hanging(const skv_reference *f, int i)
{
    double gx, gy;
    find_fall(f, i, &gx, &gy);
    double down = f->gradient_x[i] * gx + f->gradient_y[i] * gy;
    if (!(down < 0))
        return 0;
    return skv_min(-down / (sqrt(gx * gx + gy * gy) * (double)f->constants->tension_from), 1);
}

/* Of a particle's fluid, over the constants'. What is a surface's energy is its own fluid's, so
 * unlike particles draw each other as much as the mean of what both do among their like. */
static double cohesion_of(const skv_reference *f, int i)
{
    return f->cohesion ? (double)f->cohesion[f->fluid[i]] : 1;
}

/* Keeps of the gradient, for the tension, what exceeds the unevenness of the bulk. Only loose fluid
 * has a surface that matters: what was pressed in the last substep fades. */
static void keep_gradient(skv_reference *f, int i, double gx, double gy)
{
    const skv_constants *c = f->constants;
    double flat = (double)c->image_gradient * (double)skv_flat_slope((float)f->image[i]);
    gx -= f->f1x[i] + flat * f->facing_x[i];
    gy -= f->f1y[i] + flat * f->facing_y[i];
    double size = sqrt(gx * gx + gy * gy), bulk = (double)c->tension_from;
    double share = size > bulk ? (size - bulk) / size : 0;
    share *= skv_max(1 - f->warm_lambda[i] / (f->mass[i] * (double)c->tension_until), 0);
    f->gradient_x[i] = share * gx;
    f->gradient_y[i] = share * gy;
    if (c->images)
        f->hanging[i] = find_hanging(f, i);
    f->gradient_x[i] *= f->mean_mass[i] * cohesion_of(f, i);
    f->gradient_y[i] *= f->mean_mass[i] * cohesion_of(f, i);
}

/* From q^3 over mass, summed up over the neighbours, and q of the own image. */
static void find_mean_mass(skv_reference *f, int i, double lightness, double own)
{
    const double weight = (double)SKV_OWN_WEIGHT, mass = f->mass[i];
    lightness = lightness + f->wall_near[i] / mass + own * own * own / mass + weight / mass;
    f->mean_mass[i] = (f->near_density[i] + weight) / lightness;
}

void skv_pass_density(skv_reference *f)
{
    const skv_constants *c = f->constants;
    for (int i = 0; i < f->count; i++) {
        surroundings sums = look_around(f, i);
        double own = skv_own_image_of(f, i);
        f->density[i] = sums.density + f->wall_density[i] + skv_kernel_density(c->kernel, own);
        f->near_density[i] = sums.near_density + f->wall_near[i] + own * own * own;
        find_mean_mass(f, i, sums.lightness, own);
        if (f->first && !c->clavet)
            keep_gradient(f, i, sums.gx, sums.gy);
    }
}

/* The pressure term's P, which is remembered. The warm start: where the density is too high anyway,
 * a share of the last substep's push comes first. What is left to find is less, and so is the
 * density that finds it. */
static double press(skv_reference *f, int i, double response)
{
    const skv_constants *c = f->constants;
    double excess = skv_max(f->density[i] - (double)c->rest_density, 0);
    double lambda = f->mean_mass[i] * (double)c->lambda_scale * excess / response;
    double before = f->warm_lambda[i];
    if (f->first) {
        double start = (double)c->warm_start * skv_min(before, f->mass[i] * (double)c->warm_limit);
        lambda += skv_min(start, (double)c->warm_most * lambda);
        before = 0;
    }
    f->warm_lambda[i] = before + lambda;
    return lambda;
}

/* A relaxation step of the constraint that the density is at most that at rest; cohesion, and near
 * pressure, which both vanish in the lattice at rest. All of it is of the mean mass, or what is
 * light among heavy ones would fly off. */
static void find_calibrated(skv_reference *f, int i)
{
    const skv_constants *c = f->constants;
    double density = f->density[i], share = (double)c->near_share;
    double missing = skv_max((double)c->cohesion_below - density, 0);
    /* Few neighbours do not draw together: no number of them could make up the density. */
    double held = (density - (double)c->cohesion_from) * (double)c->cohesion_slope;
    held = skv_min(skv_max(held, 0), 1);
    double pull = (double)c->cohesion_scale * cohesion_of(f, i) * held * missing;
    double crowd = (double)c->near_lambda_scale * skv_max(f->near_density[i] - share * density, 0);
    /* Its floor, the value in the bulk at rest, tames small groups, whose density hardly answers.
     */
    double response = skv_max((double)c->response_slope * density, (double)c->response_floor);
    double pressed = press(f, i, response), mass = f->mean_mass[i];
    f->lambda[i] = pressed - mass * ((pull + SKV_NEAR_WEIGHT * share * crowd) / response);
    f->near_lambda[i] = mass * (crowd / response);
}

/* The thesis' law, made symmetric. Its limiter: a Jacobi iteration overshoots where many strong
 * pairs meet. Scaling P and N of one particle keeps pairs opposite; capping N alone was tried and
 * failed. */
static void find_clavet(skv_reference *f, int i)
{
    const skv_constants *c = f->constants;
    double lambda = (double)c->lambda_scale * (f->density[i] - (double)c->rest_density);
    double near_lambda = (double)c->near_lambda_scale * f->near_density[i];
    double strength = f->density[i] * near_lambda, limit = (double)c->lambda_limit;
    double scale = f->mean_mass[i] * (strength > limit ? limit / strength : 1);
    f->lambda[i] = scale * lambda;
    f->near_lambda[i] = scale * near_lambda;
}

void skv_pass_pressure(skv_reference *f)
{
    for (int i = 0; i < f->count; i++) {
        if (f->constants->clavet)
            find_clavet(f, i);
        else
            find_calibrated(f, i);
    }
}

/* Adds a virial, the sum of distance times displacement in units of h times m, to the gauge. */
static void gauge(skv_reference *f, int i, double virial)
{
    const skv_constants *c = f->constants;
    f->pressure[i] += (double)c->pressure_scale * (double)c->h * virial;
}

/* Takes from a wall's push, where it is a pull, a share of what would hold a particle up against
 * the direction in which external forces would have it fall, or drops would hang from ceilings for
 * ever. (nx, ny) points out of the wall. Leaving out all of the pull heats the fluid where its
 * surface meets a wall, since it has no energy then. */
static void let_fall(const skv_reference *f, int i, double nx, double ny, double share,
                     double *push_x, double *push_y)
{
    double gx, gy;
    find_fall(f, i, &gx, &gy);
    double down = *push_x * gx + *push_y * gy, square = gx * gx + gy * gy;
    if (!(*push_x * nx + *push_y * ny < 0 && down < 0))
        return;
    *push_x -= share * down / square * gx;
    *push_y -= share * down / square * gy;
}

/* The solid's part, P F1 + N F2: a wall pushes with the particle's own pressure, once; twice, as if
 * it were a mirrored fluid, heats the fluid. Where P is negative it pulls. */
static void add_solid(skv_reference *f, int i, double virial)
{
    const skv_constants *c = f->constants;
    double lambda = f->lambda[i], near_lambda = f->near_lambda[i];
    double push_x = lambda * f->f1x[i] + near_lambda * f->f2x[i];
    double push_y = lambda * f->f1y[i] + near_lambda * f->f2y[i];
    if (lambda < (double)c->loose_lambda * f->mass[i])
        let_fall(f, i, f->f1x[i], f->f1y[i], 1, &push_x, &push_y);
    f->dx[i] += push_x;
    f->dy[i] += push_y;
    skv_book_push(f, i, 0, lambda, near_lambda, push_x, push_y);
    /* The virial of a smooth solid, by parts in terms of h R and h Rn. */
    virial += (double)c->wall_virial * lambda * f->wall_density[i] +
              2.0 / SKV_NEAR_GAIN * near_lambda * f->wall_near[i];
    gauge(f, i, virial);
}

/* The same for a particle with an image. `out` is what those of its partners push it away from the
 * wall. */
static void add_imaged(skv_reference *f, int i, double out)
{
    const skv_constants *c = f->constants;
    double lambda = f->lambda[i], near_lambda = f->near_lambda[i], own = skv_own_image_of(f, i);
    out += 2 * (lambda * skv_kernel_force(c->kernel, own) + near_lambda * own * own);
    double push_x = lambda * f->f1x[i] + near_lambda * f->f2x[i] + out * f->facing_x[i];
    double push_y = lambda * f->f1y[i] + near_lambda * f->f2y[i] + out * f->facing_y[i];
    double share = (1 - (double)c->adhesion) * f->hanging[i];
    let_fall(f, i, f->facing_x[i], f->facing_y[i], share, &push_x, &push_y);
    f->dx[i] += push_x;
    f->dy[i] += push_y;
    skv_book_push(f, i, out, lambda, near_lambda, push_x, push_y);
    /* Fluid and images are one body, so it is that of the bulk, and goes with how dense the last
     * iteration finds it, its own W included. */
    gauge(f, i, (double)c->image_virial * lambda + (double)c->image_near_virial * near_lambda);
    double rest = (double)c->rest_density, density = f->density[i];
    density = skv_max(skv_min(density, (double)SKV_DENSEST * rest), rest);
    if (f->last)
        f->pressure[i] *= (density + 1) / (rest + 1);
}

void skv_pass_displacement(skv_reference *f)
{
    const skv_kernel kernel = f->constants->kernel;
    for (int i = 0; i < f->count; i++) {
        double virial = 0, out = 0;
        f->dx[i] = f->dy[i] = 0;
        for (int k = skv_first_partner(f, i); k < skv_end_of_partners(f, i); k++) {
            int j = skv_partner(f, k);
            skv_pair pair;
            if (!skv_pair_of(f, i, j, &pair))
                continue;
            double q = pair.q, image = skv_image_of(f, i, j, q);
            double lambda = f->lambda[i] + f->lambda[j];
            double near_lambda = f->near_lambda[i] + f->near_lambda[j];
            double size = lambda * skv_kernel_force(kernel, q) + near_lambda * q * q;
            virial += (1 - q) * size;
            if (image > 0) {
                /* For each h of way to the image. */
                double each = lambda * image * image + near_lambda * image * image / (1 - image);
                size += (1 - q) * each;
                out += 2 * f->image[j] * each;
            }
            f->dx[i] -= size * pair.ux;
            f->dy[i] -= size * pair.uy;
        }
        if (skv_has_image(f, i))
            add_imaged(f, i, out);
        else
            add_solid(f, i, virial);
    }
}

void skv_pass_tension(skv_reference *f)
{
    const double scale = (double)f->constants->tension_scale;
    for (int i = 0; i < f->count; i++) {
        double sum_x = 0, sum_y = 0, virial = 0;
        for (int k = skv_first_partner(f, i); k < skv_end_of_partners(f, i); k++) {
            int j = skv_partner(f, k);
            skv_pair pair;
            if (!skv_pair_of(f, i, j, &pair))
                continue;
            /* The slope of F r^ = (r/h) q^2 r^: q^2 across the pair, q^2 - 2q r/h along it. */
            double ex = f->gradient_x[i] - f->gradient_x[j];
            double ey = f->gradient_y[i] - f->gradient_y[j];
            double q_squared = pair.q * pair.q, r = 1 - pair.q;
            double along = ex * pair.ux + ey * pair.uy, turned = 2 * pair.q * r * along;
            sum_x += q_squared * ex - turned * pair.ux;
            sum_y += q_squared * ey - turned * pair.uy;
            virial += r * (turned - q_squared * along);
        }
        f->dx[i] += scale * sum_x;
        f->dy[i] += scale * sum_y;
        skv_book_turn(f, i);
        if (!skv_has_image(f, i))
            gauge(f, i, scale * virial);
    }
}

void skv_pass_divide(skv_reference *f)
{
    for (int i = 0; i < f->count; i++) {
        f->dx[i] /= f->mass[i];
        f->dy[i] /= f->mass[i];
    }
}
