/* Tests of chapters/27_effects: what is drawn: the copies for fixed masks, the light of 18, 19 and
 * 26 where they can draw the same, bodies within bodies, and closed forms. (27_proof: that the
 * plan's picture is that of everything.)
 */
#include "27_seen.h"

/* The copies for fixed masks are the same function: the general one gives the same bytes. */
static void test_special(void)
{
#define MASK(name, set, maybe) set, (set) | (maybe),
    static const unsigned masks[] = {EFFECTS_SETS(MASK)};
    check(effects_made_for(EFFECT_HARD_SHADOWS | EFFECTS_GENERAL) == effects_general, "for prices");
    set q;
    set_up(&q, "camera from 0 1.5 6 at 0 0.8 0 angle 40\nenvironment 0.3 0.4 0.6 1 1 0.9\n"
           "light at 2 4 3 colour 60\nsun to -1 2 1 colour 0.7\n"
           "material lamp\nKe 5 4 3\npolygon -1 4 -1  1 4 -1  1 4 1  -1 4 1\nsphere 1.5 3 1 0.2\n"
           "material chrome\nKd 0.1\nKs 0.7 0.8 0.9\nillum 3\nsphere -1 0.6 0 0.6\n"
           "material satin\nKd 0.2\nKs 0.6\nNs 40\nillum 3\nsphere 0.4 0.5 0.8 0.5\n"
           "material glass\nNi 1.5\nTf 0.9 1 1\nKd 0\nillum 7\nsphere 1 0.7 -0.4 0.7\n"
           "material pane\nKd 0.3\nd 0.4\nKs 0.2\nNs 20\n"
           "polygon -2 0 1.4  -1 0 1.4  -1 1 1.4  -2 1 1.4\n"
           "material green\nNi 1.3\nTf 1\nKd 0\nKs 0.1\nabsorb 2 0.3 1\nillum 6\n"
           "sphere -0.2 0.4 1.6 0.4\nmaterial wall\nKd 0.7 0.3 0.3\nKs 0.2\nNs 10\nillum 2\n"
           "polygon -3 0 -2  3 0 -2  3 4 -2  -3 4 -2\npolygon -3 0 3  3 0 3  3 0 -2  -3 0 -2\n");
    for (size_t k = 0; k < sizeof masks / sizeof *masks; k++) {
        size_t bad = 0;
        effects_stage_effects(&q.e, masks[k]);
        effects_function *own = effects_made_for(masks[k]);
        check(own != effects_general, "mask %x has no copy of its own", masks[k]);
        for (int i = 0; i < 300; i++) {
            dice d = dice_start(1, (uint64_t)i, 0);
            effects_counts c = {.lost = 0};
            ray r = camera_ray(q.e.eye, (real)(i % 20), (real)(i / 20), 20, 15);
            vec3 a = effects_alone(own, &q.e, r, (media_set){0}, &d, &c);
            vec3 b = effects_alone(effects_general, &q.e, r, (media_set){0}, &d, &c);
            bad += memcmp(&a, &b, sizeof a) != 0;
        }
        check(bad == 0, "mask %x: %zu of 300 rays differ from the general function", masks[k], bad);
    }
    tear_down(&q);
}

/* ---- 18 and 19 ---- */

/* Of 60 x 45 rays of the picture, those that the chapter sees otherwise. */
static size_t rays_off(set *q, const classic *c, vec3 (*chapter)(const classic *, ray), real most)
{
    enum { w = 60, h = 45 };
    size_t off = 0;
    for (int i = 0; i < w * h; i++) {
        ray r = camera_ray(q->e.eye, (real)(i % w) + (real)0.37, (real)(i / w) + (real)0.41, w, h);
        off += !(vlength(vsub(seen_along(q, r), chapter(c, r))) <= most);
    }
    return off;
}

static void test_classic(bool glass)
{
    set q;
    classic c;
    char *text = forty_text(!glass);
    set_up(&q, text);
    classic_build(&q.e, &c);
    size_t off = rays_off(&q, &c, glass ? classic_whitted : classic_shade, 256 * real_epsilon);
    /* 27's surfaces of balls are 19's, 18's take a root: a few epsilon apart, but at an edge of a
     * shadow or ball, where one ray may fall on the other side: of 2,700 few. */
    check_at_most((double)off, glass ? 0 : 5, "rays that are not %s's", glass ? "19" : "18");
    classic_free(&c);
    tear_down(&q);
    free(text);
}

/* ---- glass that touches ---- */

/* Blocks of glass and water side by side and on a table, one block upon another of the same glass,
 * and a ball of a third glass that overlaps three of them. Nothing matte is in glass: 27 leaves out
 * the (n1/n2)^2 of (19.10), which cancels where lamps and eye are in air. */
#define BLOCKS \
    "material glass\nKd 0\nNi 1.5\nabsorb 0.3 0.1 0.2\nillum 7\n"                              \
    "box -1 0 -0.5  0 1 0.5\nbox -1 1 -0.5  0 1.5 0.5\n"                                         \
    "material water\nKd 0\nNi 1.33\nabsorb 0.1 0.4 0.1\nillum 7\nbox 0 0 -0.5  1 0.75 0.5\n"    \
    "material dense\nKd 0\nNi 1.8\nillum 7\nsphere 0.1 0.8 0 0.4\n"
#define UNDER "material chrome\nKd 0\nKs 0.8 0.7 0.6\nillum 3\n"                               \
    "polygon -4 0 4  4 0 4  4 0 -4  -4 0 -4\n"

static void test_touching(const char *text)
{
    set q;
    classic c;
    set_up(&q, text);
    q.e.depth = 12;  /* each turn in a ball makes a rounding larger: 12 of them leave it small */
    classic_build(&q.e, &c);
    c.how.apart = false;
    size_t off = rays_off(&q, &c, classic_whitted, 4096 * real_epsilon);
    c.how.apart = true;
    size_t naive = rays_off(&q, &c, classic_whitted, 4096 * real_epsilon);
    /* rounding moves edges of what is seen through glass: of 2,700 rays few are at one */
    check_at_most((double)off, sizeof(real) == 4 ? 27 : 0, "rays that are not 19's");
    check_at_least((double)naive, 270, "face by face it is another picture");
    classic_free(&c);
    tear_down(&q);
}

/* ---- 26 ---- */

/* 26's path tracer in a room: the difference of two independent means, ray by ray. The ceiling is
 * the lamp, from wall to wall: its back, which shines here and not in 26, sees nothing. In the
 * room: a glass ball that absorbs, and a mirror: a white one, since brdf_mirror follows Schlick's
 * Fresnel, and 27's illum 3 reflects the same at every angle. */
static void test_paths(const char *text, unsigned effects)
{
    set q;
    size_t n = check_count(6000);
    double worst = 1;
    set_up(&q, text);
    check(q.p.effects == effects, "the room calls for %x", q.p.effects);
    for (int i = 0; i < 8 * 6; i++) {  /* a ray each, some through glass and mirror */
        ray r = camera_ray(q.e.eye, (real)(i % 8) + (real)0.4, (real)(i / 8) + (real)0.3, 8, 6);
        double likely = likely_alike(mean_along(&q, r, 3, n), mean_of_26(&q, 0, r, n));
        if (!(likely >= worst)) worst = likely;
    }
    /* false alarms: 48 comparisons, 1e-7 each */
    check_at_least(worst, 1e-7, "the room's light is not 26's: least p of 48 rays");
    tear_down(&q);
}

/* ---- bodies: what a ray is inside of ---- */

#define SEEN "camera from 0 0 5 at 0 0 0 angle 30\nbackground 0.1 0.2 0.3\n"                    \
    "material lines\nKd 0.2 0.9 0.4\nillum 0\npolygon -9 -1 -3  9 -1 -3  9 0.2 -3  -9 0.2 -3\n"
#define GLASS_BALL "material glass\nKd 0\nNi 1.5\nillum 7\nabsorb 0.3 0.1 0.2\nsphere 0 0 0 1\n"
#define CLEAR_BALL SEEN "material glass\nKd 0\nNi 1.5\nillum 6\nsphere 0 0 0 1\n"
#define OF_A "camera from 0 0 5 at 0 0 0\nbackground 1\nmaterial a\nKd 0\nillum 6\nabsorb 0.5\n"
#define WAY OF_A "sphere 0 0 0 2\n"
#define WAY_IN WAY "material b\nKd 0\nillum 6\nabsorb 2\nsphere 0 0 0 1\n"

#define BLOCKS_WAY "camera from 0 0 5 at 0 0 0\nbackground 1\nmaterial table\nKd 0.5\nillum 1\n" \
    "polygon -9 -1 9  9 -1 9  9 -1 -9  -9 -1 -9\nmaterial a\nKd 0\nillum 6\nabsorb 0.5\n"      \
    "box -1 -1 0  1 1 2\nmaterial b\nKd 0\nillum 6\nabsorb 2\nbox -1 -1 -2  1 1 0\n"

static void test_bodies(void)
{
    test_same("a ball within a ball of the same glass", SEEN GLASS_BALL,
              SEEN GLASS_BALL "sphere 0.1 0 0.2 0.5\n");
    test_same("balls within it that overlap", SEEN GLASS_BALL,
              SEEN GLASS_BALL "sphere 0.2 0 0.2 0.5\nsphere -0.2 0 0.1 0.5\nsphere 0 0.2 0 0.6\n");
    test_same("a bubble: a ball turned inside out, or one of Ni 1",
              CLEAR_BALL "sphere 0.1 0 0 -0.5\n",
              CLEAR_BALL "material air\nKd 0\nNi 1\nillum 6\nsphere 0.1 0 0 0.5\n");
    test_way(WAY, 5, 0.5 * 4), test_way(WAY, 1, 0.5 * 3);
    test_way(WAY_IN, 5, 0.5 * 2 + 2 * 2);
    test_way(WAY_IN, 0, 2 * 1 + 0.5 * 1);  /* begun in both: the innermost fills it */
    test_way(WAY_IN, 1.5, 0.5 * 0.5 + 2 * 2 + 0.5 * 1);  /* begun in the outer one */
    test_way(BLOCKS_WAY, 5, 0.5 * 2 + 2 * 2), test_way(BLOCKS_WAY, 1, 0.5 * 1 + 2 * 2);
    test_way(BLOCKS_WAY, -0.5, 2 * 1.5);  /* begun in the second of two that touch, on a table */
    /* a bubble turned inside out that touches its ball from inside, where the ray enters both */
    test_way(WAY "sphere 0 0 1 -1\n", 5, 0.5 * 2);
    test_way(OF_A "sphere 0 0 1 -1\nsphere 0 0 0 2\n", 5, 0.5 * 2);
    /* a ball on a table, straight through its foot: the table shows */
    test_way("camera from 0 0 5 at 0 0 0\nbackground 1\nmaterial a\nKd 0\nNi 1.5\nTf 1\nillum 7\n"
             "sphere 0 0 0 1\nmaterial table\nKd 0\npolygon -9 -9 -1  9 -9 -1  9 9 -1  -9 9 -1\n",
             5, -log(0.04));
    /* a single sheet, left behind: nobody was in it */
    test_way("camera from 0 0 5 at 0 0 0\nbackground 1\nmaterial a\nKd 0\nillum 6\nabsorb 1\n"
             "polygon -1 -1 0  -1 1 0  1 1 0  1 -1 0\nsphere 9 0 0 1\n", -1, 0);
    test_way("camera from 0 0 5 at 0 0 0\nbackground 1\nmaterial a\nKd 0\nillum 6\nabsorb 1\n"
             "polygon -1 -1 0  1 -1 0  1 1 0  -1 1 0\n", 5, (double)INFINITY);  /* never out */
    /* a prism: in by its face, all reflected at 45 degrees, 2 later out by the other face */
    test_way("camera from 0 0 5 at 0 0 0\nbackground 1\nmaterial a\nKd 0\nNi 1.5\nillum 6\n"
             "absorb 0.7\npolygon -1 -1 0  1 -1 0  1 1 0  -1 1 0\n"
             "polygon -1 -1 0  -1 -1 -2  1 -1 -2  1 -1 0\n"
             "polygon -1 1 0  1 1 0  1 -1 -2  -1 -1 -2\n", 5, 0.7 * 2);
}

/* A block between two others and on a table: of polygons, of triangles as they stand, and moved.
 * Contact rays are asked of what touches, and only there: one ball in the air has none. */
static void test_blocks(void)
{
    #define BESIDE WATER "box 1 0 0  2 0.75 1\nbox -1 0 0  0 0.5 1\n" UNDER
    static const char *const made[] = {
        "obj %s\n", "obj %s turn 0 1 0 90 move 0 0 1\n", "mesh m %s\ninstance m\n",
        "mesh m %s\ninstance m move 9 0 0\ninstance m turn 0 1 0 90 move 0 0 1\n"};
    char text[4000], one[300];
    put("cube.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
        "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 4 8 7 3\nf 1 5 8 4\nf 2 3 7 6\n");
    for (size_t k = 0; k < sizeof made / sizeof *made; k++) {
        snprintf(one, sizeof one, made[k], in_directory("cube.obj"));
        snprintf(text, sizeof text, "%suse glass\n%s", ABOVE GLASS BESIDE, one);
        test_same(one, ABOVE GLASS BESIDE "box 0 0 0  1 1 1  glass\n", text);
    }
    snprintf(text, sizeof text, ABOVE GLASS "box 0 0 0  1 1 1\n" WATER "box %.17g 0 0  2 0.75 1\n",
             (double)(1 + 40 * real_epsilon));
    test_same("walls a hair apart", ABOVE GLASS "box 0 0 0  1 1 1\n" WATER "box 1 0 0  2 0.75 1\n",
              text);
}

static size_t contacts_of(const char *text)
{
    set q;
    effects_counts c = {.lost = 0};
    set_up(&q, text);
    for (int i = 0; i < 40 * 30; i++) {
        dice d = {.own = 0};
        ray r = camera_ray(q.e.eye, (real)(i % 40), (real)(i / 40), 40, 30);
        effects_alone(effects_made_for(q.e.mask), &q.e, r, (media_set){0}, &d, &c);
    }
    check_at_least(c.rays[RAY_REFRACTED], 500, "rays in glass");
    tear_down(&q);
    return c.contacts;
}

static void test_contacts(void)
{
    check_equal(contacts_of(ABOVE UNDER GLASS "sphere 0 1 0 0.5\nsphere 1.25 1 0 0.5\n"), 0,
                "contact rays of balls in the air");
    check_equal(contacts_of(ABOVE UNDER GLASS "sphere 0 1 0 0.25\nsphere 0 1 0 0.5\n"), 0,
                "of a ball in a ball");
    check_equal(contacts_of(ABOVE UNDER GLASS "box 0 0.1 0  1 1 1\n"), 0, "of a block in the air");
    check_equal(contacts_of(ABOVE UNDER GLASS "sphere 0 1.1 0 1\nmaterial chalk\nKd 0.5\n"
                            "box -0.6 0 -0.6  0.6 2 0.6  turn 0 1 0 45  move 1.24 0 1.24\n"), 0,
                "of a ball beside a turned block, whose bounds meet its own");
    check_at_most((double)contacts_of(ABOVE UNDER GLASS "sphere 0 1 0 1\n"), 6,
                  "of a ball on a table: at its foot");
    check_at_least((double)contacts_of(ABOVE UNDER GLASS "box 0 0 0  1 1 1\n"), 12,
                   "of a block on it");
}

/* In float this ray ends within rounding of the edge of a polygon that it skims, and meets it again
 * and again, in and out of the same body for ever: it is given up. (If not: SIGXCPU.) */
static void test_ends(void)
{
    set q;
    dice d = dice_start(1, 1, 0);
    effects_counts c = {.lost = 0};
    set_up(&q, "camera from 0 1 4 at 0 0.8 0 angle 45\nenvironment 0.4 0.5 0.6\n"
           "material m\nKd 0\nKs 0.3\nNi 1.75825\nTf 0.5\nillum 7\n"
           "polygon -9 -0.164628 9  9 -0.164628 9  9 -0.164628 -9  -9 -0.164628 -9\n");
    effects_stage_effects(&q.e, EFFECTS_EVERYTHING);
    for (size_t i = 0; i < check_count(20000); i++) {
        random_stream s = random_start(28, i, 0);
        real x = (real)some(&s, -9, 9), tilt = (real)some(&s, 0, 1e-3);
        vec3 o = {x, (real)-0.164628 + tilt * (real)some(&s, 0, 1), (real)some(&s, -9, -8)};
        ray r = ray_from(o, vunit(vec(0.37, -tilt, -0.93)));
        effects_alone(effects_general, &q.e, r, (media_set){0}, &d, &c);
    }
    check_at_least(c.rays[RAY_OF_EYE], check_count(20000), "rays");
    tear_down(&q);
}

/* A ray goes through 128 faces with one medium on both sides, and is given up at the next: small
 * balls in a large one of the same glass. */
static void test_many_faces(void)
{
    static const int balls[] = {0, 64, 65};
    for (int i = 0; i < 3; i++) {
        char text[8192];
        int n = snprintf(text, sizeof text, "camera from 0 0 99 at 0 0 0\nbackground 1\n"
                                            "material a\nKd 0\nillum 6\nsphere 0 0 0 96\n");
        for (int k = 0; k < balls[i]; k++)
            n += snprintf(text + n, sizeof text - (size_t)n, "sphere 0 0 %d 0.25\n", k);
        test_way(text, 99, balls[i] > 64 ? (double)INFINITY : 0);
    }
}

/* A white mirror, a smoothed octahedron under a white sky: at its outline the shading normal sends
 * rays below the surface. It is as white as the sky all the same. */
static void test_smoothed(void)
{
    enum { w = 40, h = 30 };
    char text[400];
    double worst = 0;
    set q;
    put("eight.obj", "v 1 0 0\nv 0 1 0\nv 0 0 1\nv -1 0 0\nv 0 -1 0\nv 0 0 -1\n"
        "f 1 2 3\nf 2 4 3\nf 4 5 3\nf 5 1 3\nf 2 1 6\nf 4 2 6\nf 5 4 6\nf 1 5 6\n");
    snprintf(text, sizeof text, "camera from 2 1.5 4 at 0 0 0 angle 32\nbackground 1\n"
             "material m\nKd 0\nKs 1\nillum 3\nobj %s smooth\n", in_directory("eight.obj"));
    set_up(&q, text);
    for (int i = 0; i < w * h; i++) {
        ray r = camera_ray(q.e.eye, (real)(i % w) + (real)0.5, (real)(i / w) + (real)0.5, w, h);
        worst = check_worse(worst, fabs((double)seen_along(&q, r).x - 1));
    }
    check_equal(worst, 0, "light that a white mirror swallows");
    tear_down(&q);
}

/* Glass whose refraction is left out keeps the share that it reflects: Schlick's, F0 = 0.04. */
static void test_left_out(void)
{
    set q;
    set_up(&q, "camera from 0 0 5 at 0 0 0\nbackground 1\nmaterial m\nNi 1.5\nKd 0.5\nTf 0.5\n"
           "illum 7\nsphere 0 0 0 1\n");
    effects_stage_effects(&q.e, q.p.effects & ~(unsigned)EFFECT_REFRACTION);
    check(q.e.mask == EFFECT_MIRROR, "%x", q.e.mask);
    for (int k = 0; k < 2; k++) {
        double cosine = k ? 0.5 : 1, R = 0.04 + 0.96 * pow(1 - cosine, 5);
        vec3 o = {k ? (real)sqrt(0.75) : 0, 0, 5};
        vec3 L = seen_along(&q, (ray){.o = o, .d = {0, 0, -1}, .tmin = 0, .tmax = real_infinity});
        check_close((double)L.x, 0.25 * (1 - R) * cosine + R, 64 * (double)real_epsilon,
                   "no refraction, cosine %g", cosine);
    }
    tear_down(&q);
    set_up(&q, "camera from 0 0 5 at 0 0 0\nbackground 1\nmaterial m\nKd 0.5\nKs 0.25\n"
           "illum 5\nsphere 0 0 0 1\n");  /* what is matte gets the rest */
    ray r = {.o = {(real)sqrt(0.75), 0, 5}, .d = {0, 0, -1}, .tmin = 0, .tmax = real_infinity};
    double F = 0.25 + 0.75 / 32;
    check_close((double)seen_along(&q, r).x, 0.5 * (1 - F) * 0.5 + F, 64 * (double)real_epsilon,
                "illum 5 at 60 degrees");
    tear_down(&q);
}

/* ---- light: closed forms ---- */

#define FLOOR "polygon -9 0 9  9 0 9  9 0 -9  -9 0 -9\n"

/* A closed ball that shines inwards: L = Le / (1 - albedo) everywhere, whichever way its radius has
 * it turned. A point light of intensity I in the middle of a closed matte ball: E = I / R^2 is the
 * same everywhere, and so is what its wall sends back, albedo E / pi, of which albedo times as much
 * comes from the second bounce, and so on: L = albedo / (1 - albedo) I / (pi R^2). A floor within a
 * wide shining sphere, and a matte ball in an even sky: L = albedo Le. Highlights (23.14), met head
 * on: as much as their Ks, whatever Ns, of a background that they show, too (the sun, behind them,
 * is there so that the eye brings no light). Under a small sphere of radius R at height h, radiance
 * Ke: E = pi Ke (R/h)^2 at its foot, L = kd E / pi. */
static void test_light(void)
{
    const double power = 10 / (double)pi / 4;
    /* Two lamps, found by shadow rays and by chance: the weights of both ways add up to 1. A square
     * that faces upwards, 2 above the floor, half side 1: 4 corners' form factors (a = b = 1/2);
     * and a sphere of radius R at distance 5, height 3: (R/5)^2 3/5. */
    const double a = 0.5, k = a / sqrt(1 + a * a), F = 4 / (double)pi * k * atan(k);
    const double L = 0.5 * (20 * F + 50 * 0.01 * 0.6);
    #define GREY_FLOOR "camera from 0 1.5 4 at 0 0 0\nmaterial floor\nKd 0.5\nillum 1\n" FLOOR
    #define TWO_LAMPS GREY_FLOOR "material lamp\nKe 20\npolygon -1 2 1  1 2 1  1 2 -1  -1 2 -1\n"  \
        "material ball\nKe 50\nsphere 4 3 0 0.5\n"
    /* Clear balls on the way, alone, or all within a larger one of the same: a ray that passes is
     * weighted as if nothing had been there, as a shadow ray does. */
    #define CLEAR "material clear\nKd 0\nNi 1\nillum 6\nsphere 0 0 0 1.5\nsphere 2 1.5 0 0.5\n"
    const unsigned paths = EFFECT_SOFT_SHADOWS | EFFECT_INDIRECT, through = EFFECT_REFRACTION;
    const struct { const char *what, *text; double exact[3]; unsigned mask; } list[] = {
        {"closed sphere", "camera from 0 0 0.5 at 0 0 3 up 0 1 0\nmaterial m\nKd 0.5 0.25 0.1\n"
         "Ke 1 2 3\nillum 1\nsphere 0 0 0 -2\n", {2, 2 / 0.75, 3 / 0.9}, 0},
        {"closed sphere, turned outwards", "camera from 0 0 0.5 at 0 0 3 up 0 1 0\nmaterial m\n"
         "Kd 0.5 0.25 0.1\nKe 1 2 3\nillum 1\nsphere 0 0 0 2\n", {2, 2 / 0.75, 3 / 0.9}, 0},
        {"a point light in a closed ball", "camera from 0 0.5 0.5 at 0 0 3\nmaterial m\n"
         "Kd 0.7 0.5 0.2\nillum 1\nsphere 0 0 0 -2\nlight at 0 0 0 colour 10\n",
         {power * 7 / 3, power, power / 4}, 0},
        {"a floor in a shining sphere", "camera from 0 2 5 at 0 0 0\nmaterial floor\nKd 0.7\n"
         "illum 1\n" FLOOR "material lamp\nKe 1 2 3\nsphere 0 0 0 50\n", {0.7, 1.4, 2.1}, 0},
        {"highlight under a shining sphere", "camera from 0 5 0 at 0 0 0 up 0 0 1\nmaterial m\n"
         "Kd 0\nKs 1 0.5 0.25\nNs 20\nillum 2\n" FLOOR "material lamp\nKe 1\nsphere 0 0 0 50\n",
         {1, 0.5, 0.25}, 0},
        {"a background, blurred", "camera from 0 5 0 at 0 0 0 up 0 0 1\nbackground 1\n"
         "sun to 0 -1 0 colour 1\nmaterial m\nKd 0\nKs 1 0.5 0.25\nNs 20\nillum 3\n" FLOOR,
         {1, 0.5, 0.25}, EFFECT_GLOSSY},
        {"ball in an even sky", "camera from 0 0 5 at 0 0 0\nenvironment 1\nmaterial m\n"
         "Kd 0.8 0.5 0.2\nillum 1\nsphere 0 0 0 1\n", {0.8, 0.5, 0.2}, 0},
        {"under a sphere", "camera from 1 3 1 at 0 0 0\nmaterial floor\nKd 0.5\nillum 1\n"
         FLOOR "material lamp\nKe 4\nsphere 0 4 0 1\n", {0.125, 0.125, 0.125}, 0},
        {"under two lamps", TWO_LAMPS, {L, L, L}, paths},
        {"through clear balls", TWO_LAMPS CLEAR, {L, L, L}, paths | through},
        {"within a clear ball", TWO_LAMPS CLEAR "sphere 0 0 0 60\n", {L, L, L}, paths | through},
        {"clear balls in an even sky", GREY_FLOOR CLEAR "environment 1\n", {0.5, 0.5, 0.5},
         EFFECT_ENVIRONMENT | EFFECT_INDIRECT | through}};
    for (size_t i = 0; i < sizeof list / sizeof *list; i++)
        expect(list[i].what, list[i].text, list[i].exact, 300, list[i].mask);
}

/* Highlights of an even sky, whatever their exponent: head on Ks (23.14); aslant, of an endless
 * one, (wo.h) zi = cos^2 of it (23.16), 5 / Ns off. A sky of even pixels is drawn otherwise. */
static void test_highlights(void)
{
    const char *const sky[] = {"1", "0.4 1.6", in_directory("even.pfm")};
    image even = image_new(8, 4);
    failure f;
    for (int k = 0; k < 32; k++) image_set(&even, k % 8, k / 8, (vec3){1, 1, 1});
    check(image_write(in_directory("even.pfm"), &even, &f), "%s", f.text);
    image_free(&even);
    for (int k = 0; k < 3; k++)
        for (int ns = k == 1 ? 9 : 0; ns <= 9; ns++) {  /* a narrow lobe sees one colour */
            char text[500];
            double L = k == 1 ? 1.6 : 1, most = k == 1 ? 1e-4 : 0;
            snprintf(text, sizeof text, "camera from 0 5 0 at 0 0 0 up 0 0 1\n"
                     "environment %s\nmaterial m\nKd 0\nKs 1 0.5 0.25\nNs 1e%d\nillum 2\n" FLOOR,
                     sky[k], ns);
            expect(text, text, (double[3]){L, L / 2, L / 4}, 300 + most / (double)real_epsilon, 0);
        }
    expect("a narrow highlight aslant", "camera from 0 4 3 at 0 0 0\nenvironment 1\nmaterial m\n"
           "Kd 0\nKs 1\nNs 1e9\nillum 2\n" FLOOR, (double[3]){0.64, 0.64, 0.64},
           300 + 1e-8 / (double)real_epsilon, 0);
}

/* A wide lamp of 300 corners, R = h = 2, straight above: n edges seen under an angle t each, in
 * planes whose normals are c = cos from the floor's: L = kd Ke n t c / (2 pi), by Lambert. */
static void test_round_lamp(void)
{
    enum { n = 300 };
    char text[300 + 50 * n];
    int size = sprintf(text, "camera from 0 1 3 at 0 0 0\nmaterial floor\nKd 0.5\nillum 1\n" FLOOR
                       "material lamp\nKe 4\npolygon");
    for (int k = 0; k < n; k++)
        size += sprintf(text + size, " %.17g 2 %.17g", 2 * cos(2 * (double)pi * k / n),
                        2 * sin(2 * (double)pi * k / n));
    double turn = 2 * (double)pi / n, t = acos((cos(turn) + 1) / 2), c = sin(turn) / 2 / sin(t);
    double L = 0.5 * 4 * n * t * c / (2 * (double)pi);
    expect("under a lamp of many corners", text, (double[3]){L, L, L}, 300, 0);
}

/* A ball of clear glass that shines, R 2, 3 above: each ray meets two faces, L = kd 2 Ke (R/h)^2.
 * Let into other glass both are hidden: they shine all the same, for shadow rays and for others. */
static void test_hidden_lamp(void)
{
    #define SHINING "camera from 4 1 0 at 0 0 0\nmaterial floor\nKd 0.5\nillum 1\n" FLOOR          \
        "material ball\nKd 0\nKe 9\nNi 1\nillum 6\nsphere 0 3 0 2\n"
    unsigned mask = EFFECT_SOFT_SHADOWS | EFFECT_INDIRECT | EFFECT_REFRACTION;
    expect("a shining ball of glass", SHINING, (double[3]){4, 4, 4}, 300, mask);
    expect("let into other glass", SHINING "material cup\nKd 0\nNi 1\nillum 6\npriority 1\n"
           "sphere 0 3 0 2.5\n", (double[3]){4, 4, 4}, 300, mask);
}

/* A mirror all round that shines: L = Ke + Ks L. By dice on the mean, as without integrals; where
 * it is cut, all but 1/512 of it; and black rays, which everything adds, don't stand in the way. */
static void test_deep(void)
{
    static const char text[] = "camera from 0 0 0 at 0.3 0.2 -1\nmaterial m\nillum 3\n"
                               "Ks 0.9 0.97 0.99\nKe 0.1 0.03 0.01\nsphere 0 0 0 2\n";
    set q;
    /* Of 500 rays behind one another: 200 throws are off by 0.2 %, and a cut at 128 takes 28 %. */
    expect_of(check_count(1600), "a shining mirror all round", text, (double[3]){1, 1, 1}, 300,
              EFFECTS_EVERYTHING);
    expect("by the plan alone", text, (double[3]){1, 1, 1}, 300, 0);
    set_up(&q, text);
    check(q.p.effects == EFFECT_MIRROR && !q.e.chance, "calls for %x", q.p.effects);
    vec3 L = seen_along(&q, camera_ray(q.e.eye, 10, 7, 20, 15));
    for (int k = 0; k < 3; k++) {
        check_at_least((double)vaxis(L, k), 1 - 1.0 / 512 - 1e3 * (double)real_epsilon, "cut");
        check_at_most((double)vaxis(L, k), 1 + 1e3 * (double)real_epsilon, "no more");
    }
    tear_down(&q);
}

/* Six plates of clear glass in an even sky of 1 are invisible, though light goes to and fro between
 * them in many weak branches, which may not be forgotten: a cut at 1/512 loses a hundredth. */
static void test_plates(void)
{
    char text[600];
    size_t n = 0;
    set q;
    double cut = 0;
    n += (size_t)sprintf(text, "camera from 0 1 6 at 0 1 0 angle 40\nbackground 1\nindirect off\n"
                         "material glass\nKd 0\nNi 1.5\nillum 7\n");
    for (int k = 0; k < 6; k++)
        n += (size_t)sprintf(text + n, "box -9 -9 %g  9 9 %g\n", -k / 2.0, 0.2 - k / 2.0);
    expect_of(check_count(3200), "six plates of glass", text, (double[3]){1, 1, 1}, 300, 0);
    set_up(&q, text);
    check(!q.e.chance, "no integrals in it");
    for (int i = 0; i < 300; i++) {
        ray r = camera_ray(q.e.eye, (real)(i % 20), (real)i / 20, 20, 15);
        cut += (double)seen_along(&q, r).x / 300;
    }
    check_at_most(cut, 0.99, "what is left of them where branches are cut");
    tear_down(&q);
}

/* How many of 600 samples differ, if no pairs are there to be asked for. */
static int without_pairs(const char *text, bool *chance)
{
    set q;
    int differ = 0;
    set_up(&q, text);
    *chance = q.e.chance;
    for (uint32_t i = 0; i < 600; i++) {
        vec3 L[2];
        ray r = camera_ray(q.e.eye, (real)(i % 20), (real)(i / 20 % 15), 20, 15);
        for (int k = 0; k < 2; k++) {
            dice_pixel of;
            effects_counts c = {.lost = 0};
            dice_pixel_of(1, i, k == 0, &of);
            dice d = dice_sample(&of, i / 300);
            L[k] = effects_alone(effects_made_for(q.e.mask), &q.e, r, (media_set){0}, &d, &c);
        }
        differ += memcmp(&L[0], &L[1], sizeof L[0]) != 0;
    }
    tear_down(&q);
    return differ;
}

/* Where nothing is an integral nobody asks for pairs: draw.h does not hash them. */
static void test_pairs_called_for(void)
{
#define PAIRS_ROOM "camera from 0 1 6 at 0 1 0 angle 40\nbackground .2\nindirect off\n" \
    "sun to 1 2 3 colour 2\nlight at 0 4 1 colour 20\n" \
    "material chrome\nKd .1\nKs .8\nillum 3\nsphere 1 1 0 .9\n" \
    "material glass\nKd 0\nNi 1.5\nillum 7\nsphere -1 1 0 .9\nbox -9 -9 -3  9 9 -2\n"
    bool chance;
    int differ = without_pairs(PAIRS_ROOM, &chance);
    check(!chance && differ == 0, "chrome and glass: %d samples ask for pairs", differ);
    differ = without_pairs(PAIRS_ROOM "material lamp\nKe 9\nsphere 0 4 0 .5\n"
                           "material matte\nKd .5\nsphere 0 0 0 .5\n", &chance);
    check(chance && differ > 5, "a lamp in it: %d samples ask for pairs", differ);
}

/* What a lobe shows of lamps of each kind and of the sky: by its rays alone, by shadow rays alone,
 * by both with weights. False alarms: 1e-7 each. */
static void test_ways(void)
{
    static const unsigned by[] = {EFFECT_GLOSSY, EFFECT_SOFT_SHADOWS | EFFECT_ENVIRONMENT,
                                  EFFECT_SOFT_SHADOWS | EFFECT_ENVIRONMENT | EFFECT_GLOSSY};
    set q;
    estimate e[3];
    set_up(&q, "camera from 0 2 4 at 0 0 0\nenvironment 0.5 1\nmaterial satin\nKd 0\nKs 0.5\n"
           "Ns 20\nillum 3\n" FLOOR "material lamp\nKe 3\n"
           "sphere -1.5 2.5 -3 0.6\npolygon 0.7 2 -4  1.7 2 -4  1.7 3 -4  0.7 3 -4\n"
           "polygon -1 1.2 -3  0 1.2 -3  -0.4 2.2 -3\n");
    for (int k = 0; k < 3; k++) {
        effects_stage_effects(&q.e, by[k]);
        e[k] = mean_along(&q, camera_ray(q.e.eye, 8, 6, 16, 12), 9 + (uint64_t)k,
                          check_count(20000));
        check_at_least(likely_alike(e[0], e[k]), 1e-7, "effects %x: %g, by rays alone %g", by[k],
                       e[k].mean, e[0].mean);
    }
    tear_down(&q);
}

/* Deep down each hit has its own numbers: no two purposes share one, nor the two of a pair. */
static void test_dice(void)
{
    enum { purposes = (int)dice_purposes, all = 3 * purposes };
    dice d = dice_start(27, 5, 0);
    size_t same = 0;
    for (uint32_t node = 1; node <= 64; node++) {
        real x[all];
        for (int k = 0; k < purposes; k++) {
            point2 u = dice_pair(&d, node, dice_depth + 1, (dice_purpose)k);
            x[3 * k] = u.u, x[3 * k + 1] = u.v;
            x[3 * k + 2] = dice_number(&d, node, (dice_purpose)k);
        }
        for (int i = 0; i < all; i++)
            for (int k = 0; k < i; k++) same += x[i] == x[k];
    }
    check_at_most((double)same, 2, "equal numbers: 18,000 pairs of 24 bits and more, each 2^-24");
}

int main(void)
{
    seconds_at_most(120);
    if (!mkdtemp(directory)) abort();
    test_classic(false);
    test_classic(true);
    test_touching(ABOVE UNDER BLOCKS);
    test_touching(ABOVE BLOCKS UNDER);
    test_paths(tax_room, EFFECT_SOFT_SHADOWS | EFFECT_INDIRECT | EFFECTS_WHITTED);
    char rough[2000];
    snprintf(rough, sizeof rough, "%smaterial frosted\nKd 0\nNi 1.5\nroughness 0.55\nillum 7\n"
             "absorb 1 0.2 0.5\nsphere -0.5 0.4 1 0.4\nbox 0.1 0.5 1.2  0.9 1.1 1.4\n", tax_room);
    test_paths(rough, EFFECT_SOFT_SHADOWS | EFFECT_INDIRECT | EFFECT_GLOSSY | EFFECTS_WHITTED);
    for (int k = 0; k < 2; k++) {  /* the eye in glass, smooth or rough; a bulb in a ball of it */
        snprintf(rough, sizeof rough, "%smaterial bulb\nKe 4 5 6\nsphere 0.45 0.45 0.5 0.2\n"
                 "material eye\nKd 0\nNi 1.5\nroughness %g\nillum 7\nsphere 0 1 3.4 0.55\n",
                 tax_room, 0.6 * k);
        test_paths(rough, EFFECT_SOFT_SHADOWS | EFFECT_INDIRECT | EFFECTS_WHITTED
                              | (k ? EFFECT_GLOSSY : 0));
    }
    int failed = check_all("27_radiance", test_special, test_dice, test_bodies, test_blocks,
                           test_contacts, test_ends, test_many_faces, test_smoothed, test_left_out,
                           test_light, test_highlights, test_deep, test_plates,
                           test_pairs_called_for, test_round_lamp, test_hidden_lamp, test_ways);
    remove_directory();
    return failed;
}
