/* A locale that writes numbers with a comma, on any machine. */
#ifndef SKV_TEST_COMMA_LOCALE_H
#define SKV_TEST_COMMA_LOCALE_H

/* Sets LC_NUMERIC so that printf writes 0,5 and strtod reads it; the test fails if that cannot be
 * done. */
void set_comma_locale(void);

/* Sets the C locale again. */
void reset_locale(void);

#endif
