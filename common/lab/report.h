/* report.h: saves plots, prints tables: what a chapter measured. Where they go: output.h.
 *
 *   output_plot(&o, &p, "14_bvh_pareto_time.svg")   saves and frees a plot
 *   output_table(&o, &t)                       prints and frees the main table; --csv gets it, too
 *   bool output_csv(&o, &t, &f)                to --csv alone
 *   output_extra_table(&o, &t)                 prints and frees another one
 */
#ifndef REPORT_H
#define REPORT_H

#include "../output.h"
#include "plot.h"
#include "table.h"
#include <sys/utsname.h>

#ifndef BUILD_FLAGS
#define BUILD_FLAGS "not known"  /* the Makefile passes CFLAGS */
#endif

/* ---------------------------------------------------------------------------------------------- */

/* Saves and frees a plot. */
cold_inline void output_plot(const options *o, plot *p, const char *name)
{
    char room[512];
    failure f;
    file_writer w;
    const char *path = output_path(o, name, false, room);
    if (path && !file_begin(&w, path, &f)) fail(f);
    if (path) plot_write(p, w.stream);
    if (path && !file_commit(&w, &f)) fail(f);
    if (path) output_note(path);
    plot_free(p);
}

/* Prints a table, and frees it. */
static inline void output_extra_table(const options *o, table *t)
{
    struct utsname u;
    (void)o;
    printf("# %s\n# ", t->title);
    if (uname(&u) >= 0) printf("%s %s, %d cores; ", u.sysname, u.machine, parallel_cores());
    printf("%s%s; ", strstr(__VERSION__, "lang") ? "" : "gcc ", __VERSION__);
    printf("flags %s; real = %s\n", BUILD_FLAGS, real_is_float ? "float" : "double");
    table_print(t, stdout);
    printf("\n");
    table_free(t);
}

/* To the file of --csv, if there is one. */
static inline bool output_csv(const options *o, table *t, failure *f)
{
    file_writer w;
    if (!o->csv) return true;
    if (!file_begin(&w, o->csv, f)) return false;
    table_csv(t, w.stream);
    return file_commit(&w, f);
}

/* The main table: it goes to the file of --csv, too. */
static inline void output_table(const options *o, table *t)
{
    failure f;
    bool ok = output_csv(o, t, &f);
    output_extra_table(o, t);
    if (!ok) fail(f);  /* after the table was shown */
}

#endif
