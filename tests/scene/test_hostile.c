/* Damaged files and failing memory: whatever comes in, the answer is a scene or one line, and
 * nothing is left behind. Run it with the asan preset to see also what is read. */
#include "support.h"
#include "support/long.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const json_files[] = {"pool", "communicating", "breaking-wave"};
static const char *const pictures[] = {"funnel", "maze"};

/* A clean failure: a code, one line that begins with the file, and no scene. */
static void check_answer(skv_result result, const skv_scene *scene, const skv_error *error)
{
    if (result == SKV_OK) {
        assert_non_null(scene);
        assert_true(skv_scene_particles(scene) > 0);
        return;
    }
    assert_null(scene);
    assert_int_equal(error->code, result);
    assert_int_equal(strncmp(error->text, "file", 4), 0);
    for (const char *c = error->text; *c != '\0'; c++)
        assert_true((unsigned char)*c >= 0x20);
}

static skv_result try_load(const uint8_t *data, size_t size, const char *format)
{
    /* An exact copy, so that a sanitizer sees a read beyond its end. */
    uint8_t *copy = malloc(size > 0 ? size : 1);
    memcpy(copy, data, size);
    skv_scene *scene;
    skv_error error = {0};
    skv_scene_options options = skv_default_scene_options();
    options.particles = 200;
    skv_result result = skv_scene_load_memory(copy, size, format, "file", &options, &scene, &error);
    check_answer(result, scene, &error);
    skv_scene_destroy(scene);
    free(copy);
    assert_int_equal(blocks_held(), 0);
    return result;
}

static buffer read_scene(const char *folder, const char *name, const char *ending)
{
    char path[512];
    snprintf(path, sizeof path, "%s/scenes/%s%s%s", SKV_SOURCE_DIR, folder, name, ending);
    return buffer_read(path);
}

static int watch(void **state)
{
    (void)state;
    watch_memory();
    return 0;
}

static int unwatch(void **state)
{
    (void)state;
    unwatch_memory();
    return 0;
}

static void test_json_with_a_byte_0(void **state)
{
    (void)state;
    static const uint8_t text[] =
        "{ \"seconds\": 8\0, \"water\": [ { \"shape\": \"box\", \"y1\": 0.4 } ] }";
    assert_int_equal(try_load(text, sizeof text - 1, "json"), SKV_ERROR_FORMAT);
}

/* ---- Cut off --------------------------------------------------------------------------------- */

static void test_json_cut_at_every_byte(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof json_files / sizeof json_files[0]; i++) {
        buffer b = read_scene("", json_files[i], ".json");
        while (b.size > 0 && b.data[b.size - 1] == '\n')
            b.size--;
        assert_int_equal(try_load(b.data, b.size, "json"), SKV_OK);
        for (size_t size = 0; size < b.size; size += ONE_OF)
            assert_int_equal(try_load(b.data, size, "json"), SKV_ERROR_FORMAT);
        buffer_free(&b);
    }
}

static void test_png_cut_at_every_byte(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof pictures / sizeof pictures[0]; i++) {
        buffer b = read_scene("painted/", pictures[i], ".png");
        assert_int_equal(try_load(b.data, b.size, "png"), SKV_OK);
        for (size_t size = 0; size < b.size; size += ONE_OF)
            assert_int_equal(try_load(b.data, size, "png"), SKV_ERROR_FORMAT);
        buffer_free(&b);
    }
}

/* ---- Changed --------------------------------------------------------------------------------- */

static void test_json_with_changed_bytes(void **state)
{
    (void)state;
    static const char spice[] = "{}[],:\"0-9e.\\u\x80\xff\n tN";
    uint32_t seed = 1;
    int good = 0;
    for (int i = 0; i < 500 / ONE_OF; i++) {
        buffer b = read_scene("", json_files[i % 3], ".json");
        for (uint32_t n = dice(&seed) % 3 + 1; n > 0; n--) {
            uint8_t *byte = &b.data[dice(&seed) % b.size];
            if (dice(&seed) % 2)
                *byte ^= (uint8_t)(1u << dice(&seed) % 8);
            else
                *byte = (uint8_t)spice[dice(&seed) % (sizeof spice - 1)];
        }
        good += try_load(b.data, b.size, "json") == SKV_OK;
        buffer_free(&b);
    }
    assert_in_range(good, 1, 1499);
}

/* Also with the checksums set right, so that the damage gets past them. */
static uint32_t crc(const uint8_t *data, size_t size)
{
    uint32_t sum = 0xffffffffu;
    for (size_t i = 0; i < size; i++) {
        sum ^= data[i];
        for (int bit = 0; bit < 8; bit++)
            sum = sum >> 1 ^ (sum & 1 ? 0xedb88320u : 0);
    }
    return ~sum;
}

static void repair_checksums(buffer *b)
{
    for (size_t at = 8; at + 12 <= b->size;) {
        const uint8_t *p = b->data + at;
        size_t length = (size_t)p[0] << 24 | (size_t)p[1] << 16 | (size_t)p[2] << 8 | p[3];
        if (length > b->size - at - 12)
            return;
        uint32_t sum = crc(b->data + at + 4, length + 4);
        for (int i = 0; i < 4; i++)
            b->data[at + 8 + length + (size_t)i] = (uint8_t)(sum >> (24 - 8 * i));
        at += length + 12;
    }
}

static void test_png_with_changed_bytes(void **state)
{
    (void)state;
    uint32_t seed = 2;
    int good = 0;
    for (int i = 0; i < 500 / ONE_OF; i++) {
        buffer b = read_scene("painted/", pictures[i % 2], ".png");
        for (uint32_t n = dice(&seed) % 4 + 1; n > 0; n--) {
            /* Every other time in the first chunks. */
            size_t range = dice(&seed) % 2 ? b.size : 60;
            b.data[dice(&seed) % range] ^= (uint8_t)(1u << dice(&seed) % 8);
        }
        if (i % 4 != 0)
            repair_checksums(&b);
        good += try_load(b.data, b.size, "png") == SKV_OK;
        buffer_free(&b);
    }
    assert_in_range(good, 1, 1199);
}

/* A broken checksum alone is noticed. */
static void test_a_wrong_checksum(void **state)
{
    (void)state;
    buffer b = read_scene("painted/", "maze", ".png");
    b.data[b.size - 20] ^= 1; /* in the pixels' checksum or before it */
    skv_scene *scene;
    skv_error error;
    assert_int_equal(skv_scene_load_memory(b.data, b.size, "png", "file", NULL, &scene, &error),
                     SKV_ERROR_FORMAT);
    assert_int_equal(strncmp(error.text, "file: damaged PNG: ", 19), 0);
    buffer_free(&b);
}

static void test_noise(void **state)
{
    (void)state;
    uint32_t seed = 3;
    for (int i = 0; i < 500 / ONE_OF; i++) {
        uint8_t noise[300];
        size_t size = dice(&seed) % sizeof noise;
        for (size_t k = 0; k < size; k++)
            noise[k] = (uint8_t)dice(&seed);
        try_load(noise, size, "json");
        try_load(noise, size, "png");
        /* Behind a good beginning. */
        if (size > 33) {
            memcpy(
                noise,
                "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\x20\0\0\0\x20\x08\x02\0\0\0\xfc\x18\xed\xa3",
                33);
            try_load(noise, size, "png");
        }
    }
}

/* ---- Memory ---------------------------------------------------------------------------------- */

/* Every allocation in turn fails. */
static void starve(const buffer *b, const char *format)
{
    skv_scene_options options = skv_default_scene_options();
    options.particles = 200;
    skv_result result = SKV_ERROR_MEMORY;
    int count = 0;
    for (; result != SKV_OK; count++) {
        assert_true(count < 500);
        skv_scene *scene;
        skv_error error = {0};
        limit_allocations(count);
        result = skv_scene_load_memory(b->data, b->size, format, "file", &options, &scene, &error);
        if (result != SKV_OK && result != SKV_ERROR_MEMORY)
            fail_msg("allocation %d: %s", count, error.text);
        if (result == SKV_OK) {
            skv_world *world;
            skv_result built = SKV_ERROR_MEMORY;
            for (int more = 0; built != SKV_OK; more++) {
                assert_true(more < 500);
                limit_allocations(more);
                built = skv_scene_create_world(scene, 1, &world, &error);
                assert_true(built == SKV_OK || built == SKV_ERROR_MEMORY);
                assert_int_equal(built == SKV_OK, world != NULL);
            }
            skv_world_destroy(world);
        }
        skv_scene_destroy(scene);
        assert_int_equal(blocks_held(), 0);
    }
    limit_allocations(-1);
    assert_true(count > 10);
}

static void test_memory_runs_out(void **state)
{
    (void)state;
    buffer b = read_scene("painted/", "funnel", ".png");
    starve(&b, "png");
    buffer_free(&b);
    b = read_scene("", "communicating", ".json");
    starve(&b, "json");
    buffer_free(&b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_json_with_a_byte_0),
        cmocka_unit_test(test_json_cut_at_every_byte),
        cmocka_unit_test(test_png_cut_at_every_byte),
        cmocka_unit_test(test_json_with_changed_bytes),
        cmocka_unit_test(test_png_with_changed_bytes),
        cmocka_unit_test(test_a_wrong_checksum),
        cmocka_unit_test(test_noise),
        cmocka_unit_test(test_memory_runs_out),
    };
    return cmocka_run_group_tests(tests, watch, unwatch);
}
