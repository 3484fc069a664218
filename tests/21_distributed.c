/* 21_distributed: pictures: Whitted's is the special case without any extent; no ray and no random
 * number but what is called for; all effects at once against a sum of closed forms; the Cornell
 * box; the program from outside. */
#include "check.h"
#include "../chapters/21_distributed/lab/balls.h"
#include "../chapters/21_distributed/lab/box.h"
#include "21_known.h"
#include "../chapters/21_distributed/lab/showroom.h"

#include "program.h"

enum { w = 40, h = 30 };

static distributed_counts draw_look(const showroom_look *k, uint32_t samples, sequence_kind kind,
                                    int threads, image *im)
{
    distributed_view v = showroom_view(k, SHOWROOM_ALL, (real)w / h);
    v.samples = samples, v.kind = kind, v.seed = 3;
    check(distributed_draw(&v, im, threads), "drawn");
    return v.spent;
}

static size_t different(const image *a, const image *b)
{
    size_t n = 0;
    for (int i = 0; i < w * h; i++) n += memcmp(a->rgb + 3 * i, b->rgb + 3 * i, 12) != 0;
    return n;
}

/* ---- Whitted ---- */

/* The showroom's materials; nothing reflects. */
static material matte(const void *context, trace_hit x, const surface *s)
{
    material m = showroom_material(context, x, s);
    m.ks = (vec3){0, 0, 0};
    return m;
}

/* No size, no lobe, no lens, an even sky: chapter 18's picture, to the last bit. */
static void test_is_18(void)
{
    showroom *g = showroom_new(4);
    showroom_look k;
    showroom_set(&k, g, 0);
    area_light point[2] = {{AREA_BALL, k.light[0].at, .colour = k.light[0].colour}, k.light[1]};
    k.how.light = point, k.how.material_of = matte;
    light lights[2];
    for (int i = 0; i < 2; i++) lights[i] = (light){LIGHT_POINT, point[i].at, point[i].colour};
    shading how = {.lights = lights, .n = 2, .material_of = matte, .context = &k,
                   .background = k.how.background, .ambient = k.how.ambient};
    tracer t = {.w = &k.w, .program = shade_programs, .user = &how};
    distributor d = distributor_of(&k.w, &k.how);
    distributed_view v = showroom_view(&k, SHOWROOM_ALL, 1);
    size_t differ = 0;
    for (int i = 0; i < w * w; i++) {
        distributed_sample q = {SEQUENCE_RANDOM, 1, (uint64_t)i, 0, 1};
        ray r = camera_ray(v.c, (real)(i % w), (real)(i / w), w, w);
        vec3 a = distributed_ray(&d, r, q), b = shade_ray(&t, r);
        differ += memcmp(&a, &b, sizeof a) != 0;
    }
    check_equal(differ, 0, "colours that differ from chapter 18's");
    for (int kind = 0; kind < ray_kinds; kind++)
        check_equal(d.t.counts.rays[kind], t.counts.rays[kind], "rays: %s", ray_kind_names[kind]);
    for (int i = 0; i < drawn_kinds; i++) check_equal(d.drawn[i], 0, "no random number");
    /* a picture of one sample a pixel: through the middle of each */
    image one = image_new(w, w);
    v.samples = 1, differ = 0;
    distributed_draw(&v, &one, 2);
    for (int i = 0; i < w * w; i++) {
        vec3 b = shade_ray(&t, camera_ray(v.c, (real)(i % w) + (real)0.5, (real)(i / w) + (real)0.5,
                                          w, w));
        float pixel[3] = {(float)b.x, (float)b.y, (float)b.z};
        differ += memcmp(pixel, one.rgb + 3 * i, sizeof pixel) != 0;
    }
    check_equal(differ, 0, "pixels that differ from chapter 18's");
    image_free(&one), showroom_free(g);
}

/* ---- only what is called for ---- */

/* Each of the 16 combinations: what is off draws nothing; all spent, the picture stays. */
static void test_spending(void)
{
    showroom *g = showroom_new(3);
    image a = image_new(w, h), b = image_new(w, h);
    for (int effects = 0; effects < 16; effects++) {
        showroom_look k;
        showroom_set(&k, g, effects);
        sequence_kind kind = effects % 3 == 0 ? SEQUENCE_SOBOL
                           : effects % 3 == 1 ? SEQUENCE_RANDOM : SEQUENCE_JITTERED;
        distributed_counts few = draw_look(&k, 3, kind, 1, &a);
        k.how.spend_all = true;
        distributed_counts all = draw_look(&k, 3, kind, 2, &b);
        size_t pixels = 3 * w * h;
        check_equal(different(&a, &b), 0, "effects %d: the same picture if all is spent", effects);
        check_equal(few.drawn[DRAWN_LENS], effects & LOOK_LENS ? pixels : 0, "lens %d", effects);
        check_equal(few.drawn[DRAWN_FILM], pixels, "film");
        check(!few.drawn[DRAWN_LIGHT] == !(effects & LOOK_SOFT), "light numbers, %d", effects);
        check(!few.drawn[DRAWN_LOBE] == !(effects & LOOK_GLOSSY), "lobe numbers, %d", effects);
        check(!few.drawn[DRAWN_SKY] == !(effects & LOOK_SKY), "sky numbers, %d", effects);
        check(!few.rays.rays[RAY_SIGHT] == !(effects & LOOK_SKY), "sky rays, %d", effects);
        check_equal(few.rays.rays[RAY_CAMERA], pixels, "camera rays");
        check(all.drawn[DRAWN_LENS] && all.drawn[DRAWN_LIGHT] && all.drawn[DRAWN_LOBE]
              && all.drawn[DRAWN_SKY], "all drawn");
        check(all.rays.rays[RAY_SHADOW] > few.rays.rays[RAY_SHADOW], "more shadow rays");
        check(all.rays.rays[RAY_SIGHT] > few.rays.rays[RAY_SIGHT] || effects & LOOK_SKY,
            "more sky rays");
    }
    image_free(&a), image_free(&b), showroom_free(g);
}

/* Black or out of reach: exactly none of that kind. And another seed is another picture. */
static void test_none(void)
{
    showroom *g = showroom_new(3);
    image a = image_new(w, h), b = image_new(w, h);
    showroom_look k;
    showroom_set(&k, g, LOOK_ALL);
    distributed_counts full = draw_look(&k, 2, SEQUENCE_SOBOL, 2, &a);
    k.light[0].colour = k.light[1].colour = (vec3){0, 0, 0};
    distributed_counts dark = draw_look(&k, 2, SEQUENCE_SOBOL, 2, &b);
    check_equal(dark.rays.rays[RAY_SHADOW], 0, "black lights");
    check_equal(dark.drawn[DRAWN_LIGHT], 0, "and no number for them");
    showroom_set(&k, g, LOOK_ALL), k.how.n = 0;
    check_equal(draw_look(&k, 2, SEQUENCE_SOBOL, 2, &b).rays.rays[RAY_SHADOW], 0, "no light");
    showroom_set(&k, g, LOOK_ALL), k.how.ambient = (vec3){0, 0, 0};
    check_equal(draw_look(&k, 2, SEQUENCE_SOBOL, 2, &b).rays.rays[RAY_SIGHT], 0, "a black sky");
    showroom_set(&k, g, LOOK_ALL), k.how.material_of = matte;
    check_equal(draw_look(&k, 2, SEQUENCE_SOBOL, 2, &b).rays.rays[RAY_REFLECTION], 0, "ks black");
    showroom_set(&k, g, LOOK_ALL), k.how.depth = 1;
    check_equal(draw_look(&k, 2, SEQUENCE_SOBOL, 2, &b).rays.rays[RAY_REFLECTION], 0, "depth 1");
    showroom_set(&k, g, LOOK_ALL);
    for (int i = 0; i < 2; i++) k.light[i].at.z = -20, k.light[i].n.z = -1;
    check_at_most(draw_look(&k, 2, SEQUENCE_SOBOL, 2, &b).rays.rays[RAY_SHADOW],
                  full.rays.rays[RAY_SHADOW] / 4, "lights under the floor: only undersides ask");
    showroom_set(&k, g, LOOK_ALL);
    distributed_view v = showroom_view(&k, SHOWROOM_ALL, (real)w / h);
    v.samples = 2, v.seed = 4;
    check(distributed_draw(&v, &b, 2) && different(&a, &b) > w * h / 2, "another seed");
    image_free(&a), image_free(&b), showroom_free(g);
}

/* No two domains of a chain have the same pair: 3 lights, the sky and the lobe. */
static void test_pairs(void)
{
    check_equal(distributed_pairs_a_hit(&(distributed){.n = 3}), 5, "a pair each");
    check(PAIR_FILM < PAIR_LENS && PAIR_LENS < PAIR_HIT, "and film and lens");
}

/* ---- against closed forms ---- */

typedef struct {
    material floor;
    vec3 corner[8];
    shape shapes[2];
    scene s;
    world_part part;
    trace_world world;
} furnace;

static material furnace_material(const void *context, trace_hit x, const surface *s)
{
    (void)x, (void)s;
    return ((const furnace *)context)->floor;
}

/* A floor; wall: NULL, or the corners of what stands on it. */
static furnace *furnace_new(vec3 kd, vec3 ks, real shine, const vec3 *wall)
{
    furnace *f = allocate(1, sizeof *f);
    f->floor = (material){.kd = kd, .ks = ks, .shine = shine};
    for (int k = 0; k < 4; k++) {
        f->corner[k] = (vec3){k == 0 || k == 3 ? -100 : 100, k < 2 ? -100 : 100, 0};
        if (wall) f->corner[4 + k] = wall[k];
    }
    f->s = (scene){f->shapes, wall ? 2 : 1};
    for (size_t i = 0; i < f->s.n; i++)
        f->shapes[i] = shape_of_polygon(polygon_of(f->corner + 4 * i, 4));
    world_part_of_scene(&f->s, MASK_ALL, &f->part);
    f->world = (trace_world){&f->part, 1};
    return f;
}

static void furnace_free(furnace *f) { world_part_free(&f->part), free(f); }

/* Everything by one chain: kd/pi E + kd La open + ks (what of the lobe is above) B. A ray at 60
 * degrees; a cosine lobe, so 3/4 are above; the rectangle of (21.12). */
static void test_sum(void)
{
    vec3 kd = {0.5, 0.25, 0.125}, ks = {0.25, 0.5, 0.75};
    furnace *f = furnace_new(kd, ks, 1, NULL);
    known k;
    known_make(KNOWN_SQUARE, &k);
    distributed how = {.light = &k.light, .n = 1, .material_of = furnace_material, .context = f,
                       .background = {2, 2, 2}, .ambient = {1, 1, 1}, .reach = 10, .depth = 3};
    ray r = ray_from((vec3){-sqrt((real)3), 0, 1}, (vec3){sqrt((real)3), 0, -1});
    uint32_t n = (uint32_t)check_count(20000);
    for (int kind = 0; kind < 2; kind++) {
        distributor d = distributor_of(&f->world, &how);
        estimate e[3] = {{0}, {0}, {0}};
        for (uint32_t i = 0; i < (kind ? check_count(200) : n); i++) {
            vec3 sum = {0, 0, 0};
            uint32_t m = kind ? 64 : 1;
            for (uint32_t j = 0; j < m; j++) {
                distributed_sample q = {kind ? SEQUENCE_SOBOL : SEQUENCE_RANDOM, 5, i, j, m};
                sum = vmadd(sum, distributed_ray(&d, r, q), 1 / (real)m);
            }
            for (int c = 0; c < 3; c++) e[c] = estimate_add(e[c], (double)vaxis(sum, c));
        }
        for (int c = 0; c < 3; c++) {
            double truth = (double)vaxis(kd, c) * (k.truth / (double)pi + 1)
                         + (double)vaxis(ks, c) * 0.75 * 2;
            check_at_least(t_test(e[c], truth, 1e-6 + 64 * (double)real_epsilon), 1e-6,
                           "all effects by one chain, false-alarm rate 1e-6");
        }
        double sent = (double)d.t.counts.rays[RAY_REFLECTION];
        check_at_most(sent, 0.9 * (double)d.t.counts.rays[RAY_CAMERA], "a quarter is below");
    }
    known_free(&k), furnace_free(f);
}

/* A convex white body in an even sky is as bright as the sky, by diffuse light, by mirror, and by a
 * lobe that is all above: exactly, with no noise. */
static void test_furnace(void)
{
    const real shines[3] = {real_infinity, 5, 1};
    for (int i = 0; i < 3; i++) {
        vec3 white = {1, 1, 1}, black = {0, 0, 0};
        furnace *f = furnace_new(i == 1 ? black : vscale(white, 0.5),
                                 i == 1 ? white : vscale(white, 0.5), shines[i], NULL);
        distributed how = {.n = 0, .material_of = furnace_material, .context = f,
                           .background = white, .ambient = white, .reach = real_infinity,
                           .depth = 2};
        distributor d = distributor_of(&f->world, &how);
        ray r = ray_from((vec3){0, 0, 1}, (vec3){0, 0, -1});
        size_t off = 0;
        for (uint32_t j = 0; j < 200; j++) {
            vec3 c = distributed_ray(&d, r, (distributed_sample){SEQUENCE_SOBOL, 6, 0, j, 200});
            off += c.x != 1 || c.y != 1 || c.z != 1;
        }
        check_equal(off, 0, "as bright as the sky, shine %g", (double)shines[i]);
        furnace_free(f);
    }
}

/* Red: a light; green: the sky; blue: what the lobe sees. A wall hides part of each. They take
 * different numbers: no correlation beyond 5 / sqrt(n), five standard deviations. */
static void test_independent(void)
{
    vec3 wall[4] = {{0.6, -9, 0}, {0.6, 9, 0}, {0.6, 9, 2}, {0.6, -9, 2}};
    furnace *f = furnace_new((vec3){1, 1, 0}, (vec3){0, 0, 1}, 1, wall);
    known k;
    known_make(KNOWN_SQUARE, &k);
    k.light.colour = (vec3){1, 0, 0};
    distributed how = {.light = &k.light, .n = 1, .material_of = furnace_material, .context = f,
                       .background = {0, 0, 1}, .ambient = {0, 1, 0}, .reach = real_infinity,
                       .depth = 2};
    distributor d = distributor_of(&f->world, &how);
    uint32_t n = (uint32_t)check_count(4000);
    double sum[3] = {0}, product[3][3] = {{0}};
    for (uint32_t i = 0; i < n; i++) {
        vec3 c = distributed_ray(&d, ray_from((vec3){0, 0, 1}, (vec3){0, 0, -1}),
                                 (distributed_sample){SEQUENCE_RANDOM, 16, i, 0, 1});
        for (int a = 0; a < 3; a++) {
            sum[a] += (double)vaxis(c, a);
            for (int b = 0; b < 3; b++)
                product[a][b] += (double)vaxis(c, a) * (double)vaxis(c, b);
        }
    }
    for (int a = 0; a < 3; a++)
        for (int b = 0; b < 3; b++)
            product[a][b] = product[a][b] / n - sum[a] / n * (sum[b] / n);
    for (int a = 0; a < 3; a++) {
        int b = (a + 1) % 3;
        check(product[a][a] > 0, "colour %d varies", a);
        check_at_most(fabs(product[a][b]) / sqrt(product[a][a] * product[b][b]),
                      5 / sqrt((double)n), "correlation of colours %d and %d", a, b);
    }
    known_free(&k), furnace_free(f);
}

/* Where a chain between two glossy sheets was, by its calls for a material. */
typedef struct { vec3 p[3]; int n; } chain;

static material chain_material(const void *context, trace_hit x, const surface *s)
{
    chain *c = *(chain *const *)context;
    (void)x;
    if (c->n < 3) c->p[c->n] = s->p;
    c->n++;
    return (material){.ks = {1, 1, 1}, .shine = 20};
}

/* The second lobe takes other numbers than the first: otherwise both rays would stand at the same
 * angle to their axes. */
static void test_chain(void)
{
    vec3 lid[4] = {{-100, -100, 1}, {100, -100, 1}, {100, 100, 1}, {-100, 100, 1}};
    furnace *f = furnace_new((vec3){0, 0, 0}, (vec3){1, 1, 1}, 1, lid);
    chain c, *at = &c;
    distributed how = {.n = 0, .material_of = chain_material, .context = &at, .depth = 3};
    distributor d = distributor_of(&f->world, &how);
    size_t asked = 0, alike = 0;
    for (uint32_t i = 0; i < 500; i++) {
        c.n = 0;
        distributed_ray(&d, ray_from(vec(0, 0, 0.5), (vec3){0, 0, -1}),
                        (distributed_sample){SEQUENCE_RANDOM, 13, i, 0, 1});
        if (c.n < 3) continue;
        vec3 w1 = vunit(vsub(c.p[1], c.p[0])), w2 = vunit(vsub(c.p[2], c.p[1]));
        real z1 = w1.z, z2 = vdot(w2, (vec3){w1.x, w1.y, -w1.z});
        asked++, alike += fabs(z1 - z2) < (real)1e-4;
    }
    check_at_least(asked, 100, "chains of three");
    check_at_most(alike, asked / 10, "lobes with the same numbers");
    furnace_free(f);
}

/* ---- the Cornell box ---- */

static void test_cornell(void)
{
    mesh m = cornell_mesh();
    vec3 centre = {278, 274, 280}, s = cornell_side_s, t = cornell_side_t;
    size_t inwards = 0, lights = 0;
    real A = 0;
    for (size_t i = 0; i < m.triangles; i++) {
        triangle tri = mesh_triangle(&m, i);
        bool shines = cornell_of(i) == CORNELL_LIGHT, room = i < 18;
        vec3 n = triangle_normal(tri);
        vec3 middle = vscale(vadd(vadd(tri.a, tri.b), tri.c), (real)1 / 3);
        inwards += !room || vdot(n, vsub(centre, middle)) > 0;
        if (shines) A += vlength(vcross(vsub(tri.b, tri.a), vsub(tri.c, tri.a))) / 2, lights++;
    }
    check_equal(m.triangles, 38, "triangles");
    check_equal(inwards, 38, "walls face the room");
    check_equal(lights, 2, "of the light");
    check_close((double)A, 105 * 130, 1e5 * (double)real_epsilon, "its area");
    check(vcross(s, t).y < 0, "the light shines down");
    mesh_free(&m);
}

/* A point of the floor that sees all of the light: E = pi L F, without and with a size; and the
 * ceiling, which no light reaches: black, by no shadow ray. */
static void test_box(void)
{
    vec3 black = {0, 0, 0};
    distributed_box *b = box_new(true, black, 0);
    distributor d = distributor_of(&b->w, &b->how);
    estimate e = {0};
    ray down = ray_from((vec3){450, 100, 100}, (vec3){0, -100, 0});
    double H = 548.8, x0 = (213 - 450) / H, x1 = (343 - 450) / H, y0 = 127 / H, y1 = 232 / H;
    for (uint64_t i = 0; i < check_count(4000); i++)
        e = estimate_add(e, (double)distributed_ray(&d, down, (distributed_sample){
                                SEQUENCE_RANDOM, 7, i, 0, 1}).x);
    double truth = 0.725 * 17 * known_rectangle(x0, x1, y0, y1);
    check_at_least(t_test(e, truth, 64 * truth * (double)real_epsilon), 1e-6,
                   "light on the floor, false-alarm rate 1e-6");
    check_equal(d.t.counts.hits[RAY_SHADOW], 0, "seen past the blocks");
    ray up = ray_from((vec3){100, 400, 100}, (vec3){3, 148, 5});
    size_t before = d.t.counts.rays[RAY_SHADOW];
    vec3 c = distributed_ray(&d, up, (distributed_sample){SEQUENCE_RANDOM, 7, 0, 0, 1});
    check(vzero(c), "the ceiling is black");
    check_equal(d.t.counts.rays[RAY_SHADOW], before, "and asks for no shadow ray");
    ray lamp = ray_from((vec3){278, 400, 280}, (vec3){0, 1, 0});
    c = distributed_ray(&d, lamp, (distributed_sample){SEQUENCE_RANDOM, 7, 0, 0, 1});
    check_close((double)c.x, 17, 1e-4, "the light itself");
    /* shadow: behind the tall block, where the light is hidden altogether */
    ray behind = ray_from((vec3){400, 20, 500}, (vec3){0, -20, 0});
    c = distributed_ray(&d, behind, (distributed_sample){SEQUENCE_RANDOM, 7, 0, 0, 1});
    check(vzero(c), "umbra");
    box_free(b);
}

/* Directions about a shading normal that leans by 53 degrees: some lead below the surface. They are
 * closed, and no ray is called for; all others are open here. */
static void test_ambient_below(void)
{
    surface s = {{0, 0, 0}, {0, 0, 1}, vec(0.8, 0, 0.6), 0, 0, no_shape};
    size_t n = check_count(20000), below = 0, wrong = 0;
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(71, i, 0);
        real u = random_next(&g), v = random_next(&g);
        ray r;
        bool open = ambient_ray(s, (point2){u, v}, 1, &r);
        below += !(r.d.z > 0), wrong += open != (r.d.z > 0);
    }
    check_equal(wrong, 0, "open below the surface, or closed above it");
    check_close((double)below / (double)n, 0.2, 6 * 0.4 / sqrt((double)n), "(1 - cos) / 2");
}

/* ---- first.h ---- */

/* One sample of each of the picture's pixels, through their middles, by both versions, their random
 * numbers independent: the difference is 0 in the mean over all, and in each pixel. The chrome is
 * so rough that much of its lobe leads below the surface: both lose that. False alarms: 1e-6 a
 * picture, and 1e-6 among its pixels. Rounding: both add numbers below 2; and of shadows first.h
 * loses what is within eps = 1e-4 of the way, nothing among these balls. */
static void test_first(void)
{
    enum { across = 16, down = 12, pixels = across * down };
    const double rounding = 256 * (double)real_epsilon;
    for (int chrome = 0; chrome < 2; chrome++) {
        distributed_balls *b = balls_new(chrome);
        for (int i = 0; i < b->first.things; i++)
            if (!vzero(b->first.thing[i].m.mirror)) b->first.thing[i].m.shine = 3;
        distributed_view v = balls_view(b, (real)across / down);
        distributor d = distributor_of(&b->w, &b->how);
        estimate all = {0}, each[pixels] = {{0}};
        double least = 1, bright = 0;
        for (uint32_t k = 0; k < check_count(2000); k++) {
            double sum = 0;
            for (int i = 0; i < pixels; i++) {
                int x = i % across, y = i / across;
                random_stream random = random_start(17, (uint64_t)i, k);
                distributed_sample q = {SEQUENCE_RANDOM, 18, (uint64_t)i, k, 1};
                ray r = camera_ray(v.c, (real)x + (real)0.5, (real)y + (real)0.5, across, down);
                double L = (double)balls_first(b, x, y, across, down, 0, 1, &random).y;
                double off = L - (double)distributed_ray(&d, r, q).y;
                each[i] = estimate_add(each[i], off), sum += off, bright += L;
            }
            all = estimate_add(all, sum / pixels);
        }
        for (int i = 0; i < pixels; i++) least = fmin(least, t_test(each[i], 0, rounding));
        check_at_least(t_test(all, 0, rounding), 1e-6, "first.h and distributed.h, chrome %d: "
                       "%g -+ %g", chrome, all.mean, estimate_error(all));
        check_at_least(least, 1e-6 / pixels, "and in each pixel, least p");
        check_at_least(bright / pixels / (double)all.n, 0.2, "there is light");
        balls_free(b);
    }
}

/* ---- the program ---- */

static void test_program(void)
{
    check(mkdtemp(directory) != NULL, "a directory");
    check_equal(run("21_distributed", "--effects sgolx"), 2, "unknown effect behind all");
    check_equal(run("21_distributed", "--effects sx"), 2, "unknown effect");
    check(printed("err", "--effects sx"), "says which");
    check_equal(run("21_distributed", "--quick --size 24x16 --effects so --out @a.pfm"), 0,
                "two effects");
    check_equal(run("21_distributed", "--quick --size 24x16 --effects so --threads 3 --out @b.pfm"),
                0, "by three threads");
    check(equal_files("a.pfm", "b.pfm"), "the same picture");
    remove_directory();
}

int main(void)
{
    return check_all("21_distributed", test_ambient_below, test_is_18, test_spending, test_none,
                     test_pairs, test_sum, test_furnace, test_independent,
                     test_chain, test_cornell, test_box, test_first, test_program);
}
