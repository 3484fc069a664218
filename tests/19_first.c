/* 19's first.h: reflection, refraction and Fresnel as reflect.h and refract.h have them,
 * and the radiance of whitted.h on two balls over a board; what n2 = n1 (1 + epsilon) and glass that
 * touches glass make of it. */
#include "check.h"
#include "../common/random.h"
#include "19_first_world.h"

static const double ulp = (double)real_epsilon;

static double apart(vec3 a, vec3 b) { return (double)vlength(vsub(a, b)); }

/* Glass, water, diamond and air, at angles away from grazing and critical ones. */
static void test_laws(void)
{
    const real ior[4] = {1, (real)1.33, (real)1.5, (real)2.4};
    double mirror = 0, bend = 0, share = 0;
    size_t n = check_count(50000), bends = 0, total = 0, wrong = 0;
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(1, i, 0);
        vec3 N = vunit(random_unit(&s)), d = vunit(random_unit(&s)), w = vec(0, 0, 0), v;
        real n1 = ior[i % 4], n2 = ior[i / 4 % 4];
        if (vdot(d, N) > 0) N = vneg(N);
        mirror = check_worse(mirror, apart(first_reflect(d, N), reflect(d, N)));
        snell x;
        bool through = snell_of(d, N, n1, n2, &x), first = first_refract(d, N, n1, n2, &w);
        double k = 1 - (1 - x.ci * x.ci) * (double)(n1 / n2 * (n1 / n2));
        if (n1 == n2 || x.ci < 0.05 || fabs(k) < 0.01) continue;
        wrong += through != first;
        total += !first;
        if (!first || !through) continue;
        v = snell_refract(&x, d, N);
        bends++, bend = check_worse(bend, apart(w, v));
        real ci = -vdot(d, N), ct = -vdot(w, N);
        share = check_worse(share, fabs((double)(first_fresnel(ci, ct, n1, n2) - fresnel(&x))));
    }
    check_equal(wrong, 0, "through or not, of %zu", bends + total);
    check_at_least(bends, n / 3, "are refracted"), check_at_least(total, n / 10, "are not");
    check_at_most(mirror, 8 * ulp, "first_reflect against reflect");
    check_at_most(bend, 256 * ulp, "first_refract against snell_refract");
    check_at_most(share, 512 * ulp, "first_fresnel against fresnel");
}

/* Somewhere about r, whitted.h sees something else. */
static bool near_edge(const first_world *x, ray r, vec3 c)
{
    vec3 a, b;
    vbasis(r.d, &a, &b);
    for (int k = 0; k < 8; k++) {
        ray beside = r;
        real off = k < 4 ? (real)2e-4 : (real)2.5e-5;
        beside.d = vmadd(r.d, k & 2 ? a : b, k % 2 ? off : -off);
        if (apart(first_world_ray(x, beside), c) > 0.05 * (0.1 + (double)vlength(c))) return true;
    }
    return false;
}

/* Through glass, over chrome: at depth 8, and where the eye rays end. Where a ball touches the
 * board eps leaves out a little, as 18 says: one ray in 20000 or so sees that in glass. */
static void test_two_balls(void)
{
    first_scene s = first_two_balls();
    first_camera c = first_two_balls_camera(640, 400);
    for (int depth = 1; depth <= 8; depth += 7) {
        first_world *x = first_world_new(&s, depth);
        double worst = 0;
        size_t n = check_count(20000), asked = 0, seen[6] = {0}, leaks = 0;
        for (size_t i = 0; i < n; i++) {
            random_stream g = random_start(2, i, 0);
            real px = 640 * random_next(&g), py = 400 * random_next(&g);
            ray r = first_ray_unit(first_camera_ray(c, px, py));
            vec3 L = first_world_ray(x, r);
            hit h;
            if (near_edge(x, r, L)) continue;
            double off = apart(L, first_whitted(&s, r, depth)) / (1 + (double)vlength(L));
            asked++;
            if (off > 5e4 * ulp && off < 1e-3) leaks++;
            else worst = check_worse(worst, off);
            seen[first_scene_hit(&s, r, &h) ? h.shape : 5]++;
        }
        check_at_least(asked, n * 9 / 10, "away from edges, of %zu", n);
        for (int k = 0; k < 6; k++)  /* of 3 a sliver shows, one ray in 900 */
            if (k != 3) check_at_least(seen[k], asked / 200, "see thing %d", k);
        check_at_most(leaks, asked / 5000 + 1, "are off by less than 1e-3, of %zu", asked);
        check_at_most(worst, 5e4 * ulp, "first_whitted against whitted_ray, depth %d", depth);
        first_world_free(x);
    }
}

/* Two mirrors that glow face each other: each level of the tree adds what one sends out. */
static void test_depth(void)
{
    first_scene s = {.eps = (real)1e-4};
    first_material m = {.mirror = vec(1, 1, 1), .ke = vec(1, 1, 1)};
    first_add_flat(&s, vec(-9, -9, -1), vec(18, 0, 0), vec(0, 18, 0), m);
    first_add_flat(&s, vec(-9, -9, 1), vec(18, 0, 0), vec(0, 18, 0), m);
    size_t wrong = 0;
    for (int depth = 0; depth <= 200; depth++)
        wrong += first_whitted(&s, ray_from(vec(0, 0, 0), vec(0, 0, 1)), depth).x != (real)depth;
    check_equal(wrong, 0, "as many levels as were asked for, 0 to 200");
    first_add_ball(&s, vec(0, 0, 0), 0.5, (first_material){.ior = 1.5});
    check(vfinite(first_whitted(&s, ray_from(vec(0.1, 0, 0), vec(0, 0, 1)), 9)), "a ball between");
    vec3 none[] = {{0, 0, 0}, {(real)NAN, 0, 1}, {real_infinity, 0, 0}};
    for (int k = 0; k < 3; k++)
        check(!(first_whitted(&s, ray_from(vec(0, 0, 0), none[k]), 9).x > 9), "ends, %d", k);
}

/* |R' / R - 1| of first_fresnel where n2 = 1 + delta, over angles up to 89.9 degrees. */
static double fresnel_off(real delta)
{
    double worst = 0;
    for (int i = 0; i < 900; i++) {
        real a = (real)i * pi / 1800, n2 = 1 + delta;
        vec3 N = {0, 0, 1}, d = {sin(a), 0, -cos(a)}, w;
        snell x;
        snell_of(d, N, 1, n2, &x);
        bool through = first_refract(d, N, 1, n2, &w);
        real R = through ? first_fresnel(-vdot(d, N), -vdot(w, N), 1, n2) : 1;
        worst = check_worse(worst, fabs((double)R / (double)fresnel(&x) - 1));
    }
    return worst;
}

/* "Wrong where n2 is nearly n1: R is off by eps / (n2 - n1) of itself": of a share so small that
 * nobody sees it, but for grazing rays: there 0.02 of all light is put on the wrong side. */
static void test_nearly_equal(void)
{
    double grazing = 0;
    for (real delta = (real)0.1; delta > 4 * real_epsilon; delta /= 10) {
        double off = fresnel_off(delta), due = ulp / (double)delta;
        check(off < 4 * due && off > due / 8, "delta %g: off by %g", (double)delta, off);
    }
    for (int i = 1; i <= 1000; i++) {
        real c = sqrt(real_epsilon) * (real)i / 500, n2 = 1 + real_epsilon;
        vec3 N = {0, 0, 1}, d = {sqrt((1 - c) * (1 + c)), 0, -c}, w;
        snell x;
        snell_of(d, N, 1, n2, &x);
        bool through = first_refract(d, N, 1, n2, &w);
        real R = through ? first_fresnel(c, -vdot(w, N), 1, n2) : 1;
        grazing = check_worse(grazing, fabs((double)(R - fresnel(&x))));
    }
    check_at_least(grazing, 0.02, "n2 = 1 + ulp, cosines of sqrt(ulp)");
}

/* A slab of glass on a slab of water, whose faces at z = -1 are one; `gap` of air between them. The
 * sky below is 1, that above is 0: what a ray brings back is what went through. Means of both, and
 * the largest difference. */
static double slabs(real gap, double *first, double *full)
{
    first_scene s = {.below = {1, 1, 1}, .eps = (real)1e-4};
    const real z[4] = {0, -1, -1 - gap, -2 - gap};
    double most = 0;
    for (int k = 0; k < 4; k++)  /* upper faces look up, lower ones down */
        first_add_flat(&s, (vec3){-20, k % 2 ? 20 : -20, z[k]}, (vec3){40, 0, 0},
                       (vec3){0, k % 2 ? -40 : 40, 0},
                       (first_material){.ior = k < 2 ? (real)1.5 : (real)1.33});
    first_world *x = first_world_new(&s, 8);
    for (int k = 0; k < 4; k++) x->on.look[k].body = k < 2 ? 1 : 3;
    *first = *full = 0;
    for (uint64_t i = 0; i < 1000; i++) {
        real dx = random_real(3, i, 0, 0), dy = random_real(3, i, 1, 0);
        ray r = ray_from((vec3){0, 0, 3}, vunit((vec3){dx, dy, -1}));
        vec3 a = first_whitted(&s, r, 8), b = first_world_ray(x, r);
        most = check_worse(most, apart(a, b));
        *first += (double)a.x / 1000, *full += (double)b.x / 1000;
    }
    first_world_free(x);
    return most;
}

/* "and where glass touches glass": the ray passes the second of two faces at one place unseen, and
 * goes through water as if that were air. */
static void test_touching(void)
{
    double first, full;
    check_at_most(slabs((real)0.1, &first, &full), 64 * ulp, "air between: what whitted.h says");
    slabs(0, &first, &full);
    check_at_least(first / full, 1.15, "glass on water: %g comes through, %g should", first, full);
}

int main(void)
{
    return check_all("19_first", test_laws, test_two_balls, test_depth, test_nearly_equal,
                     test_touching);
}
