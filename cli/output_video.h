/* Videos: raw frames into the ffmpeg program. */
#ifndef CLI_OUTPUT_VIDEO_H
#define CLI_OUTPUT_VIDEO_H

#include <sys/types.h>

#include "output_file.h"

/* All zero is a video that is not wanted or has ended. */
typedef struct output_video {
    output_file file;
    const char *encoder;
    pid_t process;  /* ffmpeg; 0: none */
    int frames;     /* the socket that ffmpeg reads from */
    FILE *messages; /* what ffmpeg complained about */
    size_t frame_bytes;
} output_video;

/* Finds ffmpeg and an encoder and makes sure of the place: H.264, else MPEG-4.
 * SKV_ERROR_DEVICE if there is no ffmpeg. */
skv_result video_open(output_video *video, const char *name, skv_error *error);
/* Starts the encoder for 60 pictures a second of this even size. */
skv_result video_start(output_video *video, int width, int height, skv_error *error);
/* Adds a picture: width*height*3 bytes RGB, top row first. */
skv_result video_add(output_video *video, const uint8_t *rgb, skv_error *error);
/* Waits until ffmpeg is done and gives the file its name. */
skv_result video_commit(output_video *video, skv_error *error);
void video_discard(output_video *video);

#endif
