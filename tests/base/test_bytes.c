/* Bytes of files: counts as far as they are allowed, and nothing past the end. */
#include "base/bytes.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

static bool exchange_back(int written, int most, int *read)
{
    uint8_t bytes[4];
    skv_writer writer = {bytes, 0};
    skv_reader reader = {.bytes = bytes, .size = sizeof bytes};
    skv_exchange_count(&(skv_port){.to = &writer}, &written, written);
    *read = -1;
    return skv_exchange_count(&(skv_port){.from = &reader}, read, most);
}

static void as_many_as_are_allowed_are_read(void **unused)
{
    (void)unused;
    int read;
    assert_true(exchange_back(16, 16, &read));
    assert_int_equal(read, 16);
    assert_false(exchange_back(17, 16, &read));
    assert_int_equal(read, 0);
    assert_true(exchange_back(0, 0, &read));
    assert_int_equal(read, 0);
}

static void nothing_is_read_past_the_end(void **unused)
{
    (void)unused;
    const uint8_t bytes[3] = {1, 2, 3};
    skv_reader reader = {.bytes = bytes, .size = 3};
    assert_int_equal(skv_get(&reader, 3), 0x030201);
    assert_false(reader.failed);
    assert_int_equal(skv_get(&reader, 1), 0);
    assert_true(reader.failed);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(as_many_as_are_allowed_are_read),
        cmocka_unit_test(nothing_is_read_past_the_end),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
