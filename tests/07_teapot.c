/* Tests of chapters/07_mesh/teapot.h: patches against de Casteljau in wide numbers, the mesh
 * against Euler's formula, Newell's box and the winding number. (Its points: test_shipped, 07_obj.)
 */
#include "check.h"
#include "../common/random.h"
#include "../common/numbers/wide.h"
#include "../chapters/07_mesh/files/obj.h"
#include "../chapters/07_mesh/inside.h"
#include "../chapters/07_mesh/scenes/teapot.h"

static int compare_edges(const void *a, const void *b)
{
    uint64_t x = *(const uint64_t *)a, y = *(const uint64_t *)b;
    return (x > y) - (x < y);
}

/* ---- counts and edges ---- */

typedef struct { size_t edges, open, crowded, flat; } edge_counts;

/* Each edge as (lower vertex, higher vertex), with the direction as lowest bit; neighbours in a
 * sorted list tell how often it occurs. crowded: more than once in a direction. */
static edge_counts count_edges(const mesh *m)
{
    edge_counts c = {0, 0, 0, 0};
    size_t n = 3 * m->triangles;
    uint64_t *e = allocate(n, 8);
    for (size_t i = 0; i < n; i++) {
        uint64_t a = m->index[i], b = m->index[i % 3 == 2 ? i - 2 : i + 1];
        e[i] = a < b ? (a << 32 | b) << 1 : (b << 32 | a) << 1 | 1;
        c.flat += a == b;
    }
    qsort(e, n, 8, compare_edges);
    for (size_t i = 0; i < n; i++) {
        bool first = i == 0 || e[i - 1] >> 1 != e[i] >> 1;
        bool last = i + 1 == n || e[i + 1] >> 1 != e[i] >> 1;
        c.edges += first, c.open += first && last, c.crowded += !first && e[i] == e[i - 1];
    }
    free(e);
    return c;
}

static void test_counts(void)
{
    for (size_t n = 1; n <= 40; n += n < 12 ? 1 : 28) {
        mesh m = teapot_mesh((int)n);
        edge_counts c = count_edges(&m);
        bool inside = m.normals == m.vertices && m.normal_index == NULL;
        for (size_t i = 0; i < 3 * m.triangles; i++) inside = inside && m.index[i] < m.vertices;
        check(inside, "indices in range, a normal a vertex");
        check_equal(m.triangles, 64 * n * n - 8 * n, "triangles of the SPD for n = %zu", n);
        check_equal(m.vertices, 32 * n * n + 4 * n + 2, "vertices, n = %zu", n);
        check_equal(c.flat, 0, "no triangle has a corner twice");
        if (n > 1) {  /* n = 1: the halves of handle and spout share all their edges */
            check_equal(m.vertices + m.triangles - c.edges, 2, "Euler: 2 discs, 2 tubes (0)");
            check_equal(c.open, 16 * n, "open edges, n = %zu", n);
            check_equal(c.crowded, 0, "two triangles an edge, in opposite directions");
        }
        mesh_free(&m);
    }
    mesh least = teapot_mesh(-5);
    check_equal(least.triangles, 56, "n below 1 is 1");
    check_text(mesh_material(&least, 0), "body", "first part");
    check_text(mesh_material(&least, 55), "spout", "last part");
    mesh_free(&least);
}

/* ---- box ---- */

static void test_box(void)
{
    /* The spout's edge has x = (3.3, 3.525, 3.45, 3.2): x'/3 = .225 s^2 - .15 s t - .25 t^2. With
     * s = 1 - t: .125 t^2 - .6 t + .225 = 0. Between grid lines x bends by at most |x''|/8n^2. */
    double t = (.6 - sqrt(.36 - 4 * .125 * .225)) / .25, s = 1 - t;
    double x = 3.3 * s * s * s + 3 * 3.525 * s * s * t + 3 * 3.45 * s * t * t + 3.2 * t * t * t;
    check_close(x, 3.434, 5e-4, "the surface's box as published");
    for (int n = 1; n <= 32; n *= 2) {
        vec3 lo, hi;
        mesh m = teapot_mesh(n);
        mesh_bounds(&m, &lo, &hi);
        check(lo.x == -3 && lo.y == -2 && lo.z == 0 && hi.y == 2 && hi.z == (real)3.15,
              "where the box touches corners of patches it is exact");
        check_at_most((double)hi.x, x + 8 * (double)real_epsilon, "no point beyond the spout");
        check_at_least((double)hi.x, x - 1.8 / 8 / (n * n), "n = %d: |x''| <= 6 * 0.3", n);
        mesh_free(&m);
    }
}

/* ---- patches against wide numbers ---- */

static wide3 lerp(wide3 a, wide3 b, wide t) { return wide3_madd(a, wide3_sub(b, a), t); }

/* De Casteljau: averages of averages; another algorithm, in twice the precision. */
static wide3 casteljau(wide3 p[4], wide t)
{
    for (int k = 3; k; k--)
        for (int i = 0; i < k; i++) p[i] = lerp(p[i], p[i + 1], t);
    return p[0];
}

static wide3 wide_point(const bezier_patch *c, wide u, wide v)
{
    wide3 row[4], p[4];
    for (int j = 0; j < 4; j++) {
        for (int i = 0; i < 4; i++) p[i] = wide3_of(c->p[j][i]);
        row[j] = casteljau(p, u);
    }
    return casteljau(row, v);
}

static double distance(wide3 a, wide3 b) { return wide_value(wide3_length(wide3_sub(a, b))); }

static wide3 wide_unit(wide3 a)
{
    wide3 zero = {wide_of(0), wide_of(0), wide_of(0)};
    return wide3_madd(zero, a, wide_div(wide_of(1), wide3_length(a)));
}

static bezier_patch patch_of(int k)  /* 0 to 31 */
{
    int part = 0;
    while (k >= teapot_parts[part].copies * teapot_parts[part].rings)
        k -= teapot_parts[part].copies * teapot_parts[part].rings, part++;
    const teapot_part *p = &teapot_parts[part];
    return teapot_patch(p, k / p->copies, k % p->copies);
}

static void test_patches(void)
{
    random_stream rng = random_start(3, 0, 0);
    size_t n = check_count(20000);
    double worst = 0, worst_normal = 0, eps = (double)real_epsilon;
    for (size_t i = 0; i < n; i++) {
        bezier_patch c = patch_of((int)(i % 32));
        double u = (double)(random_next_bits(&rng) % 4095 + 1) / 4096;  /* 1 - u is exact */
        double v = (double)(random_next_bits(&rng) % 4095 + 1) / 4096, h = 0x1p-30;
        bezier_weights bu = bezier_at((real)(1 - u), (real)u);
        bezier_weights bv = bezier_at((real)(1 - v), (real)v);
        vec3 normal, p = bezier_point(&c, &bu, &bv, &normal);
        worst = check_worse(worst, distance(wide3_of(p), wide_point(&c, wide_of(u), wide_of(v))));

        /* Central differences: off by h^2/6 of the third derivative, some 1e-18. */
        wide x = wide_of(u), y = wide_of(v), up = wide_of(u + h), vp = wide_of(v + h);
        wide um = wide_of(u - h), vm = wide_of(v - h);
        wide3 du = wide3_sub(wide_point(&c, up, y), wide_point(&c, um, y));
        wide3 dv = wide3_sub(wide_point(&c, x, vp), wide_point(&c, x, vm));
        wide3 cross = wide3_cross(du, dv);
        double lu = wide_value(wide3_length(du)) / (2 * h);
        double lv = wide_value(wide3_length(dv)) / (2 * h), longest = 0;
        double sine = wide_value(wide3_length(cross)) / (4 * h * h) / (lu * lv);
        for (int k = 0; k < 16; k++) {  /* the differences whose means are P_u, P_v: may cancel */
            vec3 a = c.p[k / 4][k % 4];
            vec3 left = c.p[k / 4][k % 4 ? k % 4 - 1 : 0];
            vec3 above = c.p[k / 4 ? k / 4 - 1 : 0][k % 4];
            longest = check_worse(longest, (double)vlength(vsub(a, left)));
            longest = check_worse(longest, (double)vlength(vsub(a, above)));
        }
        double condition = 3 * (longest / lu + longest / lv) / sine;
        double off = distance(wide3_of(normal), wide_unit(cross)) / condition;
        worst_normal = check_worse(worst_normal, off);
    }
    check_at_most(worst, 12 * eps * 3.5, "against de Casteljau: 3 roundings in a weight, 3 in a "
                  "sum, twice, three components: 20 halves of epsilon, coordinates up to 3.5");
    check_at_least(worst, eps / 16, "rounding does show");
    check_at_most(worst_normal, 4 * eps, "normals against differences; P_u, P_v are off by some 8 "
                  "halves of epsilon of the longest difference, which the condition counts");

    for (int k = 0; k < 32; k++) {  /* corners, and mirrored in u: the same to the last bit */
        bezier_patch c = patch_of(k), mirrored;
        bool same = true;
        for (int i = 0; i < 16; i++) mirrored.p[i / 4][i % 4] = c.p[i / 4][3 - i % 4];
        for (int corner = 0; corner < 4; corner++) {
            real u = (real)(corner & 1), v = (real)(corner >> 1), x = (real)0.3;
            bezier_weights bu = bezier_at(1 - u, u), bv = bezier_at(1 - v, v),
                           bx = bezier_at(1 - x, x), back = bezier_at(x, 1 - x);
            vec3 p = bezier_point(&c, &bu, &bv, NULL), q = c.p[3 * (corner >> 1)][3 * (corner & 1)];
            same = same && vzero(vsub(p, q));
            p = bezier_point(&c, &bx, &bv, NULL), q = bezier_point(&mirrored, &back, &bv, NULL);
            same = same && vzero(vsub(p, q));
        }
        check(same, "patch %d begins and ends in its corner points, exactly; mirrored, too", k);
    }
}

/* ---- normals and orientation ---- */

/* Of the triangles [from, to): 1 inside a closed mesh that is turned outwards. */
static double winding(const mesh *m, size_t from, size_t to, vec3 p)
{
    mesh part = {.v = m->v, .vertices = m->vertices, .index = m->index + 3 * from,
                 .triangles = to - from};
    return winding_number(&part, p);
}

static void test_outwards(void)
{
    size_t n = 24;
    mesh m = teapot_mesh((int)n);
    /* From (0,0,1) only the gap between lid and rim lets one look out: 1.3 < r < 1.4 at z = 2.4. */
    double gap = (1.4 / hypot(1.3, 1.4) - 1.4 / hypot(1.4, 1.4)) / 2;
    size_t handle = m.run[2].first, spout = m.run[3].first;
    vec3 inside = {0, 0, 1}, above = {0, 0, 4}, grip = {-2.85, 0, 1.8};
    /* each ring is a circle within 0.6 %, but both are alike: of 1e-3 each 5e-5 are left */
    check_close(winding(&m, 0, handle, inside), 1 - gap, 1e-4, "body and lid from inside");
    check_close(winding(&m, 0, handle, above), 0, 0.02, "body and lid from outside");
    check_at_least(winding(&m, handle, spout, grip), 0.95, "handle from inside: its ends are far");
    check_at_least(winding(&m, spout, m.triangles, vec(2.4, 0, 1.5)), 0.6,
                   "spout from inside: its ends are nearer");

    size_t bad = 0, poles = 0;
    real least = 1;
    for (size_t i = 0; i < 3 * m.triangles; i++) {
        vec3 face = triangle_normal(mesh_triangle(&m, i / 3));
        least = real_min(least, vdot(face, mesh_corner_normal(&m, i / 3, (int)(i % 3))));
    }
    check_at_least(least, (real)0.7, "every triangle looks the way its normals do");
    for (size_t i = 0; i < m.vertices; i++) {
        bad += !(fabs(vlength(m.n[i]) - 1) <= 4 * real_epsilon);
        if (m.v[i].x != 0 || m.v[i].y != 0) continue;
        poles++;
        check(m.n[i].x == 0 && m.n[i].y == 0, "straight up or down");
        check_close(m.n[i].z, m.v[i].z > 1 ? 1 : -1, 2 * real_epsilon, "up on the lid, else down");
    }
    check_equal(bad, 0, "unit normals");
    check_equal(poles, 2, "points on the axis: knob and bottom");

    mesh_free(&m);

    /* The limit at the axis is a limit: close by, the normal differs by about the distance. */
    bezier_patch lid = teapot_patch(&teapot_parts[1], 0, 0);
    for (real v = (real)0x1p-4; v > (real)0x1p-12; v /= 4) {
        bezier_weights bu = bezier_at(0.5, 0.5), bv = bezier_at(1 - v, v);
        vec3 normal;
        bezier_point(&lid, &bu, &bv, &normal);
        check_at_most(hypot(normal.x, normal.y), 2 * v, "towards the axis the normal turns up");
    }
}

int main(void)
{
    return check_all("07_teapot", test_counts, test_box, test_patches, test_outwards);
}
