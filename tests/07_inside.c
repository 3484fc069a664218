/* 07_inside: point in mesh by parity, vote and winding number, aimed at vertices and edges. */
#include "check.h"
#include "../chapters/07_mesh/lab/trials.h"

/* Closed: each edge runs once in each direction. V - E + F = 2 - 2 holes (Euler, 欧拉公式). */
static void specimens_are_closed(void)
{
    mesh m[2] = {octahedron_mesh(3), torus_mesh(5)};
    for (int i = 0; i < 2; i++) {
        size_t open = 0;
        for (size_t a = 0; a < 3 * m[i].triangles; a++) {
            uint32_t from = m[i].index[a], to = m[i].index[a % 3 == 2 ? a - 2 : a + 1];
            int back = 0, again = 0;
            for (size_t b = 0; b < 3 * m[i].triangles; b++) {
                uint32_t f = m[i].index[b], t = m[i].index[b % 3 == 2 ? b - 2 : b + 1];
                back += f == to && t == from;
                again += f == from && t == to;
            }
            open += back != 1 || again != 1;
        }
        check_equal(open, 0, "specimen %d: edges without a partner", i);
        check_equal((int)m[i].vertices - (int)m[i].triangles / 2, i ? 0 : 2,
                    "specimen %d: Euler number", i);
        mesh_free(&m[i]);
    }
}

static void solid_angles(void)
{
    vec3 x = {1, 0, 0}, y = {0, 2, 0}, z = {0, 0, 3};
    double eps = (double)real_epsilon, octant = 3.14159265358979323846 / 2;
    check_close(solid_angle(x, y, z), octant, 4 * eps,
                "an octant is an eighth of 4 pi, whatever the lengths");
    check_close(solid_angle(y, x, z), -octant, 4 * eps, "the other way round: negative");
    check_equal(solid_angle(x, y, vadd(x, y)), 0, "edge-on: nothing");
    check_close(solid_angle(vec(1, 0, 1e-3), vec(-0.5, 0.75, 1e-3),
                            vec(-0.5, -0.75, 1e-3)),
                4 * octant, 0.02,
                "just below a triangle it is nearly half of the sphere, not nearly 0");
    check_equal(solid_angle((vec3){0, 0, 0}, y, z), 0, "a corner at p");
    /* A square of side 2 at distance 1 is one face of a cube: 4 pi / 6. */
    vec3 a = {-1, -1, 1}, b = {1, -1, 1}, c = {1, 1, 1}, d = {-1, 1, 1};
    check_close(solid_angle(a, b, c) + solid_angle(a, c, d), 4 * octant / 3, 8 * eps,
                "a face of a cube");
    mesh m = torus_mesh(40);
    check_close(winding_number(&m, vec(0.75, 0, 0)), 1, 3200 * eps,
                "in the ring: 1, n epsilon");
    check_close(winding_number(&m, (vec3){0, 0, 0}), 0, 3200 * eps, "in its hole: 0");
    check_close(winding_number(&m, (vec3){100, 0, 0}), 0, 3200 * eps, "far away: 0");
    mesh_free(&m);
}

/* All points of the lattice, exactly, along the axes, where 4, 6 or 8 triangles meet in each
 * vertex. Inside is |x| + |y| + |z| < 1, in whole numbers. */
static void lattice(void)
{
    enum { n = 4 };
    mesh m = octahedron_mesh(n);
    inside_score w = {0, {0}};
    first_mesh soup = mesh_soup(&m);
    for (int z = -n; z <= n; z++)
        for (int y = -n; y <= n; y++)
            for (int x = -n - 1; x <= n + 1; x++)
                for (int axis = 0; axis < 6; axis++) {
                    int far = abs(x) + abs(y) + abs(z);
                    if (far == n) continue;  /* on the surface */
                    vec3 p = {(real)x / n, (real)y / n, (real)z / n}, d = {0, 0, 0};
                    ((real *)&d)[axis / 2] = axis % 2 ? -1 : 1;
                    w.asked++;
                    for (int k = 0; k < inside_methods; k++)
                        w.wrong[k] += inside_ask(k, &m, &soup, p, d) != (far < n);
                }
    for (int k = inside_of_hits; k < inside_methods; k++)
        check_equal(w.wrong[k], 0, "%s: wrong of %zu lattice points", inside_names[k], w.asked);
    for (int k = 0; k < inside_of_hits; k++)
        check_at_least(w.wrong[k], w.asked / 20, "%s: wrong at 1 of 20 lattice points and more",
                       inside_names[k]);
    mesh_free(&m), first_mesh_free(&soup);
}

/* The aim of the votes is one that hurts: a vote of one, that is one naive parity along the same
 * directions, is wrong as often as rays straight at a vertex are. */
static void votes_are_aimed(void)
{
    mesh m = torus_mesh(24);
    size_t n = check_count(4000);
    for (int votes = 3; votes <= 5; votes += 2) {
        size_t wrong = 0, alone = 0, hurt = 0;
        random_stream s = random_start(22, (uint64_t)votes, 0);
        for (size_t i = 0; i < n; i++) {
            vec3 p, d;
            bool inside = inside_question(&m, &s, AT_VERTEX, votes, &p, &d), own = false;
            for (int k = 0; k < votes; k++) {
                vec3 e = inside_direction(k, votes);
                own = own || (e.x == d.x && e.y == d.y && e.z == d.z);
            }
            bool bad = inside_parity_naive(&m, p, d) != inside;
            alone += bad && own;
            wrong += inside_vote(&m, p, votes) != inside;
            hurt += bad;
        }
        check_equal(wrong, 0, "vote of %d, one of its rays through a vertex, of %zu", votes, n);
        check_at_least(alone, n / 20, "that ray alone is wrong at 5 %% and more");
        check_equal(hurt, alone, "the ray is one that the vote of %d casts", votes);
    }
    mesh_free(&m);
}

/* Rays aimed at vertices and at points of edges of a torus, whose coordinates are not exact. */
static void aimed(void)
{
    mesh m = torus_mesh(24);
    const char *name[] = {"random", "edge", "vertex"};
    for (inside_aim at = AT_RANDOM; at <= AT_VERTEX; at++) {
        random_stream numbers = random_start(21, (uint64_t)at, 0);
        inside_score w = inside_play(&m, &numbers, at, check_count(4000));
        for (int k = at == AT_RANDOM ? 0 : inside_of_hits;
             k < inside_methods - (at != AT_RANDOM); k++)
            check_equal(w.wrong[k], 0, "%s: %s, wrong of %zu", name[at], inside_names[k], w.asked);
        for (int k = 0; k < inside_of_hits; k++) {
            if (at == AT_VERTEX)
                check_at_least(w.wrong[k], w.asked / 10, "vertex: %s is wrong at 10 %% and more",
                               inside_names[k]);
            if (at == AT_EDGE)
                check_at_least(w.wrong[k], w.asked / 100, "edge: %s is wrong at 1 %% and more",
                               inside_names[k]);
        }
    }
    mesh_free(&m);
}

/* One triangle less: parity follows the ray through the hole, the winding number hardly changes. */
static void open_mesh(void)
{
    mesh m = octahedron_mesh(4);
    triangle hole = mesh_triangle(&m, m.triangles - 1);
    vec3 p = {0.03125, 0.015625, 0.0078125};
    vec3 through = vsub(vscale(vadd(vadd(hole.a, hole.b), hole.c), 1 / (real)3), p);
    check(inside_parity(&m, p, through) && inside_parity_naive(&m, p, through), "closed: inside");
    vec3 outside = vmadd(vscale(vadd(vadd(hole.a, hole.b), hole.c), 1 / (real)3),
                         inside_direction(4, 5), -2);
    check(!inside_vote(&m, outside, 5), "outside the closed mesh");
    m.triangles--;
    check(inside_parity_naive(&m, outside, inside_direction(4, 5)), "in by the hole: one hit");
    check(!inside_vote(&m, outside, 5), "one of five is outvoted");
    check(!inside_parity(&m, p, through) && !inside_parity_naive(&m, p, through),
          "parity through the hole: outside");
    check(inside_parity(&m, p, vneg(through)), "and inside by the other way");
    check(inside_winding(&m, p) && inside_vote(&m, p, 5), "winding number and vote: inside");
    check_close(winding_number(&m, p), 1 - 1.0 / 128, 0.01,
                "1 of 128 triangles: some 1/128 is missing");
    for (size_t i = 0; i < m.triangles; i++) {
        uint32_t *k = m.index + 3 * i, swap = k[0];
        k[0] = k[1], k[1] = swap;
    }
    check(inside_winding(&m, p), "all triangles turned over: still inside");
    m.triangles = 0;
    check(!inside_parity(&m, p, through) && !inside_winding(&m, p),
          "no triangles: nothing is inside");
    mesh_free(&m);
}

int main(void)
{
    specimens_are_closed();
    solid_angles();
    lattice();
    aimed();
    votes_are_aimed();
    open_mesh();
    return check_report("07_inside");
}
