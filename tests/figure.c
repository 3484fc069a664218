/* Tests of common/lab/figure.h: places, marks in texts, and where a drawing goes. */
#include "check.h"
#include "child.h"
#include "../common/lab/figure.h"

static char svg[20000];

static const char *drawn(figure *g)
{
    child_slurp(g->out, svg, sizeof svg);
    return svg;
}

static figure sheet(void)
{
    figure g = {.out = tmpfile()};
    if (!g.out) abort();
    figure_origin(&g, 60, 200, 100);
    return g;
}

static void has(const char *text, const char *what)
{
    check(strstr(text, what) != NULL, "%s in: %s", what, text);
}

/* (0, 0) is the pixel (60, 200), a unit is 100, y points up. */
static void test_places(void)
{
    const double xy[] = {0, 0, 1, 0, 1, 1};
    figure g = sheet();
    figure_line(&g, 0, 0, 1, 0.5, FIGURE_BLUE, 1.5, FIGURE_DASHED);
    figure_dot(&g, -0.5, 1, 4, FIGURE_RED);
    figure_polygon(&g, 3, xy, FIGURE_SKY, 0.25, NULL);
    figure_arc(&g, 0, 0, 30, 0, 90, FIGURE_BLACK, 1);
    const char *s = drawn(&g);
    has(s, "M60.0,200.0L160.0,150.0\" stroke=\"#0072b2\" stroke-width=\"1.5\" stroke-dasharray");
    has(s, "cx=\"10.0\" cy=\"100.0\" r=\"4\" fill=\"#d55e00\"");
    has(s, "M60.0,200.0L160.0,200.0L160.0,100.0Z\" fill=\"#56b4e9\" fill-opacity=\"0.25\"");
    has(s, "stroke=\"none\"");
    has(s, "M90.0,200.0A30,30 0 0 0 60.0,170.0");
    g = sheet();
    figure_arrow(&g, 0, 0, 1, 0, FIGURE_BLACK, 2);  /* a head of 10 x 8 pixels, shaft inside */
    has(drawn(&g), "M60.0,200.0L152.0,200.0\"");
    has(svg, "M160.0,200.0L150.0,204.0L150.0,196.0Z");
    g = sheet();
    figure_arrow(&g, 1, 1, 1, 1, FIGURE_BLACK, 2);
    check(drawn(&g)[0] == 0, "an arrow of no length is not drawn");
}

static const char *text_of(const char *marked)
{
    figure g = sheet();
    figure_text(&g, 0, 0, 8, -6, FIGURE_LEFT, FIGURE_BLACK, marked);
    char *s = strstr(drawn(&g), "preserve\">");
    check(s != NULL, "a text");
    return s ? s + strlen("preserve\">") : "";
}

static void same_text(const char *marked, const char *expected)
{
    const char *s = text_of(marked);
    check(strncmp(s, expected, strlen(expected)) == 0
          && strcmp(s + strlen(expected), "</text>\n") == 0, "%s: %s, not %s", marked, s, expected);
}

static void test_texts(void)
{
    same_text("plain", "plain");
    has(svg, "x=\"68.0\" y=\"194.0\" text-anchor=\"start\"");
    same_text("a < b & c > d", "a &#60; b &#38; c &#62; d");
    same_text("*o* + _t_", "<tspan font-weight=\"bold\">o</tspan> + "
              "<tspan font-style=\"italic\">t</tspan>");
    /* what follows an index stands on the line again */
    same_text("_t_~min~, x", "<tspan font-style=\"italic\">t</tspan><tspan font-size=\"12\" "
              "dy=\"4\">min</tspan><tspan dy=\"-4\">, x</tspan>");
    same_text("x~0~ *d*", "x<tspan font-size=\"12\" dy=\"4\">0</tspan><tspan dy=\"-4\"> </tspan>"
              "<tspan font-weight=\"bold\">d</tspan>");
    same_text("x~0~*d*", "x<tspan font-size=\"12\" dy=\"4\">0</tspan>"
              "<tspan font-weight=\"bold\" dy=\"-4\">d</tspan>");
    same_text("*open", "<tspan font-weight=\"bold\">open</tspan>");
}

/* images/ by default, build/quick/ with --quick, nowhere with --out. */
static void test_where(void)
{
    char dir[] = "/tmp/figure_test_XXXXXX";
    if (!mkdtemp(dir) || chdir(dir) != 0) abort();
    const options asked[] = {{0}, {.quick = true}, {.out = "x.png"}};
    for (int k = 0; k < 3; k++) {
        if (k == 1) mkdir("build", 0777);
        figure g = figure_begin(&asked[k], "f.svg", 300, 200);
        figure_line(&g, 0, 0, 1, 1, FIGURE_BLACK, 1, FIGURE_WHOLE);
        figure_end(&g);
        check((g.path[0] != 0) == (k < 2), "with --out no figure is drawn");
    }
    for (int k = 0; k < 2; k++) {
        FILE *in = fopen(k ? "build/quick/f.svg" : "images/f.svg", "r");
        check(in != NULL, "drawn: %d", k);
        if (!in) continue;
        child_slurp(in, svg, sizeof svg);
        has(svg, "viewBox=\"0 0 300 200\"");
        size_t n = strlen(svg);
        check(n > 7 && strcmp(svg + n - 7, "</svg>\n") == 0, "it is whole");
    }
    check(strcmp(output_drawn, " images/f.svg build/quick/f.svg") == 0, "noted: %s", output_drawn);
    remove("images/f.svg"), remove("build/quick/f.svg");
    rmdir("images"), rmdir("build/quick"), rmdir("build");
    if (chdir("/") == 0) rmdir(dir);
}

int main(void)
{
    test_places();
    test_texts();
    test_where();
    return check_report("figure");
}
