/* Rays side by side (packet.h) against brute force, in every dialect that the machine has: rows of
 * rays, of which each leaves out some triangles, on small meshes that are made to break the bounds;
 * where doubt ends; which triangles make a patch. */
#include "../chapters/15_wide_bvh/bvh8.h"
#include "structure.h"

enum { row_most = 64 };
static const char *const row_dialect[eight_dialects] = {"plain C", "AVX2", "AVX-512"};

/* ---- meshes of at most bvh8_few triangles */

static void row_quad(mesh *m, size_t i, vec3 a, vec3 b, vec3 c, vec3 d)
{
    set_triangle(m, i, a, b, c), set_triangle(m, i + 1, a, c, d);
}

/* Boxes that stand in each other: 12 triangles each. turn: of all corners, about z. */
static mesh row_boxes(size_t n, real turn)
{
    mesh m = mesh_room(12 * n);
    for (size_t i = 0; i < 6 * n; i++) {
        random_stream g = random_start(151, i / 6, 0);
        vec3 half = vabs(random_in_cube(&g, 1)), at = random_in_cube(&g, 1), p[4];
        int axis = (int)(i % 3), side = i % 6 < 3 ? 1 : -1;
        for (int k = 0; k < 4; k++) {
            vec3 c = vwith((vec3){0, 0, 0}, axis, (real)side * vaxis(half, axis));
            for (int j = 1; j < 3; j++) {
                int other = (axis + j) % 3;
                bool high = j == 1 ? k == 1 || k == 2 : k > 1;
                c = vwith(c, other, (high ? 1 : -1) * vaxis(half, other));
            }
            c = vadd(c, at);
            p[k] = (vec3){c.x - turn * c.y, turn * c.x + c.y, c.z};
        }
        row_quad(&m, 2 * i, p[0], p[1], p[2], p[3]);
    }
    return m;
}

/* Quads of which the fourth corner is off by up to `off`. */
static mesh row_quads(double off, double size)
{
    mesh m = mesh_room(40);
    for (size_t i = 0; i < 40; i += 2) {
        random_stream g = random_start(152, i, 0);
        vec3 a = random_in_cube(&g, 1), u = random_in_cube(&g, (real)size);
        vec3 v = random_in_cube(&g, (real)size), c = vadd(vadd(a, u), v);
        row_quad(&m, i, a, vadd(a, u), vadd(c, random_in_cube(&g, (real)off)), vadd(a, v));
    }
    return m;
}

/* In the plane y = z, in pairs that lie upon each other: each t is met twice, at least. */
static mesh row_ties(void)
{
    mesh m = mesh_room(40);
    for (size_t i = 0; i < 40; i++) {
        random_stream g = random_start(153, i / 2, 0);
        vec3 a = random_in_cube(&g, 1), b = random_in_cube(&g, 1), c = random_in_cube(&g, 1);
        a.z = a.y, b.z = b.y, c.z = c.y;
        if (i % 4 == 3) set_triangle(&m, i, b, c, a);
        else set_triangle(&m, i, a, b, c);
    }
    return m;
}

/* A pair that folds back, one triangle twice, and many without area between all others. */
static mesh row_degenerate(void)
{
    mesh m = mesh_room(64);
    for (size_t i = 0; i < 64; i++) {
        random_stream g = random_start(154, i / 4, 0);
        vec3 a = random_in_cube(&g, 1), b = random_in_cube(&g, 1), c = random_in_cube(&g, 1);
        const vec3 far[4] = {c, a, vadd(c, vscale(vsub(b, c), (real)0.3)), c};
        set_triangle(&m, i, a, b, far[i % 4]);
    }
    return m;
}

/* Large faces, and between them some of 1e4 epsilon or less: their edges owe little, the test of 04
 * as much as ever. */
static mesh row_sizes(void)
{
    mesh m = row_quads(0, 1);
    for (size_t i = 8; i < m.triangles; i++) {
        random_stream g = random_start(155, i, 0);
        real size = real_epsilon * pow((real)10, 4 * random_next(&g));
        vec3 a = random_in_cube(&g, 1), u = random_in_cube(&g, size);
        set_triangle(&m, i, a, vadd(a, u), vadd(a, random_in_cube(&g, size)));
    }
    return m;
}

/* ---- brute force, and rows */

static bool row_due(const mesh *m, const bvh8_query *q, hit *best)
{
    *best = hit_none;
    for (uint32_t i = 0; i < m->triangles; i++) {
        hit h;
        bool out = i == q->skip.from || (i >= q->skip.first && i <= q->skip.last);
        if (out || !triangle_hit(mesh_triangle(m, i), *q->r, &h)) continue;
        h.shape = i;
        if (hit_before(h, *best)) *best = h;
    }
    return best->shape != no_shape;
}

/* Rays of all kinds; some that are none, some from as far as they may go side by side. */
static ray row_ray(const items *x, random_stream *g, size_t i, const structure_place *at)
{
    if (i % 53 == 7) return sick_ray[i / 53 % sick_count];
    ray r = structure_aimed(x, g, i / 2, at);
    if (i % 2) r.d = vscale(r.d, 1 / at->scale);  /* tiny: else asked alone */
    if (i % 19 == 3) r.o = vadd(at->move, vscale(vec(8, 0, 0), at->scale));
    if (i % 19 == 2) {  /* to a float it lies in the plane y = z */
        r.d = vscale((vec3){(real)0.3, 1, 1 + 4096 * real_epsilon}, at->scale);
        r.o = vmadd(x->m->v[random_below(g, x->m->vertices)], r.d, -2);
    }
    if (i % 19 == 4) r.tmin = i % 2 ? real_infinity : -1, r.tmax = i % 3 ? real_infinity : -1;
    if (i % 19 == 5) r.d = vscale(r.d, i % 2 ? (real)0x1p-21 : (real)0x1p21);
    if (i % 19 == 6) r.tmax = -real_infinity;
    return r;
}

typedef struct { size_t asked, hits, wrong; } row_verdict;

/* packets: side by side even where it doesn't pay. */
static void row_ask(const bvh8 *w, bvh8_query *q, int n, bool any, bool packets)
{
    const int lanes = w->dialect == EIGHT_AVX512 ? 16 : 8;
    if (!packets || !w->patch) {
        bvh8_ask_row(w, q, n, any);
        return;
    }
    for (int k = 0; k < n; k += lanes)
        EIGHT_CALL(w->dialect, bvh8_packet, w, q + k, n - k < lanes ? n - k : lanes, any);
}

static void row_asked(const bvh8 *w, bvh8_query *q, const ray *r, int n, bool packets,
                      row_verdict *v)
{
    for (int any = 1; any >= 0; any--) {
        for (int k = 0; k < n; k++) q[k].h = hit_none, q[k].met = true;
        row_ask(w, q, n, any, packets);
        for (int k = 0; k < n; k++) {
            hit h;
            bool due = row_due(w->x.m, &q[k], &h);
            bool right = any ? due == q[k].met : same(due, h, q[k].met, q[k].h);
            if (!right && !any) print_wrong(row_dialect[w->dialect], r[k], h, q[k].h);
            v->asked++, v->hits += due, v->wrong += !right;
        }
    }
}

/* Whole rows: the rays, and then those ending at their hits, and [t, t]. */
static void row_mesh(const char *what, mesh m, double scale, double move)
{
    static const int lengths[] = {1, 2, 3, 7, 8, 9, 15, 16, 17, 33, row_most, 0};
    const structure_place at = {vec(move, -move, 0), (real)scale, 0};
    for (size_t i = 0; i < m.vertices; i++) m.v[i] = vadd(vscale(m.v[i], at.scale), at.move);
    items x = items_of_mesh(&m);
    for (int d = EIGHT_PLAIN; d <= (int)eight_best(); d++) {
        bvh8_options how = bvh8_defaults;
        failure f;
        bvh8 w;
        row_verdict v = {0, 0, 0};
        how.dialect = (eight_dialect)d, how.threads = 1;
        if (!bvh8_build(&x, how, &w, &f)) fail(f);
        const size_t all = sizeof lengths / sizeof *lengths;
        for (size_t i = 0; i < check_count(480); i++) {
            int n = lengths[i % all];
            bvh8_query q[row_most];
            ray r[row_most];
            for (int k = 0; k < n; k++) {
                random_stream g = random_start(156, i, (uint64_t)k);
                uint32_t skip = (uint32_t)random_below(&g, m.triangles);
                r[k] = row_ray(&x, &g, row_most * i + (size_t)k, &at);
                q[k] = (bvh8_query){.r = &r[k], .skip = bvh8_skip_none};
                if (k % 3 == 1) q[k].skip.from = skip;
                if (k % 3 == 2) q[k].skip.first = skip, q[k].skip.last = skip + (uint32_t)k / 8;
            }
            for (int way = 0; way < aimed_ways; way++) {
                for (int k = 0; k < n && way; k++)
                    if (q[k].h.shape != no_shape) r[k] = aimed_way(r[k], q[k].h.t, way);
                row_asked(&w, q, r, n, i / all % 2, &v);
            }
        }
        check_equal(v.wrong, 0, "%s, %s: %zu rays, wrong", what, row_dialect[d], v.asked);
        check_at_least(v.hits, v.asked / 8, "%s, %s: some hit", what, row_dialect[d]);
        bvh8_free(&w);
    }
    mesh_free(&m);
}

static void test_rows(void)
{
    const double e = (double)real_epsilon;
    row_mesh("one triangle", needles(1, 0.5), 1, 0);
    row_mesh("soup", soup_mesh(20, 1, 1, 1), 1, 0);
    row_mesh("64 triangles", soup_mesh(64, 1, 1, 2), 1, 0);
    row_mesh("65 triangles", soup_mesh(65, 1, 1, 3), 1, 0);
    row_mesh("boxes", row_boxes(5, 0), 1, 0);
    row_mesh("boxes, turned", row_boxes(5, (real)0.3), 1, 0);
    row_mesh("boxes, far away", row_boxes(5, 0), 1, 3000);
    row_mesh("boxes, tiny", row_boxes(5, (real)0.3), real_is_float ? 1e-15 : 1e-30, 0);
    row_mesh("boxes, huge", row_boxes(5, (real)0.3), real_is_float ? 1e8 : 1e30, 0);
    row_mesh("quads, off by 4 epsilon", row_quads(4 * e, 1), 1, 0);
    row_mesh("quads, off by 1e3 epsilon", row_quads(1e3 * e, 1), 1, 0);
    row_mesh("needles", needles(40, 1e-3), 1, 0);
    row_mesh("ties", row_ties(), 1, 0);
    row_mesh("degenerate", row_degenerate(), 1, 0);
    row_mesh("large and tiny", row_sizes(), 1, 0);
    row_mesh("closed", octahedron_mesh(2), 1, 0);
}

/* ---- where doubt ends: not nearer than the sum of what is owed (MEASURED.md). Of one triangle,
 * corners (0, -1), (0, 1), (1, 0), size 2, D = 2; a ray along z from z = -S. */

static bool row_in_doubt(const bvh8 *w, double x, double S, double tmax)
{
    ray r = {vec(x, 0, -S), 0, {0, 0, 1}, (real)tmax};
    bvh8_query q = {.r = &r, .skip = bvh8_skip_none};
    packet_0 p;
    packet_near_0 near = {EIGHT_ALL(INFINITY), {-1, -1, -1, -1, -1, -1, -1, -1}};
    eight at[2];
    for (int k = 0; k < 8; k++) packet_take_0(w, &q, k, &p);
    packet_bounds_0(&p);
    packet_patch_0(w->patch, 0, &p, at, &near);
    return at[0][0] < INFINITY;
}

static void test_doubt_ends(void)
{
    const double u = 0x1p-24, e = (double)real_epsilon;
    mesh m = mesh_room(1);
    failure f;
    bvh8 w;
    set_triangle(&m, 0, (vec3){0, -1, 0}, (vec3){0, 1, 0}, (vec3){1, 0, 0});
    items x = items_of_mesh(&m);
    if (!bvh8_build(&x, bvh8_defaults, &w, &f)) fail(f);
    w.frame = (aabb_frame){.scale = 1};
    w.patch[0] = patch_of(&w, 0, 0);
    for (double S = 1; S < 8; S += 6) {
        double side = 0, early = 0, no_side = -0.1, no_early = 0.1;
        for (int i = 0; i < 50; i++) {
            double half = (side + no_side) / 2, sooner = (early + no_early) / 2;
            *(row_in_doubt(&w, half, S, 9) ? &side : &no_side) = half;
            *(row_in_doubt(&w, 0.25, S, S - sooner) ? &early : &no_early) = sooner;
        }
        check(row_in_doubt(&w, 0, S, S), "what is met is in doubt");
        check_at_least(-2 * side, 2 * 28 * u * S + 456 * e * S * S, "(15.12), S = %g", S);
        check_at_least(early, 54 * u * S + 415 * e * S * S, "(15.13), S = %g", S);
    }
    bvh8_free(&w), mesh_free(&m);
}

/* A box has six patches; each triangle that is held is in one of them, others in none. */
static void row_patches(const char *what, mesh m, size_t patches, size_t twos)
{
    items x = items_of_mesh(&m);
    failure f;
    bvh8 w;
    size_t seen[bvh8_few] = {0}, wrong = 0, both = 0;
    if (!bvh8_build(&x, bvh8_defaults, &w, &f)) fail(f);
    for (size_t i = 0; i < w.patches; i++) {
        both += w.patch[i].items == 2;
        for (uint32_t k = 0; k < w.patch[i].items; k++) seen[w.patch[i].index[k]]++;
    }
    for (size_t i = 0; i < m.triangles && w.patch; i++) {
        triangle t = mesh_triangle(&m, i);
        wrong += seen[i] != !vzero(triangle_cross(t.a, t.b, t.c));
    }
    check_equal(w.patches, patches, "%s: patches", what);
    check_equal(both, twos, "%s: of two triangles", what);
    check_equal(wrong, 0, "%s: each triangle of some area is in one patch", what);
    bvh8_free(&w), mesh_free(&m);
}

static void test_patches(void)
{
    row_patches("a box", row_boxes(1, 0), 6, 6);
    row_patches("a box, turned", row_boxes(1, (real)0.3), 6, 6);
    row_patches("soup", soup_mesh(64, 1, 1, 2), 64, 0);
    row_patches("too many", soup_mesh(65, 1, 1, 3), 0, 0);
    row_patches("quads, off by 1e3 epsilon", row_quads(1e3 * (double)real_epsilon, 1), 40, 0);
    row_patches("degenerate", row_degenerate(), 48, 0);
}

/* Six patches are asked side by side in every dialect, 64 in none, nor are two rays: then the
 * search of the tree counts what it asked in `real`. */
static void test_row_pays(void)
{
    for (int i = 0; i < 2 * ((int)eight_best() + 1); i++) {
        mesh m = i % 2 ? soup_mesh(bvh8_few, 1, 1, 2) : row_boxes(1, 0);
        items x = items_of_mesh(&m);
        bvh8_options how = bvh8_defaults;
        failure f;
        bvh8 w;
        how.dialect = (eight_dialect)(i / 2);
        if (!bvh8_build(&x, how, &w, &f)) fail(f);
        triangle t = mesh_triangle(&m, 0);
        vec3 o = {2, 2, 2};
        ray r = ray_from(o, vsub(triangle_at(t, (real)0.3, (real)0.3), o));
        bvh8_query q[3];
        for (int k = 0; k < 3; k++) q[k] = (bvh8_query){.r = &r, .skip = bvh8_skip_none};
        for (int n = 2; n <= 3; n++) {
            size_t before = bvh8_asked;
            bvh8_ask_row(&w, q, n, false);
            check(q[0].met && (bvh8_asked > before) == (i % 2 || n < 3), "%s, %zu patches, %d rays",
                  row_dialect[w.dialect], w.patches, n);
        }
        bvh8_free(&w), mesh_free(&m);
    }
}

int main(void)
{
    return check_all("15_packet", test_rows, test_row_pays, test_doubt_ends, test_patches);
}
