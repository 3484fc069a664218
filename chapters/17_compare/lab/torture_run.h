/* torture_run.h: --torture FOLDER: the exact cases of torture.h in files, and who gets them wrong.
 *
 *   torture_run(&settings, folder, score)   folder NULL: writes nothing
 *
 * Writes CLASS.obj, CLASS.rays and CLASS.hits (what is right) for each class, asks every structure,
 * and prints how many answers are wrong. score, not NULL: reads CLASS.SCORE.hits instead, which any
 * other renderer may have written, and judges that alone. Of hits at the same t the files name the
 * lowest triangle; the verdict takes each of them. Wrong answers, but for those of the first
 * versions, end the program with exit 1.
 */
#ifndef COMPARE_LAB_TORTURE_RUN_H
#define COMPARE_LAB_TORTURE_RUN_H

#include "../../07_mesh/files/obj_write.h"
#include "modes.h"
#include "../../09_aabb/trials/torture.h"

typedef struct { size_t wrong[torture_classes]; double error; } torture_score;

/* ---------------------------------------------------------------------------------------------- */

static inline const char *torture_path(const char *folder, int k, const char *ending)
{
    static char path[512];
    if (snprintf(path, sizeof path, "%s/%s.%s", folder, torture_list[k].name, ending) >= 512)
        die(2, "--torture %.100s...: too long", folder);
    return path;
}

static inline void torture_write(const torture *t, const char *folder, int k)
{
    failure f;
    hit *h = allocate(t->n, sizeof *h);
    for (size_t i = 0; i < t->n; i++) {
        torture_hit due = t->due[i];
        h[i] = due.shape == no_shape ? hit_none
               : (hit){(real)((double)due.t.num / (double)due.t.den), 0, 0, due.shape};
    }
    if (!obj_write(torture_path(folder, k, "obj"), &t->m, &f)
        || !rays_write(torture_path(folder, k, "rays"), t->r, t->n, &f)
        || !hits_write(torture_path(folder, k, "hits"), h, t->n, false, &f)) fail(f);
    free(h);
}

static inline void torture_add(torture_score *s, const torture *t, int k, const hit *h)
{
    for (size_t i = 0; i < t->n; i++) {
        double error;
        s->wrong[k] += torture_judge(t, i, h[i], &error) != TORTURE_RIGHT;
        s->error = fmax(s->error, error);
    }
}

static inline void torture_ask(const compare_choice *one, size_t most_bytes, const torture *t,
                               int k, torture_score *s)
{
    failure f;
    items x = items_of_mesh(&t->m);
    hit *h = allocate(t->n, sizeof *h);
    void *built = contender_build(one->c, &one->how, &x, most_bytes, &f);
    if (!built) fail(f);
    for (size_t i = 0; i < t->n; i++) h[i] = hit_none;
    one->c->search(built, t->r, t->n, false, h);
    torture_add(s, t, k, h);
    contender_free(one->c, built);
    free(h);
}

/* The files of another renderer. The rays must be those of this run: of the same seed. */
static inline void torture_read(const char *folder, const char *who, const torture *t, int k,
                                torture_score *s)
{
    failure f;
    char ending[128];
    size_t n;
    ray *r = rays_read(torture_path(folder, k, "rays"), &n, &f);
    if (!r) fail(f);
    bool same_rays = n == t->n;
    for (size_t i = 0; same_rays && i < n; i++) {
        const ray *a = &r[i], *b = &t->r[i];
        same_rays = vdot(a->d, b->d) == vdot(b->d, b->d) && vlength(vsub(a->o, b->o)) == 0
                    && a->tmin == b->tmin && a->tmax == b->tmax;
    }
    if (!same_rays)
        die(2, "%s: not the rays of this seed and count: write them again, by --torture alone",
            torture_path(folder, k, "rays"));
    snprintf(ending, sizeof ending, "%.100s.hits", who);
    hit *h = hits_read(torture_path(folder, k, ending), n, &f);
    if (!h) fail(f);
    torture_add(s, t, k, h);
    free(r), free(h);
}

static inline size_t torture_row(table *out, const char *name, const torture_score *s)
{
    size_t sum = 0;
    table_text(out, "%s", name);
    for (int k = 0; k < torture_classes; k++) table_count(out, s->wrong[k]), sum += s->wrong[k];
    table_count(out, sum), table_number(out, s->error);
    return sum;
}

static inline void torture_run(const compare_settings *c, const char *folder, const char *who)
{
    size_t n = c->o->quick ? 60 : 2000, faults = 0;
    int rows = who ? 1 : c->chosen.n;
    char columns[256] = "structure", title[160];
    torture_score *score = allocate((size_t)rows, sizeof *score);
    memset(score, 0, (size_t)rows * sizeof *score);
    if (folder && !who && mkdir(folder, 0777) != 0 && errno != EEXIST)
        die(1, "%.200s: cannot be made: %s", folder, strerror(errno));
    for (int k = 0; k < torture_classes; k++) {
        snprintf(columns + strlen(columns), sizeof columns - strlen(columns), "|%s",
                 torture_list[k].name);
        compare_progress("torture", "asking about", torture_list[k].name);
        torture t = torture_make(k, n, c->o->seed);
        if (folder && !who) torture_write(&t, folder, k);
        for (int j = 0; j < rows; j++) {
            if (who) torture_read(folder, who, &t, k, score);
            else torture_ask(&c->chosen.of[j], c->most_bytes, &t, k, &score[j]);
        }
        torture_free(&t);
    }
    compare_progress("torture", NULL, NULL);
    snprintf(title, sizeof title, "Wrong answers of %zu a class; exact arithmetic judges", n);
    strcat(columns, "|sum|error of t [2^-24]");
    table out = table_new(title, columns);
    for (int j = 0; j < rows; j++) {
        size_t wrong = torture_row(&out, who ? who : c->chosen.of[j].label, &score[j]);
        faults += who || !contender_is_first(c->chosen.of[j].c) ? wrong : 0;
    }
    if (folder) output_table(c->o, &out);
    else output_extra_table(c->o, &out);
    for (int k = 0; k < torture_classes; k++)
        printf("# %-8s %s\n", torture_list[k].name, torture_list[k].what);
    if (folder && !who) output_note(folder);
    free(score);
    if (faults) die(1, "%zu answers are wrong: see above", faults);
}

#endif
