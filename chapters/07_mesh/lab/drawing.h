/* drawing.h: a house of three triangles, and the two arrays that are all a computer knows of it.
 *
 *   draw_arrays(&o, "07_mesh_arrays.svg");    read from the text that the drawing shows
 */
#ifndef MESH_LAB_DRAWING_H
#define MESH_LAB_DRAWING_H

#include "../../../common/lab/figure.h"
#include "../files/obj.h"

/* ---------------------------------------------------------------------------------------------- */

enum { arrays_top = 62, arrays_row = 27 };  /* [pixels] of the first row, and from row to row */

static inline void arrays_text(figure *g, double x, int row, const char *colour, const char *text)
{
    figure_origin(g, 0, 0, 1);
    figure_text(g, x, -(double)(arrays_top + row * arrays_row), 0, 0, FIGURE_LEFT, colour, text);
}

/* Triangle i of m at 84 pixels a unit. */
static inline void arrays_triangle(figure *g, const mesh *m, size_t i, const char *colour)
{
    triangle t = mesh_triangle(m, i);
    double xy[6] = {(double)t.a.x, (double)t.a.y, (double)t.b.x, (double)t.b.y, (double)t.c.x,
                    (double)t.c.y};
    figure_polygon(g, 3, xy, colour, 0.25, FIGURE_BLACK);
    figure_print(g, (xy[0] + xy[2] + xy[4]) / 3, (xy[1] + xy[3] + xy[5]) / 3, 0, 6, FIGURE_MIDDLE,
                 colour, "%zu", i);
}

cold_inline void draw_arrays(const options *o, const char *name)
{
    static const char *const line[] = {"v 0 0 0", "v 2 0 0", "v 2 1.6 0", "v 0 1.6 0",
                                       "v 1 2.6 0", "f 1 2 3 4", "f 4 3 5"};
    static const char *const colour[] = {FIGURE_BLUE, FIGURE_GREEN, FIGURE_RED};
    enum { lines = sizeof line / sizeof *line };
    char text[200] = "", cell[80];
    for (int i = 0; i < lines; i++) strcat(strcat(text, line[i]), "\n");
    mesh m;
    failure f;
    FILE *in = text_in_memory(text);
    if (!in || !obj_read_stream(in, name, UINT32_MAX, &m, &f)) die(1, "%s: no memory", name);
    fclose(in);

    figure g = figure_begin(o, name, 760, 330);
    arrays_text(&g, 30, -1, FIGURE_GREY, "file, from 1");
    for (int i = 0; i < lines; i++) arrays_text(&g, 30, i, FIGURE_BLACK, line[i]);
    arrays_text(&g, 180, -1, FIGURE_GREY, "index, from 0");
    for (size_t i = 0; i < m.triangles; i++) {
        const uint32_t *k = m.index + 3 * i;
        snprintf(cell, sizeof cell, "triangle %zu:   %u  %u  %u", i, k[0], k[1], k[2]);
        arrays_text(&g, 180, (int)i, colour[i], cell);
    }
    arrays_text(&g, 375, -1, FIGURE_GREY, "v: the points");
    uint32_t *last = m.index + 3 * (m.triangles - 1);
    for (size_t i = 0; i < m.vertices; i++) {
        bool used = i == last[0] || i == last[1] || i == last[2];
        snprintf(cell, sizeof cell, "*v*~%zu~ = (%g, %g, %g)", i, (double)m.v[i].x,
                 (double)m.v[i].y, (double)m.v[i].z);
        arrays_text(&g, 375, (int)i, used ? colour[m.triangles - 1] : FIGURE_BLACK, cell);
    }
    for (int k = 0; k < 3; k++) {  /* the last triangle's way from its indices to its points */
        double y = arrays_top + 2 * arrays_row - 5, to = arrays_top + last[k] * arrays_row - 5.0;
        figure_origin(&g, 0, 0, 1);
        figure_arrow(&g, 326, -y, 368, -to, colour[m.triangles - 1], 1.2);
    }
    figure_origin(&g, 555, 290, 84);
    for (size_t i = 0; i < m.triangles; i++) arrays_triangle(&g, &m, i, colour[i]);
    for (size_t i = 0; i < m.vertices; i++) {
        double x = (double)m.v[i].x, y = (double)m.v[i].y;
        figure_dot(&g, x, y, 4, FIGURE_BLACK);
        figure_print(&g, x, y, x < 1 ? -8 : x > 1 ? 8 : 0, y < 1 ? 20 : x == 1 ? -10 : 5,
                     x < 1 ? FIGURE_RIGHT : x > 1 ? FIGURE_LEFT : FIGURE_MIDDLE, FIGURE_BLACK,
                     "*v*~%zu~", i);
    }
    figure_end(&g);
    mesh_free(&m);
}

#endif
