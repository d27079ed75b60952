/* Dye: the names of its colours. */
#ifndef SKV_WORLD_DYE_H
#define SKV_WORLD_DYE_H

#include "skvalp/particles.h"

/* FIRST(name) and NEXT(name) in order: the number of a dye is its place. */
#define SKV_DYE_NAMES(FIRST, NEXT)                                                                 \
    FIRST("none") NEXT("rose") NEXT("amber") NEXT("green") NEXT("violet")

/* Fails for what is no dye. */
skv_result skv_check_dye(int dye, skv_error *error);

#endif
