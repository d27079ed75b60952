/* Double density relaxation as gather passes (Algorithm 6 with errata 6 and 6+9), and the
 * calibrated law's surface tension.
 *
 * Invariant: pass A (density) reads positions, pass B (displacement) reads positions and the P and
 * N of both partners; neither writes what it reads of others. A pair's two displacements are the
 * same expression with the unit vector reversed, so they are exactly opposite.
 */
#include "solver/reference/pair.h"
#include "solver/reference/passes.h"
#include "solver/wall_image.h"
#include "solver/wall_push.h"

#include <math.h>
#include <stddef.h>

void skv_pass_density(const skv_substep *sub, int begin, int end)
{
    const skv_pass_data *s = &sub->data;
    const skv_constants *c = sub->constants;
    const skv_neighbours *n = sub->neighbours;
    for (int i = begin; i < end; i++) {
        float density = 0, near_density = 0, gx = 0, gy = 0;
        for (int k = n->start[i]; k < n->start[i + 1]; k++) {
            skv_pair pair;
            if (!skv_pair_of(s, c, i, n->list[k], &pair))
                continue;
            float force = skv_kernel_forcef(c->kernel, pair.q);
            float image = skv_image_of(s, c, i, n->list[k], pair.q);
            float ahead = skv_density_ahead(s, c, i, n->list[k], &pair);
            density +=
                skv_kernel_densityf(c->kernel, pair.q) + skv_kernel_densityf(c->kernel, image);
            density += (pair.q * pair.q + image * image) * ahead;
            near_density += pair.q * pair.q * pair.q + image * image * image;
            gx += force * pair.ux;
            gy += force * pair.uy;
        }
        float own = skv_own_image_of(s, c, i);
        s->density[i] = density + (s->wall_density[i] + skv_kernel_densityf(c->kernel, own));
        s->near_density[i] = near_density + (s->wall_near[i] + own * own * own);
        if (sub->first && !c->clavet) {
            float flat = c->image_gradient * skv_flat_slope(s->image[i]);
            gx -= s->f1x[i] + flat * s->facing_x[i];
            gy -= s->f1y[i] + flat * s->facing_y[i];
            float size = sqrtf(gx * gx + gy * gy);
            float share = size > c->tension_from ? (size - c->tension_from) / size : 0;
            /* Only loose fluid has a surface that matters: what was pressed fades. */
            float pressed = c->dt * c->dt * s->warm_lambda[i] / c->tension_until;
            share *= pressed < 1 ? 1 - pressed : 0;
            s->gradient_x[i] = share * gx;
            s->gradient_y[i] = share * gy;
        }
    }
}

void skv_pass_pressure_calibrated(const skv_substep *sub, int begin, int end)
{
    const skv_pass_data *s = &sub->data;
    const skv_constants *c = sub->constants;
    float square = c->dt * c->dt;
    for (int i = begin; i < end; i++) {
        float density = s->density[i];
        float excess = density - c->rest_density;
        float crowded = s->near_density[i] - c->near_share * density;
        float missing = c->cohesion_below - density;
        /* Few neighbours do not draw together: no number of them could make up the density. */
        float held = (density - c->cohesion_from) * c->cohesion_slope;
        held = held < 0 ? 0 : held < 1 ? held : 1;
        float pull = c->cohesion_scale * (held * (missing > 0 ? missing : 0));
        float near_lambda = c->near_lambda_scale * (crowded > 0 ? crowded : 0);
        /* Its floor, the value in the bulk at rest, tames small groups, whose density hardly
         * answers. */
        float response = c->response_slope * density;
        if (!(response > c->response_floor))
            response = c->response_floor;
        float lambda = c->lambda_scale * (excess > 0 ? excess : 0) / response;
        /* The warm start: where the density is too high anyway, a share of the last substep's push
         * comes first. What is left to find is less, and so is the density that finds it. */
        float before = s->warm_lambda[i];
        if (sub->first) {
            float last = square * before, most = c->warm_most * lambda;
            last = last < c->warm_limit ? last : c->warm_limit;
            float start = c->warm_start * last;
            lambda += start < most ? start : most;
            before = 0;
        }
        s->warm_lambda[i] = before + lambda / square;
        s->lambda[i] = lambda - (pull + SKV_NEAR_WEIGHT * c->near_share * near_lambda) / response;
        s->near_lambda[i] = near_lambda / response;
    }
}

void skv_pass_pressure_clavet(const skv_substep *sub, int begin, int end)
{
    const skv_pass_data *s = &sub->data;
    const skv_constants *c = sub->constants;
    for (int i = begin; i < end; i++) {
        float lambda = c->lambda_scale * (s->density[i] - c->rest_density);
        float near_lambda = c->near_lambda_scale * s->near_density[i];
        /* The limiter: a Jacobi iteration overshoots where many strong pairs meet. Scaling P and N
         * of one particle keeps pairs antisymmetric; capping N alone was tried and failed. */
        float strength = s->density[i] * near_lambda;
        float scale = strength > c->lambda_limit ? c->lambda_limit / strength : 1;
        s->lambda[i] = scale * lambda;
        s->near_lambda[i] = scale * near_lambda;
    }
}

/* The velocity that external forces give in a substep to fluid that rests where a particle is. */
static void find_fall(const skv_substep *sub, int i, float *gx, float *gy)
{
    const skv_pass_data *s = &sub->data;
    float vx = 0, vy = 0;
    skv_apply_external_forces(sub->forces, sub->force_count, s->x[i], s->y[i], &vx, &vy);
    *gx = sub->constants->dt * sub->gravity_x + vx;
    *gy = sub->constants->dt * sub->gravity_y + vy;
}

/* The walls' part of a displacement, and the gauge pressure. */
static void add_solid(const skv_substep *sub, int i, float virial)
{
    const skv_pass_data *s = &sub->data;
    const skv_constants *c = sub->constants;
    float wall_x, wall_y, gx, gy;
    find_fall(sub, i, &gx, &gy);
    skv_wall_push(s->lambda[i], s->near_lambda[i], s->f1x[i], s->f1y[i], s->f2x[i], s->f2y[i], gx,
                  gy, c->loose_lambda, &wall_x, &wall_y);
    s->dx[i] += wall_x;
    s->dy[i] += wall_y;
    skv_book_reaction(sub, i, (double)wall_x, (double)wall_y);
    /* The virial of a smooth solid, by parts in terms of h R and h Rn. */
    virial += c->wall_virial * s->lambda[i] * s->wall_density[i] +
              2.0f / SKV_NEAR_GAIN * s->near_lambda[i] * s->wall_near[i];
    s->pressure[i] += c->pressure_scale * c->h * virial;
}

/* The same for a particle with images. `out` is what those of its partners push it away from the
 * wall. */
static void add_imaged(const skv_substep *sub, int i, float out)
{
    const skv_pass_data *s = &sub->data;
    const skv_constants *c = sub->constants;
    float lambda = s->lambda[i], near_lambda = s->near_lambda[i], own = skv_own_image_of(s, c, i);
    out += 2 * (lambda * skv_kernel_forcef(c->kernel, own) + near_lambda * (own * own));
    float wall_x = lambda * s->f1x[i] + near_lambda * s->f2x[i] + out * s->facing_x[i];
    float wall_y = lambda * s->f1y[i] + near_lambda * s->f2y[i] + out * s->facing_y[i];
    float gx, gy;
    find_fall(sub, i, &gx, &gy);
    skv_wall_let_fall(gx, gy, s->facing_x[i], s->facing_y[i], c->adhesion, &wall_x, &wall_y);
    s->dx[i] += wall_x;
    s->dy[i] += wall_y;
    skv_book_reaction(sub, i, (double)wall_x, (double)wall_y);
    /* Fluid and images are one body, so it is that of the bulk, and goes with how dense the last
     * iteration finds it, its own W included. */
    float virial = c->image_virial * lambda + c->image_near_virial * near_lambda;
    s->pressure[i] += c->pressure_scale * c->h * virial;
    if (sub->last) {
        float rest = c->rest_density, most = SKV_DENSEST * rest;
        float density = s->density[i] < most ? s->density[i] : most;
        s->pressure[i] *= density > rest ? (density + 1) / (rest + 1) : 1;
    }
}

void skv_pass_displacement(const skv_substep *sub, int begin, int end)
{
    const skv_pass_data *s = &sub->data;
    const skv_constants *c = sub->constants;
    const skv_neighbours *n = sub->neighbours;
    for (int i = begin; i < end; i++) {
        float sum_x = 0, sum_y = 0, virial = 0, out = 0;
        for (int k = n->start[i]; k < n->start[i + 1]; k++) {
            int j = n->list[k];
            skv_pair pair;
            if (!skv_pair_of(s, c, i, j, &pair))
                continue;
            float lambda = s->lambda[i] + s->lambda[j],
                  near_lambda = s->near_lambda[i] + s->near_lambda[j];
            float size =
                lambda * skv_kernel_forcef(c->kernel, pair.q) + near_lambda * (pair.q * pair.q);
            virial += (1 - pair.q) * size;
            float image = skv_image_of(s, c, i, j, pair.q);
            if (image > 0) {
                /* For each h of way to the image. */
                float each =
                    lambda * (image * image) + near_lambda * (image * (image / (1 - image)));
                size += (1 - pair.q) * each;
                out += 2 * s->image[j] * each;
            }
            sum_x -= size * pair.ux;
            sum_y -= size * pair.uy;
        }
        s->dx[i] = sum_x;
        s->dy[i] = sum_y;
        if (s->image[i] < 1)
            add_imaged(sub, i, out);
        else
            add_solid(sub, i, virial);
    }
}

void skv_pass_tension(const skv_substep *sub, int begin, int end)
{
    const skv_pass_data *s = &sub->data;
    const skv_constants *c = sub->constants;
    const skv_neighbours *n = sub->neighbours;
    for (int i = begin; i < end; i++) {
        float sum_x = 0, sum_y = 0, virial = 0;
        for (int k = n->start[i]; k < n->start[i + 1]; k++) {
            int j = n->list[k];
            skv_pair pair;
            if (!skv_pair_of(s, c, i, j, &pair))
                continue;
            /* The slope of F r^ = (r/h) q^2 r^: q^2 across the pair, q^2 - 2q r/h along it. */
            float ex = s->gradient_x[i] - s->gradient_x[j];
            float ey = s->gradient_y[i] - s->gradient_y[j];
            float q_squared = pair.q * pair.q, r = 1 - pair.q;
            float along = ex * pair.ux + ey * pair.uy, turned = 2 * pair.q * r * along;
            sum_x += q_squared * ex - turned * pair.ux;
            sum_y += q_squared * ey - turned * pair.uy;
            virial += r * (turned - q_squared * along);
        }
        s->dx[i] += c->tension_scale * sum_x;
        s->dy[i] += c->tension_scale * sum_y;
        if (s->image[i] >= 1)
            s->pressure[i] += c->pressure_scale * c->h * c->tension_scale * virial;
    }
}
