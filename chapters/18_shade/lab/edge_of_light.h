/* edge_of_light.h: a ball as a mesh of few triangles, smoothed: how well is its edge of light?
 *
 *   table_of_terminator(&o)     error against time, against the round ball that it stands for
 *   draw_terminator(&o)         four ways to light it
 */
#ifndef SHADE_LAB_EDGE_OF_LIGHT_H
#define SHADE_LAB_EDGE_OF_LIGHT_H

#include "../../../common/lab/bench.h"
#include "../../../common/lab/label.h"
#include "../../../common/lab/report.h"
#include "../terminator.h"

enum { edge_ways = 4 };
static const char *const edge_way[edge_ways] = {"both normals", "shading normal alone", "faded",
                                                "lifted"};

typedef struct { mesh m; world_part part; trace_world w; light sun; } edge_ball;

/* ---------------------------------------------------------------------------------------------- */

/* Radius 1, `rings` of quads from pole to pole, twice as many round it; normals are those of the
 * ball. Poles are along y, out of the eye's way. */
static inline mesh edge_ball_mesh(int rings)
{
    int round = 2 * rings, n = 0;
    mesh m = {.vertices = (size_t)(rings + 1) * (size_t)(round + 1)};
    m.v = allocate(m.vertices, sizeof *m.v);
    m.n = allocate(m.normals = m.vertices, sizeof *m.n);
    m.index = allocate(6 * (size_t)rings * (size_t)round, sizeof *m.index);
    for (int j = 0; j <= rings; j++)
        for (int i = 0; i <= round; i++) {
            real a = pi * (real)j / (real)rings, b = 2 * pi * (real)(i % round) / (real)round;
            m.v[n] = m.n[n] = (vec3){sin(a) * cos(b), cos(a), sin(a) * sin(b)}, n++;
        }
    for (int j = 0; j < rings; j++)
        for (int i = 0; i < round; i++) {
            uint32_t a = (uint32_t)(j * (round + 1) + i), b = a + (uint32_t)round + 1;
            const uint32_t two[6] = {a, a + 1, b, a + 1, b + 1, b};
            for (int k = 0; k < 6; k += 3) {
                if ((k == 0 && j == 0) || (k == 3 && j == rings - 1)) continue;  /* a pole */
                memcpy(m.index + 3 * m.triangles++, two + k, 3 * sizeof *two);
            }
        }
    return m;
}

static inline void edge_ball_build(edge_ball *b, int rings)
{
    *b = (edge_ball){.m = edge_ball_mesh(rings),
                     .sun = {LIGHT_DIRECTIONAL, vunit(vec(1, 0.25, 0.2)), {1, 1, 1}}};
    world_part_of_mesh(&b->m, MASK_ALL, &b->part);
    b->w = (trace_world){&b->part, 1};
}

static inline void edge_ball_free(edge_ball *b)
{
    world_part_free(&b->part);
    mesh_free(&b->m);
}

/* Irradiance at the hit x of r, shadow ray and all. */
static inline real edge_light(tracer *t, const light *sun, ray r, trace_hit x, int way)
{
    surface s = way == 3 ? terminator_surface(t, r, x) : surface_of_trace(t, r, x);
    light_sample a;
    shade_lit answer = {false};
    s = surface_facing(s, r.d);
    if (!light_reaches(sun, s.p, way == 1 ? s.ns : s.n, s.ns, &a)) return 0;
    trace(t, RAY_SHADOW, leave(s, a.l), &answer);
    if (!answer.lit) return 0;
    return way == 2 ? a.E.x * terminator_fade(s.n, s.ns, a.l) : a.E.x;
}

static inline ray edge_eye_ray(int x, int y, int size)
{
    real s = (real)2.1 / (real)size;
    return ray_from((vec3){((real)x + (real)0.5) * s - (real)1.05,
                           (real)1.05 - ((real)y + (real)0.5) * s, 4}, (vec3){0, 0, -1});
}

static inline real edge_pixel(const edge_ball *b, tracer *t, int x, int y, int size, int way,
                              vec3 *p)
{
    ray r = edge_eye_ray(x, y, size);
    trace_hit met = {hit_none, 0};
    if (!bvh8_hit(&b->part.tree, r, &met.h)) return -1;
    *p = ray_at(r, met.h.t);
    return edge_light(t, &b->sun, r, met, way);
}

typedef struct { const edge_ball *b; int way, size; size_t asked; } edge_run;

static inline double edge_time(void *context)
{
    edge_run *k = context;
    tracer t = {.w = &k->b->w, .program = shade_programs};
    double sum = 0;
    vec3 p;
    k->asked = 0;
    for (int i = 0; i < k->size * k->size; i++) {
        real E = edge_pixel(k->b, &t, i % k->size, i / k->size, k->size, k->way, &p);
        if (E >= 0) sum += (double)E, k->asked++;
    }
    return sum;
}

/* The truth at p: what the round ball gets at the same place of its surface. */
static inline void edge_errors(const edge_ball *b, int size, int way, double *rmse, double *most,
                               double *dark)
{
    tracer t = {.w = &b->w, .program = shade_programs};
    size_t n = 0, lit = 0, lost = 0;
    vec3 p;
    *rmse = *most = 0;
    for (int i = 0; i < size * size; i++) {
        real E = edge_pixel(b, &t, i % size, i / size, size, way, &p);
        if (E < 0) continue;
        double truth = fmax(0, (double)vdot(vunit(p), b->sun.at)), off = fabs((double)E - truth);
        *rmse += off * off, *most = fmax(*most, off), n++;
        lit += truth > 0, lost += truth > 0 && E == 0;
    }
    *rmse = sqrt(*rmse / (double)n), *dark = 100 * (double)lost / (double)lit;
}

static inline void table_of_terminator(const options *o)
{
    int size = o->quick ? 40 : 160;
    table t = table_new("The edge of light on a ball of 8 and of 32 rings of quads, irradiance 1",
                        "way|error: 8, rmse|error: 8, most|error: dark [% of lit]|"
                        "error: 32, rmse|time [ns/pixel]");
    edge_ball b[2];
    edge_run run[edge_ways];
    double ns[edge_ways];
    edge_ball_build(&b[0], 8), edge_ball_build(&b[1], 32);
    for (int k = 0; k < edge_ways; k++) run[k] = (edge_run){&b[0], k, size, 0};
    bench_each(edge_time, run, sizeof *run, edge_ways, o->quick ? 1 : 7, 1e9, ns);
    for (int k = 0; k < edge_ways; k++) {
        double rmse[2], most[2], dark[2];
        for (int i = 0; i < 2; i++) edge_errors(&b[i], size, k, &rmse[i], &most[i], &dark[i]);
        table_text(&t, "%s", edge_way[k]), table_number(&t, rmse[0]), table_number(&t, most[0]);
        table_number(&t, dark[0]), table_number(&t, rmse[1]);
        table_number(&t, ns[k] / (double)run[k].asked);
    }
    output_extra_table(o, &t);
    edge_ball_free(&b[0]), edge_ball_free(&b[1]);
}

static inline void draw_terminator(const options *o)
{
    enum { gap = 6, fine = 2 };
    int size = o->quick ? 60 : 240;
    image all = image_new(edge_ways * size + (edge_ways - 1) * gap, size);
    edge_ball b;
    edge_ball_build(&b, 8);
    tracer t = {.w = &b.w, .program = shade_programs};
    for (int k = 0; k < edge_ways; k++)
        for (int i = 0; i < size * size; i++) {
            real sum = 0;
            vec3 p;
            for (int j = 0; j < fine * fine; j++) {
                int x = i % size * fine + j % fine, y = i / size * fine + j / fine;
                real E = edge_pixel(&b, &t, x, y, fine * size, k, &p);
                sum += E < 0 ? (real)0.7 : (real)0.02 + (real)0.75 * E;
            }
            sum /= fine * fine;
            image_set(&all, k * (size + gap) + i % size, i / size, (vec3){sum, sum, sum});
        }
    label_titles(&all, edge_ways, 1, gap, edge_way);
    output_picture(o, &all, "18_shade_terminator.png", false, true);
    image_free(&all), edge_ball_free(&b);
}

#endif
