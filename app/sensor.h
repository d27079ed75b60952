/* The sensor: gravity follows how the device is held, and shaking it splashes. */
#ifndef SKVALP_PLAY_SENSOR_H
#define SKVALP_PLAY_SENSOR_H

#include "view.h"

G_BEGIN_DECLS

typedef struct PlaySensor PlaySensor;

/* Looks for one, under the folder that SKVALP_SENSORS names if it is set. It belongs to the view,
 * and is on if it was when it was last used. */
void play_sensor_attach(PlayView *view);

/* A view's; null if this device has none. */
PlaySensor *play_sensor_of(PlayView *view);

/* Choices act at once and are remembered. */
gboolean play_sensor_is_on(const PlaySensor *sensor);
void play_sensor_set_on(PlaySensor *sensor, gboolean on);

/* Times what is felt, 0..2. */
double play_sensor_strength(const PlaySensor *sensor);
void play_sensor_set_strength(PlaySensor *sensor, double strength);

/* Which edge of the device is up on its screen: a skv_orientation. */
int play_sensor_up(PlaySensor *sensor);
void play_sensor_set_up(PlaySensor *sensor, int up);

G_END_DECLS

#endif
