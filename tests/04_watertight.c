/* Tests of 04_triangle: rays aimed at edges and vertices of closed meshes. The naive forms must
 * slip, triangle_hit must not, not once. */
#include "check.h"
#include "../chapters/04_triangle/lab/triangle_trials.h"
#include "../chapters/04_triangle/lab/triangle_variants.h"

/* Rays at edges and vertices of a closed mesh, which is freed: none slips, and t of the aimed point
 * is 1. */
static void no_slip(icosphere m, size_t n, uint64_t seed, double bound, const char *what, double of)
{
    for (int at_vertex = 0; at_vertex < 2; at_vertex++) {
        triangle_slip_count c = slips(&m, triangle_hit, at_vertex, check_count(n), seed);
        check_equal(c.slips, 0, "%s %g: rays aimed at %s", what, of,
                    at_vertex ? "vertices" : "edges");
        check_at_most(c.error, bound * (double)real_epsilon, "%s %g: t of what is aimed at", what,
                      of);
    }
    icosphere_free(&m);
}

/* The translations are as large as the real can take: the mesh must keep its shape on the lattice
 * of the reals around it. The aimed point is off the edge by half an ulp of its coordinates, some
 * eps |T|; slopes of the facets against the ray, at most some 3, turn that into an error of t. */
static void test_no_slip_at_any_translation(void)
{
    const real far = real_is_float ? 16384 : (real)1e9, aside = real_is_float ? 9000 : (real)-1e9;
    const vec3 place[] = {{0, 0, 0}, {1000, 0, 0}, {100000, -30000, 7000}, {far, aside, 3}};
    for (uint64_t i = 0; i < 4; i++)
        no_slip(icosphere_new(4, place[i], 1), 2000000, 40 + i, 8 * (1 + (double)place[i].x),
                "translated by", (double)place[i].x);
}

/* The same by the size of the mesh: nothing is compared with a fixed number, and the products of
 * the coordinates, which under- or overflow here, are rescued. */
static void test_no_slip_at_any_size(void)
{
    const double sizes[2][6] = {{1e-300, 1e-200, 1e-160, 1e5, 1e160, 1e300},
                                {1e-35, 1e-25, 1e-18, 1e5, 1e18, 1e35}};
    for (int k = 0; k < 6; k++) {
        double size = sizes[real_is_float][k];
        no_slip(icosphere_new(3, (vec3){0, 0, 0}, (real)size), 100000, 50, 8, "size", size);
    }
}

/* Closed meshes of slivers: corners snapped to a lattice, so that many fall together and many
 * triangles become lines, then moved by up to 1000 half ulps, so that the lines are slivers 1e-13
 * wide. The map of the sphere stays in one piece and goes round the origin once: a hit is due. */
static void test_no_slip_between_slivers(void)
{
    for (uint64_t seed = 0; seed < 4; seed++) {
        icosphere m = icosphere_new(3, (vec3){0, 0, 0}, 1);
        random_stream g = random_start(seed, 0, 0);
        for (uint32_t i = 0; i < m.vertices; i++)
            for (int k = 0; k < 3; k++) {
                real snapped = floor(4 * vaxis(m.v[i], k) + (real)0.5) / 4;
                real ulps = floor(random_between(&g, -1000, 1000));
                m.v[i] = vwith(m.v[i], k, snapped + ulps * real_epsilon / 2);
            }
        no_slip(m, 100000, 60 + seed, 1e4, "slivers", (double)seed);
    }
}

/* Closed meshes with spikes: a fifth of the vertices of an icosphere moved straight outwards, so
 * far that the corners of a triangle differ in size by more than the digits of a real. Seen from
 * the centre nothing has changed, and a hit is due in every direction. */
static void test_no_slip_between_spikes(void)
{
    for (uint64_t seed = 0; seed < 6; seed++) {
        icosphere m = icosphere_new(2, (vec3){0, 0, 0}, 1);
        random_stream g = random_start(seed, 7, 0);
        real longest = exp2((real)((real_is_float ? 20 : 50) + 4 * (int)seed));
        for (uint32_t i = 0; i < m.vertices; i++)
            if (random_next(&g) < (real)0.2) m.v[i] = vscale(m.v[i], longest);
        size_t slipped = 0, n = check_count(20000);
        for (size_t i = 0; i < n; i++) {
            triangle t =
                icosphere_triangle(&m, (uint32_t)(random_next_bits(&g) >> 32) % m.triangles);
            real u = random_next(&g), v = random_next(&g) * (1 - u);
            vec3 o = slip_origin(&g, (vec3){0, 0, 0}, 0.01), a = vunit(t.a);
            vec3 d = vmadd(vmadd(vscale(a, 1 - u - v), vunit(t.b), u), vunit(t.c), v);
            slipped += slip_misses_all(&m, triangle_hit, ray_from(o, i % 4 ? d : vsub(t.a, o)));
        }
        check_equal(slipped, 0, "spikes of length %g, %zu rays", (double)longest, n);
        icosphere_free(&m);
    }
}

/* A cube of few, exactly representable coordinates and rays from exactly representable points: many
 * computed signs are exactly zero. Every ray that starts inside must hit. */
static void test_no_slip_on_a_lattice(void)
{
    vec3 v[8];
    static const int face[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6},
                                    {0, 1, 4}, {1, 5, 4}, {2, 6, 3}, {3, 6, 7},
                                    {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    for (int i = 0; i < 8; i++)
        v[i] = (vec3){i & 1 ? 4 : -4, i & 2 ? 4 : -4, i & 4 ? 4 : -4};
    size_t slipped = 0, rays = 0;
    for (int o = 0; o < 343; o++)
        for (int d = 0; d < 729; d++) {
            ray r = ray_from(vec((o % 7 - 3), (o / 7 % 7 - 3), (o / 49 - 3)),
                             vec((d % 9 - 4), (d / 9 % 9 - 4), (d / 81 - 4)));
            if (vzero(r.d)) continue;
            bool any = false;
            hit h;
            for (int i = 0; i < 12 && !any; i++)
                any = triangle_hit((triangle){v[face[i][0]], v[face[i][1]], v[face[i][2]]}, r, &h);
            rays++, slipped += !any;
        }
    check_equal(slipped, 0,
                "cube of integers, %zu rays along integer directions, zeros and diagonals included",
                rays);
}

/* Random directions find no edge to slip through: whoever tests with them learns nothing. */
static void test_random_rays_show_nothing(void)
{
    icosphere m = icosphere_new(3, (vec3){0, 0, 0}, 1);
    random_stream g = random_start(90, 0, 0);
    size_t slipped = 0, n = check_count(10000);
    for (size_t i = 0; i < n; i++) {
        vec3 d = random_in_cube(&g, 1);
        ray r = ray_from(slip_origin(&g, m.centre, m.radius), d);
        slipped += slip_misses_all(&m, first_triangle_hit, r);
        slipped += slip_misses_all(&m, triangle_hit_plane, r);
    }
    check_equal(slipped, 0, "2 x %zu random rays slip through no form at all", n);
    icosphere_free(&m);
}

/* Bounds are about a third of the measured rates: they do not come from the seed. */
static void test_naive_forms_slip(void)
{
    const struct { const char *name; triangle_method *hit; double vertex, edge; } naive[] = {
        {"plane + inside", triangle_hit_plane, 0.03, 0.03},
        {"first: Möller-Trumbore", first_triangle_hit, 0.03, 0.03},
        {"Möller-Trumbore, divides last", triangle_hit_moller_trumbore, 0.03, 0.03},
        {"planes computed beforehand", triangle_hit_planes, 0.08, 0.06},
        {"triple products", triangle_hit_triple, 0.005, 0}};
    icosphere m = icosphere_new(3, (vec3){0, 0, 0}, 1);
    size_t n = check_sample(10000, 2000);
    for (int k = 0; k < 5; k++)
        for (int at_vertex = 0; at_vertex < 2; at_vertex++) {
            triangle_slip_count c = slips(&m, naive[k].hit, at_vertex, n, 80);
            check_at_least((double)c.slips / (double)n, at_vertex ? naive[k].vertex : naive[k].edge,
                           "%s slips %s", naive[k].name, at_vertex ? "at vertices" : "at edges");
        }
    triangle_slip_count c = slips(&m, triangle_hit_triple, false, check_count(100000), 80);
    check_equal(c.slips, 0, "triple products are tight at edges: neighbours compute one number");
    c = slips(&m, triangle_hit_tolerant, false, n, 80);
    check_equal(c.slips, 0, "a tolerance of 1e-5 stops the slips");
    check_at_least((double)c.hits, 1.99 * (double)n, "and a ray at an edge hits both neighbours");
    c = slips(&m, triangle_hit, false, n, 80);
    check_at_most((double)c.hits, 1.1 * (double)n,
                  "where the watertight test hits one, but for exact zeros");
    icosphere_free(&m);
}

static void test_icosphere(void)
{
    icosphere m = icosphere_new(4, (vec3){1, 2, 3}, 2);
    check(m.triangles == 5120 && m.vertices == 2562 && m.edges == 7680,
          "20 * 4^4 triangles; V - E + F = 2");
    size_t wrong = 0, five = 0;
    double off = 0;
    for (uint32_t i = 0; i < m.vertices; i++) {
        five += m.fan[i].count == 5;
        wrong += m.fan[i].count != 5 && m.fan[i].count != 6;
        off = check_worse(off, fabs((double)vlength(vsub(m.v[i], (vec3){1, 2, 3})) - 2));
    }
    check(wrong == 0 && five == 12, "12 vertices with five triangles, the others with six");
    check_at_most(off, 8 * (double)real_epsilon,
                  "vertices on the sphere: 2 eps of the unit vector, rounding at 5");
    wrong = 0;
    for (uint32_t e = 0; e < m.edges; e++)
        wrong += m.edge[e].triangle[0] == no_shape || m.edge[e].triangle[1] == no_shape;
    check_equal(wrong, 0, "every edge has two triangles: closed");
    for (uint32_t i = 0; i < m.triangles; i++) {
        triangle t = icosphere_triangle(&m, i);
        wrong += !(vdot(triangle_normal(t), vsub(t.a, (vec3){1, 2, 3})) > 0);
    }
    check_equal(wrong, 0, "counter-clockwise seen from outside");
    icosphere_free(&m);
}

int main(void)
{
    return check_all("04_watertight", test_icosphere, test_no_slip_at_any_translation,
                     test_no_slip_at_any_size, test_no_slip_between_slivers,
                     test_no_slip_between_spikes, test_no_slip_on_a_lattice,
                     test_random_rays_show_nothing, test_naive_forms_slip);
}
