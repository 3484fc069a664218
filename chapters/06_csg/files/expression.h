/* expression.h: a tree of solids from a line of text.
 *
 *   difference(box -1 -1 -1 1 1 1, sphere 0 0 1 0.8, cylinder 0 0 0 1 0 0 0.4)
 *
 *   whole   = solid | union(whole, whole ..) | intersection(whole, whole ..) | difference(..)
 *   solid   = sphere x y z radius          box x y z x y z, from the least to the greatest corner
 *             half nx ny nz h              cylinder x y z ax ay az radius: a point, the axis
 *             gem x y z radius             an octahedron, as a closed mesh of eight triangles
 *
 * Operands are joined from the left: difference(a, b, c) is (a - b) - c. Blanks stand where one
 * likes, and between numbers. Parentheses nest as deep as memory allows: nothing here calls itself.
 *
 *   csg_expression e;
 *   if (!csg_read(text, &e, &f)) fail(f);      "character 14: ...": what stands there, what may
 *   csg_build(csg_expression_model(&e), (csg_options){0}, &c, &f);
 *   csg_free(&c), csg_expression_free(&e);     in this order: c asks e's solids
 */
#ifndef CSG_EXPRESSION_H
#define CSG_EXPRESSION_H

#include "../../../common/numbers/decimal.h"
#include "../tree.h"

typedef struct {
    csg_solid *solid;
    csg_step *step;
    size_t solids, steps, solid_room, step_room;
} csg_expression;

/* ---------------------------------------------------------------------------------------------- */

typedef struct { csg_operation what; size_t operands; } csg_open;  /* a parenthesis to be closed */
typedef struct {
    const char *text, *p;
    failure *why;
    csg_expression e;
    csg_open *open;
    size_t opens, open_room;
} csg_reader;

static inline void csg_expression_free(csg_expression *e)
{
    for (size_t i = 0; i < e->solids; i++)
        if (e->solid[i].kind == CSG_MESH) free((void *)(uintptr_t)e->solid[i].mesh.tri);
    free(e->solid), free(e->step);
    *e = (csg_expression){0};
}

static inline csg_model csg_expression_model(const csg_expression *e)
{
    return (csg_model){e->solid, e->solids, e->step, e->steps};
}

/* Eight faces of the octahedron with corners c +- r along each axis, anticlockwise from outside. */
static inline csg_solid csg_gem(vec3 c, real r)
{
    triangle *t = allocate(8, sizeof *t);
    for (int i = 0; i < 8; i++) {
        vec3 x = vadd(c, vec(i & 1 ? -r : r, 0, 0)), y = vadd(c, vec(0, i & 2 ? -r : r, 0));
        vec3 z = vadd(c, vec(0, 0, i & 4 ? -r : r));
        bool odd = ((i & 1) + (i >> 1 & 1) + (i >> 2 & 1)) % 2;
        t[i] = odd ? (triangle){x, z, y} : (triangle){x, y, z};
    }
    return csg_mesh(t, 8);
}

/* Always false: what was found, and what may stand there. What could hurt a terminal is a "?". */
static inline bool csg_wanted(csg_reader *r, const char *wanted)
{
    char shown[28] = "the end";
    size_t n = 0;
    for (; n < 20 && (unsigned char)r->p[n] > ' '; n++)
        shown[n + 1] = (char)((unsigned char)r->p[n] < 127 ? r->p[n] : '?');
    if (n > 0) shown[0] = '\'', strcpy(shown + n + 1, n < 20 ? "'" : "..'");
    else if (*r->p) snprintf(shown, sizeof shown, "byte %d", (unsigned char)*r->p);
    return failed(r->why, 2, "character %zu: %s, allowed: %s", (size_t)(r->p - r->text) + 1, shown,
                  wanted);
}

static inline void csg_blanks(csg_reader *r)
{
    while (*r->p == ' ' || *r->p == '\t' || *r->p == '\n') r->p++;
}

/* True, and behind it, if this word comes next and no letter goes on. */
static inline bool csg_word(csg_reader *r, const char *word)
{
    size_t n = strlen(word);
    bool is = strncmp(r->p, word, n) == 0 && !isalpha((unsigned char)r->p[n]);
    if (is) r->p += n;
    return is;
}

static inline bool csg_numbers(csg_reader *r, int n, real *x)
{
    for (int i = 0; i < n; i++) {
        double value;
        csg_blanks(r);
        const char *end = decimal_read(r->p, &value);
        if (!end || (*end != 0 && !strchr(" \t\n,)", *end)))
            return csg_wanted(r, "a decimal number, and a blank");
        if (!(fabs(value) <= 1e30)) return csg_wanted(r, "numbers from -1e30 to 1e30");
        x[i] = (real)value, r->p = end;
    }
    return true;
}

static inline bool csg_read_solid(csg_reader *r)
{
    static const struct { const char *name; int numbers; } known[] = {
        {"sphere", 4}, {"half", 4}, {"box", 6}, {"cylinder", 7}, {"gem", 4}};
    real x[7] = {0};
    for (int k = 0; k < 5; k++) {
        if (!csg_word(r, known[k].name)) continue;
        if (!csg_numbers(r, known[k].numbers, x)) return false;
        vec3 a = {x[0], x[1], x[2]}, b = {x[3], x[4], x[5]};
        csg_expression *e = &r->e;
        e->solid = grown(e->solid, e->solids, &e->solid_room, sizeof *e->solid);
        e->solid[e->solids++] = k == 0 ? csg_sphere(a, x[3]) : k == 1 ? csg_half(a, x[3])
            : k == 2 ? csg_box(a, b)
            : k == 3 ? csg_cylinder(a, b, x[6]) : csg_gem(a, x[3]);
        return true;
    }
    return csg_wanted(r, "sphere, box, half, cylinder, gem, union(, intersection(, difference(");
}

static inline void csg_add_step(csg_expression *e, csg_operation what)
{
    e->step = grown(e->step, e->steps, &e->step_room, sizeof *e->step);
    e->step[e->steps++] = (csg_step){what, what == CSG_SOLID ? (uint32_t)e->solids - 1 : 0};
}

/* At an operation: goes into its parenthesis. */
static inline bool csg_read_operation(csg_reader *r)
{
    static const char *const name[] = {"", "union", "intersection", "difference"};
    const char *start = r->p;
    for (int k = CSG_UNION; k <= CSG_DIFFERENCE; k++) {
        if (!csg_word(r, name[k])) continue;
        csg_blanks(r);
        if (*r->p != '(') return r->p = start, false;
        r->p++;
        r->open = grown(r->open, r->opens, &r->open_room, sizeof *r->open);
        r->open[r->opens++] = (csg_open){(csg_operation)k, 0};
        return true;
    }
    return false;
}

/* Behind an operand: joins it to those before, and closes what ends here. */
static inline bool csg_read_end(csg_reader *r, bool *more)
{
    for (*more = false;; r->opens--, r->p++) {
        csg_blanks(r);
        if (r->opens == 0) return *r->p == 0 || csg_wanted(r, "nothing more");
        csg_open *top = &r->open[r->opens - 1];
        if (++top->operands > 1) csg_add_step(&r->e, top->what);
        if (*r->p == ',') return r->p++, *more = true;
        if (*r->p != ')') return csg_wanted(r, "a comma or )");
        if (top->operands < 2) return csg_wanted(r, "a comma, as an operation takes two or more");
    }
}

static inline bool csg_read(const char *text, csg_expression *out, failure *why)
{
    csg_reader r = {.text = text, .p = text, .why = why};
    bool ok = true, more = true;
    while (ok && more) {
        csg_blanks(&r);
        if (csg_read_operation(&r)) continue;
        ok = csg_read_solid(&r);
        if (ok) csg_add_step(&r.e, CSG_SOLID);
        ok = ok && csg_read_end(&r, &more);
    }
    free(r.open);
    if (ok) *out = r.e;
    else csg_expression_free(&r.e);
    return ok;
}

#endif
