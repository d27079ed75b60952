/** @file
 * Tilt: what water in this device would feel, from its acceleration sensor: gravity, and how it is
 * shaken. On Linux the sensor is read here, from the files of the system's industrial I/O devices;
 * elsewhere the front end says what it reads (skv_tilt_feel).
 */
#ifndef SKVALP_TILT_H
#define SKVALP_TILT_H

#include "skvalp/base.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Which edge of the device is up as its screen shows it. */
typedef enum skv_orientation {
    SKV_ORIENTATION_TOP, /**< as it is built */
    SKV_ORIENTATION_LEFT,
    SKV_ORIENTATION_BOTTOM,
    SKV_ORIENTATION_RIGHT
} skv_orientation;

/** What was read, in the plane of the screen: x to its right, y up. The two parts together are all
 * that the sensor feels. */
typedef struct skv_tilt_reading {
    double gravity_x, gravity_y; /**< as skv_stage_set_gravity takes it, in units of the earth's:
                                    smoothed over 50 ms, at most 2 long */
    double push_x, push_y;       /**< as skv_stage_push takes it, m/s, of the time since the last
                                    reading: what the smoothing leaves out, from 0.15 of the earth's
                                    gravity on; 0 for a device that is not shaken */
} skv_tilt_reading;

/** What there is to remember between two readings. Plain data; all 0 at first. */
typedef struct skv_tilt_filter {
    bool begun;
    double x, y; /**< gravity, smoothed, before it is cut to its length */
} skv_tilt_filter;

/** What water feels where a sensor reads (x, y), m/s^2 along the device's own axes, as sensors do:
 * held upright and at rest +9.81 along y; `seconds` after the last time. What is not finite counts
 * as not read. */
SKV_API skv_tilt_reading skv_tilt_feel(skv_tilt_filter *filter, double x, double y, double seconds,
                                       skv_orientation up);

typedef struct skv_tilt skv_tilt;

/** Finds the first acceleration sensor under `root`; null: /sys/bus/iio/devices. `*tilt` is null on
 * failure: SKV_ERROR_DEVICE if there is none, or if this is no Linux. */
SKV_API skv_result skv_tilt_open(const char *root, skv_tilt **tilt, skv_error *error);
SKV_API void skv_tilt_close(skv_tilt *tilt);

/** Reads the sensor, `seconds` after the last time (0 at first). False, and nothing written, if it
 * cannot be read. May take some milliseconds. */
SKV_API bool skv_tilt_read(skv_tilt *tilt, double seconds, skv_orientation up,
                           skv_tilt_reading *reading);

#ifdef __cplusplus
}
#endif
#endif
