/* What a link holds, taken apart layer by layer; the first byte says where to begin: any text as a
 * link, any bytes as what a link has deflated, as a packed log, as a scene's recipe, as how it is
 * shown; and any bytes that are sealed go into a link and come out of it the same. */
#include "fuzz.h"

#include "base/envelope.h"
#include "base/memory.h"
#include "link/letters.h"
#include "scene/recipe.h"
#include "session/packed_log.h"
#include "session/showing.h"
#include "support/kept.h"

#include <skvalp/link.h>

#include <stdlib.h>
#include <string.h>

static void try_link(const char *link)
{
    kept inside = {0};
    skv_error error = {0};
    fuzz_expect_answer(skv_link_read(link, kept_add, &inside, &error), &error);
    fuzz_expect(inside.size <= SKV_LARGEST_LINKED, "no link holds more than it may");
    fuzz_expect(!inside.bytes || skv_link_is(link), "what is read is a link");
    kept_clear(&inside);
}

static void try_text(const uint8_t *data, size_t size)
{
    kept link = {0};
    kept_add((const char *)data, size, &link);
    try_link(link.bytes);
    kept_clear(&link);
}

static void try_deflated(const uint8_t *data, size_t size)
{
    static const char head[] = "skvalp:1.";
    char *link = calloc(1, sizeof head + skv_letters_of(size));
    memcpy(link, head, sizeof head - 1);
    skv_letters_write(data, size, link + sizeof head - 1);
    try_link(link);
    free(link);
}

static void try_round(const uint8_t *data, size_t size)
{
    kept sealed = {0}, link = {0}, back = {0};
    skv_error error = {0};
    kept_add((const char *)data, size, &sealed);
    skv_envelope_seal((uint8_t *)sealed.bytes, size);
    skv_result result = skv_link_write(sealed.bytes, size, NULL, kept_add, &link, &error);
    fuzz_expect_answer(result, &error);
    if (result == SKV_OK) {
        bool read = skv_link_read(link.bytes, kept_add, &back, NULL) == SKV_OK;
        fuzz_expect(read == skv_envelope_is_sealed((uint8_t *)sealed.bytes, size),
                    "a link is read if what it holds is sealed");
        fuzz_expect(!read || (back.size == size && memcmp(back.bytes, sealed.bytes, size) == 0),
                    "what went into a link comes out");
    }
    kept_clear(&sealed);
    kept_clear(&link);
    kept_clear(&back);
}

static void try_log(const uint8_t *data, size_t size)
{
    skv_log log = {0}, again = {0};
    skv_error error = {0};
    const skv_steps steps = {0.000244140625, 0.015625, 9.81, 0.00958};
    skv_result result = skv_log_unpack(&log, data, size, 1000, true, &error);
    fuzz_expect_answer(result, &error);
    if (result == SKV_OK) {
        size_t packed_size;
        uint8_t *packed = skv_log_pack(&log, &steps, &packed_size);
        result = skv_log_unpack(&again, packed, packed_size, 1000, true, NULL);
        fuzz_expect(result == SKV_OK && again.size == log.size &&
                        (log.size == 0 || memcmp(again.bytes, log.bytes, log.size) == 0),
                    "a log that was packed is the same");
        skv_free(packed);
    }
    skv_free(log.bytes);
    skv_free(again.bytes);
}

static void try_recipe(const uint8_t *data, size_t size)
{
    skv_recipe recipe;
    skv_setting *settings = NULL;
    if (skv_recipe_read(data, size, &recipe, &settings)) {
        size_t length = strlen(recipe.name);
        for (int i = 0; i < recipe.options.setting_count; i++)
            length += strlen(settings[i].path) + strlen(settings[i].value);
        fuzz_expect(length + recipe.size + recipe.picture_size < size,
                    "a recipe lies in its bytes");
    }
    skv_free(settings);
}

static size_t write_showing(const skv_showing *showing, uint8_t **bytes)
{
    skv_writer counter = {NULL, 0};
    skv_showing_put(&counter, showing);
    *bytes = calloc(counter.used, 1);
    skv_writer writer = {*bytes, 0};
    skv_showing_put(&writer, showing);
    return writer.used;
}

static void try_showing(const uint8_t *data, size_t size)
{
    skv_showing showing, again;
    skv_reader reader = {.bytes = data, .size = size};
    if (!skv_showing_get(&reader, &showing))
        return;
    uint8_t *first, *second;
    size_t written = write_showing(&showing, &first);
    skv_reader back = {.bytes = first, .size = written};
    fuzz_expect(skv_showing_get(&back, &again) && back.at == written,
                "what is shown is read again");
    fuzz_expect(write_showing(&again, &second) == written && memcmp(first, second, written) == 0,
                "what is shown stays the same");
    free(first);
    free(second);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static void (*const tries[])(const uint8_t *, size_t) = {try_text, try_deflated, try_round,
                                                             try_log,  try_recipe,   try_showing};
    if (size == 0)
        return 0;
    /* An exact fit, so that a sanitizer sees a read beyond its end. */
    uint8_t *rest = malloc(size > 1 ? size - 1 : 1);
    memcpy(rest, data + 1, size - 1);
    tries[data[0] % (sizeof tries / sizeof *tries)](rest, size - 1);
    free(rest);
    return 0;
}
