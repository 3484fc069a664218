/* embree.c: the tree eight wide, and 14's, against Embree 3, where that is installed (Debian:
 * libembree-dev).
 *
 *   make embree                   teapots of 102,080 and 999,000 triangles, a soup of a million
 *   make embree MESH=FILE.obj     that mesh, too
 *   build/embree --quick          the small teapot alone
 *
 * Both get the same corners and rays, all floats, one thread; both in one program and in turn, and
 * a ratio is the median of those of neighbours in time. Each first takes the same rays some times
 * untimed: after one such pass a million triangles were still half in the cache of the one before.
 * Embree in its default settings. Primary rays fill the frame, diffuse and shadow rays begin where
 * these hit. Nothing else needs this.
 */
#include "../../../common/posix.h"
#include <embree3/rtcore.h>
#include "../../07_mesh/files/obj.h"
#include "../../07_mesh/scenes/soup.h"
#include "../../07_mesh/scenes/teapot.h"
#include "../../../common/lab/bench.h"
#include "../../../common/lab/report.h"
#include "../../14_bvh/bvh.h"
#include "leaky.h"

enum { rays_a_kind = 50000, kinds = 3, rivals = 7, warm_ups = 3, most_rounds = 11 };
typedef struct { RTCScene rtc; bvh8 wide; bvh two; } trees;
typedef bool search(const trees *t, ray r, hit *out);
typedef struct { const trees *of; search *ask; const ray *r; bool any; size_t hits; } pass;
typedef struct { float t; uint32_t shape; } answer;
static answer answers[rays_a_kind];  /* both write them down */

/* Two searches of one of the trees: the closest hit, and any. */
#define SEARCHES(name, tree, closest, any)                                                       \
    static bool name(const trees *t, ray r, hit *out) { return closest(&t->tree, r, out); }      \
    static bool name##_any(const trees *t, ray r, hit *out)                                      \
    {                                                                                            \
        return *out = hit_none, any(&t->tree, r);                                                \
    }
SEARCHES(tight, wide, bvh8_hit, bvh8_occluded)
SEARCHES(leaky, wide, bvh8_hit_leaky, bvh8_occluded_leaky)
SEARCHES(binary, two, bvh_hit, bvh_occluded)

static double run_ours(void *context)
{
    pass *p = context;
    p->hits = 0;
    for (size_t i = 0; i < rays_a_kind; i++) {
        hit h = hit_none;
        p->hits += p->ask(p->of, p->r[i], &h);
        answers[i] = (answer){(float)h.t, h.shape};
    }
    return (double)p->hits;
}

static double run_embree(void *context)
{
    pass *p = context;
    struct RTCIntersectContext c;
    rtcInitIntersectContext(&c);
    p->hits = 0;
    for (size_t i = 0; i < rays_a_kind; i++) {
        const ray r = p->r[i];
        struct RTCRayHit q = {
            .ray = {(float)r.o.x, (float)r.o.y, (float)r.o.z, (float)r.tmin, (float)r.d.x,
                    (float)r.d.y, (float)r.d.z, 0, (float)r.tmax, ~0u, 0, 0},
            .hit = {.geomID = RTC_INVALID_GEOMETRY_ID, .primID = ~0u}};
        if (p->any) rtcOccluded1(p->of->rtc, &c, &q.ray);
        else rtcIntersect1(p->of->rtc, &c, &q);
        answers[i] = (answer){q.ray.tfar, q.hit.primID};
        p->hits += p->any ? q.ray.tfar < 0 : q.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    }
    return (double)p->hits;
}

/* ---------------------------------------------------------------------------------------------- */

static bool count_bytes(void *sum, ssize_t bytes, bool after)
{
    (void)after;
    *(ssize_t *)sum += bytes;
    return true;
}

/* *bytes: of the tree, without the arrays of the mesh. */
static RTCScene embree_build(RTCDevice device, const mesh *m, ssize_t *bytes, double *seconds)
{
    RTCScene rtc = rtcNewScene(device);
    RTCGeometry g = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    float *v = rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12,
                                       m->vertices);
    uint32_t *index = rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12,
                                              m->triangles);
    for (size_t i = 0; i < 3 * m->vertices; i++)
        v[i] = (float)vaxis(m->v[i / 3], (int)(i % 3));
    memcpy(index, m->index, 12 * m->triangles);
    ssize_t before = *bytes;
    double start = clock_seconds();
    rtcCommitGeometry(g), rtcAttachGeometry(rtc, g), rtcCommitScene(rtc);
    *seconds = clock_seconds() - start;
    *bytes -= before;
    rtcReleaseGeometry(g);
    return rtc;
}

static vec3 floats(vec3 p) { return (vec3){(real)(float)p.x, (real)(float)p.y, (real)(float)p.z}; }

/* Of all kinds, primary first; the others from where the primary ones hit. */
static void make_rays(const mesh *m, const bvh8 *w, ray r[kinds][rays_a_kind])
{
    vec3 lo, hi;
    mesh_bounds(m, &lo, &hi);
    vec3 centre = vscale(vadd(lo, hi), (real)0.5), aim = vunit(vec(0.5, 0.35, 1));
    real radius = vlength(vsub(hi, lo)) / 2;
    vec3 eye = floats(vmadd(centre, aim, radius * (real)2.2));
    vec3 u = vunit(vcross(vec(0, 1, 0), aim)), v = vcross(aim, u);
    size_t side = (size_t)ceil(sqrt(rays_a_kind)), n = 0;
    for (size_t i = 0; i < rays_a_kind || n < rays_a_kind; i++) {
        random_stream g = random_start(15, i, 0);
        real x = ((real)(2 * (i % side) + 1) / (real)side - 1) * (real)0.27;
        real y = (1 - (real)(2 * (i / side % side) + 1) / (real)side) * (real)0.27;
        ray p = ray_from(eye, floats(vunit(vsub(vadd(vscale(u, x), vscale(v, y)), aim))));
        hit h;
        if (i < rays_a_kind) r[0][i] = p;
        if (n >= rays_a_kind || !bvh8_hit(w, p, &h)) continue;
        vec3 normal = triangle_normal(mesh_triangle(m, h.shape));
        vec3 ball = vunit(random_in_cube(&g, 1));
        if (vdot(normal, p.d) > 0) normal = vneg(normal);
        vec3 from = floats(vmadd(ray_at(p, h.t), normal, radius * (real)1e-4));
        r[1][n] = ray_from(from, floats(vunit(vmadd(normal, ball, (real)0.9999))));
        r[2][n] = ray_from(from, floats(vsub(vmadd(centre, ball, 3 * radius), from)));
        r[2][n++].tmax = 1;
    }
}

/* ---------------------------------------------------------------------------------------------- */

typedef struct { const char *name; eight_dialect dialect; search *ask[2]; } rival;  /* any hit: 1 */
static const rival rival_of[rivals] = {
    {"Embree", EIGHT_PLAIN, {NULL, NULL}},
    {"AVX-512", EIGHT_AVX512, {tight, tight_any}},
    {"AVX2", EIGHT_AVX2, {tight, tight_any}},
    {"plain C", EIGHT_PLAIN, {tight, tight_any}},
    {"leaky AVX-512", EIGHT_AVX512, {leaky, leaky_any}},
    {"leaky AVX2", EIGHT_AVX2, {leaky, leaky_any}},
    {"14: two wide", EIGHT_PLAIN, {binary, binary_any}}};
static double product[kinds][rivals];  /* of logarithms */

static void compare(const char *name, const mesh *m, const trees *of, int rounds, table *t)
{
    static ray rays[kinds][rays_a_kind];
    static const char *const kind[kinds] = {"primary", "diffuse", "shadow"};
    trees as[rivals];
    make_rays(m, &of->wide, rays);
    for (int k = 0; k < kinds; k++) {
        pass p[rivals];
        bench_candidate c[rivals];
        for (int i = 0; i < rivals; i++) {
            const rival *one = &rival_of[i];
            as[i] = *of;
            if (one->dialect < of->wide.dialect) as[i].wide.dialect = one->dialect;
            p[i] = (pass){&as[i], one->ask[k == 2], rays[k], k == 2, 0};
            c[i] = (bench_candidate){.name = one->name, .run = i ? run_ours : run_embree,
                                     .context = &p[i]};
        }
        double ratio[rivals][most_rounds], seconds = 0;
        for (int round = -1; round < rounds; round++)
            for (int i = 0; i < rivals; i++) {
                for (int j = 0; j < warm_ups; j++) bench_once(&c[i]);
                double now = bench_once(&c[i]);
                if (i == 0) seconds = now;
                if (round >= 0) ratio[i][round] = i ? seconds / now : now;
            }
        table_text(t, "%s", name), table_text(t, "%s", kind[k]);
        table_count(t, p[0].hits), table_count(t, p[1].hits);
        table_number(t, clock_median(ratio[0], rounds) / rays_a_kind * 1e9);
        for (int i = 1; i < rivals; i++) {
            double median = clock_median(ratio[i], rounds);
            table_text(t, "%.2f", median);
            product[k][i] += log(median);
        }
    }
}

static void build_all(const char *name, mesh *m, int rounds, table *searches, table *builds)
{
    ssize_t bytes = 0;
    double ours[9], theirs[9], start;
    int turns = rounds < 5 ? rounds : 5;
    trees t = {.rtc = NULL};
    RTCDevice device = rtcNewDevice("threads=1,set_affinity=0");
    failure f;
    bvh8_options how = bvh8_defaults;
    how.threads = 1;
    for (size_t i = 0; i < m->vertices; i++) m->v[i] = floats(m->v[i]);
    items x = items_of_mesh(m);
    rtcSetDeviceMemoryMonitorFunction(device, count_bytes, &bytes);
    for (int k = 0; k < turns; k++) {
        if (t.rtc) rtcReleaseScene(t.rtc);
        t.rtc = embree_build(device, m, &bytes, &theirs[k]);
        bvh8_free(&t.wide);
        start = clock_seconds();
        if (!bvh8_build(&x, how, &t.wide, &f)) fail(f);
        ours[k] = clock_seconds() - start;
    }
    if (!bvh_build(&x, bvh_defaults, &t.two, &f)) fail(f);
    double mine = clock_median(ours, turns), its = clock_median(theirs, turns);
    table_text(builds, "%s", name), table_count(builds, m->triangles);
    table_number(builds, (double)t.wide.room.bytes / (double)m->triangles);
    table_number(builds, (double)bytes / (double)m->triangles);
    table_number(builds, mine * 1e3), table_number(builds, its * 1e3);
    table_text(builds, "%.2f", mine / its);
    compare(name, m, &t, rounds, searches);
    rtcReleaseScene(t.rtc), rtcReleaseDevice(device);
    bvh8_free(&t.wide), bvh_free(&t.two), mesh_free(m);
}

int main(int argc, char **argv)
{
    const char *path = NULL;
    const option list[] = {{"mesh", OPTION_INPUT, &path, 0, 0, "FILE.obj: this mesh, too"}, {0}};
    options o = options_read(argc, argv, "embree", "The tree eight wide against Embree.",
                             (options){.seed = 1}, list);
    failure f;
    mesh m;
    int rounds = o.quick ? 5 : most_rounds, meshes = 0;
    table searches = table_new("How many times as fast as Embree", "mesh|rays|hits Embree|hits|"
        "time Embree [ns]|AVX-512|AVX2|plain C|leaky AVX-512|leaky AVX2|14: two wide");
    table builds = table_new("Building, one thread", "mesh|triangles|bytes|bytes Embree|"
        "time [ms]|time Embree [ms]|time ratio");
    table means = table_new("Geometric means",
                            "rays|AVX-512|AVX2|plain C|leaky AVX-512|leaky AVX2|14: two wide");
    if (path && !obj_read(path, &m, &f)) fail(f);
    if (path) build_all(strrchr(path, '/') ? strrchr(path, '/') + 1 : path, &m, rounds, &searches,
                         &builds), meshes++;
    for (int k = 0; k < (o.quick ? 1 : 3); k++, meshes++) {
        m = k == 2 ? soup_mesh(1000000, 1, (real)0.01, 1) : teapot_mesh(k ? 125 : 40);
        build_all(k == 2 ? "soup" : "teapot", &m, rounds, &searches, &builds);
    }
    for (int k = 0; k < kinds; k++) {
        table_text(&means, "%s", k == 0 ? "primary" : k == 1 ? "diffuse" : "shadow");
        for (int i = 1; i < rivals; i++) table_text(&means, "%.2f", exp(product[k][i] / meshes));
    }
    output_table(&o, &searches), output_table(&o, &builds), output_table(&o, &means);
    return 0;
}
