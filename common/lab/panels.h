/* panels.h: pictures side by side: one function of the place, several things to look at.
 *
 *   panel p[] = {{"first.h", &naive}, {"sphere_hit", &robust}};      names and contexts
 *   panels_shape g = {.width = 960, .height = 400, .columns = 2, .rows = 1, .gap = 6, .side = 2};
 *   panels_draw(&o, "03_sphere.png", true, g, colour, p);     names above; g.tags: in the panels
 *   image sheet = panels_new(&o, g, colour, p, &whole);       for who draws more into it
 *   panels_save(&o, &sheet, 2, 1, 6, title, "21_box.png", whole);    of a sheet drawn otherwise
 *                             (label_panel): its titles, a picture that is not the main one; freed
 *
 * `columns` x `rows` of them, `gap` pixels apart, fill width x height. colour: pixels.h, at side x
 * side places a pixel. Tags for which a small panel has no room are left out.
 */
#ifndef PANELS_H
#define PANELS_H

#include "../output.h"
#include "label.h"
#include "pixels.h"

enum { panels_most = 12 };
typedef struct { const char *name; const void *context; } panel;
typedef struct { int width, height, columns, rows, gap, side; bool tags; } panels_shape;

/* ---------------------------------------------------------------------------------------------- */

/* Of a panel, rounded up: the last ones may be cut. */
static inline int panels_wide(panels_shape g)
{
    return (g.width + g.gap + g.columns - 1) / g.columns - g.gap;
}
static inline int panels_high(panels_shape g)
{
    return (g.height + g.gap + g.rows - 1) / g.rows - g.gap;
}

static inline image panels_new(const options *o, panels_shape g, pixels_colour *colour,
                               const panel *p, bool *whole)
{
    const char *title[panels_most];
    int w = panels_wide(g), h = panels_high(g), n = g.columns * g.rows;
    image sheet = label_sheet(g.width, g.height), one = image_new(w, h);
    *whole = true;
    for (int k = 0; k < n && *whole; k++) {
        int x = k % g.columns * (w + g.gap), y = k / g.columns * (h + g.gap);
        *whole = pixels_draw(&one, g.side, o->threads, "panels", colour, p[k].context);
        image_place(&sheet, x, y, &one);
        if (g.tags && w >= 200 && h >= 100) label_tag(&sheet, x + 10, y + 10, 12, p[k].name);
        title[k] = p[k].name;
    }
    if (!g.tags && *whole) label_titles(&sheet, g.columns, g.rows, g.gap, title);
    image_free(&one);
    return sheet;
}

static inline void panels_draw(const options *o, const char *name, bool is_main, panels_shape g,
                               pixels_colour *colour, const panel *p)
{
    bool whole;
    image sheet = panels_new(o, g, colour, p, &whole);
    output_picture(o, &sheet, name, is_main, whole);
    image_free(&sheet);
}

static inline void panels_save(const options *o, image *sheet, int columns, int rows, int gap,
                               const char *const *title, const char *name, bool whole)
{
    label_titles(sheet, columns, rows, gap, title);
    output_picture(o, sheet, name, false, whole);
    image_free(sheet);
}

#endif
