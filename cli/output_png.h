/* Pictures as PNG files. */
#ifndef CLI_OUTPUT_PNG_H
#define CLI_OUTPUT_PNG_H

#include "output_file.h"

/* Writes width*height*3 bytes RGB, top row first. */
skv_result png_write(output_file *file, const uint8_t *rgb, int width, int height,
                     skv_error *error);

#endif
