/* decimal.h: the double nearest to a decimal number in a text, faster than strtod.
 *
 *   const char *stop = decimal_read("-12.5e-3 7", &x);     x = -0.0125, stop is at the blank
 *
 *   [+-] digits [. digits] [e|E [+-] digits]               with a digit before the e
 *
 *   text                                answer
 *   "nan", "inf", ".", "1e"             NULL: no such number, or only a part of one
 *   "0x1p3"                             0, stop is at the x: no hexadecimal numbers
 *   1e400                               infinity
 *   1e-400                              0
 *   w 10^e, w up to 2^53, |e| <= 22     one rounding: w and 10^|e| are doubles without error, so
 *                                       their product or quotient is the nearest one (Clinger)
 *   the rest, as numbers of 17 digits   strtod; it obeys the locale, so a program that sets one
 *                                       with a decimal comma gets NULL for these, no wrong number
 *
 * Source: Clinger, "How to read floating point numbers accurately", PLDI 1990.
 */
#ifndef DECIMAL_H
#define DECIMAL_H

#include "../vec3.h"
#include <stdint.h>
#include <stdlib.h>

/* The end of the number at `text`, a string; NULL if there is none. */
static inline const char *decimal_read(const char *text, double *out);

/* ---------------------------------------------------------------------------------------------- */

static inline bool decimal_digit(char c) { return c >= '0' && c <= '9'; }

static inline const char *decimal_read(const char *text, double *out)
{
    static const double ten[] = {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11,
                                 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    const char *p = text;
    bool negative = *p == '-';
    if (*p == '-' || *p == '+') p++;
    const char *first = p;
    uint64_t w = 0;  /* wraps around beyond 19 digits, and then is not used */
    while (decimal_digit(*p)) w = 10 * w + (uint64_t)(*p++ - '0');
    long digits = p - first, e = 0;
    if (*p == '.') {
        const char *point = ++p;
        while (decimal_digit(*p)) w = 10 * w + (uint64_t)(*p++ - '0');
        e = point - p;
        digits -= e;
    }
    bool complete = digits > 0;
    if (*p == 'e' || *p == 'E') {
        long sign = *++p == '-' ? -1 : 1, x = 0;
        if (*p == '-' || *p == '+') p++;
        complete = complete && decimal_digit(*p);
        for (; decimal_digit(*p); p++) x = x < 100000 ? 10 * x + (*p - '0') : x;
        e += sign * x;
    }
    if (!complete) return NULL;
    if (digits <= 19 && w <= (uint64_t)1 << 53 && e >= -22 && e <= 22) {
        double a = negative ? -(double)w : (double)w;
        *out = e < 0 ? a / ten[-e] : a * ten[e];
        return p;
    }
    char *stop;
    *out = strtod(text, &stop);
    return stop == p ? p : NULL;
}

#endif
