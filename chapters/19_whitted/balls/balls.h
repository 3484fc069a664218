/* balls.h: a scene of balls alone, searched with what is known of balls and a tree does not know.
 *
 *   balls b;
 *   balls_build(s, n, keep, lights, k, &b)   s[n] spheres, r > 0; copies them; keep[n]: part of the
 *                                         light that each lets pass; O(n^2 + k n cells). Up to 8
 *                                         lights, all directional; else the program ends
 *   balls_view(&b, &c, width, height)     the same for eye rays of that camera; again for another
 *   balls_free(&b)                        a zeroed one may be freed
 *
 * What is looked at, by balls_search.h:
 *
 *   ray                         looked at
 *   eye ray                     the balls that its tile of the picture may see, nearest first
 *   shadow ray to light k       the balls in its cell of light k's buffer: the plane at right
 *                               angles to the light, cut in cells; nearest to the light first
 *   inside a ball, and nothing  that ball: it is left where the ray meets its far side
 *   else reaches into it
 *   reflected outwards          all but the ball it leaves: a ball is convex
 *   all others                  all balls at once, balls_lanes.h
 *
 *     \  \  \  light k         cell of its buffer     A shadow ray is asked for by its origin
 *      |  |( )| |              |  |  |  |            alone: rays to a sun are parallel, and a
 *      |( )|  | |  --->  1 0 1 1  lists of balls     cell of the buffer is a beam of them.
 *
 * Every list errs to the large side, and whether a ball is hit decides sphere_hit of 03: the same
 * hits as by brute force.
 *
 * Sources: E. Haines, D. Greenberg, "The Light Buffer: A Shadow-Testing Accelerator", IEEE CG&A
 * 6(9), 1986; H. Weghorst, G. Hooper, D. Greenberg, "Improved Computational Methods for Ray
 * Tracing", ACM TOG 3(1), 1984 (item buffer).
 */
#ifndef WHITTED_BALLS_H
#define WHITTED_BALLS_H

#include "../../02_camera/camera.h"
#include "balls_lanes.h"
#include "../whitted.h"

enum { balls_cells = 48, balls_tile = 8, balls_most_lights = 8 };

/* Lists of numbers, one after another: list k is item[first[k]] .. item[first[k + 1] - 1]. */
typedef struct { uint32_t *first, *item; size_t lists; } ball_lists;

/* A ball as the sun sees it. end: how far towards the sun it reaches; a little more. */
typedef struct { real u, v, l, rr, size, end; } ball_disc;

typedef struct {
    vec3 l, u, v;              /* towards the light; across */
    real u0, v0, per_u, per_v; /* cell = (p.u - u0) per_u, .. */
    ball_disc *disc;           /* [n] */
    ball_lists lists;
} ball_beam;

typedef struct {
    sphere *s;                 /* [n] */
    bool *lone;                /* [n] nothing else reaches into it */
    size_t n;
    ball_lanes lanes;
    ball_beam beam[balls_most_lights];
    int beams;
    ball_lists eye;
    real *near;                /* [n] of each ball, from the eye; a little less */
    int across;                /* tiles of the view */
} balls;

/* ---------------------------------------------------------------------------------------------- */

static inline void balls_free(balls *b)
{
    free(b->s), free(b->lone);
    for (int k = 0; k < b->beams; k++)
        free(b->beam[k].lists.first), free(b->beam[k].lists.item), free(b->beam[k].disc);
    free(b->eye.first), free(b->eye.item), free(b->near);
    *b = (balls){0};
}

/* A pair of a list and a ball; `key` sorts the balls of a list, the smallest first. */
typedef struct { uint32_t list, ball; real key; } ball_pair;

static inline int ball_pair_order(const void *a, const void *b)
{
    const ball_pair *x = a, *y = b;
    if (x->list != y->list) return x->list < y->list ? -1 : 1;
    return x->key < y->key ? -1 : x->key > y->key;
}

static inline ball_lists lists_of_pairs(ball_pair *p, size_t n, size_t lists)
{
    ball_lists out = {allocate(lists + 1, sizeof(uint32_t)), allocate(n, sizeof(uint32_t)), lists};
    if (n) qsort(p, n, sizeof *p, ball_pair_order);
    for (size_t i = 0; i < n; i++) out.first[p[i].list + 1]++, out.item[i] = p[i].ball;
    for (size_t k = 0; k < lists; k++) out.first[k + 1] += out.first[k];
    return out;
}

static inline void pairs_add(ball_pair **p, size_t *n, size_t *room, ball_pair x)
{
    *p = grown(*p, *n, room, sizeof **p);
    (*p)[(*n)++] = x;
}

/* A ball behind which, seen from the sun, all others lie as wholes, and outside of it: it shades
 * none of them. The ground, as a rule. */
static inline bool beam_shades_none(const balls *b, vec3 l, uint32_t k)
{
    sphere s = b->s[k];
    for (size_t i = 0; i < b->n; i++) {
        vec3 f = vsub(b->s[i].c, s.c);
        real r = b->s[i].r, margin = 16 * real_epsilon * (surface_reach(s.c) + surface_reach(f));
        if (i != k && !(vdot(f, l) > r + margin && vlength(f) > r + s.r + 4 * margin)) return false;
    }
    return true;
}

/* The part of the plane that matters is that of the small balls: a large one, the ground, would
 * make the cells as large as itself. What lies outside is clamped to the outermost cells. */
static inline void beam_build(const balls *b, vec3 l, const real *shadow, ball_beam *out)
{
    ball_pair *pair = NULL;
    size_t n = 0, room = 0;
    real lo[2] = {real_infinity, real_infinity}, hi[2] = {-real_infinity, -real_infinity}, mean = 0;
    vbasis(l, &out->u, &out->v);
    out->l = l, out->disc = allocate(b->n, sizeof *out->disc);
    for (size_t i = 0; i < b->n; i++) mean += b->s[i].r / (real)b->n;
    for (size_t i = 0; i < b->n; i++) {
        sphere s = b->s[i];
        real c[2] = {vdot(s.c, out->u), vdot(s.c, out->v)};
        for (int k = 0; k < 2 && s.r <= 8 * mean; k++)
            lo[k] = real_min(lo[k], c[k] - s.r), hi[k] = real_max(hi[k], c[k] + s.r);
    }
    real per[2];
    for (int k = 0; k < 2; k++) {
        if (!(lo[k] < hi[k])) lo[k] = 0, hi[k] = 1;
        per[k] = balls_cells / (hi[k] - lo[k]);
    }
    out->u0 = lo[0], out->v0 = lo[1], out->per_u = per[0], out->per_v = per[1];
    for (uint32_t i = 0; i < b->n; i++) {
        sphere s = b->s[i];
        real size = surface_reach(s.c) + s.r, along = vdot(s.c, l);
        out->disc[i] = (ball_disc){vdot(s.c, out->u), vdot(s.c, out->v), along, s.r * s.r, size,
                                   along + s.r + 32 * real_epsilon * size};
        if (shadow[i] == 1 || beam_shades_none(b, l, i)) continue;
        /* a cell more to either side: rounding, here and in beam_cell */
        real c[2] = {vdot(s.c, out->u), vdot(s.c, out->v)}, from[2], to[2];
        for (int k = 0; k < 2; k++) {
            from[k] = real_clamp((c[k] - s.r - lo[k]) * per[k] - (real)0.5, 0, balls_cells - 1);
            to[k] = real_clamp((c[k] + s.r - lo[k]) * per[k] + (real)0.5, 0, balls_cells - 1);
        }
        for (int y = (int)from[1]; y <= (int)to[1]; y++)
            for (int x = (int)from[0]; x <= (int)to[0]; x++)
                pairs_add(&pair, &n, &room, (ball_pair){(uint32_t)(y * balls_cells + x), i,
                                                        -out->disc[i].end});
    }
    out->lists = lists_of_pairs(pair, n, balls_cells * balls_cells);
    free(pair);
}

/* O(n^2). Rounding may only make a lone one none. */
static inline void balls_lone(balls *b)
{
    for (size_t i = 0; i < b->n; i++) {
        b->lone[i] = true;
        for (size_t j = 0; j < b->n; j++) {
            sphere s = b->s[i], o = b->s[j];
            real far = vlength(vsub(s.c, o.c)), size = surface_reach(s.c) + surface_reach(o.c);
            real margin = 16 * real_epsilon * (size + s.r + o.r);
            bool around = o.r - far - s.r > margin;  /* s lies deep in o: o's face is far */
            if (i != j && !around && !(far - s.r - o.r > margin)) b->lone[i] = false;
        }
    }
}

static inline void balls_build(const sphere *s, size_t n, const real *shadow, const light *L,
                               int lights, balls *out)
{
    *out = (balls){.s = allocate(n, sizeof *s), .lone = allocate(n, sizeof(bool)), .n = n};
    memcpy(out->s, s, n * sizeof *s);
    if (!ball_lanes_fill(s, n, &out->lanes)) die(2, "%zu balls: from 1 to 64 fit", n);
    balls_lone(out);
    for (failure f; out->beams < lights; out->beams++) {
        if (out->beams == balls_most_lights || L[out->beams].kind != LIGHT_DIRECTIONAL)
            failed(&f, 2, "balls take up to %d lights, all directional", (int)balls_most_lights),
                fail(f);
        beam_build(out, L[out->beams].at, shadow, &out->beam[out->beams]);
    }
}

/* A ball of radius r at distance D shows under the angle asin(r / D); a tile is a cone about its
 * middle, through its farthest corner. */
static inline void balls_view(balls *b, const camera *c, int width, int height)
{
    ball_pair *pair = NULL;
    size_t n = 0, room = 0;
    int across = (width + balls_tile - 1) / balls_tile;
    int down = (height + balls_tile - 1) / balls_tile;
    free(b->eye.first), free(b->eye.item), free(b->near);
    b->across = across, b->near = allocate(b->n, sizeof *b->near);
    real *sine = allocate(b->n, sizeof *sine), *cosine = allocate(b->n, sizeof *cosine);
    for (size_t i = 0; i < b->n; i++) {
        sine[i] = real_min(1, b->s[i].r / vlength(vsub(b->s[i].c, c->e)) * (1 + 8 * real_epsilon));
        cosine[i] = sqrt((1 - sine[i]) * (1 + sine[i]));
        real far = vlength(vsub(b->s[i].c, c->e)), size = far + b->s[i].r + surface_reach(c->e);
        b->near[i] = sine[i] < 1 ? far - b->s[i].r - 64 * real_epsilon * size : 0;
    }
    for (int y = 0; y < down; y++)
        for (int x = 0; x < across; x++) {
            real at = (real)(x * balls_tile), to = (real)(y * balls_tile);
            real half = (real)balls_tile / 2;
            vec3 d = vunit(camera_ray(*c, at + half, to + half, width, height).d);
            real tile = 1;  /* cosine of half its angle */
            for (int k = 0; k < 4; k++) {
                real cx = at + (k & 1 ? balls_tile : 0), cy = to + (k & 2 ? balls_tile : 0);
                tile = real_min(tile, vdot(d, vunit(camera_ray(*c, cx, cy, width, height).d)));
            }
            tile -= 64 * real_epsilon;
            real tile_sine = sqrt(real_max(0, (1 - tile) * (1 + tile)));
            for (uint32_t i = 0; i < b->n; i++) {
                vec3 f = vsub(b->s[i].c, c->e);
                real far = vlength(f), along = vdot(d, f);
                /* cos(a + t) = cos a cos t - sin a sin t */
                real least = cosine[i] * tile - sine[i] * tile_sine - 64 * real_epsilon;
                if (sine[i] < 1 && along < far * least) continue;
                pairs_add(&pair, &n, &room, (ball_pair){(uint32_t)(y * across + x), i,
                                                        b->near[i]});
            }
        }
    b->eye = lists_of_pairs(pair, n, (size_t)across * (size_t)down);
    free(pair), free(sine), free(cosine);
}

#endif
