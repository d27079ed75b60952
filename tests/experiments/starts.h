/* Starts: a run is exact, but a slightly other start is another run. These are the first ones of
 * `skvalp lab --starts`: as many particles as wanted, a hundredth more, a hundredth fewer. */
#ifndef SKV_TEST_STARTS_H
#define SKV_TEST_STARTS_H

enum { START_COUNT = 3 };

static inline int start_particles(int wanted, int start)
{
    const int hundredths[START_COUNT] = {100, 101, 99};
    return wanted * hundredths[start] / 100;
}

#endif
