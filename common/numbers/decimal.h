/* decimal.h: the double nearest to a decimal number in a text, as strtod, in less time.
 *
 *   const char *stop = decimal_read("-12.5e-3 7", &x);     x = -0.0125, stop is at the blank
 *
 *   [+-] digits [. digits] [e|E [+-] digits]               with a digit before the e
 *
 *   text                            answer
 *   w / 10^k, w < 2^53, k <= 22     doubles hold both, so their quotient is rounded once (Clinger)
 *   others, decimal comma in use    NULL, no wrong number: strtod obeys the locale, if one is set
 *   "nan", "inf", ".", "e1"         NULL: no such number
 *   "1e", "0x1"                     1, 0; stop is at the letter: whoever calls asks what comes next
 *   1e400                           infinity
 *   1e-400                          0
 *
 * Source: Clinger, "How to read floating point numbers accurately", PLDI 1990.
 */
#ifndef DECIMAL_H
#define DECIMAL_H

#include "../vec3.h"
#include <stdlib.h>

/* ---------------------------------------------------------------------------------------------- */

static inline bool decimal_digit(char c) { return c >= '0' && c <= '9'; }

/* The end of the number at `text`, a string; NULL if there is none. */
static inline const char *decimal_read(const char *text, double *out)
{
    const char *p = text + (*text == '-' || *text == '+');
    double w = 0, scale = 1;
    if (!decimal_digit(p[*p == '.'])) return NULL;
    for (; decimal_digit(*p); p++) w = 10 * w + (*p - '0');
    if (*p == '.')
        while (decimal_digit(*++p)) w = 10 * w + (*p - '0'), scale *= 10;
    bool exact = w < 0x1p53 && scale <= 1e22 && (*p | 32) != 'e';
    char *stop = (char *)p;
    *out = exact ? (*text == '-' ? -w : w) / scale : strtod(text, &stop);
    return stop < p ? NULL : stop;
}

#endif
