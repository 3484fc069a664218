/* first_studio.h: a studio as first.h has it, so that both versions can be asked about one scene.
 *
 *   first_scene f;
 *   const char *lacks = first_of_studio(&s, &view, &f)     NULL: f has its surfaces and its lights;
 *                                                          else what it has no word for; f unset
 *   first_camera c = first_studio_camera(&view, nx, ny)    as that of studio_camera
 *
 * Balls and parallelograms that are matte, mirrors or clear glass, lights without size, and one
 * lamp, thing 0, with everything, the eye too, on one side of it: that is made its front, since
 * lamps of 27 shine to both. Nothing of `indirect off`: first.h cannot decline. The eye is in no
 * ball, and glass in no other glass: that is not looked at.
 *
 * A sun is a point light at the distance D. first.h has one eps, of rays that go on a distance, of
 * shadow rays a part of the way. It is no smaller than rounding allows; then the light falls off by
 * size / D, and shadow rays begin eps D away. D = size / sqrt eps makes both alike: in double 4e-7
 * of the whole, in float a hundredth.
 */
#ifndef EFFECTS_FIRST_STUDIO_H
#define EFFECTS_FIRST_STUDIO_H

#include "../appearance.h"
#include "../first.h"

/* ---------------------------------------------------------------------------------------------- */

static inline bool first_studio_white(vec3 a) { return a.x == 1 && a.y == 1 && a.z == 1; }

static inline const char *first_studio_material(const appearance *a, first_material *m)
{
    bool mirror = !vzero(a->mirror), glass = !vzero(a->through);
    if (!vzero(a->flat)) return "no unlit surface";
    if (!vzero(a->highlight) || !vzero(a->glossy) || a->rough > 0) return "no lobe";
    if (glass && !(a->bends && a->solid && a->fresnel && first_studio_white(a->through)
                   && first_studio_white(a->mirror) && vzero(a->absorb)))
        return "no glass but clear glass";
    if (!glass && a->fresnel) return "no Fresnel but of glass";
    if ((glass || mirror) && !vzero(a->matte)) return "no matte mirror";
    *m = (first_material){.kd = a->matte, .ke = a->emits};
    if (glass) m->ior = a->ior;
    else m->mirror = a->mirror;
    return NULL;
}

/* Shape k; turned: its corners the other way round, so that the front, a x b, is on the other side.
 */
static inline const char *first_studio_thing(const studio *s, uint32_t k, bool turned,
                                             first_scene *f)
{
    const shape *x = &s->shape[k];
    appearance look = appearance_of(&s->material[s->shape_material[k]]);
    first_material m;
    const char *lacks = first_studio_material(&look, &m);
    if (lacks) return lacks;
    if (f->things == first_most_things) return "no room";
    if (x->kind == SHAPE_SPHERE && x->sphere.r > 0)
        return first_add_ball(f, x->sphere.c, x->sphere.r, m), NULL;
    if (x->kind != SHAPE_POLYGON || x->polygon.n != 4) return "no such shape";
    const vec3 *v = x->polygon.v;
    vec3 a = vsub(v[1], v[0]), b = vsub(v[3], v[0]), far = vsub(vsub(v[2], v[0]), vadd(a, b));
    real size = vlength(a) + vlength(b);
    if (!(vlength(far) <= 16 * real_epsilon * size) || !(vlength(vcross(a, b)) > 0))
        return "no polygon but parallelograms";
    if (turned) first_add_flat(f, v[0], b, a, m);
    else first_add_flat(f, v[0], a, b, m);
    return NULL;
}

/* How far before the lamp a box is at least, in units of its n; negative: partly behind it. */
static inline real first_studio_before(const first_thing *lamp, vec3 lo, vec3 hi)
{
    real least = real_infinity;
    for (int i = 0; i < 8; i++) {
        vec3 p = {i & 1 ? lo.x : hi.x, i & 2 ? lo.y : hi.y, i & 4 ? lo.z : hi.z};
        least = real_min(least, vdot(vsub(p, lamp->corner), lamp->n));
    }
    return least;
}

/* The lamp, thing 0, towards all that is there. */
static inline const char *first_studio_lamp(const studio *s, const studio_view *view,
                                            first_scene *f)
{
    uint32_t k = s->emitter[0].index;
    if (s->shape[k].kind != SHAPE_POLYGON) return "no lamp but parallelograms";
    for (int turned = 0; turned < 2; turned++) {
        f->things = 0;
        const char *lacks = first_studio_thing(s, k, turned, f);
        if (lacks) return lacks;
        real least = first_studio_before(&f->thing[0], view->from, view->from);
        for (size_t i = 0; i < s->shapes; i++) {
            vec3 lo, hi;
            shape_bounds(s->shape[i], &lo, &hi);
            if (i != k) least = real_min(least, first_studio_before(&f->thing[0], lo, hi));
        }
        if (least >= 0) return NULL;
    }
    return "no lamp with two sides";
}

static inline const char *first_studio_lights(const studio *s, real far, first_scene *f)
{
    for (size_t i = 0; i < s->lights; i++) {
        light x = s->light[i].light;
        if (vzero(x.colour)) continue;
        if (f->lights == first_most_lights) return "no room";
        if (x.kind == LIGHT_DIRECTIONAL)
            x.at = vscale(x.at, far), x.colour = vscale(x.colour, far * far);
        f->light[f->lights++] = (first_light){x.at, x.colour};
    }
    return NULL;
}

static inline const char *first_of_studio(const studio *s, const studio_view *view, first_scene *f)
{
    const vec3 sky = s->sky.background;
    const char *lacks = s->lens.radius > 0 ? "no lens"
                      : s->sky.kind != SKY_NONE ? "no light of the sky"
                      : s->places || s->solids ? "no mesh, no solid"
                      : s->emitters > 1 ? "no second lamp" : view->hither > 0 ? "no hither"
                      : studio_dark(s) ? "no headlight" : NULL;
    vec3 lo, hi;
    *f = (first_scene){.above = sky, .below = sky};
    if (!lacks && !studio_bounds(s, &lo, &hi)) lacks = "nothing there";
    if (!lacks && s->emitters) lacks = first_studio_lamp(s, view, f);
    for (uint32_t k = 0; k < s->shapes && !lacks; k++)
        if (!s->emitters || k != s->emitter[0].index) lacks = first_studio_thing(s, k, false, f);
    if (lacks) return lacks;
    real size = vlength(vsub(hi, lo));
    f->eps = 16 * real_epsilon * size;
    return first_studio_lights(s, size / sqrt(f->eps), f);
}

static inline first_camera first_studio_camera(const studio_view *v, int nx, int ny)
{
    return first_camera_at(v->from, v->at, v->up, v->angle, nx, ny);
}

#endif
