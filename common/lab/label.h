/* label.h: words and numbers in a picture of pixels; in an SVG, text is text.
 *
 *   label_text(&im, x, y, size, align, colour, "t_enter")   on the line y, capitals `size` pixels
 *                       high [>= 9 to be read]; x is its left end, middle or right end as align
 *                       is 0, 0.5 or 1; what sticks out of the picture is left out
 *   label_width("t_enter", size)                            [pixels]
 *   label_tag(&im, x, y, size, "first")                     black on white, upper left corner x, y
 *   label_titles(&im, columns, rows, gap, title)    a white sheet with a title above each panel,
 *                       row by row, takes the place of im, which holds columns x rows panels of one
 *                       size, `gap` pixels apart
 *   label_panel(&im, columns, rows, gap, k, &one)   puts panel k there; im = {0} before the first
 *   image sheet = label_sheet(width, height)                white
 *   label_below(&im, rows)                                  so many white rows more, below
 *   label_bar(&im, x, y, width, size, colour_of, low, high, "tests a ray")   false colours, from
 *                       the colour of 0 at `low` to that of 1 at `high`; with numbers 4.5 size high
 *
 * ASCII only; what is not is left out. Letters are strokes, smooth at every size, drawn for this
 * book: a point is a letter (a to i: 0 to 4 units right) and a digit (units up; 2 is the line, 8
 * the top of capitals, 6 that of "x", 0 the foot of "g"); a space lifts the pen.
 */
#ifndef LABEL_H
#define LABEL_H
#include "../image.h"

static const char *const label_glyph[95] = {
    "", "a8a4 a2", "a8a6 e8e6", "c2c8 g2g8 a4i4 a6i6", "g7e8c8a7a6c5e5g4g3e2c2a3 d9d1",
    "a8c8c6a6a8 g4i4i2g2g4 a2i8", "i2a6a7c8e7e6a4a3c2e2i4", "a8a6", "c9a7a3c1", "a9c7c3a1",
    "e4e8 a5i7 a7i5", "e3e7 a5i5", "c2a1", "a5e5", "a2", "a1g9", "c2e2g3g7e8c8a7a3c2",
    "a7c8c2 a2e2", "a7c8e8g7g6a2g2", "a8g8c5e5g4g3e2c2a3", "e2e8a4g4", "g8a8a5e5g4g3e2c2a3",
    "g7e8c8a7a3c2e2g3g4e5c5a4", "a8g8c2", "c5a6a7c8e8g7g6e5c5a4a3c2e2g3g4e5",
    "a3c2e2g3g7e8c8a7a6c5e5g6", "a5 a2", "c5 c2a1", "g7a5g3", "a6g6 a4g4", "a7g5a3",
    "a7c8e8g7g6d5d4 d2", "g4g6c6c4i4i7g8c8a7a3c2g2", "a2d8g2 b4f4", "a5e5g6g7e8a8a2e2g3g4e5",
    "g7e8c8a7a3c2e2g3", "a2a8e8g7g3e2a2", "g8a8a2g2 a5e5", "g8a8a2 a5e5", "g7e8c8a7a3c2e2g3g5c5",
    "a2a8 g2g8 a5g5", "a2a8", "e8e3c2a3", "a2a8 g8a4 c5g2", "a8a2g2", "a2a8e4i8i2", "a2a8g2g8",
    "c2g2i3i7g8c8a7a3c2", "a2a8e8g7g6e5a5", "c2g2i3i7g8c8a7a3c2 e4i1", "a2a8e8g7g6e5a5 c5g2",
    "g7e8c8a7a6c5e5g4g3e2c2a3", "a8i8 e8e2", "a8a3c2e2g3g8", "a8d2g8", "a8c2e6g2i8", "a2g8 a8g2",
    "a8d5g8 d5d2", "a8g8a2g2", "c9a9a1c1", "a9g1", "a9c9c1a1", "a6c8e6", "a1g1", "a8c7",
    "a6e6g5g2c2a3c4g4", "a8a2e2g3g5e6c6a5", "g5e6c6a5a3c2e2g3", "g8g2c2a3a5c6e6g5",
    "a4g4g5e6c6a5a3c2e2g3", "e8c7c2 a6e6", "g3e2c2a3a5c6e6g5 g6g1e0a0", "a8a2 a5c6e6g5g2",
    "a6a2 a8", "c6c1a0 c8", "a8a2 e6a4e2", "a8a3b2", "a6a2 a5c6e5e2 e5g6i5i2", "a6a2 a5c6e6g5g2",
    "c2e2g3g5e6c6a5a3c2", "a6a0 a5c6e6g5g3e2c2a3", "g6g0 g5e6c6a5a3c2e2g3", "a6a2 a5c6e6",
    "g6c6a5c4e4g3e2a2", "c8c3e2 a6e6", "a6a3c2e2g3 g6g2", "a6d2g6", "a6c2e5g2i6", "a6g2 a2g6",
    "a6a3c2e2g3 g6g1e0a0", "a6g6a2g2", "e9c8c6a5c4c2e1", "a9a1", "a9c8c6e5c4c2a1", "a4c5e4g5",
};

/* ---------------------------------------------------------------------------------------------- */
static inline const char *label_strokes(char c)
{
    return c > 32 && c < 127 ? label_glyph[c - 32] : "";
}

/* Units to the next letter: its own width, and 1.75 between; 2.5 for a space. */
static inline double label_advance(char c)
{
    int most = -1;  /* in half units */
    for (const char *s = label_strokes(c); *s; s++)
        if (*s >= 'a' && *s - 'a' > most) most = *s - 'a';
    return c == ' ' ? 2.5 : most < 0 ? 0 : most / 2.0 + 1.75;
}

static inline double label_width(const char *text, double size)
{
    double units = 0;
    for (const char *s = text; *s; s++) units += label_advance(*s);
    return units > 0 ? (units - 1.75) * size / 6 : 0;
}

/* From (x, y), in units, to the nearest point of the strokes, in units. */
static inline double label_distance(const char *strokes, double x, double y)
{
    double least = HUGE_VAL, fx = 0, fy = 0;
    bool pen = false;
    for (const char *s = strokes; *s; s += *s == ' ' ? 1 : 2) {
        if (*s == ' ') { pen = false; continue; }
        double tx = (s[0] - 'a') / 2.0, ty = s[1] - '2';
        if (!pen) fx = tx, fy = ty;
        double wx = tx - fx, wy = ty - fy, ww = wx * wx + wy * wy;
        double t = ww > 0 ? fmin(fmax(((x - fx) * wx + (y - fy) * wy) / ww, 0), 1) : 0;
        least = fmin(least, hypot(x - fx - t * wx, y - fy - t * wy));
        fx = tx, fy = ty, pen = true;
    }
    return least;
}

static inline void label_letter(image *im, double x, double y, double size, vec3 colour, char c)
{
    double unit = size / 6, half = fmax(size / 14, 0.7), right = x + label_advance(c) * unit;
    int x0 = (int)(x - half) - 1, x1 = (int)(right + half) + 1;
    int y0 = (int)(y - 7 * unit - half) - 1, y1 = (int)(y + 2 * unit + half) + 1;
    for (int j = y0 > 0 ? y0 : 0; j <= y1 && j < im->height; j++)
        for (int i = x0 > 0 ? x0 : 0; i <= x1 && i < im->width; i++) {
            double u = (i + 0.5 - x) / unit, v = (y - j - 0.5) / unit;
            double cover = half + 0.5 - unit * label_distance(label_strokes(c), u, v);
            vec3 under = image_get(im, i, j), change = vsub(colour, under);
            if (cover > 0) image_set(im, i, j, vmadd(under, change, (real)fmin(cover, 1)));
        }
}

static inline void label_text(image *im, double x, double y, double size, double align,
                              vec3 colour, const char *text)
{
    x -= align * label_width(text, size);
    for (; *text; text++) {
        label_letter(im, x, y, size, colour, *text);
        x += label_advance(*text) * size / 6;
    }
}

static inline void label_fill(image *im, int x, int y, int width, int height, vec3 colour)
{
    for (int j = y > 0 ? y : 0; j < y + height && j < im->height; j++)
        for (int i = x > 0 ? x : 0; i < x + width && i < im->width; i++)
            image_set(im, i, j, colour);
}

static inline void label_tag(image *im, int x, int y, double size, const char *text)
{
    label_fill(im, x, y, (int)(label_width(text, size) + size), (int)(2 * size), vec(1, 1, 1));
    label_text(im, x + size / 2, y + 1.5 * size, size, 0, vec(0, 0, 0), text);
}

static inline image label_sheet(int width, int height)
{
    image sheet = image_new(width, height);
    label_fill(&sheet, 0, 0, width, height, vec(1, 1, 1));
    return sheet;
}

static inline void label_titles(image *im, int columns, int rows, int gap, const char *const *title)
{
    enum { size = 12, strip = 26 };  /* of the titles [pixels] */
    int w = (im->width + gap) / columns, h = (im->height + gap) / rows;
    image sheet = label_sheet(im->width, im->height + rows * strip);
    for (int k = 0; k < columns * rows; k++) {
        int x = k % columns * w, from = k / columns * h, y = k / columns * (h + strip);
        for (int j = 0; j < h - gap; j++)
            memcpy(image_pixel(&sheet, x, y + strip + j), image_pixel(im, x, from + j),
                   (size_t)(w - gap) * 3 * sizeof(float));
        label_text(&sheet, x + (w - gap) / 2.0, y + 18, size, 0.5, vec(0, 0, 0), title[k]);
    }
    image_free(im), *im = sheet;
}

static inline void label_panel(image *im, int columns, int rows, int gap, int k, const image *one)
{
    int w = one->width + gap, h = one->height + gap;
    if (!im->rgb) *im = label_sheet(columns * w - gap, rows * h - gap);
    image_place(im, k % columns * w, k / columns * h, one);
}

static inline void label_below(image *im, int rows)
{
    image sheet = label_sheet(im->width, im->height + rows);
    image_place(&sheet, 0, 0, im);
    image_free(im), *im = sheet;
}

static inline void label_bar(image *im, int x, int y, int width, double size,
                             vec3 (*colour_of)(real), double low, double high, const char *name)
{
    const vec3 black = {0, 0, 0};
    double base = y + 3.5 * size;
    char text[2][32];
    for (int i = 0; i < width; i++)
        label_fill(im, x + i, y, 1, (int)(2 * size), colour_of((real)((i + 0.5) / width)));
    snprintf(text[0], sizeof text[0], "%.3g", low), snprintf(text[1], sizeof text[1], "%.3g", high);
    label_text(im, x, base, size, 0, black, text[0]);
    label_text(im, x + width, base, size, 1, black, text[1]);
    label_text(im, x + width / 2.0, base, size, 0.5, black, name);
}

#endif
