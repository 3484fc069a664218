/* Tests of 22_radiometry: irradiance of spheres and polygons against textbook form factors, against
 * 32 digits, and where the naive forms fail. */
#include "../chapters/22_radiometry/lab/measure_hard.h"
#include "22_inputs.h"
#include "check.h"

/* ---- the oracle itself, against digits of others ---- */

/* Computed from (22.13) with 80 digits by another program: R = 1, across, height, E. */
static void test_oracle(void)
{
    static const double list[][3] = {
        {2, 0.5, 0.19680187617896472434}, {1.25, -0.75, 0.014153726509890230922},
        {0x1p20, -0.5, 1.092184305149337395e-19}, {0x1p10, -1 + 0x1p-10, 2.0932375573092866342e-17},
        {0x1p6, -1 + 0x1p-20, 2.555488767452287925e-21},
        {1 + 0x1p-20, -0.5, 0.22920274651186429498}};
    for (int i = 0; i < 6; i++) {
        double a = list[i][0], h = list[i][1], e = list[i][2];
        check_at_most(relative(sphere_irradiance_exact(1, a, h), e), 1e-15, "oracle, sphere %d", i);
        real value = sphere_irradiance((sphere){{(real)a, 0, (real)h}, 1}, seen_from, seen_up);
        check_at_most(relative((double)value, e), 16 * eps, "default, sphere %d", i);
    }
    for (int i = 1; i < 64; i++) {  /* all round: the angles of (x, y) and (-x, y) make pi */
        wide x = wide_of(cos(PI * i / 64)), y = wide_of(sin(PI * i / 64));
        wide angle = wide_atan2(y, x), other = wide_atan2(y, wide_neg(x));
        check_close(wide_value(angle), PI * i / 64, 4.5e-16 * PI, "the angle %d pi / 64", i);
        check_at_most(fabs(wide_value(wide_sub(wide_add(angle, other), wide_pi))), 1e-30, "pi");
    }
    /* Machin: pi/4 = 4 atan(1/5) - atan(1/239), and pi = 4 atan2(1, 1) */
    wide machin = wide_sub(wide_mul(wide_of(4), wide_atan2(wide_of(1), wide_of(5))),
                           wide_atan2(wide_of(1), wide_of(239)));
    wide eighth = wide_atan2(wide_of(1), wide_of(1));
    check_at_most(fabs(wide_value(wide_sub(machin, eighth))), 1e-31, "Machin's formula");
    check_at_most(fabs(wide_value(wide_sub(wide_mul(wide_of(4), eighth), wide_pi))), 1e-30, "pi");
    wide tiny = wide_atan2(wide_of(1e-20), wide_of(1));
    check_at_most(relative(wide_value(tiny), 1e-20), 1e-15, "a tiny angle");
}

/* ---- spheres ---- */

static double sphere_e(double r, double a, double h)
{
    return (double)sphere_irradiance((sphere){{(real)a, 0, (real)h}, (real)r}, seen_from, seen_up);
}

static void test_known_spheres(void)
{
    /* p on the sphere: a half of all directions, turned by the angle b: pi/2 (1 + cos b) */
    const struct { double r, a, h, e; const char *where; } list[] = {
        {1, 0, 2, PI / 4, "above: pi (R/d)^2"},
        {1, 3, 1, PI / 10 / sqrt(10), "touching the horizon from above"},
        {1, 3, -1, 0, "touching it from below"}, {1, 0, -5, 0, "behind the surface"},
        {1, 0.5, 0, PI, "p inside: all directions shine"}, {1, 0, 1, PI, "p on it, facing it"},
        {1, 0, -1, 0, "p on it, facing away"}, {1, 1, 0, PI / 2, "p on it, facing along it"},
        {5, 4, 3, PI / 2 * (1 + 0.6), "p on it, oblique"},
        {5, 4, -3, PI / 2 * (1 - 0.6), "p on it, oblique, below"},
        {0, 1, 1, 0, "a point without a size"}};
    for (size_t i = 0; i < sizeof list / sizeof *list; i++)
        check_close(sphere_e(list[i].r, list[i].a, list[i].h), list[i].e, 4 * eps * list[i].e, "%s",
                    list[i].where);
    /* half below: asin s - s sqrt(1 - s^2), s = R/d: area of two segments, (22.13) with height 0 */
    double s = 0.5;
    check_close(sphere_e(1, 2, 0), asin(s) - s * sqrt(1 - s * s), 8 * eps, "half below");
    for (double far = 1e2; far < (real_is_float ? 1e6 : 1e40); far *= 10) {  /* -> 2/3 s^3 */
        double q = 1 / (double)(real)far;
        check_at_most(relative(sphere_e(1, far, 0), 2 * q * q * q / 3 * (1 + 0.3 * q * q)),
                      8 * eps + q * q * q * q, "half below, far");
    }
    check_equal(sphere_irradiance((sphere){{0, 0, 2}, (real)NAN}, seen_from, seen_up) > 0, 0,
                "NaN is no light");
}

static void test_hard_spheres(void)
{
    double worst = 0;
    size_t negative = 0;
    const double lo = real_is_float ? -6 : -14, far = real_is_float ? 4 : 8;
    for (size_t i = 0; i < check_count(40000); i++) {
        random_stream s = random_start(1, 0, i);
        real r = random_next(&s) < (real)0.5 ? size_between(&s, -3, 1) : 1;
        real a = r * (random_next(&s) < (real)0.3 ? 1 + size_between(&s, lo, 0)
                                                  : size_between(&s, -2, far));
        real how = random_next(&s), h = a * random_between(&s, -1, 1);
        if (how < (real)0.3) h = r * random_between(&s, -1, 1);
        else if (how < (real)0.6) h = -r * (1 - size_between(&s, lo, 0));
        else if (how < (real)0.8) h = r * size_between(&s, -8, 0) * (how < (real)0.7 ? 1 : -1);
        if (!(sphere_power(wide3_of((vec3){a, 0, h}), (double)r).hi > 0)) continue;
        double exact = sphere_irradiance_exact((double)r, (double)a, (double)h);
        sphere b = {{a, 0, h}, r};
        double value = (double)sphere_irradiance(b, seen_from, seen_up);
        /* 32 digits of terms of size R/d leave 16 of it; below 1e-30 float says nothing */
        if (exact < 1e-30 || exact < 1e-15 * (double)(r / a)) {
            check(value >= 0 && value <= 2e-15 * (double)(r / a) + 2e-30, "next to nothing");
            continue;
        }
        worst = check_worse(worst, relative(value, exact));
    }
    for (int i = 0; i < 1000; i++) {  /* slivers of a far sphere */
        real far_off = real_is_float ? 1000 : (real)1e6, h = -1 + (real)(i + 1) / 10000;
        sphere b = {{far_off, 0, h}, 1};
        negative += sphere_irradiance_naive(b, seen_from, seen_up) < 0;
        check(sphere_irradiance(b, seen_from, seen_up) > 0, "light is positive");
    }
    check_at_most(worst, 16 * eps, "what the header promises");
    check_at_least((double)negative, 10, "naive: negative light");
}

/* Turned any way, E is the same, as well as n and p know where they are. */
static void test_turned_spheres(void)
{
    double worst = 0;
    for (size_t i = 0; i < check_count(5000); i++) {
        random_stream s = random_start(2, 0, i);
        real z = random_between(&s, -1, 1), turn = random_between(&s, 0, 6.28);
        vec3 n = sample_turn(sqrt(1 - z * z), z, turn), x, y, p = {1, 2, 3};
        vbasis(n, &x, &y);
        real a = random_between(&s, 1.5, 8), h = random_between(&s, -0.9, 2);
        real phi = random_between(&s, 0, 6.28);
        vec3 f = vmadd(vmadd(vscale(x, a * cos(phi)), y, a * sin(phi)), n, h);
        double exact = sphere_irradiance_exact(1, (double)a, (double)h);
        /* height is off by some epsilon d <= 10, beside R + height >= 0.1, to the power 5/2 */
        worst = check_worse(
            worst, relative((double)sphere_irradiance((sphere){vadd(p, f), 1}, p, n), exact));
    }
    check_at_most(worst, 3 * 10 / 0.1 * 3 * eps, "turned and moved");
}

/* ---- polygons: the oracle ---- */

/* Howell, "A Catalog of Radiation Heat Transfer Configuration Factors": a rectangle a x b at height
 * c, one corner above p, parallel (B-3); and upright, its lower edge b in the plane, at distance c,
 * beginning beside p, height a (B-4). Times pi. */
static double parallel_corner(double a, double b, double c)
{
    double x = a / c, y = b / c, sx = sqrt(1 + x * x), sy = sqrt(1 + y * y);
    return (x / sx * atan(y / sx) + y / sy * atan(x / sy)) / 2;
}

static double upright_corner(double a, double b, double c)
{
    double y = sqrt(a * a + c * c);
    return (atan(b / c) - c / y * atan(b / y)) / 2;
}

static void test_known_polygons(void)
{
    for (size_t i = 0; i < check_count(500); i++) {
        random_stream s = random_start(3, 0, i);
        real a = random_between(&s, 0.25, 4), b = random_between(&s, 0.25, 4);
        real c = random_between(&s, 0.25, 4);
        double upright = upright_corner((double)a, (double)b, (double)c);
        rectangle ceiling = {{0, 0, c}, {0, b, 0}, {a, 0, 0}};
        rectangle wall = {{c, 0, 0}, {0, 0, a}, {0, b, 0}};
        rectangle sunk = {{c, 0, -1}, {0, 0, 1 + a}, {0, b, 0}};  /* what is below counts nothing */
        vec3 far = vadd(wall.o, wall.s), end = vadd(far, wall.t);
        double half = triangle_irradiance_exact((triangle){wall.o, far, end}, seen_from, seen_up)
                    + triangle_irradiance_exact((triangle){wall.o, end, vadd(wall.o, wall.t)},
                                                seen_from, seen_up);
        check_at_most(relative(rectangle_irradiance_exact(ceiling, seen_from, seen_up),
                               parallel_corner((double)a, (double)b, (double)c)), 1e-14,
                      "ceiling, Howell B-3");
        check_at_most(relative(rectangle_irradiance_exact(wall, seen_from, seen_up), upright),
                      1e-13, "wall, Howell B-4");
        check_at_most(relative(rectangle_irradiance_exact(sunk, seen_from, seen_up), upright),
                      1e-13 + 16 * eps, "wall, partly below");
        check_at_most(relative(half, upright), 1e-13 + 16 * eps, "two triangles of it");
    }
    const struct { rectangle r; vec3 n; double e; const char *where; } list[] = {
        {{{-(real)1e6, -(real)1e6, 1}, {0, 2e6, 0}, {2e6, 0, 0}}, {0, 0, 1}, PI, "a white sky"},
        {{{-1, -1, 1}, {0, 2, 0}, {2, 0, 0}}, {0, 0, -1}, 0, "behind the receiver"},
        {{{-1, -1, 1}, {2, 0, 0}, {0, 2, 0}}, {0, 0, 1}, 0, "behind the light"},
        {{{1, 1, 1}, {0, (real)0x1p-40, 0}, {(real)0x1p-40, 0, 0}}, {0, 0, 1}, 0x1p-80 / 9,
         "a tiny one: cos cos' / r^2 of its area"}};
    for (int i = 0; i < 4; i++)
        check_close(rectangle_irradiance_exact(list[i].r, seen_from, list[i].n), list[i].e,
                    1e-10 * list[i].e, "%s", list[i].where);
}

/* Those of the table of hard cases, and seeds of their own. */
static void test_hard_cases(void)
{
    radiometry_hard_run *r = allocate(1, sizeof *r);  /* naive is false */
    for (int k = 0; k < hard_cases; k++) {
        const radiometry_hard_case *c = &hard_list[k];
        bool fits = !real_is_float || c->size > 1e-6;  /* 1e-6: below what float's inputs resolve */
        if (!fits && c->kind != HARD_SPHERE_E && c->shape != SHAPE_ANY) continue;
        for (uint64_t seed = 20; seed < 20 + check_count(8); seed++) {
            hard_fill(r, c, seed);
            check_at_most(hard_error(r), 32 * eps, "%s, %s", hard_name[c->kind], c->input);
        }
    }
    const struct { int k; double least; } naive_fails[] = {  /* where no digit, or few, are left */
        {1, real_is_float ? 0.9 : 1e-6}, {5, 1}, {9, real_is_float ? 1 : 1e-3}};
    r->naive = true;
    for (int i = 0; i < 3; i++) {
        const radiometry_hard_case *c = &hard_list[naive_fails[i].k];
        hard_fill(r, c, 20);
        double off = hard_error(r);
        check(isnan(off) || off >= naive_fails[i].least, "naive, %s, %s: only off by %g",
              hard_name[c->kind], c->input, off);
    }
    free(r);
}

/* Light, and p, scaled by powers of two: the same solid angle, to the last bits. */
static void test_scales(void)
{
    const sphere b = {{2, 0, 0.5}, 1};
    const rectangle wall = {{2, -1, -1}, {0, 0, 3}, {0, 2, 0}};
    const triangle part = {wall.o, vadd(wall.o, wall.s), vadd(vadd(wall.o, wall.s), wall.t)};
    double sphere_omega = (double)sphere_solid_angle(b, seen_from);
    double part_omega = (double)fabs(triangle_solid_angle(part, seen_from));
    double wall_omega = (double)fabs(rectangle_solid_angle(wall, seen_from));
    for (int e = real_is_float ? -120 : -1000; e < (real_is_float ? 120 : 1000); e += 8) {
        rectangle r = rectangle_scaled(wall, e);
        vec3 corner = vadd(r.o, r.s);
        spherical_rectangle k = spherical_rectangle_of(r, seen_from);
        const triangle half = {r.o, corner, vadd(corner, r.t)};
        spherical_triangle h = spherical_triangle_of(half, seen_from);
        check_at_most(relative((double)sphere_solid_angle(sphere_scaled(b, e), seen_from),
                               sphere_omega), 4 * eps, "sphere in view, scaled by 2^%d", e);
        check_at_most(relative((double)k.omega, wall_omega), 24 * eps, "in view, scaled by 2^%d",
                      e);
        check_at_most(relative((double)h.omega, part_omega), 16 * eps, "half, by 2^%d", e);
        check_close(spherical_rectangle_sample(&k, 0.5, 0.5).y, 0.5, 64 * eps,
                    "the middle, scaled by 2^%d", e);
    }
}

int main(void)
{
    return check_all("22_irradiance", test_oracle, test_known_spheres, test_hard_spheres,
                     test_turned_spheres, test_known_polygons, test_hard_cases, test_scales);
}
