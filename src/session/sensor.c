/* The acceleration sensor of Linux devices (industrial I/O). Invariant: what files say is
 * untrusted: a line that is no number, or no longer there, is a reading that did not take place. */
#include "skvalp/tilt.h"

#include "base/assert.h"
#include "base/memory.h"

#if defined(__linux__)

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { MOST_DEVICES = 32, PATH_SIZE = 4096 };

struct skv_tilt {
    char folder[PATH_SIZE];
    double scale[2], offset[2]; /* of x and y */
    double matrix[9];           /* from the sensor's axes to the device's, row by row */
    skv_tilt_filter filter;
};

/* A file's first line, without its end; false if there is none. */
static bool read_line(const char *folder, const char *name, char *line, size_t size)
{
    char path[PATH_SIZE + 64];
    skv_format(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, "r");
    if (!file)
        return false;
    bool read = fgets(line, (int)size, file) != NULL;
    fclose(file);
    line[read ? strcspn(line, "\n") : 0] = '\0';
    return read;
}

static bool read_number(const char *folder, const char *name, double *value)
{
    char line[64];
    return read_line(folder, name, line, sizeof line) && skv_parse_number(line, value);
}

/* "1, 0, 0; 0, 1, 0; 0, 0, 1"; left as it is if it is not that. */
static void read_matrix(const char *folder, double matrix[9])
{
    char line[256];
    double read[9];
    if (!read_line(folder, "in_accel_mount_matrix", line, sizeof line) &&
        !read_line(folder, "in_mount_matrix", line, sizeof line))
        return;
    int count = 0;
    for (char *at = line; *at && count < 9; count++) {
        at += strspn(at, " ,;");
        size_t length = strcspn(at, " ,;");
        bool last = at[length] == '\0';
        at[length] = '\0';
        if (!skv_parse_number(at, &read[count]))
            return;
        at += length + !last;
    }
    if (count == 9)
        memcpy(matrix, read, sizeof read);
}

/* The scale of an axis: its own, or that of all. */
static bool read_axis(skv_tilt *tilt, int axis)
{
    char name[32];
    double raw;
    skv_format(name, sizeof name, "in_accel_%c_raw", 'x' + axis);
    if (!read_number(tilt->folder, name, &raw))
        return false;
    skv_format(name, sizeof name, "in_accel_%c_scale", 'x' + axis);
    if (!read_number(tilt->folder, "in_accel_scale", &tilt->scale[axis]) &&
        !read_number(tilt->folder, name, &tilt->scale[axis]))
        return false;
    skv_format(name, sizeof name, "in_accel_%c_offset", 'x' + axis);
    if (!read_number(tilt->folder, name, &tilt->offset[axis]))
        tilt->offset[axis] = 0;
    return true;
}

skv_result skv_tilt_open(const char *root, skv_tilt **out, skv_error *error)
{
    SKV_ASSERT_OR(out, SKV_ERROR_VALUE);
    *out = NULL;
    root = root ? root : "/sys/bus/iio/devices";
    skv_tilt *tilt = skv_calloc(1, sizeof *tilt);
    if (!tilt)
        return skv_fail(error, SKV_ERROR_MEMORY, "out of memory for a sensor");
    for (int device = 0; device < MOST_DEVICES; device++) {
        skv_format(tilt->folder, sizeof tilt->folder, "%s/iio:device%d", root, device);
        if (!read_axis(tilt, 0) || !read_axis(tilt, 1))
            continue;
        for (int i = 0; i < 9; i++)
            tilt->matrix[i] = i % 4 == 0;
        read_matrix(tilt->folder, tilt->matrix);
        *out = tilt;
        return SKV_OK;
    }
    skv_free(tilt);
    return skv_fail(error, SKV_ERROR_DEVICE,
                    "%s: there is no acceleration sensor; tilt with the arrow keys", root);
}

void skv_tilt_close(skv_tilt *tilt)
{
    skv_free(tilt);
}

/* Acceleration along the device's x and y, m/s^2. A sensor without a z axis lies in the plane of
 * the screen. */
static bool read_acceleration(const skv_tilt *tilt, double *x, double *y)
{
    double raw[3] = {0};
    if (!read_number(tilt->folder, "in_accel_x_raw", &raw[0]) ||
        !read_number(tilt->folder, "in_accel_y_raw", &raw[1]))
        return false;
    read_number(tilt->folder, "in_accel_z_raw", &raw[2]);
    for (int i = 0; i < 3; i++) {
        int as = i < 2 ? i : 0;
        raw[i] = (raw[i] + (i < 2 ? tilt->offset[i] : 0)) * tilt->scale[as];
    }
    *x = tilt->matrix[0] * raw[0] + tilt->matrix[1] * raw[1] + tilt->matrix[2] * raw[2];
    *y = tilt->matrix[3] * raw[0] + tilt->matrix[4] * raw[1] + tilt->matrix[5] * raw[2];
    return isfinite(*x) && isfinite(*y);
}

bool skv_tilt_read(skv_tilt *tilt, double seconds, skv_orientation up, skv_tilt_reading *reading)
{
    SKV_ASSERT_OR(tilt && reading, false);
    double x, y;
    if (!read_acceleration(tilt, &x, &y))
        return false;
    *reading = skv_tilt_feel(&tilt->filter, x, y, seconds, up);
    return true;
}

#else

skv_result skv_tilt_open(const char *root, skv_tilt **tilt, skv_error *error)
{
    (void)root;
    SKV_ASSERT_OR(tilt, SKV_ERROR_VALUE);
    *tilt = NULL;
    return skv_fail(error, SKV_ERROR_DEVICE,
                    "sensors are read on Linux only; tilt with the arrow keys");
}

void skv_tilt_close(skv_tilt *tilt)
{
    (void)tilt;
}

bool skv_tilt_read(skv_tilt *tilt, double seconds, skv_orientation up, skv_tilt_reading *reading)
{
    (void)tilt, (void)seconds, (void)up, (void)reading;
    return false;
}

#endif
