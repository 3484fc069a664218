/* settings.h: the options of this chapter, and what is wrong with them: that ends the program.
 *
 *   own_world(&own, path, &w)            the scene of an OBJ or NFF file, with --up and the view
 *   check_options(&o, &own)              what does not exist, or does not go together
 */
#ifndef COMPARE_LAB_SETTINGS_H
#define COMPARE_LAB_SETTINGS_H

#include "../../07_mesh/files/nff_world.h"
#include "../../07_mesh/files/obj.h"
#include "../../07_mesh/scenes/named.h"
#include "knobs.h"

enum { most_meshes = 12 };
typedef struct { const char *rays, *hits, *costs; bool any; } compare_files;
typedef struct {
    const char *scene, *mesh[most_meshes], *only, *sweep, *protocol, *up, *from, *at;
    const char *report, *torture, *score;
    int scale, megabytes;
    double angle;
    bool verify, regimes, orders;
    compare_files files;
} compare_options;

/* ---------------------------------------------------------------------------------------------- */

/* Three numbers with commas between; no text: `usual`. */
static inline vec3 read_point(const char *name, const char *text, vec3 usual)
{
    const char *at = text;
    double x[3];
    if (!text) return usual;
    for (int k = 0; k < 3; k++) {
        char *after;
        x[k] = strtod(at, &after);
        if (after == at || !isfinite(x[k]) || *after != (k < 2 ? ',' : 0))
            die(2, "--%s %.100s: allowed are X,Y,Z", name, text);
        at = after + 1;
    }
    return vec(x[0], x[1], x[2]);
}

/* View from outside: what is not given stays as it is. */
static inline void own_view(const compare_options *own, world *w)
{
    failure f;
    vec3 eye = read_point("from", own->from, w->from), target = read_point("at", own->at, w->at);
    if (!own->from && !own->at && own->angle <= 0) return;
    if (!world_look(w, eye, target, w->up, own->angle > 0 ? (real)own->angle : w->angle, &f))
        die(2, "--from, --at: %s", f.text);
}

static inline void own_world(const compare_options *own, const char *path, world *w)
{
    failure f;
    mesh m;
    if (ends_with(path, ".nff")) {  /* one without a view has that of both options, upright */
        nff_view v = {.up = {0, 0, 1}, .angle = 45};
        v.from = read_point("from", own->from, v.from), v.at = read_point("at", own->at, v.at);
        if (!nff_world(path, own->from && own->at ? &v : NULL, w, &f)) fail(f);
        world_to_mesh(w);
    } else {
        bool z_up = own->up && strcmp(own->up, "z") == 0;
        if (!obj_read(path, &m, &f)) fail(f);
        if (m.t) fprintf(stderr, "%s: %s: textures are ignored: only hits are compared\n",
                         program_name, path);
        if (!mesh_world(w, path, m, z_up, &f)) fail(f);
    }
    const char *slash = strrchr(path, '/');
    w->name = slash ? slash + 1 : path;
    own_view(own, w);
}

/* What does not go together. */
static inline void check_options(const options *o, const compare_options *own)
{
    const generator *g = own->scene ? scene_find(own->scene) : NULL;
    bool view = own->from || own->at || own->angle > 0 || own->up, rays = own->files.rays;
    if (own->scene && !g) {
        char all[512] = "";
        for (int k = 0; k < scenes; k++) text_add(all, sizeof all, " %s", scene_list[k].name);
        die(2, "--scene %.100s: allowed are%s", own->scene, all);
    }
    if (g && own->scale >= 0 && (own->scale < g->least || own->scale > g->most))
        die(2, "--scale %d: allowed for %s are whole numbers from %d to %d", own->scale, g->name,
            g->least, g->most);
    if (own->protocol && strcmp(own->protocol, "spd") != 0)
        die(2, "--protocol %.100s: allowed is spd", own->protocol);
    if (own->up && strcmp(own->up, "y") != 0 && strcmp(own->up, "z") != 0)
        die(2, "--up %.20s: allowed are y and z", own->up);
    bool timed = !own->verify && !own->protocol && !rays;
    bool spd = !own->mesh[0] && !rays && !own->verify && !own->sweep
               && (!g || generator_find(spd_list, spd_scenes, g->name));
    bool other = own->scene || own->mesh[0] || !timed || own->sweep || own->torture || o->out
                 || o->csv;
    const struct { bool wrong; const char *says; } rules[] = {
        {own->scene && own->mesh[0], "--scene and --mesh: one of them"},
        {own->scale >= 0 && !own->scene, "--scale needs --scene NAME"},
        {view && !own->mesh[0], "--up, --from, --at and --angle need --mesh FILE"},
        {own->protocol && !spd, "--protocol spd: goes with --scene balls, gears, mount, rings, "
                                "teapot, tetra or tree alone"},
        {(own->files.hits || own->files.any || own->files.costs) && !rays,
         "--hits, --costs and --any-hit need --rays FILE"},
        {rays && own->verify, "--rays and --verify: one of them"},
        {rays && own->mesh[1], "--rays goes with one --mesh"},
        {own->sweep && (own->only || !timed), "--sweep goes with tables, and not with --only"},
        {own->score && !own->torture, "--score needs --torture FOLDER"},
        {own->torture && (own->scene || own->mesh[0] || !timed || own->sweep || own->report
                          || o->out), "--torture has meshes and rays of its own"},
        {own->regimes && other, "--regimes has scenes of its own"},
        {own->orders && (other || own->regimes || own->only || own->report),
         "--orders has scenes and structures of its own"},
        {o->csv && (own->verify || own->protocol || own->sweep),
         "--csv goes with tables: not with --verify, not with --protocol, not with --sweep"},
        {own->report && !timed, "--report goes with what is measured: not with --verify, "
                                   "--protocol, --rays"},
        {(o->out || o->preview) && (own->scene || own->mesh[0] || !timed || own->sweep
                                    || own->report || own->regimes || own->orders || own->torture),
         "--out and --preview are for the picture of all scenes: they go with no other work"},
        {o->out && o->csv, "--out draws, --csv measures: one of them"}};
    for (size_t k = 0; k < sizeof rules / sizeof *rules; k++)
        if (rules[k].wrong) die(2, "%s", rules[k].says);
}

#endif
