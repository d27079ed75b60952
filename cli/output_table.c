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

/* The head of a fluid's column: in quotes, with those of its name doubled, if a reader of tables
 * would else take the name for more than one. */
static void fluid_head(output_file *file, const char *name, const char *column)
{
    const char *quote = strpbrk(name, ",\"") ? "\"" : "";
    fprintf(file->stream, ",%s", quote);
    for (; *name; name++)
        fprintf(file->stream, *name == '"' ? "\"%c" : "%c", *name);
    fprintf(file->stream, ".%s%s", column, quote);
}

void series_head(output_file *file, const skv_world *world)
{
    static const char *const columns[] = {"particles", "kinetic_energy", "centre_x", "centre_y"};
    fputs("t,particles,kinetic_energy,potential_energy,momentum_x,momentum_y,rms_speed,max_speed,"
          "volume_ratio,centre_x,centre_y",
          file->stream);
    const skv_liquid *liquid;
    for (int i = 0; has_several(world) && (liquid = skv_world_liquid(world, i)); i++)
        for (size_t k = 0; k < sizeof columns / sizeof *columns; k++)
            fluid_head(file, liquid->name, columns[k]);
    fputc('\n', file->stream);
}

void series_row(output_file *file, const skv_world *world, const skv_packing *packing, double time)
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
    fputc('\n', file->stream);
}
