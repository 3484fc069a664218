/* 09_aabb: boxes; the slab test against whole numbers, at every scale, with infinities and NaN. */
#include "../chapters/09_aabb/lab/exact.h"
#include "../chapters/09_aabb/lab/slabs.h"
#include "check.h"

static const real inf = real_infinity, nan_real = (real)NAN;
static const aabb cube = {{0, 0, 0}, {1, 1, 1}};

static bool hits(aabb_test *test, aabb b, ray r)
{
    real t = -7;
    return test(b, r, &t);
}

static ray through(real ox, real oy, real oz, real dx, real dy, real dz)
{
    return ray_from((vec3){ox, oy, oz}, (vec3){dx, dy, dz});
}

static bool same_box(aabb a, aabb b)
{
    return memcmp(&a, &b, sizeof a) == 0;  /* six reals, no gaps; and -0.0 differs from 0.0 */
}

static void test_boxes(void)
{
    const aabb none = aabb_empty(), b = {{-1, 2, 0}, {3, 5, 7}}, c = {{2, 4, -1}, {9, 9, 1}};
    const aabb apart = {{4, 4, -1}, {9, 9, 1}}, touching = {{3, 4, -1}, {9, 9, 1}};
    const vec3 p = {7, 1, 3}, far = {real_largest, 0, 0};
    const struct { aabb is, due; const char *why; } box[] = {
        {aabb_union(none, b), b, "nothing added changes nothing"}, {aabb_union(b, none), b, "nor"},
        {aabb_union(b, c), {{-1, 2, -1}, {9, 9, 7}}, "union"},
        {aabb_overlap(b, c), {{2, 4, 0}, {3, 5, 1}}, "overlap"},
        {aabb_overlap(b, apart), none, "boxes apart on one axis share nothing"},
        {aabb_overlap(b, touching), {{3, 4, 0}, {3, 5, 1}}, "contact is a flat overlap"},
        {aabb_grow_point(b, p), {{-1, 1, 0}, {7, 5, 7}}, "grows as far as p"},
        {aabb_grow_point(none, p), {p, p}, "the box of one point"},
        {aabb_grow_point(b, vec(7, NAN, 3)), {{-1, 2, 0}, {7, 5, 7}},
         "a NaN coordinate does not grow the box"}};
    for (size_t i = 0; i < sizeof box / sizeof *box; i++)
        check(same_box(box[i].is, box[i].due), "%s", box[i].why);
    const struct { aabb b; real area; } surface[] = {
        {none, 0}, {b, 2 * (4 * 3 + 3 * 7 + 7 * 4)}, {{{0, 0, 0}, {2, 3, 0}}, 12},
        {{{0, 0, 0}, {0, 0, 4}}, 0}};
    for (int i = 0; i < 4; i++) check_equal(aabb_area(surface[i].b), surface[i].area, "area %d", i);
    check(aabb_is_empty(none) && !aabb_is_empty(b), "an empty box knows that it is empty");
    check(aabb_contains(b, b.lo) && aabb_contains(b, b.hi) && !aabb_contains(none, b.lo),
          "corners belong to the box");
    check(!aabb_contains(b, vec(0, 3, 8)) && !aabb_contains(b, vec(0, NAN, 1)),
          "outside, and nowhere");
    check(vzero(vsub(aabb_centre(b), vec(1, 3.5, 3.5))), "centre");
    check(vfinite(aabb_centre((aabb){far, far})), "the centre of a far box does not overflow");
}

/* The whole numbers against the numbers of 32 digits, which know no fractions. */
static void test_oracle(void)
{
    size_t wrong = 0, hit_count = 0, n = check_count(60000), judged = 0;
    for (size_t i = 0; i < n; i++) {
        aabb_trial c = aabb_trial_of((aabb_trial_kind)(i % aabb_trial_kinds), 5, i);
        aabb_exact e = exact_aabb(c.b, c.r);
        if (isinf(c.r.tmin)) continue;
        aabb_wide w = wide_aabb(c.b, c.r);
        wide off = wide_sub(wide_mul(w.enter, wide_of((double)e.enter.d)),
                            wide_of((double)e.enter.n));
        judged++, hit_count += e.hit;
        wrong += e.hit != w.hit || fabs(wide_value(off)) > 1e-25;
    }
    check_equal(wrong, 0, "two oracles, of %zu trials", judged);
    check(hit_count > judged / 2 && hit_count < judged - n / 20, "hits and misses: %zu", hit_count);
    aabb_fraction third = {1, 3};
    check(not_after((real)1 / 3, third) == (sizeof(real) == sizeof(double)),
          "the double next to 1/3 is below it, the float above");
    check(not_after(-inf, third) && !not_after(inf, third) && not_after(5, (aabb_fraction){1, 0}),
          "infinities have their place");
}

/* How a test answers n trials of each kind. skipped: hit, but not any more once something was found
 * just at its t. */
typedef struct { size_t hit, missed, late, skipped, wrong_alarm; } score;

static score score_of(aabb_test *test, aabb_trial_kind kind, size_t n)
{
    score s = {0};
    for (size_t i = 0; i < n; i++) {
        aabb_trial c = aabb_trial_of(kind, 1, i);
        aabb_exact e = exact_aabb(c.b, c.r);
        real t = -7;
        bool h = test(c.b, c.r, &t);
        s.hit += e.hit;
        s.missed += e.hit && !h;
        s.late += e.hit && h && !not_after(t, e.enter);
        s.wrong_alarm += h && !e.hit;
        c.r.tmax = t;
        s.skipped += h && !hits(test, c.b, c.r);
    }
    return s;
}

/* Ten million hard rays: none lost, none late. Two fractions of this size that differ do so by 1e-6
 * at least, relatively; the padding is 1e-6 in float and 2e-15 in double, so in double there is no
 * false alarm, and in float next to none. */
static void test_ten_million(void)
{
    size_t n = check_count(10000000 / aabb_trial_kinds + 1), alarms = 0;
    for (int kind = 0; kind < aabb_trial_kinds; kind++) {
        score s = score_of(aabb_hit, (aabb_trial_kind)kind, n);
        check_equal(s.missed, 0, "kind %d: false negatives of %zu", kind, s.hit);
        check_equal(s.late, 0, "kind %d: t_enter behind the exact one", kind);
        check_equal(s.skipped, 0, "kind %d: skipped by a search that found something there", kind);
        alarms += s.wrong_alarm;
    }
    check_at_most(alarms, real_is_float ? n / 1000 : 0, "false alarms among %zu rays", 6 * n);
}

/* Each of the other variants fails where slabs.h says so; test_hard in 09_first.c: first's flat
 * boxes and faces. */
static void test_variants_fail(void)
{
    size_t n = check_count(200000);
    double per = 1 / (double)n;
    check_at_least((double)score_of(first_aabb_hit, TRIAL_EDGE, n).missed * per, 0.95,
                   "first: a touch of an edge has t_enter = t_exit");
    check_at_least((double)score_of(aabb_hit_closed, TRIAL_PARALLEL, n).missed * per, 0.5,
                   "closed: 0/0, and -0.0, in a plane of the box");
    check_at_least((double)score_of(aabb_hit_kept, TRIAL_CORNER, n).missed * per, 0.05,
                   "n (1/d) at a corner: equal t that round apart");
    check_at_least((double)score_of(aabb_hit_ize, TRIAL_EDGE, n).late * per, 0.1,
                   "Ize: t_enter rounded to nearest is late for many");
    for (int kind = 0; kind < TRIAL_ANY; kind++)
        check_equal(score_of(aabb_hit_ize, (aabb_trial_kind)kind, n).missed, 0,
                    "an exit widened by 2 ulp loses none of kind %d, at t >= 0", kind);
    check_at_least((double)score_of(first_aabb_hit, TRIAL_ANY, n).wrong_alarm * per, 0.1,
                   "first: knows no interval");
}

/* Each axis scaled by its own power of two, t by another, 2^e: no answer changes, if coordinates
 * and t stay below half the largest real. Directions may be subnormal, so that 1/d overflows, or so
 * large that 1/d is subnormal and loses two bits; coordinates and t may underflow. */
static aabb_trial scaled_trial(size_t i, int *t_exponent)
{
    const int low = real_is_float ? -149 : -1074, high = real_is_float ? 117 : 1013;
    random_stream s = random_start(3, i, 0);
    aabb_trial_kind kind = (aabb_trial_kind)(i % aabb_trial_kinds);
    aabb_trial c = aabb_trial_of(kind, 3, i);
    bool has_interval = kind == TRIAL_CONTACT || kind == TRIAL_ANY;
    int least = has_interval ? low + 6 : 3 * low / 2, most = high - 3;
    int e = random_integer(&s, least, most);
    for (int k = 0; k < 3; k++) {
        int least_a = e > 0 ? low + e : low, most_a = e < -2 ? high + 2 + e : high;
        int a = random_integer(&s, least_a, most_a);
        if (chance(&s, 3)) a = chance(&s, 2) ? least_a : most_a;
        c.b.lo = vwith(c.b.lo, k, ldexp(vaxis(c.b.lo, k), a));
        c.b.hi = vwith(c.b.hi, k, ldexp(vaxis(c.b.hi, k), a));
        c.r.o = vwith(c.r.o, k, ldexp(vaxis(c.r.o, k), a));
        c.r.d = vwith(c.r.d, k, ldexp(vaxis(c.r.d, k), a - e));
    }
    c.r.tmin = ldexp(c.r.tmin, e), c.r.tmax = ldexp(c.r.tmax, e);
    *t_exponent = e;
    return c;
}

static void test_scales(void)
{
    size_t missed = 0, late = 0, overflowed = 0, subnormal = 0, closed_missed = 0,
           ize_missed = 0;
    for (size_t i = 0; i < check_count(1000000); i++) {
        int e;
        aabb_trial c = scaled_trial(i, &e);
        aabb_trial plain = aabb_trial_of((aabb_trial_kind)(i % aabb_trial_kinds), 3, i);
        aabb_exact exact = exact_aabb(plain.b, plain.r);
        real t = -7;
        if (!exact.hit) continue;
        bool h = aabb_hit(c.b, c.r, &t);
        missed += !h;
        late += h && !not_after(ldexp(t, -e), exact.enter);
        closed_missed += !hits(aabb_hit_closed, c.b, c.r);
        ize_missed += !hits(aabb_hit_ize, c.b, c.r);
        overflowed += isnan(aabb_inverse_of(c.r).inverse.x) != 0;
        real inverse = aabb_inverse_of(c.r).inverse.x;
        subnormal += isfinite(inverse) && inverse != 0 && !isnormal(inverse);
    }
    check_equal(missed, 0, "false negatives from the smallest to half the largest number");
    check_equal(late, 0, "t_enter behind the exact one");
    check_at_least(overflowed, check_count(1000), "directions whose 1/d overflows are among them");
    check_at_least(subnormal, check_count(1000), "and those whose 1/d is subnormal");
    check_at_least(closed_missed, check_count(100000), "and <= alone loses many");
    check_at_least(ize_missed, check_count(10000), "2 ulp are not enough where 1/d is off by more");
}

static void test_infinities(void)
{
    aabb all = {{-inf, -inf, -inf}, {inf, inf, inf}}, half = {{-inf, -inf, 0}, {inf, inf, inf}};
    size_t wrong_all = 0, wrong_half = 0, wrong_empty = 0;
    for (size_t i = 0; i < check_count(300000); i++) {
        aabb_trial c = aabb_trial_of((aabb_trial_kind)(i % aabb_trial_kinds), 4, i);
        c.r.tmin = i % 3 ? 0 : -inf, c.r.tmax = i % 2 ? inf : 1000000;
        wrong_all += !hits(aabb_hit, all, c.r);
        wrong_empty += hits(aabb_hit, aabb_empty(), c.r);
        c.r.tmin = 0;
        if (c.r.d.z == 0) c.r.tmax = 1000000;  /* or it is met at t = infinity, as aabb.h says */
        bool expected = c.r.o.z >= 0 || c.r.d.z > 0;
        wrong_half += hits(aabb_hit, half, c.r) != expected;
    }
    check_equal(wrong_all, 0, "the whole space is always hit");
    check_equal(wrong_half, 0, "a half space: by a start inside or a way towards it");
    check_equal(wrong_empty, 0, "an empty box is never hit");
}

static void test_interval(void)
{
    const real half = (real)0.5, just = 32 * real_epsilon, tiny = 2 * real_smallest;
    const vec3 o = {half, half, -4}, d = {0, 0, 2};  /* in the cube for t in [2, 2.5] */
    const vec3 beyond = {half, half, 4}, in = {half, half, half}, still = {0, 0, 0};
    const struct { ray r; bool due; real lo, hi; const char *why; } at[] = {  /* t_enter: lo, hi */
        {{o, 0, d, 2}, true, 2 - just * 2, 2, "tmax = entry: contact"},
        {{o, 0, d, 2 - 2 * just}, false, 0, 0, "tmax before the entry, by more than the padding"},
        {{o, 2.5, d, inf}, true, 2, 2.5, "tmin = exit: contact"},
        {{o, (real)2.5 * (1 + just), d, inf}, false, 0, 0, "tmin behind the exit"},
        {{beyond, 0, d, inf}, false, 0, 0, "behind"},
        {{beyond, -inf, d, inf}, true, -2 - 2 * just, -2, "behind, and wanted"},
        {{beyond, -inf, d, -2}, true, -3, -2, "behind: contact at tmax"},
        {{in, 1, d, 0}, false, 0, 0, "an empty interval"},
        {{in, 0, {1, 1, 1}, inf}, true, -tiny, 0, "inside: tmin"},
        {{in, 0, still, inf}, true, -tiny, 0, "a ray that stands still inside"},
        {{beyond, 0, still, inf}, false, 0, 0, "and outside"}};
    for (size_t i = 0; i < sizeof at / sizeof *at; i++) {
        real t = -7;
        bool is = aabb_hit(cube, at[i].r, &t);
        check(is == at[i].due && (is ? t >= at[i].lo && t <= at[i].hi : t == -7), "%s: %.17g",
              at[i].why, (double)t);
    }
}

/* An axis with a NaN says nothing: the answer is that of the two others. */
static void test_nan(void)
{
    size_t wrong = 0, in_interval = 0;
    for (size_t i = 0; i < check_count(300000); i++) {
        aabb_trial c = aabb_trial_of(i % 2 ? TRIAL_ANY : TRIAL_CORNER, 6, i), open = c, bad = c;
        int k = (int)(i % 3);
        open.b.lo = vwith(open.b.lo, k, -inf), open.b.hi = vwith(open.b.hi, k, inf);
        switch (i % 4) {
        case 0: bad.r.d = vwith(bad.r.d, k, nan_real); break;
        case 1: bad.r.o = vwith(bad.r.o, k, nan_real); break;
        case 2:
            bad.b.lo = vwith(bad.b.lo, k, nan_real), bad.b.hi = vwith(bad.b.hi, k, nan_real);
            break;
        default: bad.r.d = vwith(bad.r.d, k, inf);
        }
        wrong += hits(aabb_hit, bad.b, bad.r) != hits(aabb_hit, open.b, open.r);
        c.r.tmin = i % 2 ? nan_real : 0, c.r.tmax = i % 2 ? inf : nan_real;
        in_interval += hits(aabb_hit, c.b, c.r);
    }
    check_equal(wrong, 0, "a NaN, or an infinite d: this axis says nothing");
    check_equal(in_interval, 0, "a NaN in tmin or tmax: no t is in the interval");
    aabb one_side = {{nan_real, 0, 0}, {1, 1, 1}};
    check(hits(aabb_hit, one_side, through(-9, 0, 0, 1, 0, 0)), "NaN for lo: hi still counts");
    check(!hits(aabb_hit, one_side, through(9, 0, 0, 1, 0, 0)), "NaN for lo: behind hi");
}

/* A box in each of eight lanes, and in four of them: none lost, none late, whatever the lane. */
static void test_lanes(void)
{
    size_t missed = 0, late = 0, differ = 0, empty = 0;
    for (size_t i = 0; i < check_count(500000); i++) {
        aabb_trial_kind kind = (aabb_trial_kind)(i % aabb_trial_kinds);
        aabb8 eight;
        aabb4 four;
        lanes_empty(eight.side[0], 8), lanes_empty(four.side[0], 4);
        ray r = aabb_trial_of(kind, 7, i).r;
        aabb_lanes l = aabb_lanes_of(r);
        float t[8], u[4];
        empty += aabb8_hit(&eight, &l, t) | aabb4_hit(&four, &l, u);
        for (int k = 0; k < 8; k++) {
            aabb b = aabb_trial_of(kind, 7, i + (size_t)k * 6).b;
            if (k != 5) lanes_put(eight.side[0], 8, k, b);
            if (k < 4) lanes_put(four.side[0], 4, k, b);
        }
        unsigned mask = aabb8_hit(&eight, &l, t), mask4 = aabb4_hit(&four, &l, u);
        differ += (mask & 15) != mask4 || mask & 32;
        for (int k = 0; k < 8; k++) {
            aabb_exact e = exact_aabb(aabb_trial_of(kind, 7, i + (size_t)k * 6).b, r);
            if (k == 5 || !e.hit) continue;
            missed += !(mask >> k & 1), late += !not_after((real)t[k], e.enter);
            differ += k < 4 && t[k] != u[k];
        }
    }
    check_equal(missed, 0, "four and eight at once: false negatives");
    check_equal(late, 0, "t_enter behind the exact one");
    check_equal(differ, 0, "four as eight, and no lane stands for another");
    check_equal(empty, 0, "empty lanes are never hit");
}

/* ---- a reader's own test (mine.h): what is right passes, and each usual mistake is found ---- */

static bool without_tmax(aabb b, ray r, real *t_enter)
{
    r.tmax = real_infinity;
    return aabb_hit(b, r, t_enter);
}

static bool without_tmin(aabb b, ray r, real *t_enter)
{
    r.tmin = -real_infinity;
    return aabb_hit(b, r, t_enter);
}

static bool up_only(aabb b, ray r, real *t_enter)
{
    return (r.d.x > 0 || r.d.y > 0 || r.d.z > 0) && aabb_hit(b, r, t_enter);
}

static bool exit_for_entry(aabb b, ray r, real *t_enter)
{
    real t0;
    if (!aabb_hit(b, r, &t0)) return false;
    first_slabs(b, r, &t0, t_enter);
    return true;
}

static void test_mine(void)
{
    const struct { const char *name; aabb_test *hit; bool right; } one[] = {
        {"mine.h", mine_aabb_hit, true}, {"closed", aabb_hit_closed, true},
        {"aabb_hit", aabb_hit, true}, {"t > tmax", without_tmax, false},
        {"t < tmin", without_tmin, false}, {"up only", up_only, false},
        {"the notes' own, which knows no interval", first_aabb_hit, false},
        {"exit for entry", exit_for_entry, false}};
    FILE *nowhere = fopen("/dev/null", "w");
    for (size_t k = 0; nowhere && k < sizeof one / sizeof *one; k++)
        check(aabb_prove(one[k].hit, one[k].name, 2000, nowhere) == one[k].right,
              "%s: right or wrong?", one[k].name);
    check(nowhere && fclose(nowhere) == 0, "/dev/null");
}

int main(void)
{
    return check_all("09_aabb", test_boxes, test_oracle, test_ten_million, test_variants_fail,
                     test_scales, test_infinities, test_interval, test_nan, test_lanes, test_mine);
}
