/* painter.h: the painter's algorithm (画家算法): back to front, each over what is behind it, from any
 * eye: what BSP trees were made for.
 *
 *        plane of P            An eye in front of the plane of P sees what lies behind it first
 *   back    |    front         covered: draw the back, then P, then the front. And so on, in both
 *           P     .eye         halves. What the plane cuts is cut into two pieces (碎片).    (13.5)
 *
 *   painter p;
 *   bool painter_build(&m, painter_defaults, &p, &f)   false: too many pieces, no candidates
 *   size_t n = painter_order(&p, eye, order)           all pieces, farthest first; order[p.pieces]
 *   painter_free(&p)                                   a zeroed one may be freed
 *
 *   p.piece[k]      corners p.corner[first .. first + corners - 1], of triangle `owner`
 *   how.rule        PAINTER_FIRST: planes in the order of the mesh; RANDOM; FEWEST: of `candidates`
 *   how.candidates  drawn, the one that cuts the fewest [>= 1]
 *   how.most        pieces; more, and painter_build fails (exit code 2)
 *
 * The tree is built once and serves every eye: O(pieces) an order, no sorting, no depths. Sorting
 * by distance cannot do it: three triangles, each over the next, have no order at all until one is
 * cut; and a long one beside a short one has its middle in the wrong place.
 *
 * A piece within 64 eps size of a plane is in it and drawn with it: corners may be 6 eps off their
 * own plane (side.h), and each cut on the way adds 2.6. Triangles that lie closer than that over
 * each other have no order. Those without area or with a NaN are no pieces at all. The mesh may be
 * up to real_largest / 2 wide.
 *
 * How many pieces? Paterson & Yao: n triangles can force n^2 (two crossing rows of walls do); n
 * walls that do not cross, in random order, make on average at most n + 2 n ln n           (13.6)
 * since wall j is cut by the plane of i only if i comes before all walls between them.
 *
 * Sources: H. Fuchs, Z. Kedem, B. Naylor, SIGGRAPH 1980; R. Schumacker et al., "Study for Applying
 * Computer-Generated Images to Visual Simulation", AFHRL-TR-69-14, 1969 (the idea); M. Paterson,
 * F. Yao 1990 (see choose.h).
 */
#ifndef PAINTER_H
#define PAINTER_H

#include "../07_mesh/mesh.h"
#include "../../common/random.h"
#include "side.h"

typedef enum { PAINTER_FIRST, PAINTER_RANDOM, PAINTER_FEWEST, painter_rules } painter_rule;
typedef struct { painter_rule rule; int candidates; uint64_t seed; size_t most; } painter_options;
#define painter_defaults ((painter_options){PAINTER_FEWEST, 16, 1, 10000000})

typedef struct { uint32_t first, corners, owner; } painter_piece;
typedef struct { split_plane p; uint32_t back, front, piece, pieces; } painter_node;
typedef struct {
    vec3 middle;           /* corners and planes are relative to it */
    vec3 *corner;
    painter_piece *piece;  /* those in one plane in a row */
    painter_node *node;    /* back, front: UINT32_MAX for none; the root is node 0 */
    size_t corners, pieces, nodes, corner_room, piece_room, node_room;
} painter;

/* ---------------------------------------------------------------------------------------------- */

/* What is still to be put into nodes below one side of a node. */
typedef struct { painter_piece *piece; size_t n, room; uint32_t parent; bool front; } painter_list;

typedef struct {
    painter *p;
    const mesh *m;
    painter_options how;
    real e, scale;        /* scale: a power of two above all sides */
    painter_list *stack;
    size_t lists, room, waiting;
    random_stream g;
} painter_builder;

static inline void painter_free(painter *p)
{
    free(p->corner), free(p->piece), free(p->node);
    *p = (painter){0};
}

static inline void painter_reserve(painter *p, size_t corners)
{
    p->corner = grown_by(p->corner, p->corners, corners, &p->corner_room, sizeof *p->corner);
}

static inline void painter_push(painter_list *l, painter_piece x)
{
    l->piece = grown(l->piece, l->n, &l->room, sizeof *l->piece);
    l->piece[l->n++] = x;
}

/* Scaled, so that products neither overflow nor vanish. */
static inline split_plane painter_plane(const painter_builder *b, uint32_t owner)
{
    triangle t = mesh_triangle(b->m, owner);
    vec3 o = b->p->middle;
    real k = 1 / b->scale;
    split_plane p = plane_of_triangle(vscale(vsub(t.a, o), k), vscale(vsub(t.b, o), k),
                                      vscale(vsub(t.c, o), k));
    p.at *= b->scale;
    return p;
}

static inline plane_side painter_side(const painter_builder *b, const split_plane *p,
                                      painter_piece x)
{
    real lo, hi;
    side_range(p, b->p->corner + x.first, x.corners, &lo, &hi);
    return side_of_range(lo, hi, b->e);
}

static inline split_plane painter_choose(painter_builder *b, const painter_list *l, size_t *which)
{
    size_t fewest = SIZE_MAX;
    int tries = b->how.rule == PAINTER_FEWEST ? b->how.candidates : 1;
    split_plane best = {0};
    for (int k = 0; k < tries && fewest > 0; k++) {
        size_t i = b->how.rule == PAINTER_FIRST ? 0 : (size_t)(random_next_bits(&b->g) % l->n);
        split_plane p = painter_plane(b, l->piece[i].owner);
        size_t cuts = 0;
        for (size_t j = 0; tries > 1 && j < l->n; j++)
            cuts += painter_side(b, &p, l->piece[j]) == SIDE_BOTH;
        if (cuts < fewest) fewest = cuts, best = p, *which = i;
    }
    return best;
}

static inline void painter_half(painter_builder *b, const split_plane *p, real sign,
                                painter_piece x, painter_list *out)
{
    painter *t = b->p;
    painter_reserve(t, 2 * (size_t)x.corners);
    painter_piece part = {(uint32_t)t->corners, 0, x.owner};
    part.corners = (uint32_t)clip(p, sign, 0, t->corner + x.first, x.corners,
                                  t->corner + t->corners);
    if (part.corners < 3) return;
    t->corners += part.corners;
    painter_push(out, part);
}

/* What of the list lies on one side of node `at`. */
static inline painter_list painter_part(painter_builder *b, const painter_list *l, size_t which,
                                        uint32_t at, plane_side wanted)
{
    const split_plane p = b->p->node[at].p;
    painter_list out = {.parent = at, .front = wanted == SIDE_FRONT};
    for (size_t i = 0; i < l->n; i++) {
        painter_piece x = l->piece[i];
        plane_side s = i == which ? SIDE_ON : painter_side(b, &p, x);
        if (s == wanted) painter_push(&out, x);
        if (s == SIDE_BOTH) painter_half(b, &p, out.front ? -1 : 1, x, &out);
    }
    return out;
}

static inline void painter_wait(painter_builder *b, painter_list l)
{
    b->stack = grown(b->stack, b->lists, &b->room, sizeof *b->stack);
    b->stack[b->lists++] = l;
    b->waiting += l.n;
}

/* A node of the list: what lies in its plane is drawn with it; both sides wait, the smaller one on
 * top, so that no more than log2 n lists wait below it. */
static inline void painter_make(painter_builder *b, const painter_list *l)
{
    painter *t = b->p;
    size_t which = 0;
    split_plane p = painter_choose(b, l, &which);
    uint32_t at = (uint32_t)t->nodes;
    t->node = grown(t->node, t->nodes++, &t->node_room, sizeof *t->node);
    t->node[at] = (painter_node){p, UINT32_MAX, UINT32_MAX, (uint32_t)t->pieces, 0};
    if (at) *(l->front ? &t->node[l->parent].front : &t->node[l->parent].back) = at;
    for (size_t i = 0; i < l->n; i++)
        if (i == which || painter_side(b, &p, l->piece[i]) == SIDE_ON) {
            t->piece = grown(t->piece, t->pieces, &t->piece_room, sizeof *t->piece);
            t->piece[t->pieces++] = l->piece[i];
        }
    t->node[at].pieces = (uint32_t)t->pieces - t->node[at].piece;
    painter_list back = painter_part(b, l, which, at, SIDE_BACK);
    painter_list front = painter_part(b, l, which, at, SIDE_FRONT);
    painter_wait(b, front.n > back.n ? front : back);
    painter_wait(b, front.n > back.n ? back : front);
}

/* All triangles that have an area. */
static inline painter_list painter_begin(painter_builder *b)
{
    painter *out = b->p;
    painter_list all = {.n = 0};
    vec3 lo, hi;
    if (!mesh_bounds(b->m, &lo, &hi)) return all;
    out->middle = vmadd(vscale(lo, 0.5), hi, 0.5);
    real size = vlargest(vsub(hi, lo));
    b->e = 64 * real_epsilon * size, b->scale = power_above(size);
    for (size_t i = 0; i < b->m->triangles; i++) {
        triangle t = mesh_triangle(b->m, i);
        if (vzero(painter_plane(b, (uint32_t)i).n)) continue;
        painter_reserve(out, 3);
        painter_push(&all, (painter_piece){(uint32_t)out->corners, 3, (uint32_t)i});
        out->corner[out->corners++] = vsub(t.a, out->middle);
        out->corner[out->corners++] = vsub(t.b, out->middle);
        out->corner[out->corners++] = vsub(t.c, out->middle);
    }
    return all;
}

static inline bool painter_build(const mesh *m, painter_options how, painter *out, failure *f)
{
    *out = (painter){0};
    if (how.candidates < 1)
        return failed(f, 2, "painter: %d candidates; 1 or more are needed", how.candidates);
    painter_builder b = {.p = out, .m = m, .how = how, .g = random_start(how.seed, 0, 0)};
    bool full = false;
    painter_wait(&b, painter_begin(&b));
    while (b.lists > 0) {
        painter_list l = b.stack[--b.lists];
        b.waiting -= l.n;
        if (l.n && !full) painter_make(&b, &l);
        full |= b.waiting + out->pieces > how.most;
        free(l.piece);
    }
    free(b.stack);
    if (!full) return true;
    painter_free(out);
    return failed(f, 2, "%zu triangles: cut into more than %zu pieces", m->triangles, how.most);
}

/* Back, own plane, front, as the eye sees them. A stack of its own, as the tree may be as deep as
 * there are triangles. An eye in the plane sees its pieces edge-on: any order will do. */
static inline size_t painter_order(const painter *p, vec3 eye, uint32_t *order)
{
    uint32_t *stack = allocate(p->nodes + 1, sizeof *stack), at = p->nodes ? 0 : UINT32_MAX;
    size_t top = 0, n = 0;
    vec3 e = vsub(eye, p->middle);
    for (;;) {
        while (at != UINT32_MAX) {  /* down the far side */
            stack[top++] = at;
            bool front = side_of(&p->node[at].p, e) > 0;
            at = front ? p->node[at].back : p->node[at].front;
        }
        if (top == 0) break;
        const painter_node *x = &p->node[stack[--top]];
        for (uint32_t k = 0; k < x->pieces; k++) order[n++] = x->piece + k;
        at = side_of(&x->p, e) > 0 ? x->front : x->back;
    }
    free(stack);
    return n;
}

#endif
