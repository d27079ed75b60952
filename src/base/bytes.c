/* Little-endian bytes. Invariant: a reader never looks beyond its bytes, whatever is asked for. */
#include "base/bytes.h"

#include <string.h>

void skv_put(skv_writer *w, uint64_t value, int bytes)
{
    for (int i = 0; i < bytes; i++) {
        if (w->bytes)
            w->bytes[w->used] = (uint8_t)(value >> (8 * i));
        w->used++;
    }
}

void skv_put_float(skv_writer *w, float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    skv_put(w, bits, 4);
}

void skv_put_double(skv_writer *w, double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    skv_put(w, bits, 8);
}

void skv_put_text(skv_writer *w, const char *text)
{
    size_t length = strlen(text);
    length = length < 255 ? length : 255;
    skv_put(w, length, 1);
    for (size_t i = 0; i < length; i++)
        skv_put(w, (uint8_t)text[i], 1);
}

uint64_t skv_get(skv_reader *r, int bytes)
{
    if (r->failed || r->size - r->at < (size_t)bytes) {
        r->failed = true;
        return 0;
    }
    uint64_t value = 0;
    for (int i = 0; i < bytes; i++)
        value |= (uint64_t)r->bytes[r->at++] << (8 * i);
    return value;
}

float skv_get_float(skv_reader *r)
{
    uint32_t bits = (uint32_t)skv_get(r, 4);
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

double skv_get_double(skv_reader *r)
{
    uint64_t bits = skv_get(r, 8);
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

void skv_get_text(skv_reader *r, char text[256])
{
    int length = (int)skv_get(r, 1);
    for (int i = 0; i < length; i++)
        text[i] = (char)skv_get(r, 1);
    text[length] = '\0';
}

void skv_exchange(skv_port *port, uint64_t *value, int bytes)
{
    if (port->to)
        skv_put(port->to, *value, bytes);
    else
        *value = skv_get(port->from, bytes);
}

void skv_exchange_float(skv_port *port, float *value)
{
    if (port->to)
        skv_put_float(port->to, *value);
    else
        *value = skv_get_float(port->from);
}

void skv_exchange_double(skv_port *port, double *value)
{
    if (port->to)
        skv_put_double(port->to, *value);
    else
        *value = skv_get_double(port->from);
}

bool skv_exchange_count(skv_port *port, int *count, int most)
{
    uint64_t number = (uint64_t)*count;
    skv_exchange(port, &number, 4);
    bool allowed = number <= (uint64_t)most;
    *count = allowed ? (int)number : 0;
    return allowed;
}

uint64_t skv_hash_bytes(uint64_t hash, const void *data, size_t size)
{
    const uint8_t *bytes = data;
    for (size_t i = 0; i < size; i++)
        hash = (hash ^ bytes[i]) * 1099511628211u;
    return hash;
}
