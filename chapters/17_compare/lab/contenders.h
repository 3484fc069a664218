/* contenders.h: the structures that are compared. A new one, with X_search and the verbs that
 * 09_aabb/structure.h makes of it, is one #include and one line of the list below; example.h is a
 * whole one, to begin with. If it has X_cell_of, too (cells.h), CELL(X) tells --verify.
 *
 *   LINE(id, "name", X, options)     id of its own; name for tables and --only; X is the type and
 *                                    the prefix of its verbs; X_options have a member most_bytes,
 *                                    and may depend on x, the items
 *   ALSO(..)                         an X that has a LINE, with other options
 *
 *   const contender *c = contender_find("octree");     NULL: no such name
 *   void *s = contender_build(c, &how, &x, most_bytes, &f);  NULL: it does not fit, f says so; how:
 *                                                      members that were set from outside (knobs.h)
 *   c->search(s, r, n, any, hits)    all rays in a loop, the structure's search inlined; how many
 *                                    hit; any: hits[i] has t = 0, shape 0 where occluded. The verbs
 *                                    call it with one ray: what is proved is what is timed
 *   c->counted(s, r, any, &h, &w)    is there a hit? What it took is added to w
 *   contender_cell(c, s, item, p, &cell)    the box or cell nearest to p of those that list the
 *                                    item, by X_cell_of (cells.h); false: it has none
 *   contender_free(c, s)
 */
#ifndef COMPARE_CONTENDERS_H
#define COMPARE_CONTENDERS_H

#include "../example.h"
#include "cells.h"
#include "oracles.h"

/* A reader's own: make mine-17 MINE=my.h compiles with its name. mine.h is one to begin with. */
#ifdef MINE
#include MINE
#define CONTENDER_MINE(LINE) LINE(mine, "mine", mine, ((mine_options){0}))
#else
#define CONTENDER_MINE(LINE)
#endif
#ifdef MINE_CELL
#define CONTENDER_MINE_CELL(CELL) CELL(mine)
#else
#define CONTENDER_MINE_CELL(CELL)
#endif

/* The defaults are tuned to triangles, whose test mostly ends at the first comparison. That of a
 * sphere, a cone or a polygon costs some four times as much against a step: trees are then cut
 * finer. Measured on balls, gears, mount, rings and tree: rays take up to half the time less. */
#define shape_cost(x) ((x)->s ? 4 : 1)

#define CONTENDERS(LINE, ALSO)                                                                    \
    LINE(brute, "brute", brute, ((brute_options){0}))                                             \
    LINE(grid, "grid", grid, grid_defaults)                                                       \
    LINE(nested, "nested", nested, nested_defaults)                                               \
    LINE(octree, "octree", octree, octree_how(x))                                                 \
    LINE(kdtree, "kdtree", kdtree, kdtree_how(x))                                                 \
    LINE(bsp, "bsp", bsp, bsp_how(x))                                                             \
    LINE(bvh, "bvh", bvh, bvh_how(x))                                                             \
    ALSO(bvh_morton, "bvh-morton", bvh, bvh_morton_how(x))                                        \
    ALSO(bvh_spatial, "bvh-spatial", bvh, bvh_spatial_how(x))                                     \
    LINE(wide, "wide", bvh8, wide_how(x))                                                         \
    LINE(example, "example", example, ((example_options){0}))                                     \
    CONTENDER_MINE(LINE)                                                                          \
    LINE(first_mesh, "first-mesh", first_items, first_items_how(brute))                           \
    ALSO(first_grid, "first-grid", first_items, first_items_how(grid))                            \
    ALSO(first_octree, "first-octree", first_items, first_items_how(octree))                      \
    ALSO(first_kdtree, "first-kdtree", first_items, first_items_how(kdtree))                      \
    ALSO(first_bsp, "first-bsp", first_items, first_items_how(bsp))                               \
    ALSO(first_bvh, "first-bvh", first_items, first_items_how(bvh))                               \
    ALSO(first_wide, "first-wide", first_items, first_items_how(wide))

#define CONTENDER_CELLS(CELL)                                                                     \
    CELL(grid) CELL(nested) CELL(octree) CELL(kdtree) CELL(bsp) CELL(bvh) CELL(bvh8)              \
    CELL(example) CONTENDER_MINE_CELL(CELL)

/* A member of X_options: how far from its beginning, of which type, and its value. */
typedef enum { KNOB_INT, KNOB_DOUBLE, KNOB_FLAG, KNOB_NAME } knob_type;
typedef struct { size_t offset; knob_type type; double value; const char *name; } contender_setting;
typedef struct { contender_setting set[8]; int n; } contender_settings;

typedef struct {
    const char *name, *type;  /* type: X */
    size_t size;
    bool (*build)(const items *x, const contender_settings *how, size_t most_bytes, void *out,
                  failure *f);
    bool (*hit)(const void *s, ray r, hit *out);
    bool (*occluded)(const void *s, ray r);
    bool (*counted)(const void *s, ray r, bool any, hit *out, search_work *w);
    size_t (*search)(const void *s, const ray *r, size_t n, bool any, hit *out);
    structure_stats (*stats)(const void *s);
    void (*free)(void *s);
} contender;

typedef struct { const char *type; item_cell (*of)(const void *s, uint32_t item, vec3 p); }
    contender_cells;

/* ---------------------------------------------------------------------------------------------- */

/* The defaults of X, but for something. */
#define CONTENDER_HOW(id, X, change)                                                            \
    static inline X##_options id##_how(const items *x)                                          \
    {                                                                                           \
        X##_options how = X##_defaults;                                                         \
        (void)x, change;                                                                        \
        return how;                                                                             \
    }
CONTENDER_HOW(octree, octree, how.leaf /= shape_cost(x))
CONTENDER_HOW(kdtree, kdtree, how.item_cost *= shape_cost(x))
CONTENDER_HOW(bsp, bsp, (how.axis_cost /= shape_cost(x), how.slanted_cost /= shape_cost(x)))
CONTENDER_HOW(bvh, bvh, (how.rule = "sah", how.item_cost *= shape_cost(x)))
CONTENDER_HOW(bvh_morton, bvh, (how.rule = "morton", how.item_cost *= shape_cost(x)))
CONTENDER_HOW(bvh_spatial, bvh, (how.rule = "spatial", how.item_cost *= shape_cost(x)))
CONTENDER_HOW(wide, bvh8, how.threads = 1)  /* built by one, as the others are */

static inline void contender_set(void *members, const contender_settings *how)
{
    for (int k = 0; k < how->n; k++) {
        const contender_setting *s = &how->set[k];
        void *at = (char *)members + s->offset;
        if (s->type == KNOB_INT) *(int *)at = (int)s->value;
        if (s->type == KNOB_DOUBLE) *(double *)at = s->value;
        if (s->type == KNOB_FLAG) *(bool *)at = s->value != 0;
        if (s->type == KNOB_NAME) *(const char **)at = s->name;
    }
}

#define CONTENDER_ALSO(id, text, X, options)                                                    \
    static bool id##_c_build(const items *x, const contender_settings *set, size_t most_bytes,  \
                             void *out, failure *f)                                             \
    {                                                                                           \
        X##_options how = options;                                                              \
        contender_set(&how, set);                                                               \
        how.most_bytes = most_bytes;                                                            \
        return X##_build(x, how, out, f);                                                       \
    }                                                                                           \
    static const contender id##_contender = {text, #X, sizeof(X), id##_c_build,                 \
        X##_c_hit, X##_c_occluded, X##_c_counted, X##_c_search, X##_c_stats, X##_c_free};
/* The verbs of X, and the first who uses them. */
#define CONTENDER_LINE(id, text, X, options)                                                    \
    __attribute__((noinline))                                                                   \
    static size_t X##_c_search(const void *s, const ray *r, size_t n, bool any, hit *out)       \
    {                                                                                           \
        size_t hits = 0;                                                                        \
        for (size_t i = 0; i < n; i++) out[i] = hit_none;                                       \
        for (size_t i = 0; any && i < n; i++)                                                   \
            if (X##_occluded(s, r[i])) out[i] = (hit){0, 0, 0, 0}, hits++;                      \
        for (size_t i = 0; !any && i < n; i++) hits += X##_hit(s, r[i], &out[i]);               \
        return hits;                                                                            \
    }                                                                                           \
    static bool X##_c_hit(const void *s, ray r, hit *out)                                       \
    {                                                                                           \
        hit h;                                                                                  \
        return X##_c_search(s, &r, 1, false, &h) && (*out = h, true);                           \
    }                                                                                           \
    static bool X##_c_occluded(const void *s, ray r)                                            \
    {                                                                                           \
        hit h;                                                                                  \
        return X##_c_search(s, &r, 1, true, &h);                                                \
    }                                                                                           \
    static bool X##_c_counted(const void *s, ray r, bool any, hit *out, search_work *w)         \
    {                                                                                           \
        return X##_search(s, r, any, out, w);                                                   \
    }                                                                                           \
    static structure_stats X##_c_stats(const void *s) { return X##_stats(s); }                  \
    static void X##_c_free(void *s) { X##_free(s); }                                            \
    CONTENDER_ALSO(id, text, X, options)
CONTENDERS(CONTENDER_LINE, CONTENDER_ALSO)

#define CONTENDER_PLACE(id, text, X, options) &id##_contender,
static const contender *const contender_list[] = {CONTENDERS(CONTENDER_PLACE, CONTENDER_PLACE)};
enum { contenders = sizeof contender_list / sizeof *contender_list };

static inline const contender *contender_find(const char *name)
{
    for (int k = 0; k < contenders; k++)
        if (strcmp(contender_list[k]->name, name) == 0) return contender_list[k];
    return NULL;
}

#define CONTENDER_CELL(X)                                                                       \
    static item_cell X##_c_cell(const void *s, uint32_t item, vec3 p)                           \
    {                                                                                           \
        return X##_cell_of(s, item, p);                                                         \
    }
CONTENDER_CELLS(CONTENDER_CELL)
#define CONTENDER_CELL_PLACE(X) {#X, X##_c_cell},
static const contender_cells contender_cell_list[] = {CONTENDER_CELLS(CONTENDER_CELL_PLACE)};

static inline bool contender_cell(const contender *c, const void *s, uint32_t item, vec3 p,
                                  item_cell *out)
{
    for (size_t k = 0; k < sizeof contender_cell_list / sizeof *contender_cell_list; k++)
        if (strcmp(contender_cell_list[k].type, c->type) == 0)
            return *out = contender_cell_list[k].of(s, item, p), true;
    return false;
}

/* May be wrong: that is counted and marked, and is no error. */
static inline bool contender_is_first(const contender *c)
{
    return strcmp(c->type, first_mesh_contender.type) == 0;
}

static inline void contender_free(const contender *c, void *s)
{
    if (s) c->free(s);
    free(s);
}

static inline void *contender_build(const contender *c, const contender_settings *how,
                                    const items *x, size_t most_bytes, failure *f)
{
    void *s = allocate(1, c->size);
    if (c->build(x, how, most_bytes, s, f)) return s;
    contender_free(c, s);
    return NULL;
}

#endif
