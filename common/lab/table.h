/* table.h: a table for people and for programs.
 *
 *   table t = table_new("Error and time of a hit", "method|distance [R]|error [R]|time [ns]");
 *   table_text(&t, "naive"), table_count(&t, 100), table_number(&t, 1e-9), table_number(&t, 7.1);
 *   output_table(&o, &t);                     output.h: prints it, and writes it as CSV
 *
 * Cells, of up to 79 bytes, come row by row; what is missing in the last row stays empty. A column
 * whose name begins with "error" or "time" holds what was measured; the others say of what.
 * `make precision` sets the measured columns of float and double side by side.
 */
#ifndef TABLE_H
#define TABLE_H
#include "../file.h"
#include <math.h>

enum { table_cell_size = 80, table_most_columns = 16 };

typedef struct {
    const char *title;
    size_t columns;
    char (*cell)[table_cell_size];    /* n cells, row by row; row 0 holds the names */
    size_t n, room;
    bool number[table_most_columns];  /* columns that hold a number stand to the right */
} table;

/* ---------------------------------------------------------------------------------------------- */
__attribute__((format(printf, 2, 3)))
static inline void table_text(table *t, const char *format, ...)
{
    va_list arguments;
    t->cell = grown(t->cell, t->n, &t->room, table_cell_size);
    va_start(arguments, format);
    vsnprintf(t->cell[t->n++], table_cell_size, format, arguments);
    va_end(arguments);
}

/* `columns`: 1 to 16 names with their units, | between them. The title is not copied. */
static inline table table_new(const char *title, const char *columns)
{
    table t = {.title = title};
    for (const char *at = columns; t.columns == 0 || *at++ == '|'; t.columns++) {
        int length = (int)strcspn(at, "|");
        if (t.columns == table_most_columns) abort();
        table_text(&t, "%.*s", length, at);
        at += length;
    }
    return t;
}

static inline void table_free(table *t) { free(t->cell), *t = (table){.columns = 1}; }

/* Three significant digits: 0.00123, 12.3, 1230, 1.23e-05; nan, inf. */
static inline void table_number(table *t, double x)
{
    double size = fabs(x);
    t->number[t->n % t->columns] = true;
    if (size >= 100 && size < 1e6) table_text(t, "%.0f", x);
    else table_text(t, "%.3g", isnan(x) ? size : x);
}

static inline void table_count(table *t, size_t n)
{
    t->number[t->n % t->columns] = true;
    table_text(t, "%zu", n);
}

/* Columns on the screen: bytes that begin a UTF-8 character. */
static inline int table_width(const char *s)
{
    int n = 0;
    for (; *s; s++) n += (*s & 0xc0) != 0x80;
    return n;
}

static inline void table_print(table *t, FILE *out)
{
    while (t->n % t->columns) table_text(t, "%s", "");
    int width[table_most_columns] = {0};
    for (size_t i = 0; i < t->n; i++) {
        int w = table_width(t->cell[i]), *most = &width[i % t->columns];
        if (w > *most) *most = w;
    }
    for (size_t i = 0; i < t->n; i++) {
        size_t c = i % t->columns;
        int pad = width[c] - table_width(t->cell[i]), before = t->number[c] ? pad : 0;
        fprintf(out, "%*s%s", before, "", t->cell[i]);
        if (c + 1 == t->columns) fprintf(out, "\n");
        else fprintf(out, "%*s", pad - before + 2, "");
    }
}

/* RFC 4180: a cell with comma, quote or line break stands in quotes, its own quotes doubled. */
static inline void table_csv(table *t, FILE *out)
{
    while (t->n % t->columns) table_text(t, "%s", "");
    for (size_t i = 0; i < t->n; i++) {
        const char *s = t->cell[i], *quote = strpbrk(s, ",\"\r\n") ? "\"" : "";
        fprintf(out, "%s", quote);
        for (; *s; s++) fprintf(out, "%s%c", *s == '"' ? "\"" : "", *s);
        fprintf(out, "%s%c", quote, (i + 1) % t->columns ? ',' : '\n');
    }
}
#endif
