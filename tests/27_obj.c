/* Tests of chapter 27: 26 and 27 see the same light in one OBJ file. A room of matte walls, open in
 * front, under a lamp; a mirror with Fresnel's share (illum 5); an octahedron of tinted glass that
 * absorbs (illum 7), and in it a lamp and a plate. Each program reads the file by its own reader;
 * mirror and glass, of which 26 reads Kd and Ke alone, are 27's materials, drawn by 26's path. */
#include "27_seen.h"
#include "../chapters/26_path_tracer/files/obj_materials.h"

enum { blocks_across = 4, blocks_down = 3, blocks = blocks_across * blocks_down };
typedef struct { estimate e[3]; } block_light;

static const char room_mtl[] =
    "newmtl white\nKd 0.75 0.7 0.65\nillum 1\nnewmtl red\nKd 0.6 0.1 0.08\n"
    "newmtl green\nKd 0.12 0.45 0.15\nnewmtl lamp\nKe 3 2.6 2\nnewmtl bulb\nKe 0.5 1 2\n"
    "newmtl chrome\nKd 0\nKs 0.5 0.3 0.1\nillum 5\n"
    "newmtl glass\nKd 0\nNi 1.5\nTf 0.7 1 0.5\nabsorb 0.5 0.2 0.8\nillum 7\n";

/* Four corners a wall, three a piece of what is in the glass; its own corners come last. */
static const char room_walls[] =
    "mtllib room.mtl\n"
    "v -1 0 1\nv 1 0 1\nv 1 0 -1\nv -1 0 -1\nv -1 2 1\nv 1 2 1\nv 1 2 -1\nv -1 2 -1\n"
    "usemtl white\nf 1 2 3 4\nf 5 8 7 6\nf 4 3 7 8\nusemtl red\nf 1 4 8 5\n"
    "usemtl green\nf 2 6 7 3\n"
    "v -0.8 1.95 -0.8\nv 0.8 1.95 -0.8\nv 0.8 1.95 0.8\nv -0.8 1.95 0.8\n"
    "usemtl lamp\nf 9 10 11 12\n"
    "v -0.95 0.2 0.5\nv -0.3 0.2 -0.9\nv -0.3 1.5 -0.9\nv -0.95 1.5 0.5\n"
    "usemtl chrome\nf 13 14 15 16\n"
    "v 0.3 0.5 0.3\nv 0.5 0.5 0.2\nv 0.4 0.7 0.25\n"
    "v 0.3 0.8 0.3\nv 0.55 0.8 0.25\nv 0.4 0.95 0.2\n"
    "usemtl bulb\nf 17 18 19\nusemtl white\nf 20 21 22\nusemtl glass\n"
    "v 0.95 0.7 0.2\nv -0.15 0.7 0.2\nv 0.4 1.3 0.2\n"
    "v 0.4 0.1 0.2\nv 0.4 0.7 0.8\nv 0.4 0.7 -0.4\n";

static void put_room(void)
{
    char text[2000];
    int n = snprintf(text, sizeof text, "%s", room_walls);
    for (int k = 0; k < 8; k++) {  /* its faces, outwards */
        int x = 23 + (k & 1), y = 25 + (k >> 1 & 1), z = 27 + (k >> 2);
        bool even = ((k & 1) + (k >> 1 & 1) + (k >> 2)) % 2 == 0;
        n += snprintf(text + n, sizeof text - (size_t)n, "f %d %d %d\n", x, even ? y : z,
                      even ? z : y);
    }
    put("room.obj", text), put("room.mtl", room_mtl);
    put("room.scene", "indirect on\nobj room.obj\n");
}

/* As 26 has it; `of`: as 27 read it. */
static void room_of_26(const studio *of, lit_scene *s)
{
    mesh m;
    failure f;
    uint64_t libraries;
    lit_begin(s);
    uint16_t grey = lit_add_material(s, (material){.shine = 1});
    if (!obj_read(in_directory("room.obj"), &m, &f)) fail(f);
    lit_add_mesh(s, &m, grey);
    if (!obj_materials(&m, in_directory("room.obj"), grey, s, &libraries, &f)) fail(f);
    for (size_t i = 0; i < m.triangles; i++) {
        uint32_t k = studio_material_of(of, 0, (uint32_t)i);
        material own = appearance_of(&of->material[k]).m;
        if (!vzero(own.mirror)) s->material[s->of_triangle[i]] = own;
    }
    mesh_free(&m);
    lit_end(s);
}

static ray block_ray(int block, uint64_t seed, uint64_t k)
{
    camera c = camera_at(vec(0.1, 1.05, 4.4), vec(0, 1, 0), (vec3){0, 1, 0}, 30, 4 / (real)3);
    random_stream r = random_start(seed, (uint64_t)block, k);
    real x = (real)(block % blocks_across) + random_next(&r);
    return camera_ray(c, x, (real)(block / blocks_across) + random_next(&r), blocks_across,
                      blocks_down);
}

static void block_add(block_light *b, vec3 L)
{
    for (int k = 0; k < 3; k++) b->e[k] = estimate_add(b->e[k], (double)vaxis(L, k));
}

static block_light block_by_26(const path_tracer *t, int block, size_t n)
{
    block_light b = {{{0}}};
    path_counts c = {0};
    for (size_t k = 0; k < n; k++) {
        path_random own = path_start(&t->how, 62, (uint64_t)block, (uint32_t)k, 1);
        block_add(&b, path_radiance(t, block_ray(block, 61, k), &own, &c));
    }
    return b;
}

static block_light block_by_27(const effects_stage *e, int block, size_t n)
{
    block_light b = {{{0}}};
    effects_function *f = effects_made_for(e->mask);
    effects_counts c = {.lost = 0};
    for (size_t k = 0; k < n; k++) {
        dice d = dice_start(72, (uint64_t)block * n + k, 0);
        block_add(&b, effects_alone(f, e, block_ray(block, 71, k), (media_set){0}, &d, &c));
    }
    check_equal(c.lost, 0, "bodies lost");
    return b;
}

/* Block by block and colour by colour, by numbers of their own; and in all, where noise is least.
 * 39 comparisons; each alarms falsely once in 1e8 seeds. */
int main(void)
{
    static const double false_alarm = 1e-8;
    set q;
    lit_scene lit;
    path_tracer t;
    path_options how = path_defaults;
    failure f;
    block_light all[2] = {{{{0}}}};
    how.sequence = SEQUENCE_RANDOM;
    check(mkdtemp(directory), "a directory");
    put_room();
    if (!read_scene("room.scene", &q.s, &f)) fail(f);
    if (!effects_get_ready(&q, 4 / (real)3, &f)) fail(f);
    room_of_26(&q.s, &lit), path_tracer_of(&lit, NULL, how, &t);
    for (int i = 0; i < blocks; i++) {
        size_t n = check_sample(256000, 32000);
        block_light a = block_by_26(&t, i, n), b = block_by_27(&q.e, i, n);
        for (int k = 0; k < 3; k++) {
            check_at_least(welch_test(a.e[k], b.e[k]), false_alarm,
                           "block %d, channel %d: %g by 26, %g by 27", i, k, a.e[k].mean,
                           b.e[k].mean);
            all[0].e[k] = estimate_merge(all[0].e[k], a.e[k]);
            all[1].e[k] = estimate_merge(all[1].e[k], b.e[k]);
        }
    }
    for (int k = 0; k < 3; k++) {
        const estimate *a = &all[0].e[k], *b = &all[1].e[k];
        double error = hypot(estimate_error(*a), estimate_error(*b));
        check_at_least(welch_test(*a, *b), false_alarm, "channel %d: %g by 26, %g by 27", k,
                       a->mean, b->mean);
        check_at_most(error, 0.006 * a->mean, "channel %d: the noise of both", k);
    }
    path_tracer_free(&t), lit_free(&lit), tear_down(&q);
    remove_directory();
    return check_report("27_obj");
}
