/* Tests of 22_radiometry: each relation measured and compared with its closed form by a t-test, the
 * wrong ones refuted; photons on floors; pixels counted; four ways of sampling. Fixed seeds;
 * each random test alarms falsely once in 1e8 seeds, and there are fewer than 100. */
#include "../common/lab/chi_square.h"
#include "../common/lab/t_test.h"
#include "../chapters/22_radiometry/lab/pictures.h"
#include "../common/file.h"
#include "check.h"

#define alarm 1e-8
#define eps ((double)real_epsilon)
#define PI 3.14159265358979324

static void test_relations(void)
{
    size_t n = check_count(100000), wrong = 0;
    for (size_t k = 0; k < relations; k++) {
        const relation r = relation_of(k);
        estimate e = relation_measure(k, 7, n);
        double c = r.closed, p = t_test(e, c, 16 * eps * fabs(c));
        check(e.n > 1 && estimate_error(e) > 0, "%s: chance has a part in it", r.name);
        if (r.holds) check_at_least(p, alarm, "%s", r.name);
        else check_at_most(p, alarm, "%s: refuted", r.name), wrong++;
        check_at_most(estimate_error(e), 0.05 * sqrt(1e5 / (double)n) * fabs(c),
                      "%s: good for 5 %%", r.name);
    }
    check_equal((double)wrong, 3, "three of them are often believed");
}

/* Closed forms that the tests of solid angles do not have. Phi of I = cos^n: 2 pi / (n+1), by the
 * midpoint rule in cos theta. */
static void test_closed(void)
{
    double sum = 0;
    for (int i = 0; i < 10000; i++) sum += pow((i + 0.5) / 10000, 8) / 10000;
    check_close(2 * PI * sum, spot_flux, 1e-7, "flux of the spotlight");
    check_equal(area_term(pane, (vec3){2, 0, 1}, (vec3){-1, 0, 0}, 0.5, 0.5), 0,
                "the back of the square is dark");
}

/* ---- photons ---- */

/* Mean of E over cell (i, j), by the middles of parts^2 of it; there is none inside the sphere. */
static double floor_mean(floor_light light, int i, int j, int parts)
{
    double sum = 0;
    for (int k = 0; k < parts * parts; k++) {
        real x = ((real)i + ((real)(k % parts) + (real)0.5) / (real)parts) / floor_cells;
        real y = ((real)j + ((real)(k / parts) + (real)0.5) / (real)parts) / floor_cells;
        x = (2 * x - 1) * floor_half, y = (2 * y - 1) * floor_half;
        bool inside = light == FLOOR_SPHERE && x * x + y * y < (real)0.64;
        sum += inside ? 0 : (double)floor_exact(light, x, y);
    }
    return sum / (parts * parts);
}

/* Counts in all cells against the closed form at once, by chi-square. Cells through which the
 * border of the sphere or of the light's plane passes have a mean that 4 x 4 points know to some
 * percent: left out. */
static void test_floors(void)
{
    const size_t n = 200000;
    for (int light = 0; light < floor_lights; light++) {
        enum { cells = floor_cells * floor_cells };
        uint32_t *count = allocate(cells, sizeof *count);
        double *o = allocate(cells + 1, sizeof *o), *e = allocate(cells + 1, sizeof *e);
        double counted = 0, expected = 0;
        floor_photons((floor_light)light, 3, 0, n, count);
        for (int k = 0; k < cells; k++) {
            int i = k % floor_cells, j = k / floor_cells;
            double x = (i + 0.5) / floor_cells * 8 - 4, y = (j + 0.5) / floor_cells * 8 - 4;
            double r = sqrt(x * x + y * y), fill = floor_mean((floor_light)light, i, j, 4);
            bool border = light == FLOOR_SPHERE ? fabs(r - 0.8) < 0.1
                        : light == FLOOR_RECTANGLE && fabs(x - (double)screen.o.x) < 0.2;
            if (border) continue;
            o[k] = count[k], e[k] = floor_expected((floor_light)light, fill, (double)n);
            counted += o[k], expected += e[k];
        }
        o[cells] = (double)n - counted, e[cells] = (double)n - expected;  /* those elsewhere */
        check_at_least(chi_square_test(o, e, cells + 1).p, alarm, "floor %d: photons", light);
        check_at_least(counted, 0.05 * (double)n, "floor %d: many of them arrive", light);
        check_close(counted, expected, 6 * sqrt(expected), "floor %d: all of them", light);
        /* a fifth more light than closed form has: the test sees it */
        for (int k = 0; k < cells; k++) e[k] *= 1.2;
        e[cells] = (double)n - 1.2 * expected;
        check_at_most(chi_square_test(o, e, cells + 1).p, alarm, "floor %d: a fifth is seen",
                      light);
        free(count), free(o), free(e);
    }
    real inside = floor_exact(FLOOR_SPHERE, 0, 0);
    check_close((double)inside, PI, 4 * eps, "inside of the sphere: pi L");
    check_equal(floor_exact(FLOOR_RECTANGLE, screen.o.x - 1, 0), 0, "behind the rectangle");
    /* one step from the screen that stands on the floor: E = L times a half of pi */
    double near = (double)floor_exact(FLOOR_RECTANGLE, screen.o.x + (real)0x1p-12, 0);
    check_close(near, PI / 2, 0x1p-10, "touching light: half of all directions");
}

/* Pixels: of n x n, those that a border of length 10 or so crosses, 5 n, are right with chance 1/2:
 * an area is off by about sqrt(5 n) / 2 pixels, 6 times that is allowed. */
static void test_view(void)
{
    enum { n = 400 };
    const triangle front = {view_triangle.a, view_triangle.c, view_triangle.b};
    const double closed[view_maps][view_things] = {  /* 0: none known, of a sphere cut in two */
        {(double)sphere_solid_angle(view_sphere[0], seen_from), 0,
         (double)fabs(rectangle_solid_angle(view_square, seen_from)),
         (double)fabs(triangle_solid_angle(view_triangle, seen_from))},
        {(double)sphere_irradiance(view_sphere[0], seen_from, seen_up),
         (double)sphere_irradiance(view_sphere[1], seen_from, seen_up),
         rectangle_irradiance_exact(view_square, seen_from, seen_up),
         triangle_irradiance_exact(front, seen_from, seen_up)}};
    for (int m = 0; m < view_maps; m++) {
        double count[view_things] = {0}, side = 2 * (double)view_scale((radiometry_map)m) / n;
        double length = 0;
        vec3 w;
        for (int i = 0; i < n * n; i++) {
            real x = (2 * (real)(i % n) + 1) / n - 1, y = (2 * (real)(i / n) + 1) / n - 1;
            if (!view_direction((radiometry_map)m, x, y, &w)) continue;
            length = check_worse(length, fabs((double)vlength(w) - 1));
            int k = view_met(w);
            if (k >= 0) count[k]++;
        }
        for (int k = 0; k < view_things; k++)
            if (closed[m][k] != 0)
                check_close(count[k] * side * side, closed[m][k], 3 * sqrt(5.0 * n) * side * side,
                            "thing %d, map %d", k, m);
        check_at_most(length, 4 * eps, "unit length");
        check(!view_direction((radiometry_map)m, 1, 0.1, &w), "outside of the hemisphere");
    }
}

/* ---- four ways to one number ---- */

static void test_ways(void)
{
    size_t n = check_count(100000);
    double variance[radiometry_lights][direction_ways];
    radiometry_seen k = radiometry_seen_of(seen_from);
    for (int l = 0; l < radiometry_lights; l++)
        for (int b = 0; b < direction_ways; b++) {
            estimate e = {0};
            for (size_t i = 0; i < n; i++) {
                random_stream s = random_start(9, (uint64_t)(l * direction_ways + b), i);
                real u = random_next(&s), v = random_next(&s);
                e = estimate_add(e, (double)direction_sample((radiometry_light)l, (direction_way)b,
                                                             &k, u, v));
            }
            double exact = direction_exact((radiometry_light)l);
            check_at_least(t_test(e, exact, 16 * eps), alarm, "%s by %s", radiometry_light_name[l],
                           direction_name[b]);
            variance[l][b] = estimate_variance(e) / (exact * exact);
        }
    for (int l = 0; l < radiometry_lights; l++) {
        check_at_most(variance[l][BY_COSINE], 0.8 * variance[l][BY_HEMISPHERE], "cosine helps");
        check_at_most(variance[l][BY_SOLID_ANGLE], 0.1 * variance[l][BY_AREA],
                      "%s: solid angle beats area tenfold", radiometry_light_name[l]);
    }
    /* by cosine: hits of probability E/pi, weight pi: variance / E^2 = pi / E - 1 */
    for (int l = 0; l < radiometry_lights; l++)
        check_close(variance[l][BY_COSINE] / (PI / direction_exact((radiometry_light)l) - 1), 1,
                    0.1, "variance by cosine, in closed form");
}

int main(void)
{
    return check_all("22_radiometry", test_relations, test_closed, test_floors, test_view,
                     test_ways);
}
