/* Results, messages, allocator hooks, assert handler, and the exact functions against libm. */
#include "base/assert.h"
#include "base/exact.h"
#include "base/memory.h"
#include "base/platform.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static void every_result_has_a_text(void **unused)
{
    (void)unused;
    for (int r = SKV_OK; r <= SKV_ERROR_DEVICE; r++)
        assert_string_not_equal(skv_result_text((skv_result)r), "unknown result");
    assert_string_equal(skv_result_text((skv_result)99), "unknown result");
    char version[32];
    snprintf(version, sizeof version, "%d.%d.%d", SKV_VERSION_MAJOR, SKV_VERSION_MINOR,
             SKV_VERSION_PATCH);
    assert_string_equal(skv_version(), version);
}

static void messages_are_one_line(void **unused)
{
    (void)unused;
    skv_error error = {0};
    assert_int_equal(skv_fail(&error, SKV_ERROR_FILE, "a\nb\x1b[31m%s\x7f", "c"), SKV_ERROR_FILE);
    assert_string_equal(error.text, "a?b?[31mc?");
    assert_int_equal(error.code, SKV_ERROR_FILE);
    assert_int_equal(skv_fail(NULL, SKV_ERROR_VALUE, "ignored"), SKV_ERROR_VALUE);
    char endless[2000];
    memset(endless, ' ', sizeof endless - 1);
    endless[sizeof endless - 1] = 0;
    skv_fail(&error, SKV_ERROR_FILE, "%s", endless);
    assert_int_equal(strlen(error.text), sizeof error.text - 1);
}

/* A name of any length leaves room for the place and the remedy, and breaks no character. */
static void messages_cut_long_words(void **unused)
{
    (void)unused;
    skv_error error = {0};
    char name[5001];
    for (int i = 0; i < 2500; i++)
        memcpy(name + 2 * i, "\xc3\xa5", 2); /* a letter of two bytes */
    name[5000] = 0;
    for (int shift = 0; shift < 2; shift++) {
        name[0] = 'x';
        skv_fail(&error, SKV_ERROR_FILE, "%s.png: it is gone; name %s", name + shift, "another");
        const char *gap = strstr(error.text, "...");
        assert_non_null(gap);
        assert_true(gap - error.text >= 79 && strlen(error.text) < 180);
        assert_true((unsigned char)gap[-1] == 0xa5 && (unsigned char)gap[3] == 0xc3);
        assert_non_null(strstr(error.text, ".png: it is gone; name another"));
    }
    memset(name, 'a', 160);
    name[160] = 0;
    skv_fail(&error, SKV_ERROR_FILE, "%s end", name);
    assert_int_equal(strlen(error.text), 164);
}

static int live;

static void *counting_allocate(size_t bytes, size_t alignment, void *user)
{
    assert_ptr_equal(user, &live);
    live++;
    return aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
}

static void counting_release(void *memory, void *user)
{
    assert_ptr_equal(user, &live);
    live--;
    free(memory);
}

static void memory_is_zeroed_aligned_and_hooked(void **unused)
{
    (void)unused;
    const skv_allocator hooks = {counting_allocate, counting_release, &live};
    skv_set_allocator(&hooks);
    unsigned char *bytes = skv_calloc(1000, 3);
    assert_int_equal(live, 1);
    assert_int_equal((uintptr_t)bytes % SKV_ALIGNMENT, 0);
    for (int i = 0; i < 3000; i++)
        assert_int_equal(bytes[i], 0);
    skv_free(bytes);
    skv_free(NULL);
    assert_int_equal(live, 0);
    skv_set_allocator(NULL);
    assert_null(skv_calloc(SIZE_MAX / 2, 3));
    assert_null(skv_calloc(SIZE_MAX - 8, 1));
    void *empty = skv_calloc(0, 8);
    assert_non_null(empty);
    skv_free(empty);
}

static int reports;

static void note_assertion(const char *condition, const char *file, int line, void *user)
{
    assert_string_equal(condition, "number > 0");
    assert_non_null(strstr(file, "test_base.c"));
    assert_true(line > 0);
    assert_ptr_equal(user, &reports);
    reports++;
}

/* Whether the system says of memory that it was asked for large pages there. */
static bool asked_for_large_pages(const void *memory, FILE *maps)
{
    char line[512];
    bool within = false;
    while (fgets(line, sizeof line, maps)) {
        unsigned long long from, to;
        if (sscanf(line, "%llx-%llx", &from, &to) == 2)
            within = from <= (uintptr_t)memory && (uintptr_t)memory < to;
        else if (within && strncmp(line, "VmFlags:", 8) == 0)
            return strstr(line, " hg") != NULL;
    }
    return false;
}

static void large_memory_has_large_pages_if_there_are_any(void **unused)
{
    (void)unused;
    FILE *sizes = fopen("/sys/kernel/mm/transparent_hugepage/hpage_pmd_size", "r");
    FILE *maps = fopen("/proc/self/smaps", "r");
    size_t size = 0;
    char *memory = skv_calloc(16 << 20, 1);
    assert_non_null(memory);
    if (maps && sizes && fscanf(sizes, "%zu", &size) == 1 && size == 2 << 20)
        assert_true(asked_for_large_pages(memory + (8 << 20), maps));
    skv_free(memory);
    if (sizes)
        fclose(sizes);
    if (maps)
        fclose(maps);
}

static int checked(int number)
{
    SKV_ASSERT_OR(number > 0, -1);
    return number;
}

static void assertions_go_to_the_handler(void **unused)
{
    (void)unused;
    skv_set_assert_handler(note_assertion, &reports);
    assert_int_equal(checked(5), 5);
    assert_int_equal(reports, 0);
    assert_int_equal(checked(-5), -1);
    assert_int_equal(reports, 1);
    skv_set_assert_handler(NULL, NULL);
}

static void exact_functions_agree_with_libm(void **unused)
{
    (void)unused;
    for (double x = -50; x <= 50; x += 0.0173)
        assert_true(fabs(skv_exp(x) / exp(x) - 1) < 1e-14 * (1 + fabs(x)));
    for (double x = 1e-6; x < 1e6; x *= 1.013)
        assert_true(fabs(skv_log(x) - log(x)) < 1e-14 * (1 + fabs(log(x))));
    for (double b = 0.01; b < 1; b += 0.01)
        for (double e = 0.01; e < 2; e += 0.05)
            assert_true(fabs(skv_pow(b, e) / pow(b, e) - 1) < 1e-13);
    for (double angle = -3.1; angle <= 3.1; angle += 0.001)
        assert_true(fabs(skv_atan2(3 * sin(angle), 3 * cos(angle)) - angle) < 1e-14);
    for (double x = -1000; x < 1000; x += 0.37) {
        assert_true(fabs(skv_sin(x) - sin(x)) < 1e-13 && fabs(skv_cos(x) - cos(x)) < 1e-13);
        if (fabs(x) < 20)
            assert_true(fabs(skv_sin(x) - sin(x)) < 1e-14 && fabs(skv_cos(x) - cos(x)) < 1e-14);
    }
    assert_true(skv_sin(0) == 0 && skv_cos(0) == 1);
    assert_true(skv_atan2(0, 0) == 0 && skv_atan2(0, -2) == 3.14159265358979323846);
    for (double x = 1.7e-9; x < 1e12; x *= 1.013)
        assert_true(fabs(skv_decade(x) / pow(10, floor(log10(x))) - 1) < 1e-15);
    assert_true(skv_decade(0.001) == 0.001 && skv_decade(1) == 1 && skv_decade(1e3) == 1e3);
    assert_true(skv_decade(0) < 1e-299 && isfinite(skv_decade(INFINITY)));
    assert_true(skv_pow(0, 0) == 1 && skv_pow(0, 0.3) == 0 && skv_exp(0) == 1 && skv_log(1) == 0);
}

static void the_clock_does_not_run_backwards(void **unused)
{
    (void)unused;
    double before = skv_clock();
    for (int i = 0; i < 1000; i++) {
        double now = skv_clock();
        assert_true(now >= before);
        before = now;
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_result_has_a_text),
        cmocka_unit_test(messages_are_one_line),
        cmocka_unit_test(messages_cut_long_words),
        cmocka_unit_test(memory_is_zeroed_aligned_and_hooked),
        cmocka_unit_test(large_memory_has_large_pages_if_there_are_any),
        cmocka_unit_test(assertions_go_to_the_handler),
        cmocka_unit_test(exact_functions_agree_with_libm),
        cmocka_unit_test(the_clock_does_not_run_backwards),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
