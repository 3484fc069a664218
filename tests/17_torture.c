/* The exact cases of --torture: is the oracle exact, and does it tell right from wrong? */
#include "check.h"
#include "../chapters/07_mesh/scenes/as_first.h"
#include "../chapters/14_bvh/bvh.h"
#include "../chapters/09_aabb/trials/torture.h"

/* All fractions of small whole numbers, against their cross products. */
static void test_less(void)
{
    size_t wrong = 0;
    for (int a = -7; a <= 7; a++)
        for (int b = 1; b <= 9; b++)
            for (int c = -7; c <= 7; c++)
                for (int d = 1; d <= 9; d++)
                    wrong += torture_less((torture_t){a, b}, (torture_t){c, d}) != (a * d < c * b);
    check_equal(wrong, 0, "fractions compared by their quotients");
    torture_int n = (torture_int)1 << (3 * torture_bits);  /* products of two would not fit */
    check(torture_less((torture_t){n - 2, n - 1}, (torture_t){n - 1, n}), "1 - 1/(n-1) < 1 - 1/n");
    check(!torture_less((torture_t){n - 1, n}, (torture_t){n - 2, n - 1}), "and not the reverse");
    torture_t f = torture_fraction((real)-2.75);
    check(f.num == -11 && f.den == 4, "-2.75 = -11 / 4");
}

/* One triangle, x y <= 4 in the plane z = 1, met from below where it is known by hand. */
static void test_meet(void)
{
    static const struct { real x, y; int met, share; } list[] = {
        {1, 1, true, 6}, {2, 0, true, 3}, {2, 2, true, 3}, {0, 0, true, 1}, {4, 0, true, 1},
        {3, 2, false, 0}, {-1, 1, false, 0}, {1, -1, false, 0}};
    mesh m = mesh_room(1);
    m.v[0] = vec(0, 0, 1), m.v[1] = vec(4, 0, 1), m.v[2] = vec(0, 4, 1);
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        int share;
        ray r = ray_from(vec(list[i].x - 3, list[i].y, -2), vec(2, 0, 2));  /* there at t = 3/2 */
        torture_t t = torture_meet(&m, 0, r, &share);
        check((t.den > 0) == list[i].met && (!list[i].met || 2 * t.num == 3 * t.den),
              "triangle at %g, %g", (double)list[i].x, (double)list[i].y);
        if (list[i].met) check_equal(abs(share), list[i].share, "its share there, in sixths");
        r.tmax = (real)1.5;
        check((torture_meet(&m, 0, r, &share).den > 0) == list[i].met, "tmax = t counts");
        r.tmax = (real)nextafterf(1.5F, 0);
        check(torture_meet(&m, 0, r, &share).den == 0, "one float less does not");
    }
    mesh_free(&m);
}

/* Three sheets, one behind the other, not in the order of their numbers: the nearest that the
 * interval lets through is due, and no other is accepted. */
static void test_nearest(void)
{
    static const real height[3] = {2, 1, 3}, from[4] = {0, (real)1.25, (real)2.5, (real)3.5};
    static const uint32_t due[4] = {1, 0, 2, no_shape};
    mesh m = mesh_room(3);
    for (size_t i = 0; i < 3; i++)
        for (size_t k = 0; k < 3; k++)
            m.v[3 * i + k] = vec(k == 1 ? 4 : 0, k == 2 ? 4 : 0, height[i]);
    for (int i = 0; i < 4; i++) {
        bool through;
        ray r = ray_from(vec(1, 1, 0), vec(0, 0, 1));
        r.tmin = from[i];
        torture_hit nearest = torture_due(&m, r, &through);
        torture t = {m, &r, &nearest, 1};
        check(nearest.shape == due[i] && through, "from %g: %u is due", (double)from[i], due[i]);
        for (uint32_t k = 0; k < 3; k++) {
            double error;
            hit h = {height[k], 0, 0, k};
            torture_fault f = torture_judge(&t, 0, h, &error);
            check_equal(f, k == due[i] ? TORTURE_RIGHT : due[i] == no_shape ? TORTURE_INVENTED
                        : TORTURE_ASTRAY, "from %g: %u judged", (double)from[i], k);
        }
    }
    ray r = ray_from(vec(1, 1, 0), vec(0, 0, 1));
    torture_hit farther = {{3, 1}, 2};  /* an oracle that forgot two sheets */
    torture t = {m, &r, &farther, 1};
    double error;
    check_equal(torture_judge(&t, 0, (hit){1, 0, 0, 1}, &error), TORTURE_ASTRAY, "not in silence");
    const real at[] = {1, (real)(1 + 0x1p-20), real_infinity, -1e6, 1e6, (real)NAN};
    torture_hit nearest = {{1, 1}, 1};
    t.due = &nearest;
    for (size_t k = 0; k < sizeof at / sizeof *at; k++)
        check_equal(torture_judge(&t, 0, (hit){at[k], 0, 0, 1}, &error),
                    k < 2 ? TORTURE_RIGHT : TORTURE_ASTRAY, "its t is %g", (double)at[k]);
    mesh_free(&m);
}

typedef bool asked(const void *s, ray r, hit *h);

static size_t faults_of(const torture *t, asked *ask, const void *s)
{
    size_t faults = 0;
    double error;
    for (size_t i = 0; i < t->n; i++) {
        hit h = hit_none;
        if (!ask(s, t->r[i], &h)) h = hit_none;
        faults += torture_judge(t, i, h, &error) != TORTURE_RIGHT;
    }
    return faults;
}
static bool ask_brute(const void *s, ray r, hit *h) { return items_hit(s, r, h); }
static bool ask_bvh(const void *s, ray r, hit *h) { return bvh_hit(s, r, h); }
static bool ask_first(const void *s, ray r, hit *h) { return first_mesh_hit(s, r, h); }

/* The default is right in each class; the lecture's triangle loses edges, in double, too. */
static void test_classes(void)
{
    size_t first = 0, easy = 0;
    for (int k = 0; k < torture_classes; k++) {
        failure f;
        bvh b;
        const char *name = torture_list[k].name;
        torture t = torture_make(k, 600, 1);
        items x = items_of_mesh(&t.m);
        first_mesh m = first_mesh_of(&t.m);
        size_t none = 0, bounds = 0;
        for (size_t i = 0; i < t.n; i++) {
            none += t.due[i].shape == no_shape;
            for (int axis = 0; axis < 3; axis++)
                bounds += !(fabs((double)vaxis(t.r[i].o, axis)) <= (2 << torture_bits)
                            && fabs((double)vaxis(t.r[i].d, axis)) <= (2 << torture_bits)
                            && (real)(float)vaxis(t.r[i].d, axis) == vaxis(t.r[i].d, axis));
        }
        check_equal(bounds, 0, "%s: rays beyond what is exact", name);
        bool some = strcmp(name, "plane") == 0 ? none == t.n : none < t.n;
        check(some && (none == 0 || k >= 4), "%s: %zu of %zu meet nothing", name, none, t.n);
        check_equal(faults_of(&t, ask_brute, &x), 0, "%s: brute force", name);
        if (!bvh_build(&x, bvh_defaults, &b, &f)) fail(f);
        check_equal(faults_of(&t, ask_bvh, &b), 0, "%s: BVH", name);
        *(k == 0 ? &easy : &first) += faults_of(&t, ask_first, &m);
        bvh_free(&b), first_mesh_free(&m), torture_free(&t);
    }
    check_equal(easy, 0, "first version, well inside");
    check_at_least(first, real_is_float ? 150 : 8, "first version, edges and corners lost");
}

/* How many triangles a ray meets at the t that is due, and the share of that one, in sixths. */
static int met_at_once(const torture *t, size_t i, int *share)
{
    int n = 0, other;
    *share = 0;
    for (size_t k = 0; k < t->m.triangles; k++) {
        torture_t x = torture_meet(&t->m, k, t->r[i], &other);
        if (x.den == 0 || torture_less(x, t->due[i].t) || torture_less(t->due[i].t, x)) continue;
        if (k == t->due[i].shape) *share = abs(other);
        n++;
    }
    return n;
}

static aabb box_of(const mesh *m)
{
    aabb b = aabb_empty();
    for (size_t i = 0; i < m->vertices; i++) b.lo = vmin(b.lo, m->v[i]), b.hi = vmax(b.hi, m->v[i]);
    return b;
}

static double longest_over_height(triangle t)
{
    vec3 e[3] = {vsub(t.b, t.a), vsub(t.c, t.b), vsub(t.a, t.c)};
    double longest = 0;
    for (int k = 0; k < 3; k++) longest = fmax(longest, (double)vlength(e[k]));
    return longest * longest / (double)vlength(vcross(e[0], e[1]));
}

/* One end of the interval is 1/4096 before or behind the hit that is due without it. */
static bool ends_there(const torture *t, ray r)
{
    bool through, begins = r.tmin > 0, ends = isfinite(r.tmax);
    ray all = ray_from(r.o, r.d);
    torture_hit first = torture_due(&t->m, all, &through);
    double at = (double)first.t.num / (double)first.t.den;
    if (first.shape == no_shape || (!begins && !ends)) return first.shape == no_shape;
    return (!begins || fabs(fabs((double)r.tmin / at - 1) * 0x1p12 - 1) < 1e-3)
           && (!ends || fabs(fabs((double)r.tmax / at - 1) * 0x1p12 - 1) < 1e-3);
}

/* What a class says of one of its rays, but for where it is aimed. */
static bool is_of_class(const torture *t, const char *name, size_t i)
{
    ray r = t->r[i], before = r;
    aabb box = box_of(&t->m);
    bool through;
    real far = (real)((1 << torture_bits) - 1);
    before.tmin = 0;
    if (!strcmp(name, "axes")) return r.d.x == 0 && r.d.y == 0 && fabs(r.o.z) == far;
    if (!strcmp(name, "plane")) return r.o.z == 0 && r.d.z == 0;
    if (!strcmp(name, "far"))
        return fabs(r.o.x) == far && fabs(r.o.y) <= 4 && r.o.z >= far / 9
               && vlength(vsub(box.hi, box.lo)) < far / 100;
    if (!strcmp(name, "needles"))
        return longest_over_height(mesh_triangle(&t->m, t->due[i].shape)) > 0x1p13;
    if (!strcmp(name, "ends")) return ends_there(t, r);
    if (!strcmp(name, "start"))
        return r.tmin == (real)0x1p-10 && torture_due(&t->m, before, &through).t.num == 0;
    real room = (real)(1 << (torture_bits - 2));
    vec3 off = vmax(vsub(box.lo, r.o), vsub(r.o, box.hi));
    return off.x <= room && off.y <= room && off.z <= 3 * room / 2 && r.o.z > 0 && r.d.z < 0
           && (strcmp(name, "flat") != 0 || (box.lo.z == 0 && box.hi.z == 0));
}

/* Each class is what its line says; where heights hide what a ray is aimed at, most of it is.
 * share 0: any. */
static void test_kinds(void)
{
    static const struct { int share, at_once; double least; } aimed[torture_classes] = {
        {6, 1, 1}, {3, 2, 0.7}, {1, 6, 0.6}, {3, 2, 1}, {0, 0, 1}, {3, 2, 1}, {3, 2, 0.4},
        {3, 2, 0.8}, {6, 3, 1}, {0, 4, 0.3}, {0, 0, 1}, {0, 0, 1}};
    for (int k = 0; k < torture_classes; k++) {
        torture t = torture_make(k, 200, 5);
        const char *name = torture_list[k].name;
        size_t flat = 0, so = 0, at = 0, down = 0, minus = 0, left = 0, cut = 0;
        for (size_t i = 0; i < t.n; i++) {
            ray r = t.r[i];
            int share, at_once = met_at_once(&t, i, &share);
            so += is_of_class(&t, name, i);
            at += (!aimed[k].share || share == aimed[k].share)
                  && (!aimed[k].at_once || at_once == aimed[k].at_once);
            down += r.d.z < 0, minus += r.d.x == 0 && signbit(r.d.x), left += r.d.x < 0;
            cut += t.due[i].shape == no_shape;
        }
        for (size_t i = 0; i < t.m.triangles; i++) {
            triangle q = mesh_triangle(&t.m, i);
            flat += vzero(vcross(vsub(q.b, q.a), vsub(q.c, q.a)));
        }
        check_equal(flat, 0, "%s: triangles without area", name);
        check_equal(so, t.n, "%s: rays of another kind", name);
        check_at_least((double)at, aimed[k].least * (double)t.n, "%s: where they are aimed", name);
        if (k == 3) check(down > 50 && down < 150 && minus > 50 && minus < 150, "up, down, 0, -0");
        else check(left > 50 && left < 150, "%s: to the left and to the right", name);
        if (k == 10) check(cut > 50 && cut < 150, "intervals with a hit and without one");
        torture_free(&t);
    }
}

/* Each kind of fault, planted into right answers. */
static void test_judge(void)
{
    torture t = torture_make(1, 100, 7);
    torture none = torture_make(4, 100, 7);
    size_t seen[4] = {0, 0, 0, 0};
    double error, worst = 0;
    for (size_t i = 0; i < t.n; i++) {
        torture_hit due = t.due[i];
        hit right = {(real)((double)due.t.num / (double)due.t.den), 0, 0, due.shape}, wrong = right;
        seen[0] += torture_judge(&t, i, right, &error) == TORTURE_RIGHT;
        worst = check_worse(worst, error);
        seen[1] += torture_judge(&t, i, hit_none, &error) == TORTURE_LOST;
        seen[2] += torture_judge(&none, i, right, &error) == TORTURE_INVENTED;
        wrong.shape = (due.shape + 200) % (uint32_t)t.m.triangles;
        seen[3] += torture_judge(&t, i, wrong, &error) == TORTURE_ASTRAY;
        right.t *= 1 + (real)0x1p-16;
        torture_judge(&t, i, right, &error);
        check_at_least(error, 50, "t off by 2^-16 shows");
    }
    for (int k = 0; k < 4; k++) check_equal(seen[k], t.n, "answers judged, kind %d", k);
    check_at_most(worst, 1, "a right t is off by a rounding of float at most");
    torture_free(&t), torture_free(&none);
}

/* In roundings of the largest of t, and of a coordinate of o, or 2^20, on the way: by hand. */
static void test_error(void)
{
    static const struct { real x, dz, t, given; double error; } list[] = {
        {0, 1, 1, 1.5, 0x1p23 / 0x1p20}, {0, 1, 1, 0.5, 0x1p23 / 0x1p20}, {0, 1, 1, 1, 0},
        {0, 0x1p21, 0x1p-21, 0.5 + 0x1p-21, 0x1p24}, {0, 0x1p10, 0x1p-10, 0x1p-9, 1 << 4},
        {-0x1p21, 1, 1, 1.5, 0x1p23 / (0x1p21 - 1)}, {0x1p21, 1, 1, 1.5, 0x1p23 / (0x1p21 + 1)}};
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        double error;
        bool through;
        mesh m = mesh_room(1);
        vec3 at = {list[i].x, 0, 0};
        m.v[0] = vadd(at, vec(0, 0, 1)), m.v[1] = vadd(at, vec(4, 0, 1));
        m.v[2] = vadd(at, vec(0, 4, 1));
        ray r = ray_from(vadd(at, vec(1, 1, 0)), vec(0, 0, list[i].dz));
        torture_hit due = torture_due(&m, r, &through);
        torture t = {m, &r, &due, 1};
        check_equal(torture_judge(&t, 0, (hit){list[i].t, 0, 0, 0}, &error), TORTURE_RIGHT, "met");
        check_equal(error, 0, "row %zu: t itself", i);
        torture_judge(&t, 0, (hit){list[i].given, 0, 0, 0}, &error);
        check_close(error, list[i].error, 1e-6 * list[i].error, "row %zu: off, in roundings", i);
        mesh_free(&m);
    }
}

int main(void)
{
    return check_all("17_torture", test_less, test_meet, test_nearest, test_kinds, test_classes,
                     test_judge, test_error);
}
