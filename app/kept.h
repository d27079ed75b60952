/* Kept: files for the worlds of windows, several of which may be open at once. */
#ifndef SKVALP_PLAY_KEPT_H
#define SKVALP_PLAY_KEPT_H

#include <glib.h>

G_BEGIN_DECLS

/* What one window knows of the folder. It has a place of its own there from the start. */
typedef struct PlayKept PlayKept;
PlayKept *play_kept_new(void);
void play_kept_free(PlayKept *kept);

/* Where the window writes its world; `title` is remembered with it. */
const char *play_kept_path(const PlayKept *kept);
void play_kept_name(const PlayKept *kept, const char *title);

/* The newest world that a window left behind, and that this one has not had yet; 0: none. */
int play_kept_left(const PlayKept *kept);
char *play_kept_path_at(const PlayKept *kept, int place);
/* "" if there is none. */
char *play_kept_title_at(const PlayKept *kept, int place);

/* Holds a place, so that no other window goes on there. False if one does already. */
gboolean play_kept_hold(const PlayKept *kept, int place);
/* From now on the window writes to a place that it holds, and leaves its former one behind. */
void play_kept_move(PlayKept *kept, int place);
/* Gives a damaged world another name, which is returned. */
char *play_kept_set_aside(const PlayKept *kept, int place);

G_END_DECLS

#endif
