/* patch.h: a few triangles as lines meet them: by edges and planes (Plücker coordinates).
 *
 *      c ----- .     A patch is a triangle a b c, or two, a b c and the other half of the
 *     / \     /      parallelogram, as the faces of boxes are. For a ray o + t d, m = o x d:
 *    /   \   /
 *   a ---- b           e1 = d . (a x b) + m . (b - a),   e2 = d . (c x a) + m . (a - c)    (15.10)
 *                      D = d . n,   n = (b - a) x (c - a),   t = n . (a - o) / D           (15.11)
 *
 *   e2 / D and e1 / D are the weights of b and c: a b c is met if neither is negative and their
 *   sum is at most 1; the other half if neither is above 1 and their sum is at least 1. Nothing
 *   here depends on the axis along which d is longest, as (4.9) does: so rays of all directions
 *   can be asked side by side (packet.h).
 *
 *   bvh8_patches_of(&w, item, n)        of the n items [1..bvh8_few] that w holds; into w.patch
 *
 * Where memory is short there are none, and w.room says so.
 */
#ifndef WIDE_PATCH_H
#define WIDE_PATCH_H

#include "tree8.h"

enum { bvh8_few = 64 };  /* so many triangles, or fewer, are patches, too */
typedef struct bvh8_patch {
    float edge[2][6], n[3], to;  /* (15.10): factors of d, of m; (15.11): to = n . a */
    float size;                  /* what the largest of an edge, or of a plane, add up to */
    uint32_t items, index[2];    /* one or two triangles */
} bvh8_patch;

/* A ray of many, and its answer (packet.h). */
typedef struct {
    const ray *r;
    bvh8_skip skip;
    hit h;
    bool met;
} bvh8_query;

/* ---------------------------------------------------------------------------------------------- */

static inline real patch_largest(vec3 a) { return fabs(vaxis(a, vlongest(a))); }

static inline void patch_floats(vec3 a, float *out)
{
    out[0] = (float)a.x, out[1] = (float)a.y, out[2] = (float)a.z;
}

/* Edge a b of (15.10); *size: what its numbers may add up to. */
static inline void patch_edge(vec3 a, vec3 b, float *edge, real *size)
{
    vec3 moment = vcross(a, b), along = vsub(b, a);
    patch_floats(moment, edge), patch_floats(along, edge + 3);
    *size = real_max(*size, patch_largest(moment) + patch_largest(along));
}

/* Of triangle i, its corner number `a` first. */
static inline bvh8_patch patch_of(const bvh8 *w, uint32_t i, int a)
{
    triangle t = mesh_triangle(w->x.m, i);
    const vec3 corner[3] = {t.a, t.b, t.c};
    vec3 p[3];
    for (int k = 0; k < 3; k++) p[k] = frame_into(&w->frame, corner[(a + k) % 3]);
    vec3 n = vcross(vsub(p[1], p[0]), vsub(p[2], p[0]));
    real to = vdot(n, p[0]), size = fabs(to) + patch_largest(n);
    bvh8_patch patch = {.to = (float)to, .items = 1, .index = {i, no_shape}};
    patch_floats(n, patch.n);
    patch_edge(p[0], p[1], patch.edge[0], &size);
    patch_edge(p[2], p[0], patch.edge[1], &size);
    patch.size = (float)size * (1 + 0x1p-22f);
    return patch;
}

/* The corner of p that is none of q; -1 unless there is just one. */
static inline int patch_apex(const vec3 *p, const vec3 *q)
{
    int apex = -1, alone = 0;
    for (int i = 0; i < 3; i++) {
        bool shared = false;
        for (int j = 0; j < 3; j++) shared |= vzero(vsub(p[i], q[j]));
        if (!shared) apex = i, alone++;
    }
    return alone == 1 ? apex : -1;
}

/* Is triangle j the other half of i's parallelogram, but for some roundings? *a: i's corner that is
 * not on the diagonal. */
static inline bool patch_halves(const bvh8 *w, uint32_t i, uint32_t j, int *a)
{
    triangle t = mesh_triangle(w->x.m, i), u = mesh_triangle(w->x.m, j);
    const vec3 p[3] = {t.a, t.b, t.c}, q[3] = {u.a, u.b, u.c};
    int far = patch_apex(q, p);
    *a = patch_apex(p, q);
    if (*a < 0 || far < 0) return false;
    vec3 s = vadd(frame_into(&w->frame, p[*a]), frame_into(&w->frame, q[far]));
    for (int k = 1; k < 3; k++) s = vsub(s, frame_into(&w->frame, p[(*a + k) % 3]));
    return patch_largest(s) <= 8 * real_epsilon;
}

static inline void bvh8_patches_of(bvh8 *w, const bvh_item *item, size_t n)
{
    w->patch = memory_array(&w->room, n, sizeof *w->patch);
    for (size_t i = 0; w->patch && i < n; i++) {
        int a = 0;
        bool two = i + 1 < n && patch_halves(w, item[i].index, item[i + 1].index, &a);
        bvh8_patch *p = &w->patch[w->patches++];
        *p = patch_of(w, item[i].index, two ? a : 0);
        if (two) p->items = 2, p->index[1] = item[++i].index;
    }
}

#endif
