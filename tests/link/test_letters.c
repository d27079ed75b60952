/* Letters of links: there is one text for every bytes, and another one is not read. */
#include "link/letters.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

static void bytes_come_back(void **unused)
{
    (void)unused;
    const uint8_t bytes[4] = {0xfb, 0xff, 0x00, 0x81};
    const char *const texts[5] = {"", "-w", "-_8", "-_8A", "-_8AgQ"};
    for (size_t size = 0; size <= 4; size++) {
        char text[8] = "";
        uint8_t back[8];
        size_t length;
        skv_letters_write(bytes, size, text);
        assert_int_equal(strlen(text), skv_letters_of(size));
        assert_string_equal(text, texts[size]);
        assert_null(skv_letters_read(text, back, &length));
        assert_int_equal(length, size);
        assert_memory_equal(back, bytes, size);
    }
}

static void another_text_is_not_read(void **unused)
{
    (void)unused;
    /* Bits to spare that are not 0; a letter too many; one that is none. */
    const char *const wrong[] = {"-x", "-_9", "A", "-_8A-", "-_8+"};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        uint8_t back[8];
        size_t length;
        if (!skv_letters_read(wrong[i], back, &length))
            fail_msg("%s is read", wrong[i]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bytes_come_back),
        cmocka_unit_test(another_text_is_not_read),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
