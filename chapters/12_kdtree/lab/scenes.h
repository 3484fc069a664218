/* scenes.h: two scenes that show what the teapot does not: squares in dyadic planes, where textbook
 * searches lose hits; and the teapot in a stadium, where triangles are not alike. */
#ifndef KDTREE_SCENES_H
#define KDTREE_SCENES_H

#include "../../07_mesh/scenes/stadium.h"
#include "measure.h"

static inline void table_of_planes(const options *o);
static inline void table_of_stadium(const options *o);

/* ---------------------------------------------------------------------------------------------- */

/* Three planes x, y, z = -1, -1/2, .. 1, of 4 x 4 squares each, cut in two. */
static inline mesh planes_mesh(void)
{
    mesh m = {.vertices = 125, .triangles = 480};
    m.v = allocate(m.vertices, sizeof *m.v);
    m.index = allocate(3 * m.triangles, sizeof *m.index);
    for (int i = 0; i < 125; i++)
        m.v[i] = (vec3){(real)(i % 5) / 2 - 1, (real)(i / 5 % 5) / 2 - 1, (real)(i / 25) / 2 - 1};
    static const uint32_t step[3] = {1, 5, 25};
    uint32_t *at = m.index;
    for (int k = 0; k < 3; k++)
        for (uint32_t i = 0; i < 80; i++) {
            uint32_t u = step[(k + 1) % 3], v = step[(k + 2) % 3];
            uint32_t a = i / 16 * step[k] + i % 4 * u + i / 4 % 4 * v;
            uint32_t corner[6] = {a, a + u, a + u + v, a, a + u + v, a + v};
            memcpy(at, corner, sizeof corner), at += 6;
        }
    return m;
}

/* Rays on which nothing is rounded, or rays from anywhere at corners. */
static inline ray_set rays_at_planes(const mesh *m, size_t n, bool dyadic, uint64_t seed)
{
    ray_set s = {allocate(n, sizeof(ray)), n};
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(seed, i, 4);
        vec3 at = m->v[random_next_bits(&g) % m->vertices];
        vec3 o = {4 * random_next(&g) - 2, 4 * random_next(&g) - 2, 4 * random_next(&g) - 2};
        s.r[i] = dyadic ? kd_dyadic_ray(&g) : ray_from(o, vsub(at, o));
    }
    return s;
}

static inline void table_of_planes(const options *o)
{
    static const struct { const char *name; kd_searcher *search; } shown[4] = {
        {"first hit final", kdtree_hit_naive_final}, {"strict", kdtree_hit_naive_strict},
        {"textbook", kdtree_hit_textbook}, {"padded", kdtree_hit}};
    mesh m = planes_mesh();
    items x = items_of_mesh(&m);
    size_t n = o->quick ? 500 : 20000;
    kdtree both, one;
    char title[100];
    snprintf(title, sizeof title, "Squares in dyadic planes, cut in the middle: wrong of %zu rays",
             n);
    table out = table_new(title, "search|dyadic rays, both sides|dyadic rays, one side|"
                                 "rays at corners, both sides|rays at corners, one side");
    kdtree_options how = KD_HOW(KD_MIDDLE, 0, true, KD_BOTH);
    how.leaf = 1;
    build_or_fail(&x, how, &both);
    how.planar = KD_ONE;
    build_or_fail(&x, how, &one);
    hit *brute = allocate(2 * n, sizeof *brute);
    ray_set rays[2];
    for (size_t k = 0; k < 2; k++) {
        rays[k] = rays_at_planes(&m, n, k == 0, o->seed);
        for (size_t i = 0; i < n; i++)
            if (!items_hit(&x, rays[k].r[i], &brute[k * n + i])) brute[k * n + i] = hit_none;
    }
    for (int i = 0; i < 4; i++) {
        table_text(&out, "%s", shown[i].name);
        for (size_t k = 0; k < 2; k++) {
            table_count(&out, rays_wrong(&both, shown[i].search, &rays[k], brute + k * n));
            table_count(&out, rays_wrong(&one, shown[i].search, &rays[k], brute + k * n));
        }
    }
    output_extra_table(o, &out);
    rays_free(&rays[0]), rays_free(&rays[1]);
    kdtree_free(&both), kdtree_free(&one);
    mesh_free(&m);
    free(brute);
}

static inline void table_of_stadium(const options *o)
{
    mesh pot = teapot_mesh(1);
    subject s;
    trial t[structures];
    double seconds[structures];
    table out = table_new("The teapot in a stadium: diffuse rays from the teapot",
                          "structure|depth|references/tri|empty leaves [%]|nodes/ray|leaves/ray|"
                          "tests/ray|ray [ns]");
    subject_init(&s, stadium_mesh(o->quick ? 4 : 16), view_of_mesh(&pot, 1.6),
                 o->quick ? 40 : 160, 0, o->seed);
    for (int i = 0; i < structures; i++) {
        t[i] = (trial){&s, &candidate_list[i], &s.diffuse, {0}};
        run_build(&t[i]);
    }
    time_trials(t, structures, run_search, o->quick ? 1 : 3, seconds);
    for (int i = 0; i < structures; i++) {
        table_text(&out, "%s", t[i].c->name);
        row_of_work(&out, &t[i].t, rays_count(&t[i].t, &s.diffuse), s.diffuse.n);
        table_number(&out, per(seconds[i] * 1e9, s.diffuse.n));
        kdtree_free(&t[i].t);
    }
    output_extra_table(o, &out);
    mesh_free(&pot);
    subject_free(&s);
}

#endif
