/* Links (docs/share.md): a version, and a replay deflated and written in letters.
 *
 * Invariant: nothing that a link claims is believed: the letters bound what is inflated from, and
 * SKV_LARGEST_LINKED what it becomes. What comes out is, to the last byte, what was sealed; what it
 * says is the player's to judge.
 */
#include "skvalp/link.h"

#include <stdint.h>
#include <string.h>

#include "base/assert.h"
#include "base/envelope.h"
#include "base/memory.h"
#include "link/deflate.h"
#include "link/letters.h"

#define SCHEME  "skvalp:"
#define VERSION "1."

static const char *after_space(const char *text)
{
    return text + strspn(text, " \t\r\n");
}

/* Other addresses would be read as names of files. */
static bool is_web(const char *text)
{
    return strncmp(text, "https://", 8) == 0 || strncmp(text, "http://", 7) == 0 ||
           strncmp(text, "file://", 7) == 0;
}

/* What follows "skvalp:" or the "#" of a web address; null if it is neither. */
static const char *find_payload(const char *text)
{
    text = after_space(text);
    if (strncmp(text, SCHEME, sizeof SCHEME - 1) == 0)
        return text + sizeof SCHEME - 1;
    size_t address = strcspn(text, "# \t\r\n");
    return is_web(text) && text[address] == '#' ? text + address + 1 : NULL;
}

bool skv_link_is(const char *text)
{
    SKV_ASSERT_OR(text, false);
    const char *payload = find_payload(text);
    size_t digits = payload ? strspn(payload, "0123456789") : 0;
    bool scheme = payload && payload[-1] == ':';
    return scheme || (digits > 0 && payload[digits] == '.');
}

static skv_result fail_memory(skv_error *error)
{
    return skv_fail(error, SKV_ERROR_MEMORY, "link: out of memory");
}

static skv_result fail_damaged(skv_error *error)
{
    return skv_fail(error, SKV_ERROR_FORMAT, "link: it is damaged or cut short; copy all of it");
}

/* ---- Writing --------------------------------------------------------------------------------- */

static bool is_page(const char *page)
{
    return is_web(page) && page[strcspn(page, "# \t\r\n")] == '\0';
}

static skv_result write_text(const uint8_t *packed, size_t size, const char *page, skv_write *write,
                             void *user, skv_error *error)
{
    char begin[1024];
    size_t head =
        skv_format(begin, sizeof begin, "%s%s" VERSION, page ? page : SCHEME, page ? "#" : "");
    size_t length = head + skv_letters_of(size);
    if (size == 0 || length > SKV_LONGEST_LINK)
        return skv_fail(error, SKV_ERROR_LIMIT,
                        "link: it would have more than the %d characters that a link may have; "
                        "save it as a file",
                        SKV_LONGEST_LINK);
    char *text = skv_calloc(length + 1, 1);
    if (!text)
        return fail_memory(error);
    memcpy(text, begin, head);
    skv_letters_write(packed, size, text + head);
    bool written = write(text, length, user);
    skv_free(text);
    return written ? SKV_OK : skv_fail(error, SKV_ERROR_FILE, "link: it could not be written");
}

skv_result skv_link_write(const void *replay, size_t size, const char *page, skv_write *write,
                          void *user, skv_error *error)
{
    SKV_ASSERT_OR(replay && write, SKV_ERROR_VALUE);
    if (page && (!is_page(page) || strlen(page) > 1000))
        return skv_fail(error, SKV_ERROR_VALUE,
                        "link: '%s' is no address of a page; say for example "
                        "https://example.org/water/",
                        page);
    if (size > SKV_LARGEST_LINKED)
        return skv_fail(error, SKV_ERROR_LIMIT,
                        "link: it holds %zu bytes, more than the %d that a link may hold; save it "
                        "as a file",
                        size, SKV_LARGEST_LINKED);
    size_t room = skv_bytes_of(SKV_LONGEST_LINK), used = 0;
    uint8_t *packed = skv_calloc(room, 1);
    bool made = packed && skv_deflate(replay, size, packed, room, &used);
    skv_result result = made ? SKV_OK : fail_memory(error);
    if (result == SKV_OK)
        result = write_text(packed, used, page, write, user, error);
    skv_free(packed);
    return result;
}

/* ---- Reading --------------------------------------------------------------------------------- */

/* Names what stands before the wrong letter: the version at least. */
static skv_result fail_letter(const char *payload, const char *wrong, skv_error *error)
{
    enum { NAMED = 12 };
    const char *end = wrong, *from;
    if (!*wrong)
        return fail_damaged(error);
    while (end[-1] <= ' ')
        end--;
    for (from = end; from > payload - 2 && end - from < NAMED && from[-1] > ' ';)
        from--;
    return skv_fail(error, SKV_ERROR_FORMAT, "link: it is damaged after \"%.*s\"; copy all of it",
                    (int)(end - from), from);
}

/* Inflates into `room` bytes, one of them too many. */
static skv_result expand(const uint8_t *packed, size_t size, uint8_t *to, size_t room, size_t *used,
                         skv_error *error)
{
    skv_inflated state = skv_inflate(packed, size, to, room, used);
    if (*used == room)
        return skv_fail(error, SKV_ERROR_LIMIT, "link: it holds more than the %d bytes allowed",
                        SKV_LARGEST_LINKED);
    return state == SKV_INFLATED_WHOLE       ? SKV_OK
           : state == SKV_INFLATED_NO_MEMORY ? fail_memory(error)
                                             : fail_damaged(error);
}

static skv_result read_payload(const char *payload, uint8_t *packed, uint8_t *bytes,
                               skv_write *write, void *user, skv_error *error)
{
    size_t packed_size, size = 0;
    const char *wrong = skv_letters_read(payload, packed, &packed_size);
    if (wrong)
        return fail_letter(payload, wrong, error);
    skv_result result = expand(packed, packed_size, bytes, SKV_LARGEST_LINKED + 1, &size, error);
    /* A wrong letter can inflate to something else. */
    if (result == SKV_OK && !skv_envelope_is_sealed(bytes, size))
        result = fail_damaged(error);
    if (result == SKV_OK && !write((const char *)bytes, size, user))
        result = skv_fail(error, SKV_ERROR_FILE, "link: it could not be written");
    return result;
}

/* What follows the version. */
static skv_result check_head(const char *link, const char **payload, skv_error *error)
{
    const char *found = find_payload(link);
    size_t digits = found ? strspn(found, "0123456789") : 0;
    if (digits == 0 || found[digits] != '.')
        return skv_fail(error, SKV_ERROR_FORMAT,
                        "link: this is none; one begins with " SCHEME VERSION);
    if (strncmp(found, VERSION, sizeof VERSION - 1) != 0)
        return skv_fail(error, SKV_ERROR_FORMAT,
                        "link: its version is %.*s, this library reads 1; use a newer skvalp",
                        (int)(digits < 9 ? digits : 9), found);
    if (strlen(found) > SKV_LONGEST_LINK)
        return skv_fail(error, SKV_ERROR_LIMIT, "link: it has more than the %d characters allowed",
                        SKV_LONGEST_LINK);
    *payload = found + sizeof VERSION - 1;
    return SKV_OK;
}

skv_result skv_link_read(const char *link, skv_write *write, void *user, skv_error *error)
{
    SKV_ASSERT_OR(link && write, SKV_ERROR_VALUE);
    const char *payload = "";
    skv_result result = check_head(link, &payload, error);
    if (result != SKV_OK)
        return result;
    uint8_t *packed = skv_calloc(skv_bytes_of(strlen(payload)) + 1, 1);
    uint8_t *bytes = skv_calloc(SKV_LARGEST_LINKED + 1, 1);
    result = packed && bytes ? read_payload(payload, packed, bytes, write, user, error)
                             : fail_memory(error);
    skv_free(packed);
    skv_free(bytes);
    return result;
}
