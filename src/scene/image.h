/* A picture in memory: what a reader of pictures yields and the painter's colours are read from. */
#ifndef SKV_SCENE_IMAGE_H
#define SKV_SCENE_IMAGE_H

#include <stdint.h>

/* Pixels as painted: top row first, four bytes each (red, green, blue, 255), what was transparent
 * laid over black. */
typedef struct skv_image {
    int width, height;
    uint8_t *pixels; /* skv_free */
} skv_image;

#endif
