/* Writes the CSV tables.
 *
 * Invariant: nine significant digits, so a float32 read back has the bits that were simulated.
 */
#include "output_table.h"

#include <inttypes.h>
#include <string.h>

void trace_head(output_file *file)
{
    fputs("t,id,x,y,vx,vy,pressure,fluid\n", file->stream);
}

void trace_rows(output_file *file, const skv_world *world, double time)
{
    skv_particles all = skv_world_particles(world);
    for (int i = 0; i < all.count; i++) {
        fprintf(file->stream, "%.9g,%" PRIu32 ",%.9g,%.9g,%.9g,%.9g,%.9g,%d\n", time, all.id[i],
                (double)all.x[i], (double)all.y[i], (double)all.vx[i], (double)all.vy[i],
                (double)all.pressure[i], all.fluid ? all.fluid[i] : 0);
    }
}

/* Whether there is more to tell of each than of all. */
static bool has_several(const skv_world *world)
{
    return skv_world_liquid(world, 1) != NULL;
}

const char *body_name(const skv_scene *scene, skv_body_id id, char number[32])
{
    const char *name = scene ? skv_scene_body_name(scene, (int)id - 1) : NULL;
    snprintf(number, 32, "body %u", (unsigned)id);
    return name ? name : number;
}

/* The head of a column of a fluid or a body: in quotes, with those of its name doubled, if a reader
 * of tables would else take the name for more than one. */
static void named_head(output_file *file, const char *name, const char *column)
{
    const char *quote = strpbrk(name, ",\"") ? "\"" : "";
    fprintf(file->stream, ",%s", quote);
    for (; *name; name++)
        fprintf(file->stream, *name == '"' ? "\"%c" : "%c", *name);
    fprintf(file->stream, ".%s%s", column, quote);
}

void series_head(output_file *file, const skv_world *world, const skv_scene *scene,
                 series_bodies *bodies)
{
    static const char *const columns[] = {"particles", "kinetic_energy", "centre_x", "centre_y"};
    static const char *const of_bodies[] = {"x", "y", "angle", "vx", "vy", "spin"};
    fputs("t,particles,kinetic_energy,potential_energy,momentum_x,momentum_y,rms_speed,max_speed,"
          "volume_ratio,centre_x,centre_y",
          file->stream);
    const skv_liquid *liquid;
    for (int i = 0; has_several(world) && (liquid = skv_world_liquid(world, i)); i++)
        for (size_t k = 0; k < sizeof columns / sizeof *columns; k++)
            named_head(file, liquid->name, columns[k]);
    skv_body body;
    for (bodies->count = 0; skv_world_body_at(world, bodies->count, &body); bodies->count++) {
        char number[32];
        const char *name = body_name(scene, body.id, number);
        bodies->id[bodies->count] = body.id;
        for (size_t k = 0; k < sizeof of_bodies / sizeof *of_bodies; k++)
            named_head(file, name, of_bodies[k]);
    }
    fputc('\n', file->stream);
}

void series_row(output_file *file, const skv_world *world, const series_bodies *bodies,
                const skv_packing *packing, double time)
{
    skv_stats all = skv_world_stats(world);
    fprintf(file->stream, "%.9g,%d,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g", time,
            all.particles, all.kinetic_energy, all.potential_energy, all.momentum_x, all.momentum_y,
            all.rms_speed, all.max_speed, packing->volume_ratio, all.centre_x, all.centre_y);
    for (int i = 0; has_several(world) && skv_world_liquid(world, i); i++) {
        skv_stats one = skv_world_fluid_stats(world, i);
        fprintf(file->stream, ",%d,%.9g", one.particles, one.kinetic_energy);
        if (one.particles > one.not_finite)
            fprintf(file->stream, ",%.9g,%.9g", one.centre_x, one.centre_y);
        else
            fputs(",,", file->stream);
    }
    for (int i = 0; i < bodies->count; i++) {
        skv_body body;
        if (skv_world_body(world, bodies->id[i], &body))
            fprintf(file->stream, ",%.9g,%.9g,%.9g,%.9g,%.9g,%.9g", (double)body.x, (double)body.y,
                    (double)body.angle, (double)body.vx, (double)body.vy, (double)body.spin);
        else
            fputs(",,,,,,", file->stream);
    }
    fputc('\n', file->stream);
}
