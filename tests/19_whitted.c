/* 19_whitted: the walk against closed forms and twice the precision: ball, hall of mirrors,
 * furnace; touching and nested bodies; no ray that is not called for; the same as a loop. */
#include "check.h"
#include "child.h"
#include "../common/image.h"
#include "../common/random.h"
#include "../common/numbers/wide.h"
#include "../chapters/07_mesh/scenes/teapot.h"
#include "../chapters/19_whitted/scenes/forty.h"
#include "../chapters/19_whitted/lab/pictures.h"
#include "../chapters/19_whitted/lab/ray_tree.h"
#include "../chapters/19_whitted/lab/whitted_loop.h"

/* ---- a small scene: shapes, each with a look ------------------------------------------------- */

typedef whitted_stage stage;

/* A square of side 2 h in the plane z = c.z. */
static void stage_square(stage *s, vec3 c, real h, bool up, whitted_look m)
{
    vec3 half = {h, h, 0};
    stage_floor(s, vsub(c, half), vadd(c, half), up, m);
}

/* The rays themselves, to look at. */
static void looked(tracer *t, ray r, ray_tree *x)
{
    const whitted *w = t->user;
    whitted watched = *w;
    watched.log = ray_tree_begin(x), t->user = &watched;
    whitted_from_air(t, r);
    t->user = w;
}

/* The ray that goes on straight through: the refractions, one after another. */
static int passed(const ray_tree *x, int refractions)
{
    int k = 0;
    for (int i = 1; i < x->n && refractions > 0; i++)
        if (x->node[i].from == k && x->node[i].kind == RAY_REFRACTION) k = i, refractions--;
    return refractions ? -1 : k;
}

/* What is left, (1 - R) of every interface, of a ray from `eye` straight down after so many
 * refractions, if it is in the sky then; else 0. Ends the stage. */
static vec3 left_below(stage *s, int depth, vec3 eye, int refractions, tracer *t, ray_tree *x)
{
    *t = stage_begin(s, depth);
    looked(t, ray_from(eye, (vec3){0, 0, -1}), x);
    int last = passed(x, refractions);
    bool out = last > 0 && !(x->node[last].t < real_infinity);
    stage_end(s);
    return out ? x->node[last].weight : (vec3){0, 0, 0};
}

/* ---- closed forms ---------------------------------------------------------------------------- */

/* In twice the precision: where a ray leaves a ball of glass, and how: d turns by i - t twice. */
typedef struct { wide3 o, d; wide weight; } wide_ray;

static wide wide_fresnel_through(wide n1, wide n2, wide ci, wide ct)
{
    wide p = wide_mul(n1, ci), q = wide_mul(n2, ct), u = wide_mul(n2, ci), v = wide_mul(n1, ct);
    wide rs = wide_div(wide_sub(p, q), wide_add(p, q));
    wide rp = wide_div(wide_sub(u, v), wide_add(u, v));
    wide r = wide_add(wide_mul(rs, rs), wide_mul(rp, rp));
    return wide_sub(wide_of(1), wide_mul(r, wide_of(0.5)));
}

/* n unit, against d; both in twice the precision. */
static wide3 wide_refract(wide3 d, wide3 n, wide n1, wide n2, wide *part)
{
    wide eta = wide_div(n1, n2), ci = wide_neg(wide3_dot(n, d)), one = wide_of(1);
    wide ss = wide_mul(wide_mul(eta, eta), wide_sub(one, wide_mul(ci, ci)));
    wide ct = wide_sqrt(wide_sub(one, ss));
    wide3 zero = {wide_of(0), wide_of(0), wide_of(0)};
    *part = wide_fresnel_through(n1, n2, ci, ct);
    return wide3_madd(wide3_madd(zero, d, eta), n, wide_sub(wide_mul(eta, ci), ct));
}

static wide_ray wide_through_ball(sphere b, ray r, real n)
{
    wide3 o = wide3_of(r.o), d = wide3_of(r.d), c = wide3_of(b.c), zero = {wide_of(0), wide_of(0),
                                                                          wide_of(0)};
    d = wide3_madd(zero, d, wide_div(wide_of(1), wide3_length(d)));
    wide R = wide_of((double)b.r), one = wide_of(1), n1 = wide_of((double)n), T1, T2;
    wide3 f = wide3_sub(o, c);
    wide h = wide3_dot(d, f), k = wide_sub(wide3_dot(f, f), wide_mul(R, R));
    wide D = wide_sub(wide_mul(h, h), k);
    wide t = wide_sub(wide_neg(h), wide_sqrt(D));
    wide3 p = wide3_madd(f, d, t), N = wide3_madd(zero, p, wide_div(one, R));
    wide3 w = wide_refract(d, N, one, n1, &T1);
    wide s = wide_mul(wide_of(-2), wide3_dot(w, p));  /* the chord */
    wide3 q = wide3_madd(p, w, s), M = wide3_madd(zero, q, wide_div(wide_of(-1), R));
    wide3 out = wide_refract(w, M, n1, one, &T2);
    return (wide_ray){wide3_madd(c, q, one), out, wide_mul(T1, T2)};
}

static double wide_off(wide3 a, vec3 b)
{
    return wide_value(wide3_length(wide3_sub(a, wide3_of(b))));
}

static void test_ball(void)
{
    double place = 0, direction = 0, weight = 0, beer = 0;
    size_t n = check_count(4000), seen = 0;
    for (size_t i = 0; i < n; i++) {
        random_stream q = random_start(7, i, 0);
        stage s = {0};
        ray_tree x;
        double e = floor(7 * (double)random_next(&q)) - 3;  /* place 0 .. 1e3 R, size 1e-3 .. 1e3 */
        real R = (real)pow(10, e), far = R * (real)(i % 3 == 0 ? 0 : i % 3 == 1 ? 10 : 1000);
        sphere b = {{far, -far, far}, R};
        s.media[1] = (medium){(real)1.1 + random_next(&q), {1 / R, (real)0.5 / R, 0}, 0};
        stage_add(&s, shape_of_sphere(b), whitted_clear(1, 1));
        tracer t = stage_begin(&s, 4);
        vec3 from = random_in_cube(&q, 1);
        vec3 at = {random_next(&q) - (real)0.5, random_next(&q) - (real)0.5, random_next(&q) / 2};
        ray r = ray_between(vmadd(b.c, vunit(from), 4 * R), vmadd(b.c, at, R));
        r.tmax = real_infinity;
        wide_ray exact = wide_through_ball(b, r, s.media[1].ior);
        looked(&t, r, &x);
        int last = passed(&x, 2), in = passed(&x, 1);
        stage_end(&s);
        if (last < 0) continue;
        seen++;
        /* o: error bound of surface.h, R eps (4 + 2 |p|/R), and entry's share, bent twice */
        double unit = (double)((R + far) * real_epsilon);
        place = check_worse(place, wide_off(exact.o, x.node[last].r.o) / unit);
        double near = (double)(R / (R + far)), chord = (double)x.node[in].t;
        double T = wide_value(exact.weight);
        direction = check_worse(direction, wide_off(exact.d, x.node[last].r.d) * near);
        weight = check_worse(weight, fabs((double)x.node[last].weight.z - T) * near);
        double left = (double)x.node[last].weight.x / T;
        beer = check_worse(beer, fabs(left - exp(-chord / (double)R)) * near);
    }
    check_at_least(seen, n * 9 / 10, "rays through the ball");
    check_at_most(place, 64, "where it leaves, in eps of R and of the coordinates");
    check_at_most(direction, 128 * (double)real_epsilon, "direction: i is off by eps |p| / R");
    check_at_most(weight, 128 * (double)real_epsilon, "light (1 - R1)(1 - R2)");
    check_at_most(beer, 64 * (double)real_epsilon, "absorbed on the chord");
}

/* Two mirrors that shine with 1 face each other. */
static tracer hall_of(stage *s, double mirror, int depth)
{
    whitted_look m = whitted_mirror(mirror);
    m.base.ke = (vec3){1, 1, 1};
    stage_square(s, (vec3){0, 0, 0}, 4, true, m);
    stage_square(s, (vec3){0, 0, 3}, 4, false, m);
    return stage_begin(s, depth);
}

/* With M = 1/2: 1 + 1/2 + 1/4 + ..: exact in binary. */
static void test_hall(void)
{
    stage s = {0};
    tracer t = hall_of(&s, 0.5, 1);
    for (int depth = 1; depth <= whitted_most_depth; depth *= 2) {
        s.w.depth = depth;
        t.counts = (trace_counts){0};
        vec3 c = whitted_from_air(&t, ray_from(vec(0.3, 0.2, 1), (vec3){0, 0, -5}));
        int digits = real_is_float ? 23 : 52, levels = depth < digits ? depth : digits + 1;
        check_close(c.x, 2 - 2 * ldexp(1.0, -depth), levels > digits ? 2 * (double)real_epsilon : 0,
                    "a geometric series, depth %d", depth);
        if (depth < 140)  /* then the weight is no float any more, and the branch is cut */
            check_equal(t.counts.rays[RAY_REFLECTION], (size_t)depth - 1, "one ray a level");
        check_equal(t.counts.rays[RAY_CAMERA], 1, "the eye ray is depth 1");
    }
    /* cut where the weight is at most 2^-10: what is missing is the rest of the series */
    s.w.depth = 256, s.w.least = (real)ldexp(1.0, -10);
    vec3 c = whitted_from_air(&t, ray_from((vec3){0, 0, 1}, (vec3){0, 0, 1}));
    check_equal((double)c.x, 2 - 2 * ldexp(1.0, -10), "cut");
    stage_end(&s);

    /* within a mirror ball, at any angle, depth 256: M = 255/256, ke = 1/256: L = 1 - M^256; M^k is
     * off by k epsilon / 2, the sum of M^k / 256 thus by 34, and by 40 as 256 are added */
    stage b = {0};
    whitted_look m = whitted_mirror(255.0 / 256);
    m.base.ke = (vec3){(real)1 / 256, 0, 0};
    stage_add(&b, shape_of_sphere((sphere){{5, 6, 7}, 2}), m);
    t = stage_begin(&b, 256);
    for (size_t i = 0; i < check_count(100); i++) {
        random_stream q = random_start(8, i, 0);
        vec3 d = {random_next(&q) - (real)0.5, random_next(&q) - (real)0.5, random_next(&q)};
        c = whitted_from_air(&t, ray_from(vec(5, 6.5, 8), d));
        check_close(c.x, 1 - pow(255.0 / 256, 256), 80 * (double)real_epsilon, "mirror ball");
    }
    b.w.depth = 1000;  /* no more than the stack has room for */
    c = whitted_from_air(&t, ray_from(vec(5, 6.5, 8), (vec3){1, 2, 3}));
    check_close(c.x, 1 - pow(255.0 / 256, 256), 80 * (double)real_epsilon, "depth at most 256");
    stage_end(&b);
}

/* In a sky that is 1 everywhere, clear glass is invisible: what is missing is the rest at the last
 * depth, and no more than 1 comes from anywhere. */
static void test_furnace(void)
{
    whitted_stage *k = tank_new();
    k->w.background = (vec3){1, 1, 1};
    for (int i = 0; i < 5; i++) k->media[i].absorb = (vec3){0, 0, 0};
    k->look[tank_stone] = whitted_mirror(1), k->look[tank_table] = k->odd = whitted_mirror(1);
    k->w.least = 0;
    tracer t = stage_tracer(k);
    camera c = tank_camera(1);
    double most = 0, mean = 0;
    size_t n = 0;
    for (int y = 2; y < 32; y += 3)
        for (int x = 2; x < 32; x += 3, n++) {
            k->w.depth = 13;
            ray r = camera_ray(c, (real)x, (real)y, 32, 32);
            double L = (double)whitted_from_air(&t, r).x;
            most = check_worse(most, L);
            mean += L;
        }
    stage_end(k), free(k);
    check_at_most(most, 1 + 64 * (double)real_epsilon, "never more than there is");
    check_at_least(mean / (double)n, 0.95, "and little less: what lies deeper than 13");
}

/* Radiance is squeezed into a smaller solid angle in glass: under a sky of 1 an eye in there sees
 * n^2 in every direction (19.11); test_on_table looks the other way. Nearer to the ball's surface
 * than 1 - 1/n some rays are reflected for ever. */
static void test_squeeze(void)
{
    const double n = 1.5;
    stage s = {0};
    s.media[1].ior = (real)n, s.w.background = (vec3){1, 1, 1};
    stage_add(&s, shape_of_sphere((sphere){{0, 0, 0}, 1}), whitted_clear(1, 1));
    tracer t = stage_begin(&s, 250);
    double worst = 0;
    for (size_t i = 0; i < check_count(200); i++) {
        random_stream q = random_start(12, i, 0);
        vec3 o = vscale((vec3){random_next(&q), random_next(&q), random_next(&q) / 2}, (real)0.4);
        vec3 d = {random_next(&q) - (real)0.5, random_next(&q) - (real)0.5, random_next(&q)};
        double L = (double)whitted_from_air(&t, ray_from(o, d)).x;
        worst = check_worse(worst, fabs(L - n * n));
    }
    check_at_most(worst, 256 * (double)real_epsilon, "an eye in glass under a sky of 1 sees n^2");
    s.media[1].absorb.x = 1, s.w.depth = 2;
    double L = (double)whitted_from_air(&t, ray_from((vec3){0, 0, 0}, (vec3){0, 0, 3})).x;
    check_close(L, n * n * 0.96 * exp(-1), 16 * (double)real_epsilon, "a way of 1 in glass");
    stage_end(&s);
}

/* Place i of a teapot with the normals of a smooth one, and a way past it, less than 3 degrees
 * above (side 1) or below (-1) the plane at right angles to n or, if `smooth`, ns. False: a place
 * without a normal. */
static bool smoothed_place(const mesh *pot, random_stream *q, size_t i, bool smooth, real side,
                           whitted_place *p, vec3 *past)
{
    hit h = {1, random_next(q) / 2, random_next(q) / 2, (uint32_t)(i * 7919 % pot->triangles)};
    p->s = surface_of_mesh(pot, h);
    vec3 n = smooth ? p->s.ns : p->s.n, u, v;
    if (vzero(p->s.n)) return false;
    vbasis(n, &u, &v);
    real turn = 2 * pi * random_next(q), tilt = random_next(q) / 20;
    *past = vunit(vmadd(vadd(vscale(u, cos(turn)), vscale(v, sin(turn))), n, side * tilt));
    return true;
}

/* The teapot of chrome. Reflected about the shading normal many grazing rays lead below the
 * surface, where they meet its back at once: black rims. */
static void test_smoothed(void)
{
    mesh pot = teapot_mesh(24);
    world_part part;
    world_part_of_mesh(&pot, MASK_ALL, &part);
    size_t grazing = 0, below = 0, back = 0, wrong = 0, n = check_count(20000);
    const medium air = {1, {0, 0, 0}, 0};
    const whitted_look chrome = whitted_mirror(1);
    const whitted w = {.depth = 4, .media = &air};
    for (size_t i = 0; i < n; i++) {
        random_stream q = random_start(13, i, 0);
        whitted_place p = {.m = &chrome, .left = {1, 1, 1}};
        vec3 d;
        hit h;
        if (!smoothed_place(&pot, &q, i, false, -1, &p, &d) || !(vdot(d, p.s.ns) < 0)) continue;
        whitted_branch b = whitted_eye(ray_from(vsub(p.s.p, d), d), (media_set){0}), child[2];
        grazing++, below += vdot(reflect(d, p.s.ns), p.s.n) < 0;
        wrong += whitted_children(&w, &b, &p, child) != 1 || !(vdot(child[0].r.d, p.s.n) > 0);
        back += bvh8_hit(&part.tree, child[0].r, &h) && h.shape == p.s.shape;
    }
    check_at_least(below, grazing / 20, "of %zu grazing rays lead below", grazing);
    check_equal(wrong, 0, "reflected rays that lead below the surface");
    check_equal(back, 0, "that meet the triangle that they leave");
    world_part_free(&part), mesh_free(&pot);
}

/* The same teapot of glass, from within: rays that get out nearly in the shading normal's plane. */
static void test_smoothed_glass(void)
{
    mesh pot = teapot_mesh(24);
    size_t below = 0, out = 0, wrong = 0, n = check_count(20000);
    const medium media[2] = {{1, {0, 0, 0}, 0}, {(real)1.5, {0, 0, 0}, 0}};
    const whitted_look glass = whitted_clear(1, 1);
    const whitted w = {.depth = 4, .media = media};
    for (size_t i = 0; i < n; i++) {
        random_stream q = random_start(14, i, 0);
        whitted_place p = {.m = &glass, .left = {1, 1, 1}};
        vec3 away;
        snell x;
        if (!smoothed_place(&pot, &q, i, true, 1, &p, &away)) continue;
        if (!snell_of(vneg(away), p.s.ns, 1, (real)1.5, &x)) continue;
        vec3 d = vneg(snell_refract(&x, vneg(away), p.s.ns)), outwards = p.s.n;
        p.s.n = vneg(p.s.n), p.s.ns = vneg(p.s.ns), p.inside = 1;  /* the ray is in the glass */
        whitted_branch b = whitted_eye(ray_from(vsub(p.s.p, d), d), (media_set){0}), child[2];
        if (!(vdot(d, outwards) > 0) || whitted_children(&w, &b, &p, child) != 2) continue;
        out++, below += vdot(away, outwards) < 0;
        wrong += child[0].kind != RAY_REFRACTION || !(vdot(child[0].r.d, outwards) > 0);
    }
    check_at_least(below, out / 20, "of %zu rays out of glass lead into it again", out);
    check_equal(wrong, 0, "refracted rays that lead below the surface");
    mesh_free(&pot);
}

/* ---- touching and nested --------------------------------------------------------------------- */

/* air | glass | water | glass | air, at normal incidence, the faces between them twice, of either
 * body, in any order of the shapes, anywhere: only the four true interfaces count. */
static void test_touching(void)
{
    static const int order[3][6] = {{0, 1, 2, 3, 4, 5}, {0, 2, 1, 4, 3, 5}, {5, 4, 3, 2, 1, 0}};
    static const struct { int z, body; bool up; } face[6] = {
        {3, 1, true}, {2, 1, false}, {2, 2, true}, {1, 2, false}, {1, 3, true}, {0, 3, false}};
    double ag = pow(0.5 / 2.5, 2), gw = pow((1.5 - 1.25) / (1.5 + 1.25), 2);
    double expected = (1 - ag) * (1 - gw) * (1 - gw) * (1 - ag), worst = 0, naive = 0;
    for (int o = 0; o < 3; o++)
        for (int e = 0; e <= 6; e += 2) {
            real T = e ? pow((real)10, (real)e) : 0;
            for (int apart = 0; apart < 2; apart++) {
                stage s = {0};
                ray_tree x;
                tracer t;
                for (int i = 0; i < 6; i++) {
                    int f = order[o][i];
                    stage_square(&s, (vec3){T, T, T + (real)face[f].z}, 2, face[f].up,
                                 whitted_clear((uint32_t)face[f].body, 1));
                }
                s.media[1].ior = s.media[3].ior = 1.5, s.media[2].ior = 1.25;
                s.w.apart = apart;
                vec3 eye = {T + (real)0.5, T + (real)0.25, T + 5};
                double got = (double)left_below(&s, 8, eye, 4, &t, &x).x;
                if (apart) naive = fmax(naive, fabs(got - expected));
                else worst = check_worse(worst, fabs(got - expected));
                check_equal(t.counts.hits[RAY_SIGHT], 0, "contact rays let all pass");
            }
        }
    check_at_most(worst, 16 * (double)real_epsilon, "(1 - R) of four interfaces");
    check_at_least(naive, 0.01, "face by face, one of two faces is passed unseen");
}

/* 1 - R at normal incidence. */
static double kept(double n1, double n2) { return 1 - pow((n1 - n2) / (n1 + n2), 2); }

/* Balls that coincide, that touch from inside, that are nested: along the axis. */
static void test_nested(void)
{
    static const struct { double ball[3][2]; } make[3] = {  /* z, radius */
        {{{0, 2}, {0, 1}, {0, 1}}},      /* two coincide */
        {{{0, 2}, {1, 1}, {1, 0.5}}},    /* one touches another from inside, at the top */
        {{{0, 2}, {0, 1.5}, {0, 0.5}}}}; /* three, one in the other */
    double a = 1, g = 1.5, w = 1.25, v = 1;
    for (int k = 0; k < 3; k++)
        for (int e = 0; e <= 4; e += 2) {
            real T = e ? pow((real)10, (real)e) : 0;
            stage s = {0};
            ray_tree x;
            tracer t;
            s.media[1].ior = (real)g, s.media[2].ior = (real)w, s.media[3].ior = (real)v;
            for (uint32_t j = 0; j < 3; j++) {
                vec3 c = {T, T, T + (real)make[k].ball[j][0]};
                stage_add(&s, shape_of_sphere((sphere){c, (real)make[k].ball[j][1]}),
                          whitted_clear(j + 1, 1));
            }
            double ag = kept(a, g), gw = kept(g, w), wv = kept(w, v);
            double T1 = ag * gw * wv * wv * gw * ag;
            int faces = 6;
            if (k == 0)  /* glass | air in it (the higher number) | glass */
                T1 = pow(ag * kept(g, v), 2), faces = 4;
            if (k == 1)  /* air | water | air | water | glass | air: one interface at the top */
                T1 = kept(a, w) * wv * wv * gw * ag, faces = 5;
            vec3 got = left_below(&s, 9, (vec3){T, T, T + 5}, faces, &t, &x);
            check_close(got.x, T1, 32 * (double)real_epsilon, "case %d, T = %g", k, (double)T);
        }
}

/* Glass that stands on a table: from within, the table is seen; face by face, the ray would go out
 * below. Whichever is found first. And a lower priority does not break in. */
static void test_on_table(void)
{
    for (int first = 0; first < 2; first++) {
        stage s = {0};
        whitted_look table = whitted_paint(0, 0, 0);
        table.base.ke = (vec3){1, 2, 4};
        s.media[1].ior = 1.5;
        if (first) stage_square(&s, (vec3){0, 0, 0}, 9, true, table);
        stage_square(&s, (vec3){0, 0, 1}, 2, true, whitted_clear(1, 1));
        stage_square(&s, (vec3){0, 0, 0}, 2, false, whitted_clear(1, 1));
        if (!first) stage_square(&s, (vec3){0, 0, 0}, 9, true, table);
        tracer t = stage_begin(&s, 2);
        vec3 c = whitted_from_air(&t, ray_from((vec3){0, 0, 5}, (vec3){0, 0, -1}));
        check_close(c.z, 4 * 0.96 / 2.25, 16 * (double)real_epsilon, "the table through its glass");
        s.w.apart = true;
        c = whitted_from_air(&t, ray_from((vec3){0, 0, 5}, (vec3){0, 0, -1}));
        if (!first) check_equal(c.z, 0, "face by face the table is not seen");
        stage_end(&s);
    }
    /* Two balls that overlap: the one of higher priority is whole. Through both along the axis:
     * air | 1 | 2 | air if 2 has priority; 1 ends within 2 without an interface. */
    for (int p = -1; p <= 1; p++) {
        stage s = {0};
        ray_tree x;
        tracer t;
        s.media[1] = (medium){1.5, {1, 0, 0}, 0}, s.media[2] = (medium){2, {0, 1, 0}, p};
        stage_add(&s, shape_of_sphere((sphere){{0, 0, 1}, 1.5}), whitted_clear(1, 1));
        stage_add(&s, shape_of_sphere((sphere){{0, 0, -1}, 1.5}), whitted_clear(2, 1));
        vec3 got = left_below(&s, 8, (vec3){0, 0, 9}, 4, &t, &x);  /* four faces, one passed */
        check_equal(x.node[passed(&x, 4)].depth, 4, "three interfaces, not four");
        /* faces at z = 2.5, 0.5, -0.5, -2.5 */
        double in1 = p < 0 ? 3 : 2, in2 = p < 0 ? 2 : 3;
        double T = (1 - 0.04) * (1 - pow(0.5 / 3.5, 2)) * (1 - 1.0 / 9);
        check_close(got.z, T, 16 * (double)real_epsilon, "light");
        check_close(got.x, T * exp(-in1), 16 * (double)real_epsilon, "way in 1");
        check_close(got.y, T * exp(-in2), 16 * (double)real_epsilon, "way in 2");
    }
}

/* A plate stands on a floor a million times its size (in float: a thousand), tilted, so that
 * coordinates are rounded: the floor is seen up to 32 eps of its size off its place, and no contact
 * ray of the plate reaches so far. `touch` says how far to look. */
static void test_touch(void)
{
    size_t lost[2] = {0}, n = 400;
    real size = real_is_float ? 1000 : 1000000;
    for (size_t i = 0; i < n; i++) {
        random_stream q = random_start(11, i, 0);
        vec3 z = vunit((vec3){random_next(&q) - (real)0.5, random_next(&q) - (real)0.5, 1}), a, b;
        vbasis(z, &a, &b);
        stage s = {0};
        whitted_look floor = whitted_paint(0, 0, 0);
        floor.base.ke = (vec3){1, 1, 1};
        s.media[1].ior = 1.5;
        for (int k = 0; k < 3; k++) {  /* floor, under side, upper side */
            real h = k ? 1 : size;
            vec3 *c = s.corner + 4 * k;
            for (int j = 0; j < 4; j++) {
                int m = k == 1 ? 3 - j : j;
                vec3 p = vscale(a, m == 1 || m == 2 ? h : -h);
                c[j] = vmadd(vmadd(p, b, m > 1 ? h : -h), z, k == 2 ? (real)0.5 : 0);
            }
            stage_add(&s, shape_of_polygon(polygon_of(c, 4)), k ? whitted_clear(1, 1) : floor);
        }
        tracer t = stage_begin(&s, 3);
        vec3 at = vscale(b, random_next(&q) / 2);
        at = vmadd(at, a, random_next(&q) / 2);
        ray r = ray_from(vmadd(at, z, 3), vneg(z));
        for (int k = 0; k < 2; k++) {
            s.w.touch = k ? 32 * size * real_epsilon : 0;
            double L = (double)whitted_from_air(&t, r).x;
            lost[k] += !(fabs(L - 0.96 / 2.25) < 16 * (double)real_epsilon);
        }
        stage_end(&s);
    }
    check_at_least(lost[0], n / 20, "the floor is missed without `touch`");
    check_equal(lost[1], 0, "and with it seen: (1 - R) / n^2 of its radiance, of %zu", n);
}

/* A face is found as far as both may be off their places, each by error + noise, and no farther. */
static void test_reach(void)
{
    static const struct { double off; bool found; } list[] = {
        {0, true}, {0.55, true}, {1.9, true}, {2.1, false}};
    for (size_t i = 0; i < 2 * (sizeof list / sizeof *list); i++) {
        stage s = {0};
        whitted_look room, glass = whitted_clear(1, 1);
        ray r = ray_from((vec3){(real)0.5, (real)0.25, 3}, (vec3){0, 0, -1});
        trace_hit x = {{3, 0, 0, 0}, 0};
        stage_square(&s, (vec3){0, 0, 0}, 1, true, glass);
        surface on = surface_of_shape(&s.shape[0], r, x.h);
        real z = (real)list[i / 2].off * (on.error + on.noise) * (i % 2 ? 1 : -1);
        stage_square(&s, (vec3){0, 0, z}, 1, true, whitted_paint(1, 1, 1));
        tracer t = stage_begin(&s, 3);
        const whitted_look *m = &glass;
        media_crossing c = {0};
        contact_find(&t, r, x, &on, &m, &room, &c);
        check((m != &glass) == list[i / 2].found, "a table %g (error + noise) from glass",
              list[i / 2].off);
        stage_end(&s);
    }
}

/* Which way the tank's faces look. */
static void test_tank(void)
{
    whitted_stage *k = tank_new();
    for (int i = tank_table + 1; i < tank_stone - 2; i++) {
        polygon f = k->shape[i].polygon;
        bool in = i > 6 && i < 13;  /* the cavity's */
        check((vdot(f.normal, vsub(f.v[0], vec(0, 0, 1))) > 0) == !in, "face %d", i);
    }
    stage_end(k), free(k);
}

/* ---- what a look says counts: one ball of glass, along its axis ------------------------------ */

static vec3 looked_at(whitted_look m, whitted *w, vec3 o, vec3 d)
{
    stage s = {.w = *w};
    s.media[1] = (medium){1.5, {1, 0, 0}, 0};
    stage_add(&s, shape_of_sphere((sphere){{0, 0, 0}, 1}), m);
    tracer t = stage_begin(&s, w->depth);
    vec3 c = whitted_from_air(&t, ray_from(o, d));
    stage_end(&s);
    return c;
}

static vec3 sky_above(const void *context, vec3 d)
{
    (void)context;
    return (vec3){d.z > 0 ? 1 : 0, d.z > 0 ? 0 : 1, 3};
}

/* Balls of glass of no refraction: within one another, seen from outside or from the middle, where
 * one after the other is left and none is entered; or sheets at one place. Of more than there is
 * room for the light would be wrong. */
typedef struct { int bodies; real z; bool sheets; } many_bodies;

static void look_through(void *context)
{
    const many_bodies *many = context;
    stage s = {0};
    s.w.background = (vec3){1, 1, 1};
    for (uint32_t k = 1; k <= (uint32_t)many->bodies; k++) {
        s.media[k].ior = 1;
        if (many->sheets) stage_square(&s, (vec3){0, 0, 0}, 1, k % 2 > 0, whitted_clear(k, 1));
        else stage_add(&s, shape_of_sphere((sphere){{0, 0, 0}, (real)k}), whitted_clear(k, 1));
    }
    tracer t = stage_begin(&s, 30);
    ray r = ray_from((vec3){0, 0, many->z}, (vec3){0, 0, -1});
    printf("%.3f", (double)whitted_from_air(&t, r).x);
    stage_end(&s);
}

static void test_too_many(void)
{
    static const struct { many_bodies of; const char *err; } list[] = {
        {{7, 50, false}, ""}, {{8, 0, false}, ""}, {{8, 5, true}, ""},
        {{8, 50, false}, "more than 7 bodies of glass lie around one another"},
        {{9, 5, true}, "more than 8 bodies of glass touch at one place"}};
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        many_bodies of = list[i].of;
        child_result r = child_run(look_through, &of);
        bool refused = *list[i].err != 0;
        check_equal(r.status, refused ? 2 : 0, "%d bodies, from %g: %s", of.bodies, (double)of.z,
                    r.err);
        check(refused ? strstr(r.err, list[i].err) != NULL : strcmp(r.out, "1.000") == 0,
              "%d bodies: said %s, seen %s", of.bodies, r.err, r.out);
    }
}

static void test_looks(void)
{
    double eps = (double)real_epsilon;
    vec3 up = {0, 0, 5}, down = {0, 0, -1}, c;
    whitted w = {.sky = sky_above, .depth = 2};
    whitted_look m = whitted_clear(1, 1);
    m.base.mirror = vec(0.5, 1, 0), m.base.through = (vec3){0, 0, 0};
    c = looked_at(m, &w, up, down);  /* R = 0.04 of the sky above, times M */
    check_close(c.x, 0.02, 0.02 * 4 * eps, "M of glass");
    check(c.y == 0 && c.z == 0, "the sky in the direction of the ray; M black");
    m.base.ke = (vec3){1, 2, 4}, w.depth = 1;
    c = looked_at(m, &w, up, down);
    check(c.x == 1 && c.y == 2 && c.z == 4, "glass shines, too");
    /* A medium without end around everything keeps all back that it absorbs at all. */
    stage s = {.w = {.background = {1, 1, 1}}};
    s.media[0].absorb = vec(0, 0.01, 1);
    stage_square(&s, (vec3){0, 0, 0}, 1, true, whitted_paint(0, 0, 0));
    tracer t = stage_begin(&s, 1);
    c = whitted_from_air(&t, ray_from(up, up));
    check(c.x == 1 && c.y == 0 && c.z == 0, "nothing is seen of the sky where it absorbs");
    stage_end(&s);
    /* A light through two bodies that keep a half and a quarter. */
    stage q = {.light = {{LIGHT_DIRECTIONAL, {0, 0, 1}, {pi, pi, pi}}}};
    q.w.n = 1;
    stage_square(&q, (vec3){0, 0, 0}, 9, true, whitted_paint(1, 1, 1));
    stage_add(&q, shape_of_sphere((sphere){{0, 0, 2}, 1}), whitted_clear(1, 0.5));
    stage_add(&q, shape_of_sphere((sphere){{0, 0, 5}, 1}), whitted_clear(2, 0.25));
    t = stage_begin(&q, 1);
    c = whitted_from_air(&t, ray_from((vec3){5, 0, 5}, (vec3){-1, 0, -1}));
    check_close(c.x, 0.125, 4 * eps, "both dim the light");
    stage_end(&q);
}

/* ---- only what is called for ----------------------------------------------------------------- */

typedef struct {
    const char *what;
    whitted_look m;
    double ior, least;
    int depth;
    bool inside;
    size_t reflections, refractions, contacts;
} called_for;

/* Ten rays at a ball; from inside: near the rim, nearly along it. */
static trace_counts ball_counts(const called_for *x)
{
    stage s = {0};
    s.media[1].ior = (real)x->ior, s.w.least = (real)x->least;
    stage_add(&s, shape_of_sphere((sphere){{0, 0, 0}, 1}), x->m);
    tracer t = stage_begin(&s, x->depth);
    for (int i = 0; i < 10; i++)
        whitted_from_air(&t, x->inside
                                 ? ray_from(vec(0, 0.95, 0), (vec3){1, (real)i / 100, 0})
                                 : ray_from((vec3){(real)i / 20, 0, 5}, (vec3){0, 0, -1}));
    stage_end(&s);
    return t.counts;
}

static void test_called_for(void)
{
    whitted_look paint = whitted_paint(0.5, 0.5, 0.5), half = whitted_mirror(0.5);
    whitted_look glass = whitted_clear(1, 1), shut = glass;
    shut.base.through = (vec3){0, 0, 0};
    whitted_look red = half, green = half, blue = half;
    red.base.mirror = vec(0.5, 0, 0), green.base.mirror = vec(0, 0.5, 0);
    blue.base.mirror = vec(0, 0, 0.5);
    const called_for list[] = {
        {"opaque, and no mirror", paint, 1, 0, 8, false, 0, 0, 0},
        {"a mirror: one each, away from it", half, 1, 0, 8, false, 10, 0, 0},
        {"a red one", red, 1, 0.4, 8, false, 10, 0, 0},
        {"a green one", green, 1, 0.4, 8, false, 10, 0, 0},
        {"a blue one", blue, 1, 0.4, 8, false, 10, 0, 0},
        {"depth 1: eye rays alone", half, 1, 0, 1, false, 0, 0, 0},
        {"a weight of 0.5 is not more than 0.5: cut", half, 1, 0.5, 8, false, 0, 0, 0},
        {"glass, depth 2: both; a contact ray a hit", glass, 1.5, 0, 2, false, 10, 10, 20},
        {"like the air around: R = 0", glass, 1, 0, 8, false, 0, 20, 20},
        {"nothing is let through, but reflected", shut, 1.5, 0, 8, false, 10, 0, 10},
        {"total reflection: one a level", glass, 1.5, 0, 5, true, 40, 0, 50},
        {"R = 0.04 is cut, what goes through is not", glass, 1.5, 0.05, 8, false, 0, 20, 20}};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        const called_for *x = &list[k];
        trace_counts c = ball_counts(x);
        check_equal(c.hits[RAY_CAMERA], 10, "%s: all hit", x->what);
        check_equal(c.rays[RAY_REFLECTION], x->reflections, "%s: reflections", x->what);
        check_equal(c.rays[RAY_REFRACTION], x->refractions, "%s: refractions", x->what);
        check_equal(c.rays[RAY_SIGHT], x->contacts, "%s: contact rays", x->what);
    }
}

static void same_picture(const char *name, whitted_stage *s, camera c)
{
    image a = image_new(24, 18), b = image_new(24, 18);
    traced_view v = whitted_view(s, c, 24, 18);
    trace_counts few = {0}, all = {0};
    s->w.depth = 5, s->w.least = 0, v.counts = &few;
    check(pixels_draw(&a, 1, 1, "", traced_colour, &v), "drawn");
    s->w.spend_all = true, v.counts = &all;
    check(pixels_draw(&b, 1, 1, "", traced_colour, &v), "all spent");
    check(memcmp(a.rgb, b.rgb, sizeof(float) * 3 * 24 * 18) == 0, "%s: the same bytes", name);
    size_t less = 0, more = 0;
    for (int k = 0; k < RAY_SIGHT; k++) {
        less += few.rays[k], more += all.rays[k];
        check(few.rays[k] <= all.rays[k], "%s: not more %s rays", name, ray_kind_names[k]);
    }
    check(few.rays[RAY_SHADOW] * 2 < all.rays[RAY_SHADOW], "%s: shadow rays", name);
    check(less < more * 9 / 10, "%s: %zu rays of %zu", name, less, more);
    image_free(&a), image_free(&b), stage_end(s), free(s);
}

static void test_spend_all(void)
{
    same_picture("two spheres", two_spheres_new(), two_spheres_camera((real)4 / 3));
    same_picture("tank", tank_new(), tank_camera((real)4 / 3));
    same_picture("forty balls", forty_new(), forty_camera((real)4 / 3));
}

/* What is cut off is worth no more than its weight times the brightest thing there is: 1 here. */
static void test_cut(void)
{
    whitted_stage *f = forty_new();
    camera c = forty_camera(1);
    whitted *w = &f->w;
    tracer t = stage_tracer(f);
    double worst = 0;
    for (size_t i = 0; i < check_count(2000); i++) {
        random_stream s = random_start(9, i, 0);
        real y = 100 * random_next(&s), x = 100 * random_next(&s);
        ray r = camera_ray(c, x, y, 100, 100);
        w->depth = 40, w->least = 0;
        vec3 all = whitted_from_air(&t, r);
        w->least = 0.001;
        t.counts = (trace_counts){0};
        vec3 cut = whitted_from_air(&t, r);
        size_t branches = t.counts.rays[RAY_REFLECTION] + t.counts.rays[RAY_REFRACTION] + 1;
        /* each ray leaves at most two cut branches of at most 0.001 each, times at most 1.5 */
        double lost = (double)(all.x - cut.x);
        check(lost >= -1e-6, "cutting takes away");
        worst = check_worse(worst, lost / (0.003 * (double)branches));
    }
    check_at_most(worst, 1, "what was cut");
    stage_end(f), free(f);
}

/* ---- the loop -------------------------------------------------------------------------------- */

/* The light along r if no face is left out: no part of the world has a name. */
static vec3 nothing_left_out(stage *w, ray r)
{
    tracer t = stage_tracer(w);
    w->part[0].id = w->part[1].id = world_unnamed;
    vec3 L = whitted_from_air(&t, r);
    w->part[0].id = w->part[1].id = 0;
    return L;
}

/* Does the ray of the eye end on what its children can't meet again? */
static bool left_for_good(stage *w, ray r)
{
    tracer t = stage_tracer(w);
    whitted_branch eye = whitted_eye(r, (media_set){0});
    whitted_place p;
    return whitted_find(&t, &eye, &p) && p.face.item != no_shape;
}

/* The same rays, and the same light but for the order of the sums. Ends the stage. */
static void test_loop(const char *name, stage *w, camera c)
{
    tracer a = stage_tracer(w), b = a;
    size_t n = check_count(1000), differ = 0, left = 0;
    double worst = 0;
    w->w.least = (real)1 / 1024, w->w.depth = 12;
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(10, i, 0);
        real y = 75 * random_next(&s), x = 100 * random_next(&s);
        ray r = camera_ray(c, x, y, 100, 75);
        vec3 u = whitted_from_air(&a, r), v = whitted_ray_loop(&b, r, (media_set){0});
        worst = check_worse(worst, (double)(vlength(vsub(u, v)) / (1 + vlength(u))));
        vec3 all = nothing_left_out(w, r);
        differ += memcmp(&u, &all, sizeof u) != 0, left += left_for_good(w, r);
    }
    check_at_most(worst, 64 * (double)real_epsilon, "%s: loop against recursion", name);
    check_equal(differ, 0, "%s: nothing is left out that would be met", name);
    check_at_least(left, n / 4, "%s: faces are left out", name);
    for (int k = 0; k < ray_kinds; k++)
        check_equal(b.counts.rays[k], a.counts.rays[k], "%s: %s rays", name, ray_kind_names[k]);
    check_at_least(a.counts.rays[RAY_REFLECTION], n / 10, "%s: a tree", name);
    stage_end(w), free(w);
}

static void test_loops(void)
{
    const real aspect = (real)4 / 3;
    test_loop("two spheres", two_spheres_new(), two_spheres_camera(aspect));
    test_loop("tank", tank_new(), tank_camera(aspect));
    test_loop("forty balls", forty_new(), forty_camera(aspect));
    stage s = {0};
    tracer t = hall_of(&s, 1, 1000);
    vec3 c = whitted_ray_loop(&t, ray_from(vec(0.3, 0.2, 1), (vec3){0, 0, -5}), (media_set){0});
    check_equal((double)c.x, 256, "as deep as the stack, between mirrors that keep all");
    stage_end(&s);
}

int main(void)
{
    return check_all("19_whitted", test_loops, test_ball, test_hall, test_furnace, test_squeeze,
                     test_smoothed, test_smoothed_glass, test_touching, test_nested, test_on_table,
                     test_touch, test_reach, test_tank, test_looks, test_too_many,
                     test_called_for, test_spend_all, test_cut);
}
