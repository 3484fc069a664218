/* balls_rays.h: up to 64 eye rays at once, level by level.
 *
 *   whitted_walk, one ray          depth 1 -> hit -> light -> depth 2 -> hit -> light -> ...
 *   balls_rays, 64 of them         all of depth 1: hits, then places, then light, then children
 *                                  all of depth 2: hits, ...
 *
 *   balls_rays(&t, n, r, x, y, colour)   as balls_ray of r[i] through (x[i], y[i]), n <= 64
 *   balls_picture(&t, &c, &im)           one ray a pixel, tile by tile; after balls_view
 *
 * Why it is faster. On its way down one ray is a chain: where it goes on is known after a root and
 * some divisions, each of which waits for the one before, and what it meets is anybody's guess, so
 * the processor guesses wrong. Rays of a level do not wait for each other, and each loop here does
 * one thing. The functions are those of whitted_walk, and so are the colours, to the last bit: the
 * sums of each level are added in the same order.
 *
 * What does not fit, or does not go by levels (a face between two places of the same medium, glass
 * that touches, spend_all), is left to balls_ray.
 */
#ifndef WHITTED_BALLS_RAYS_H
#define WHITTED_BALLS_RAYS_H

#include "../../../common/image.h"
#include "balls_search.h"

enum { balls_batch = 64, balls_room = 4 * balls_batch };

typedef struct {
    whitted_branch b[balls_room];
    uint8_t eye[balls_room];          /* the ray that it descends from */
    int n;
} balls_level;

typedef struct {
    trace_hit hit[balls_room];
    vec3 colour[balls_room];
    whitted_place place[balls_room];
    uint16_t met[balls_room], lit[balls_room];
} balls_work;

/* ---------------------------------------------------------------------------------------------- */

/* colour[i] of each branch of a level, and the level below; false: leave it to balls_ray. */
static inline bool balls_step(tracer *t, balls_level *now, balls_work *k, balls_level *below)
{
    const balls_scene *s = t->user;
    const whitted *w = &s->w;
    int met = 0, lit = 0;
    for (int i = 0; i < now->n; i++) {
        const whitted_branch *b = &now->b[i];
        k->met[met] = (uint16_t)i;
        bool hits = balls_closest(t, b->kind, b->r, b->from, &k->hit[i]);
        k->colour[i] = hits ? (vec3){0, 0, 0} : whitted_nothing(w, b);
        met += hits;
    }
    for (int a = 0; a < met; a++) {
        int i = k->met[a];
        balls_surface(t, &now->b[i].r, &k->hit[i], &k->place[i].s);
    }
    for (int a = 0; a < met; a++) {
        int i = k->met[a];
        whitted_arrive(t, &now->b[i], &k->hit[i], &k->place[i]);
        k->lit[lit] = (uint16_t)i;
        lit += whitted_is_lit(w, &k->place[i]);
    }
    for (int a = 0; a < lit; a++) {
        int i = k->lit[a];
        const whitted_branch *b = &now->b[i];
        const whitted_place *p = &k->place[i];
        k->colour[i] = vmul(b->weight, whitted_shade(t, w, &whitted_by_balls, &p->s, &p->m->base,
                                                     vneg(b->r.d), NULL, b));
    }
    below->n = 0;
    for (int a = 0; a < met; a++) {
        int i = k->met[a];
        if (below->n + 2 > balls_room || whitted_passes(&k->place[i])) return false;
        int n = whitted_follow(w, &now->b[i], &k->place[i], &below->b[below->n]);
        for (; n > 0; n--) below->eye[below->n++] = now->eye[i];
    }
    return true;
}

static inline bool balls_levels(tracer *t, int n, const ray *r, const real *x, const real *y,
                                vec3 *colour)
{
    const balls_scene *s = t->user;
    const media_set nowhere = {0};
    balls_level level[2];
    balls_work k;
    int now = 0;
    if (!s->w.apart || s->w.spend_all || n > balls_batch) return false;
    for (int i = 0; i < n; i++) {
        whitted_eye(r[i], &nowhere, balls_tile_of(&s->b, x[i], y[i]), &level[0].b[i]);
        level[0].eye[i] = (uint8_t)i;
    }
    for (level[0].n = n; level[now].n > 0; now = !now) {
        vec3 sum[balls_batch];
        bool any[balls_batch] = {false};
        if (!balls_step(t, &level[now], &k, &level[!now])) return false;
        for (int i = level[now].n - 1; i >= 0; i--) {  /* the last is traced first: whitted_walk */
            int e = level[now].eye[i];
            sum[e] = any[e] ? vadd(sum[e], k.colour[i]) : k.colour[i];
            any[e] = true;
        }
        for (int e = 0; e < n; e++)
            if (any[e]) colour[e] = level[now].b[0].depth > 1 ? vadd(colour[e], sum[e]) : sum[e];
    }
    return true;
}

static inline void balls_rays(tracer *t, int n, const ray *r, const real *x, const real *y,
                              vec3 *colour)
{
    trace_counts before = t->counts;
    if (balls_levels(t, n, r, x, y, colour)) return;
    t->counts = before;
    for (int i = 0; i < n; i++) colour[i] = balls_ray(t, r[i], x[i], y[i]);
}

static inline void balls_picture(tracer *t, const camera *c, image *im)
{
    ray r[balls_batch];
    real px[balls_batch], py[balls_batch];
    vec3 colour[balls_batch];
    for (int y0 = 0; y0 < im->height; y0 += balls_tile)
        for (int x0 = 0; x0 < im->width; x0 += balls_tile) {
            int across = im->width - x0 < balls_tile ? im->width - x0 : balls_tile;
            int down = im->height - y0 < balls_tile ? im->height - y0 : balls_tile, n = 0;
            for (int y = y0; y < y0 + down; y++)
                for (int x = x0; x < x0 + across; x++, n++) {
                    px[n] = (real)x + (real)0.5, py[n] = (real)y + (real)0.5;
                    r[n] = camera_ray(*c, px[n], py[n], im->width, im->height);
                }
            balls_rays(t, n, r, px, py, colour);
            for (int i = 0; i < n; i++) image_set(im, x0 + i % across, y0 + i / across, colour[i]);
        }
}

#endif
