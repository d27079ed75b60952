/* How eyes of full colour vision, 0, and those that lack one kind of cone see colours. */
#ifndef SKV_TEST_RENDER_EYES_H
#define SKV_TEST_RENDER_EYES_H

enum { EYES = 4 };

/* A colour, RGB 0..1, in Oklab (Ottosson 2020), in which equal distances look about equal: black
 * and white are 1 apart. */
void color_seen_by(int eye, const float color[3], double lab[3]);

double colors_apart(int eye, const float a[3], const float b[3]);

#endif
