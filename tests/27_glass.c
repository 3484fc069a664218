/* Tests of chapters/27_effects: bodies that overlap, light within them, and rough glass.
 *
 * Oracles: Beer's law and Snell's by hand, 19's tree of rays, 26's paths, quadratures.
 */
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

/* Balls and blocks anywhere, each of a glass of its own, and one that shines among them; the same
 * numbers, but `equal`: without priorities. */
static void random_glass(uint64_t number, bool equal, char text[4000])
{
    random_stream r = random_start(29, number, 0);
    size_t n = (size_t)snprintf(text, 4000, "%s", ABOVE
                                "material glow\nKe 1 0.5 0.2\nsphere 0.1 0.6 0.1 0.2\n");
    for (int k = 0; k < 5; k++) {
        double x = some(&r, -0.7, 0.4), y = some(&r, 0.1, 0.9), z = some(&r, -0.7, 0.4), p;
        double green = some(&r, 0, 1), red = some(&r, 0, 1);
        n += (size_t)snprintf(text + n, 4000 - n, "material m%d\nKd 0\nillum 7\nNi %.3f\n"
                              "absorb %.2f %.2f 0\n", k, some(&r, 1.05, 2), red, green);
        p = some(&r, 0, 3);
        n += (size_t)snprintf(text + n, 4000 - n, "priority %d\n", equal ? 0 : (int)p);
        if (k % 2) n += (size_t)snprintf(text + n, 4000 - n, "sphere %.3f %.3f %.3f %.3f\n", x, y,
                                         z, some(&r, 0.2, 0.8));
        else {
            double c = z + some(&r, 0.2, 1), b = y + some(&r, 0.2, 1), a = x + some(&r, 0.2, 1);
            n += (size_t)snprintf(text + n, 4000 - n, "box %.3f %.3f %.3f  %.3f %.3f %.3f\n", x, y,
                                  z, a, b, c);
        }
    }
}

/* Ray by ray 19's, wherever the eye is. */
static void test_whitted(void)
{
    size_t n = check_count(60), rays = 0, off = 0, inside = 0, moved = 0;
    for (size_t i = 0; i < n; i++) {
        char text[4000], plain[4000];
        set q, without;
        classic c;
        random_glass(i, false, text), random_glass(i, true, plain);
        set_up(&q, text), set_up(&without, plain);
        effects_stage_effects(&q.e, EFFECT_HARD_SHADOWS | EFFECTS_WHITTED);
        effects_stage_effects(&without.e, q.e.mask);
        q.e.depth = 12;  /* each turn in a ball makes a rounding larger: 12 leave it small */
        classic_build(&q.e, &c);
        c.how.apart = false;
        for (uint64_t k = 0; k < 100; k++, rays++) {
            random_stream s = random_start(30, i, k);
            real y = 45 * random_next(&s), x = 60 * random_next(&s);
            ray r = camera_ray(q.e.eye, x, y, 60, 45);
            if (k % 4 == 0) {  /* from among them, to the wall */
                vec3 d = vec(some(&s, -1, 1), some(&s, -1, 1), -1);
                vec3 o = vec(some(&s, -0.4, 0.6), some(&s, 0.3, 1.3), some(&s, -0.4, 0.6));
                r = ray_from(o, vunit(d));
            }
            media_set in = bodies_around(&q.e, r.o, NULL);
            tracer t = {.w = &c.e->t.world, .program = whitted_programs, .user = &c.how};
            vec3 a = seen_along(&q, r), b = whitted_ray(&t, r, in);
            inside += in.n > 1;
            off += !(vlength(vsub(a, b)) <= 65536 * real_epsilon);
            moved += vlength(vsub(a, seen_along(&without, r))) > (real)0.01;
        }
        classic_free(&c);
        tear_down(&q), tear_down(&without);
    }
    check_at_most((double)off, (sizeof(real) == 4 ? 0.02 : 1e-3) * (double)rays,
                  "of %zu rays, those that are not 19's", rays);
    check_at_least((double)inside, 0.005 * (double)rays, "begun in two bodies");
    check_at_least((double)moved, 0.02 * (double)rays, "without priorities: another picture");
}

/* Radiance is squeezed into a smaller solid angle in glass (19.11): under a sky of 1 an eye in it
 * sees n^2 in every direction, of the body that fills its place; seen from outside, what shines or
 * is lit in water is 1/n^2 as bright. */
static void test_squeeze(void)
{
    #define POOLS "camera from 0 0 9 at 0 0 0\nbackground 1\nmaterial water\nKd 0\nNi 1.25\n"      \
        "illum 7\nsphere 0 0 0 4\nmaterial glass\nKd 0\nNi 1.5\nillum 7\n"
    #define UNIT "sphere 0 0 0 1\n"
    static const struct { const char *text; real x, n; } eye[] = {
        {POOLS UNIT, 0, (real)1.5}, {POOLS UNIT, 2, (real)1.25}, {POOLS UNIT, 9, 1},
        {POOLS "priority 1\n" UNIT, 0, (real)1.5}, {POOLS "priority 1\nsphere 3 0 0 2\n", 2, 1.5},
        {POOLS "material air\nNi 1\nTf 1\nillum 7\n" UNIT, 0, 1}};
    for (size_t k = 0; k < sizeof eye / sizeof *eye; k++) {
        set q;
        double worst = 0;
        set_up(&q, eye[k].text);
        for (uint64_t i = 0; i < check_count(200); i++) {
            random_stream s = random_start(34, i, 0);
            vec3 d = vec(some(&s, -1, 1), some(&s, -1, 1), some(&s, -1, 1));
            ray r = ray_from((vec3){eye[k].x, 0, 0}, vunit(d));
            worst = check_worse(worst, fabs((double)(seen_along(&q, r).x - eye[k].n * eye[k].n)));
        }
        check_at_most(worst, 0.02, "eye %d: n^2 of its place, but for what is cut", (int)k);
        tear_down(&q);
    }
    #define POOL "camera from 0 0 5 at 0 0 0 up 0 1 0\nmaterial water\nKd 0\nNi 1.33\nillum 7\n"   \
        "box -9 -9 -1  9 9 0\n"
    const double R = pow(0.33 / 2.33, 2), way = (1 - R) / (1.33 * 1.33), lit = 2 * way / (double)pi;
    double shines[3] = {way, way, way}, shone[3] = {lit, lit, lit};
    expect("a floor that shines in water", POOL "indirect off\nmaterial m\nKe 1\n"
           "polygon -8 -8 -0.75  8 -8 -0.75  8 8 -0.75  -8 8 -0.75\n", shines, 64,
           EFFECTS_WHITTED);
    expect("one that is lit in it", POOL "indirect off\nlight at 0 0 -0.25 colour 1\n"
           "material m\nKd 0.5\npolygon -8 -8 -0.75  8 -8 -0.75  8 8 -0.75  -8 8 -0.75\n", shone,
           256, EFFECT_HARD_SHADOWS | EFFECTS_WHITTED);
    const double w = 0.04 + 0.96 / 2.25, window[3] = {w, w, w};
    expect("a window of one face: behind it all is glass", "camera from 0 0 5 at 0 0 0\n"
           "background 1\nmaterial glass\nKd 0\nNi 1.5\nillum 7\n"
           "polygon -9 -9 0  9 -9 0  9 9 0  -9 9 0\n", window, 64, 0);
    expect("a picture, not lit", POOL "material m\nKd 1\nillum 0\n"
           "polygon -8 -8 -0.75  8 -8 -0.75  8 8 -0.75  -8 8 -0.75\n", shines, 64, 0);
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
    "illum 6\nabsorb 0.4 0.8 0\n"

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
    const double gap[] = {0, 200, 400, 800, -200, -400, -800};
    for (size_t k = 0; k < sizeof gap / sizeof *gap; k++) {  /* none, to within rounding */
        char text[700];
        snprintf(text, sizeof text, FOG "box -50 %.17g -50  50 0.5 50\nbox -1 0.1 -1  1 0.4 1\n",
                 gap[k] * (double)real_epsilon);
        expect("fog on the floor, a part of it said twice", text, fog, 3e6, sky);
        expect("by paths, too", text, fog, 3e6, sky | EFFECT_INDIRECT);
    }
}

/* Nine balls within one another, each of a glass of its own: in the middle, no more than seven are
 * noted, the innermost; from the two outermost shells it is told which these are not. */
static void test_shells(void)
{
    char text[700] = "camera from 0 0 20 at 0 0 0\nbackground 1\n";
    set q;
    for (int k = 1; k <= 9; k++)
        snprintf(text + strlen(text), 60, "material m%d\nKd 0\nillum 7\nsphere 0 0 0 %d\n", k, k);
    set_up(&q, text);
    effects_counts c = {.lost = 0};
    media_set all = bodies_around(&q.e, (vec3){0, 0, 0}, &c);
    check_equal(all.n, media_most, "in nine bodies: the most that are noted");
    check_equal(c.lost, 1, "and it is told that there are more");
    for (uint32_t k = 1; k <= 3; k++) {
        media_set in = bodies_around(&q.e, vec(0, 0, 9.5 - k), &c);
        check_equal(in.n, k, "in the outermost %u", (unsigned)k);
        check(in.n == k && media_has(&all, in.body[k - 1]) == (k == 3),
              "%u from without: noted from the middle or not", (unsigned)k);
    }
    check_equal(c.lost, 1, "of three bodies none is lost");
    tear_down(&q);
}

/* Without refraction no ray is told what it is in: absorption, asked for alone, dims nothing. */
static void test_alone(void)
{
    const unsigned way[] = {EFFECT_ABSORPTION, EFFECT_ABSORPTION | EFFECT_REFRACTION};
    set q;
    set_up(&q, "camera from 0 0 9 at 0 0 0\nbackground 1\nmaterial fog\nKd 0\nillum 6\nTf 1\n"
               "absorb 1\nsphere 0 0 0 1\n");
    for (int k = 0; k < 2; k++) {
        dice d = dice_start(1, 0, 0);
        effects_counts c = {.lost = 0};
        ray up = ray_from((vec3){0, 0, 3}, (vec3){0, 1, 0});
        effects_stage_effects(&q.e, way[k]);
        media_set in = bodies_around(&q.e, (vec3){0, 0, 0}, NULL);
        vec3 L = effects_alone(effects_made_for(way[k]), &q.e, up, in, &d, &c);
        check_equal(L.x, k ? 0 : 1, "sky, begun in fog, with refraction: %d", k);
    }
    tear_down(&q);
}

/* A lamp at z = 0, Ke 1, seen from z = 9 through a block of fog from x0 z0 to x1 z1, Ni 1, begun at
 * the lens and at `hither`: the way in the fog, cut by the block, is what weakens it. */
static void test_begins(const char *eye, double x0, double z0, double x1, double z1)
{
    char text[700];
    set q;
    double worst = 0;
    snprintf(text, sizeof text, "%s\nindirect off\nmaterial lamp\nKe 1\n"
             "polygon -50 -50 0  50 -50 0  50 50 0  -50 50 0\n"
             "material fog\nKd 0\nillum 6\nabsorb 0.1\nbox %g -60 %g  %g 60 %g\n", eye, x0, z0,
             x1, z1);
    set_up(&q, text);
    effects_stage_effects(&q.e, q.e.mask | EFFECTS_DICED);  /* anywhere in the pixel */
    for (uint64_t seed = 0; seed < 200; seed++) {
        image im;
        dice_pixel of;
        drawing j = {.e = &q.e, .samples = 1, .seed = seed, .width = 1, .height = 1};
        if (!draw_image(&j, &im, 1)) abort();
        dice_pixel_of(seed, 0, true, &of);
        dice d = dice_sample(&of, 0);
        ray r = draw_ray(&j, 0, 0, &d);
        double from = (double)r.tmin, to = (double)(-r.o.z / r.d.z);
        const double lo[2] = {x0, z0}, hi[2] = {x1, z1};
        const double o[2] = {(double)r.o.x, (double)r.o.z}, v[2] = {(double)r.d.x, (double)r.d.z};
        for (int k = 0; k < 2; k++) {
            double a = (lo[k] - o[k]) / v[k], b = (hi[k] - o[k]) / v[k];
            from = fmax(from, fmin(a, b)), to = fmin(to, fmax(a, b));
        }
        double exact = exp(-0.1 * fmax(to - from, 0) * (double)vlength(r.d));
        worst = check_worse(worst, fabs((double)im.rgb[0] - exact));
        image_free(&im);
    }
    check_at_most(worst, 1e-6 + 256 * (double)real_epsilon, "begun %s: fog from %g %g to %g %g",
                  eye, x0, z0, x1, z1);
    tear_down(&q);
}

#define EYE "camera from 0 0 9 at 0 0 0 angle 40"
static void test_begins_elsewhere(void)
{
    test_begins(EYE, -70, 3, 70, 5), test_begins(EYE, -70, 3, 70, 20);  /* a pinhole, in both */
    test_begins(EYE " hither 5", -70, 2, 70, 8);                        /* `hither` in a body, */
    test_begins(EYE " hither 5", -70, -1, 70, 8);                       /* with the lamp */
    test_begins(EYE " hither 5", -70, 5, 70, 12);                       /* eye in, beyond it out, */
    test_begins(EYE " hither 5", -70, -1, 70, 12);                      /* both in, */
    test_begins(EYE " hither 5", -70, 6, 70, 8);                        /* all nearer than that */
    test_begins(EYE " hither 5", 0.4, -1, 70, 12);                      /* a wall along the view, */
    test_begins(EYE " hither 5", -0.4, 2, 70, 8);
    test_begins(EYE "\nlens radius 1 focus 4", 0.4, -1, 70, 20);        /* through the lens, */
    test_begins(EYE "\nlens radius 1 focus 4", -0.4, -1, 70, 20);       /* the eye in it or not, */
    test_begins(EYE " hither 2\nlens radius 1 focus 40", -0.4, 1, 70, 8);     /* and all at once */
}

/* ---- rough glass (27_radiance: in 26's room) ---- */

#define FROSTED "material frosted\nKd 0\nNi 1.5\nillum 7\n"
#define GREY_SKY "camera from 0 0 6 at 0 0 0 angle 25\nenvironment 0.2 0.4 0.6  1 0.8 0.3\n"

/* Two scenes have the same light along rays of the first's picture. False alarms: 1e-8 each. */
static void test_alike(const char *what, const char *one, const char *other)
{
    set a, b;
    size_t n = check_count(6000);
    double worst = 1;
    set_up(&a, one), set_up(&b, other);
    effects_stage_effects(&a.e, a.p.effects | EFFECTS_DICED);
    effects_stage_effects(&b.e, b.p.effects | EFFECTS_DICED);
    for (int i = 0; i < 8 * 6; i++) {
        ray r = camera_ray(a.e.eye, (real)(i % 8) + (real)0.4, (real)(i / 8) + (real)0.3, 8, 6);
        estimate x = mean_along(&a, r, 5, n), y = mean_along(&b, r, 6, n);
        double likely = likely_alike(x, y);
        if (!(likely >= worst)) worst = likely;
    }
    check_at_least(worst, 1e-8, "%s: least p of 48 rays", what);
    tear_down(&a), tear_down(&b);
}

/* In white light nothing is won, and what facets hide is lost: of each face at most some alpha, and
 * as much as in 26. From within it is the same. */
static void test_furnace(void)
{
    static const double rough[] = {0.7, 0.45, 0.2, 0.03, 1e-6};
    double before = 0;
    for (size_t k = 0; k < sizeof rough / sizeof *rough; k++) {
        char text[400];
        set q;
        snprintf(text, sizeof text, "camera from 0 0 6 at 0 0 0\nbackground 1\n" FROSTED
                 "roughness %g\nsphere 0 0 0 1\n", rough[k]);
        set_up(&q, text);
        for (int j = 0; j < 5; j++) {  /* head on, aside, along its edge, and from within */
            const real y[5] = {0, 0.6, 0.99, 1 - 1e-6, 0.5};
            ray r = ray_from((vec3){0, y[j], j < 4 ? 5 : 0}, (vec3){0, 0, -1});
            estimate e = mean_along(&q, r, 7, check_count(4000));
            double error = 6 * estimate_error(e) + 100 * (double)real_epsilon;
            double all = j == 4 ? 2.25 : 1;  /* n^2 (19.11) */
            check_at_most(e.mean, all + error, "light is won, roughness %g, ray %d", rough[k], j);
            check_at_least(likely_alike(e, mean_of_26(&q, 1, r, check_count(4000))), 1e-8,
                           "as much as 26: %g, roughness %g, ray %d", e.mean, rough[k], j);
            if (j != 0 && j != 4) continue;
            check_at_least(e.mean, all * (1 - rough[k] * rough[k]) - error,
                           "little is lost, ray %d", j);
            check(j || e.mean >= before - error, "the less the smoother: %g, %g", before, e.mean);
            if (j == 0) before = e.mean;
        }
        tear_down(&q);
    }
}

/* Without `glossy` rough glass is smooth, to the last bit; and so is glass of hardly any roughness,
 * but for the numbers. */
static void test_smooth(void)
{
    set a, b;
    size_t off = 0;
    set_up(&a, GREY_SKY FROSTED "roughness 0.5\nsphere 0 0 0 1\n");
    set_up(&b, GREY_SKY FROSTED "sphere 0 0 0 1\n");
    effects_stage_effects(&a.e, EFFECT_MIRROR | EFFECT_REFRACTION);
    effects_stage_effects(&b.e, EFFECT_MIRROR | EFFECT_REFRACTION);
    for (int i = 0; i < 40 * 30; i++) {
        ray r = camera_ray(a.e.eye, (real)(i % 40), (real)(i / 40), 40, 30);
        vec3 x = seen_along(&a, r), y = seen_along(&b, r);
        off += memcmp(&x, &y, sizeof x) != 0;
    }
    check_equal(off, 0, "rays that are not smooth");
    tear_down(&a), tear_down(&b);
    test_alike("roughness 1e-6", GREY_SKY FROSTED "roughness 1e-6\nsphere 0 0 0 1\n",
               GREY_SKY FROSTED "sphere 0 0 0 1\n");
    test_alike("of coloured glass in a dense ball",
               GREY_SKY FROSTED "roughness 1e-6\nTf 0.9 0.5 0.3\nsphere 0.2 0 0 0.6\n"
               "material dense\nNi 2\nTf 1\nKd 0\nillum 7\nsphere 0 0 0 1\n",
               GREY_SKY FROSTED "Tf 0.9 0.5 0.3\nsphere 0.2 0 0 0.6\n"
               "material dense\nNi 2\nTf 1\nKd 0\nillum 7\nsphere 0 0 0 1\n");
}

/* Two walls at one place: the rough one, whichever is met first. Into its glass, or up to it. A
 * rough boundary of two equal indices is none. */
static void test_rough_contact(void)
{
    #define ROUGH "material rough\nKd 0\nNi 2.4\nroughness 0.8\nabsorb 1 2 4\nillum 7\n"           \
        "priority 1\nbox -1 -1 -0.6  1 1 0\n"
    #define ASIDE "camera from 3 2 5 at 0 0 0 angle 15\nenvironment 0 0 0  1 1 1\n"
    test_alike("rough or smooth first", ASIDE ROUGH WATER "box -1 -1 0  1 1 0.5\n",
               ASIDE WATER "box -1 -1 0  1 1 0.5\n" ROUGH);
    test_alike("water let into it", ASIDE ROUGH WATER "box -1 -1 0  1 1 0.5\n",
               ASIDE WATER "box -1 -1 -0.2  1 1 0.5\n" ROUGH);
    test_alike("frosted water in water", GREY_SKY WATER "sphere 0 0 0 1\n", GREY_SKY WATER
               "sphere 0 0 0 1\nmaterial ice\nKd 0\nNi 1.33\nabsorb 0.1 0.4 0.1\n"
               "roughness 0.7\nillum 7\nsphere 0.1 0.2 0 0.5\n");
}

/* Shadow rays, or what rays run into alone: the same light, of a picture in all. False alarms:
 * 1e-8. The error with them is at most `most` of that without. */
static void test_rough_lit(const char *text, double most)
{
    const unsigned lights = EFFECT_SOFT_SHADOWS | EFFECT_ENVIRONMENT;
    set q;
    double off = 0, sum = 0, square[2] = {0, 0};
    set_up(&q, text);
    check((q.p.effects & lights) && !(q.p.effects & EFFECT_INDIRECT), "light on it alone");
    for (int i = 0; i < 8 * 6; i++) {
        ray r = camera_ray(q.e.eye, (real)(i % 8) + (real)0.4, (real)(i / 8) + (real)0.3, 8, 6);
        estimate x[2];
        for (int k = 0; k < 2; k++) {
            effects_stage_effects(&q.e, k ? q.p.effects & ~lights : q.p.effects);
            x[k] = mean_along(&q, r, 100 + (uint64_t)(2 * i + k), check_count(3000));
            square[k] += estimate_error(x[k]) * estimate_error(x[k]);
        }
        off += x[0].mean - x[1].mean, sum += x[1].mean;
    }
    check_at_most(fabs(off), 5.7 * sqrt(square[0] + square[1]), "shadow rays or none, of %g", sum);
    check_at_most(sqrt(square[0] / square[1]), most, "error, of that without shadow rays");
    tear_down(&q);
}

/* Of a lamp of one unit the error is a third; of skies rays alone are about as good. */
static void test_rough_skies(void)
{
    #define ROUGH_BALL "camera from 0 0 5 at 0 0 0 angle 22\n" FROSTED "roughness 0.6\n"          \
        "absorb 0.1 0.3 0.6\nsphere 0 0 0 1\n"
    char picture[500];
    test_rough_lit(ROUGH_BALL "material lamp\nKe 30\n"
                   "polygon -1 3 -1  0 3 -1  0 3 0  -1 3 0\n", 0.5);
    test_rough_lit(ROUGH_BALL "environment 0.2 0.3 0.4  0.9 0.8 0.6\n", 1.5);
    put("sky.ppm", "P3 4 2 255  255 0 9  40 250 40  0 0 255  255 255 255"
                   "  90 90 200  255 200 0  0 0 0  255 0 255\n");
    snprintf(picture, sizeof picture, ROUGH_BALL "environment \"%s\"\n", in_directory("sky.ppm"));
    test_rough_lit(picture, 1.5);
}

/* A face of rough glass at z = 0.1 under a light without size, above it or below, seen from above
 * or below, one hit alone: f cos I / r^2 (23.24), and what the glass below leaves of it. On that
 * face water may stand. */
static void test_rough_point(void)
{
    static const char *const above[] = {"", "material water\nKd 0\nNi 1.33\nillum 7\n"
                                            "box -9 -9 0.1  9 9 9\n"};
    for (int kind = 0; kind < 8; kind++) {
        char text[500];
        set q;
        bool below = kind & 1, under = kind & 2, wet = kind & 4;  /* the eye; the light */
        real top = wet ? (real)1.33 : 1, n1 = below ? (real)1.5 : top, n2 = below ? top : (real)1.5;
        const rough_glass g = {(real)0.36, n1, n2};
        vec3 at = {1, 0, under ? (real)-1.9 : (real)2.1}, eye = {-1, (real)0.5, below ? -2 : 3};
        snprintf(text, sizeof text, "camera from 0 0 5 at 0 0 0 up 0 1 0\nlight at 1 0 %g colour 10"
                 "\n%s" FROSTED "roughness 0.6\nabsorb 0.3\nbox -9 -9 -9  9 9 0.1\n",
                 (double)at.z, above[wet]);
        set_up(&q, text);
        q.e.depth = 1;
        check(q.p.effects & EFFECT_HARD_SHADOWS, "a light on rough glass");
        double worst = 0;
        for (uint64_t k = 0; k < 100; k++) {
            random_stream r = random_start(33, k, 0);
            vec3 p = {(real)some(&r, -1, 1), (real)some(&r, -1, 1), (real)0.1};
            vec3 wo = vunit(vsub(eye, p)), wi = vunit(vsub(at, p)), to = vsub(at, p);
            ray from = {eye, 0, vneg(wo), real_infinity};
            double way = (double)vlength(to), seen = below ? (double)vlength(vsub(eye, p)) : 0;
            double exact = fabs((double)wi.z) * 10 / (way * way);
            if (below) wo.z = -wo.z, wi.z = -wi.z;  /* z is where wo is */
            exact *= (double)rough_glass_value(&g, wi, wo) * exp(-0.3 * (seen + (under ? way : 0)));
            dice d = dice_start(1, k, 0);
            effects_counts c = {.lost = 0};
            vec3 L = effects_alone(effects_made_for(q.e.mask), &q.e, from,
                                   bodies_around(&q.e, eye, NULL), &d, &c);
            worst = check_worse(worst, fabs((double)L.x - exact) / (exact + 1e-3));
        }
        check_at_most(worst, 1e4 * (double)real_epsilon, "eye %s, light %s, %s: relative error",
                      below ? "below" : "above", under ? "below" : "above", wet ? "wet" : "dry");
        tear_down(&q);
    }
}

int main(void)
{
    seconds_at_most(120);
    if (!mkdtemp(directory)) abort();
    int failed = check_all("27_glass", test_priorities, test_whitted, test_squeeze, test_within,
                           test_shells, test_alone, test_begins_elsewhere, test_furnace,
                           test_smooth, test_rough_contact, test_rough_skies, test_rough_point);
    remove_directory();
    return failed;
}
