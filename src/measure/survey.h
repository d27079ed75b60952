/* The survey's inside, for the instruments that look at single particles. */
#ifndef SKV_MEASURE_SURVEY_H
#define SKV_MEASURE_SURVEY_H

#include "skvalp/measure.h"

enum { SOLID_TABLE = 64, MAX_SURVEY_CELLS = 1 << 22 };

struct skv_survey {
    skv_terrain *terrain; /* of the world that was looked at, shared */
    double time;          /* of the world, s */
    double h, spacing, density;
    double gravity_x, gravity_y;

    int count, capacity;
    float *x, *y, *vx, *vy, *pressure; /* sorted by cell */
    float *mass;            /* sorted alike: over that of the first fluid's, whose is `density` */
    bool mixed;             /* some are not 1 */
    float *from_x, *from_y; /* sorted alike: where the look before saw them; NaN: it did not */
    double travel;          /* longest way since the look before, m */
    int *cell_start;        /* columns*rows + 1 */
    int cell_capacity;
    int columns, rows;
    double cell; /* side, m */

    /* In creation order: this look's ids and positions, and those of the one before. */
    uint32_t *id, *id_before;
    float *now_x, *now_y, *before_x, *before_y;
    int count_before;
    double time_before; /* negative: there was none, or its world was another one */

    double solid_share[SOLID_TABLE + 1]; /* of the kernel beyond a flat wall at i/SOLID_TABLE h */
};

/* As skv_survey_take and skv_lab_sample; with other pressures, by particle, unless they are null.
 */
skv_result skv_survey_take_with(skv_survey *survey, const skv_world *world, const float *pressure,
                                skv_error *error);
skv_result skv_lab_sample_with(skv_lab *lab, const skv_world *world, const float *pressure,
                               skv_error *error);

/* The next look is the first one. */
void skv_survey_forget(skv_survey *survey);

/* The cells that a box touches, clamped to the grid. */
typedef struct cell_range {
    int column0, column1, row0, row1; /* inclusive */
} cell_range;
cell_range skv_survey_cells(const skv_survey *survey, double x0, double y0, double x1, double y1);

/* Share of the kernel around (x, y) that lies in solid, by the distance to the nearest wall: exact
 * for flat walls; 1 inside solid. */
double skv_survey_solid(const skv_survey *survey, double x, double y);

/* Mean mass of the fluid around (x, y), over that of the first fluid's; 1 where there is none. */
double skv_survey_mean_mass(const skv_survey *survey, double x, double y);

/* Share of the free space around (x, y) that is fluid; 0 in solid. */
double skv_survey_fill(const skv_survey *survey, double x, double y);

#endif
