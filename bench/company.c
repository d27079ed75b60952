/* Pools with company, as scenes: a second fluid, bodies, jelly, air. Invariant: their tank is that
 * of the built-in pool, and it is about as deep, so that what differs is the company. */
#include "company.h"

#include <string.h>

/* A log of wood that floats. */
#define LOG(x) "{\"shape\":\"circle\",\"material\":\"wood\",\"x\":" x ",\"y\":0.45,\"radius\":0.05}"

static const struct {
    const char *name, *title, *text;
} companies[BENCH_COMPANIES] = {
    {"oil-on-water", "oil on water",
     "{\"sleep\":false,\"fluids\":[{\"name\":\"oil\",\"material\":\"oil\"}],\"water\":["
     "{\"shape\":\"box\",\"y1\":0.3},"
     "{\"shape\":\"box\",\"y0\":0.3,\"y1\":0.45,\"fluid\":\"oil\"}]}"},
    {"ten-bodies", "ten bodies of 0.1 m",
     "{\"sleep\":false,\"water\":[{\"shape\":\"box\",\"y1\":0.45}],"
     "\"bodies\":[" LOG("0.08") "," LOG("0.24") "," LOG("0.4") "," LOG("0.56") "," LOG(
         "0.72") "," LOG("0.88") "," LOG("1.04") "," LOG("1.2") "," LOG("1.36") "," LOG("1.52") "]"
                                                                                                "}"},
    {"half-jelly", "half of it jelly",
     "{\"sleep\":false,\"fluids\":[{\"name\":\"jelly\",\"shear_modulus\":1000}],\"water\":["
     "{\"shape\":\"box\",\"x0\":0.8,\"y1\":0.45},"
     "{\"shape\":\"box\",\"x1\":0.8,\"y1\":0.45,\"fluid\":\"jelly\"}]}"},
    {"bell-of-air", "a bell of air",
     "{\"sleep\":false,\"air\":{\"pressure\":10},\"solid\":[{\"shape\":\"line\","
     "\"thickness\":0.05,\"points\":[[0.6,0.08],[0.6,0.32],[1,0.32],[1,0.08]]}],\"water\":["
     "{\"shape\":\"box\",\"y1\":0.08},{\"shape\":\"box\",\"x1\":0.6,\"y0\":0.08,\"y1\":0.45},"
     "{\"shape\":\"box\",\"x0\":1,\"y0\":0.08,\"y1\":0.45},"
     "{\"shape\":\"box\",\"x0\":0.6,\"x1\":1,\"y0\":0.32,\"y1\":0.45}]}"},
};

static int find(const char *name)
{
    for (int i = 0; i < BENCH_COMPANIES; i++)
        if (strcmp(companies[i].name, name) == 0)
            return i;
    return -1;
}

const char *bench_company_name(int i)
{
    return companies[i].name;
}

const char *bench_company_title(const char *name)
{
    int i = find(name);
    return i < 0 ? NULL : companies[i].title;
}

const char *bench_company_scene(const char *name)
{
    int i = find(name);
    return i < 0 ? NULL : companies[i].text;
}
