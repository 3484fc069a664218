/* naive.h: two searches of the BSP tree that lose hits, with the signature of bsp_hit; and the
 * painter without a tree: whole triangles, sorted by distance.
 *
 *   bsp_hit_naive(&b, r, &h)                     planes without padding: loses hits
 *   bsp_hit_first(&b, r, &h)                     the first leaf's hit as final: wrong hits
 *   painter_uncut(&m, &p)                        all triangles as they are; painter_free
 *   painter_order_naive(&p, eye, order)          all pieces by distance of their middles
 */
#ifndef BSP_NAIVE_H
#define BSP_NAIVE_H

#include "../bsp.h"
#include "../painter.h"

/* ---------------------------------------------------------------------------------------------- */

/* Dyadic faces, corners and rays (tests): t of the plane and of the hit on it are equal, or a hair
 * apart, and the side that has the item is left before the hit. */
static inline bool bsp_hit_naive(const bsp *b, ray r, hit *out)
{
    return bsp_walk(b, r, 0, false, false, out, NULL);
}

/* A large triangle that is named by the first leaf and hit behind it, beyond a small one that
 * only the second leaf names. */
static inline bool bsp_hit_first(const bsp *b, ray r, hit *out)
{
    return bsp_walk(b, r, 2, false, true, out, NULL);
}

static inline void painter_uncut(const mesh *m, painter *out)
{
    const items x = items_of_mesh(m);
    *out = (painter){0};
    painter_begin(out, &x);
    out->piece = out->w.f, out->pieces = out->w.fragments;
    out->w.f = NULL, out->w.x = NULL;
}

typedef struct { real far; uint32_t piece; } painter_key;

static inline int painter_key_order(const void *a, const void *b)
{
    const painter_key *x = a, *y = b;
    return x->far != y->far ? (x->far < y->far) - (x->far > y->far)
                            : (x->piece > y->piece) - (x->piece < y->piece);
}

/* Three triangles, each over the next (cyclic_mesh): any order of whole triangles is wrong. */
static inline size_t painter_order_naive(const painter *p, vec3 eye, uint32_t *order)
{
    painter_key *key = allocate(p->pieces, sizeof *key);
    vec3 e = workshop_place(&p->w, eye);
    for (size_t i = 0; i < p->pieces; i++) {
        vec3 sum = {0, 0, 0};
        const fragment *x = &p->piece[i];
        for (uint32_t k = 0; k < x->corners; k++) sum = vadd(sum, p->w.corner[x->corner + k]);
        key[i] = (painter_key){vlength(vsub(vscale(sum, 1 / (real)x->corners), e)), (uint32_t)i};
    }
    qsort(key, p->pieces, sizeof *key, painter_key_order);
    for (size_t i = 0; i < p->pieces; i++) order[i] = key[i].piece;
    free(key);
    return p->pieces;
}

#endif
