/* Writes the CSV tables.
 *
 * Invariant: nine significant digits, so a float32 read back has the bits that were simulated.
 */
#include "output_table.h"

#include <inttypes.h>

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

void series_head(output_file *file)
{
    fputs("t,particles,kinetic_energy,potential_energy,momentum_x,momentum_y,rms_speed,max_speed,"
          "volume_ratio,centre_x,centre_y\n",
          file->stream);
}

void series_row(output_file *file, const skv_stats *stats, const skv_packing *packing, double time)
{
    fprintf(file->stream, "%.9g,%d,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g\n", time,
            stats->particles, stats->kinetic_energy, stats->potential_energy, stats->momentum_x,
            stats->momentum_y, stats->rms_speed, stats->max_speed, packing->volume_ratio,
            stats->centre_x, stats->centre_y);
}
