/* contender.h: what is compared, and with what: scenes, structures and their results as data.
 *
 *   TRIAL_VERBS(kdtree, kdtree, kdtree_hit, kdtree_hit_counted)   makes kdtree_trial, trial_verbs
 *                                     of a structure that has the verbs of structure.h
 *   TRIAL_OTHER(naive, kdtree, kdtree, kdtree_hit_naive)           makes naive_trial, of another
 *                                     search of the same structure; its work is not counted
 *   TRIAL_FIRST(first_bvh, build)     makes first_bvh_trial, of a first.h; its hits count as wrong
 *                                     where first_is_wrong (07) says so
 */
#ifndef TRIALS_CONTENDER_H
#define TRIALS_CONTENDER_H

#include "../../07_mesh/scenes/as_first.h"
#include "../items.h"
#include "survey.h"

typedef enum { TRIAL_PRIMARY, TRIAL_DIFFUSE, TRIAL_UNIFORM, TRIAL_CORNERS, trial_kinds }
    trial_rays_kind;
static const char *const trial_kind_name[trial_kinds] = {"primary", "diffuse", "uniform",
                                                         "corners"};

typedef struct {
    mesh m;
    items x;
    ray_set rays[trial_kinds];
    hit *due;                    /* of the corners, by brute force; NULL: not asked yet */
    double brute;                /* seconds a ray */
} trial_scene;

typedef struct {
    size_t size;                 /* of what is built [bytes] */
    bool (*build)(const trial_scene *s, const void *how, void *out, failure *f);
    bool (*hit)(const void *b, ray r, hit *out);
    bool (*hit_counted)(const void *b, ray r, hit *out, search_work *w);  /* NULL: nobody counts */
    size_t (*search)(const void *b, const ray_set *rays, size_t step);  /* hits; inlined */
    structure_stats (*stats)(const void *b);                              /* NULL: likewise */
    void (*free)(void *b);
    bool first;                  /* of a first.h: counts tests only, and rounds otherwise */
} trial_verbs;

typedef struct {
    const char *name;
    const trial_verbs *verbs;
    const void *how;             /* its options */
    bool again;                  /* searches what the row before has built */
    size_t step;                 /* is slow: asks every step-th ray only; 0 is 1 */
    void *built;                 /* from here on: out */
    double build;                /* seconds */
    structure_stats stats;
    size_t wrong;                /* hits at corners that are not due */
    struct { search_work work; size_t n; double seconds, spread; } ray[trial_kinds];  /* n rays */
} trial_row;

/* ---------------------------------------------------------------------------------------------- */

#define TRIAL_SEARCH(id, X, search)                                                              \
    static bool id##_trial_hit(const void *b, ray r, hit *out)                                   \
    {                                                                                            \
        return search((const X *)b, r, out);                                                     \
    }                                                                                            \
    static size_t id##_trial_search(const void *b, const ray_set *rays, size_t step)             \
    {                                                                                            \
        size_t hits = 0;                                                                         \
        hit h;                                                                                   \
        for (size_t i = 0; i < rays->n; i += step)                                               \
            hits += search((const X *)b, rays->r[i], &h);                                        \
        return hits;                                                                             \
    }

#define TRIAL_COMMON(id, X, counted)                                                             \
    static bool id##_trial_build(const trial_scene *s, const void *how, void *out, failure *f)   \
    {                                                                                            \
        return X##_build(&s->x, *(const X##_options *)how, (X *)out, f);                         \
    }                                                                                            \
    static bool id##_trial_counted(const void *b, ray r, hit *out, search_work *w)               \
    {                                                                                            \
        return counted((const X *)b, r, out, w);                                                 \
    }                                                                                            \
    static structure_stats id##_trial_stats(const void *b) { return X##_stats((const X *)b); }   \
    static void id##_trial_free(void *b) { X##_free((X *)b); }

#define TRIAL_VERBS(id, X, search, counted)                                                      \
    TRIAL_SEARCH(id, X, search)                                                                  \
    TRIAL_COMMON(id, X, counted)                                                                 \
    static const trial_verbs id##_trial = {sizeof(X), id##_trial_build, id##_trial_hit,          \
                                           id##_trial_counted, id##_trial_search,                \
                                           id##_trial_stats, id##_trial_free, false};

/* The structure of `base`, searched in another way. */
#define TRIAL_OTHER(id, base, X, search)                                                         \
    TRIAL_SEARCH(id, X, search)                                                                  \
    static const trial_verbs id##_trial = {sizeof(X), base##_trial_build, id##_trial_hit, NULL,  \
                                           id##_trial_search, base##_trial_stats,                \
                                           base##_trial_free, false};

/* build: statements that build b->s from b->m, in the way that *(const bool *)how may choose. */
#define TRIAL_FIRST(X, building)                                                                 \
    typedef struct { first_mesh m; X s; } X##_trial_of;                                          \
    static bool X##_trial_build(const trial_scene *s, const void *how, void *out, failure *f)    \
    {                                                                                            \
        X##_trial_of *b = out;                                                                   \
        (void)f, (void)how;                                                                      \
        b->m = first_mesh_of(&s->m);                                                             \
        building;                                                                                \
        return true;                                                                             \
    }                                                                                            \
    static bool X##_trial_one(const X##_trial_of *b, ray r, hit *out)                            \
    {                                                                                            \
        return X##_hit(&b->s, r, out);                                                           \
    }                                                                                            \
    TRIAL_SEARCH(X, X##_trial_of, X##_trial_one)                                                 \
    static bool X##_trial_counted(const void *b, ray r, hit *out, search_work *w)                \
    {                                                                                            \
        long before = first_tests;                                                               \
        bool found = X##_trial_hit(b, r, out);                                                   \
        w->tests += (size_t)(first_tests - before);                                              \
        return found;                                                                            \
    }                                                                                            \
    static void X##_trial_free(void *built)                                                      \
    {                                                                                            \
        X##_trial_of *b = built;                                                                 \
        X##_free(&b->s), first_mesh_free(&b->m);                                                 \
    }                                                                                            \
    static const trial_verbs X##_trial = {sizeof(X##_trial_of), X##_trial_build, X##_trial_hit,  \
                                          X##_trial_counted, X##_trial_search, NULL,             \
                                          X##_trial_free, true};

#endif
