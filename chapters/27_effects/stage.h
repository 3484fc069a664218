/* stage.h: a scene made ready for light: trees, lamps, sky, lobes, media; and what is to be done.
 *
 *   effects_stage e;
 *   if (!effects_stage_build(&s, &e, &f)) fail(f);          s must outlive it
 *   effects_stage_effects(&e, mask)                         what to simulate from now on
 *   effects_stage_cut(&e, least)                            without dice
 *   effects_stage_view(&e, &view, camera)                   sets e.eye, e.lens, e.hither
 *   effects_stage_free(&e);
 *
 *   mask     effects that are simulated (effect.h), and beside them:
 *     EFFECTS_SPEND    all of them at every hit, whether it has a part in them or not: rays are
 *                      traced and shaded whose weight is black, so that they add exactly 0; they
 *                      give rise to no further ones, or there would be no end
 *     EFFECTS_DICED    branches are thrown for, even where no effect of the mask is an integral
 *     EFFECTS_GENERAL  drawn by the general copy of special.h, always
 *   EFFECTS_EVERYTHING   all effects, spent: the estimator that knows no plan
 *
 * A branch ends by dice, once its weight is small: radiance.h. `depth` is for mirrors that lose
 * nothing.
 */
#ifndef EFFECTS_STAGE_H
#define EFFECTS_STAGE_H

#include "../19_whitted/whitted.h"
#include "../21_distributed/lens.h"
#include "../26_path_tracer/roulette.h"
#include "framing.h"
#include "lamps.h"
#include "effect.h"
#include "touch.h"

enum {
    EFFECTS_SPEND = 1 << effect_kinds,  /* bits beside those of effect.h */
    EFFECTS_GENERAL = 2 << effect_kinds,  /* drawn by the general copy of special.h, always */
    EFFECTS_DICED = 4 << effect_kinds,
    EFFECTS_EVERYTHING = EFFECTS_ALL | EFFECTS_SPEND,
    RAY_OF_EYE = effect_kinds, effects_rays,
    stage_most_depth = 1024, stage_most_waiting = 384,  /* rays behind one another; branches */
    stage_most_faces = 128,                             /* passed without a change of way */
    stage_keep = 128
};

typedef struct {
    size_t rays[effects_rays];       /* [RAY_OF_EYE]: all that the eye sent */
    size_t lost;                     /* bodies for which 19's media.h had no room */
    size_t contacts;                 /* rays of touch.h */
} effects_counts;

typedef struct {
    const studio *s;
    studio_tree t;
    appearance *look;                /* [materials] */
    touch_near *near;                /* where glass has neighbours: touch.h */
    aabb glass;                      /* the box of all of it */
    medium *media;                   /* [materials + 1] body m + 1 is made of material m */
    lamp_list lamp;
    unsigned mask;                   /* effects, and SPEND, GENERAL, DICED */
    bool headlight;                  /* no light is there: each ray of the eye carries a lamp */
    bool chance;                     /* integrals; else all branches above 1 / keep are followed */
    bool cuts;                       /* and no other one */
    bool clear;                      /* a material lets light straight through */
    int depth;                       /* rays behind one another, the eye's is 1 */
    real keep, keep_sharp;           /* k of radiance.h */
    camera eye;
    thin_lens lens;
    real hither;
} effects_stage;

/* ---------------------------------------------------------------------------------------------- */

static inline void effects_stage_free(effects_stage *e)
{
    studio_tree_free(&e->t);
    lamps_free(&e->lamp);
    free(e->look), free(e->near), free(e->media);
    *e = (effects_stage){.s = NULL};
}

static inline void effects_stage_effects(effects_stage *e, unsigned mask)
{
    e->mask = mask;
    e->chance = (mask & (EFFECTS_OF_CHANCE | EFFECTS_DICED)) != 0;
    e->keep = e->chance ? roulette_keep : stage_keep;
    e->keep_sharp = e->chance ? 32 : stage_keep;
    e->cuts = false;
}

/* Until that is called again: branches below `least` are cut, as in 19, to be compared with it. */
static inline void effects_stage_cut(effects_stage *e, real least)
{
    e->cuts = true, e->keep = e->keep_sharp = 1 / least;
}

static inline bool effects_stage_build(const studio *s, effects_stage *out, failure *f)
{
    *out = (effects_stage){.s = s, .depth = stage_most_depth, .headlight = studio_dark(s)};
    if (!studio_tree_build(s, &out->t, f)) return false;
    lamps_build(&out->t, &out->lamp);
    out->look = appearances_of(s);
    out->near = touch_near_of(s, out->look, &out->glass);
    out->media = allocate(s->materials + 1, sizeof *out->media);
    out->media[0] = (medium){.ior = 1};
    for (size_t m = 0; m < s->materials; m++) {
        const appearance *a = &out->look[m];
        out->media[m + 1] = a->m.inside;
        out->clear |= s->material[m].used && !vzero(a->m.through) && !appearance_bends(a);
    }
    effects_stage_effects(out, EFFECTS_ALL);
    return true;
}

/* Does light change its way at a surface of this look, between two media? As a body; sheets do not
 * bend. A face with one medium on both sides is none: it stops shadow rays all the same. */
fast_inline bool stage_bends(const effects_stage *e, const appearance *a, bool body,
                             uint32_t inside, uint32_t to)
{
    return appearance_bends(a)
        || (body && inside != to && (e->media[inside].ior != 1 || e->media[to].ior != 1));
}

static inline void effects_stage_view(effects_stage *e, const studio_view *v, camera c)
{
    e->eye = c;
    e->lens = (thin_lens){e->s->lens.radius, studio_focus(e->s, v)};
    e->hither = v->hither;
}

static inline void effects_counts_add(effects_counts *to, const effects_counts *c)
{
    to->lost += c->lost, to->contacts += c->contacts;
    for (int k = 0; k < effects_rays; k++) to->rays[k] += c->rays[k];
}

#endif
