/* 19_spd: rays counted by the protocol, against counts by brute force and against reason; the
 * program from outside. */
#include "check.h"
#include "program.h"
#include "../chapters/19_whitted/lab/spd_protocol.h"
#include <unistd.h>

/* Everything is asked of every shape; the recursion is one, and a ray's kind is not known before it
 * is needed. Only ways to begin a ray are shared with what is tested. */
typedef struct {
    const world *w;
    scene s;
    size_t primary, hits, shadow, blocked, reflected, refracted;
} brute_count;

static void brute_ray(brute_count *c, ray r, int depth)
{
    hit h;
    if (!(c->w->n ? scene_hit(&c->s, r, &h) : mesh_hit(&c->w->mesh, r, &h))) return;
    if (depth == 1) c->hits++;
    surface s = c->w->n ? surface_of_shape(&c->s.shapes[h.shape], r, h)
                        : surface_of_mesh(&c->w->mesh, h);
    finish f = world_finish(c->w, h.shape);
    bool in = vdot(s.n, r.d) < 0;
    if (!in) s.n = vneg(s.n);
    for (int i = 0; i < c->w->lights; i++)
        if (vdot(s.n, vsub(c->w->light[i], s.p)) > 0) {
            ray to = leave_to(s, c->w->light[i]);
            c->shadow++;
            c->blocked += c->w->n ? scene_occluded(&c->s, to) : mesh_occluded(&c->w->mesh, to);
        }
    if (depth == 5) return;
    real ratio = f.ior > 0 ? in ? 1 / f.ior : f.ior : 1, cosine = -vdot(s.n, r.d);
    real sine = ratio * sqrt(real_max(0, 1 - cosine * cosine));
    bool total = f.transmit > 0 && sine > 1;
    if (f.transmit > 0 && !total) {
        real across = ratio * cosine - sqrt(1 - sine * sine);
        vec3 w = vunit(vmadd(vscale(r.d, ratio), s.n, across));
        c->refracted++;
        brute_ray(c, (ray){leave_point(s, vneg(s.n), 0), 0, w, real_infinity}, depth + 1);
    }
    if (f.ks > 0 || total) {
        vec3 w = vunit(vmadd(r.d, s.n, 2 * cosine));
        c->reflected++;
        brute_ray(c, (ray){leave_point(s, s.n, 0), 0, w, real_infinity}, depth + 1);
    }
}

/* Directions differ in the last bits: of many rays some pass an edge on its other side. */
static void test_counts(void)
{
    static const struct { const char *name; int scale; } scenes[] = {
        {"balls", 1}, {"gears", 1}, {"mount", 2}, {"rings", 1}, {"tetra", 3}, {"tree", 3},
        {"teapot", 2}};
    int edge = check_count(100) == 100 ? 24 : 6;
    for (size_t k = 0; k < sizeof scenes / sizeof *scenes; k++) {
        world w;
        failure f;
        trace_counts c;
        check(spd_world(scenes[k].name, scenes[k].scale, &w, &f), "made");
        brute_count b = {.w = &w, .s = world_scene(&w)};
        for (int j = 0; j <= edge; j++)
            for (int i = 0; i <= edge; i++, b.primary++) {
                real x = (real)(2 * i) / (real)edge - 1, y = 1 - (real)(2 * j) / (real)edge;
                brute_ray(&b, ray_unit(world_ray(&w, x, y)), 1);
            }
        check(spd_count_scene(&w, edge, 2, &c), "counted");
        const size_t got[] = {c.rays[RAY_CAMERA], c.hits[RAY_CAMERA],
                              c.rays[RAY_SHADOW], c.hits[RAY_SHADOW],
                              c.rays[RAY_REFLECTION], c.rays[RAY_REFRACTION]};
        const size_t want[] = {b.primary, b.hits, b.shadow, b.blocked, b.reflected, b.refracted};
        static const char *const what[] = {"primary", "hits", "shadow", "shadow hits", "reflected",
                                           "refracted"};
        for (int i = 0; i < 6; i++)
            check_close((double)got[i], (double)want[i], i < 2 ? 0 : 2 + 0.02 * (double)want[i],
                        "%s: %s", scenes[k].name, what[i]);
        world_free(&w);
    }
}

/* Inside glass that has no Ks: beyond the critical angle all goes with the reflection. */
static void test_total(void)
{
    finish glass = {{1, 1, 1}, 0.2, 0, 0, 0.8, 1.5};
    surface s = {{0, 0, 0}, {0, 0, 1}, {0, 0, 1}, 0, 0, 0};
    vec3 d = vec(0.8, 0, -0.6), w;
    bool mirrors;
    check(!spd_bends(&glass, &s, d, false, &w, &mirrors) && mirrors, "reflected");
    check(spd_bends(&glass, &s, d, true, &w, &mirrors) && !mirrors,
          "from outside: refracted; Ks = 0: no reflection");
}

static void test_program(void)
{
    check_equal(run("19_whitted", "--protocol spd --scene balls --scale 1 --quick"), 0, "counts");
    check(printed("out", "primary balls 1: rays 1089"), "primary");
    check(printed("out", "shadow balls 1: rays "), "shadow");
    check(printed("out", "secondary balls 1: reflected "), "secondary");
    static const struct { const char *what, *says; } wrong[] = {
        {"--protocol nff", "allowed is spd"}, {"--protocol spd --scene lattice", "balls, gears"},
        {"--protocol spd --scene balls --scale 7", "balls"},
        {"--scene balls", "allowed with --protocol"},
        {"--protocol spd --csv x", ": not allowed with --protocol"},
        {"--protocol spd --out x.png", ": not allowed with --protocol"},
        {"--protocol spd --spend-all", ": not allowed with --protocol"}};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        check_equal(run("19_whitted", wrong[i].what), 2, "%s", wrong[i].what);
        check(printed("err", wrong[i].says), "says so: %s", wrong[i].what);
    }
}

int main(void)
{
    if (!mkdtemp(directory)) return 1;
    test_counts();
    test_total();
    test_program();
    remove_directory();
    return check_report("19_spd");
}
