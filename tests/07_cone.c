/* 07_cone: open cones and cylinders against closed forms and an exact oracle. */
#include "check.h"
#include "07_trials.h"

/* Exact: every number here has few bits. t 0: a miss; u -1: any. */
static void closed_forms(void)
{
    const real e = real_epsilon, end = real_infinity;
    const cone tube = {{0, 0, 0}, 1, {0, 0, 2}, 1}, tip = {{0, 0, 0}, 1, {0, 0, 2}, 0},
               glass = {{0, 0, -1}, 1, {0, 0, 1}, -1}, inverse = {{0, 0, 0}, -1, {0, 0, 2}, 0};
    const struct { cone c; ray r; real t, u; const char *why; } list[] = {
        {tube, {{-4, 0, 1}, 0, {1, 0, 0}, end}, 3, 0.5, "straight at a tube, half way up"},
        {tip, {{-4, 0, 1}, 0, {1, 0, 0}, end}, 3.5, -1, "a cone: radius 1/2 at half height"},
        {tip, {{-4, 0, 1}, 3.75, {1, 0, 0}, end}, 4.5, -1, "tmin between both: the way out"},
        {tip, {{-4, 0, 1}, 4.5, {1, 0, 0}, 4.5}, 4.5, -1, "the interval is closed"},
        {tip, {{-4, 0, 1}, 4.25, {1, 0, 0}, 4.25}, 0, -1, "no hit in the middle"},
        {tube, {{-4, 0, 0}, 0, {1, 0, 0}, end}, 3, 0, "the base belongs to it"},
        {tube, {{-4, 0, 2}, 0, {1, 0, 0}, end}, 3, 1, "the top belongs to it"},
        {tube, {{-4, 0, 2 * (1 + e)}, 0, {1, 0, 0}, end}, 0, -1, "just above the top"},
        {tube, {{-4, 0, -e}, 0, {1, 0, 0}, end}, 0, -1, "just below the base"},
        {tube, {{-4, 1, 1}, 0, {2, 0, 0}, end}, 2, -1, "tangent: a hit"},
        {tube, {{-4, 1 + 2 * e, 1}, 0, {2, 0, 0}, end}, 0, -1, "just past the tangent"},
        {tube, {{0, 0, 1}, 0, {0, 0.25, 0}, end}, 4, -1, "from inside: the way out"},
        {tube, {{-4, 0, 4}, 0, {2, 0, -1}, end}, 2.5, -1, "in above the top: the far wall"},
        {tip, {{-4, 0, 2}, 0, {1, 0, 0}, end}, 4, 1, "through the tip"},
        {tip, {{-4, 0, 3}, 0, {1, 0, 0}, end}, 0, -1, "the mirrored cone is not there"},
        {tip, {{0, 0, 4}, 0, {0, 0, -1}, end}, 2, -1, "down the axis: the tip"},
        {tip, {{0.5, 0, 5}, 0, {0, 0, -2}, end}, 2, -1, "parallel to the axis: radius 1/2"},
        {tip, {{0, 0, 1}, 0, {-1, 0, 2}, end}, 0.25, -1, "parallel to one side: the other one"},
        {tip, {{0, 0, 1}, 0, {1, 0, -2}, end}, 0, -1, "and none the other way"},
        {tube, {{0.5, 0, 5}, 0, {0, 0, -1}, end}, 0, -1, "through an open tube"},
        {tube, {{1, 0, 5}, 0, {0, 0, -1}, end}, 0, -1, "along its wall: a miss, by rule"},
        {glass, {{-4, 0, 0.5}, 0, {1, 0, 0}, end}, 3.5, -1, "upper half of two cones"},
        {glass, {{-4, 0, -0.5}, 0, {1, 0, 0}, end}, 3.5, -1, "lower half of two cones"},
        {inverse, {{-4, 0, 1}, 0, {1, 0, 0}, end}, 3.5, -1, "both radii negative: the same side"}};
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        hit h = {0, -1, 0, 0};
        bool is = cone_hit(list[i].c, list[i].r, &h);
        check(is == (list[i].t != 0), "%s", list[i].why);
        check_equal(h.t, list[i].t, "t: %s", list[i].why);
        if (list[i].u >= 0) check_equal(h.u, list[i].u, "u: %s", list[i].why);
    }
}

static void degenerate(void)
{
    const hit kept = {7, 8, 9, 10};
    hit h = kept;
    real bad[] = {(real)NAN, real_infinity, -real_infinity};
    ray r = ray_from((vec3){-4, 0, 1}, (vec3){1, 0, 0});
    cone good = {{0, 0, 0}, 1, {0, 0, 2}, 1}, flat = {{0, 0, 1}, 2, {0, 0, 1}, 1},
         line = {{0, 0, 0}, 0, {0, 0, 2}, 0};
    check(!cone_hit(flat, r, &h), "no height: no side");
    check(!cone_hit(line, r, &h), "no radius: a line is never hit");
    check(!cone_hit(good, ray_from(r.o, (vec3){0, 0, 0}), &h), "direction 0");
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 14; k++) {
            real in[14] = {0, 0, 0, 1, 0, 0, 2, 1, -4, 0, 1, 1, 0, 0};
            in[k] = bad[i];
            cone c = {{in[0], in[1], in[2]}, in[3], {in[4], in[5], in[6]}, in[7]};
            check(!cone_hit(
                      c, ray_from((vec3){in[8], in[9], in[10]}, (vec3){in[11], in[12], in[13]}),
                      &h),
                  "input %d is %g: a miss", k, (double)bad[i]);
        }
    check(h.t == kept.t && h.u == kept.u && h.v == kept.v && h.shape == kept.shape,
          "a miss leaves the hit alone");
}

/* 64 epsilon for radii of the size of the height. A needle gets h / r times that: q, the origin
 * near the axis, is rounded at the scale of h. */
static void against_the_oracle(void)
{
    const real distances[] = {1, 100, 10000, 1000000};
    for (int kind = 0; kind < cone_kind_count; kind++)
        for (cone_aim aim = AIM_RANDOM; aim < aim_count; aim++)
            for (int j = 0; j < 4; j++) {
                double thin =
                    1 / (double)real_max(fabs(cone_kinds[kind].ra), fabs(cone_kinds[kind].rb));
                random_stream numbers = random_start(7, (uint64_t)kind, (uint64_t)(10 * j) + aim);
                cone_score s =
                    cone_play(&numbers, kind, aim, distances[j], check_count(4000), 64 * thin);
                check_equal(s.wrong[1], 0,
                            "%s, aim %d, distance %g: wrong answers of %zu, %zu hits",
                            cone_kinds[kind].name, aim, (double)distances[j], s.decided, s.hits);
                check_at_most(s.residual[1], 2,
                              "%s, aim %d, distance %g: off the side, in epsilon (1 + distance)",
                              cone_kinds[kind].name, aim, (double)distances[j]);
            }
}

/* Lines at right angles to the normal of a point, moved along that by anything from 1e-12 (float:
 * 1e-4) of the radius there to nothing: hit or miss is right however close the call, where the
 * radius is a hundredth of |ra| + |rb| or more. */
static void tangents(void)
{
    size_t wrong = 0, hits = 0, rays = check_count(400000);
    for (size_t i = 0; i < rays; i++) {
        random_stream s = random_start(19, i, 0);
        int kind = (int)(i % 5);
        cone c = some_cone(&s, kind);
        real u = random_between(&s, 0.1, 0.9), far = pow((real)10, random_between(&s, -1, 5));
        real radius = (fabs(c.ra) + fabs(c.rb)) * random_between(&s, 1, 2) / 100;
        if (kind != 0 && kind != 3) u = (radius - c.ra) / (c.rb - c.ra);  /* near the tip */
        vec3 g, n, p = point_of_side(c, u, random_between(&s, -pi, pi), &g, &n);
        vec3 d = vmadd(vcross(g, n), g, random_between(&s, -1, 1));
        real off = pow((real)10, -random_between(&s, real_is_float ? 4 : 12,
                                                 real_is_float ? 8 : 17));
        p = vmadd(p, n, random_between(&s, -1, 1) * off * fabs(c.ra + (c.rb - c.ra) * u));
        ray r = ray_from(vmadd(p, d, -far), vscale(d, random_between(&s, 1, 8)));
        hit h;
        bool is = cone_hit(c, r, &h);
        hits += is, wrong += is != cone_exact(c, r).hit;
    }
    check_equal(wrong, 0, "tangents but for rounding: wrong answers of %zu, %zu hits", rays, hits);
    check(hits > rays / 3 && hits < 2 * rays / 3, "half are hits: %zu of %zu", hits, rays);
}

/* The textbook is 100 times worse, at least: that is the point of the other one. */
static void naive_fails(void)
{
    for (int kind = 0; kind < 5; kind++) {
        random_stream numbers = random_start(8, (uint64_t)kind, 0);
        cone_score s = cone_play(&numbers, kind, AIM_GRAZING, 1000000, check_count(4000), 64);
        check_at_least((double)s.wrong[0] / (double)s.decided, 0.05, "%s: grazing from 1e6",
                       cone_kinds[kind].name);
        s = cone_play(&numbers, kind, AIM_RANDOM, 10000, check_count(4000), 64);
        check_at_least(s.residual[0], 100 * s.residual[1], "%s: residual from 1e4",
                       cone_kinds[kind].name);
    }
}

/* A cone of 1e-12 or 1e12 (double: 1e-90, 1e90) gives the hits of one of 1: scaling by a power of
 * 2 is exact, as long as t, 2^-80 of what it was at least, stays a normal float. */
static void scales(void)
{
    int most = real_is_float ? 40 : 300;
    size_t wrong = 0, hits = 0;
    random_stream numbers = random_start(9, 0, 0);
    for (size_t i = 0; i < check_count(20000); i++) {
        int e = (int)round(random_between(&numbers, -(real)most, (real)most)),
            f = (int)round(random_between(&numbers, -(real)most, (real)most));
        cone c = some_cone(&numbers, (int)(i % 5)), d = c;
        ray r = ray_at_cone(&numbers, c, (cone_aim)(i % aim_count), 10), q = r;
        real s = ldexp((real)1, e), k = ldexp((real)1, f);
        d.a = vscale(c.a, s), d.b = vscale(c.b, s), d.ra *= s, d.rb *= s;
        q.o = vscale(r.o, s), q.d = vscale(r.d, k);
        hit h = hit_none, g = hit_none;
        bool is = cone_hit(c, r, &h), is_scaled = cone_hit(d, q, &g);
        wrong += is != is_scaled || (is && !(h.u == g.u && ldexp(h.t, e - f) == g.t));
        hits += is;
    }
    check_equal(wrong, 0, "scaled hits that differ, of %zu", hits);
}

/* Of `r` at t from the side across it, or beyond its ends, in epsilon (L + |t d|). */
static double off_side(cone c, ray r, real t)
{
    wide3 a = wide3_of(c.a), w = wide3_sub(wide3_of(c.b), a);
    wide3 q = wide3_sub(wide3_madd(wide3_of(r.o), wide3_of(r.d), wide_of((double)t)), a);
    double h = wide_value(wide3_length(w)), slope = (double)(c.rb - c.ra) / h,
           u = wide_value(wide_div(wide3_dot(q, w), wide3_dot(w, w))),
           end = h * (u < 0 ? -u : u > 1 ? u - 1 : 0),
           side = cone_residual(c, r, t) / sqrt(1 + slope * slope),
           size = h + fabs((double)c.ra) + fabs((double)c.rb) + fabs((double)(t * vlength(r.d)));
    return fmax(side, end) / (size * (double)real_epsilon);
}

/* In a tangent plane: the discriminant is 0, and rounding makes of it what it likes. In the plane
 * of an end but for 1e-17: the ray passes between the ends' planes only 1e17 away. */
static void tangent_planes(void)
{
    const real x = 1248, y = 511.25, z = -895.75, o = 0.25;
    hit h;
    cone tube = {{x + 1, y, z}, 1, {x + 3 * o, y + 6 * o, z}, 1};
    ray r = ray_from((vec3){x - 1, y, z - 1}, (vec3){1 + o, 1, 0});
    check(cone_hit(tube, r, &h), "in a tangent plane: a hit");
    check_close(h.t, 24.0 / 17, 4 * real_epsilon, "where it crosses the line that touches");
    tube.a.x = x;
    check(cone_hit(tube, r, &h), "in a tangent plane of another tube: a hit");
    check_close(h.t, 4.0 / 3, 4 * real_epsilon, "where it crosses the line that touches");
    cone tip = {{0, -3 * o, -o}, o, {o, -2 * o, -o}, 0};
    r = (ray){{-9 * o, 0, 3 * o}, 2 * o, {1, 1, -1}, 1};
    check(!cone_hit(tip, r, &h), "parallel to a side, in its tangent plane: a miss");
    cone wide_end = {{-2 * o, 0, 1}, 2 * o, {6 * o, 2, 5 * o}, o};
    r = ray_from(vec(-0.2225618484, -1.1111835262, 1), (vec3){-1, 1, -o});
    r.d.z *= real_epsilon;
    check(!cone_hit(wide_end, r, &h), "below the base, and parallel to it: a miss");

    /* Nearly along a side, in double: alpha and the discriminant lose most of their digits. */
    cone cut = {{(real)0x1.7f928p+9, (real)-0x1.fe64p+7, (real)0x1.00048p+9}, 0.5,
                {(real)0x1.7fcdp+9, (real)-0x1.ffecp+7, (real)0x1.ff57p+8}, 0.2};
    r = ray_from((vec3){(real)0x1.7f9db9368e43dp+9, (real)-0x1.ffba9d4d6d4eep+7,
                        (real)0x1.ffcd3b3e134e3p+8},
                 (vec3){(real)0x1.0a53889ad24p-1, (real)-0x1.df986ecf0c2ap-2,
                        (real)-0x1.6daa66c8331a1p-1});
    if (cone_hit(cut, r, &h)) check_at_most(off_side(cut, r, h.t), 8, "nearly along a side");

    /* x1, x2, x3 at right angles, 3 long; beside a line of the side, in its tangent plane. The
     * numbers have so many bits that 32 digits round, too: alpha, beta and D are noise. */
    const vec3 x1 = {1, 2, 2}, x2 = {2, 1, -2}, x3 = {2, -2, 1};
    size_t hits = 0, along = 0;
    random_stream s = random_start(18, 0, 0);
    for (int i = 0; i < 20000; i++) {
        real k = floor(ldexp(random_between(&s, 0.5, 1), real_is_float ? 18 : 47)),
             beside = ldexp(k, -(int)random_between(&s, 0, real_is_float ? 3 : 9));
        cone c = {{0, 0, 0}, 9 * k, vscale(x3, 4 * k), 0};
        vec3 d = vmadd(vscale(x1, -3 * k), x3, 4 * k);
        vec3 p = vmadd(vscale(x1, 3 * k), x2, floor(beside));
        r = (ray){p, -real_infinity, d, real_infinity};
        hits += cone_hit(c, r, &h);
        r.o = vscale(x1, k);
        along += cone_hit(c, r, &h);
    }
    check_equal(hits, 0, "beside a line of the side, parallel to it: never a hit");
    check_equal(along, 20000, "nearer to the axis, parallel to a side: always a hit");
}

/* Every other one of quarters, 1000 away or not: tangents, rays in a tangent plane, along a side
 * or through the tip come up often here. The others are aimed so, and then turned by anything
 * from 1 to 1e-18. Whatever is reported must be on the side (7.14). */
static void always_on_the_side(void)
{
    double worst[2] = {0, 0};
    size_t hits = 0;
    random_stream s = random_start(15, 0, 0);
    for (size_t i = 0; i < check_count(300000); i++) {
        real x[13];
        for (int k = 0; k < 13; k++) x[k] = round(random_between(&s, -4, 4)) / 4;
        cone c = {{x[0], x[1], x[2]}, fabs(x[3]), {x[0] + x[4], x[1] + x[5], x[2] + x[6]}, x[3]};
        if (i % 3 == 0) c.rb = x[12];
        ray r = ray_from((vec3){x[7], x[8], x[9]}, (vec3){x[10], x[11], x[12]});
        if (i % 2) {
            if (i % 4 == 1) c = some_cone(&s, (int)(i / 4 % cone_kind_count));
            vec3 g, n, p = point_of_side(c, (x[7] + 1) / 2, pi * x[8], &g, &n);
            real off = pow((real)10, random_between(&s, real_is_float ? -9 : -18, 0));
            r.d = vmadd(vmadd(g, vcross(g, n), 4 * x[9]), direction(&s), off);
            r.o = vmadd(p, r.d, -pow((real)10, random_between(&s, -3, 6)));
        }
        vec3 far = {768, -256, 512};
        if (i % 5 == 0) c.a = vadd(c.a, far), c.b = vadd(c.b, far), r.o = vadd(r.o, far);
        for (int k = 0; k < 2; k++) {
            hit h;
            if (!(k ? cone_hit_naive : cone_hit)(c, r, &h)) continue;
            hits += k == 0;
            double off = off_side(c, r, h.t);
            if (k == 0 || off < HUGE_VAL) worst[k] = check_worse(worst[k], off);
        }
    }
    check_at_most(worst[0], 8, "off the side, in epsilon (7.14), of %zu hits", hits);
    check_at_least((double)hits, (double)check_count(300000) / 20, "some are hit");
    check_at_least(worst[1], 100, "the textbook is off the side");
}

static void normals_and_points(void)
{
    double worst = 0, worst_unit = 0, worst_point = 0;
    random_stream numbers = random_start(10, 0, 0);
    for (size_t i = 0; i < check_count(20000); i++) {
        cone c = some_cone(&numbers, (int)(i % 5));
        real turn = random_between(&numbers, -pi, pi);
        vec3 g, n, p = point_of_side(c, random_between(&numbers, 0, 1), turn, &g, &n);
        real radius = fabs(c.ra + (c.rb - c.ra) * vdot(vsub(p, c.a), vsub(c.b, c.a))
                           / vdot(vsub(c.b, c.a), vsub(c.b, c.a)));
        vec3 m = cone_normal(c, p);
        worst = check_worse(worst, (double)(vlength(vsub(m, n)) * real_min(1, radius)));
        worst_unit = check_worse(worst_unit, fabs((double)vlength(m) - 1));
        vec3 off = cone_point(c, vmadd(p, n, radius / 100));
        worst_point = check_worse(worst_point, cone_residual(c, ray_from(off, (vec3){1, 0, 0}), 0));
    }
    /* p is rounded by epsilon of its size 4, which turns the normal by that over the radius. */
    check_at_most(worst, 16 * (double)real_epsilon,
                  "normal against generator and circle, times the radius");
    check_at_most(worst_unit, 4 * (double)real_epsilon, "length of a normal");
    check_at_most(worst_point, 8 * (double)real_epsilon, "cone_point off the side");
    cone tip = {{0, 0, 0}, 1, {0, 0, 2}, 0}, tube = {{0, 0, 0}, 2, {0, 0, 2}, 2};
    check_close(cone_normal(tip, (vec3){0, 0, 2}).z, 1, 2 * real_epsilon,
                "normal at the tip: along the axis");
    check_equal(cone_normal(tube, (vec3){0, -2, 1}).y, -1,
                "normal of a tube points away from the axis");
    check_close(cone_normal(tip, vec(0.5, 0, 1)).z, 1 / sqrt((real)5), 2 * real_epsilon,
                "slope 2: n = (2,0,1)/sqrt 5");
}

int main(void)
{
    return check_all("07_cone", closed_forms, degenerate, against_the_oracle, tangents, naive_fails,
                     scales, tangent_planes, always_on_the_side, normals_and_points);
}
