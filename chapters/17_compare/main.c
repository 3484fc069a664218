/* 17_compare: every structure on the same scenes and the same rays: first the same hits, then time.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 17_compare chapters/17_compare/main.c -lm -lpthread
 *
 * Without options: ten scenes, four kinds of rays, a table each; growth with n; two pictures, a
 * chart, three plots. --scene or --mesh: one scene. --rays: the rays of a file. --verify: all rays
 * by brute force, too. --protocol spd: the published counts. */
#include "lab/chart.h"
#include "lab/growth.h"
#include "lab/modes.h"
#include "lab/pictures.h"
#include "lab/settings.h"
#include "lab/summary.h"
#include <sys/resource.h>

static int scale_of(const options *o, const own_options *own, int k)
{
    return own->scale >= 0 ? own->scale : o->quick ? scene_list[k].quick
           : own->full ? scene_list[k].full : scene_find(scene_list[k].name)->scale;
}

/* Proves, measures, prints; adds to CSV, chart and summary. */
static void compare(const common_settings *c, const world *w, table *csv, chart *bars,
                    summary *sum)
{
    const options *o = c->o;
    stage s;
    char title[160];
    bool large = world_size(w) > 30000;
    progress(w->name, 0, 3);
    stage_begin(&s, w, c->chosen, c->most_bytes, o->quick || large ? 1 : 3);
    stage_rays(&s, whole_view, o->quick ? 12 : c->full ? 256 : 96, o->seed);
    progress(w->name, 1, 3);
    end_if_wrong(stage_prove(&s, o->quick ? 200 : 2400, o->seed, stdout));
    progress(w->name, 2, 3);
    bench_measure(&s, o->quick ? 1 : 5);
    progress(w->name, 3, 3);
    snprintf(title, sizeof title, "%.60s: %zu shapes; %zu rays proved equal, %zu by brute force",
             w->name, world_size(w), s.proved, s.by_brute);
    bench_table(o, &s, title);
    printf("\n");
    fflush(stdout);
    bench_csv(csv, &s);
    summary_add(sum, &s);
    int place = chart_panel(bars, w->name);
    for (int k = 0; k < s.entries; k++) {
        const entry *e = &s.entry[k];
        if (e->c != &brute_contender)
            chart_bar(bars, place, e->c->name, e->s ? bench_mean(&s, e) * 1e9 : 0,
                      per(e->build * 1e9, s.x.n));
    }
    stage_end(&s);
}

static void draw_pictures(const options *o, const common_settings *c)
{
    world w;
    failure f;
    image im = image_new(o->width, o->height);
    bool whole = sheet_draw(o, &im);
    output_picture(o, &im, "17_compare.png", true, whole);
    image_free(&im);
    if (o->out) return;
    if (!scene_world(scene_find("teapot"), o->quick ? 3 : 12, &w, &f)) fail(f);
    im = image_new(o->width, o->width / 2 + 1);
    whole = visits_draw(o, &w, c->chosen & ~1u, c->most_bytes, &im);
    output_picture(o, &im, "17_compare_visits.png", false, whole);
    image_free(&im);
    world_free(&w);
}

/* The world of --mesh or of scene k; false: not wanted. */
static bool wanted(const options *o, const own_options *own, int k, world *w)
{
    failure f;
    mesh m;
    if (own->mesh) {
        if (k > 0) return false;
        if (!obj_read(own->mesh, &m, &f) || !mesh_world(w, own->mesh, m, false, &f)) fail(f);
        return true;
    }
    if (own->scene && strcmp(own->scene, scene_list[k].name) != 0) return false;
    if (!scene_world(scene_find(scene_list[k].name), scale_of(o, own, k), w, &f)) fail(f);
    return true;
}

static void print_memory(const options *o)
{
    struct rusage u;
    if (o->quick || getrusage(RUSAGE_SELF, &u) != 0) return;
    printf("# most memory held by the program: %.0f MB\n", (double)u.ru_maxrss / 1024);
}

/* The notes' own algorithms beside the fastest full tree, on a small soup. */
static void compare_first(const common_settings *c)
{
    const options *o = c->o;
    unsigned firsts = ((1u << contenders) - 1) & ~((1u << full_contenders) - 1);
    world w;
    stage s;
    failure f;
    char title[160];
    if (!scene_world(scene_find("soup"), o->quick ? 1 : 4, &w, &f)) fail(f);
    stage_begin(&s, &w, firsts | 1u << contender_number(&bvh_contender), c->most_bytes, 1);
    stage_rays(&s, whole_view, o->quick ? 12 : 64, o->seed);
    end_if_wrong(stage_prove(&s, o->quick ? 200 : 2400, o->seed, stdout));
    bench_measure(&s, o->quick ? 1 : 3);
    snprintf(title, sizeof title, "The first versions: soup of %zu triangles", world_size(&w));
    bench_table(o, &s, title);
    printf("\n");
    stage_end(&s), world_free(&w);
}

static void run(const options *o, const own_options *own, const common_settings *c)
{
    bool all = !own->scene && !own->mesh;
    world w;
    table csv = table_new("17_compare", bench_columns);
    summary sum = {.chosen = c->chosen};
    chart bars = chart_new("What a ray costs, and what building costs");
    if (all && !own->verify && !own->files.rays) draw_pictures(o, c);
    for (int k = 0; k < scenes && !(all && o->out); k++) {
        if (all && own->files.rays && strcmp(scene_list[k].name, "teapot") != 0) continue;
        if (!wanted(o, own, k, &w)) continue;
        if (own->files.rays) file_run(c, &w, &own->files);
        else if (own->verify) verify_world(c, &w);
        else compare(c, &w, &csv, &bars, &sum);
        world_free(&w);
    }
    bool measured = !own->files.rays && !own->verify && !(all && o->out);
    if (measured) bench_write_csv(o, &csv);
    else table_free(&csv);
    if (measured && all) {
        summary_print(o, &sum);
        if (!own->only) compare_first(c);
        end_if_wrong(growth_run(o, c->chosen, c->most_bytes, own->full));
        output_chart(o, &bars, "17_compare_time.svg");
    }
    free(bars.value);
    if (measured) print_memory(o);
}

int main(int argc, char **argv)
{
    own_options own = {.scale = -1, .megabytes = 2048};
    const option list[] = {
        {"scene", OPTION_TEXT, &own.scene, 0, 0,
         "balls gears mount rings teapot tetra tree stadium soup or needles, alone"},
        {"scale", OPTION_INT, &own.scale, 0, 10000, "its size, see README"},
        {"mesh", OPTION_INPUT, &own.mesh, 0, 0, "FILE.obj: this mesh, y up"},
        {"rays", OPTION_INPUT, &own.files.rays, 0, 0,
         "FILE of rays: ox oy oz tmin dx dy dz tmax, float32"},
        {"any-hit", OPTION_FLAG, &own.files.any, 0, 0, "with --rays: is there any hit at all?"},
        {"hits", OPTION_OUTPUT, &own.files.hits, 0, 0, "with --rays: their t and shape go here"},
        {"only", OPTION_TEXT, &own.only, 0, 0, "these structures, with commas between"},
        {"protocol", OPTION_TEXT, &own.protocol, 0, 0, "spd: counts as they were published"},
        {"verify", OPTION_FLAG, &own.verify, 0, 0,
         "all rays by brute force, too; explain what differs"},
        {"region", OPTION_TEXT, &own.region, 0, 0,
         "with --verify: X0,Y0,X1,Y1 of the view, -1 to 1"},
        {"memory", OPTION_INT, &own.megabytes, 1, 1 << 20,
         "MB that all structures may hold together"},
        {0}};
    options o = options_read(argc, argv, "17_compare",
                             "Every structure on the same scenes and the same rays.",
                             (options){.width = 1000, .height = 400, .seed = 1}, list);
    common_settings c = {&o, chosen_of(own.only), (size_t)own.megabytes << 20, {-1, -1, 1, 1},
                         o.full};
    check_options(&o, &own);
    read_region(own.region, c.region);
    const generator *g = own.scene ? scene_find(own.scene) : NULL;
    if (own.protocol) protocol_run(c, own.only, g, own.scale);
    else run(&o, &own, &c);
    return output_done(&o);
}
