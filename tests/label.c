/* Letters in pictures: each has its strokes and keeps to its place, panels keep their pixels. */
#include "../common/lab/panels.h"
#include "check.h"

static const vec3 white = {1, 1, 1}, black = {0, 0, 0};

static image sheet_of(int width, int height)
{
    image im = image_new(width, height);
    label_fill(&im, 0, 0, width, height, white);
    return im;
}

/* Ink (1 - colour) in a rectangle, and outside. */
static double ink(const image *im, int x0, int y0, int x1, int y1, bool inside)
{
    double sum = 0;
    for (int y = 0; y < im->height; y++)
        for (int x = 0; x < im->width; x++)
            if ((x >= x0 && x < x1 && y >= y0 && y < y1) == inside)
                sum += 1 - (double)image_get(im, x, y).x;
    return sum;
}

/* Strokes are pairs of a letter in a..i and a digit; no two characters look alike. */
static void test_glyphs(void)
{
    for (int c = 33; c < 127; c++) {
        const char *s = label_strokes((char)c);
        bool good = *s != 0;
        for (; *s; s += *s == ' ' ? 1 : 2)
            good = good && (*s == ' ' || (*s >= 'a' && *s <= 'i' && s[1] >= '0' && s[1] <= '9'));
        check(good, "strokes of %c", c);
        for (int d = 33; d < c; d++)
            check(strcmp(label_strokes((char)c), label_strokes((char)d)) != 0, "%c and %c", c, d);
    }
    check(*label_strokes(' ') == 0 && *label_strokes('\n') == 0 && *label_strokes((char)200) == 0,
          "what is no letter has no strokes");
}

/* 24 high, on the line y = 60: capitals reach up to 36, "g" down to 68, nothing farther. */
static void test_place(void)
{
    const double size = 24;
    for (int c = 33; c < 127; c++) {
        image im = sheet_of(120, 100);
        const char text[] = {(char)c, 0};
        double width = label_width(text, size);
        label_text(&im, 40, 60, size, 0, black, text);
        int x1 = 40 + (int)ceil(width) + 3;
        check_at_least(ink(&im, 37, 29, x1, 71, true), 5, "%c is drawn", c);
        check_equal(ink(&im, 37, 29, x1, 71, false), 0, "%c keeps to its place", c);
        if (c >= 'A' && c <= 'Z' && c != 'Q')
            check_equal(ink(&im, 0, 34, 120, 62, false), 0, "%c stands on the line", c);
        image_free(&im);
    }
    check_close(label_width("HH", 12), 2 * label_width("H", 12) + 3.5, 1e-9, "space between");
    check_equal(label_width("", 12), 0, "no letters, no width");
}

static void test_align(void)
{
    image left = sheet_of(200, 30), right = sheet_of(200, 30);
    label_text(&left, 20, 20, 12, 0, black, "t_enter");
    label_text(&right, 20 + label_width("t_enter", 12), 20, 12, 1, black, "t_enter");
    check_at_most(image_compare(&left, &right).maximum, 1e-5, "left end and right end");
    label_text(&left, -7, 4, 12, 0, black, "off the edge"), label_tag(&left, 190, 25, 12, "tag");
    label_text(&left, 1e4, -1e4, 12, 0.5, black, "far off");
    check(vdot(image_get(&left, 199, 29), white) > 0, "what sticks out is left out");
    image_free(&left), image_free(&right);
}

static void test_panels(void)
{
    const char *const title[4] = {"one", "two", "three", "four"};
    image im = image_new(2 * 60 + 4, 2 * 40 + 4);
    for (int y = 0; y < im.height; y++)
        for (int x = 0; x < im.width; x++) image_set(&im, x, y, vec(x / 200.0, y / 200.0, 0.5));
    image sheet = image_new(im.width, im.height);
    image_place(&sheet, 0, 0, &im);
    label_titles(&sheet, 2, 2, 4, title);
    double wrong = 0;
    for (int y = 0; y < 84; y++)
        for (int x = 0; x < 124; x++) {
            bool gap = (x >= 60 && x < 64) || (y >= 40 && y < 44);
            vec3 due = gap ? white : image_get(&im, x, y);
            wrong += !vzero(vsub(image_get(&sheet, x, y + (y < 44 ? 26 : 52)), due));
        }
    check_equal(wrong, 0, "panels keep their pixels, gaps are white");
    image one = image_new(60, 40), again = {0};
    for (int k = 0; k < 4; k++) {  /* the same panels, one by one */
        for (int i = 0; i < 60 * 40; i++) {
            int x = i % 60, y = i / 60;
            image_set(&one, x, y, image_get(&im, k % 2 * 64 + x, k / 2 * 44 + y));
        }
        label_panel(&again, 2, 2, 4, k, &one);
    }
    label_titles(&again, 2, 2, 4, title);
    check(again.width == sheet.width && again.height == sheet.height, "as large");
    check_equal(memcmp(again.rgb, sheet.rgb, sizeof(float) * 3 * 124 * (84 + 52)), 0,
                "panels put one by one");
    image_free(&one), image_free(&again);
    for (int k = 0; k < 4; k++) {
        int x = k % 2 * 64, y = k / 2 * 70;
        check_at_least(ink(&sheet, x, y, x + 60, y + 26, true), 20, "title %d", k);
    }
    image_free(&im), image_free(&sheet);
}

static vec3 panel_colour(const void *context, real x, real y)
{
    (void)x, (void)y;
    return *(const vec3 *)context;
}

/* Sizes that divide, that do not, one pixel: each panel in its place, the last cut, gaps white. */
static void test_panels_new(void)
{
    static const vec3 paint[4] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}};
    static const int size[][3] = {{124, 84, 4}, {123, 85, 4}, {7, 5, 2}, {1, 1, 0}, {444, 240, 4}};
    const panel p[4] = {{"one", &paint[0]}, {"two", &paint[1]}, {"three", &paint[2]},
                        {"four", &paint[3]}};
    options o = {.threads = 1};
    for (size_t i = 0; i < sizeof size / sizeof *size; i++) {
        panels_shape g = {size[i][0], size[i][1], 2, 2, size[i][2], 1, true};
        int w = panels_wide(g), h = panels_high(g), wrong = 0, tagged = 0;
        bool whole = false;
        image sheet = panels_new(&o, g, panel_colour, p, &whole);
        check(whole && sheet.width == g.width && sheet.height == g.height, "as large as asked");
        for (int y = 0; y < g.height; y++)
            for (int x = 0; x < g.width; x++) {
                bool tag = w >= 200 && x % (w + g.gap) < 100 && y % (h + g.gap) < 40;
                bool gap = x % (w + g.gap) >= w || y % (h + g.gap) >= h;
                vec3 due = gap ? white : paint[2 * (y / (h + g.gap)) + x / (w + g.gap)];
                bool same = vzero(vsub(image_get(&sheet, x, y), due));
                wrong += !same && !tag, tagged += !same && tag;
            }
        check_equal(wrong, 0, "%d x %d: panels and gaps", g.width, g.height);
        check((tagged > 100) == (w >= 200), "names where there is room");
        image_free(&sheet);
        if (w < 60) continue;
        g.tags = false;
        sheet = panels_new(&o, g, panel_colour, p, &whole);
        check_equal(sheet.height, g.height + 52, "names above: two strips more");
        image_free(&sheet);
    }
}

static vec3 grey(real t) { return vec(t, t, t); }

static void test_bar(void)
{
    image im = sheet_of(120, 60);
    label_bar(&im, 10, 5, 100, 10, grey, 0, 64, "tests");
    for (int i = 0; i < 100; i++)
        check_close(image_get(&im, 10 + i, 15).x, (i + 0.5) / 100, 1e-6, "colour %d", i);
    check_at_least(ink(&im, 10, 28, 120, 50, true), 20, "numbers below");
    check_equal(ink(&im, 8, 5, 114, 50, false), 0, "4.5 times its size high");
    image_free(&im);
}

int main(void)
{
    test_glyphs();
    test_place();
    test_align();
    test_panels();
    test_panels_new();
    test_bar();
    return check_report("label");
}
