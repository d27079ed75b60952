/* Force fields, for change.c and acting.c. */
#ifndef SKV_WORLD_FORCES_H
#define SKV_WORLD_FORCES_H

#include "world/acting.h"

skv_result skv_check_forces(const skv_force *forces, int count, skv_error *error);
skv_external_force skv_field_force(const skv_force *force, float h, float dt);
/* The acceleration that a force may give, at most, m/s^2. */
float skv_force_strength(const skv_force *force);
/* Writes or reads one, unchecked. */
void skv_exchange_force(skv_port *port, skv_force *force);
skv_result skv_exchange_forces(skv_port *port, skv_acting *acting, skv_error *error);

#endif
