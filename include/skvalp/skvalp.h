/** @file
 * The core library in one include: terrain, world, step, queries, instruments. No dependency beyond
 * libc and pthreads. What needs more has headers of its own: scenes skvalp/scene.h, experiments
 * skvalp/experiments.h, and the front ends' parts skvalp/session.h and skvalp/render.h. */
#ifndef SKVALP_SKVALP_H
#define SKVALP_SKVALP_H

#include "skvalp/base.h"
#include "skvalp/camera.h"
#include "skvalp/measure.h"
#include "skvalp/terrain.h"
#include "skvalp/world.h"

#endif
