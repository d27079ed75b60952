/* Plain text: what a terminal, a message or a window's title may show as it stands. */
#ifndef SKV_BASE_PLAIN_H
#define SKV_BASE_PLAIN_H

/* What is wrong with a text, "holds a control character" or "is not UTF-8"; null if it is plain. */
const char *skv_plain_complaint(const char *text);

#endif
