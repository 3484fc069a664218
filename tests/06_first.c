/* 06's first.h: the answers of csg.h where the eye is outside of both balls, others inside. */
#include "../chapters/06_csg/lab/csg_variants.h"
#include "../chapters/06_csg/first.h"
#include "../common/random.h"
#include "check.h"

static const double eps = (double)real_epsilon;

static size_t unlike;  /* answers of csg_hit_front that are not first.h's */

typedef struct { sphere ball[2]; csg c; csg_solid solid[2]; ray r; } shot;

/* Two balls that mostly overlap, and a ray from the eye, or from outside, to a point near them.
 * False: a crossing is so near to another, or to the eye, that rounding may decide. */
static bool shot_at(size_t i, vec3 eye, bool outside, shot *x)
{
    static const csg_step step[3] = {{CSG_SOLID, 0}, {CSG_SOLID, 1}, {CSG_DIFFERENCE, 0}};
    random_stream s = random_start(1, i, 0);
    x->ball[0] = (sphere){random_in_cube(&s, (real)0.2), 1};
    x->ball[1] = (sphere){random_in_cube(&s, (real)0.7), (real)0.6 + random_next(&s) / 4};
    vec3 to = random_in_cube(&s, 1);
    if (outside) eye = vunit(random_in_cube(&s, 1)), eye = vscale(eye, 4 + random_next(&s));
    x->r = ray_from(eye, vscale(vsub(to, eye), (real)0.5 + random_next(&s)));
    for (int k = 0; k < 2; k++) x->solid[k] = csg_sphere(x->ball[k].c, x->ball[k].r);
    if (!csg_build((csg_model){x->solid, 2, step, 3}, (csg_options){0}, &x->c, NULL)) abort();
    csg_crossing at[4];
    size_t n = csg_solid_crossings(&x->solid[0], x->r, 0, at);
    n += csg_solid_crossings(&x->solid[1], x->r, 1, at + n);
    bool clear = true;
    for (size_t a = 0; a < n; a++) {
        clear = clear && fabs((double)at[a].t) > 1e4 * eps;
        for (size_t b = 0; b < a; b++)
            clear = clear && fabs((double)(at[a].t - at[b].t)) > 0.01;
    }
    return clear;
}

/* Of n rays from `eye` (or from outside) those to which first.h and csg.h give other answers. */
static size_t others(size_t n, vec3 eye, bool outside, size_t *hits, double *off)
{
    size_t wrong = 0;
    for (size_t i = 0; i < n; i++) {
        shot x;
        hit a = {7, 7, 7, 7}, b = {7, 7, 7, 7};
        if (shot_at(i, eye, outside, &x)) {
            bool is = first_difference_hit(x.ball, x.r, &a), due = csg_hit(&x.c, x.r, &b);
            bool same = is == due && (!due || a.shape == b.shape / 2);
            if (same && due) {
                vec3 p = ray_at(x.r, b.t), n0 = first_difference_normal(x.ball, p, a);
                *off = check_worse(*off, fabs((double)(a.t - b.t)));
                *off = check_worse(*off, (double)vlength(vsub(n0, csg_normal(&x.c, x.r, b))));
            }
            hit f = {7, 7, 7, 7};  /* the tables' way for any tree does what first.h does */
            unlike += csg_hit_front(&x.c, x.r, &f) != is || (is && f.shape / 2 != a.shape);
            wrong += !same, *hits += due;
        }
        csg_free(&x.c);
    }
    return wrong;
}

static void test_outside(void)
{
    size_t hits = 0, n = check_count(60000);
    double off = 0;
    size_t wrong = others(n, vec(0, 0, 0), true, &hits, &off);
    check_equal(wrong, 0, "seen from outside: as csg.h, of %zu", n);
    check_at_least((double)hits, 0.3 * (double)n, "the test sees hits");
    /* chords above 0.01 of t: the roots are off by some 1e3 epsilon, the normal by twice that */
    check_at_most(off, 2e3 * eps, "t, and the normal");
}

/* "Wrong where the eye is in A or in B" */
static void test_inside(void)
{
    size_t hits = 0, n = check_count(20000);
    double off = 0;
    size_t wrong = others(n, vec(0.1, 0, 0), false, &hits, &off);  /* in A, and mostly in B */
    check_at_least((double)wrong, 0.3 * (double)n, "seen from inside most answers are wrong");
    check_at_least((double)hits, 0.3 * (double)n, "there is something to see");
}

/* The named case, by hand: A has radius 2, B radius 1, the eye is in the middle of both. */
static void test_named_case(void)
{
    const sphere ball[2] = {{{0, 0, 0}, 2}, {{0, 0, 0}, 1}};
    hit h = {7, 7, 7, 7};
    ray hollow = ray_from(vec(0, 0, 0), vec(0, 0, 1));
    check(!first_difference_hit(ball, hollow, &h), "from the hollow nothing is seen, no wall");
    ray wall = ray_from(vec(0, 0, 1.5), vec(0, 0, -1));  /* in A, not in B */
    h.t = 7;
    check(first_difference_hit(ball, wall, &h) && h.t == (real)3.5,
          "from within the wall the ball ahead is missed, too");
    ray outside = ray_from(vec(0, 0, 3), vec(0, 0, -1));
    check(first_difference_hit(ball, outside, &h) && h.t == 1 && h.shape == 0, "from outside");
    outside.tmin = (real)1.5;
    check(first_difference_hit(ball, outside, &h) && h.t == 2 && h.shape == 1,
          "tmin cuts after the walk: the inner wall");
    check(first_difference_normal(ball, vec(0, 0, 1), h).z == -1, "its normal leads into B");
}

static void test_interval(void)
{
    const sphere ball[2] = {{{0, 0, 0}, 2}, {{0, 0, 0}, 1}};
    const struct { real tmin, tmax; } out[] = {
        {0, (real)0.9}, {(real)1.1, (real)1.9}, {6, 9}, {3, 1}, {(real)NAN, 9}};
    for (size_t i = 0; i < sizeof out / sizeof *out; i++) {
        hit h = {7, 7, 7, 7};
        ray r = {{0, 0, 3}, out[i].tmin, {0, 0, -1}, out[i].tmax};
        check(!first_difference_hit(ball, r, &h) && h.t == 7, "outside %zu", i);
    }
    const real strange[] = {0, (real)NAN, real_infinity, -real_infinity};
    size_t answers = 0;
    for (int k = 0; k < 6; k++)
        for (int i = 0; i < 4; i++) {
            real v[6] = {0, 0, 3, 0, 0, -1};
            hit h = {7, 7, 7, 7};
            v[k] = strange[i];
            bool is = first_difference_hit(ball, ray_from(vec(v[0], v[1], v[2]),
                                                          vec(v[3], v[4], v[5])), &h);
            answers += is != (h.t == 7);
        }
    check_equal(answers, 24, "a miss leaves *out alone, a hit does not");
}

int main(void)
{
    test_outside();
    test_inside();
    test_named_case();
    test_interval();
    check_equal(unlike, 0, "csg_hit_front is first.h's way");
    return check_report("06_first");
}
