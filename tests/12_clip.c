/* Cutting triangles exactly: boxes of parts against an oracle of whole numbers; the sweep
 * against trying all planes. */
#include "../chapters/12_kdtree/split.h"
#include "../common/random.h"
#include "check.h"

/* The bounds of what a triangle with whole corners has inside a box with whole sides. Its extreme
 * points are corners of the triangle, or its edges in sides of the box, or edges of the box in
 * the triangle: all of them are tried, and whether a point counts is decided in whole numbers. */
typedef struct { int64_t p[3]; } whole;
typedef struct { whole lo, hi; } whole_box;
typedef struct { double lo[3], hi[3], point[64][3]; int n; } bounds;

static void bounds_point(bounds *b, const double p[3])
{
    if (b->n < 64) memcpy(b->point[b->n++], p, 3 * sizeof *p);
    for (int k = 0; k < 3; k++) {
        if (p[k] < b->lo[k]) b->lo[k] = p[k];
        if (p[k] > b->hi[k]) b->hi[k] = p[k];
    }
}

/* n / d with d != 0 in [lo, hi]? */
static bool within(int64_t n, int64_t d, int64_t lo, int64_t hi)
{
    if (d < 0) n = -n, d = -d;
    return n >= lo * d && n <= hi * d;
}

static bool whole_in(const whole *p, const whole_box *b)
{
    for (int k = 0; k < 3; k++)
        if (p->p[k] < b->lo.p[k] || p->p[k] > b->hi.p[k]) return false;
    return true;
}

static void edge_in_side(bounds *out, const whole *a, const whole *b, int k, int64_t side,
                         const whole_box *box)
{
    int64_t d = b->p[k] - a->p[k], n[3];
    double q[3];
    if (d == 0) return;  /* along the side: its ends are corners, or in other sides */
    if (!within(side - a->p[k], d, 0, 1)) return;
    for (int j = 0; j < 3; j++) {
        n[j] = a->p[j] * d + (b->p[j] - a->p[j]) * (side - a->p[k]);
        if (!within(n[j], d, box->lo.p[j], box->hi.p[j])) return;
        q[j] = (double)n[j] / (double)d;
    }
    bounds_point(out, q);
}

/* The line with coordinates p, q along axes u, v meets the triangle where? */
static void box_edge(bounds *out, const whole c[3], int k, int64_t p, int64_t q,
                     const whole_box *box)
{
    int u = (k + 1) % 3, v = (k + 2) % 3, up = 0, down = 0;
    int64_t w[3], sum = 0, n = 0;
    double point[3];
    for (int i = 0; i < 3; i++) {
        const whole *a = &c[(i + 1) % 3], *b = &c[(i + 2) % 3];
        w[i] = (a->p[u] - p) * (b->p[v] - q) - (a->p[v] - q) * (b->p[u] - p);
        up += w[i] > 0, down += w[i] < 0, sum += w[i];
    }
    if (sum == 0 || (up && down)) return;  /* edge-on: nothing that the others do not have */
    for (int i = 0; i < 3; i++) n += w[i] * c[i].p[k];
    if (!within(n, sum, box->lo.p[k], box->hi.p[k])) return;
    point[k] = (double)n / (double)sum, point[u] = (double)p, point[v] = (double)q;
    bounds_point(out, point);
}

static bounds oracle(const whole c[3], const whole_box *box)
{
    bounds b = {.lo = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, .hi = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
    for (int i = 0; i < 3; i++) {
        double p[3] = {(double)c[i].p[0], (double)c[i].p[1], (double)c[i].p[2]};
        if (whole_in(&c[i], box)) bounds_point(&b, p);
        for (int k = 0; k < 3; k++) {
            edge_in_side(&b, &c[i], &c[(i + 1) % 3], k, box->lo.p[k], box);
            edge_in_side(&b, &c[i], &c[(i + 1) % 3], k, box->hi.p[k], box);
        }
    }
    for (int k = 0; k < 3; k++) {
        int u = (k + 1) % 3, v = (k + 2) % 3;
        for (int s = 0; s < 4; s++)
            box_edge(&b, c, k, s & 1 ? box->hi.p[u] : box->lo.p[u],
                     s & 2 ? box->hi.p[v] : box->lo.p[v], box);
    }
    return b;
}

static int64_t random_whole(random_stream *g, int64_t most)
{
    return (int64_t)(random_next_bits(g) % (uint64_t)(2 * most + 1)) - most;
}

typedef struct { size_t lost, contacts, loose, empty, parts; double worst; } clip_verdict;

static bool box_has(const kd_box *b, const double p[3], double spare)
{
    for (int k = 0; k < 3; k++)
        if (p[k] < (double)b->lo[k] - spare || p[k] > (double)b->hi[k] + spare) return false;
    return true;
}

/* Every extreme point of a part lies in the box of that part. Or rounding has lost a mere contact:
 * then it is in the box of the other part, or in a side of the present box, where the neighbour
 * has it; each within `spare`. And no box is larger by `slack`. */
static void judge(const kd_box *mine, const kd_box *other, const kd_box *now, const bounds *b,
                  double spare, double slack, clip_verdict *v)
{
    v->parts++;
    v->empty += b->n == 0;
    for (int i = 0; i < b->n; i++) {
        bool here = box_has(mine, b->point[i], spare);
        v->contacts += !here;
        bool there = box_has(other, b->point[i], spare);
        v->lost += !here && !there && box_has(now, b->point[i], -spare);
    }
    for (int k = 0; k < 3 && b->n && mine->lo[0] <= mine->hi[0]; k++) {
        double below = b->lo[k] - (double)mine->lo[k], above = (double)mine->hi[k] - b->hi[k];
        v->loose += below > slack || above > slack;
        if (below > v->worst) v->worst = below;
        if (above > v->worst) v->worst = above;
    }
}

/* A triangle and a box of whole numbers; kind 1: in a plane of an axis; 2: a needle; 3: corners on
 * the sides of the box. */
static void random_case(random_stream *g, int kind, int64_t most, whole c[3], whole_box *box)
{
    int flat = (int)(random_next_bits(g) % 3);
    for (int k = 0; k < 3; k++) {
        int64_t a = random_whole(g, most), b = random_whole(g, most);
        box->lo.p[k] = a < b ? a : b, box->hi.p[k] = (a < b ? b : a) + 2;
    }
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) {
            c[i].p[k] = random_whole(g, most);
            if (kind == 1 && k == flat) c[i].p[k] = box->lo.p[k] + 1;
            if (kind == 2 && i == 2) c[i].p[k] = c[1].p[k] + random_whole(g, 1);
            if (kind == 3) c[i].p[k] = random_next_bits(g) & 1 ? box->lo.p[k] : box->hi.p[k];
        }
}

static void test_clip(bool thick)
{
    clip_verdict v = {0, 0, 0, 0, 0, 0};
    size_t cases = check_count(200000);
    for (size_t i = 0; i < cases; i++) {
        random_stream g = random_start(12, i, 0);
        int64_t most = i % 8 < 4 ? 1000 : 4;
        whole c[3];
        whole_box box;
        random_case(&g, (int)(i % 4), most, c, &box);
        double corner[3][3];
        for (int j = 0; j < 9; j++) corner[j / 3][j % 3] = (double)c[j / 3].p[j % 3];
        kd_box now, below, above;
        for (int k = 0; k < 3; k++)
            now.lo[k] = (float)box.lo.p[k], now.hi[k] = (float)box.hi.p[k];
        int axis = (int)(random_next_bits(&g) % 3);
        int64_t room = box.hi.p[axis] - box.lo.p[axis] - 1;
        int64_t at = box.lo.p[axis] + 1 + (int64_t)(random_next_bits(&g) % (uint64_t)room);
        below = above = now;
        kd_polygon p = kd_polygon_in(corner, &now);
        kd_cut cut = kd_cut_begin(axis, (float)at);
        for (int j = 0; j < p.n; j++) kd_cut_edge(&cut, p.p[j], p.p[j + 1 < p.n ? j + 1 : 0]);
        kd_cut_end(&cut, thick, &below, &above);
        whole_box lower = box, upper = box;
        lower.hi.p[axis] = upper.lo.p[axis] = at;
        bounds bl = oracle(c, &lower), bu = oracle(c, &upper);
        /* four roundings of a double for each of six cuts; and three floats */
        double spare = 24 * DBL_EPSILON * (double)most, slack = 4 * (double)FLT_EPSILON;
        slack *= (double)most;
        judge(&below, &above, &now, &bl, spare, slack, &v);
        judge(&above, &below, &now, &bu, spare, slack, &v);
    }
    check_equal(v.lost, 0, "each point of a triangle lies in the box of one of its parts");
    /* points are counted, and one part may have 64 */
    check_at_most(v.contacts, v.parts / 1000 + 64, "nearly always in that of its own part");
    check_equal(v.loose, 0, "boxes of parts are tight; farthest %g", v.worst);
    check_at_least(v.parts - v.empty, v.parts / 4, "triangles reach into their boxes");
    check_at_least(v.empty, v.parts / 20, "and some do not");
}

/* A concave polygon, edge by edge: an arch, cut through both legs. */
static void test_concave(void)
{
    static const double arch[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {3, 2, 0},
                                      {3, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0}};
    kd_cut c = kd_cut_begin(1, 1);
    kd_box below = {{-9, -9, -9}, {9, 9, 9}}, above = below;
    for (int i = 0; i < 8; i++) kd_cut_edge(&c, arch[i], arch[(i + 1) % 8]);
    kd_cut_end(&c, false, &below, &above);
    check(below.lo[0] == 0 && below.hi[0] == 4 && below.lo[1] == 0 && below.hi[1] == 1,
          "the legs of the arch: [0,4] x [0,1]");
    check(above.lo[1] == 1 && above.hi[1] == 3 && above.lo[0] == 0 && above.hi[0] == 4,
          "the arch above: [0,4] x [1,3]");
    check(below.lo[2] == 0 && above.hi[2] == 0, "boxes of what is flat are flat");
}

static void test_rounding(void)
{
    size_t wrong = 0, loose = 0;
    for (size_t i = 0; i < check_count(500000); i++) {
        uint64_t bits = random_bits(3, i, 0, 0);
        double x;
        memcpy(&x, &bits, sizeof x);
        if (i % 2) x = ldexp((double)(int64_t)bits, (int)(bits % 200) - 160);
        if (i % 5 == 0) x = (double)(float)x;
        if (!(fabs(x) < 1e38)) continue;
        float lo = kd_below(x, false), hi = kd_above(x, false), lower = kd_below(x, true);
        wrong += !((double)lo <= x && x <= (double)hi && (double)lower < x);
        wrong += (double)(float)x == x && (lo != (float)x || hi != (float)x);
        float up = lower;
        for (int k = 0; k < 4; k++) up = nextafterf(up, INFINITY);
        loose += (double)up < x;
    }
    check_equal(wrong, 0, "rounded outwards; thick: to a float that is not x; else exact");
    check_equal(loose, 0, "and not farther than four floats");
}

/* (12.1) by definition: every side of every box, counted anew. */
static double cost_by_counting(const kd_splitter *s, const kd_item *item, size_t n,
                               const kd_box *cell, int k, float at)
{
    size_t below = 0, above = 0;
    kd_box l = *cell, r = *cell;
    l.hi[k] = r.lo[k] = at;
    for (size_t i = 0; i < n; i++)
        below += item[i].box.lo[k] < at, above += item[i].box.hi[k] > at;
    double cost = 1 + s->how.item_cost / kd_area(cell)
        * (kd_area(&l) * (double)below + kd_area(&r) * (double)above);
    return below == 0 || above == 0 ? cost * (1 - s->how.empty_bonus) : cost;
}

static void test_sweep(void)
{
    enum { most = 60 };
    static kd_item item[most];
    static uint32_t a[most], b[most], c[most];
    double worst = 0;
    size_t none = 0, rounds = check_count(3000);
    for (size_t i = 0; i < rounds; i++) {
        random_stream g = random_start(21, i, 0);
        size_t n = 1 + random_next_bits(&g) % most;
        kd_box cell = {{0, 0, 0}, {8, 8, 8}};
        kdtree_options how = {.strategy = KD_SAH, .item_cost = 0.25 + (double)(i % 5),
                              .empty_bonus = i % 3 ? 0.2 : 0};
        kd_splitter s = {how, a, b, c};
        double least = HUGE_VAL;
        for (size_t j = 0; j < n; j++)
            for (int k = 0; k < 3; k++) {
                float x = (float)(random_next_bits(&g) % (i % 2 ? 9 : 8192));
                float w = (float)(random_next_bits(&g) % 3);
                if (i % 2 == 0) x /= 1024;
                item[j].box.lo[k] = x, item[j].box.hi[k] = float_min(x + w, 8);
            }
        for (size_t j = 0; j < 6 * n; j++) {
            int k = (int)(j % 3);
            const kd_box *box = &item[j / 6].box;
            float at = j % 6 < 3 ? box->lo[k] : box->hi[k];
            if (!(at > 0 && at < 8)) continue;
            double cost = cost_by_counting(&s, item, n, &cell, k, at);
            if (cost < least) least = cost;
        }
        kd_choice found = kd_choose(&s, item, n, &cell);
        none += !(least < HUGE_VAL);
        if (!(least < HUGE_VAL)) { worst = check_worse(worst, found.cost < HUGE_VAL); continue; }
        double there = cost_by_counting(&s, item, n, &cell, found.axis, found.plane);
        worst = check_worse(worst, fabs(found.cost - least) / least);
        worst = check_worse(worst, fabs(there - least) / least);
    }
    check_at_most(worst, 16 * DBL_EPSILON, "the sweep finds the cheapest of all planes (12.1)");
    check_at_most(none, rounds / 10, "most sets can be cut");
}

/* By definition: among the centres, sorted by hand, in halves of which no digit is lost. */
static void test_median(void)
{
    enum { n = 5 };
    static uint32_t a[n], b[n], c[n];
    kd_splitter s = {{.strategy = KD_MEDIAN, .item_cost = 1}, a, b, c};
    kd_box cell = {{0, 0, 0}, {4, 16, 8}};
    kd_item item[n] = {{.index = 0}};
    const float lo[n] = {2, 14, 0, 4, 3}, hi[n] = {4, 16, 1, 9, 4};  /* 3, 15, .5, 6.5, 3.5 */
    for (int i = 0; i < n; i++) item[i].box.lo[1] = lo[i], item[i].box.hi[1] = hi[i];
    kd_choice found = kd_choose(&s, item, n, &cell);
    check_equal(found.axis, 1, "the longest side");
    check_equal((double)found.plane, 3.5, "the third of five centres");
}

/* In large cells the sweep tries few planes: its cost is right but for sides that lie in the very
 * plane, and hardly above the least of all. */
static void test_bins(void)
{
    enum { most = 3000, from = 600 };
    static kd_item item[most];
    static uint32_t a[most], b[most], c[most];
    double wrong = 0, above = 0;
    for (size_t i = 0; i < check_count(40); i++) {
        random_stream g = random_start(22, i, 0);
        size_t n = from + random_next_bits(&g) % (most - from);
        kd_box cell = {{-1, -2, -3}, {1, 2, 3}};
        kd_splitter s = {{.strategy = KD_SAH, .item_cost = 0.25, .empty_bonus = 0.1}, a, b, c};
        for (size_t j = 0; j < n; j++)
            for (int k = 0; k < 3; k++) {
                double x = (double)random_next(&g), w = (double)random_next(&g) / 4;
                if (i % 2) x = x * x * x;
                item[j].box.lo[k] = (float)((2 * x - 1) * (k + 1) * (i % 3 ? 1 : 0.7));
                item[j].box.hi[k] = float_min(item[j].box.lo[k] + (float)w, (float)(k + 1));
            }
        kd_choice found = kd_choose(&s, item, n, &cell), best = {HUGE_VAL, 0, 0};
        for (int k = 0; k < 3; k++) kd_sweep_axis(&s, item, n, &cell, k, &best);
        double there = cost_by_counting(&s, item, n, &cell, found.axis, found.plane);
        wrong = check_worse(wrong, fabs(found.cost - there) / there);
        above = check_worse(above, found.cost / best.cost - 1);
    }
    check_at_most(wrong, 0.01, "bins: the cost of the plane taken");
    check_at_most(above, 0.03, "bins: nearly the cheapest of all planes");
}

int main(void)
{
    test_clip(true);
    test_clip(false);
    return check_all("12_clip", test_concave, test_rounding, test_sweep, test_median,
                     test_bins);
}
