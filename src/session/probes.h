/* Probes: a session's instruments, read by the worker and shown in pictures. */
#ifndef SKV_SESSION_PROBES_H
#define SKV_SESSION_PROBES_H

#include "session/gallery.h"
#include "session/mailbox.h"

typedef struct skv_probes {
    skv_lab *lab; /* made with the first probe */
    struct {
        uint32_t id; /* the session's */
        skv_instrument instrument;
        bool watched;
    } list[SKV_MOST_PROBES];
    int count;
    double time; /* of the last sample, s */
} skv_probes;

void skv_probes_destroy(skv_probes *probes);

/* Reads them; nothing without a probe. With other pressures than the world's, unless null. */
skv_result skv_probes_sample(skv_probes *probes, const skv_world *world, const float *pressure,
                             skv_error *error);

/* Does what a message of theirs says. */
skv_result skv_probes_handle(skv_probes *probes, const skv_message *message, skv_error *error);

/* How they are shown: all but those that read another one. */
void skv_probes_note(const skv_probes *probes, skv_showing *showing);

/* Paints them. */
void skv_probes_paint(const skv_probes *probes, skv_canvas *canvas);

#endif
