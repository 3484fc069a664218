/* tree.h: what a k-d tree consists of, how it is to be built, and the memory that building takes.
 *
 *   kdtree_options         the builder's orders: see kdtree.h for what each is
 *   kdtree                 nodes, and the records of the leaves one after another
 *   kd_room(&b, &p, ...)   room for more at p, within how.most_bytes, or false and a message
 *
 * Every byte is counted, so that t.peak is the most ever held and most_bytes is kept. Arrays grow
 * by half; old and new are both held while one is copied.
 */
#ifndef KDTREE_TREE_H
#define KDTREE_TREE_H

#include "split.h"

enum { kdtree_most_depth = 64, kd_most_doubled = 3 };

/* How an item that lies in a plane is kept. KD_THICK: its box gets one float more on each side, so
 * that it lies in no plane of its own; where another plane cuts it, it goes to both children. The
 * others keep boxes as they are: exact where coordinates are floats. */
typedef enum { KD_THICK, KD_BOTH, KD_ONE } kdtree_planar;

typedef struct {
    kdtree_strategy strategy;
    int leaf, depth;          /* most items in a leaf, 0: by cost; deepest leaf, 0: (12.2) */
    double traversal_cost, item_cost, empty_bonus;  /* (12.1) */
    bool clip;                /* boxes of parts are those of the part (12.3), not cut boxes */
    kdtree_planar planar;
    size_t most_bytes;        /* while it is built */
} kdtree_options;

/* 16 bytes for a triangle in a leaf: its corners and its number. */
typedef struct { uint32_t corner[3], index; } kd_triangle;

typedef struct {
    kd_node *node;            /* [nodes] 0 is the root, 1 not used: pairs begin at even numbers */
    kd_triangle *triangle;    /* [references] of a mesh, else NULL */
    uint32_t *index;          /* [references] of a scene, else NULL */
    size_t nodes, references, items;
    items x;
    const vec3 *v;            /* corners of the mesh */
    kd_frame frame;
    kd_box box;               /* in the frame; lo > hi if there is nothing */
    int depth;
    size_t bytes, peak;
} kdtree;

/* ---------------------------------------------------------------------------------------------- */

typedef struct {
    kdtree *t;
    kdtree_options how;
    kd_splitter split;
    kd_item *item;            /* see above */
    uint32_t *index;          /* of the leaves, one after another */
    size_t item_room, node_room, index_room;
    failure *f;
} kd_builder;

static inline bool kd_takes(kd_builder *b, size_t bytes)
{
    kdtree *t = b->t;
    if (bytes > b->how.most_bytes || t->bytes > b->how.most_bytes - bytes)
        return failed(b->f, 1, "k-d tree of %zu items: needs more than the %zu bytes allowed",
                      t->items, b->how.most_bytes);
    t->bytes += bytes;
    if (t->bytes > t->peak) t->peak = t->bytes;
    return true;
}

/* Room for n things of `size` bytes at *p, of which the first `used` are kept; lines of the cache.
 * Both are held for a moment. */
static inline bool kd_room(kd_builder *b, void *p, size_t used, size_t n, size_t *room,
                           size_t size)
{
    void *old = *(void **)p;
    if (n <= *room) return true;
    if (n < *room + *room / 2) n = *room + *room / 2;
    if (n > SIZE_MAX / 128) return failed(b->f, 1, "k-d tree: no memory for %zu items", n);
    size_t bytes = (n * size + 63) / 64 * 64;
    if (!kd_takes(b, bytes)) return false;
    void *more = aligned_alloc(64, bytes);
    if (!more) return failed(b->f, 1, "k-d tree: no memory for %zu bytes", bytes);
    if (old) memcpy(more, old, used * size);
    free(old);
    b->t->bytes -= (*room * size + 63) / 64 * 64;
    *(void **)p = more, *room = n;
    return true;
}

static inline void kd_give_back(kd_builder *b, void *p, size_t room, size_t size)
{
    free(*(void **)p);
    *(void **)p = NULL;
    b->t->bytes -= (room * size + 63) / 64 * 64;
}

static inline void kdtree_free(kdtree *t)
{
    free(t->node), free(t->triangle), free(t->index);
    *t = (kdtree){0};
}

#endif
