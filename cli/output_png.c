/* Writes RGB pictures with libpng's simplified interface, which reports instead of jumping. */
#include "output_png.h"

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
    if (!png_image_write_to_stdio(&image, file->stream, 0, rgb, 0, NULL)) {
        /* A full disk has a better name in errno's words. */
        skv_result lost = output_file_check(file, error);
        return lost ? lost
                    : skv_fail(error, SKV_ERROR_FILE,
                               "%s: cannot be written: %s; write the picture elsewhere", file->name,
                               image.message);
    }
    return SKV_OK;
}
