/* What the page's first modules lack comes with larger ones (docs/web.md). Invariant: who asks for
 * it there is refused, and the host is told. */
#ifndef SKV_BASE_MORE_H
#define SKV_BASE_MORE_H

#include "skvalp/base.h"

/* Somebody asks for it; refuses. Only those modules have this: web/core/no_bodies.c. */
skv_result skv_want_more(skv_error *error);

#endif
