/* figure.h: drawings that explain, as SVG, in the coordinates of what they explain; y points up.
 *
 *   figure g = figure_begin(&o, "01_ray_geometry.svg", 760, 300);    where it goes: output.h
 *   figure_at(path, 760, 300)            the same, to this file
 *   figure_origin(&g, 60, 200, 100);     from now on (0, 0) is the pixel (60, 200), a unit is 100
 *   figure_line(&g, x0, y0, x1, y1, FIGURE_BLUE, 1.5, FIGURE_WHOLE);       or FIGURE_DASHED
 *   figure_arrow(&g, x0, y0, x1, y1, FIGURE_BLACK, 1.5);                   its head at (x1, y1)
 *   figure_dot(&g, x, y, 4, FIGURE_RED);                                   radius in pixels
 *   figure_polygon(&g, 4, xy, FIGURE_BLUE, 0.2, FIGURE_BLACK);    x, y in turn; fill, its opacity,
 *                                                                 outline; NULL: none
 *   figure_arc(&g, x, y, 30, 0, 90, FIGURE_BLACK, 1);             radius in pixels; degrees
 *   figure_text(&g, x, y, 8, -6, FIGURE_LEFT, FIGURE_BLACK, "*o* + _t_ *d*");      8 right, 6 up
 *   figure_print(&g, x, y, 8, -6, FIGURE_LEFT, FIGURE_BLACK, "_t_ = %g", t);       as printf
 *   figure_end(&g);                                               saves it
 *
 * In texts, UTF-8, *..* is bold (vectors), _.._ is italic (numbers), ~..~ is lower (an index).
 * Colours are those of M. Okabe, K. Ito, "Color Universal Design", 2008.
 */
#ifndef FIGURE_H
#define FIGURE_H
#include "../output.h"

#define FIGURE_BLACK "#000000"
#define FIGURE_GREY "#777777"
#define FIGURE_BLUE "#0072b2"
#define FIGURE_RED "#d55e00"
#define FIGURE_GREEN "#009e73"
#define FIGURE_PURPLE "#cc79a7"
#define FIGURE_ORANGE "#e69f00"
#define FIGURE_SKY "#56b4e9"
#define FIGURE_WHOLE ""
#define FIGURE_DASHED "stroke-dasharray=\"5 4\""
#define FIGURE_LEFT "start"     /* the text begins at its place */
#define FIGURE_MIDDLE "middle"
#define FIGURE_RIGHT "end"

typedef struct {
    FILE *out;                  /* NULL: not wanted */
    file_writer file;
    char path[512];
    double x, y, unit;          /* pixels: of (0, 0), of a unit */
} figure;
typedef struct { double x, y; } figure_point;  /* for who computes places */

/* ---------------------------------------------------------------------------------------------- */
/* path NULL: not wanted. */
static inline figure figure_at(const char *path, int width, int height)
{
    figure g = {.unit = 1};
    failure f;
    if (!path) return g;
    if (!file_begin(&g.file, path, &f)) fail(f);
    snprintf(g.path, sizeof g.path, "%s", path);
    g.out = g.file.stream;
    fprintf(g.out, "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" width=\"%d\" "
            "height=\"%d\" font-family=\"sans-serif\" font-size=\"15\">\n<rect width=\"%d\" "
            "height=\"%d\" fill=\"white\"/>\n", width, height, width, height, width, height);
    return g;
}

static inline figure figure_begin(const options *o, const char *name, int width, int height)
{
    char room[512];
    return figure_at(output_path(o, name, false, room), width, height);
}

static inline void figure_end(figure *g)
{
    failure f;
    if (!g->out) return;
    fprintf(g->out, "</svg>\n");
    if (!file_commit(&g->file, &f)) fail(f);
    output_note(g->path);
    g->out = NULL;
}

static inline void figure_origin(figure *g, double x, double y, double unit)
{
    g->x = x, g->y = y, g->unit = unit;
}

/* Where (x, y) lies; + 0.0 turns -0 into 0. */
static inline double figure_x(const figure *g, double x) { return g->x + g->unit * x + 0.0; }
static inline double figure_y(const figure *g, double y) { return g->y - g->unit * y + 0.0; }

static inline void figure_line(figure *g, double x0, double y0, double x1, double y1,
                               const char *colour, double width, const char *dashes)
{
    if (!g->out) return;
    fprintf(g->out, "<path d=\"M%.1f,%.1fL%.1f,%.1f\" stroke=\"%s\" stroke-width=\"%g\" %s/>\n",
            figure_x(g, x0), figure_y(g, y0), figure_x(g, x1), figure_y(g, y1), colour, width,
            dashes);
}

static inline void figure_arrow(figure *g, double x0, double y0, double x1, double y1,
                                const char *colour, double width)
{
    double ax = figure_x(g, x0), ay = figure_y(g, y0), bx = figure_x(g, x1), by = figure_y(g, y1);
    double dx = bx - ax, dy = by - ay, length = sqrt(dx * dx + dy * dy), size = 4 + 3 * width;
    if (!g->out || !(length > 0)) return;
    dx *= size / length, dy *= size / length;
    fprintf(g->out, "<path d=\"M%.1f,%.1fL%.1f,%.1f\" stroke=\"%s\" stroke-width=\"%g\"/>\n",
            ax, ay, bx - 0.8 * dx, by - 0.8 * dy, colour, width);
    fprintf(g->out, "<path d=\"M%.1f,%.1fL%.1f,%.1fL%.1f,%.1fZ\" fill=\"%s\"/>\n", bx, by,
            bx - dx - 0.4 * dy, by - dy + 0.4 * dx, bx - dx + 0.4 * dy, by - dy - 0.4 * dx, colour);
}

static inline void figure_dot(figure *g, double x, double y, double radius, const char *colour)
{
    if (!g->out) return;
    fprintf(g->out, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%g\" fill=\"%s\"/>\n", figure_x(g, x),
            figure_y(g, y), radius, colour);
}

static inline void figure_polygon(figure *g, int n, const double *xy, const char *fill,
                                  double opacity, const char *outline)
{
    if (!g->out) return;
    fprintf(g->out, "<path d=\"");
    for (int i = 0; i < n; i++)
        fprintf(g->out, "%c%.1f,%.1f", i ? 'L' : 'M', figure_x(g, xy[2 * i]),
                figure_y(g, xy[2 * i + 1]));
    fprintf(g->out, "Z\" fill=\"%s\" fill-opacity=\"%g\" stroke=\"%s\"/>\n", fill ? fill : "none",
            opacity, outline ? outline : "none");
}

/* Anticlockwise from one angle to the other, in degrees [less than 180 apart]. */
static inline void figure_arc(figure *g, double x, double y, double radius, double from, double to,
                              const char *colour, double width)
{
    const double degree = 3.14159265358979323846 / 180;
    double cx = figure_x(g, x), cy = figure_y(g, y);
    if (!g->out) return;
    fprintf(g->out, "<path d=\"M%.1f,%.1fA%g,%g 0 0 0 %.1f,%.1f\" fill=\"none\" stroke=\"%s\" "
            "stroke-width=\"%g\"/>\n", cx + radius * cos(from * degree),
            cy - radius * sin(from * degree), radius, radius, cx + radius * cos(to * degree),
            cy - radius * sin(to * degree), colour, width);
}

/* At (x, y), but so many pixels to the right, and down. */
static inline void figure_text(figure *g, double x, double y, double right, double down,
                               const char *where, const char *colour, const char *text)
{
    static const char *const begin[] = {" font-weight=\"bold\"", " font-style=\"italic\"",
                                        " font-size=\"12\" dy=\"4\""};
    const char *marks = "*_~", *m;
    int open = -1;
    bool raise = false;
    if (!g->out) return;
    fprintf(g->out, "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\" fill=\"%s\" "
            "xml:space=\"preserve\">",
            figure_x(g, x) + right, figure_y(g, y) + down, where, colour);
    for (; *text; text++) {
        if (!(m = strchr(marks, *text))) {
            if (raise && open < 0) fprintf(g->out, "<tspan dy=\"-4\">"), open = 3, raise = false;
            fprintf(g->out, *text == '<' || *text == '>' || *text == '&' ? "&#%d;" : "%c", *text);
            continue;
        }
        bool same = open == (int)(m - marks);
        if (open >= 0) fprintf(g->out, "</tspan>");
        if (!same) {
            fprintf(g->out, "<tspan%s%s>", begin[m - marks], raise ? " dy=\"-4\"" : "");
            if (m - marks != 2) raise = false;
        } else if (open == 2) raise = true;
        open = same ? -1 : (int)(m - marks);
    }
    fprintf(g->out, "%s</text>\n", open >= 0 ? "</tspan>" : "");
}

/* The same, of a text like printf's. */
__attribute__((format(printf, 8, 9)))
static inline void figure_print(figure *g, double x, double y, double right, double down,
                                const char *where, const char *colour, const char *format, ...)
{
    char text[128];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    figure_text(g, x, y, right, down, where, colour, text);
}
#endif
