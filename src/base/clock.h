/* Wall time for profiles. Never part of a result. */
#ifndef SKV_BASE_CLOCK_H
#define SKV_BASE_CLOCK_H

/* Seconds from an arbitrary origin, monotonic. */
double skv_clock(void);

#endif
