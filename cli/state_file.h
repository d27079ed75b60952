/* Files that hold the state of a world, what --snapshot writes and run goes on from, and replays.
 */
#ifndef CLI_STATE_FILE_H
#define CLI_STATE_FILE_H

#include "options.h"
#include "output_file.h"
#include "skvalp/player.h"
#include "skvalp/world.h"

/* True for a name that ends in .skv, in any letter case. */
bool is_state_file(const char *name);

/* Makes the world of the state file that is named. Without --anyway what asks for unusually much is
 * refused. */
skv_result state_file_read(const cli_options *options, skv_world **world, skv_error *error);

/* The same for a replay: a name that ends in .skvr, or a link. */
bool is_replay_file(const char *name);
skv_result replay_file_read(const cli_options *options, skv_player **player, skv_error *error);

/* What to call it: a link is too long to be said. */
const char *name_of_input(const char *name);

/* Writes the world, with its terrain. */
skv_result state_file_write(output_file *file, const skv_world *world, skv_error *error);

#endif
