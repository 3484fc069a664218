/* Where structures keep a shape, cells.h, and what 17's --verify says when a search is wrong. */
#include "../chapters/09_aabb/trials/borders.h"
#include "../chapters/07_mesh/scenes/named.h"
#include "../chapters/17_compare/lab/proof.h"
#include "aimed.h"
#include "check.h"
#include "child.h"

static const contender_settings usual_how = {.n = 0};

/* All cells, against the search. --------------------------------------------------------------- */

/* Points on shapes, points anywhere; of these: that the search could be held against the cells. */
typedef struct { size_t points, on, off, judged, wrong; } cell_verdict;

/* A ray that is no longer than the point p tests the shapes of the leaves that hold p, and no
 * others. But not where a wall is within `near` of p. more: shapes may be in several of these. */
static void judge_point(const contender *c, const void *s, const items *x, vec3 p, real near,
                        bool more, cell_verdict *v)
{
    ray r = {p, 0, {1, (real)-0.7, (real)0.3}, 0};
    search_work w = {0, 0, 0, 0};
    item_cell cell;
    hit h;
    size_t inside = 0;
    v->points++;
    for (uint32_t i = 0; i < x->n; i++) {
        if (!contender_cell(c, s, i, p, &cell)) continue;
        if (fabs(cell.outside) <= near) return;
        inside += cell.outside < 0;
    }
    c->counted(s, r, false, &h, &w);
    v->judged++, v->wrong += more ? w.tests < inside : w.tests != inside;
}

/* Where a ray hits a shape, the nearest of its cells holds the point, but for `near`. */
static void judge_hit(const contender *c, const void *s, const items *x, ray r, real near,
                      bool more, cell_verdict *v)
{
    hit h = hit_none;
    item_cell cell;
    if (!items_hit(x, r, &h)) return;
    vec3 p = ray_at(r, h.t);
    contender_cell(c, s, h.shape, p, &cell);
    v->on++, v->off += !(cell.outside <= near);
    judge_point(c, s, x, p, near, more, v);
}

/* Of the book's structures it is known where they keep a shape; a reader's own need not say. */
static bool must_tell(const contender *c)
{
    static const char *const type[] = {"grid", "nested", "octree", "kdtree", "bsp", "bvh", "bvh8",
                                       "example"};
    for (size_t k = 0; k < sizeof type / sizeof *type; k++)
        if (strcmp(c->type, type[k]) == 0) return true;
    return false;
}

static void judge_cells(const contender *c, const world *w, const items *x, aabb all)
{
    failure f;
    item_cell cell;
    cell_verdict v = {0, 0, 0, 0, 0};
    void *s = contender_build(c, &usual_how, x, (size_t)1 << 30, &f);
    if (!s && contender_is_first(c)) return;  /* of triangles alone */
    if (!s) fail(f);
    size_t n = check_sample(200, 24);
    bool more = strcmp(c->name, "bvh-spatial") == 0;
    ray_set rays = rays_everywhere(w, n, 3);
    real size = vlargest(vsub(all.hi, all.lo)), reach = size + aabb_reach(all);
    real near = reach * ((real)0x1p-18 + 4096 * real_epsilon);
    bool none = !contender_cell(c, s, 0, all.lo, &cell);
    for (size_t i = 0; !none && i < n; i++) {
        random_stream g = random_start(4, i, 0);
        vec3 at = random_in_cube(&g, 1), half = vscale(vsub(all.hi, all.lo), (real)0.5);
        judge_hit(c, s, x, rays.r[i], near, more, &v);
        judge_point(c, s, x, vadd(aabb_centre(all), vmul(at, half)), near, more, &v);
    }
    check_equal(v.off, 0, "%s, %s: cells that don't hold their shape's hit, of %zu", w->name,
                c->name, v.on);
    check_equal(v.wrong, 0, "%s, %s: points that the search asks others at, of %zu", w->name,
                c->name, v.judged);
    check(none ? !must_tell(c) : 8 * v.on > n && 2 * v.judged > v.points,
          "%s, %s: %zu points, %zu on shapes, %zu judged", w->name, c->name, v.points, v.on,
          v.judged);
    rays_free(&rays), contender_free(c, s);
}

static void test_cells(void)
{
    static const struct { const char *name; int scale; } scene_of[] = {
        {"teapot", 2}, {"needles", 1}, {"balls", 2}, {"gears", 1}, {"tetra", 3}};
    for (size_t k = 0; k < sizeof scene_of / sizeof *scene_of; k++) {
        world w;
        failure f;
        aabb all;
        if (!scene_world(scene_find(scene_of[k].name), scene_of[k].scale, &w, &f)) fail(f);
        scene shapes = world_scene(&w);
        items x = w.n ? items_of_scene(&shapes) : items_of_mesh(&w.mesh);
        if (!items_all_bounds(&x, &all, &f)) fail(f);
        for (int i = 0; i < contenders; i++) judge_cells(contender_list[i], &w, &x, all);
        world_free(&w);
    }
}

/* Broken on purpose: what is said of it. ------------------------------------------------------- */

/* A structure over a mesh; a ray that hits it, and where. */
typedef struct { mesh m; items x; contender c; void *s; ray r; hit due; vec3 p; } broken;

static bool broken_aim(broken *b, ray r)
{
    b->r = r, b->due = hit_none;
    bool hits = items_hit(&b->x, r, &b->due);
    b->p = ray_at(r, b->due.t);
    return hits;
}

static const ray straight = {{0, -10, 1}, 0, {(real)0.01, 1, (real)0.02}, real_infinity};

static broken *broken_new(const char *name, mesh m)
{
    failure f;
    broken *b = allocate(1, sizeof *b);
    b->m = m, b->x = items_of_mesh(&b->m), b->c = *contender_find(name);
    b->s = contender_build(&b->c, &usual_how, &b->x, (size_t)1 << 30, &f);
    if (!b->s) fail(f);
    check(broken_aim(b, straight), "%s: a ray that hits", name);
    return b;
}

static void broken_free(broken *b)
{
    contender_free(&b->c, b->s), mesh_free(&b->m);
    free(b);
}

/* What --verify says of the ray, or nothing; for free. */
static char *broken_said(const broken *b)
{
    char *text;
    size_t length;
    wrong_answer w;
    FILE *out = open_memstream(&text, &length);
    if (!prove_closed(&b->c, b->s, b->r, b->due, aimed_ways, &w))
        explain_wrong(&w, &b->x, "brute force", out);
    fclose(out);
    return text;
}

/* It says a, and b, but not c. */
static void check_said(const broken *b, const char *what, const char *says, const char *also,
                       const char *not)
{
    char *text = broken_said(b);
    check(strstr(text, says) && strstr(text, also) && !strstr(text, not), "%s, %s: wanted are "
          "'%s', '%s' and no '%s': %s", b->c.name, what, says, also, not, text);
    free(text);
}

static uint32_t another(const broken *b) { return b->due.shape ? 0 : 1; }

/* Which of the grid's cells that list the shape are within `far` of the hit: they forget it. */
static void grid_forgets(broken *b, real far)
{
    grid *g = b->s;
    const lattice *l = &g->cells;
    size_t c = 0;
    for (int z = 0; z < l->n[2]; z++)
        for (int y = 0; y < l->n[1]; y++)
            for (int x = 0; x < l->n[0]; x++, c++) {
                aabb cell = lattice_box(l, (int[3]){x, y, z}, (int[3]){x, y, z}, far);
                for (uint32_t i = g->lists.first[c]; i < g->lists.first[c + 1]; i++)
                    if (g->lists.item[i] == b->due.shape && aabb_contains(cell, b->p))
                        g->lists.item[i] = another(b);
            }
}

static void test_grid_forgets(void)
{
    broken *b = broken_new("grid", teapot_mesh(4));
    const grid *g = b->s;
    check_said(b, "as it is", "", "", ":");
    grid_forgets(b, g->cells.size.x / 100);
    char *text = broken_said(b), *at = strstr(text, "nearest box that lists it: x ");
    const char *off = at ? strstr(at, "the hit is ") : NULL;
    double far = off ? strtod(off + strlen("the hit is "), NULL) : 0;
    double size = (double)vlargest(g->cells.size);
    check(far >= 0.0099 * size && far <= size, "the next cell is %g away, of %g: %s", far, size,
          text);
    check_said(b, "not in its cell", "outside: it is not listed where it is hit",
               "not found on the interval [t, t] either\n", "wider");
    grid_forgets(b, real_infinity);
    check_said(b, "in no cell", "it is listed nowhere", " itself: x ", "nearest box");
    free(text), broken_free(b);
}

/* The leaf that holds the hit, by the planes, forgets the shape; and then knows it again. What it
 * says in between, for free. */
static char *bsp_forgets(const broken *b)
{
    bsp *t = b->s;
    vec3 q = vsub(b->p, t->middle);
    const bsp_node *n = t->node;
    while (!(n->kind & bsp_leaf_bit)) {
        real s = n->kind < 3 ? vaxis(q, (int)n->kind)
                             : vdot(t->normal[n->kind & ~bsp_slanted_bit], q);
        n = t->node + n->first + (s > n->at);
    }
    uint32_t *at = t->reference + n->first, *end = at + (n->kind & ~bsp_leaf_bit);
    while (at < end && *at != b->due.shape) at++;
    if (at == end) return NULL;
    *at = another(b);
    char *text = broken_said(b);
    *at = b->due.shape;
    return text;
}

static void test_bsp_forgets(void)
{
    broken *b = broken_new("bsp", teapot_mesh(4));
    size_t asked = 0, nowhere = 0, slanted = 0, across = 0;
    for (size_t i = 0; i < 300; i++) {
        random_stream g = random_start(5, i, 0);
        vec3 to = vadd(vec(0, 0, 1), random_in_cube(&g, (real)0.5));
        bool hits = broken_aim(b, ray_between(vadd(to, random_in_cube(&g, 9)), to));
        char *text = hits ? bsp_forgets(b) : NULL;
        if (!text) continue;
        nowhere += strstr(text, "it is listed nowhere") != NULL;
        slanted += strstr(text, "outside, beyond a slanted wall: it is not listed") != NULL;
        across += strstr(text, "outside: it is not listed where") != NULL;
        asked++, free(text);
    }
    check(nowhere > 0 && slanted > 0 && across > 0, "of %zu hits %zu, %zu, %zu", asked, nowhere,
          slanted, across);
    check_equal(nowhere + slanted + across, asked, "all are explained");
    broken_free(b);
}

/* The way lost; the box shrunk to a corner; the number gone. */
static void test_bvh_breaks(void)
{
    broken *b = broken_new("bvh", teapot_mesh(4));
    bvh *tree = b->s;
    bvh_tree *t = &tree->mesh.tree;
    bvh_node *leaf = NULL, inner[2] = {t->node[2], t->node[3]};
    uint32_t at = 0;
    check_said(b, "as it is", "", "", ":");
    for (bvh_node *n = t->node; n < t->node + t->nodes; n++)
        for (uint32_t k = n->first; k < n->first + n->count; k++)
            if (tree->mesh.triangle[k].index == b->due.shape) leaf = n, at = k;
    check(leaf && inner[0].count + inner[1].count == 0, "its leaf is found");
    for (int k = 0; k < 3; k++)
        for (int i = 2; i < 4; i++) t->node[i].minus_high[k] = -t->node[i].low[k];
    check_said(b, "way", "inside: listed there, but the search does not come there",
               "nearest box that lists it: x ", "outside");
    t->node[2] = inner[0], t->node[3] = inner[1];
    for (int k = 0; k < 3; k++) leaf->minus_high[k] = -leaf->low[k];
    check_said(b, "box", "outside: it is not listed where it is hit", "[t, t] either", "wider");
    tree->mesh.triangle[at].index = another(b);
    check_said(b, "number", "it is listed nowhere", "[t, t] either", "nearest box");
    broken_free(b);
}

/* Bare boxes. */
static bool bare_hit(const void *s, ray r, hit *out)
{
    const example *e = s;
    example_query q = {e, query_of(r), aabb_inverse_of(r), {0, 0, 0}, false};
    return example_walk(&q, 0, 0, e->n, NULL) && query_answer(&q.q, out);
}

static mesh square_at(real y)
{
    mesh m = mesh_room(2);
    vec3 low = {-9, y, -9}, high = {9, y, 9};
    set_triangle(&m, 0, low, (vec3){9, y, -9}, high);
    set_triangle(&m, 1, low, high, (vec3){-9, y, 9});
    return m;
}

/* A square, seen from close by: rounding places hits before or behind it, or the t of its box. */
static void test_example_bare(void)
{
    broken *b = broken_new("example", square_at((real)0.3));
    size_t lost = 0, once = 0, outside = 0, border = 0;
    b->c.hit = bare_hit;
    for (size_t i = 0; i < 1000; i++) {
        random_stream g = random_start(2, i, 0);
        vec3 o = random_in_cube(&g, 8), d = random_in_cube(&g, 1);
        o.y = (real)0.3 - (real)0.01 * random_next(&g), d.y = (real)0.1;
        if (!broken_aim(b, ray_from(o, d))) continue;
        char *text = broken_said(b);
        lost += *text != 0;
        outside += strstr(text, " outside: the box must be wider than that") != NULL;
        border += strstr(text, "on its border: there a rounding loses it") != NULL;
        once += strstr(text, " itself, and the box that lists it: x ") != NULL;
        free(text);
    }
    check(outside > 0 && border > 0, "of %zu lost %zu are outside, %zu on the border", lost,
          outside, border);
    check_equal(outside + border, lost, "all that are lost");
    check_equal(once, lost, "a leaf has the box of its shape: it is printed once");
    broken_free(b);
}

/* Searches that are wrong. --------------------------------------------------------------------- */

/* Loses what is more than 3 beyond its beginning; of any structure. */
static const contender *sighted;

static bool short_sighted_hit(const void *s, ray r, hit *out)
{
    hit h;
    if (!sighted->hit(s, r, &h) || h.t > r.tmin + 3) return false;
    *out = h;
    return true;
}

static bool short_sighted_occluded(const void *s, ray r)
{
    hit h;
    return short_sighted_hit(s, r, &h);
}

/* All but brute force and the first versions: what they answer, and that the shape is listed where
 * it is hit. */
static void test_lost_way(void)
{
    for (int k = 1; k < contenders; k++) {
        char answer[64];
        item_cell cell;
        sighted = contender_list[k];
        if (contender_is_first(sighted)) continue;
        broken *b = broken_new(sighted->name, teapot_mesh(4));
        bool known = contender_cell(&b->c, b->s, b->due.shape, b->p, &cell);
        for (int any = 0; any < 2; any++) {
            b->c.hit = any ? sighted->hit : short_sighted_hit;
            b->c.occluded = any ? short_sighted_occluded : sighted->occluded;
            snprintf(answer, sizeof answer, "%s: %s", b->c.name, any ? "occluded: no" : "no hit");
            check_said(b, "far", answer, "found on the interval [t, t] alone", "not listed");
            check_said(b, "far", " itself", known ? "box that lists it: x " : "", "not listed");
        }
        broken_free(b);
    }
}

static bool dreaming_hit(const void *s, ray r, hit *out)
{
    (void)s, (void)r;
    *out = (hit){1, 0, 0, 5};
    return true;
}

/* A tie that the wrong one wins. */
static bool later_hit(const void *s, ray r, hit *out)
{
    if (!bvh_hit(s, r, out)) return false;
    out->shape++;
    return true;
}

static bool strict_hit(const void *s, ray r, hit *out)
{
    hit h;
    if (!bvh_hit(s, r, &h)) return false;
    *out = h;
    return h.t < r.tmax;
}

/* Finds what is at the beginning of the interval. */
static bool begin_hit(const void *s, ray r, hit *out)
{
    return bvh_hit(s, r, out) && out->t <= r.tmin;
}

/* begin: on the border, and yet found there: so the box is wide enough. */
static void test_wrong_searches(void)
{
    static const ray past = {{9, 9, 9}, 0, {1, 0, 0}, real_infinity};
    static const struct {
        const char *what;
        bool (*hit)(const void *s, ray r, hit *out);
        bool square, hits;
        const char *says, *also, *not;
    } wrong[] = {
        {"later", later_hit, false, true, "the lower index must win", "shape", "outside"},
        {"dream", dreaming_hit, false, false, "a hit that does not exist", "no hit", "itself"},
        {"strict", strict_hit, false, true, "a comparison with its end is strict",
         "the hit is inside\n", "rounding loses"},
        {"begin", begin_hit, true, true, "found on the interval [t, t] alone",
         "the hit is on its border\n", "rounding"}};
    for (size_t k = 0; k < sizeof wrong / sizeof *wrong; k++) {
        broken *b = broken_new("bvh", wrong[k].square ? square_at((real)0.25) : teapot_mesh(4));
        if (!wrong[k].hits) check(!broken_aim(b, past), "%s: a ray that misses", wrong[k].what);
        b->c.hit = wrong[k].hit;
        check_said(b, wrong[k].what, wrong[k].says, wrong[k].also, wrong[k].not);
        broken_free(b);
    }
}

/* Searches that see nothing so close to the ends of the interval. */
static real blind_at[2];

static bool blind_hit(const void *s, ray r, hit *out)
{
    hit h;
    if (!bvh_hit(s, r, &h)) return false;
    *out = h;
    return h.t >= r.tmin + blind_at[0] && h.t <= r.tmax - blind_at[1];
}

/* An end that is left out is found out, and the explanation says how much is. */
static void test_open_ends(void)
{
    static const real by = (real)1 / 1024, ends[4][2] = {{0, by}, {by, 0}, {by, by}};
    static const char reaches[] = "reaches ";
    broken *b = broken_new("bvh", teapot_mesh(4));
    for (int k = 0; k < 4; k++) {
        bool strict = k == 3;
        double least = (double)(strict ? b->due.t * real_epsilon / 2 : by);
        memcpy(blind_at, ends[k], sizeof blind_at);
        b->c.hit = strict ? strict_hit : blind_hit;
        char *text = broken_said(b);
        const char *at = strstr(text, reaches);
        double said = at ? strtod(at + strlen(reaches), NULL) : 0;
        check(said > 0.9 * least && said < 2.2 * least, "%d: within %g of an end: %s", k, least,
              text);
        free(text);
    }
    broken_free(b);
}

/* Loses what is at t = 0, where the last digit of t is nothing. */
static bool forward_hit(const void *s, ray r, hit *out)
{
    return bvh_hit(s, r, out) && out->t > 0;
}

static void say_in_time(void *b)
{
    alarm(60);  /* it once never ended */
    char *text = broken_said(b);
    fputs(text, stdout), free(text);
}

static void test_zero(void)
{
    broken *b = broken_new("bvh", teapot_mesh(4));
    check(broken_aim(b, ray_from(mesh_triangle(&b->m, b->due.shape).a, straight.d))
          && b->due.t == 0, "a ray that begins at a corner hits there");
    b->c.hit = forward_hit;
    child_result said = child_run(say_in_time, b);
    check(said.status == 0 && strstr(said.out, "bvh: wrong ray: o = ")
              && strstr(said.out, "[t, t] either"),
          "a lost t = 0 is explained, in time: %d: %s", said.status, said.out);
    broken_free(b);
}

/* Of a type that has no X_cell_of; and of one that has, if the shape is gone. */
static void test_no_cell(void)
{
    broken *b = broken_new("example", teapot_mesh(4));
    example *e = b->s;
    aabb root = e->box[0];
    b->c.type = "other", e->box[0].hi = root.lo;
    check_said(b, "no cell", " itself: x ", "not listed there, or the search does not come there",
               "nowhere");
    b->c.type = "example", e->box[0] = root;
    for (size_t i = 0; i < e->n; i++)
        if (e->item[i].index == b->due.shape) e->item[i].index = another(b);
    check_said(b, "number", "it is listed nowhere", " itself: x ", "and the box");
    broken_free(b);
}

int main(void)
{
    return check_all("17_proof", test_cells, test_grid_forgets, test_bsp_forgets,
                     test_bvh_breaks, test_example_bare, test_lost_way, test_wrong_searches,
                     test_open_ends, test_zero, test_no_cell);
}
