/* The core library in one include: terrain, world, step, queries. No dependency beyond libc and
 * pthreads. Scenes and the front ends' parts have headers of their own: skvalp/scene.h,
 * skvalp/session.h, skvalp/render.h. */
#ifndef SKVALP_SKVALP_H
#define SKVALP_SKVALP_H

#include "skvalp/base.h"
#include "skvalp/terrain.h"
#include "skvalp/world.h"

#endif
