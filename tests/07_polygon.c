/* 07_polygon: planar polygons against exact cases and an exact oracle, and the seams between
 * them. */
#include "check.h"
#include "07_trials.h"

static void turn(vec3 *v, size_t n, vec3 axis, vec3 offset)
{
    vec3 s, t;
    vbasis(axis, &s, &t);
    for (size_t i = 0; i < n; i++)
        v[i] = vadd(vadd(vadd(vscale(s, v[i].x), vscale(t, v[i].y)), vscale(axis, v[i].z)), offset);
}

/* A comb, seen from above and from below, upright and upside down, so that each edge is once an
 * upper and once a lower one: all coordinates are multiples of 1/8. */
static void exact_cases(bool over)
{
    const vec3 comb[] = {{0, 0, 1}, {8, 0, 1}, {8, 4, 1}, {6, 1, 1},
                         {4, 4, 1}, {2, 1, 1}, {0, 4, 1}};
    enum { n = sizeof comb / sizeof *comb };
    static const struct { real x, y; bool hit;
    } at[] = {{1, 1, true},      {2, 0.5, true},     {2, 2, false},      {6, 3, false},
              {4, 3.5, true},    {4, 4, true},       {0, 4, true},       {8, 4, true},
              {2, 1, true},      {6, 1, true},       {0, 0, true},       {8, 0, true},
              {4, 0, true},      {0, 2, true},       {8, 3, true},       {7, 2.5, true},
              {5, 2.5, true},    {3, 2.5, true},     {1, 2.5, true},     {1, 2.625, false},
              {4, 4.125, false}, {-0.125, 0, false}, {8.125, 0, false},  {-1, 4, false},
              {9, 1, false},     {2, 4, false},      {4, -0.125, false}, {2, 1.125, false},
              {-3, 1, false},    {1, 4, false},      {6, 4, false},      {7.5, 3.75, false}};
    static vec3 corner[3][n];
    for (int axis = 0; axis < 3; axis++)       /* in the planes z = 1, x = 1, y = 1 */
        for (int first = 0; first < n; first++)    /* from each corner, concave ones too */
            for (int side = -1; side <= 1; side += 2) {
                vec3 *v = corner[axis];
                for (int i = 0; i < n; i++) {
                    vec3 c = comb[(first + side * i + n) % n];
                    if (over) c.x = 8 - c.x, c.y = 4 - c.y;
                    v[i] = axis == 0   ? c
                           : axis == 1 ? (vec3){c.z, c.x, c.y}
                                       : (vec3){c.y, c.z, c.x};
                }
                polygon p = polygon_of(v, n);
                vec3 up = {axis == 1, axis == 2, axis == 0};
                check(vdot(p.normal, up) == (real)side,
                      "axis %d from corner %d: Newell's normal is exact", axis, first);
                for (size_t k = 0; k < sizeof at / sizeof *at; k++)
                    for (int tilt = 0; tilt < 2; tilt++) {
                        vec3 q = {at[k].x, at[k].y, 1},
                             d = tilt ? (vec3){1, -2, 4} : (vec3){0, 0, 2};
                        if (over) q.x = 8 - q.x, q.y = 4 - q.y;
                        vec3 o = vmadd(q, d, -3);
                        if (axis == 1) o = (vec3){o.z, o.x, o.y}, d = (vec3){d.z, d.x, d.y};
                        if (axis == 2) o = (vec3){o.y, o.z, o.x}, d = (vec3){d.y, d.z, d.x};
                        hit h, plain = {7, 7, 7, 7};
                        bool is = polygon_hit(p, ray_from(o, d), &h);
                        if (k < 3 || k > 27)  /* on no edge: there naive is right */
                            check(polygon_hit_naive(p, ray_from(o, d), &plain) == is
                                      && plain.t == (is ? 3 : 7), "naive, point %zu", k);
                        check(is == at[k].hit && (!is || h.t == 3),
                              "(%g, %g), axis %d, from corner %d, side %d, tilt %d",
                              (double)at[k].x, (double)at[k].y, axis, first, side, tilt);
                    }
            }
}

static void degenerate(void)
{
    vec3 v[4] = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
    const hit kept = {7, 8, 9, 10};
    hit h = kept;
    ray r = ray_from(vec(1, 0.5, -1), (vec3){0, 0, 1});
    check(polygon_hit(polygon_of(v, 4), r, &h) && h.t == 1, "a square");
    r.tmin = r.tmax = 1;
    check(polygon_hit(polygon_of(v, 4), r, &h), "the interval is closed");
    h = kept;
    r.tmin = 1.5, r.tmax = 2;
    check(!polygon_hit(polygon_of(v, 4), r, &h), "beyond the interval");
    const vec3 oblong[4] = {{1, 0, 2}, {7, 0, 2}, {7, 8, 2}, {1, 8, 2}};
    check_equal((double)polygon_of(oblong, 4).radius, 5, "half of the diagonal of 6 x 8");
    r = ray_from((vec3){1, 0, -1}, (vec3){0, 0, 1});
    for (size_t n = 0; n < 3; n++) check(!polygon_hit(polygon_of(v, n), r, &h), "%zu corners", n);
    vec3 line[4] = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 0, 0}},
         point[3] = {{1, 0, 0}, {1, 0, 0}, {1, 0, 0}};
    check(!polygon_hit(polygon_of(line, 4), r, &h), "corners in a line: no area");
    check(!polygon_hit(polygon_of(point, 3), r, &h), "all corners one point");
    check(!polygon_hit(polygon_of(v, 4), ray_from((vec3){-1, 1, 0}, (vec3){1, 0, 0}), &h),
          "exactly edge-on");
    check(!polygon_hit(polygon_of(v, 4), ray_from((vec3){-1, 0, 0}, (vec3){1, 0, 0}), &h),
          "along an edge");
    check(!polygon_hit(polygon_of(v, 4), ray_from((vec3){1, 1, -1}, (vec3){0, 0, 0}), &h),
          "direction 0");
    real bad[] = {(real)NAN, real_infinity, -real_infinity};
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 18; k++) {
            real in[18] = {0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0, 1, 1, -1, 0, 0, 1};
            in[k] = bad[i];
            vec3 w[4] = {{in[0], in[1], in[2]},
                         {in[3], in[4], in[5]},
                         {in[6], in[7], in[8]},
                         {in[9], in[10], in[11]}};
            check(!polygon_hit(polygon_of(w, 4), ray_from((vec3){in[12], in[13], in[14]},
                                                          (vec3){in[15], in[16], in[17]}), &h),
                  "input %d is %g: a miss", k, (double)bad[i]);
        }
    check(h.t == kept.t && h.shape == kept.shape, "a miss leaves the hit alone");
}

/* 4 epsilon for the plane; seen almost edge-on, an edge within 16 more gives the depth (7.16).
 * Nearer to an edge than 8 epsilon (size + distance) the corners' own rounding decides. */
static void against_the_oracle(void)
{
    enum { corners = 144 };
    static vec3 v[corners];
    const real distances[] = {1, 100, 10000};
    for (int j = 0; j < 3; j++) {
        size_t wrong = 0, hits = 0;
        double worst = 0;
        random_stream numbers = random_start(11, 0, (uint64_t)j);
        for (size_t i = 0; i < check_count(6000); i++) {
            int teeth = (int)random_between(&numbers, 3, 37);
            real depth = random_between(&numbers, 0.1, 0.9);
            size_t n = gear(v, teeth, random_between(&numbers, 0.5, 2), depth);
            vec3 axis = direction(&numbers), d = direction(&numbers),
                 offset = {random_between(&numbers, -1, 1), random_between(&numbers, -1, 1),
                           random_between(&numbers, -1, 1)};
            turn(v, n, axis, offset);
            polygon p = polygon_of(v, n);
            size_t k = (size_t)random_between(&numbers, 0, (real)n - 1);
            vec3 aim =
                i % 2 ? vmadd(v[k], vsub(v[(k + 1) % n], v[k]), random_between(&numbers, 0, 1))
                      : offset;
            real aside = i % 2 ? (real)1e-3 : random_between(&numbers, 0, 2);
            aim = vmadd(aim, direction(&numbers), aside);
            ray r = ray_from(vmadd(aim, d, -distances[j]),
                             vscale(d, random_between(&numbers, 0.5, 2)));
            polygon_truth truth = polygon_exact(p, r);
            hit h = hit_none;
            bool is = polygon_hit(p, r, &h);
            if (truth.margin < 8 * (double)(real_epsilon * (4 + distances[j]))) continue;
            wrong += is != truth.hit;
            hits += is;
            if (is && truth.hit) {
                double steep = fabs((double)(vdot(p.normal, r.d) / vlength(r.d)));
                double off = fabs((double)h.t - truth.t) * (double)vlength(r.d) * steep;
                worst = check_worse(worst, off / (double)(real_epsilon * (4 + distances[j])));
            }
        }
        check_equal(wrong, 0, "gears from %g: wrong answers, %zu hits", (double)distances[j], hits);
        check_at_most(
            worst, 20,
            "gears from %g: error of t |D| across the plane, in epsilon (size + distance)",
            (double)distances[j]);
    }
}

/* From inside at least one must be hit; the rays aim at corners and edges. */
static void seams(void)
{
    static gear_box box;
    const real translations[] = {0, 1, 1000, 100000};
    random_stream numbers = random_start(12, 0, 0);
    for (int j = 0; j < 4; j++)
        for (int k = 0; k < 2; k++) {
            size_t rays = check_count(j == 0 ? 300000 : 65000);
            gear_box_fill(&box, &numbers, translations[j], k == 1);
            check_equal(gear_box_slips(&box, &numbers, rays, false), 0,
                        "slips of %zu rays at seams, translation %g, %s", rays,
                        (double)translations[j], k ? "with triangles" : "with quads");
        }
    size_t rays = check_count(20000);
    gear_box_fill(&box, &numbers, 0, false);
    check_at_least(gear_box_slips(&box, &numbers, rays, true), rays / 100,
                   "the textbook polygon slips at 1 %% of the seams and more");
}

/* Corners in the other order, other starts, other scale: the same hits, bit for bit. */
static void same_answers(void)
{
    size_t turned = 0, scaled = 0, hits = 0;
    random_stream numbers = random_start(13, 0, 0);
    for (size_t i = 0; i < check_count(20000); i++) {
        vec3 v[12], w[12], x[12];
        size_t n = gear(v, 3, 1, 0.4), first = (size_t)random_between(&numbers, 0, 11);
        vec3 d = direction(&numbers), zero = {0, 0, 0};
        turn(v, n, direction(&numbers), zero);
        real s = ldexp((real)1, (int)random_between(&numbers, real_is_float ? -100 : -900,
                                             real_is_float ? 100 : 900));
        for (size_t k = 0; k < n; k++) w[n - 1 - (k + first) % n] = v[k], x[k] = vscale(v[k], s);
        real off = random_between(&numbers, 0, 1);
        vec3 aim = vscale(direction(&numbers), off);
        ray r = ray_from(vmadd(aim, d, -3), d), q = r;
        q.o = vscale(r.o, s), q.d = vscale(d, 4);
        hit h = hit_none, e = hit_none;
        bool is = polygon_hit(polygon_of(v, n), r, &h);
        hits += is;
        turned += is != polygon_hit(polygon_of(w, n), r, &e);
        scaled += is != polygon_hit(polygon_of(x, n), q, &e) || (is && h.t * s / 4 != e.t);
    }
    check_equal(turned, 0, "other orders of the corners that change the answer, of %zu hits", hits);
    check_equal(scaled, 0, "sizes that change the answer");
}

/* Of q from the polygon in the plane spanned by the exact, whole e1 and e2, the origin at v[0]. */
static double distance_from(const vec3 *v, size_t n, vec3 normal, const double q[3])
{
    double near = HUGE_VAL, nn = (double)vdot(normal, normal), up = 0;
    const double m[3] = {(double)normal.x, (double)normal.y, (double)normal.z};
    int k = vlongest(normal), a = (k + 1) % 3, b = (k + 2) % 3;
    bool inside = false;
    for (int i = 0; i < 3; i++) up += q[i] * m[i];
    double p[3] = {q[0] - up / nn * m[0], q[1] - up / nn * m[1], q[2] - up / nn * m[2]};
    for (size_t i = 0, j = n - 1; i < n; j = i++) {
        double ab = 0, aq = 0, rest = 0, f[3], e[3];
        for (int x = 0; x < 3; x++) {
            f[x] = q[x] - (double)(vaxis(v[j], x) - vaxis(v[0], x));
            e[x] = (double)(vaxis(v[i], x) - vaxis(v[j], x));
            ab += e[x] * e[x], aq += e[x] * f[x];
        }
        double t = ab > 0 ? aq / ab : 0;
        t = t > 0 ? (t < 1 ? t : 1) : 0;
        for (int x = 0; x < 3; x++) rest += (f[x] - t * e[x]) * (f[x] - t * e[x]);
        if (sqrt(rest) < near) near = sqrt(rest);
        double yj = (double)(vaxis(v[j], b) - vaxis(v[0], b)), yi = yj + e[b],
               xj = (double)(vaxis(v[j], a) - vaxis(v[0], a));
        if ((yi > p[b]) != (yj > p[b]) && p[a] < xj + e[a] * (p[b] - yj) / e[b]) inside = !inside;
    }
    double flat = fabs(up) / sqrt(nn);
    return inside && flat < near ? flat : near;
}

static const double eps = (double)real_epsilon;

/* D of (7.15). */
static double size_from(const vec3 *v, size_t n, vec3 o)
{
    double size = 0;
    for (size_t i = 0; i < n; i++) {
        vec3 f = vsub(v[i], o);
        size = fmax(size, fabs((double)vaxis(f, vlongest(f))));
    }
    return size;
}

/* Of `r` at t from the polygon, as distance_from, in epsilon D. */
static double off_polygon(const vec3 *v, size_t n, vec3 normal, ray r, real t)
{
    wide3 q = wide3_sub(wide3_madd(wide3_of(r.o), wide3_of(r.d), wide_of((double)t)),
                        wide3_of(v[0]));
    double at[3] = {wide_value(q.x), wide_value(q.y), wide_value(q.z)};
    return distance_from(v, n, normal, at) / (size_from(v, n, r.o) * eps);
}

static const int comb[7][2] = {{0, 0}, {8, 0}, {8, 4}, {6, 1}, {4, 4}, {2, 1}, {0, 4}};

/* A comb of whole numbers in a plane of whole numbers, wide or a sliver, seen flat, or edge-on but
 * for a little: whatever is reported must be on it (7.15). */
static void always_on_the_polygon(void)
{
    double worst = 0, worst_plane = 0;
    size_t hits = 0;
    random_stream s = random_start(16, 0, 0);
    for (size_t i = 0; i < check_count(100000); i++) {
        vec3 v[7], e1 = random_in_cube(&s, 4), e2 = random_in_cube(&s, 4);
        vec3 base = random_in_cube(&s, 99);
        e1 = (vec3){round(e1.x), round(e1.y), round(e1.z)};
        e2 = (vec3){round(e2.x), round(e2.y), round(e2.z)};
        base = (vec3){round(base.x), round(base.y), round(base.z)};
        if (i % 3 == 0) e1 = vadd(e2, vscale(e1, ldexp((real)1, real_is_float ? -6 : -30)));
        vec3 normal = vcross(e1, e2);
        if (vzero(normal)) continue;
        for (int k = 0; k < 7; k++)
            v[k] = vmadd(vmadd(base, e1, (real)comb[k][0]), e2, (real)comb[k][1]);
        real x = random_between(&s, -1, 1), y = random_between(&s, -1, 1);
        vec3 along = vadd(vscale(e1, x), vscale(e2, y)),
             aim = vmadd(base, e2, random_between(&s, 0, 4));
        aim = vmadd(aim, e1, random_between(&s, 0, 8));
        real tilt = pow((real)10, random_between(&s, real_is_float ? -9 : -18, 0));
        vec3 d = vmadd(along, vscale(normal, vlength(along) / vlength(normal)), tilt);
        if (i % 4 == 0) d = direction(&s);
        ray r = ray_from(vmadd(aim, d, -random_between(&s, 0, 9)), d);
        polygon p = polygon_of(v, 7);
        for (int k = 0; k < 2; k++) {
            hit h;
            if (k) p.trust = 0;  /* the plane's depth, whatever it is worth */
            if (!polygon_hit(p, r, &h)) continue;
            double off = off_polygon(v, 7, normal, r, h.t);
            if (k) worst_plane = check_worse(worst_plane, off);
            else hits++, worst = check_worse(worst, off);
        }
    }
    check_at_most(worst, 32, "off the polygon, in epsilon D (7.15), of %zu hits", hits);
    check_at_least((double)hits, (double)check_count(100000) / 20, "some are hit");
    if (check_count(100000) >= 10000)  /* rare: a few hundred rays may show none */
        check_at_least(worst_plane, 1000, "the depth of the plane (7.10) alone is off the polygon");
}

static vec3 of_doubles(const double x[3]) { return (vec3){(real)x[0], (real)x[1], (real)x[2]}; }

/* The comb again, in a plane with the ray: its picture is a line, and rounding has the edges of two
 * teeth change places there, each moved by 1.3 to 2.8 epsilon D. Between them is no comb, so one of
 * them must be taken itself. Three in double, three in float, found by climbing. */
static void edges_that_change_places(void)
{
    const struct { double base[3], e1[3], e2[3], o[3], d[3]; } list[6] = {
        {{-5, -2, 7}, {2, -3, 0}, {3, -4, 1},
         {0x1.a81c7f1622b49p+1, -0x1.b113fb961fe7dp+3, 0x1.1bed68245a37fp+3},
         {0x1.87a5482225e51p-6, -0x1.53823c8a2336fp-3, -0x1.0a133f03bc1d8p-2}},
        {{5, -7, 3}, {2, 0, 2}, {-3, 1, -4},
         {0x1.2c7ce381f9658p+3, -0x1.3223cfcc018c8p+1, 0x1.64175dd3e7224p+1},
         {-0x1.5493b753785e6p-4, -0x1.2143b440b052fp-2, 0x1.983d8cd7a4773p-3}},
        {{-6, -2, -1}, {0, 2, -2}, {-1, 4, -3},
         {-0x1.15f239955c65dp+3, 0x1.0b59837fdbd21p+4, -0x1.106066b52d9f2p+4},
         {0x1.4f9f9b417fcd9p-3, -0x1.aabfc5691584dp-4, -0x1.e8fee233d42e7p-5}},
        {{1, 0, 8}, {0, -3, -2}, {-1, -4, -3}, {-0x1.646ac6p+1, -0x1.86371ep+3, -0x1.6417aap+0},
         {0x1.5f26ccp-3, -0x1.12102ap-3, -0x1.06a26cp-5}},
        {{7, 3, 2}, {-3, 0, 3}, {4, 1, -3}, {-0x1.0537d6p+2, 0x1.28fe3cp+2, 0x1.d71b0ap+3},
         {0x1.f87cd8p-4, 0x1.5dfcdcp-3, 0x1.86f9b4p-5}},
        {{6, -4, 4}, {-2, 3, 0}, {-1, 3, -1}, {-0x1.25060cp+0, 0x1.77a5acp+2, 0x1.242864p+2},
         {0x1.90fcd6p-3, 0x1.aa0aa4p-6, -0x1.b47dacp-3}}};
    for (size_t i = real_is_float ? 3 : 0, end = i + 3; i < end; i++) {
        vec3 v[7], e1 = of_doubles(list[i].e1), e2 = of_doubles(list[i].e2);
        for (int k = 0; k < 7; k++)
            v[k] = vmadd(vmadd(of_doubles(list[i].base), e1, (real)comb[k][0]), e2,
                         (real)comb[k][1]);
        ray r = ray_from(of_doubles(list[i].o), of_doubles(list[i].d));
        hit h = hit_none;
        check(polygon_hit(polygon_of(v, 7), r, &h), "edges that change places, %zu: a hit", i);
        check_at_most(off_polygon(v, 7, vcross(e1, e2), r, h.t), 32,
                      "edges that change places, %zu: off the comb, in epsilon D (7.15)", i);
    }
}

/* Corners off their plane, by anything from the last bit to the polygon's own size: the point of a
 * hit is within their box, and 128 epsilon D (7.15). */
static void not_in_a_plane(void)
{
    double worst = 0;
    size_t hits = 0;
    random_stream s = random_start(17, 0, 0);
    for (size_t i = 0; i < check_count(100000); i++) {
        vec3 v[12], lo = {real_infinity, real_infinity, real_infinity}, hi = vneg(lo);
        size_t n = gear(v, 3, 1, 0.4);
        vec3 by = vscale(direction(&s), 3);
        turn(v, n, direction(&s), by);
        real off = pow((real)10, random_between(&s, real_is_float ? -8 : -17, 0));
        for (size_t k = 0; k < n; k++) {
            v[k] = vmadd(v[k], direction(&s), off);
            lo = vmin(lo, v[k]), hi = vmax(hi, v[k]);
        }
        vec3 d = direction(&s), aim = vadd(v[i % n], vscale(vsub(v[(i + 5) % n], v[i % n]),
                                                            random_between(&s, 0, 1)));
        ray r = ray_from(vmadd(aim, d, -random_between(&s, 0, 4)), d);
        hit h;
        if (!polygon_hit(polygon_of(v, n), r, &h)) continue;
        hits++;
        wide3 at = wide3_madd(wide3_of(r.o), wide3_of(r.d), wide_of((double)h.t));
        wide p[3] = {at.x, at.y, at.z};
        for (int k = 0; k < 3; k++) {
            double below = wide_value(wide_sub(wide_of((double)vaxis(lo, k)), p[k])),
                   above = wide_value(wide_sub(p[k], wide_of((double)vaxis(hi, k))));
            worst = check_worse(worst, fmax(below, above) / (size_from(v, n, r.o) * eps));
        }
    }
    check_at_most(worst, 128, "off the corners' box, in epsilon D (7.15), of %zu hits", hits);
    check_at_least((double)hits, (double)check_count(100000) / 20, "some are hit");
}

/* Three corners are in a plane whatever they are. Aimed at edges, and steep enough for the depth of
 * the plane or hardly: what that is off along the ray is off the triangle. */
static void at_an_edge(void)
{
    double worst = 0;
    size_t hits = 0;
    random_stream s = random_start(20, 0, 0);
    for (size_t i = 0; i < check_count(1000000); i++) {
        vec3 v[3] = {random_in_cube(&s, 1), random_in_cube(&s, 1), random_in_cube(&s, 1)};
        vec3 e1 = vsub(v[1], v[0]), e2 = vsub(v[2], v[0]), n = vunit(vcross(e1, e2));
        vec3 along = vscale(e1, random_between(&s, -1, 1));
        along = vunit(vadd(along, vscale(e2, random_between(&s, -1, 1))));
        vec3 d = vmadd(along, n, pow((real)10, random_between(&s, -2.5, -0.5)));
        vec3 aim = vmadd(v[i % 3], vsub(v[(i + 1) % 3], v[i % 3]), random_between(&s, 0, 1));
        ray r = ray_from(vmadd(aim, d, -random_between(&s, 0, 2)), d);
        hit h;
        if (!polygon_hit(polygon_of(v, 3), r, &h)) continue;
        hits++;
        worst = check_worse(worst, off_polygon(v, 3, vcross(e1, e2), r, h.t));
    }
    check_at_most(worst, 32, "off a triangle, in epsilon D (7.15), of %zu hits", hits);
    check_at_least((double)hits, (double)check_count(1000000) / 4, "some are hit");
}

/* Corners by turns above and below a plane, seen at the angle at which that counts: on an edge that
 * lies off the plane, the plane's depth is wrong by off / steep along the ray, out of the polygon.
 * x of the edge that the ray passes is known to all digits, and so is x of the point. */
static void beside_a_warped_edge(void)
{
    double worst = 0;
    size_t hits = 0;
    random_stream s = random_start(19, 0, 0);
    for (size_t i = 0; i < check_count(40000); i++) {
        real off = real_epsilon * random_between(&s, 0, 128), y = random_between(&s, -0.25, 0.25);
        vec3 v[4] = {vec(1, -0.25, 0), vec(1.125, 0.25, 0), vec(-1, 0.25, 0),
                     vec(-1.125, -0.25, 0)};
        for (int k = 0; k < 4; k++) v[k].z = k % 2 ? -off : off;
        real steep = pow((real)10, random_between(&s, -2, 0)), z = -off * 4 * y;
        vec3 d = {1, 0, i % 2 ? steep : -steep};
        polygon p = polygon_of(v, 4);
        ray r = ray_from((vec3){0, y, 0}, d);
        r.o.z = z - d.z * (1 + (y + (real)0.25) / 4);
        hit h;
        if (!polygon_hit(p, r, &h)) continue;
        hits++;
        wide edge = wide_add(wide_of(1), wide_div(wide_add(wide_of((double)y), wide_of(0.25)),
                                                  wide_of(4)));
        double over = wide_value(wide_sub(wide_of((double)h.t), edge));
        worst = check_worse(worst, over / (size_from(v, 4, r.o) * eps));
    }
    check_at_most(worst, 128, "beyond a warped edge, in epsilon D (7.15), of %zu hits", hits);
    check_at_least((double)hits, (double)check_count(40000) / 4, "some are hit");
}

int main(void)
{
    exact_cases(false);
    exact_cases(true);
    degenerate();
    against_the_oracle();
    seams();
    same_answers();
    always_on_the_polygon();
    edges_that_change_places();
    not_in_a_plane();
    at_an_edge();
    beside_a_warped_edge();
    return check_report("07_polygon");
}
