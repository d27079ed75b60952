/* Hands, for acting.c. */
#ifndef SKV_WORLD_HANDS_H
#define SKV_WORLD_HANDS_H

#include "world/acting.h"

skv_result skv_check_hands(const skv_hand *hands, int count, skv_error *error);
skv_external_force skv_hand_force(const skv_hand *hand, float dt);
/* Writes or reads all of them but what they hold, which is apart: few hold anything. */
skv_result skv_exchange_hands(skv_port *port, skv_acting *acting, skv_error *error);
/* bodies/grip.c: whether they hold any; what they hold. */
bool skv_hands_hold_bodies(const skv_acting *acting);
skv_result skv_exchange_holds(skv_port *port, skv_acting *acting, skv_error *error);
/* Of one hand. */
void skv_exchange_held(skv_port *port, skv_hand *hand);

#endif
