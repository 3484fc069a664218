/* explain.h: what programs say of one pixel (--pixel X,Y).
 *
 *   int xy[2];
 *   explain_pixel("320,200", width, height, xy)       columns and rows from 0; else exit 2
 *   explain_line(2, "(7.1)", "hit: t = %g", t)        two deep; the equation's number on the right
 *   explain_vector(2, "(1.2)", "p =", p)
 */
#ifndef EXPLAIN_H
#define EXPLAIN_H
#include "../options.h"
#include <stdarg.h>

/* ---------------------------------------------------------------------------------------------- */
__attribute__((format(printf, 3, 4)))
static inline void explain_line(int depth, const char *equation, const char *format, ...)
{
    char text[240];
    va_list list;
    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    printf("%*s%-*s%s%s\n", depth, "", *equation ? 83 - depth : 0, text, *equation ? " " : "",
           equation);
}

static inline void explain_vector(int depth, const char *equation, const char *what, vec3 a)
{
    explain_line(depth, equation, "%s (%.6g, %.6g, %.6g)", what, (double)a.x, (double)a.y,
                 (double)a.z);
}

static inline void explain_pixel(const char *text, int width, int height, int xy[2])
{
    char more;
    /* NOLINTNEXTLINE(cert-err34-c): nine digits fit, a tenth is one character more */
    if (sscanf(text, "%9d,%9d%c", &xy[0], &xy[1], &more) == 2 && xy[0] >= 0 && xy[0] < width
        && xy[1] >= 0 && xy[1] < height) return;
    die(2, "--pixel %.60s: allowed are X,Y with X from 0 to %d, Y from 0 to %d", text, width - 1,
        height - 1);
}

#endif
