/* 27_effects: a renderer for scene files that simulates only what the scene calls for.
cc -std=c11 -O2 -ffp-contract=off -o 27_effects chapters/27_effects/main.c -lm -lpthread
 *
 *   27_effects room.scene --explain       a scene file, an OBJ or an NFF file: what it calls for
 *   27_effects --scene room.scene --out room.png --camera "from 0 1 5 at 0 1 0"
 *
 * Without options: the scene of demo.h. What the command line says of camera, lens, lights and
 * surroundings replaces what the files say; the words are those of scene files. */
#include "../../common/output.h"
#include "../02_camera/headlight.h"
#include "demo.h"
#include "explain.h"
#include "studio_read.h"
#include "studio_tree.h"

typedef struct { const studio_tree *t; const plan *p; camera c; real near; image *im; } job;

/* What the surface would look like by a lamp beside the eye. */
static void pixel(int x, int y, void *context)
{
    const job *j = context;
    studio_hit h = {hit_none, no_shape};
    ray r = camera_ray(j->c, (real)x + (real)0.5, (real)y + (real)0.5, j->im->width, j->im->height);
    vec3 c = sky_radiance(&j->t->s->sky, r.d);
    r.tmin = j->near;
    if (studio_tree_hit(j->t, r, &h)) {
        const appearance *a = &j->p->look[studio_hit_material(j->t, h)];
        vec3 sum = vadd(vadd(a->matte, a->highlight), vadd(vadd(a->mirror, a->glossy), a->through));
        c = vmul(vmin(sum, (vec3){1, 1, 1}), headlight(studio_surface(j->t, r, h).ns, r.d));
        c = vadd(c, vadd(a->flat, a->emits));
    }
    image_set(j->im, x, y, c);
}

static void draw(const options *o, const studio *s, const plan *p, camera c, real near)
{
    studio_tree t;
    failure f;
    image im = image_new(o->width, o->height);
    if (!studio_tree_build(s, &t, &f)) fail(f);
    job j = {&t, p, c, near, &im};
    bool whole = parallel_pixels(im.width, im.height, o->threads, "pixels", pixel, &j);
    output_picture(o, &im, "27_effects.png", true, whole);
    image_free(&im);
    studio_tree_free(&t);
}

static void table_of_effects(const options *o, const studio *s, const plan *p)
{
    table t = table_new("What the scene calls for", "effect|called|materials");
    for (int k = 0; k < effect_kinds; k++) {
        size_t n = 0;
        for (uint32_t m = 0; m < s->materials; m++)
            n += s->material[m].used && plan_effects(p, m) >> k & 1;
        table_text(&t, "%s", effect_names[k].name);
        table_text(&t, "%s", p->effects >> k & 1 ? "yes" : "no");
        table_count(&t, n);
    }
    output_table(o, &t);
}

/* room.scene alone stands for --scene=room.scene: of names that end so, nothing else is meant. */
static char *option_of_file(char *word)
{
    bool file = word[0] != '-'
        && (scene_ends(word, ".scene") || scene_ends(word, ".obj") || scene_ends(word, ".nff"));
    size_t room = strlen(word) + 16;
    if (!file) return word;
    char *words = allocate(room, 1);
    snprintf(words, room, "--scene=%s", word);
    return words;
}

int main(int argc, char **argv)
{
    const char *path = NULL;
    studio_words words = {.camera = NULL};
    bool told = false;
    const option own[] = {
        {"scene", OPTION_TEXT, &path, 0, 0, "FILE to draw: .obj, .nff, else a scene file"},
        {"explain", OPTION_FLAG, &told, 0, 0, "say what the scene calls for, and why"},
        {"camera", OPTION_TEXT, &words.camera, 0, 0, "from X Y Z at X Y Z [up X Y Z] [angle A]"},
        {"lens", OPTION_TEXT, &words.lens, 0, 0, "radius X [focus X]"},
        {"light", OPTION_TEXT, &words.light, 0, 0, "at X Y Z colour C [; at ...]"},
        {"sun", OPTION_TEXT, &words.sun, 0, 0, "to X Y Z colour C [; to ...]"},
        {"environment", OPTION_TEXT, &words.environment, 0, 0, "C, C C, or a picture"},
        {"background", OPTION_TEXT, &words.background, 0, 0, "C"},
        {"up", OPTION_TEXT, &words.up, 0, 0, "x, y or z: where no camera says it"},
        {0}};
    for (int i = 1; i < argc; i++)
        if (strcmp(argv[i - 1], "--scene") != 0) argv[i] = option_of_file(argv[i]);
    options o = options_read(argc, argv, "27_effects", "Draws scene files.",
                             (options){.width = 640, .height = 480}, own);
    if (o.quick && o.width == 640 && o.height == 480) o.width = 160, o.height = 120;
    studio s;
    studio_view view;
    camera c;
    failure f;
    if (path ? !studio_read(path, &words, &s, &f)
             : !studio_read_text(demo_scene, "demo.scene", &words, &s, &f)) fail(f);
    plan p = plan_of(&s);
    real aspect = (real)o.width / (real)o.height;
    if (!studio_camera(&s, aspect, &view, &c, &f)) fail(f);
    if (told) explain(stdout, &s, &p, &view);
    draw(&o, &s, &p, c, view.hither);
    if (!told) table_of_effects(&o, &s, &p);
    plan_free(&p);
    studio_free(&s);
    return 0;
}
