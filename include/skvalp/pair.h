/** @file
 * Pair: two sessions side by side, at the same moment of their own worlds, so that two liquids or
 * two resolutions can be compared (docs/session.md).
 *
 * Both step the same frames; the one that takes longer sets the pace. The sessions stay their
 * owner's, who makes all calls on one thread, and who draws each of them as before; what goes on in
 * time is asked of the pair.
 */
#ifndef SKVALP_PAIR_H
#define SKVALP_PAIR_H

#include "skvalp/session.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct skv_pair skv_pair;

/** Pairs two sessions, the second with what the first has shared (skv_session_share). What is open
 * in them is played from its start again, as skv_session_replay does, up to where the first shared
 * it: what was done since is cut off, and fingers that are down are let go. The instruments of the
 * first come to the second, in place of its own and under the same numbers; from then on what is
 * asked of both, one call each, keeps them so. */
SKV_API skv_result skv_pair_create(skv_session *a, skv_session *b, skv_pair **pair,
                                   skv_error *error);
/** Lets both go on by themselves. Null is allowed. */
SKV_API void skv_pair_destroy(skv_pair *pair);

/** As skv_session_advance, for both. */
SKV_API void skv_pair_advance(skv_pair *pair, double seconds, double drawing);
/** Whether time has to pass for anything to happen in one of them. */
SKV_API bool skv_pair_is_active(const skv_pair *pair);

/** As those of a session, for both at once. Undo takes the latest edit back, whichever it was made
 * in, and the other goes to that moment, too. Redo brings both back, if both can. */
SKV_API void skv_pair_set_paused(skv_pair *pair, bool paused);
SKV_API void skv_pair_step_once(skv_pair *pair);
SKV_API void skv_pair_set_speed(skv_pair *pair, double speed);
SKV_API void skv_pair_seek(skv_pair *pair, int64_t frame);
SKV_API void skv_pair_undo(skv_pair *pair);
SKV_API void skv_pair_redo(skv_pair *pair);

#ifdef __cplusplus
}
#endif
#endif
