/* Tests of chapters/27_effects: bodies that overlap, and light within them.
 *
 * Oracles: Beer's law and Snell's by hand, 19's tree of rays, quadratures.
 */
static char directory[] = "/tmp/27_glass_XXXXXX";
#include "27_seen.h"

/* ---- priorities ---- */

/* Two blocks with Ni 1: A from z -2 to 1, B from -1 to 2; the ways in each. */
static void test_overlap(int a, int b, real z, double in_a, double in_b)
{
    char text[700];
    snprintf(text, sizeof text, "camera from 0 0 9 at 0 0 0\nbackground 1\n"
             "material a\nKd 0\nillum 6\nabsorb 0.25\npriority %d\nbox -1 -1 -2  1 1 1\n"
             "material b\nKd 0\nillum 6\nabsorb 1\npriority %d\nbox -1 -1 -1  1 1 2\n", a, b);
    test_way(text, z, 0.25 * in_a + in_b);
}

/* Wide slabs at the same places, aslant: each by Snell's law. */
static void test_slabs(bool glass_first, double sine)
{
    char text[700];
    set q;
    const double n[2] = {1.5, 1.33}, absorb[2] = {0.25, 1};
    const double thick[2] = {glass_first ? 3 : 1, glass_first ? 1 : 3};
    double exponent = 0;
    for (int k = 0; k < 2; k++)
        exponent += absorb[k] * thick[k] / sqrt(1 - sine * sine / (n[k] * n[k]));
    snprintf(text, sizeof text, "camera from 0 0 9 at 0 0 0\nbackground 1\n"
             "material a\nKd 0\nNi 1.5\nillum 6\nabsorb 0.25\npriority %d\n"
             "box -40 -40 -2  40 40 1\n"
             "material b\nKd 0\nNi 1.33\nillum 6\nabsorb 1\npriority %d\n"
             "box -40 -40 -1  40 40 2\n",
             glass_first, !glass_first);
    set_up(&q, text);
    vec3 d = vec(sine, 0, -sqrt(1 - sine * sine));
    double L = (double)seen_along(&q, ray_from((vec3){0, 0, 3}, d)).x;
    check_close(L, exp(-exponent), 256 * (double)real_epsilon, "slabs, sine %g", sine);
    tear_down(&q);
}

static void test_priorities(void)
{
    test_overlap(0, 0, 9, 3, 1);  /* of equals the one entered last: A, */
    test_overlap(1, 0, 9, 3, 1), test_overlap(7, 7, 9, 3, 1);
    test_overlap(0, 1, 9, 1, 3), test_overlap(999, 1000, 9, 1, 3);
    test_overlap(1, 0, 1.5, 3, 0.5);                                /* begun in B, */
    test_overlap(1, 0, 0, 2, 0), test_overlap(0, 1, 0, 1, 1);       /* in both, */
    test_overlap(0, 1, -1.5, 0.5, 0);                               /* in A */
    for (int k = 0; k < 2; k++)
        test_slabs(k, 0), test_slabs(k, 0.5), test_slabs(k, 0.999), test_slabs(k, 1e-6);
    test_same("what a body of higher priority hides",
              ABOVE "material g\nKd 0\nNi 1.5\nillum 7\npriority 1\nsphere 0 1 0 0.9\n",
              ABOVE "material g\nKd 0\nNi 1.5\nillum 7\npriority 1\nsphere 0 1 0 0.9\n"
              WATER "sphere 0.2 1 0.1 0.5\n" GLASS "box -0.3 0.7 0  0.2 1.2 0.3\n");
    test_same("a wall of glass, the liquid let into it, or up to it",
              ABOVE GLASS "priority 1\nbox 0 0.2 0  0.4 1.2 1\n" WATER "box 0.3 0.2 0  1 1.2 1\n",
              ABOVE GLASS "priority 1\nbox 0 0.2 0  0.4 1.2 1\n" WATER "box 0.4 0.2 0  1 1.2 1\n");
}

/* Balls and blocks anywhere, each of a glass of its own; the same numbers, but `equal`: without
 * priorities. */
static void random_glass(uint64_t number, bool equal, char text[4000])
{
    random_stream r = random_start(29, number, 0);
    size_t n = (size_t)snprintf(text, 4000, "%s", ABOVE);
    for (int k = 0; k < 5; k++) {
        double x = some(&r, -0.7, 0.4), y = some(&r, 0.1, 0.9), z = some(&r, -0.7, 0.4), p;
        n += (size_t)snprintf(text + n, 4000 - n, "material m%d\nKd 0\nillum 7\nNi %.3f\n"
                              "absorb %.2f %.2f 0\n", k, some(&r, 1.05, 2), some(&r, 0, 1),
                              some(&r, 0, 1));
        p = some(&r, 0, 3);
        n += (size_t)snprintf(text + n, 4000 - n, "priority %d\n", equal ? 0 : (int)p);
        if (k % 2) n += (size_t)snprintf(text + n, 4000 - n, "sphere %.3f %.3f %.3f %.3f\n", x, y,
                                         z, some(&r, 0.2, 0.8));
        else n += (size_t)snprintf(text + n, 4000 - n, "box %.3f %.3f %.3f  %.3f %.3f %.3f\n", x, y,
                                   z, x + some(&r, 0.2, 1), y + some(&r, 0.2, 1),
                                   z + some(&r, 0.2, 1));
    }
}

/* Ray by ray 19's, wherever the eye is: n^2 of its place apart. */
static void test_whitted(void)
{
    size_t n = check_count(60), rays = 0, off = 0, inside = 0, moved = 0;
    for (size_t i = 0; i < n; i++) {
        char text[4000], plain[4000];
        set q, without;
        classic c;
        random_glass(i, false, text), random_glass(i, true, plain);
        set_up(&q, text), set_up(&without, plain);
        classic_build(&q.e, &c);
        c.how.apart = false;
        for (uint64_t k = 0; k < 100; k++, rays++) {
            random_stream s = random_start(30, i, k);
            ray r = camera_ray(q.e.eye, 60 * random_next(&s), 45 * random_next(&s), 60, 45);
            if (k % 4 == 0)  /* from among them, to the wall */
                r = ray_from(vec(some(&s, -1, 1), some(&s, 0, 1.5), some(&s, -1, 1)),
                             vunit(vec(some(&s, -1, 1), some(&s, -1, 1), -1)));
            media_set in = bodies_around(&q.e, r.o);
            tracer t = {.w = &c.world, .program = whitted_programs, .user = &c.how};
            vec3 a = seen_along(&q, r), b = whitted_ray(&t, r, in);
            b = vscale(b, 1 / whitted_square(&c.how, &in));
            inside += in.n > 1;
            off += !(vlength(vsub(a, b)) <= 65536 * real_epsilon);
            moved += vlength(vsub(a, seen_along(&without, r))) > (real)0.01;
        }
        classic_free(&c);
        tear_down(&q), tear_down(&without);
    }
    check_at_most((double)off, (sizeof(real) == 4 ? 0.02 : 1e-3) * (double)rays,
                  "of %zu rays, those that are not 19's", rays);
    check_at_least((double)inside, 0.01 * (double)rays, "begun in two bodies");
    check_at_least((double)moved, 0.05 * (double)rays, "without priorities: another picture");
}

/* ---- light within a body ---- */

/* A stone floor and a light in a ball of water, so wide that nothing comes back from its end. */
#define DEEP "material water\nKd 0\nNi 1.33\nabsorb 0.5 1 0.7\npriority 2\nillum 7\n"            \
    "sphere 0 0 0 80\nmaterial stone\nKd 0.5\nillum 1\npolygon -9 0 9  9 0 9  9 0 -9  -9 0 -9\n"
#define LOOKS "camera from 0 1.5 2 at 0 0 0\n"
#define SQUARE "material lamp\nKe 20\npolygon -1 2 1  1 2 1  1 2 -1  -1 2 -1\n"

/* E = sum of Ke cos^2 e^(-sigma s) / s^2 over a square of half side 1, 2 above, by the midpoint
 * rule; L = Kd E / pi, and the way to the eye. */
static double under_square(double sigma, double Ke, double eye)
{
    enum { n = 200 };
    double E = 0;
    for (int i = 0; i < n * n; i++) {
        double x = (i % n + 0.5) * 2 / n - 1, y = (i / n + 0.5) * 2 / n - 1;
        double s2 = x * x + y * y + 4, s = sqrt(s2);
        E += Ke * 4 / s2 / s2 * exp(-sigma * s) * 4 / (n * n);
    }
    return 0.5 * E / (double)pi * exp(-sigma * eye);
}

/* 2 E3(x): what is left of an even sky under fog of that depth. */
static double under_fog(double x)
{
    enum { n = 100000 };
    double sum = 0;
    for (int i = 0; i < n; i++) {
        double mu = (i + 0.5) / n;
        sum += 2 * mu * exp(-x / mu) / n;
    }
    return sum;
}

#define FOG "camera from 0 3 0 at 0 0 0 up 0 0 1\nenvironment 1\nmaterial floor\nKd 0.5\n"        \
    "illum 1\npolygon -60 0 60  60 0 60  60 0 -60  -60 0 -60\nmaterial fog\nKd 0\nTf 0.5\n"       \
    "illum 6\nabsorb 0.4 0.8 0\nbox -50 0 -50  50 0.5 50\n"

static void test_within(void)
{
    const unsigned lamps = EFFECT_SOFT_SHADOWS | EFFECT_REFRACTION | EFFECT_ABSORPTION;
    const unsigned sky = EFFECT_ENVIRONMENT | EFFECT_REFRACTION | EFFECT_ABSORPTION;
    const double sigma[3] = {0.5, 1, 0.7};
    double point[3], square[3], fog[3];
    for (int k = 0; k < 3; k++) {
        double s = sqrt(1 + 4);
        point[k] = 0.5 / (double)pi * 9 * 2 / (s * s * s) * exp(-sigma[k] * (s + 2.5));
        square[k] = under_square(sigma[k], 20, 2.5);
        double x = (k == 2 ? 0 : k ? 0.8 : 0.4) * 0.5;
        fog[k] = 0.5 * 0.25 * exp(-x) * under_fog(x);  /* Tf in, and Tf out */
    }
    expect("a point light in water", LOOKS DEEP "indirect off\nlight at 1 2 0 colour 9\n", point,
           300, 0);
    expect("a lamp in water, by shadow rays", LOOKS DEEP SQUARE, square, 1e7, lamps);
    expect("and by paths", LOOKS DEEP SQUARE, square, 1e7, lamps | EFFECT_INDIRECT);
    #define HIDDEN "material glass\nKd 0\nNi 1.5\nabsorb 3\npriority 1\nillum 7\n"
    expect("past a body that the water hides", LOOKS DEEP SQUARE HIDDEN "sphere 0 1 0 0.4\n",
           square, 1e7, lamps | EFFECT_INDIRECT);
    expect("fog on the floor", FOG, fog, 3e6, sky);
    expect("by paths, too", FOG, fog, 3e6, sky | EFFECT_INDIRECT);
    expect("a part of it said twice", FOG "box -1 0.1 -1  1 0.4 1\n", fog, 3e6,
           sky | EFFECT_INDIRECT);
}

int main(void)
{
    alarm(120);
    test_priorities();
    test_whitted();
    test_within();
    return check_report("27_glass");
}
