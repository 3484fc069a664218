/* settings.h: the options of this chapter, and what is wrong with them.
 *
 *   chosen_of("grid,bvh")       bit k: number k of contender_list; NULL: the usual
 *   read_region(text, part)     four numbers: a part of the view
 *   check_options(&o, &own)     what does not exist, or does not go together
 * Misuse ends the program with exit 2 and a message.
 */
#ifndef COMPARE_LAB_SETTINGS_H
#define COMPARE_LAB_SETTINGS_H

#include "modes.h"

typedef struct {
    const char *scene, *mesh, *only, *protocol, *region;
    int scale, megabytes;
    bool verify, large;
    compare_files files;
} compare_options;

/* ---------------------------------------------------------------------------------------------- */

static inline unsigned chosen_of(const char *only)
{
    unsigned chosen = 0;
    if (!only) return (1u << usual_contenders) - 1;
    for (const char *at = only + strspn(only, ","); *at; at += strspn(at, ",")) {
        int length = (int)strcspn(at, ","), k = 0;
        char name[32];
        snprintf(name, sizeof name, "%.*s", length, at);
        while (k < contenders && strcmp(contender_list[k]->name, name) != 0) k++;
        if (k < contenders) chosen |= 1u << k;
        else {
            char all[256] = "";
            for (k = 0; k < contenders; k++)
                snprintf(all + strlen(all), sizeof all - strlen(all), " %s",
                         contender_list[k]->name);
            die(2, "--only %.100s: allowed are, with commas between:%s", only, all);
        }
        at += length;
    }
    if (!chosen) die(2, "--only %.100s: names no structure", only);
    return chosen;
}

static inline void read_region(const char *text, double region[4])
{
    failure f;
    char after;
    if (!text) return;
    if (sscanf(text, "%lf,%lf,%lf,%lf%c", &region[0], &region[1], &region[2], &region[3], &after)
            == 4 && region[0] < region[2] && region[1] < region[3] && fabs(region[0]) <= 1
        && fabs(region[1]) <= 1 && fabs(region[2]) <= 1 && fabs(region[3]) <= 1) return;
    failed(&f, 2, "--region %.100s: allowed are X0,Y0,X1,Y1 from -1 to 1, X0 < X1, Y0 < Y1", text);
    fail(f);
}

/* What does not go together. */
static inline void check_options(const options *o, const compare_options *own)
{
    failure f = {0, ""};
    const generator *g = own->scene ? scene_find(own->scene) : NULL;
    if (own->scene && !g) {
        char all[128] = "";
        for (int k = 0; k < scenes; k++)
            snprintf(all + strlen(all), sizeof all - strlen(all), " %s", scene_list[k].name);
        failed(&f, 2, "--scene %.100s: allowed are%s", own->scene, all);
    } else if (own->scene && own->mesh) failed(&f, 2, "--scene and --mesh: one of them");
    else if (own->scale >= 0 && !own->scene) failed(&f, 2, "--scale needs --scene NAME");
    else if (g && own->scale >= 0 && (own->scale < g->least || own->scale > g->most))
        failed(&f, 2, "--scale %d: allowed for %s are whole numbers from %d to %d", own->scale,
               g->name, g->least, g->most);
    else if (own->protocol && strcmp(own->protocol, "spd") != 0)
        failed(&f, 2, "--protocol %.100s: allowed is spd", own->protocol);
    else if (own->protocol && (own->mesh || own->files.rays || own->verify
                               || (g && !generator_find(spd_list, spd_scenes, g->name))))
        failed(&f, 2, "--protocol spd: goes with --scene balls, gears, mount, rings, teapot, tetra "
                      "or tree alone");
    else if (!own->files.rays && (own->files.hits || own->files.any))
        failed(&f, 2, "--hits and --any-hit need --rays FILE");
    else if (own->files.rays && own->verify) failed(&f, 2, "--rays and --verify: one of them");
    else if (own->region && !own->verify) failed(&f, 2, "--region needs --verify");
    else if (o->csv && (own->verify || own->protocol))
        failed(&f, 2, "--csv goes with tables: not with --verify, not with --protocol");
    else if (o->out && (own->scene || own->mesh || own->verify || own->protocol || own->files.rays))
        failed(&f, 2, "--out is for the picture of all scenes: it goes with no other work");
    else if (o->out && o->csv) failed(&f, 2, "--out draws, --csv measures: one of them");
    if (f.exit_code) fail(f);
    if (own->files.hits && !file_try(own->files.hits, &f)) fail(f);
}

#endif
