/* nff.h: reads NFF, the Neutral File Format of the Standard Procedural Databases, item by item.
 *
 *   v  from x y z  at x y z  up x y z  angle a  hither h  resolution w h       the view
 *   b  r g b                               background
 *   l  x y z [r g b]                       light; of L lights without colour each has sqrt(L) / 2L
 *   f  r g b Kd Ks Shine T ior             what comes next is made of this
 *   s  x y z r                             sphere; r < 0: seen from inside
 *   c  x y z r  x y z r                    cone or cylinder, open: base, then apex
 *   p  n  x y z ..                         polygon, n corners, concave ones too
 *   pp n  x y z nx ny nz ..                patch: the same with a normal at each corner
 *
 * Between the tokens there is white space, ends of lines too, as much as one likes; # begins a
 * comment. angle: full, in degrees (0, 180); hither and resolution may be missing.
 *
 *   nff_reader r;
 *   if (!nff_begin(&r, stream, "balls.nff", &f)) return false;
 *   while (nff_next(&r)) use(&r.item);              r.item.kind, .line, and what that kind has
 *   return nff_end(&r);                             false and *f if anything went wrong
 *
 *   nff_refuse(&r, what, allowed)      what the caller cannot use: nff_next is false from here on
 *   nff_plain_light(L)                 strength of each of L lights without colour
 *
 * item.corner and item.normal stay until the next item. Broken: "FILE:LINE: s: not a number: 'x',
 * allowed: ..", exit code 2. Memory: a fixed multiple of the longest polygon.
 *
 * Source: E. Haines, Standard Procedural Databases, 1987 to 2004: NFF.TXT.
 */
#ifndef MESH_NFF_H
#define MESH_NFF_H

#include "../cone.h"
#include "../../03_sphere/sphere.h"
#include "words.h"

typedef enum {
    NFF_VIEW, NFF_BACKGROUND, NFF_LIGHT, NFF_FILL, NFF_SPHERE, NFF_CONE, NFF_POLYGON, NFF_PATCH,
    nff_kinds
} nff_kind;

typedef struct { vec3 from, at, up; real angle, hither, width, height; } nff_view;
typedef struct { vec3 at, colour; bool plain; } nff_light;              /* plain: no colour said */
typedef struct { vec3 colour; real kd, ks, shine, transmit, ior; } nff_fill;

typedef struct {
    nff_kind kind;
    size_t line;                 /* where it begins */
    nff_view view;
    vec3 background;
    nff_light light;
    nff_fill fill;
    sphere sphere;
    cone cone;
    vec3 *corner, *normal;       /* [corners] of polygon and patch; a polygon's normals are 0 */
    size_t corners;
} nff_item;

typedef struct {
    text_reader t;
    nff_item item;
    size_t corner_room, normal_room;
} nff_reader;

/* ---------------------------------------------------------------------------------------------- */

/* ---- numbers, on this line or the next ones ---- */

static inline bool nff_number(nff_reader *r, real *out, double lowest, double highest)
{
    (void)word_more(&r->t);
    return word_number(&r->t, out, lowest, highest);
}

static inline bool nff_any(nff_reader *r, real *out)
{
    return nff_number(r, out, -word_largest, word_largest);
}

static inline bool nff_point(nff_reader *r, vec3 *p)
{
    return nff_any(r, &p->x) && nff_any(r, &p->y) && nff_any(r, &p->z);
}

static inline bool nff_colour(nff_reader *r, vec3 *out)
{
    return nff_number(r, &out->x, 0, 1e30) && nff_number(r, &out->y, 0, 1e30)
        && nff_number(r, &out->z, 0, 1e30);
}

/* ---- the items, behind their letter ---- */

static inline bool nff_read_view(nff_reader *r, nff_view *v)
{
    enum { FROM, AT, UP, ANGLE, HITHER, RESOLUTION, parts };
    static const char *const words[parts] = {"from", "at", "up", "angle", "hither", "resolution"};
    const unsigned needed = 1u << FROM | 1u << AT | 1u << UP | 1u << ANGLE;
    unsigned seen = 0;
    *v = (nff_view){.hither = 0};
    while (word_more(&r->t)) {
        int k = 0;
        bool ok = true;
        while (k < parts && !text_is(&r->t, words[k])) k++;
        if (k == parts) break;
        r->t.p += strlen(r->t.keyword = words[k]);
        seen |= 1u << k;
        switch (k) {
        case FROM: ok = nff_point(r, &v->from); break;
        case AT: ok = nff_point(r, &v->at); break;
        case UP: ok = nff_point(r, &v->up); break;
        case ANGLE: ok = nff_number(r, &v->angle, 1e-6, 179.999); break;
        case HITHER: ok = nff_number(r, &v->hither, 0, word_largest); break;
        default: ok = nff_number(r, &v->width, 1, 65536) && nff_number(r, &v->height, 1, 65536);
        }
        if (!ok) return false;
    }
    r->t.keyword = "v";
    return (seen & needed) == needed
        || text_bad(&r->t, r->t.p, "from, at, up or angle is missing before", "all four");
}

static inline bool nff_read_light(nff_reader *r, nff_light *l)
{
    if (!nff_point(r, &l->at)) return false;
    l->plain = !(word_more(&r->t) && word_is_number(&r->t));
    return l->plain || nff_colour(r, &l->colour);
}

static inline bool nff_read_fill(nff_reader *r, nff_fill *x)
{
    return nff_colour(r, &x->colour) && nff_number(r, &x->kd, 0, 1e9)
        && nff_number(r, &x->ks, 0, 1e9) && nff_number(r, &x->shine, 0, 1e9)
        && nff_number(r, &x->transmit, 0, 1) && nff_number(r, &x->ior, 0, 10);
}

static inline bool nff_read_cone(nff_reader *r, cone *c)
{
    return nff_point(r, &c->a) && nff_any(r, &c->ra) && nff_point(r, &c->b) && nff_any(r, &c->rb);
}

/* The list of corners, `normals` if each has one. */
static inline bool nff_read_corners(nff_reader *r, bool normals)
{
    nff_item *x = &r->item;
    real count;
    if (!nff_number(r, &count, 3, 1e9)) return false;
    x->corners = (size_t)count;
    if ((real)x->corners != count)
        return text_bad(&r->t, r->t.p, "not a whole number before", "3 or more");
    for (size_t i = 0; i < x->corners; i++) {
        x->corner = grown_for(r->t.name, x->corner, i, 1, &r->corner_room, sizeof *x->corner);
        x->normal = grown_for(r->t.name, x->normal, i, 1, &r->normal_room, sizeof *x->normal);
        x->normal[i] = (vec3){0, 0, 0};
        if (!nff_point(r, &x->corner[i]) || (normals && !nff_point(r, &x->normal[i]))) return false;
    }
    return true;
}

static inline bool nff_read_item(nff_reader *r)
{
    static const char *const words[nff_kinds] = {"v", "b", "l", "f", "s", "c", "p", "pp"};
    nff_item *x = &r->item;
    int k = 0;
    x->line = r->t.line;
    while (k < nff_kinds && !text_is(&r->t, words[k])) k++;
    if (k == nff_kinds)
        return text_bad(&r->t, r->t.p, "begins with", "v, b, l, f, s, c, p, pp or #");
    r->t.p += strlen(r->t.keyword = words[k]);
    switch (x->kind = (nff_kind)k) {
    case NFF_VIEW: return nff_read_view(r, &x->view);
    case NFF_BACKGROUND: return nff_colour(r, &x->background);
    case NFF_LIGHT: return nff_read_light(r, &x->light);
    case NFF_FILL: return nff_read_fill(r, &x->fill);
    case NFF_SPHERE: return nff_point(r, &x->sphere.c) && nff_any(r, &x->sphere.r);
    case NFF_CONE: return nff_read_cone(r, &x->cone);
    default: return nff_read_corners(r, x->kind == NFF_PATCH);
    }
}

/* ---- the file ---- */

static inline bool nff_begin(nff_reader *r, FILE *in, const char *path, failure *f)
{
    *r = (nff_reader){.corner_room = 0};
    return text_begin(&r->t, in, path, f);
}

static inline bool nff_next(nff_reader *r)
{
    r->t.keyword = "line";
    return !r->t.bad && word_more(&r->t) && nff_read_item(r);
}

static inline bool nff_refuse(nff_reader *r, const char *what, const char *allowed)
{
    return text_bad(&r->t, r->t.p, what, allowed);
}

static inline bool nff_end(nff_reader *r)
{
    free(r->item.corner), free(r->item.normal);
    return text_end(&r->t);
}

static inline real nff_plain_light(size_t lights)
{
    return sqrt((real)lights) / (2 * (real)lights);
}

#endif
