/* Tests of common/plot.h: places, ticks, and a file that is valid whatever goes into it. */
#include "check.h"
#include "child.h"
#include "../common/lab/plot.h"

static char svg[200000];

static const char *drawn(plot *p)
{
    FILE *out = tmpfile();
    plot_write(p, out);
    child_slurp(out, svg, sizeof svg);
    plot_free(p);
    return svg;
}

static int occurrences(const char *text, const char *what)
{
    int n = 0;
    for (; (text = strstr(text, what)) != NULL; text++) n++;
    return n;
}

/* True if every tag is closed, quotes pair up, and only the five known entities or &#N; occur. */
static bool well_formed(const char *s)
{
    char stack[16][16];
    int depth = 0;
    for (; *s; s++) {
        bool printable = !iscntrl((unsigned char)*s) || *s == '\n';
        if (!printable || *s == '>') return false;
        if (*s == '&' && (s[1] != '#' || s[2 + strspn(s + 2, "0123456789")] != ';')) return false;
        if (*s != '<') continue;
        const char *end = strchr(s, '>');
        if (!end) return false;
        int quotes = 0;
        for (const char *c = s; c < end; c++) quotes += *c == '"';
        if (quotes % 2) return false;
        size_t n = strcspn(s + 1, " />");
        if (s[1] == '/') {
            n = strcspn(s + 2, ">");
            if (depth == 0 || strlen(stack[depth - 1]) != n
                || strncmp(stack[--depth], s + 2, n) != 0)
                return false;
        } else if (end[-1] != '/') {
            if (depth == 16 || n > 15) return false;
            snprintf(stack[depth++], 16, "%.*s", (int)n, s + 1);
        }
        s = end;
    }
    return depth == 0;
}

static void check_sound(const char *s, const char *what)
{
    check(well_formed(s), "well-formed XML: %s", what);
    check(!strstr(s, "nan") && !strstr(s, "inf"), "coordinates are numbers: %s", what);
}

static void test_places(void)
{
    plot p = plot_new("title", "x", "y", PLOT_LOG_X | PLOT_LOG_Y);
    int s = plot_series(&p, "one");
    plot_add(&p, s, 1, 100), plot_add(&p, s, 10, 1), plot_add(&p, s, 100, 10);
    plot_axis ax = plot_range(&p, false, 80, 560), ay = plot_range(&p, true, 370, 50);
    check(ax.lowest == 0 && ax.highest == 2 && ay.lowest == 0 && ay.highest == 2, "whole decades");
    check_close(plot_place(ax, plot_value(ax, 10)), 320, 1e-9, "10 in the middle of 1 to 100");
    check_close(plot_place(ay, plot_value(ay, 100)), 50, 1e-9, "the largest y on top");
    plot_slope(&p, -1, "slope -1");
    const char *text = drawn(&p);
    check_sound(text, "three points");
    check(strstr(text, "M80.0,50.0L320.0,370.0") && strstr(text, "M320.0,370.0L560.0,210.0"),
          "lines join the points in their order");
    check(strstr(text, "M80.0,50.0L560.0,370.0"), "slope -1 through the first point");
    check(strstr(text, ">title<") && strstr(text, ">one<") && strstr(text, ">slope -1<")
          && strstr(text, ">x<") && strstr(text, ">y<"), "title, labels and legend");
    check(strstr(text, ">1<") && strstr(text, ">10<") && strstr(text, ">100<"), "decades as ticks");
}

static void test_ticks(void)
{
    plot p = plot_new("", "", "", 0);
    int s = plot_series(&p, "");
    for (int i = -1; i <= 8; i++) plot_add(&p, s, 0.1 * i, -3e9 * i);
    const char *text = drawn(&p);
    check(strstr(text, ">0<") && !strstr(text, ">-0<"), "zero has no sign");
    check(strstr(text, ">0.6<") && strstr(text, ">-0.2<"), "decimals without noise");
    check_sound(text, "negative values");
    p = plot_new("", "", "", 0);
    plot_add(&p, plot_series(&p, ""), 0, 0), plot_add(&p, 0, 1, 1);
    check(!strstr(drawn(&p), ">-0<"), "zero at the beginning has no sign");
    for (int decades = 1; decades < 400; decades += 7) {
        p = plot_new("", "", "", PLOT_LOG_X);
        plot_add(&p, plot_series(&p, ""), 1e-300, 0);
        plot_add(&p, 0, 1e-300 * pow(10, decades), 1);
        plot_axis ax = plot_range(&p, false, 0, 1);
        double n = (ax.highest - ax.lowest) / plot_step(ax);
        check(n >= 1 && n <= 10, "%d decades have %g steps", decades, n);
        plot_free(&p);
    }
    for (double high = 1e-5; high < 1e5; high *= 1.07) {
        p = plot_new("", "", "", 0);
        plot_add(&p, plot_series(&p, ""), 0, high);
        plot_axis ay = plot_range(&p, true, 0, 1);
        double n = (ay.highest - ay.lowest) / plot_step(ay);
        check(n >= 3.9 && n <= 11, "0 to %g has %g steps", high, n);
        check_at_least(ay.highest, high * (1 - 1e-9), "the axis reaches the highest value");
        plot_free(&p);
    }
}

static void test_degenerate(void)
{
    const double odd[] = {0, -0.0, 1, -1, 1e300, -1e300, 5e-324, 1e-100,
                          1e-300, 1e100, HUGE_VAL, -HUGE_VAL,
                          (double)NAN, 1e308};
    enum { n = sizeof odd / sizeof *odd };
    for (int flags = 0; flags < 4; flags++) {
        plot p = plot_new("", "", "", flags);
        check_sound(drawn(&p), "nothing at all");
        p = plot_new("", "", "", flags);
        plot_series(&p, "empty"), plot_slope(&p, 1, "slope");
        check_sound(drawn(&p), "a series without points");
        for (int i = 0; i < n * n; i++) {
            p = plot_new("", "", "", flags);
            plot_series(&p, "two"), plot_slope(&p, -0.5, "slope");
            plot_add(&p, 0, odd[i / n], odd[i % n]), plot_add(&p, 0, odd[i % n], odd[i / n]);
            check_sound(drawn(&p), "two odd points");
            p = plot_new("", "", "", flags);
            plot_series(&p, "one"), plot_slope(&p, 2, "slope");
            plot_add(&p, 0, odd[i / n], odd[i % n]);
            check_sound(drawn(&p), "one odd point");
        }
    }
    plot p = plot_new("", "", "", PLOT_LOG_Y);
    plot_series(&p, "");
    plot_add(&p, 0, 0, 10), plot_add(&p, 0, 1, 0), plot_add(&p, 0, 2, 1);
    const char *text = drawn(&p);
    check(occurrences(text, "translate(320.0,370.0)\" fill=\"white\"") == 1,
          "a y of 0 on a log axis: hollow, on the bottom edge");
    check(strstr(text, ">hollow: 0<") != NULL, "and the legend says what that is");
    check(!strstr(text, "M80.0,50.0L560.0,370.0"), "no line leads past it");
    p = plot_new("", "", "", 0);
    plot_series(&p, ""), plot_add(&p, 0, 0, 0), plot_add(&p, 0, 1, 1);
    check(!strstr(drawn(&p), "hollow"), "on a linear axis a 0 is a mark like any other");
}

static void test_labels(void)
{
    char any[128];
    for (int i = 0; i < 127; i++) any[i] = (char)(i + 1);
    any[127] = 0;
    plot p = plot_new(any, "a < b & c > \"d\"", "]]> <!-- M\u00f6ller", 0);
    for (int s = 0; s < plot_most_series; s++) plot_series(&p, any);
    plot_add(&p, 7, 1, 1);
    plot_slope(&p, 1, any), plot_slope(&p, 2, any);
    const char *text = drawn(&p);
    check_sound(text, "any ASCII character in any label");
    check(strstr(text, ">]]&#62; &#60;!-- M\u00f6ller<") != NULL, "UTF-8 stays");
    check(strstr(text, "a &#60; b &#38; c &#62; \"d\""), "markup in labels is text");
    for (int s = 0; s < plot_most_series; s++)
        check(strstr(text, plot_colour[s % plot_colours]) != NULL, "series %d has its colour", s);
}

/* What the legend shows of series s: its line, and its mark without the place. */
static void legend_of(const char *text, int s, char *out, size_t room)
{
    char line[40];
    snprintf(line, sizeof line, "M572.0,%.1fL598.0,", 62. + 20 * s);
    const char *at = strstr(text, line), *mark = at ? strstr(at + 1, "<path d=") : NULL;
    const char *place = mark ? strstr(mark, "transform") : NULL;
    const char *fill = mark ? strstr(mark, "fill") : NULL;
    const char *style = at ? strstr(at, "stroke-width") : NULL;
    out[0] = 0;
    if (!place || !fill || !style) return;
    snprintf(out, room, "%.*s%.*s%.*s", (int)strcspn(style, "/"), style, (int)(place - mark), mark,
             (int)strcspn(fill, "/"), fill);
}

/* No two series look alike, however many: a line and a mark of their own. */
static void test_told_apart(void)
{
    plot p = plot_new("", "", "", 0);
    static char seen[plot_most_series][300];
    for (int s = 0; s < plot_most_series; s++) plot_series(&p, "x");
    const char *text = drawn(&p);
    for (int s = 0; s < plot_most_series; s++) {
        legend_of(text, s, seen[s], sizeof seen[s]);
        check(strstr(seen[s], "width") && strstr(seen[s], "fill"), "series %d: in the legend", s);
        for (int k = 0; k < s; k++)
            check(strcmp(seen[k], seen[s]) != 0, "series %d and %d look different", k, s);
        check((strstr(seen[s], "dash") != NULL) == (s >= plot_colours), "series %d: dashes", s);
    }
}

static void too_many(void *context)
{
    plot p = plot_new("", "", "", 0);
    for (int s = 0; s <= plot_most_series; s++) plot_series(&p, context);
}

/* Eight colours, the eight of Okabe and Ito. */
static void test_colours(void)
{
    static const char *const theirs[] = {"#000000", "#e69f00", "#56b4e9", "#009e73",
                                         "#f0e442", "#0072b2", "#d55e00", "#cc79a7"};
    for (int k = 0; k < plot_colours; k++) {
        int found = 0;
        for (int i = 0; i < plot_colours; i++) found += !strcmp(plot_colour[i], theirs[k]);
        check_equal(found, 1, "the colour %s", theirs[k]);
    }
    check(strcmp(plot_colour[plot_yellow], "#f0e442") == 0, "yellow, pale on white, is told apart");
}

int main(void)
{
    test_places();
    test_ticks();
    test_degenerate();
    test_labels();
    test_told_apart();
    check(child_run(too_many, "").status != 0, "more series are a mistake of the program");
    test_colours();
    return check_report("plot");
}
