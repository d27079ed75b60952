/** @file
 * The core library in one include: terrain, world, step, queries, instruments. No dependency beyond
 * libc and pthreads. What needs more has headers of its own: scenes skvalp/scene.h, experiments
 * skvalp/experiments.h and skvalp/study.h, worlds with a log skvalp/player.h, links to them
 * skvalp/link.h; for front ends skvalp/stage.h, skvalp/controls.h, skvalp/numbers.h,
 * skvalp/fingers.h, skvalp/stopwatch.h, skvalp/tilt.h and skvalp/render.h. */
#ifndef SKVALP_SKVALP_H
#define SKVALP_SKVALP_H

#include "skvalp/acting.h"
#include "skvalp/air.h"
#include "skvalp/base.h"
#include "skvalp/bodies.h"
#include "skvalp/camera.h"
#include "skvalp/fluid.h"
#include "skvalp/frame.h"
#include "skvalp/measure.h"
#include "skvalp/parameters.h"
#include "skvalp/particles.h"
#include "skvalp/query.h"
#include "skvalp/snapshot.h"
#include "skvalp/terrain.h"
#include "skvalp/world.h"

#endif
