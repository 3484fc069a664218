/* 18_shade: trace against brute force, programs and masks; lights against closed forms; shadows
 * against geometry; no ray that cannot contribute; line of sight. */
#include "check.h"
#include "../common/random.h"
#include "../chapters/18_shade/lab/pictures.h"

/* ---- trace ----------------------------------------------------------------------------------- */

typedef struct {
    hit h;
    uint32_t part;
    bool met, missed;
    int asked, accepted, ignore, end_at, hopeless;
    real best;  /* of the accepted, 0: none yet */
} seen;

static void see_hit(tracer *t, ray r, trace_hit x, void *payload)
{
    seen *s = payload;
    (void)t, (void)r;
    s->h = x.h, s->part = x.part, s->met = true;
}

static void see_miss(tracer *t, ray r, void *payload)
{
    (void)t, (void)r;
    ((seen *)payload)->missed = true;
}

static any_hit_answer see_any(const tracer *t, ray r, trace_hit x, void *payload)
{
    seen *s = payload;
    (void)t, (void)r;
    s->asked++;
    s->hopeless += s->accepted && x.h.t > s->best;
    if (s->end_at && s->asked == s->end_at) return ANY_HIT_END;
    if (x.h.shape % 3 == (uint32_t)s->ignore) return ANY_HIT_IGNORE;
    s->accepted++, s->best = x.h.t;
    return ANY_HIT_ACCEPT;
}

static const ray_program see_programs[ray_kinds] = {
    [RAY_CAMERA] = {1, false, NULL, see_hit, see_miss},
    [RAY_SHADOW] = {2, true, NULL, see_hit, see_miss},
    [RAY_REFLECTION] = {3, false, see_any, see_hit, see_miss},
    [RAY_REFRACTION] = {3, true, see_any, see_hit, see_miss},
    [RAY_SIGHT] = {3, false, NULL, NULL, NULL}};

/* The closest of two scenes and a mesh, by asking everybody. ignore: shapes of this index modulo 3
 * do not count; 3: all do. */
static bool brute(const trace_world *w, ray r, uint8_t mask, int ignore, seen *out)
{
    bool met = false;
    for (uint32_t k = 0; k < w->parts; k++) {
        const world_part *p = &w->part[k];
        const items *of = &p->tree.x;
        for (size_t i = 0; i < of->n && (p->mask & mask); i++) {
            hit h;
            if ((int)(i % 3) == ignore) continue;
            if (!(of->m ? triangle_hit(mesh_triangle(of->m, i), r, &h)
                        : shape_hit(of->s->shapes[i], r, &h))) continue;
            if (met && h.t >= out->h.t) continue;
            h.shape = (uint32_t)i;
            out->h = h, out->part = k, met = true;
        }
    }
    return met;
}

static void test_trace(void)
{
    enum { balls = 40 };
    shape ball[2][balls];
    world_part part[3];
    trace_world w = {part, 3};
    mesh pot = teapot_mesh(3);
    random_stream s = random_start(3, 0, 0);
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < balls; i++) {
            vec3 c = {random_next(&s) * 8 - 4, random_next(&s) * 8 - 4, random_next(&s) * 4};
            ball[k][i] = shape_of_sphere((sphere){c, random_next(&s) / 2});
            if (k && i % 4 == 0) ball[1][i] = ball[0][i];  /* ties between the parts */
            if (i % 5 == 4) ball[k][i] = ball[k][i - 1];   /* and within them */
        }
    scene scenes[2] = {{ball[0], balls}, {ball[1], balls}};
    world_part_of_scene(&scenes[0], 1, &part[0]);
    world_part_of_scene(&scenes[1], 2 | 1, &part[1]);
    world_part_of_mesh(&pot, 2, &part[2]);
    size_t n = check_count(20000), wrong[4] = {0}, hits[4] = {0}, ties = 0, early = 0, later = 0;
    size_t hopeless = 0;
    tracer t = {.w = &w, .program = see_programs};
    for (size_t i = 0; i < n; i++) {
        vec3 from = {random_next(&s) * 20 - 10, random_next(&s) * 20 - 10, random_next(&s) * 8};
        vec3 to = {random_next(&s) * 8 - 4, random_next(&s) * 8 - 4, random_next(&s) * 4};
        ray r = ray_between(from, to);
        if (i % 2) r.tmax = real_infinity;
        for (int kind = 0; kind < 4; kind++) {
            int ignore = kind < 2 ? 3 : (int)(i % 3);
            seen expected = {.met = false}, got = {.ignore = ignore};
            expected.met = brute(&w, r, see_programs[kind].mask, ignore, &expected);
            bool met = trace(&t, (ray_kind)kind, r, &got), first = see_programs[kind].first;
            hits[kind] += expected.met;
            wrong[kind] += met != expected.met || got.missed == met || got.met != (met && !first);
            if (met && !first)
                wrong[kind] += got.h.t != expected.h.t || got.h.shape != expected.h.shape
                               || got.part != expected.part || got.h.u != expected.h.u;
            ties += met && !first && got.part == 0 && got.h.shape % 4 == 0;
            if (kind < 2) wrong[kind] += got.asked != 0;
            if (first && met) early += got.asked == 1;
            if (first) later += got.accepted > 1;
            hopeless += (size_t)got.hopeless;
        }
        seen end = {.ignore = 3, .end_at = 2};  /* the second candidate ends it, whatever it is */
        trace(&t, RAY_REFLECTION, r, &end);
        later += end.asked > 2;
    }
    for (int k = 0; k < 4; k++) {
        check_equal(wrong[k], 0, "%s rays that differ from brute force", ray_kind_names[k]);
        check_equal(t.counts.rays[k], k == RAY_REFLECTION ? 2 * n : n, "all are counted");
        check_at_least(t.counts.hits[k], hits[k], "hits are counted");
        check_at_least(hits[k], n / 10, "and there are some");
    }
    check_equal(t.counts.hits[RAY_CAMERA], hits[RAY_CAMERA], "each hit once");
    check_at_least(ties, n / 100, "ties between parts are among them");
    check_at_least(early, n / 100, "a kind that wants the first hit often asks once");
    check_equal(hopeless, 0, "candidates behind the best so far, in this part or an earlier one");
    check_equal(later, 0, "candidates after ANY_HIT_END, or after the first");

    /* Of a part that is opaque nobody asks, whatever any_hit would say. */
    for (int k = 0; k < 3; k++) part[k].opaque = true;
    ray down = ray_from((vec3){0, 0, 9}, (vec3){0, 0, -1});
    seen blind = {.ignore = 0}, all = {.met = false};
    check(trace(&t, RAY_REFLECTION, down, &blind) && blind.asked == 0, "met, and nobody asked");
    brute(&w, down, 3, 3, &all);
    check(blind.h.t == all.h.t && blind.h.shape == all.h.shape, "the closest hit of all");
    for (int k = 0; k < 3; k++) part[k].opaque = false;

    seen nothing = {.ignore = 3};
    ray bad = ray_from((vec3){0, 0, 0}, vec(NAN, 0, 1));
    check(!trace(&t, RAY_CAMERA, bad, &nothing) && nothing.missed, "a NaN is a miss");
    nothing.missed = false;
    check(!trace(&t, RAY_REFLECTION, bad, &nothing) && nothing.missed && nothing.asked == 0,
          "and nobody is asked about it");
    check(trace(&t, RAY_SIGHT, ray_between((vec3){0, 0, 9}, (vec3){0, 0, 0}), NULL),
          "programs may all be NULL");
    world_part none = part[0];
    none.tree = (bvh8){.nodes = 0};
    const trace_world blank[2] = {{NULL, 0}, {&none, 1}};  /* nothing; a part without a tree */
    for (int k = 0; k < 2; k++) {
        ray on = ray_from((vec3){0, 0, 0}, (vec3){0, 0, 1});
        t.w = &blank[k], nothing.missed = false;
        check(!trace(&t, RAY_CAMERA, on, &nothing) && nothing.missed,
              "world %d, of nothing, is missed", k);
        nothing.missed = false;
        check(!trace(&t, RAY_REFLECTION, on, &nothing) && nothing.missed && nothing.asked == 0,
              "and has nothing to ask about");
    }
    for (int k = 0; k < 3; k++) world_part_free(&part[k]);
    world_part_free(&part[0]);  /* twice is allowed */
    mesh_free(&pot);
}

static vec3 other_up(const void *self, hit h, vec3 p)
{
    (void)self, (void)h, (void)p;
    return (vec3){0, 0, 1};
}

/* What is owed for a shape of the caller's: 256 epsilon of the way and its size, 2 of p. */
static void test_other(void)
{
    shape_other o = {.normal = other_up, .lo = {0, 0, 0}, .hi = {3, 4, 0}};
    hit h = {1, 0, 0, 7};
    surface near = surface_on_other(&o, h, (vec3){0, 0, 0}, 11);
    surface far = surface_on_other(&o, h, (vec3){(real)4096, 0, 0}, 11);
    check_equal(near.error / real_epsilon, 256 * (11 + 5), "256 of 11 + 5");
    check_equal(far.error / real_epsilon, 256 * (11 + 5) + 2 * 4096, "and 2 of 4096");
}

/* ---- light ----------------------------------------------------------------------------------- */

static void test_light(void)
{
    const vec3 up = {0, 0, 1}, o = {0, 0, 0};
    light lamp = {LIGHT_POINT, {3, 0, 4}, {50, 100, 0}};
    light sun = {LIGHT_DIRECTIONAL, {0, 0.6, 0.8}, {2, 3, 4}};
    light_sample x;
    real eps = 4 * real_epsilon;
    check(light_reaches(&lamp, o, up, up, &x), "above");
    check_close(x.E.x, 50 * 0.8 / 25, 2 * eps, "I cos / r^2 (18.1)");
    check_close(x.E.y, 100 * 0.8 / 25, 4 * eps, "I cos / r^2");
    check_equal(x.E.z, 0, "no blue");
    check(light_reaches(&sun, o, up, up, &x), "the sun");
    check_close(x.E.z, 4 * 0.8, 4 * eps, "E0 cos (18.2)");
    check(!light_reaches(&lamp, o, vneg(up), vneg(up), &x) && vzero(x.E), "behind");
    check(!light_reaches(&lamp, o, up, vneg(up), &x) && vzero(x.E), "behind the shading normal");
    check(!light_reaches(&lamp, o, vneg(up), up, &x) && vzero(x.E), "behind the surface");
    check(!light_reaches(&lamp, lamp.at, up, up, &x) && vzero(x.E), "in the lamp itself");
    check(!light_reaches(&lamp, (vec3){0, 0, 4}, up, up, &x), "in the horizon");
    lamp.colour = o;
    check(!light_reaches(&lamp, o, up, up, &x), "a black light");

    material m = {.kd = {0.5, 0.25, 0}, .ks = {0.5, 0, 0.125}, .shine = 2};
    vec3 E = {(real)pi, 1, 8}, l = {0.6, 0, 0.8}, v = {-0.6, 0, 0.8};
    vec3 c = blinn_phong(&m, up, l, v, E);  /* h = n: the lobe is 1 */
    check_close(c.x, 0.5 + 0.5 * (double)pi, 8 * eps, "Lambert kd E / pi, and ks E (18.3, 18.4)");
    check_close(c.y, 0.25 / (double)pi, eps, "Lambert alone");
    check_close(c.z, 1, eps, "the lobe alone");
    c = blinn_phong(&m, up, l, l, E);  /* h = l: n.h = 0.8, squared */
    check_close(c.z, 0.64, eps, "(n.h)^2");
    c = blinn_phong(&m, up, (vec3){1, 0, 0}, (vec3){-1, 0, 0}, E);
    check(vfinite(c), "l = -v: no half vector, and no NaN");
    m.shine = 2.5;
    c = blinn_phong(&m, up, (vec3){1, 0, 0}, (vec3){0, 0, -1}, E);
    check_equal(c.z, 0, "an eye below the shading normal: no highlight, and no NaN");
    lamp = (light){LIGHT_POINT, {0, 0, (real)(real_is_float ? 1e-20 : 1e-160)}, {1, 0, 0}};
    check(!light_reaches(&lamp, o, up, up, &x) && vzero(x.E), "so near that E overflows");
    check(material_reflects(&m) && !material_reflects(&(material){.shine = 1}), "black");
}

/* ---- shadows --------------------------------------------------------------------------------- */

static material matte(const void *context, trace_hit x, const surface *s)
{
    (void)x, (void)s;
    const vec3 *kd = context;
    return (material){.kd = *kd, .shine = 1};
}

/* A ball of radius 1 that lies on a floor, anywhere; light from above, or a lamp at height 3. The
 * floor is dark within the shadow's circle, to the point of contact: at 1e-4 from there the ball is
 * 5e-9 above the floor. The lamp's cone touches the ball at an angle of asin(1/2): tan = 1/sqrt 3,
 * radius 3/sqrt 3. */
static void test_contact(void)
{
    size_t wrong = 0, dark = 0, lost = 0, missed = 0, n = check_count(10000);
    for (int e = 0; e <= 4; e += 2)
        for (int lamp = 0; lamp < 2; lamp++) {
            real T = e ? pow((real)10, (real)e) : 0;
            vec3 c = {T, T, T}, kd = {1, 1, 1};
            vec3 corner[4] = {{T - 8, T - 8, T}, {T + 8, T - 8, T},
                              {T + 8, T + 8, T}, {T - 8, T + 8, T}};
            shape two[2] = {shape_of_polygon(polygon_of(corner, 4)),
                            shape_of_sphere((sphere){{T, T, T + 1}, 1})};
            scene sc = {two, 2};
            light L = {lamp ? LIGHT_POINT : LIGHT_DIRECTIONAL, {0, 0, 1}, {1, 1, 1}};
            if (lamp) L.at = (vec3){T, T, T + 3};
            world_part part;
            world_part_of_scene(&sc, MASK_ALL, &part);
            trace_world w = {&part, 1};
            shading how = {.lights = &L, .n = 1, .material_of = matte, .context = &kd};
            tracer t = {.w = &w, .program = shade_programs, .user = &how};
            double R = lamp ? sqrt(3) : 1;
            for (size_t i = 0; i < n; i++) {
                random_stream s = random_start(5, i, (uint64_t)e);
                /* nearer than this the ball is closer to the floor than reals tell */
                real least = 16 * sqrt(real_epsilon * real_max(1, T));
                real rho = least * pow(2 / least, random_next(&s)), a = 2 * pi * random_next(&s);
                vec3 p = vadd(c, (vec3){rho * cos(a), rho * sin(a), 0});
                double at = hypot((double)(p.x - c.x), (double)(p.y - c.y));
                if (fabs(at - R) < 1e-3 + 64 * (double)(real_epsilon * T) || at < (double)least)
                    continue;
                ray r = ray_between(vadd(p, vec(0, 0, -0.5)), p);  /* from below */
                r.tmax = real_infinity;
                hit h;
                missed += !shape_hit(two[0], r, &h);
                surface f = surface_facing(surface_of_shape(&two[0], r, h), (vec3){0, 0, -1});
                material m = matte(&kd, (trace_hit){h, 0}, &f);
                bool lit = !vzero(shade(&t, &how, f, &m, (vec3){0, 0, 1}));
                wrong += lit != (at > R);
                dark += !lit;
                ray fixed = ray_from(f.p, (vec3){0, 0, 1});
                fixed.tmin = 1e-3;
                lost += !lamp && at < R && shape_hit(two[1], fixed, &h) && h.t > 1;  /* far side */
            }
            world_part_free(&part);
        }
    check_equal(missed, 0, "rays up to the floor");
    check_equal(wrong, 0, "points of the floor that are lit or dark wrongly");
    check_at_least(dark, n, "points in the shadow");
    check_at_least(lost, n / 10, "an eps of 1e-3 begins inside the ball, near the contact");
}

/* ---- all of shade ---------------------------------------------------------------------------- */

static material shiny(const void *context, trace_hit x, const surface *s)
{
    (void)context, (void)s;
    if (x.part == 1) return (material){.kd = {1, 1, 1}, .shine = 1};
    return (material){.kd = {0.5, 0.25, 0}, .ks = {0, 0.5, 0.125}, .shine = 3, .ke = {0, 0, 7}};
}

/* (18.8) at the north pole of a ball, seen from above, by a d that is not unit: sun from (0.6, 0,
 * 0.8), h = (0.6, 0, 1.8) / sqrt(3.6). A lamp in front of a wall: what is behind it does not
 * shadow, whatever way the ray leaves. */
static void test_shade(void)
{
    shape ball = shape_of_sphere((sphere){{0, 0, 0}, 1});
    vec3 corner[4] = {{2, -9, -9}, {2, 9, -9}, {2, 9, 9}, {2, -9, 9}};
    shape wall = shape_of_polygon(polygon_of(corner, 4));
    scene s[2] = {{&ball, 1}, {&wall, 1}};
    world_part part[2];
    world_part_of_scene(&s[0], MASK_ALL, &part[0]), world_part_of_scene(&s[1], MASK_ALL, &part[1]);
    trace_world w = {part, 1};
    light L = {LIGHT_DIRECTIONAL, {0.6, 0, 0.8}, {1, 2, 4}};
    shading how = {.lights = &L, .n = 1, .material_of = shiny, .background = {3, 1, 4},
                   .ambient = {1, 2, 3}};
    tracer t = {.w = &w, .program = shade_programs, .user = &how};
    ray r = ray_from((vec3){0, 0, 5}, (vec3){0, 0, -4});
    double lobe = pow(1.8 / sqrt(3.6), 3), eps = 16 * (double)real_epsilon;
    vec3 c = shade_ray(&t, r);
    check_close(c.x, 0.5 + 0.8 * 0.5 / (double)pi, eps, "ambient and Lambert (18.8)");
    check_close(c.y, 0.5 + 1.6 * (0.25 / (double)pi + 0.5 * lobe), eps, "and the highlight");
    check_close(c.z, 7 + 3.2 * 0.125 * lobe, 4 * eps, "emission and highlight");
    c = shade_ray(&t, ray_from((vec3){0, 0, 5}, (vec3){0, 1, 0}));
    check(c.x == 3 && c.y == 1 && c.z == 4, "the background");

    ray (*const leaving_by[])(surface, vec3) = {NULL, leave, leave_first};
    w.parts = 2, L = (light){LIGHT_POINT, {1, 0, 2}, {2, 2, 2}};
    double cosine = 1 / sqrt(2);
    for (int k = 0; k < 3; k++) {
        how.leave = leaving_by[k];
        c = shade_ray(&t, r);
        check_close(c.x, 0.5 + cosine * 0.5 / (double)pi, eps, "a lamp before a wall, way %d", k);
    }
    world_part_free(&part[0]), world_part_free(&part[1]);
}

/* On a smoothed mesh the shading normal comes from the corners, and is another than n. */
static void test_smooth(void)
{
    mesh pot = teapot_mesh(4);
    size_t wrong = 0, apart = 0, flipped = 0;
    for (uint32_t i = 0; i < pot.triangles; i++) {
        hit h = {1, 0.25, 0.5, i};
        surface s = surface_of_mesh(&pot, h);
        vec3 ns = mesh_normal(&pot, i, h.u, h.v);
        wrong += s.ns.x != ns.x || s.ns.y != ns.y || s.ns.z != ns.z || s.shape != i;
        if (vzero(s.n)) continue;
        apart += vlength(vcross(s.n, s.ns)) > (real)0.01;
        flipped += !(vdot(s.n, s.ns) > 0);
    }
    check_equal(wrong, 0, "shading normals of the mesh");
    check_equal(flipped, 0, "on the same side as n");
    check_at_least(apart, pot.triangles / 4, "but not the same");
    mesh_free(&pot);
}

/* ---- only what is called for ----------------------------------------------------------------- */

static trace_counts counts_of(const light *L, vec3 kd, bool spend_all)
{
    shape ball = shape_of_sphere((sphere){{0, 0, 0}, 1});
    scene sc = {&ball, 1};
    world_part part;
    world_part_of_scene(&sc, MASK_ALL, &part);
    trace_world w = {&part, 1};
    shading how = {.lights = L, .n = 1, .material_of = matte, .context = &kd};
    how.spend_all = spend_all;
    tracer t = {.w = &w, .program = shade_programs, .user = &how};
    for (int i = 0; i < 100; i++)
        shade_ray(&t, ray_from((vec3){(real)(i % 10 - 5) / 8, (real)(i / 10 - 5) / 8, 5},
                               (vec3){0, 0, -1}));
    world_part_free(&part);
    return t.counts;
}

static void test_spent(void)
{
    light front = {LIGHT_DIRECTIONAL, {0, 0, 1}, {1, 1, 1}}, back = front, black = front;
    back.at.z = -1, black.colour = (vec3){0, 0, 0};
    vec3 white = {1, 1, 1}, none = {0, 0, 0};
    trace_counts c = counts_of(&front, white, false);
    check_equal(c.rays[RAY_CAMERA], 100, "camera rays");
    check_equal(c.rays[RAY_SHADOW], c.hits[RAY_CAMERA], "one a hit: the light is in front of all");
    check_equal(c.hits[RAY_SHADOW], 0, "nothing in between, the ball itself least of all");
    check_equal(counts_of(&back, white, false).rays[RAY_SHADOW], 0, "behind the surface: none");
    check_equal(counts_of(&black, white, false).rays[RAY_SHADOW], 0, "a black light: none");
    check_equal(counts_of(&front, none, false).rays[RAY_SHADOW], 0, "a black surface: none");
    check_equal(counts_of(&back, white, true).rays[RAY_SHADOW], c.rays[RAY_SHADOW], "if asked to");
    for (int k = RAY_REFLECTION; k < ray_kinds; k++)
        check_equal(c.rays[k], 0, "%s rays: nobody asked for them", ray_kind_names[k]);

    for (int e = 0; e <= 4; e += 4) {
        gallery *g = gallery_new(4, e ? pow((real)10, (real)e) : 0);
        image im[2];
        trace_counts spent[2] = {{{0}, {0}}};
        for (int k = 0; k < 2; k++) {
            im[k] = image_new(96, 54);
            shading how = gallery_shading(g);
            traced_view v = gallery_view(g, &how, 96, 54, false);
            v.counts = &spent[k], how.spend_all = k == 1;
            check(pixels_draw(&im[k], 1, 1 + 2 * k, "", traced_colour, &v), "drawn");
        }
        size_t bytes = 96 * 54 * 3 * sizeof(float);
        check(memcmp(im[0].rgb, im[1].rgb, bytes) == 0,
              "all rays spent, by three threads: the same picture");
        check_equal(spent[1].rays[RAY_SHADOW], 2 * (spent[0].hits[RAY_CAMERA]), "two lights each");
        check(spent[0].rays[RAY_SHADOW] < spent[1].rays[RAY_SHADOW] * 95 / 100,
              "of %zu shadow rays only %zu are called for", spent[1].rays[RAY_SHADOW],
              spent[0].rays[RAY_SHADOW]);
        for (int k = 0; k < 2; k++) image_free(&im[k]);
        gallery_free(g);
    }
}

/* The bulb is seen, and casts no shadow of its lamp; of what is in its shadow nothing changes if
 * it may cast one. */
static void test_masks(void)
{
    gallery *g = gallery_new(2, 0);
    shading how = gallery_shading(g);
    tracer t = {.w = &g->w, .program = shade_programs, .user = &how};
    vec3 bulb = g->bulb.sphere.c;
    vec3 c = shade_ray(&t, ray_between(vadd(bulb, (vec3){0, -5, 0}), bulb));
    check(c.z == 2, "the bulb is seen by its own light");
    surface floor = {{-4, -1, 0}, {0, 0, 1}, {0, 0, 1}, 1e-5, 0, 0};
    shade_lit lit = {false};
    check(!trace(&t, RAY_SHADOW, leave_to(floor, bulb), &lit) && lit.lit, "it lets its lamp shine");
    g->part[2].mask = MASK_ALL, lit.lit = false;
    check(trace(&t, RAY_SHADOW, leave_to(floor, bulb), &lit) && !lit.lit, "but would");
    gallery_free(g);
}

/* shade() as the notes print it (Real-Time Rendering, 4th ed., 26.1): the answer of the shadow ray
 * is not used, and what it hits is shaded, too, by shadow rays of its own. */
typedef struct { vec3 colour; int left; } printed_payload;

static void printed_closest_hit(tracer *t, ray r, trace_hit x, void *payload)
{
    const shading *how = t->user;
    printed_payload *p = payload;
    surface s = surface_facing(surface_of_trace(t, r, x), r.d);
    material m = how->material_of(how->context, x, &s);
    p->colour = vadd(m.ke, vmul(how->ambient, m.kd));
    for (int i = 0; i < how->n; i++) {
        light_sample at;
        printed_payload unused = {{0, 0, 0}, p->left - 1};
        light_reaches(&how->lights[i], s.p, s.n, s.ns, &at);
        if (unused.left > 0)  /* trace(shadow ray to L); */
            trace(t, RAY_SHADOW, shade_shadow_ray(how, s, &how->lights[i]), &unused);
        p->colour = vadd(p->colour, blinn_phong(&m, s.ns, at.l, vneg(vunit(r.d)), at.E));
    }
}

static void printed_miss(tracer *t, ray r, void *payload)
{
    (void)r;
    ((printed_payload *)payload)->colour = ((const shading *)t->user)->background;
}

static const ray_program printed_programs[ray_kinds] = {
    [RAY_CAMERA] = {MASK_SEEN, false, NULL, printed_closest_hit, printed_miss},
    [RAY_SHADOW] = {MASK_SHADOW, false, NULL, printed_closest_hit, printed_miss},
};

/* At most `depth` rays behind one another, the camera ray being the first; without that limit it
 * may never end. */
static vec3 printed_ray(tracer *t, ray r, int depth)
{
    printed_payload p = {{0, 0, 0}, depth};
    trace(t, RAY_CAMERA, r, &p);
    return p.colour;
}

/* On the ground floor of a house each ray towards a sun ends at the ceiling. As printed, that is
 * shaded, by shadow rays of its own, which end at the next: two suns, eight ceilings: 2 + 4 + ... +
 * 256 of them, and the suns shine in. Ours: one a light, and darkness. */
static void test_printed(void)
{
    vec3 corner[9][4];
    shape house[9];
    for (int k = 0; k < 9; k++) {
        for (int i = 0; i < 4; i++)
            corner[k][i] = vec(i % 3 ? 99 : -99, i > 1 ? 99 : -99, k);
        house[k] = shape_of_polygon(polygon_of(corner[k], 4));
    }
    scene sc = {house, 9};
    world_part part;
    world_part_of_scene(&sc, MASK_ALL, &part);
    trace_world w = {&part, 1};
    light suns[2] = {{LIGHT_DIRECTIONAL, {0, 0, 1}, {1, 1, 1}},
                     {LIGHT_DIRECTIONAL, {0, 0.6, 0.8}, {1, 1, 1}}};
    vec3 kd = {1, 1, 1};
    shading how = {.lights = suns, .n = 2, .material_of = matte, .context = &kd};
    tracer ours = {.w = &w, .program = shade_programs, .user = &how}, theirs = ours;
    theirs.program = printed_programs;
    ray down = ray_from(vec(0, 0, 0.5), vec(0.1, 0, -1));
    vec3 dark = shade_ray(&ours, down), bright = printed_ray(&theirs, down, 9);
    check(vzero(dark), "no sun inside");
    check_at_least((double)bright.x, 0.1, "as printed, they shine through ceilings");
    check_equal(ours.counts.rays[RAY_SHADOW], 2, "ours: one a light");
    check_equal(theirs.counts.rays[RAY_SHADOW], 510, "as printed: 2 + 4 + .. + 2^8");
    world_part_free(&part);
}

/* ---- sight ----------------------------------------------------------------------------------- */

/* A cube seen from inside: points on one wall do not see each other by rule, all others do. With a
 * wall across the middle, only those on one side of it. */
static void test_sight(void)
{
    enum { posts = 60 };
    int most = real_is_float ? 3 : 6;  /* in float, at 1e6, walls of 2 are 32 reals wide */
    for (int e = 0; e <= most; e += 3) {
        real T = e ? pow((real)10, (real)e) : 0;
        vec3 corner[28];
        shape wall[7];
        surface s[posts];
        for (int k = 0; k < 7; k++) {
            for (int i = 0; i < 4; i++) {
                real p[3], a = i == 1 || i == 2 ? 1 : -1, b = i >= 2 ? 1 : -1;
                int axis = k < 6 ? k / 2 : 0;
                p[axis] = k == 6 ? 0 : k % 2 ? 1 : -1;
                p[(axis + 1) % 3] = a, p[(axis + 2) % 3] = b;
                corner[4 * k + i] = (vec3){T + p[0], T + p[1], T + p[2]};
            }
            wall[k] = shape_of_polygon(polygon_of(corner + 4 * k, 4));
        }
        for (int walls = 6; walls <= 7; walls++) {
            scene sc = {wall, (size_t)walls};
            world_part part;
            world_part_of_scene(&sc, MASK_ALL, &part);
            trace_world w = {&part, 1};
            tracer t = {.w = &w, .program = shade_programs};
            for (int i = 0; i < posts; i++) {
                random_stream r = random_start(9, (uint64_t)i, 0);
                vec3 c = {T + (i % 2 ? (real)0.25 : (real)-0.25), T, T};
                ray x = ray_from(c, (vec3){random_next(&r) - (real)0.5, random_next(&r) - (real)0.5,
                                           random_next(&r) - (real)0.5});
                hit h = hit_none;
                (void)scene_hit(&(scene){wall, 6}, x, &h);
                s[i] = surface_facing(surface_of_shape(&wall[h.shape], x, h), x.d);
            }
            size_t wrong = 0, asked = 0, both = 0;
            for (int i = 0; i < posts; i++)
                for (int j = 0; j < posts; j++) {
                    bool apart = s[i].shape != s[j].shape;
                    bool across = (s[i].p.x > T) != (s[j].p.x > T);
                    bool expected = i == j || (apart && (walls == 6 || !across));
                    wrong += (i == j || sight(&t, s[i], s[j])) != expected;
                    asked += apart;
                    both += expected;
                }
            check_equal(wrong, 0, "cube with %d walls, T = %g", walls, (double)T);
            check_equal(t.counts.rays[RAY_SIGHT], asked, "one ray, but none within a wall");
            check_at_least(both, posts * posts / 4, "many see each other");
            world_part_free(&part);
        }
    }
}

/* Above one another in empty space: seen if both face the other. */
static void test_facing(void)
{
    trace_world nothing = {NULL, 0};
    tracer t = {.w = &nothing, .program = shade_programs};
    for (int k = 0; k < 4; k++) {
        vec3 n[2] = {{0, 0, k & 1 ? -1 : 1}, {0, 0, k & 2 ? 1 : -1}};
        surface a = {{0, 0, 0}, n[0], n[0], 0, 0, 0}, b = {{0, 0, 2}, n[1], n[1], 0, 0, 1};
        check(sight(&t, a, b) == (k == 0) && sight(&t, b, a) == (k == 0), "facing, case %d", k);
    }
    check_equal(t.counts.rays[RAY_SIGHT], 2, "no ray where the surface itself is in between");
}

/* ---- the edge of light ----------------------------------------------------------------------- */

/* The truth at p: what the round ball gets at the same place of its surface. */
static void edge_errors(const edge_ball *b, int size, bool lift, double *most, double *dark)
{
    size_t lit = 0, lost = 0;
    real step = (real)2.1 / (real)size;
    vec3 p;
    *most = 0;
    for (int i = 0; i < size * size; i++) {
        real x = ((real)(i % size) + (real)0.5) * step - (real)1.05;
        real y = (real)1.05 - ((real)(i / size) + (real)0.5) * step;
        real E = edge_light(b, x, y, lift, &p);
        if (E < 0) continue;
        double truth = fmax(0, (double)vdot(vunit(p), b->sun.at)), off = fabs((double)E - truth);
        *most = fmax(*most, off);
        lit += truth > 0, lost += truth > 0 && E == 0;
    }
    *dark = 100 * (double)lost / (double)lit;
}

/* The round ball is the truth. Its shading normals are exact here, so what is wrong is shadow. */
static void test_terminator(void)
{
    for (int fine = 2; fine <= 8; fine *= 2) {
        double most[2], dark[2];
        edge_ball b;
        edge_ball_build(&b, fine);
        for (int k = 0; k < 2; k++) edge_errors(&b, 60, k, &most[k], &dark[k]);
        check_at_most(most[1], 16 * (double)real_epsilon, "lifted, n = %d", fine);
        check_equal(dark[1], 0, "dark where it should be lit, lifted, n = %d", fine);
        check_at_least(most[0], 0.4 / fine, "in shade by its own triangles, n = %d", fine);
        check_at_least(dark[0], 1, "part of the lit half, n = %d", fine);
        edge_ball_free(&b);
    }
    /* From inside a ball bulges away: nothing to lift, and p stays. */
    edge_ball b;
    edge_ball_build(&b, 4);
    hit h = {1, (real)0.25, (real)0.5, 40};
    surface s = surface_of_mesh(&b.m, h);
    vec3 out = terminator_point(&b.m, h, s.p, 1), in = terminator_point(&b.m, h, s.p, -1);
    check_at_least((double)vdot(vsub(out, s.p), s.n), 1e-3, "lifted");
    check_at_most((double)vlength(vsub(in, s.p)), 4 * (double)real_epsilon, "not from inside");
    edge_ball_free(&b);
}

/* How far rays begin above the middle of a square floor of two triangles: some ten epsilon of its
 * side. What lies lower casts no shadow: a leaf at 2^-20 does on a floor of side 0.75 even in
 * float, and in float not on one of 0.85. */
static void test_floor(void)
{
    for (int k = 0; k < 2; k++) {
        real side = k ? (real)0.85 : (real)0.75, x = side / 2, low = (real)ldexp(1, -20);
        triangle t = {{-x, -x, 0}, {x, -x, 0}, {x, x, 0}};
        surface s = surface_on_triangle(t, 0, (real)0.02, (real)0.49);
        ray r = leave(s, (vec3){0, 0, 1});
        triangle leaf = {{-x, -x, low}, {x, -x, low}, {0, x, low}};
        hit h;
        check_at_least((double)(r.o.z / side), 9 * (double)real_epsilon, "the offset of a floor");
        check_at_most((double)(r.o.z / side), 11 * (double)real_epsilon, "as a part of its side");
        check(triangle_hit(leaf, r, &h) == !(real_is_float && k), "the leaf, side %g",
              (double)side);
    }
}

int main(void)
{
    return check_all("18_shade", test_facing, test_trace, test_other, test_light, test_contact,
                     test_shade, test_smooth, test_spent, test_masks, test_printed, test_sight,
                     test_terminator, test_floor);
}
