/* table.h: a table for people and for programs.
 *
 *   table t = table_new("Error and time of a hit", "method|distance [R]|error [R]|time [ns]");
 *   table_text(&t, "naive"), table_count(&t, 100), table_number(&t, 1e-9), table_number(&t, 7.1);
 *   output_table(&o, &t);                     output.h: prints it, and writes it as CSV
 *
 * Cells come row by row. A column whose name begins with "error" or "time" holds what was measured;
 * the others say of what. `make precision` sets the measured columns of float and double side by
 * side.
 */
#ifndef TABLE_H
#define TABLE_H

#include "file.h"
#include <math.h>

enum { table_cell_size = 48, table_most_columns = 16 };

typedef struct {
    const char *title;
    int columns;
    char name[table_most_columns][table_cell_size];
    char (*cell)[table_cell_size];  /* n cells, row by row */
    size_t n, room;
    bool number[table_most_columns];
} table;

/* ---------------------------------------------------------------------------------------------- */

/* `columns`: at most 16 names with their units, | between them. */
static inline table table_new(const char *title, const char *columns)
{
    table t = {.title = title};
    for (const char *at = columns; *at && t.columns < table_most_columns; at += *at == '|') {
        int length = (int)strcspn(at, "|");
        snprintf(t.name[t.columns++], table_cell_size, "%.*s", length, at);
        at += length;
    }
    return t;
}

static inline void table_free(table *t)
{
    free(t->cell);
    t->cell = NULL, t->n = t->room = 0;
}

__attribute__((format(printf, 2, 3)))
static inline void table_text(table *t, const char *format, ...)
{
    va_list arguments;
    t->cell = grown(t->cell, t->n, &t->room, table_cell_size);
    va_start(arguments, format);
    vsnprintf(t->cell[t->n++], table_cell_size, format, arguments);
    va_end(arguments);
}

/* Three significant digits: 0.00123, 12.3, 1230, 1.23e-05. */
static inline void table_number(table *t, double x)
{
    t->number[t->n % (size_t)t->columns] = true;
    double size = fabs(x);
    if (size >= 100 && size < 1e6) table_text(t, "%.0f", x);
    else table_text(t, "%.3g", x);
}

static inline void table_count(table *t, size_t n)
{
    t->number[t->n % (size_t)t->columns] = true;
    table_text(t, "%zu", n);
}

/* Columns on the screen: bytes that begin a UTF-8 character. */
static inline int text_width(const char *s)
{
    int n = 0;
    for (; *s; s++) n += (*s & 0xc0) != 0x80;
    return n;
}

static inline void table_print(const table *t, FILE *out)
{
    size_t columns = (size_t)t->columns, rows = t->n / columns;
    int width[table_most_columns];
    for (size_t c = 0; c < columns; c++) width[c] = text_width(t->name[c]);
    for (size_t i = 0; i < t->n; i++)
        if (width[i % columns] < text_width(t->cell[i])) width[i % columns] = text_width(t->cell[i]);
    for (size_t r = 0; r < rows + 1; r++, fprintf(out, "\n"))
        for (size_t c = 0; c < columns; c++) {
            const char *s = r ? t->cell[(r - 1) * columns + c] : t->name[c];
            int pad = width[c] - text_width(s);
            fprintf(out, "%s%*s%s", c ? "  " : "", t->number[c] ? pad : 0, "", s);
            if (!t->number[c] && c + 1 < columns) fprintf(out, "%*s", pad, "");
        }
}

static inline void table_csv(const table *t, FILE *out)
{
    size_t columns = (size_t)t->columns;
    for (size_t i = 0; i < columns + t->n; i++) {
        const char *s = i < columns ? t->name[i] : t->cell[i - columns];
        fprintf(out, strpbrk(s, ",\"") ? "\"%s\"%c" : "%s%c", s, (i + 1) % columns ? ',' : '\n');
    }
}

#endif
