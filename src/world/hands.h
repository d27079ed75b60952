/* Hands, for acting.c. */
#ifndef SKV_WORLD_HANDS_H
#define SKV_WORLD_HANDS_H

#include "world/acting.h"

skv_result skv_check_hands(const skv_hand *hands, int count, skv_error *error);
skv_external_force skv_hand_force(const skv_hand *hand, float dt);
skv_result skv_exchange_hands(skv_port *port, skv_acting *acting, skv_error *error);

#endif
