/* knobs.h: structures and their options, from a text.
 *
 *   line_up all = chosen_of("bvh:leaf=8:cost=1,kdtree:bonus=0")      NULL: the usual
 *   line_up all = swept_of("bvh:leaf=1..32")     the usual, and the BVH with leaves of 1, 2, 4 ..
 *                                                32; up to 17 values, one by one or doubling
 *
 * Which options there are says the list below: a line for each. Misuse ends the program, exit 2.
 */
#ifndef COMPARE_LAB_KNOBS_H
#define COMPARE_LAB_KNOBS_H

#include "compare.h"

typedef struct {
    const char *type, *name;
    size_t offset;
    knob_type kind;
    double lowest, highest;
} knob;

#define KNOB_AT(X, member) offsetof(X##_options, member)
static const knob knobs[] = {
    {"grid", "density", KNOB_AT(grid, density), KNOB_DOUBLE, 1e-6, 1e6},
    {"grid", "exact", KNOB_AT(grid, exact), KNOB_FLAG, 0, 1},
    {"grid", "mailbox", KNOB_AT(grid, mailbox), KNOB_FLAG, 0, 1},
    {"nested", "outer", KNOB_AT(nested, outer), KNOB_DOUBLE, 1e-6, 1e6},
    {"nested", "inner", KNOB_AT(nested, inner), KNOB_DOUBLE, 1e-6, 1e6},
    {"octree", "leaf", KNOB_AT(octree, leaf), KNOB_INT, 1, 1e6},
    {"octree", "depth", KNOB_AT(octree, depth), KNOB_INT, 0, octree_most_depth},
    {"octree", "mailbox", KNOB_AT(octree, mailbox), KNOB_FLAG, 0, 1},
    {"kdtree", "rule", KNOB_AT(kdtree, strategy), KNOB_INT, 0, kdtree_strategies - 1},
    {"kdtree", "leaf", KNOB_AT(kdtree, leaf), KNOB_INT, 0, 1e6},
    {"kdtree", "depth", KNOB_AT(kdtree, depth), KNOB_INT, 0, kdtree_most_depth},
    {"kdtree", "cost", KNOB_AT(kdtree, item_cost), KNOB_DOUBLE, 1e-3, 1e3},
    {"kdtree", "bonus", KNOB_AT(kdtree, empty_bonus), KNOB_DOUBLE, 0, 0.99},
    {"kdtree", "clip", KNOB_AT(kdtree, clip), KNOB_FLAG, 0, 1},
    {"bsp", "rule", KNOB_AT(bsp, rule), KNOB_INT, 0, bsp_rules - 1},
    {"bsp", "leaf", KNOB_AT(bsp, leaf), KNOB_INT, 1, 1e6},
    {"bsp", "depth", KNOB_AT(bsp, depth), KNOB_INT, 0, 60},
    {"bsp", "candidates", KNOB_AT(bsp, candidates), KNOB_INT, 1, 1e3},
    {"bvh", "rule", KNOB_AT(bvh, rule), KNOB_NAME, 0, 0},  /* a name of bvh_rules */
    {"bvh", "leaf", KNOB_AT(bvh, leaf), KNOB_INT, 1, 255},
    {"bvh", "cost", KNOB_AT(bvh, item_cost), KNOB_DOUBLE, 1e-3, 1e3},
    {"bvh8", "leaf", KNOB_AT(bvh8, leaf), KNOB_INT, 1, 8},
    {"bvh8", "cost", KNOB_AT(bvh8, leaf_cost), KNOB_DOUBLE, 1e-3, 1e3},
    {"bvh8", "shape", KNOB_AT(bvh8, shape_cost), KNOB_DOUBLE, 1e-3, 1e3},
    {"bvh8", "bins", KNOB_AT(bvh8, bins), KNOB_INT, 4, 32},
    {"bvh8", "width", KNOB_AT(bvh8, width), KNOB_INT, 2, 8}};

/* ---------------------------------------------------------------------------------------------- */

static inline const knob *knob_find(const contender *c, const char *name, size_t length)
{
    for (size_t k = 0; k < sizeof knobs / sizeof *knobs; k++)
        if (strcmp(knobs[k].type, c->type) == 0 && strlen(knobs[k].name) == length
            && strncmp(knobs[k].name, name, length) == 0) return &knobs[k];
    return NULL;
}

/* All there are: names of structures, or of the options of c. */
static inline const char *knob_names(const contender *c)
{
    static char all[512];
    all[0] = 0;
    for (int k = 0; !c && k < contenders; k++)
        snprintf(all + strlen(all), sizeof all - strlen(all), " %s", contender_list[k]->name);
    for (size_t k = 0; c && k < sizeof knobs / sizeof *knobs; k++)
        if (strcmp(knobs[k].type, c->type) == 0)
            snprintf(all + strlen(all), sizeof all - strlen(all), " %s", knobs[k].name);
    return all[0] ? all : " none";
}

static inline bool knob_any(const knob *k)  /* number, not whole ones only */
{
    return k->kind == KNOB_DOUBLE;
}

/* A number at `text`; past it. */
static inline const char *knob_value(const knob *k, const char *text, double *x)
{
    char *after;
    *x = strtod(text, &after);
    bool whole = knob_any(k) || *x == floor(*x);
    if (after == text || !(*x >= k->lowest && *x <= k->highest) || !whole)
        die(2, "%s=%.20s: allowed are %s from %g to %g", k->name, text,
            knob_any(k) ? "numbers" : "whole numbers", k->lowest, k->highest);
    return after;
}

static inline void choice_set(compare_choice *p, const knob *k, double x)
{
    if (p->how.n == 8) die(2, "%s: eight options are the most", p->label);
    p->how.set[p->how.n++] = (contender_setting){k->offset, k->kind, x, NULL};
    size_t n = strlen(p->label);
    snprintf(p->label + n, sizeof p->label - n, ":%s=%.6g", k->name, x);
}

/* The one option that is a name. Past it. */
static inline const char *choice_rule(compare_choice *p, const knob *k, const char *text)
{
    char name[24];
    size_t length = strcspn(text, ":,"), n = strlen(p->label);
    snprintf(name, sizeof name, "%.*s", (int)(length < 23 ? length : 23), text);
    const bvh_rule *rule = bvh_rule_find(name);
    if (!rule) {
        char all[256] = "";
        for (int i = 0; i < bvh_rule_count; i++)
            snprintf(all + strlen(all), sizeof all - strlen(all), " %s", bvh_rules[i].name);
        die(2, "%s=%s: allowed are%s", k->name, name, all);
    }
    if (p->how.n == 8) die(2, "%s: eight options are the most", p->label);
    p->how.set[p->how.n++] = (contender_setting){k->offset, KNOB_NAME, 0, rule->name};
    snprintf(p->label + n, sizeof p->label - n, ":%s=%s", k->name, rule->name);
    return text + length;
}

/* "bvh:leaf=8". */
static inline void choose_text(line_up *all, const char *text, size_t length, const char *where)
{
    const char *end = text + length, *at = text + strcspn(text, ":,");
    char name[32];
    snprintf(name, sizeof name, "%.*s", (int)(at - text < 31 ? at - text : 31), text);
    const contender *c = contender_find(name);
    if (!c) die(2, "%s %.100s: allowed are, with commas between:%s", where, text, knob_names(c));
    choose(all, c);
    while (at < end) {
        double x;
        const char *word = at + 1;
        size_t n = strcspn(word, "=:,");
        const knob *k = knob_find(c, word, n);
        if (!k || word[n] != '=')
            die(2, "%s %.100s: options of %s, as in %s:%s=1: %s", where, text, name, name,
                "NAME", knob_names(c) + 1);
        if (k->kind == KNOB_NAME) {
            at = choice_rule(&all->of[all->n - 1], k, word + n + 1);
            continue;
        }
        at = knob_value(k, word + n + 1, &x);
        if (*at && *at != ':' && *at != ',')
            die(2, "%s %.100s: a number ends before '%.10s'", where, text, at);
        choice_set(&all->of[all->n - 1], k, x);
    }
}

static inline line_up chosen_of(const char *only)
{
    line_up all = {.n = 0};
    if (!only) return choose_usual();
    for (const char *at = only + strspn(only, ","); *at; at += strspn(at, ",")) {
        size_t length = strcspn(at, ",");
        choose_text(&all, at, length, "--only");
        at += length;
    }
    if (!all.n) die(2, "--only %.100s: names no structure", only);
    return all;
}

/* The next value: one more, while that are few; else twice as much. */
static inline double sweep_next(const knob *k, double x, double from, double to)
{
    if (!knob_any(k) && to - from <= 16) return x + 1;
    if (knob_any(k) && from <= 0) return x + (to - from) / 8;
    return x < 1 && !knob_any(k) ? x + 1 : 2 * x;
}

static inline line_up swept_of(const char *text)
{
    const char *dots = strstr(text, ".."), *equals = dots;
    double from, to;
    while (equals && equals > text && *equals != '=') equals--;
    const char *colon = equals;
    while (colon && colon > text && *colon != ':') colon--;
    if (!dots || colon == text || strchr(text, ','))
        die(2, "--sweep %.100s: allowed is one structure with a range, as in bvh:leaf=1..32", text);
    line_up all = choose_usual(), one = {.n = 0};
    char front[128];
    snprintf(front, sizeof front, "%.*s", (int)(colon - text), text);
    choose_text(&one, front, strlen(front), "--sweep");
    const knob *k = knob_find(one.of[0].c, colon + 1, (size_t)(equals - colon - 1));
    if (!k || k->kind == KNOB_NAME)
        die(2, "--sweep %.100s: options of %s:%s", text, front, knob_names(one.of[0].c));
    char first[32];  /* alone: a number may end with a dot */
    snprintf(first, sizeof first, "%.*s", (int)(dots - equals - 1), equals + 1);
    if (*knob_value(k, first, &from) || *knob_value(k, dots + 2, &to) || !(from < to))
        die(2, "--sweep %.100s: a range is FROM..TO", text);
    for (double x = from; x <= to; x = sweep_next(k, x, from, to)) {
        choose(&all, one.of[0].c);
        all.of[all.n - 1] = one.of[0];
        choice_set(&all.of[all.n - 1], k, x);
    }
    return all;
}

#endif
