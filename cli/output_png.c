/* Writes RGB pictures with libpng's simplified interface, which reports instead of jumping. */
#include "output_png.h"

#include <errno.h>
#include <png.h>
#include <string.h>

skv_result png_write(output_file *file, const uint8_t *rgb, int width, int height, skv_error *error)
{
    png_image image;
    memset(&image, 0, sizeof image);
    image.version = PNG_IMAGE_VERSION;
    image.width = (png_uint_32)width;
    image.height = (png_uint_32)height;
    image.format = PNG_FORMAT_RGB;
    errno = 0;
    bool written = png_image_write_to_stdio(&image, file->stream, 0, rgb, 0, NULL);
    /* A full disk has a better name in the system's words than in libpng's, which does not notice
     * when the last of it gets lost. */
    skv_result result = output_file_check(file, error);
    if (!result && !written)
        result = skv_fail(error, SKV_ERROR_FILE,
                          "%s: cannot be written: %s; write the picture elsewhere", file->name,
                          image.message);
    return result;
}
