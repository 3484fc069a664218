/* mine.h: a structure to begin your own with: a list, each item behind a box. example.h is a tree.
 * Copy it, change it, and put it beside the others, in every table, plot, picture and proof:
 *     make mine-17 MINE=my.h
 *     build/mine-17/17_compare --verify --only mine     that alone, all rays by brute force
 * It must be called mine, with mine_options, and needs no #include: items and query are those of
 * 09_aabb/items.h, and 09_aabb/structure.h says what its verbs have to do. With
 * MINE_CELL, mine_cell_of tells --verify where a shape is listed, when its hit is lost. */
#define MINE_CELL

typedef struct { size_t most_bytes; } mine_options;
typedef struct { items x; aabb all, *box; structure_stats stats; } mine;

static inline bool mine_build(const items *x, mine_options how, mine *m, failure *f)
{
    size_t bytes = x->n * sizeof *m->box;
    *m = (mine){.x = *x, .stats = {.leaves = x->n, .references = x->n, .items = x->n}};
    if (bytes > how.most_bytes) return failed(f, 1, "%zu items do not fit", x->n);
    if (!items_all_bounds(x, &m->all, f)) return false;
    m->box = allocate(x->n, sizeof *m->box);
    for (size_t i = 0; i < x->n; i++)
        if (!items_bounds(x, i, &m->box[i])) m->box[i] = aabb_empty();
    m->stats.bytes = m->stats.peak = bytes;
    return true;
}

static inline void mine_free(mine *m) { free(m->box), *m = (mine){.box = NULL}; }

/* Every box, larger by a hair for rounding (10.1), and what is in those that are met. */
static inline bool mine_search(const mine *m, ray r, bool any, hit *out, search_work *w)
{
    if (!ray_is_usable(r)) return false;
    real hair = query_delta(r, m->all), t;
    query q = query_of(r);
    for (size_t i = 0; i < m->x.n; i++) {
        if (w) w->nodes++;
        if (!aabb_hit(first_aabb_pad(m->box[i], hair), q.r, &t)) continue;
        if (w) w->tests++;
        if (query_ask(&q, &m->x, (uint32_t)i, any) && any) return true;
    }
    return !any && query_answer(&q, out);
}

/* The box that lists the item; were there several, the nearest to p (lab/cells.h). */
static inline item_cell mine_cell_of(const mine *m, uint32_t item, vec3 p)
{
    return item_cell_at(m->box[item], p);
}

static inline structure_stats mine_stats(const mine *m) { return m->stats; }
STRUCTURE_VERBS(mine)
