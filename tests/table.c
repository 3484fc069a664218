/* Tests of common/table.h. */
#include "check.h"
#include "child.h"
#include "../common/lab/table.h"

static char said[8192];

/* What a table prints, or its CSV. */
static const char *printed(table *t, void (*print)(table *, FILE *))
{
    FILE *out = tmpfile();
    print(t, out);
    child_slurp(out, said, sizeof said);
    return said;
}

static void test_columns(void)
{
    table t = table_new("title", "method|distance [R]|error");
    table_text(&t, "naive"), table_count(&t, 100), table_number(&t, 0.5);
    table_text(&t, "%s, %d", "robust", 2), table_count(&t, 1000000), table_number(&t, 1.25e-9);
    check_text(printed(&t, table_print),
               "method     distance [R]     error\n"
               "naive               100       0.5\n"
               "robust, 2       1000000  1.25e-09\n", "texts to the left, numbers to the right");
    check_text(printed(&t, table_csv),
               "method,distance [R],error\nnaive,100,0.5\n\"robust, 2\",1000000,1.25e-09\n", "CSV");
    table_free(&t);
    table_free(&t);
    check(t.n == 0 && t.cell == NULL, "freed, twice");
}

static void test_numbers(void)
{
    const struct { double x; const char *text; } cases[] = {
        {0.00123, "0.00123"}, {12.34, "12.3"}, {1234, "1234"}, {1.234e-5, "1.23e-05"}, {0, "0"},
        {-12.34, "-12.3"}, {99.96, "100"}, {123456.7, "123457"}, {1e6, "1e+06"}, {1e300, "1e+300"},
        {(double)NAN, "nan"}, {-(double)NAN, "nan"}, {HUGE_VAL, "inf"}, {-HUGE_VAL, "-inf"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        table t = table_new("", "x");
        table_number(&t, cases[i].x);
        check_text(t.cell[1], cases[i].text, "%g in a cell", cases[i].x);
        table_free(&t);
    }
}

static void test_odd(void)
{
    table t = table_new("", "caf\xc3\xa9 \xe5\x85\x89|n");
    table_text(&t, "%s", "na\xc3\xafve"), table_count(&t, 1), table_text(&t, "%s", "a\"b\nc,");
    check_text(printed(&t, table_csv),
               "caf\xc3\xa9 \xe5\x85\x89,n\nna\xc3\xafve,1\n\"a\"\"b\nc,\",\n",
               "quotes doubled, the row that is not complete filled up");
    table_free(&t);
    t = table_new("", "caf\xc3\xa9|n");
    table_text(&t, "abcd"), table_count(&t, 1), table_text(&t, "%s", "\xc3\xa9");
    check_text(printed(&t, table_print), "caf\xc3\xa9  n\nabcd  1\n\xc3\xa9      \n",
               "aligned by characters, not by bytes");
    table_free(&t);
    t = table_new("", "");
    check_text(printed(&t, table_print), "\n", "one column without a name, no rows");
    table_free(&t);
    t = table_new("", "a||b");
    check_text(printed(&t, table_csv), "a,,b\n", "a column in the middle without a name");
    table_free(&t);
}

static void too_many(void *context) { table_new("", context); }

static void test_limits(void)
{
    char longest[200];
    memset(longest, 'x', sizeof longest), longest[199] = 0;
    table t = table_new("", "1|2|3|4|5|6|7|8|9|10|11|12|13|14|15|16");
    for (size_t i = 0; i < 16000; i++) table_count(&t, i);
    table_text(&t, "%s", longest);
    check_equal(t.n, 16017, "cells of 16 columns and 1000 rows, names, one more");
    check_equal(strtol(t.cell[16 + 15999], NULL, 10), 15999, "the last number");
    check_equal(strlen(t.cell[16016]), table_cell_size - 1, "a cell is cut at its size");
    table_free(&t);
    check(child_run(too_many, "1|2|3|4|5|6|7|8|9|0|1|2|3|4|5|6|7").status != 0,
          "17 columns are a mistake of the program");
}

int main(void)
{
    test_columns();
    test_numbers();
    test_odd();
    test_limits();
    return check_report("table");
}
