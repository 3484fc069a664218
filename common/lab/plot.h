/* plot.h: line plots as SVG, with linear or logarithmic axes.
 *
 *   plot p = plot_new("Error of a hit", "distance [R]", "error [R]", PLOT_LOG_X | PLOT_LOG_Y);
 *   int naive = plot_series(&p, "naive");
 *   plot_add(&p, naive, 100, 2.5e-10);
 *   plot_slope(&p, 1, "slope 1");             y ~ x^1 through the first point, dashed
 *   output_plot(&o, &p, "03_sphere_error.svg");
 *
 * Each series has its own mark and its own colour of M. Okabe, K. Ito, "Color Universal Design",
 * 2008, which the colour-blind can tell apart; from the ninth on these come again, dashed and with
 * another mark. A y <= 0 on a logarithmic axis is drawn as a hollow mark on the bottom edge, as the
 * legend then says; lines break there. Texts are UTF-8, names some 28 characters long.
 */
#ifndef PLOT_H
#define PLOT_H
#include "../file.h"
#include "../vec3.h"
#include <math.h>

enum { PLOT_LOG_X = 1, PLOT_LOG_Y = 2, plot_most_series = 14, plot_most_slopes = 2 };
enum { plot_colours = 8, plot_yellow = 7 };  /* this one has wide lines, and black-edged marks */
typedef struct { int series; double x, y; } plot_point;
typedef struct {
    const char *title, *x_label, *y_label;
    int flags, series, slopes;
    char name[plot_most_series + plot_most_slopes][64];  /* slopes behind series */
    double slope[plot_most_slopes];
    plot_point *points;
    size_t n, room;
} plot;

/* ---------------------------------------------------------------------------------------------- */
/* The three texts are not copied. */
static inline plot plot_new(const char *title, const char *x_label, const char *y_label, int flags)
{
    return (plot){.title = title, .x_label = x_label, .y_label = y_label, .flags = flags};
}

static inline void plot_free(plot *p) { free(p->points), p->points = NULL, p->n = p->room = 0; }

/* A new series [at most 14]; its number. */
static inline int plot_series(plot *p, const char *name)
{
    if (p->series == plot_most_series) abort();
    snprintf(p->name[p->series], sizeof p->name[0], "%.63s", name);
    return p->series++;
}

/* Points are joined in the order in which they come. What is not finite, or beyond 1e100 where
 * places might overflow, is left out, and so is an x <= 0 on a logarithmic axis. */
static inline void plot_add(plot *p, int series, double x, double y)
{
    bool drawable = fabs(x) <= 1e100 && fabs(y) <= 1e100;  /* false for a NaN */
    if (!drawable || (p->flags & PLOT_LOG_X && x <= 0)) return;
    p->points = grown(p->points, p->n, &p->room, sizeof *p->points);
    p->points[p->n++] = (plot_point){series, x, y};
}

/* A reference line y ~ x^slope (linear axes: of that slope) through the first point [at most 2]. */
static inline void plot_slope(plot *p, double slope, const char *name)
{
    if (p->slopes == plot_most_slopes) abort();
    snprintf(p->name[plot_most_series + p->slopes], sizeof p->name[0], "%.63s", name);
    p->slope[p->slopes++] = slope;
}

/* Values (on a logarithmic axis their logarithms) lowest .. highest lie at places from .. to. */
typedef struct { double lowest, highest, from, to; bool log, hollow; } plot_axis;

static inline double plot_value(plot_axis a, double v) { return a.log ? log10(v) : v; }

static inline double plot_place(plot_axis a, double value)
{
    return a.from + (a.to - a.from) * (value - a.lowest) / (a.highest - a.lowest);
}

/* Distance of ticks: whole decades, or 1, 2 or 5 times a power of ten; 4 to 10 of them. */
static inline double plot_step(plot_axis a)
{
    double span = a.highest - a.lowest, unit = pow(10, floor(log10(span / 4)));
    if (a.log) return ceil(span / 10);
    return unit * (span / unit > 20 ? 5 : span / unit > 8 ? 2 : 1);
}

/* An axis that holds all values of one coordinate, from tick to tick; a linear one includes 0. */
static inline plot_axis plot_range(const plot *p, bool y, double from, double to)
{
    bool log = (p->flags & (y ? PLOT_LOG_Y : PLOT_LOG_X)) != 0;
    plot_axis a = {log ? HUGE_VAL : 0, log ? -HUGE_VAL : 0, from, to, log, false};
    for (size_t i = 0; i < p->n; i++) {
        double v = plot_value(a, y ? p->points[i].y : p->points[i].x);
        a.hollow |= !isfinite(v);
        if (isfinite(v)) a.lowest = fmin(a.lowest, v), a.highest = fmax(a.highest, v);
    }
    if (a.lowest > a.highest) a.lowest = a.highest = 0;           /* nothing to show */
    if (a.highest - a.lowest < 1e-100) a.highest = a.lowest + 1;  /* one value only */
    double step = log ? 1 : plot_step(a);
    a.lowest = step * floor(a.lowest / step + 1e-9);
    a.highest = step * ceil(a.highest / step - 1e-9);
    return a;
}

static const char *const plot_colour[plot_colours] = {
    "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000", "#f0e442"};

static inline void plot_mark(FILE *out, int series, double x, double y, bool hollow)
{
    static const char *const mark[plot_colours] = {
        "M-4,0A4,4 0 1 0 4,0A4,4 0 1 0 -4,0Z", "M-4,-4H4V4H-4Z", "M0,-5L5,4H-5Z", "M0,5L5,-4H-5Z",
        "M0,-5L5,0L0,5L-5,0Z", "M-5,-2H-2V-5H2V-2H5V2H2V5H-2V2H-5Z", "M-5,-4L0,-1L5,-4V4L0,1L-5,4Z",
        "M-5,-2H5V2H-5Z"};
    fprintf(out, "<path d=\"%s\" transform=\"translate(%.1f,%.1f)\" fill=\"%s\" stroke=\"%s\"/>\n",
            mark[(series + 3 * (series / plot_colours)) % plot_colours], x, y,
            hollow ? "white" : plot_colour[series % plot_colours],
            plot_colour[series == plot_yellow ? plot_yellow - 1 : series % plot_colours]);
}

static inline void plot_line(FILE *out, double x, double y, double x1, double y1, const char *style)
{
    fprintf(out, "<path clip-path=\"url(#area)\" d=\"M%.1f,%.1fL%.1f,%.1f\" ", x, y, x1, y1);
    fprintf(out, "%s/>\n", style);
}

/* Texts are UTF-8. Markup is escaped, control characters become question marks: valid XML. */
static inline void plot_text(FILE *out, double x, double y, const char *style, const char *text)
{
    fprintf(out, "<text x=\"%.1f\" y=\"%.1f\" %s>", x, y, style);
    for (; *text; text++) {
        bool markup = *text == '<' || *text == '>' || *text == '&';
        fprintf(out, markup ? "&#%d;" : "%c", iscntrl((unsigned char)*text) ? '?' : *text);
    }
    fprintf(out, "</text>\n");
}

static inline void plot_ticks(FILE *out, plot_axis a, plot_axis other, bool y)
{
    double step = plot_step(a), from = other.from, to = other.to;
    char text[32];
    for (double k = ceil(a.lowest / step - 1e-9); k * step <= a.highest + 1e-9 * step; k++) {
        double v = k * step + 0.0, at = plot_place(a, v);  /* + 0.0 turns -0 into 0 */
        bool power = a.log && fabs(v) > 3;
        snprintf(text, sizeof text, power ? "1e%.0f" : "%.6g", a.log && !power ? pow(10, v) : v);
        plot_line(out, y ? from : at, y ? at : from, y ? to : at, y ? at : to, "stroke=\"#ddd\"");
        if (y) plot_text(out, from - 8, at + 4, "text-anchor=\"end\"", text);
        else plot_text(out, at, from + 18, "text-anchor=\"middle\"", text);
    }
}

/* One series: lines between its points, its marks upon them, and its entry in the legend. */
static inline void plot_curve(const plot *p, FILE *out, int s, plot_axis ax, plot_axis ay)
{
    double px = 0, py = 0, legend = 62 + 20 * s;
    bool pen = false;
    char style[80];
    snprintf(style, sizeof style, "stroke-width=\"%s\" stroke=\"%s\"%s",
             s == plot_yellow ? "3" : "1.5", plot_colour[s % plot_colours],
             s < plot_colours ? "" : " stroke-dasharray=\"6 3\"");
    for (size_t i = 0; i < p->n; i++) {
        if (p->points[i].series != s) continue;
        bool off = ay.log && p->points[i].y <= 0;
        double x = plot_place(ax, plot_value(ax, p->points[i].x));
        double y = off ? ay.from : plot_place(ay, plot_value(ay, p->points[i].y));
        if (pen && !off) plot_line(out, px, py, x, y, style);
        plot_mark(out, s, x, y, off);
        pen = !off, px = x, py = y;
    }
    plot_line(out, 572, legend, 598, legend, style);
    plot_mark(out, s, 585, legend, false);
    plot_text(out, 604, legend + 4, "", p->name[s]);
}

/* Reference line k through the first point that has a place, and its entry in the legend. */
static inline void plot_reference(const plot *p, FILE *out, int k, plot_axis ax, plot_axis ay)
{
    const char *style = k ? "stroke=\"#555\" stroke-dasharray=\"8 4\""
                          : "stroke=\"#555\" stroke-dasharray=\"2 3\"";
    double legend = 62 + 20 * (p->series + k);
    size_t i = 0;
    while (i < p->n && ay.log && p->points[i].y <= 0) i++;
    if (i == p->n) return;
    double x0 = plot_value(ax, p->points[i].x), y0 = plot_value(ay, p->points[i].y);
    plot_line(out, ax.from, plot_place(ay, y0 + p->slope[k] * (ax.lowest - x0)),
              ax.to, plot_place(ay, y0 + p->slope[k] * (ax.highest - x0)), style);
    plot_line(out, 572, legend, 598, legend, style);
    plot_text(out, 604, legend + 4, "", p->name[plot_most_series + k]);
}

cold_inline void plot_write(const plot *p, FILE *out)
{
    plot_axis ax = plot_range(p, false, 80, 560), ay = plot_range(p, true, 370, 50);
    fprintf(out, "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 820 430\" width=\"820\" "
            "height=\"430\" font-family=\"sans-serif\" font-size=\"13\">\n"
            "<rect width=\"820\" height=\"430\" fill=\"white\"/>\n"
            "<clipPath id=\"area\"><path d=\"M79,49H820V371H79Z\"/></clipPath>\n");
    plot_text(out, 320, 28, "text-anchor=\"middle\" font-size=\"16\"", p->title);
    plot_text(out, 320, 412, "text-anchor=\"middle\"", p->x_label);
    plot_text(out, -210, 16, "text-anchor=\"middle\" transform=\"rotate(-90)\"", p->y_label);
    plot_ticks(out, ax, ay, false), plot_ticks(out, ay, ax, true);
    fprintf(out, "<path d=\"M80,50H560V370H80Z\" fill=\"none\" stroke=\"black\"/>\n");
    for (int k = 0; k < p->slopes; k++) plot_reference(p, out, k, ax, ay);
    for (int s = 0; s < p->series; s++) plot_curve(p, out, s, ax, ay);
    if (ay.hollow) plot_text(out, 604, 66 + 20 * (p->series + p->slopes), "", "hollow: 0");
    fprintf(out, "</svg>\n");
}
#endif
