/* torture_run.h: --torture FOLDER: the exact cases of torture.h in files, and who gets them wrong.
 *
 *   torture_run(&settings, folder, score)   folder NULL: writes nothing
 *
 * Writes CLASS.obj, CLASS.rays and CLASS.hits (what is right; at a tie the lowest triangle, though
 * any of them is) for each class, asks every structure, and prints how many answers are wrong.
 * score, not NULL: reads CLASS.SCORE.hits instead, which any other renderer may have written, and
 * judges that alone. Wrong answers, but for those of the first versions, end with exit 1.
 */
#ifndef COMPARE_LAB_TORTURE_RUN_H
#define COMPARE_LAB_TORTURE_RUN_H

#include "../../07_mesh/files/obj_write.h"
#include "../../07_mesh/files/ray_file.h"
#include "../../09_aabb/trials/torture.h"
#include "costs.h"

typedef struct { size_t wrong; double error; } torture_score;

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

static inline hit *torture_ask(const compare_choice *one, size_t most_bytes, const torture *t)
{
    failure f;
    items x = items_of_mesh(&t->m);
    hit *h = allocate(t->n, sizeof *h);
    void *built = contender_build(one->c, &one->how, &x, most_bytes, &f);
    if (!built) fail(f);
    one->c->search(built, t->r, t->n, false, h);
    contender_free(one->c, built);
    return h;
}

/* The file of another renderer. The rays must be those of this run: of the same seed. */
static inline hit *torture_read(const char *folder, const char *who, const torture *t, int k)
{
    failure f;
    char ending[128];
    size_t n;
    ray *r = rays_read(torture_path(folder, k, "rays"), &n, &f);
    if (!r) fail(f);
    if (n != t->n || memcmp(r, t->r, n * sizeof *r) != 0)  /* floats, there and here */
        die(2, "%s: not the rays of this seed and count: write them again, by --torture alone",
            torture_path(folder, k, "rays"));
    snprintf(ending, sizeof ending, "%.100s.hits", who);
    hit *h = hits_read(torture_path(folder, k, ending), n, &f);
    if (!h) fail(f);
    free(r);
    return h;
}

/* How many of these hits are wrong; frees them. */
static inline size_t torture_add(torture_score *s, const torture *t, hit *h)
{
    size_t wrong = 0;
    for (size_t i = 0; i < t->n; i++) {
        double error;
        wrong += torture_judge(t, i, h[i], &error) != TORTURE_RIGHT;
        s->error = fmax(s->error, error);
    }
    free(h);
    s->wrong += wrong;
    return wrong;
}

/* Asks all who take part about a class. A row: structures together; the worst first version. */
static inline void torture_row(const compare_settings *c, const char *folder, const char *who,
                               int k, torture_score *score, table *out)
{
    size_t wrong = 0, first = 0;
    int firsts = 0;
    compare_progress("torture", "asking about", torture_list[k].name);
    torture t = torture_make(k, c->o->quick ? 60 : 2000, c->o->seed);
    if (folder && !who) torture_write(&t, folder, k);
    if (who) wrong = torture_add(score, &t, torture_read(folder, who, &t, k));
    for (int j = 0; j < c->chosen.n && !who; j++) {
        const compare_choice *one = &c->chosen.of[j];
        size_t w = torture_add(&score[j], &t, torture_ask(one, c->most_bytes, &t));
        if (!contender_is_first(one->c)) wrong += w;
        else if (w > first) first = w;
        firsts += contender_is_first(one->c);
    }
    table_text(out, "%s", torture_list[k].name), table_text(out, "%s", torture_list[k].what);
    cost_cell(out, who || firsts < c->chosen.n, (double)wrong);
    if (!who) cost_cell(out, firsts > 0, (double)first);
    torture_free(&t);
}

cold_inline void torture_run(const compare_settings *c, const char *folder, const char *who)
{
    static const char *const ending[] = {"obj", "rays", "hits"};
    failure f;
    size_t faults = 0;
    torture_score score[compare_most] = {{0, 0}};
    char columns[160] = "class|aims at|error: structures|error: first versions, at most";
    if (who) snprintf(columns, sizeof columns, "class|aims at|error: %.100s", who);
    table out = table_new(c->o->quick ? "Wrong answers of 60 a class; exact arithmetic judges"
                                      : "Wrong answers of 2000 a class; exact arithmetic judges",
                          columns);
    for (int i = 0; folder && c->o->csv && i < 3 * torture_classes; i++)
        if (option_same_file(c->o->csv, torture_path(folder, i / 3, ending[i % 3])))
            die(2, "--csv %.200s: is a file of --torture", c->o->csv);  /* just written */
    if (folder && !who && mkdir(folder, 0777) != 0 && errno != EEXIST)
        die(1, "%.200s: cannot be made: %s", folder, strerror(errno));
    for (int k = 0; k < torture_classes; k++) torture_row(c, folder, who, k, score, &out);
    compare_progress("torture", NULL, NULL);
    bool saved = !folder || output_csv(c->o, &out, &f);
    html_element(c->to, "h2", "Torture");
    html_table(c->to, &out);
    if (!saved) fail(f);
    for (int j = 0; j < (who ? 1 : c->chosen.n); j++) {
        const compare_choice *p = &c->chosen.of[j];
        if (who || score[j].wrong)
            html_note(c->to, "%s: %zu wrong; its t are off by up to %.3g roundings of a float",
                      who ? who : p->label, score[j].wrong, score[j].error);
        faults += who || !contender_is_first(p->c) ? score[j].wrong : 0;
    }
    printf("\n");
    if (folder && !who) output_note(folder);
    if (faults) die(1, "%zu answers are wrong: see above", faults);
}

#endif
