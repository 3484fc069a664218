/* nff_world.h: reads a scene in NFF, the Neutral File Format of the Standard Procedural Databases,
 * as a world: its view, lights, colours and shapes. (27 reads the same format with all that a
 * picture takes: materials, patches with normals, scenes of many files.)
 *
 *   v  from x y z  at x y z  up x y z  angle a  hither h  resolution w h       the view
 *   b  r g b                               background
 *   l  x y z [r g b]                       light; its colour is dropped
 *   f  r g b Kd Ks Shine T ior             the colour of what comes next
 *   s  x y z r                             sphere
 *   c  x y z r  x y z r                    cone or cylinder: base, then apex
 *   p  n  x y z ..                         polygon of n corners; three are a triangle
 *   pp n  x y z nx ny nz ..                the same; normals are dropped
 *
 * Between the tokens there is white space, ends of lines too; # begins a comment.
 *
 *   if (!nff_world("balls.nff", &w, &f)) fail(f);     world_free(&w)
 *
 * "FILE:LINE: ..", exit code 2: broken, nothing in it, no view; cannot be read: 1. Of more than
 * world_most_lights lights the first are kept.
 *
 * Source: E. Haines, Standard Procedural Databases, 1987 to 2004: NFF.TXT.
 */
#ifndef MESH_NFF_WORLD_H
#define MESH_NFF_WORLD_H

#include "../../../common/numbers/text.h"
#include "../scenes/world.h"

typedef struct {
    text_reader t;
    world *w;
    size_t shape_room, corner_room, group_room;
    bool viewed;
} nff_world_reader;

/* ---------------------------------------------------------------------------------------------- */

/* To the next token, on whatever line. */
static inline bool nff_world_more(text_reader *t)
{
    while (!text_more(t)) {
        if (*t->p == '#') text_skip(t);
        if (text_finished(t)) return false;
        text_next_line(t);
    }
    return true;
}

static inline bool nff_world_numbers(nff_world_reader *r, real *x, int n)
{
    for (int k = 0; k < n; k++) {
        if (!nff_world_more(&r->t)) return text_bad(&r->t, r->t.p, "no number before", "a number");
        if (!text_number(&r->t, &x[k])) return false;
    }
    return true;
}

static inline bool nff_world_point(nff_world_reader *r, vec3 *p)
{
    return nff_world_numbers(r, &p->x, 3);
}

static inline bool nff_world_view(nff_world_reader *r)
{
    static const char *const words[] = {"from", "at", "up", "angle", "hither", "resolution"};
    vec3 p[3] = {{0, 0, 0}};
    real number[2] = {0, 0}, angle = 0;
    unsigned seen = 0;
    while (nff_world_more(&r->t)) {
        int k = 0;
        while (k < 6 && !text_is(&r->t, words[k])) k++;
        if (k == 6) break;
        r->t.p += strlen(words[k]);
        seen |= 1u << k;
        bool ok = k < 3 ? nff_world_point(r, &p[k]) : nff_world_numbers(r, number, k == 5 ? 2 : 1);
        if (!ok) return false;
        if (k == 3) angle = number[0];
    }
    if ((seen & 15) != 15 || !(angle > 0 && angle < 180))
        return text_bad(&r->t, r->t.p, "from, at, up or angle is missing before", "all four");
    r->viewed = true;
    return world_look(r->w, p[0], p[1], p[2], angle, r->t.f);
}

static inline void nff_world_add(nff_world_reader *r, shape s)
{
    world *w = r->w;
    w->shape = grown(w->shape, w->n, &r->shape_room, sizeof *w->shape);
    w->shape[w->n++] = s;
}

/* Corners move as their array grows: until the file is read, `n` is known and `v` is not. */
static inline bool nff_world_polygon(nff_world_reader *r, bool normals)
{
    real number = 0, normal[3];
    vec3 p[3];
    if (!nff_world_numbers(r, &number, 1)) return false;
    if (!(number >= 3 && number <= 1000000 && number == floor(number)))
        return text_bad(&r->t, r->t.p, "no count of corners before", "whole numbers from 3");
    size_t n = (size_t)number;
    for (size_t k = 0; k < n; k++) {
        vec3 *at = &p[k % 3];
        if (!nff_world_point(r, at) || (normals && !nff_world_numbers(r, normal, 3))) return false;
        if (n == 3) continue;
        r->w->corner = grown(r->w->corner, r->w->corners, &r->corner_room, sizeof *at);
        r->w->corner[r->w->corners++] = *at;
    }
    if (n == 3) nff_world_add(r, shape_of_triangle((triangle){p[0], p[1], p[2]}));
    else nff_world_add(r, (shape){.kind = SHAPE_POLYGON, .polygon = {.n = (uint32_t)n}});
    return true;
}

static inline bool nff_world_statement(nff_world_reader *r)
{
    static const char *const words[] = {"v", "b", "l", "f", "s", "c", "pp", "p"};
    world *w = r->w;
    real x[8];
    vec3 p;
    int k = 0;
    while (k < 8 && !text_is(&r->t, words[k])) k++;
    if (k == 8) return text_bad(&r->t, r->t.p, "begins with", "v, b, l, f, s, c, p, pp or #");
    r->t.p += strlen(r->t.keyword = words[k]);
    switch (k) {
    case 0: return nff_world_view(r);
    case 1: return nff_world_point(r, &w->background);
    case 2:
        if (!nff_world_point(r, &p)) return false;
        if (w->lights < world_most_lights) world_light(w, p);
        text_skip(&r->t);
        return true;
    case 3:
        if (!nff_world_numbers(r, x, 8)) return false;
        w->group = grown(w->group, w->groups, &r->group_room, sizeof *w->group);
        world_paint(w, (finish){{x[0], x[1], x[2]}, x[3], x[4], x[5], x[6], x[7]});
        return true;
    case 4:
        if (!nff_world_numbers(r, x, 4)) return false;
        nff_world_add(r, shape_of_sphere((sphere){{x[0], x[1], x[2]}, x[3]}));
        return true;
    case 5:
        if (!nff_world_numbers(r, x, 8)) return false;
        nff_world_add(r, shape_of_cone((cone){{x[0], x[1], x[2]}, x[3], {x[4], x[5], x[6]}, x[7]}));
        return true;
    default: return nff_world_polygon(r, k == 6);
    }
}

/* The first group must begin at 0; without lights one is beside the eye. */
static inline void nff_world_finish(nff_world_reader *r)
{
    world *w = r->w;
    size_t at = 0;
    for (size_t i = 0; i < w->n; i++)
        if (w->shape[i].kind == SHAPE_POLYGON) {
            size_t n = w->shape[i].polygon.n;
            w->shape[i] = shape_of_polygon(polygon_of(w->corner + at, n));
            at += n;
        }
    w->group = grown(w->group, w->groups, &r->group_room, sizeof *w->group);
    if (w->groups == 0)
        w->group[w->groups++].finish = (finish){{(real)0.8, (real)0.8, (real)0.8}, 1, 0, 0, 0, 0};
    w->group[0].first = 0;
    if (w->lights == 0) world_light(w, vadd(w->from, vec(1, 1, 1)));
    w->light_each = sqrt((real)w->lights) / (2 * (real)w->lights);
}

static inline bool nff_world(const char *path, world *w, failure *f)
{
    *w = (world){.name = path, .background = {(real)0.078, (real)0.361, (real)0.753}};
    nff_world_reader r = {.w = w};
    FILE *in = file_open(path, f);
    if (!in) return false;
    bool ok = text_begin(&r.t, in, path, f);
    if (ok) {
        while (ok && (r.t.keyword = "line", nff_world_more(&r.t))) ok = nff_world_statement(&r);
        ok = text_end(&r.t) && ok;
    }
    fclose(in);
    if (ok && w->n == 0) ok = failed(f, 2, "%.300s: no shape in it", path);
    if (ok && !r.viewed) ok = failed(f, 2, "%.300s: no view (v) in it", path);
    if (ok) nff_world_finish(&r);
    else world_free(w);
    return ok;
}

#endif
