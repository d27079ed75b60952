/* The files of scenes/, compiled in, each with its picture. The table is written by builtin.cmake
 * during the build. */
#ifndef SKV_SCENE_BUILTIN_H
#define SKV_SCENE_BUILTIN_H

#include "skvalp/scene.h"

typedef struct skv_builtin {
    skv_scene_info info;
    const unsigned char *text; /* the JSON file */
    size_t size;
    const unsigned char *picture; /* the PNG that it names; null: none */
    size_t picture_size;
} skv_builtin;

extern const skv_builtin skv_builtins[];
extern const int skv_builtin_count;

#endif
