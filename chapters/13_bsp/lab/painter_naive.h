/* painter_naive.h: the painter without a tree: whole triangles, sorted by distance.
 *
 *   painter_uncut(&m, &p)                     all triangles as they are; painter_free
 *   painter_order_naive(&p, eye, order)       all pieces by distance of their middles
 */
#ifndef PAINTER_NAIVE_H
#define PAINTER_NAIVE_H

#include "../painter.h"

/* ---------------------------------------------------------------------------------------------- */

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
