/* path.h: the path tracer: radiance that arrives along a ray, from one random path.
 *
 *   eye --> x0 --> x1 --> x2 ...      at each xk, with beta = product of f cos / pdf / q so far:
 *            \      \                   1. light sampling: a point of a light, a shadow ray
 *             light  light              2. BRDF sampling: the next ray; what it meets may shine
 *
 *   L = sum over k of beta_k ( w_L f cos Le / p_L  +  w_B f cos Le / p_B ),  w_L + w_B = 1  (26.5)
 *
 *   w: power heuristic of 24 (24.9). What the eye sees at once, or in a mirror or through glass, no
 *   light sample could have found: there w_B = 1. Roulette (26.3) ends the path.
 *
 *   path_tracer t;
 *   path_tracer_of(&scene, sky, path_defaults, &t);        sky: an environment (24.12) or NULL
 *   vec3 L = path_radiance(&t, r, &s, &counts);            s: path_random; counts: {0} at first
 *   path_begin(&walk[i], r); .. path_row(&t, walk, s, n, &counts);     n paths [1..path_row_most],
 *                                                          step by step together: L in walk[i]
 *   path_random s = path_start(&t.how, seed, pixel, k, n); sample k of n of a pixel; or, where many
 *   path_pixel p; path_pixel_of(&t.how, seed, pixel, &p);  follow, hashed once a pixel:
 *   path_sample(&p, k, n, &s);                             the same numbers; path_samples of many
 *   path_tracer_free(&t)
 *
 * E[L] is the solution of the rendering equation (25.1) along r, whatever t.how says but for
 * `bounces` and `clamp`, which leave light out. How large the noise is is all that differs. It
 * holds where the eye (of light_tracer.h: the lamp) is in air, and where bodies of glass do not
 * nest, touch or overlap: a path begins in air, and is in air again when it leaves any body. 19's
 * media.h and chapter 27 know these.
 *
 * Only what is called for:
 *   no ray at all       in scenes in which nothing shines
 *   no light sample     at mirrors, smooth glass, black surfaces; in scenes without lights
 *   no shadow ray       where the light's back faces x, or f cos = 0
 *   no roulette         where nothing can follow: after the last bounce, black, absorbed; q = 1
 *   no refraction code  without glass; no sphere is tested where there are none
 *   no random digits    for a choice of one
 * counts say how often each was done. With spend_all shadow rays that can bring nothing are traced
 * all the same: the result is the same bit by bit.
 *
 * Random numbers: the first path_pairs pairs are the sampler's. Pair 0 places the ray in its pixel,
 * then come two a hit, light and BRDF. All others, glass and roulette are independent: what far
 * bounces bring depends on too many numbers for any of them to be worth stratifying.
 *
 * Source: J. Kajiya, SIGGRAPH 1986; E. Veach, thesis, Stanford, 1997, sections 8.3, 9.2, 10.2.
 */
#ifndef PATH_H
#define PATH_H

#include "../24_direct_light/lights.h"
#include "../24_direct_light/mis.h"
#include "dielectric.h"
#include "roulette.h"

typedef struct {
    sequence_kind sequence;
    bool light_sampling;     /* without: only what BRDF directions run into */
    bool mis;                /* without: light samples alone count what they could find */
    roulette_rule roulette;
    int bounces;             /* at most; path_endless */
    real clamp;              /* no sample counts for more than that; 0: none is cut */
    bool spend_all;
} path_options;

enum { path_endless = 1 << 20, path_pairs = sampler_row };
#define path_defaults \
    ((path_options){SEQUENCE_SOBOL, true, true, ROULETTE_THROUGHPUT, path_endless, 0, false})

typedef struct {
    size_t paths, camera, bounce, shadow;            /* rays traced */
    size_t light_draws, dice, refractions, spent;    /* spent: what could bring nothing */
} path_counts;

typedef struct {
    const lit_scene *scene;
    const environment *sky;
    lit_lights light;
    path_options how;
    bool glass, dark;        /* dark: nothing shines */
} path_tracer;

typedef struct { sampler_keys keys; uint64_t own; } path_pixel;
typedef struct { point2 pair[path_pairs]; random_stream own; uint32_t used; } path_random;

/* ---------------------------------------------------------------------------------------------- */

static inline size_t path_rays(const path_counts *c) { return c->camera + c->bounce + c->shadow; }

static inline void path_counts_add(path_counts *to, const path_counts *c)
{
    to->paths += c->paths, to->camera += c->camera, to->bounce += c->bounce;
    to->shadow += c->shadow, to->light_draws += c->light_draws, to->dice += c->dice;
    to->refractions += c->refractions, to->spent += c->spent;
}

static inline void path_tracer_free(path_tracer *t) { lit_lights_free(&t->light); }

static inline void path_tracer_of(const lit_scene *s, const environment *sky, path_options how,
                                  path_tracer *out)
{
    *out = (path_tracer){.scene = s, .sky = sky, .how = how};
    lit_lights_of(s, sky, LIGHTS_FLUX, &out->light);
    out->dark = !lit_lights_some(&out->light) && vzero(s->background) && !how.spend_all;
    for (size_t i = 0; i < s->materials; i++) out->glass |= s->material[i].inside.ior > 0;
}

static inline void path_pixel_of(const path_options *how, uint64_t seed, uint64_t pixel,
                                 path_pixel *out)
{
    sampler_keys_of(how->sequence, seed, pixel, &out->keys);
    out->own = random_pixel(seed ^ random_step, pixel);
}

static inline void path_sample(const path_pixel *p, uint32_t k, uint32_t n, path_random *out)
{
    sampler_row_of(&p->keys, k, n, out->pair);
    out->own = random_sample(p->own, k), out->used = 0;
}

/* Of some pixels side by side: each number is a long chain of products, which others needn't wait
 * for. */
static inline void path_samples(const path_pixel *p, int pixels, uint32_t k, uint32_t n,
                                path_random *out)
{
    for (int i = 0; i < pixels; i += sampler_rows) {
        const sampler_keys *of[sampler_rows];
        point2 *pair[sampler_rows];
        for (int j = 0; j < sampler_rows; j++) {
            int at = i + j < pixels ? i + j : pixels - 1;  /* the last one again */
            of[j] = &p[at].keys, pair[j] = out[at].pair;
        }
        sampler_rows_of(of, k, n, pair);
    }
    for (int i = 0; i < pixels; i++) out[i].own = random_sample(p[i].own, k), out[i].used = 0;
}

static inline path_random path_start(const path_options *how, uint64_t seed, uint64_t pixel,
                                     uint32_t k, uint32_t n)
{
    path_pixel p;
    path_random s;
    path_pixel_of(how, seed, pixel, &p);
    path_sample(&p, k, n, &s);
    return s;
}

fast_inline point2 path_pair(path_random *r)
{
    if (r->used < path_pairs) return r->pair[r->used++];
    real u = random_next(&r->own), v = random_next(&r->own);
    return (point2){u, v};
}

/* Where the path is, and what it has gathered. */
typedef struct {
    vec3 L, beta;
    ray r;
    vec3 from;                   /* what r left: a point, */
    uint32_t left;               /* and its shape; no_shape: the eye */
    real pdf;                    /* of r's direction; infinite: no light sample could find it */
    const medium *in;            /* of the glass that r is in, or NULL */
    real squeezed;               /* part of beta that is dielectric_squeeze: it comes back */
    int bounces;
    bool asks;                   /* the light sample of this hit: its shadow ray, what that can't */
    ray shadow;                  /* meet, and the light that comes along it if nothing is there */
    world_but but;
    vec3 gain;
} path_walk;

enum { path_row_most = world_row };

/* Field by field, and l in path_light not at all: a struct that is first cleared as a whole waits
 * for it, and one that is handed over is copied. */
fast_inline void path_begin(path_walk *w, ray eye)
{
    w->L = (vec3){0, 0, 0}, w->beta = (vec3){1, 1, 1}, w->r = eye, w->from = eye.o;
    w->left = no_shape, w->pdf = real_infinity, w->in = NULL, w->squeezed = 1, w->bounces = 0;
    w->asks = false;
}

static inline vec3 path_cut(vec3 c, real most)
{
    real x = real_max(real_max(c.x, c.y), c.z);
    return most > 0 && x > most ? vscale(c, most / x) : c;
}

/* (26.5), second half: light that the ray itself has met. */
fast_inline vec3 path_found(const path_tracer *t, const path_walk *w, const lit_hit *x)
{
    vec3 Le = x->m->ke;
    if (!(w->pdf < real_infinity) || !t->how.light_sampling) return Le;
    if (!t->how.mis) return (vec3){0, 0, 0};
    real cosine = fabs(vdot(x->s.n, w->r.d));
    real q = lit_lights_pdf(&t->light, POINTS_CHEAP, x->emitter, w->from, x->t, cosine);
    return vscale(Le, mis_power(w->pdf, q));
}

static inline vec3 path_escaped(const path_tracer *t, const path_walk *w)
{
    if (!t->sky) return t->scene->background;
    vec3 d = w->left == no_shape ? vunit(w->r.d) : w->r.d;
    vec3 L = environment_radiance(t->sky, d);
    if (!(w->pdf < real_infinity) || !t->how.light_sampling) return L;
    if (!t->how.mis) return (vec3){0, 0, 0};
    return vscale(L, mis_power(w->pdf, lit_lights_pdf_sky(&t->light, d)));
}

/* What fills the place behind a wall of glass. */
static inline const medium *path_behind(const lit_hit *x)
{
    return x->front ? &x->m->inside : NULL;
}

/* What glass itself colours. */
static inline vec3 path_tint(const lit_hit *x, bool through)
{
    return through ? x->m->through : x->m->mirror;
}

/* (26.5), first half, if its shadow ray meets nothing. wo is local to f. g: of rough glass, which
 * light may also reach from behind; else NULL. */
fast_inline void path_light(const path_tracer *t, path_walk *w, const lit_hit *x,
                            shading_frame f, vec3 wo, const rough_glass *g, point2 u,
                            path_counts *c)
{
    lit_draw l;
    c->light_draws++;
    if (!lit_lights_sample(&t->light, POINTS_CHEAP, x->s.p, u, &l)) return;
    vec3 wi = to_local(f, l.wi);
    bool lit = g || (vdot(x->s.n, l.wi) > 0 && !brdf_behind(wi));
    if (!lit && !t->how.spend_all) return;
    vec3 fcos = {0, 0, 0};
    if (g) fcos = vscale(path_tint(x, wi.z < 0), fabs(wi.z) * rough_glass_value(g, wi, wo));
    else if (lit) fcos = vscale(brdf_value_local(x->f, wi, wo), wi.z);
    vec3 brings = vmul(w->beta, vmul(fcos, l.Le));
    if (vzero(brings)) {
        if (!t->how.spend_all) return;
        c->spent++;
    }
    c->shadow++;
    w->shadow = lit_draw_ray(&x->s, &l), w->but = lit_left_to(t->scene, x->s.shape, l.emitter);
    real pdf = !t->how.mis ? 0 : g ? rough_glass_pdf(g, wi, wo)
                                   : brdf_pdf_local(x->f, wi, wo);
    vec3 gain = vscale(brings, mis_power(l.pdf, pdf) / l.per);
    const medium *in = g && wi.z < 0 ? path_behind(x) : w->in;
    if (t->glass && in)  /* no wall of it in between: all the way in the glass */
        gain = vmul(gain, absorbed(in->absorb,
                                   l.far ? real_infinity : vlength(vsub(l.s.p, x->s.p))));
    w->gain = path_cut(gain, t->how.clamp), w->asks = true;
}

/* False: the path ends here. */
fast_inline bool path_dice(const path_tracer *t, path_walk *w, path_random *s, path_counts *c)
{
    if (t->how.roulette == ROULETTE_NONE) return true;
    vec3 carries = t->glass ? vscale(w->beta, 1 / w->squeezed) : w->beta;
    real q = t->how.roulette == ROULETTE_FIXED ? roulette_fixed(carries)
                                               : roulette_survival(carries);
    if (q >= 1) return true;
    c->dice++;
    if (random_next(&s->own) >= q) return false;
    w->beta = vscale(w->beta, 1 / q);
    return true;
}

/* Off a facet or through it, which light samples find, too; false: it sends it to the wrong side.
 * Of two equal indices it is none. */
static inline bool path_facet(const path_tracer *t, path_walk *w, const lit_hit *x, rough_glass g,
                              path_random *s, path_counts *c, vec3 *wi, bool *through)
{
    vec3 wo = vneg(vunit(w->r.d));
    real power;
    bool find = t->how.light_sampling && lit_lights_some(&t->light) && g.n1 != g.n2;
    shading_frame f = shading_frame_of(x->s.n);
    if (find) path_light(t, w, x, f, to_local(f, wo), &g, path_pair(s), c);
    if (!dielectric_rough(g, x->s.n, wo, &s->own, wi, through, &power)) return false;
    w->beta = vscale(w->beta, power);
    w->pdf = find ? rough_glass_pdf(&g, to_local(f, *wi), to_local(f, wo)) : real_infinity;
    return true;
}

/* False: the path ends here. A call: half of the machine code is for glass. */
__attribute__((noinline))
static bool path_through_glass(const path_tracer *t, path_walk *w, const lit_hit *x,
                               path_random *s, path_counts *c)
{
    bool through;
    real n1 = x->front ? 1 : x->m->inside.ior, n2 = x->front ? x->m->inside.ior : 1;
    c->refractions++;
    vec3 wi;
    if (x->m->alpha > 0) {
        rough_glass g = {x->m->alpha, n1, n2};
        if (!path_facet(t, w, x, g, s, c, &wi, &through)) return false;
    } else {
        vec3 wo = vneg(vunit(w->r.d));
        w->pdf = real_infinity;
        wi = dielectric_scatter(x->s.n, wo, n1, n2, random_next(&s->own), &through);
    }
    w->beta = vmul(w->beta, path_tint(x, through));
    if (through) {
        real k = dielectric_squeeze(n1, n2);
        w->beta = vscale(w->beta, k), w->squeezed *= k;
        w->in = path_behind(x);
    }
    w->r = leave(surface_copy(&x->s), wi);
    w->from = x->s.p, w->left = x->s.shape;
    return true;
}

/* The next ray by the BRDF; false: nothing is reflected. */
fast_inline bool path_reflect(const path_tracer *t, path_walk *w, const lit_hit *x,
                              path_random *s, path_counts *c)
{
    const brdf *b = x->f;
    vec3 wo = vneg(w->left == no_shape ? vunit(w->r.d) : w->r.d), wi, weight;
    shading_frame f = shading_frame_of(x->s.ns);
    vec3 local = to_local(f, wo);
    point2 for_light = path_pair(s), for_brdf = path_pair(s);
    if (t->how.light_sampling && lit_lights_some(&t->light) && !brdf_is_delta(b))
        path_light(t, w, x, f, local, NULL, for_light, c);
    if (!brdf_sample_local(b, local, for_brdf.u, for_brdf.v, &wi, &w->pdf, &weight)) return false;
    wi = to_world(f, wi);
    if (!(vdot(x->s.n, wi) > 0)) return false;
    w->beta = vmul(w->beta, weight);
    w->r = leave(surface_copy(&x->s), wi);
    w->from = x->s.p, w->left = x->s.shape;
    return true;
}

/* What the ray has met, with what is left of beta there. */
fast_inline void path_hit(const path_tracer *t, path_walk *w, const trace_hit *h, lit_hit *x)
{
    lit_hit_of(t->scene, &w->r, h, x);
    if (t->glass && w->in)
        w->beta = vmul(w->beta, absorbed(w->in->absorb, x->t * vlength(w->r.d)));
}

/* False: nothing. */
fast_inline bool path_meets(const path_tracer *t, path_walk *w, lit_hit *x)
{
    trace_hit h;
    if (!lit_find(t->scene, &w->r, w->left, &h)) return false;
    path_hit(t, w, &h, x);
    return true;
}

/* On from the hit x; false: the path ends there. */
fast_inline bool path_on(const path_tracer *t, path_walk *w, const lit_hit *x, path_random *s,
                         path_counts *c)
{
    bool glass = t->glass && x->m->inside.ior > 0;
    if (w->bounces >= t->how.bounces) return false;
    if (!glass && brdf_is_black(x->f)) return false;
    if (glass) {
        lit_hit own = *x;  /* x itself stays where it need not be in memory */
        if (!path_through_glass(t, w, &own, s, c)) return false;
    } else if (!path_reflect(t, w, x, s, c)) return false;
    if (vzero(w->beta) || !path_dice(t, w, s, c)) return false;
    w->bounces++, c->bounce++;
    return true;
}

/* What the ray brings from h, where it met something, and on from there; false: the path ends. x is
 * not cleared: that took 2.7 % of all time. */
fast_inline bool path_at(const path_tracer *t, path_walk *w, bool met, const trace_hit *h,
                         path_random *s, path_counts *c)
{
    lit_hit x;
    if (met) path_hit(t, w, h, &x);
    if (!met || x.shines) {
        vec3 L = vmul(w->beta, met ? path_found(t, w, &x) : path_escaped(t, w));
        w->L = vadd(w->L, w->bounces ? path_cut(L, t->how.clamp) : L);
    }
    return met && path_on(t, w, &x, s, c);
}

/* One hit further for the n paths walk[at[..]]: their rays first, side by side, then what each hit
 * brings. How many go on: next[..]. */
fast_inline int path_steps(const path_tracer *t, path_walk *walk, path_random *s, const int *at,
                           int n, int *next, path_counts *c)
{
    world_query q[path_row_most];
    int left = 0;
    for (int i = 0; i < n; i++) q[i].r = &walk[at[i]].r, q[i].but = lit_left(walk[at[i]].left);
    world_find_row(&t->scene->world, MASK_ALL, q, n, false);
    for (int i = 0; i < n; i++) {
        int k = at[i];
        next[left] = k, left += path_at(t, &walk[k], q[i].met, &q[i].x, &s[k], c);
    }
    return left;
}

/* Then their shadow rays, and the light that comes along them. */
fast_inline void path_shadows(const path_tracer *t, path_walk *walk, const int *at, int n)
{
    world_query q[path_row_most];
    int of[path_row_most], asks = 0;
    for (int i = 0; i < n; i++) of[asks] = at[i], asks += walk[at[i]].asks;
    for (int i = 0; i < asks; i++) q[i].r = &walk[of[i]].shadow, q[i].but = walk[of[i]].but;
    world_find_row(&t->scene->world, MASK_ALL, q, asks, true);
    for (int i = 0; i < asks; i++) {
        path_walk *w = &walk[of[i]];
        w->asks = false;
        if (!q[i].met) w->L = vadd(w->L, w->gain);
    }
}

/* Of one path. False: it ends. */
fast_inline bool path_step(const path_tracer *t, path_walk *w, path_random *s, path_counts *c)
{
    int at = 0, next, left = path_steps(t, w, s, &at, 1, &next, c);
    path_shadows(t, w, &at, 1);
    return left > 0;
}

/* Paths know nothing of each other. They wait for each other so that their rays are asked side by
 * side (15). */
__attribute__((flatten))
static inline void path_row(const path_tracer *t, path_walk *walk, path_random *s, int n,
                            path_counts *c)
{
    int at[2][path_row_most];
    c->paths += (size_t)n;
    if (t->dark) return;
    c->camera += (size_t)n;
    for (int i = 0; i < n; i++) at[0][i] = i;
    for (int k = 0, left; n > 0; k = !k, n = left) {
        left = path_steps(t, walk, s, at[k], n, at[!k], c);
        path_shadows(t, walk, at[k], n);
    }
}

static inline vec3 path_radiance(const path_tracer *t, ray eye, path_random *s, path_counts *c)
{
    path_walk w;
    path_begin(&w, eye);
    path_row(t, &w, s, 1, c);
    return w.L;
}

#endif
