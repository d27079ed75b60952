/** @file
 * Links: a replay in a line of text (docs/share.md), to be sent to somebody or shown as a QR code.
 * What is inside is what skv_player_share writes and skv_player_load reads.
 */
#ifndef SKVALP_LINK_H
#define SKVALP_LINK_H

#include "skvalp/base.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The most characters of a link, and the most bytes of the replay inside. */
#define SKV_LONGEST_LINK   32768
#define SKV_LARGEST_LINKED (1 << 20)

/** Whether a text is meant as a link: it begins with "skvalp:", or is a web address that goes on
 * with "#" and a version. Space around it is allowed. */
SKV_API bool skv_link_is(const char *text);

/** Writes a replay as a link, in one call of `write`: "skvalp:1...", or with the address of a web
 * page that hosts Skvalp, "https://example.org/water/#1...". `page` null: none. Fails with
 * SKV_ERROR_LIMIT (it would be too long: save it as a file), SKV_ERROR_VALUE (`page` is no
 * address), SKV_ERROR_FILE if `write` does, or SKV_ERROR_MEMORY. */
SKV_API skv_result skv_link_write(const void *replay, size_t size, const char *page,
                                  skv_write *write, void *user, skv_error *error);

/** Reads a link, any text at all, and writes the replay inside, in one call of `write`. White space
 * in a link is ignored. Fails with SKV_ERROR_FORMAT (it is none, damaged, cut short, or of another
 * version), SKV_ERROR_LIMIT, SKV_ERROR_FILE or SKV_ERROR_MEMORY. */
SKV_API skv_result skv_link_read(const char *link, skv_write *write, void *user, skv_error *error);

#ifdef __cplusplus
}
#endif
#endif
