/* decimal.h: the double nearest to a decimal number in a text: strtod, of decimal numbers alone.
 *
 *   const char *stop = decimal_read("-12.5e-3 7", &x);     x = -0.0125, stop is at the blank
 *
 *   [+-] digits [. digits] [e|E [+-] digits]               with a digit before the e
 *
 *   text                            answer
 *   "nan", "inf", ".", "1e", "0x1"  NULL: no such number, or only a part of one
 *   1e400                           infinity
 *   1e-400                          0
 *   "1.5", decimal comma in use     NULL, no wrong number: strtod obeys the locale, if one is set
 */
#ifndef DECIMAL_H
#define DECIMAL_H

#include "../vec3.h"
#include <stdlib.h>

/* ---------------------------------------------------------------------------------------------- */

static inline bool decimal_digit(char c) { return c >= '0' && c <= '9'; }

/* The end of the number at `text`, a string; NULL if strtod sees another end, or there is none. */
static inline const char *decimal_read(const char *text, double *out)
{
    const char *p = text;
    char *stop;
    if (*p == '-' || *p == '+') p++;
    while (decimal_digit(*p)) p++;
    if (*p == '.') p++;
    while (decimal_digit(*p)) p++;
    if (*p == 'e' || *p == 'E') {
        p++;
        if (*p == '-' || *p == '+') p++;
        while (decimal_digit(*p)) p++;
    }
    *out = strtod(text, &stop);
    return stop == p && p > text ? p : NULL;
}

#endif
