/* knobs.h: structures and their options, from a text.
 *
 *   line_up all = chosen_of("bvh:leaf=8:cost=1,kdtree:rule=median")      NULL: the usual
 *   line_up all = swept_of("bvh:leaf=1..32")     the usual, and the BVH with leaves of 1, 2, 4 ..
 *                                                32; up to 17 values, one by one or doubling
 *   text_add(text, sizeof text, " %s", name)     printf, behind what is there
 *
 * Misuse ends the program, exit 2.
 */
#ifndef COMPARE_LAB_KNOBS_H
#define COMPARE_LAB_KNOBS_H

#include "contenders.h"

/* A structure with its options; label: what --only said, "bvh:leaf=8". out: it has its place, but
 * is not built. */
typedef struct {
    const contender *c;
    contender_settings how;
    char label[44];
    bool out;
} compare_choice;
enum { compare_most = 48 };
typedef struct { compare_choice of[compare_most]; int n; } line_up;

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
    {"bvh", "rule", KNOB_AT(bvh, rule), KNOB_NAME, 0, bvh_rule_count - 1},
    {"bvh", "leaf", KNOB_AT(bvh, leaf), KNOB_INT, 1, 255},
    {"bvh", "cost", KNOB_AT(bvh, item_cost), KNOB_DOUBLE, 1e-3, 1e3},
    {"bvh8", "leaf", KNOB_AT(bvh8, leaf), KNOB_INT, 1, 8},
    {"bvh8", "width", KNOB_AT(bvh8, width), KNOB_INT, 2, 8}};

/* The rules of 12 and of 13, in the order of their enums. */
static const char *const kdtree_rule_names[kdtree_strategies] = {
    [KD_MIDDLE] = "middle", [KD_MEDIAN] = "median", [KD_SAH] = "sah"};
static const char *const bsp_rule_names[bsp_rules] = {
    [BSP_RANDOM] = "random", [BSP_FEWEST] = "fewest", [BSP_AXIS] = "axis", [BSP_OWN] = "own",
    [BSP_COST] = "cost"};

/* ---------------------------------------------------------------------------------------------- */

__attribute__((format(printf, 3, 4)))
static inline void text_add(char *text, size_t room, const char *format, ...)
{
    size_t n = strlen(text);
    va_list list;
    va_start(list, format);
    vsnprintf(text + n, room - n, format, list);
    va_end(list);
}

static inline void choose(line_up *all, const contender *c)
{
    if (all->n == compare_most) die(2, "%d structures at once are the most", (int)compare_most);
    compare_choice *p = &all->of[all->n++];
    *p = (compare_choice){.c = c};
    text_add(p->label, sizeof p->label, "%.40s", c->name);
}

/* Those that take part without being asked for: all. */
static inline line_up choose_usual(void)
{
    line_up all = {.n = 0};
    for (int k = 0; k < contenders; k++) choose(&all, contender_list[k]);
    return all;
}

/* Neither brute force nor a first version: they must be right, and count their steps. */
static inline bool contender_counts(const contender *c)
{
    return c != &brute_contender && !contender_is_first(c);
}

static inline line_up choose_counting(const line_up *chosen)
{
    line_up some = {.n = 0};
    for (int k = 0; k < chosen->n; k++)
        if (contender_counts(chosen->of[k].c)) some.of[some.n++] = chosen->of[k];
    return some;
}

/* All there are: names of structures, or of the options of c. */
static inline const char *knob_names(const contender *c)
{
    static char all[512];
    all[0] = 0;
    for (int k = 0; !c && k < contenders; k++)
        text_add(all, sizeof all, " %s", contender_list[k]->name);
    for (size_t k = 0; c && k < sizeof knobs / sizeof *knobs; k++)
        if (!strcmp(knobs[k].type, c->type)) text_add(all, sizeof all, " %s", knobs[k].name);
    return all[0] ? all : " none";
}

static inline const knob *knob_find(const contender *c, const char *name)
{
    for (size_t k = 0; k < sizeof knobs / sizeof *knobs; k++)
        if (!strcmp(knobs[k].type, c->type) && !strcmp(knobs[k].name, name)) return &knobs[k];
    return NULL;
}

/* Of value i; NULL: it has none. */
static inline const char *knob_value_name(const knob *k, int i)
{
    if (strcmp(k->name, "rule") != 0 || i > k->highest) return NULL;
    if (k->kind == KNOB_NAME) return bvh_rules[i].name;
    return strcmp(k->type, "bsp") == 0 ? bsp_rule_names[i] : kdtree_rule_names[i];
}

/* text: a number, or the name of one. */
static inline double knob_value(const knob *k, const char *text)
{
    char names[512] = "", *end;
    bool any = k->kind == KNOB_DOUBLE;
    for (int i = 0; knob_value_name(k, i); i++) {
        if (!strcmp(text, knob_value_name(k, i))) return i;
        text_add(names, sizeof names, " %s", knob_value_name(k, i));
    }
    double x = strtod(text, &end);
    if (end != text && !*end && x >= k->lowest && x <= k->highest && (any || x == floor(x)))
        return x;
    if (*names) die(2, "%s=%.20s: allowed are%s", k->name, text, names);
    die(2, "%s=%.20s: allowed are %s from %g to %g", k->name, text,
        any ? "numbers" : "whole numbers", k->lowest, k->highest);
}

static inline void choice_set(compare_choice *p, const knob *k, const char *value)
{
    double x = knob_value(k, value);
    const char *name = knob_value_name(k, (int)x);
    if (p->how.n == 8) die(2, "%s: eight options are the most", p->label);
    p->how.set[p->how.n++] = (contender_setting){k->offset, k->kind, x, name};
    text_add(p->label, sizeof p->label, ":%s=%s", k->name, name ? name : value);
}

/* "bvh:leaf=8", which is cut into its words. */
static inline void choose_text(line_up *all, char *text, const char *where)
{
    char *rest, *name = strtok_r(text, ":", &rest), *word;
    const contender *c = name ? contender_find(name) : NULL;
    if (!c) die(2, "%s %.100s: allowed are, with commas between:%s", where, text, knob_names(c));
    choose(all, c);
    while ((word = strtok_r(NULL, ":", &rest)) != NULL) {
        char *value = strchr(word, '=');
        if (value) *value++ = 0;
        const knob *k = value ? knob_find(c, word) : NULL;
        if (!k) die(2, "%s %.20s:%.100s: options of %.20s, as in %.20s:NAME=1: %s", where, name,
                    word, name, name, knob_names(c) + 1);
        choice_set(&all->of[all->n - 1], k, value);
    }
}

static inline line_up chosen_of(const char *only)
{
    line_up all = {.n = 0};
    if (!only) return choose_usual();
    char *text = allocate(strlen(only) + 1, 1), *rest;
    strcpy(text, only);
    for (char *one = strtok_r(text, ",", &rest); one; one = strtok_r(NULL, ",", &rest))
        choose_text(&all, one, "--only");
    if (!all.n) die(2, "--only %.100s: names no structure", only);
    free(text);
    return all;
}

/* The next value: one more, while that are few; else twice as much. */
static inline double sweep_next(knob_type kind, double x, double from, double to)
{
    if (kind == KNOB_DOUBLE) return from <= 0 ? x + (to - from) / 8 : 2 * x;
    return to - from <= 16 || x < 1 ? x + 1 : 2 * x;
}

static inline line_up swept_of(const char *text)
{
    char front[128], one[160], *end, *last;
    line_up all = choose_usual();
    const char *dots = strstr(text, "..");
    snprintf(front, sizeof front, "%.*s", dots ? (int)(dots - text) : 0, text);
    char *equals = strrchr(front, '=');  /* cut before the dots: a number may end with one */
    if (!equals || strchr(text, ','))
        die(2, "--sweep %.100s: allowed is one structure with a range, as in bvh:leaf=1..32", text);
    *equals = 0;
    double from = strtod(equals + 1, &end), to = strtod(dots + 2, &last);
    if (end == equals + 1 || *end || last == dots + 2 || *last || !(from < to))
        die(2, "--sweep %.100s: a range is FROM..TO", text);
    for (double x = from; x <= to;) {
        snprintf(one, sizeof one, "%s=%.6g", front, x);
        choose_text(&all, one, "--sweep");
        const contender_settings *how = &all.of[all.n - 1].how;
        x = sweep_next(how->set[how->n - 1].type, x, from, to);
    }
    return all;
}

#endif
