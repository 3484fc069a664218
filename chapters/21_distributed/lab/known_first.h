/* known_first.h: three of known.h's questions, asked of first.h.
 *
 *   known_first k = known_first_of(KNOWN_SQUARE);       or KNOWN_PENUMBRA, KNOWN_HORIZON
 *   double x = known_first_sample(&k, &random)          its expectation is that of known_sample
 *   estimate e = known_first_mean(&k, seed, run, n)     of n samples
 */
#ifndef DISTRIBUTED_KNOWN_FIRST_H
#define DISTRIBUTED_KNOWN_FIRST_H

#include "../first.h"
#include "known.h"

typedef struct { known_kind kind; first_scene s; first_lamp lamp; first_point at; } known_first;

/* ---------------------------------------------------------------------------------------------- */

/* A rectangle of known.h, centre and sides, from above: it shines where b x a points. */
static inline first_lamp known_first_lamp(const area_light *L)
{
    vec3 corner = vsub(L->at, vscale(vadd(L->a, L->b), (real)0.5));
    return (first_lamp){corner, L->b, L->a, area_light_radiance(L)};
}

static inline known_first known_first_of(known_kind kind)
{
    known_first k = {.kind = kind, .s.eps = (real)1e-4, .at.n = {0, 0, 1}};
    known full;
    known_make(kind, &full);
    k.lamp = known_first_lamp(&full.light);
    if (full.s.n > 0) {  /* the sheet: three of its corners */
        const vec3 *v = full.corner;
        first_add_flat(&k.s, v[0], vsub(v[1], v[0]), vsub(v[3], v[0]), (first_material){.ior = 0});
    }
    known_free(&full);
    return k;
}

static inline double known_first_sample(const known_first *k, random_stream *random)
{
    vec3 r = {sqrt((real)0.75), 0, (real)0.5};
    if (k->kind == KNOWN_HORIZON) return first_lobe(r, 1, random).z > 0;
    vec3 E = first_lamp_sample(&k->s, &k->lamp, k->at, random);
    return k->kind == KNOWN_PENUMBRA ? E.x > 0 : (double)E.x;
}

static inline estimate known_first_mean(const known_first *k, uint64_t seed, uint64_t run,
                                        uint32_t n)
{
    estimate e = {0};
    random_stream random = random_start(seed, run, n);
    for (uint32_t i = 0; i < n; i++) e = estimate_add(e, known_first_sample(k, &random));
    return e;
}

#endif
