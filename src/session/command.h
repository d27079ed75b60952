/* Commands: what each of them does to a world, and as bytes. A new one is a value of
 * skv_command_kind, its member of skv_command, and a row of the table in command.c. */
#ifndef SKV_SESSION_COMMAND_H
#define SKV_SESSION_COMMAND_H

#include "session/coder.h"
#include "skvalp/player.h"

enum { SKV_COMMAND_KINDS = SKV_COMMAND_DROP + 1 };

/* Does it to the world. On failure the world is as it was. */
skv_result skv_command_apply(const skv_command *command, skv_world *world, skv_error *error);

/* drop.c: a body comes; those go over which a brush's way leads, which is no failure. */
skv_result skv_drop_apply(const skv_drop *drop, skv_world *world, skv_error *error);
void skv_drop_take(const skv_dab *dab, skv_world *world);
/* As the table's `code`. */
bool skv_drop_code(skv_command *command, const skv_command last[2], skv_coder *coder);

/* Whether what the fluid weighs, or what holds it, is another afterwards. */
bool skv_command_changes_balance(skv_command_kind kind);

/* Writes the kind, a byte, and what belongs to it. */
void skv_command_encode(const skv_command *command, skv_writer *writer);

/* Reads one; false if these bytes are none, whoever wrote them. Whether a world takes it only the
 * world can tell. */
bool skv_command_decode(skv_command *command, skv_reader *reader);

/* What packed commands are told by: units, and the last two of each kind. Begins with zeros. */
typedef struct skv_packer {
    double units[SKV_UNITS];
    skv_command last[SKV_COMMAND_KINDS][2];
} skv_packer;

/* Writes what belongs to one after the others, and reads it, likewise. */
void skv_command_pack(const skv_command *command, skv_packer *packer, skv_writer *writer);
bool skv_command_unpack(skv_command_kind kind, skv_command *command, skv_packer *packer,
                        skv_reader *reader);

#endif
