/* cases.c: the catalogue of hard cases: `make hard-cases` builds and runs it, in double and float.
 *
 * One table over the chapters. A row: what is tried and how often; who knows the truth; how many
 * answers the first version (first.h, or the textbook's way) gets wrong, and how many the default.
 * Where the last column says 0, none may be wrong: otherwise the program ends with 1. Inputs and
 * oracles are mostly those of the chapters' own laboratories; each row is explained in
 * tests/README.md, and every "Where it breaks" of a page is among them. */
#include "shapes.h"
#include "structures.h"
#include "light.h"  /* last: some of its types have common names */
#include "../../common/lab/table.h"

static size_t broken, rows;

static void add(table *t, const hard_case *c)
{
    hard_count n = c->count(c->k, c->x);
    table_text(t, "%s", c->chapter), table_text(t, "%s", c->name), table_text(t, "%s", c->how);
    table_text(t, "%s", c->oracle), table_count(t, n.tried), table_count(t, n.first);
    table_count(t, n.now), table_text(t, hard_promised(c) ? "0" : "-");
    rows++, broken += hard_promised(c) ? n.now : 0;
}

static void add_all(table *t, const hard_case *c, size_t n)
{
    for (size_t i = 0; i < n; i++) add(t, &c[i]);
}

int main(void)
{
    table t = table_new("Hard cases", "chapter|case|how|oracle|tried|first: wrong|default: wrong|"
                                      "promised");
    add_all(&t, hard_shapes, sizeof hard_shapes / sizeof *hard_shapes);
    add_all(&t, hard_structures, sizeof hard_structures / sizeof *hard_structures);
    for (int k = 0; k < torture_classes; k++)
        add(&t, &(hard_case){"17", torture_list[k].name, torture_list[k].what, WHOLE,
                             torture_of_class, k, 0, PROMISED});
    add_all(&t, hard_light, sizeof hard_light / sizeof *hard_light);
    printf("# %s, real = %s\n", t.title, real_is_float ? "float" : "double");
    table_print(&t, stdout);
    table_free(&t);
    printf("# %zu cases, %zu wrong where 0 is promised\n", rows, broken);
    return broken > 0;
}
