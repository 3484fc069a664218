/* 19_optics: reflection, Snell, Fresnel, Beer against twice the precision and closed forms; the
 * sets of media. */
#include "19_optics_naive.h"
#include "check.h"
#include "../common/random.h"
#include "../common/numbers/wide.h"
#include "../chapters/19_whitted/media.h"

/* d towards a surface of normal n, at an angle of the given sine and cosine. */
static vec3 incident_at(vec3 n, real sine, real c, random_stream *s)
{
    vec3 a, b;
    vbasis(n, &a, &b);
    real phi = 2 * pi * random_next(s);
    return vunit(vadd(vscale(n, -c), vmadd(vscale(a, sine * cos(phi)), b, sine * sin(phi))));
}

static vec3 incident(vec3 n, real sine, random_stream *s)
{
    return incident_at(n, sine, sqrt(real_max(0, (1 - sine) * (1 + sine))), s);
}

/* ci^2 of the directions of d and n, and ct^2 n2^2, in twice the precision. */
static void wide_snell(vec3 d, vec3 n, real n1, real n2, wide *cc, wide *kk)
{
    wide3 D = wide3_of(d), N = wide3_of(n);
    wide dn = wide3_dot(D, N), a = wide_of((double)n1), b = wide_of((double)n2);
    *cc = wide_div(wide_mul(dn, dn), wide_mul(wide3_dot(D, D), wide3_dot(N, N)));
    wide aa = wide_mul(a, a), bb = wide_mul(b, b);
    *kk = wide_add(wide_sub(bb, aa), wide_mul(aa, *cc));
}

static double wide_fresnel(vec3 d, vec3 n, real n1, real n2)
{
    wide cc, kk, a = wide_of((double)n1), b = wide_of((double)n2);
    wide_snell(d, n, n1, n2, &cc, &kk);
    if (wide_sign(kk) < 0) return 1;
    wide c = wide_sqrt(cc), t = wide_div(wide_sqrt(kk), b);
    wide p = wide_mul(a, c), q = wide_mul(b, t), u = wide_mul(b, c), v = wide_mul(a, t);
    wide rs = wide_div(wide_sub(p, q), wide_add(p, q));
    wide rp = wide_div(wide_sub(u, v), wide_add(u, v));
    return wide_value(wide_add(wide_mul(rs, rs), wide_mul(rp, rp))) / 2;
}

static void test_reflect(void)
{
    vec3 low = lifted(vec(0.8, 0, -0.6), (vec3){0, 0, 1});
    check_close(low.z / real_epsilon, 16 / 0.8, 0.01, "lifted: by 16 eps, then made unit");
    random_stream s = random_start(1, 0, 0);
    double eps = (double)real_epsilon, off = 0, turn = 0, plane = 0;
    for (size_t i = 0; i < check_count(20000); i++) {
        vec3 n = vunit(random_unit(&s)), d = incident(n, random_next(&s), &s), w = reflect(d, n);
        off = check_worse(off, fabs((double)(vlength(w) - 1)));
        turn = check_worse(turn, fabs((double)(vdot(w, n) + vdot(d, n))));
        plane = check_worse(plane, fabs((double)vdot(w, vcross(d, n))));
        check(vlength(vsub(w, reflect(d, vneg(n)))) <= 4 * real_epsilon, "either normal");
    }
    check_at_most(off, 2 * eps, "unit again");
    check_at_most(turn, 8 * eps, "the angles are equal: n, d off by 2.25 eps each");
    check_at_most(plane, 4 * eps, "in one plane");
    vec3 w = reflect(vec(0.6, -0.8, 0), (vec3){0, 1, 0});
    check_close(w.x, 0.6, eps, "(0.6, -0.8) on a floor");
    check_close(w.y, 0.8, eps, "goes up");

    /* To and fro along n, which is not unit to the last bit: |w|^2 grows by the factor
     * 1 + 4 ((n.n)^2 - n.n) each time, if w is not made unit again. */
    vec3 n = {0.6, 0.8, 0}, a = n, b = n;
    size_t bounces = 100000;
    if (vdot(n, n) == 1) n.x *= 1 + 2 * real_epsilon;
    for (size_t i = 0; i < bounces; i++) a = first_reflect(a, n), b = reflect(b, n);
    double y = wide_value(wide_sub(wide3_dot(wide3_of(n), wide3_of(n)), wide_of(1)));
    check_at_least(fabs((double)vlength(a) - 1), (double)bounces * fabs(y) / 4,
                   "the plain formula drifts with the number of reflections");
    check_at_most(fabs((double)vlength(b) - 1), 4 * eps, "after 1e5 reflections");
}

/* The wide oracle decides. ci^2 is right within some eps, which counts (n1/n2)^2 < 11 times in
 * 1 - (n1/n2 sin i)^2: within 11 * 8 eps = 2e-14 of 0 nobody can be asked to. */
static void test_critical(void)
{
    random_stream s = random_start(2, 0, 0);
    size_t n = check_count(100000), wrong = 0, naive = 0, close = 0, total = 0, near = 0;
    double ct = 0, length = 0, law = 0;
    for (size_t i = 0; i < n; i++) {
        real n1 = 1 + random_next(&s), n2 = n1 * ((real)0.3 + (real)0.699 * random_next(&s));
        double away = pow(10, -(real_is_float ? 6.5 : 15) * (double)random_next(&s));
        real sine = n2 / n1 * (1 + (real)(random_next(&s) < (real)0.5 ? away : -away));
        vec3 N = vunit(random_unit(&s)), d = incident(N, real_clamp(sine, 0, 1), &s), w;
        wide cc, kk;
        snell x, y;
        wide_snell(d, N, n1, n2, &cc, &kk);
        double k = wide_value(kk) / ((double)n2 * (double)n2);  /* 1 - (n1/n2 sin i)^2 */
        bool bends = snell_of(d, N, n1, n2, &x), other = snell_of_naive(d, N, n1, n2, &y);
        if (fabs(k) < 2e-14) { close++; continue; }
        wrong += bends != (k > 0), total += !bends;
        if (fabs(k) < 2e-6) near++, naive += other != (k > 0);
        if (!bends || k <= 0) continue;
        double exact = wide_value(wide_sqrt(kk)) / (double)n2;
        ct = check_worse(ct, fabs(x.ct - exact) * exact);
        w = snell_refract(&x, d, N);
        length = check_worse(length, fabs((double)vlength(w) - 1));
        vec3 in = vcross(N, d), out = vcross(N, w);
        law = check_worse(law, (double)vlength(vsub(vscale(in, n1), vscale(out, n2))));
    }
    check_equal(wrong, 0, "wrong about total reflection, of %zu", n - close);
    check_at_least(total, n / 4, "much of it is total");
    check_at_most(ct, 32 * DBL_EPSILON, "ct times its error: k is off by some eps (19.3), whatever "
                                        "real is");
    check_at_most(length, 4 * (double)real_epsilon, "length of what is refracted");
    check_at_most(law, 32 * (double)real_epsilon, "n1 n x d = n2 n x w (19.2)");
    if (real_is_float)  /* in double it is right that far away */
        check_at_least(naive, near / 100, "the textbook is wrong, of %zu within 1e-6", near);
}

static void test_normal_incidence(void)
{
    random_stream s = random_start(3, 0, 0);
    size_t n = check_count(20000), nan = 0, bad = 0;
    double R = 0, ci = 0;
    for (size_t i = 0; i < n; i++) {
        vec3 N = vunit(random_unit(&s)), d = vneg(N);
        snell x, y;
        snell_of_naive(d, N, 1, 1.5, &y);
        nan += isnan(y.ct) ? 1 : 0;
        if (!snell_of(d, N, 1, 1.5, &x)) bad++;
        ci = check_worse(ci, fabs(x.ci - 1));
        vec3 w = snell_refract(&x, d, N);
        bad += !(vlength(vsub(w, d)) <= 8 * real_epsilon);
        R = check_worse(R, fabs((double)fresnel(&x) - 0.04));
        snell_of(d, N, 1.5, 1, &x);
        R = check_worse(R, fabs((double)fresnel(&x) - 0.04));
    }
    check_equal(bad, 0, "straight through");
    /* -n.d alone would be n.n: off by up to 3 eps in double, by 1e-7 in float */
    check_at_most(ci, DBL_EPSILON, "ci = 1 of their directions, whatever their lengths");
    check_at_most(R, (double)real_epsilon / 16, "R = ((1.5 - 1) / (1.5 + 1))^2 = 0.04");
    check_at_least(nan, n / 20, "1 - ci^2 < 0: the textbook's NaN");
}

/* (19.6), of two indices that differ. */
static double through(const snell *s)
{
    double pq = s->n1 * s->ci + s->n2 * s->ct, uv = s->n2 * s->ci + s->n1 * s->ct;
    double g = 2 * s->n1 * s->n2 * s->ci * s->ct;
    return s->total ? 0 : g / (pq * pq) + g / (uv * uv);
}

/* Directions and indices that are exact: along the surface, along the normal, none between. */
static void test_edges(void)
{
    vec3 up = {0, 0, 1}, graze = {1, 0, 0}, down = {0, 0, -1}, w;
    snell x;
    check(snell_of(graze, up, 1, 1.5, &x), "grazing into glass: goes in");
    check_close(fresnel(&x), 1, 2 * (double)real_epsilon, "and nothing of it");
    for (int k = 2; k < 40; k++) {  /* 1 + eps for some, but for the last line of fresnel */
        snell_of(graze, up, 1, (real)k, &x);
        check(fresnel(&x) <= 1, "not more than all");
    }
    snell_of(graze, up, 1, 1.5, &x);
    check_equal(x.ci, 0, "ci");
    w = snell_refract(&x, graze, up);
    check_close(w.x, 1 / 1.5, 2 * (double)real_epsilon, "at the critical angle");
    check(!snell_of(graze, up, 1.5, 1, &x) && fresnel(&x) == 1, "total");
    check(snell_of(graze, up, 1.25, 1.25, &x), "equal indices, grazing");
    check_equal(fresnel(&x), 0, "no interface, no reflection: not 0 / 0");
    w = snell_refract(&x, graze, up);
    check(w.x == 1 && w.y == 0 && w.z == 0, "straight on");
    check(snell_of(down, up, 1, 2, &x), "down");
    check_close(fresnel(&x), 1.0 / 9, (double)real_epsilon, "((2-1)/(2+1))^2");
    check(!snell_of(vec(NAN, 0, 0), up, 1, 2, &x) && fresnel(&x) == 1, "a NaN: total");
    /* Brewster: tan i = n2 / n1 = 4/3: sin = 0.8, cos = 0.6; what is refracted goes at right angles
     * to what is reflected: ct = 0.8. rp = 0, rs = (1.8 - 3.2) / (1.8 + 3.2) = -7/25. */
    snell_of(vec(0.8, 0, -0.6), up, 3, 4, &x);
    check_close(x.ct, 0.8, 2 * (double)real_epsilon, "Brewster's angle");
    check_close(fresnel(&x), 0.0392, 2 * (double)real_epsilon, "one polarisation: (7/25)^2 / 2");
    check_close(through(&x), 1 - 0.0392, 4 * (double)real_epsilon, "T");
}

/* n2 = n1 (1 + 1e-1 .. 1e-15), all angles; and the way back, into the thinner. */
static void test_fresnel(void)
{
    random_stream s = random_start(4, 0, 0);
    size_t n = check_count(50000), outside = 0;
    double error = 0, usual = 0, sum = 0, back = 0, close = 0;
    for (size_t i = 0; i < n; i++) {
        real delta = (real)pow(10, -(real_is_float ? 6.5 : 15) * (double)random_next(&s));
        real n1 = 1, n2 = 1 + delta * 2, cosine = (real)pow(10, -8 * (double)random_next(&s));
        vec3 N = vunit(random_unit(&s));
        vec3 d = incident_at(N, sqrt((1 - cosine) * (1 + cosine)), cosine, &s);
        if (i % 3 == 0) n1 = n2, n2 = 1;
        if (!(snell_dot(N, d) < 0)) continue;
        snell x;
        snell_of(d, N, n1, n2, &x);
        double R = (double)fresnel(&x), exact = wide_fresnel(d, N, n1, n2);
        outside += !(R >= 0 && R <= 1);
        double steep = sqrt((double)n2 - (double)n1);
        if (n1 < n2) error = check_worse(error, fabs(R - exact) * steep);
        if (n1 < n2 && delta > (real)5e-7) usual = check_worse(usual, fabs(R - exact));
        sum = check_worse(sum, fabs(R + through(&x) - 1));
        if (!x.total) {  /* the same R from the other side, at the angle of refraction */
            snell z = {x.n2, x.n1, x.ct, x.ci, false};
            back = check_worse(back, fabs((double)fresnel(&z) - R));
        }
    }
    check_equal(outside, 0, "R is in [0, 1]");
    /* dR/dci of a grazing ray is up to 4 n1 n2 / (n2 sqrt(n2^2 - n1^2)), some 3 / steep; ci is off
     * by a few eps of double. In float, the result is rounded. */
    double eps = (double)real_epsilon;
    check_at_most(error, 16 * DBL_EPSILON + (real_is_float ? eps : 0), "error of R, times steep");
    check_at_most(usual, 5e-13 + (real_is_float ? eps : 0), "R, n2 / n1 >= 1 + 1e-6");
    check_at_most(sum, 8 * (double)real_epsilon, "R + T = 1, by two formulas");
    check_at_most(back, real_is_float ? 2 * eps : 2e-13, "R is the same both ways");
    for (size_t i = 0; i < 1000; i++) {  /* nearly no interface, nearly grazing */
        real c = sqrt(real_epsilon) * (real)(1 + i) / 500, n2 = 1 + real_epsilon;
        vec3 N = {0, 0, 1}, d = {sqrt((1 - c) * (1 + c)), 0, -c};
        snell x;
        snell_of(d, N, 1, n2, &x);
        close = check_worse(close, fabs((double)fresnel(&x) - wide_fresnel(d, N, 1, n2)));
    }
    check_at_most(close, real_is_float ? eps : 8 * eps, "R at n2 = 1 + eps, where it is up to 1");
}

/* Between 0 and 90 degrees, from outside: the largest error of Schlick's form; it is exact only at
 * both ends. */
static void test_schlick(real n, double low, double high)
{
    double most = 0;
    for (int i = 0; i <= 900; i++) {
        real a = (real)i * pi / 1800;
        snell x;
        vec3 d = {sin(a), 0, -cos(a)}, up = {0, 0, 1};
        if (i == 900) d = (vec3){1, 0, 0};
        snell_of(d, up, 1, n, &x);
        double e = fabs((double)schlick(&x) - wide_fresnel(d, up, 1, n));
        most = fmax(most, e);
        if (i == 0 || i == 900) check_at_most(e, (double)real_epsilon / 16, "exact at %d", i / 10);
        snell y = {x.n2, x.n1, x.ct, x.ci, false};  /* from inside it takes the outer cosine */
        check_close(schlick(&y), schlick(&x), 1e-6, "the same from the other side");
    }
    check(most > low && most < high, "n = %g: Schlick is off by %g", (double)n, most);
}

static void test_absorb(void)
{
    double eps = (double)real_epsilon;
    vec3 a = {log((real)2) / 2, log((real)2), 0};
    vec3 one = absorbed(a, 1), two = absorbed(a, 2), four = absorbed(a, 4);
    check_close(two.x, 0.5, 2 * eps, "half of it after a way of 2");
    check_close(two.y, 0.25, 2 * eps, "green");
    check_equal(two.z, 1, "blue is not absorbed");
    check_close(one.x * one.x, two.x, 4 * eps, "two ways behind one another");
    check_close(four.y, 0.0625, 2 * eps, "twice as deep: the square");
    vec3 all = absorbed(vec(1, 0, 1e-30), real_infinity);
    check(all.x == 0 && all.y == 1 && all.z == 0, "an endless way: 0 or 1, no NaN");
    all = absorbed((vec3){1, 2, 3}, 0);
    check(all.x == 1 && all.y == 1 && all.z == 1, "no way");
}

static void test_media(void)
{
    medium m[6] = {{1, {0, 0, 0}, 0}, {2, {0, 0, 0}, 0}, {3, {0, 0, 0}, 0},
                   {4, {0, 0, 0}, 5}, {5, {0, 0, 0}, 0}, {6, {0, 0, 0}, -1}};
    media_set s = {0};
    check_equal(media_fills(m, &s), 0, "air");
    media_enter(&s, 1), media_enter(&s, 2);
    check_equal(media_fills(m, &s), 2, "the innermost");
    media_enter(&s, 3), media_enter(&s, 4);
    check_equal(media_fills(m, &s), 3, "priority");
    media_leave(&s, 3);
    check_equal(media_fills(m, &s), 4, "the innermost again");
    media_leave(&s, 2), media_leave(&s, 2);
    check(s.n == 2 && s.body[0] == 1 && s.body[1] == 4, "overlapping bodies end in any order");
    media_enter(&s, 4);
    check_equal(s.n, 2, "not twice");
    media_set p = {0};
    media_enter(&p, 5);
    check_equal(media_fills(m, &p), 5, "alone, any priority fills");
    media_enter(&p, 1), media_leave(&p, 5), media_enter(&p, 5);
    check_equal(media_fills(m, &p), 1, "a lower priority entered later does not");

    /* out of 1, into 2: in any order; twice the same face; in and out of 4 */
    for (int k = 0; k < 2; k++) {
        media_crossing c = {0};
        media_set in = {1, {1}};
        if (k) media_crossing_add(&c, 2, 1), media_crossing_add(&c, 1, -1);
        else media_crossing_add(&c, 1, -1), media_crossing_add(&c, 2, 1);
        media_crossing_add(&c, 1, -1);
        media_crossing_add(&c, 4, 1), media_crossing_add(&c, 4, -1);
        media_set before = media_before(in, &c), after = before;
        media_cross(&after, &c);
        check(media_fills(m, &before) == 1 && after.n == 1 && after.body[0] == 2, "touching");
    }
    media_crossing thin = {0};  /* in and out again at one place: we stay where we are */
    media_crossing_add(&thin, 1, 1), media_crossing_add(&thin, 1, -1);
    media_set stay = {1, {1}};
    media_cross(&stay, &thin);
    check(stay.n == 1 && stay.body[0] == 1, "in and out");
    media_crossing c = {0};
    media_crossing_add(&c, 2, -1);
    media_set in = {1, {4}}, before = media_before(in, &c);
    check(before.n == 2 && before.body[0] == 2 && before.body[1] == 4, "began in 2, outermost");
    media_set after = before;
    media_cross(&after, &c);
    check(after.n == 1 && after.body[0] == 4, "and left it");
    media_crossing both = {0};
    media_crossing_add(&both, 4, 1), media_crossing_add(&both, 1, 1);
    after = (media_set){0}, media_cross(&after, &both);
    check_equal(media_fills(m, &after), 4, "entered at once: the higher number fills");
    media_set full = {0};
    for (uint32_t k = 1; k < 20; k++)
        check(media_enter(&full, k) == (k <= media_most), "body %u: room", (unsigned)k);
    check_equal(full.n, media_most, "an eighth is not noted");
    check(media_enter(&full, 3), "one that is in there needs none");
    c = (media_crossing){0};
    for (uint32_t k = 20; k > 0; k--) media_crossing_add(&c, k, -1);
    check_equal(c.n, media_most_faces, "nor a ninth face");
    before = media_before(full, &c);
    check_equal(before.n, media_most, "no room: none added");
    check(!media_begin(&full, &c), "and it says so");
}

int main(void)
{
    test_reflect();
    test_critical();
    test_normal_incidence();
    test_edges();
    test_fresnel();
    test_schlick(1.1, 0.2, 0.22);
    test_schlick(1.5, 0.03, 0.04);
    test_absorb();
    test_media();
    return check_report("19_optics");
}
