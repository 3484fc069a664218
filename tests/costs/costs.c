/* costs.c: what accuracy costs, a chapter a point: `make costs` runs the programs with --csv, then
 *
 *   costs DIRECTORY        reads DIRECTORY/NN_name.csv, draws images/costs.svg, prints the table
 *
 * Each chapter's table has an error and a time for the naive way and for the default. Their units
 * differ, so the plot shows quotients, default by naive: across, of the times; up, of the errors.
 * Chapters whose default errs in no trial stand below, each in a line of its own, in order of time.
 * 17 and 27 are missing: what 17 compares all gives the hits of brute force, and the errors of
 * 27's are those of leaving an effect out, against its own plan. */
#include "../../common/lab/figure.h"
#include "../../common/lab/table.h"

enum { most_cells = 16, most_lines = 200 };
typedef struct { char *cell[most_lines][most_cells]; int lines, columns; } sheet;

/* Rows are named by how they begin, cells joined by |; the time stands in the next column whose
 * name begins with "time". */
typedef struct { const char *chapter, *what, *error, *naive, *now; } subject;

static const subject subjects[] = {
    {"01_ray", "points along a ray", "error t=1e4", "first (1-t) a", "first o + t d"},
    {"02_camera", "edges, 16 rays a pixel", "error 16 rays", "checkerboard|tent random",
     "checkerboard|tent jittered"},
    {"03_sphere", "rays at the limb, from 1e6 R", "error grazing wrong 1e6 R [%]", "first|",
     "sphere_hit"},
    {"04_triangle", "rays at edges that slip", "error at edges [%]", "first", "watertight"},
    {"05_implicit", "grazing rays that miss", "error missed [%]", "first, 128", "intervals"},
    {"06_csg", "the eye within a solid", "error eye inside [%]", "t > 0", "spans, bounds"},
    {"07_mesh", "inside or not, past an edge", "error: an edge", "first|", "parity of crossings"},
    {"08_object_order", "wrong pixels", "error: another triangle [pixels]", "first|",
     "raster, 8 bits"},
    {"09_aabb", "boxes of no thickness lost", "error flat [%]", "first, divides",
     "aabb_hit, divides"},
    {"10_grid", "hits beyond the cell", "error boards [%]", "first hit accepted",
     "grid_hit, 27 cells"},
    {"11_octree", "rays at corners and in planes", "error [wrong]", "textbook|", "octree|"},
    {"12_kdtree", "rays at corners", "error [wrong]", "textbook search", "SAH, by cost"},
    {"13_bsp", "rays at corners", "error [wrong]", "first leaf", "cost, 16"},
    {"14_bvh", "rays at corners", "error [wrong]", "sah, boxes naive", "sah|"},
    {"15_wide_bvh", "rays into a mesh", "error [lost]", "leaky|4|", "watertight|4|"},
    {"16_instances", "plants lost far away", "error far", "boxes naive", "boxes of points"},
    {"18_shade", "shadows that leak", "error: leak T=0 [%]", "first|", "leave|"},
    {"19_whitted", "depth 5, or a cut", "error: rmse", "depth|5|", "cut|64|0.01|"},
    {"20_monte_carlo", "a smooth integral", "error smooth", "random", "Sobol', Owen"},
    {"21_distributed", "all effects", "error N=64", "all others|random", "all others|Sobol', Owen"},
    {"22_radiometry", "light of a sphere", "error random", "sphere|first",
     "sphere|solid angle"},
    {"23_brdf", "a glossy surface", "error [1]", "GGX .25|uniform",
     "GGX .25|BRDF|"},
    {"24_direct_light", "the plates", "error at the plates [1]",
     "uniform directions", "power heuristic"},
    {"25_bounces", "two rays a hit, or one", "error of a sample, -+ [1]", "5|2|", "5|1|"},
    {"26_path_tracer", "the Cornell box", "error RMSE", "naive (25)", "the same, Sobol'"},
};
enum { chapters = sizeof subjects / sizeof *subjects };

typedef struct { const subject *of; double naive_error, naive_time, now_error, now_time; } cost;

/* ---- reading: the CSV that table.h writes ---- */

/* Cuts `text`, which stays, into cells; quotes go, doubled ones become one. */
static sheet sheet_read(char *text, const char *path)
{
    sheet s = {.lines = 0};
    for (char *in = text; *in; s.lines++) {
        int column = 0;
        for (bool more = true; more; column++) {
            if (s.lines == most_lines || column == most_cells) die(2, "%s: too large", path);
            char *out = s.cell[s.lines][column] = in;
            bool quoted = *in == '"';
            for (in += quoted; *in && (quoted || (*in != ',' && *in != '\n')); in++) {
                if (quoted && *in == '"' && *++in != '"') { quoted = false; in--; continue; }
                *out++ = *in;
            }
            more = *in == ',';
            in += *in != '\0';
            *out = '\0';
        }
        if (s.lines == 0) s.columns = column;
        if (column != s.columns)
            die(2, "%s:%d: %d cells, not %d", path, s.lines + 1, column, s.columns);
    }
    return s;
}

static bool begins(const char *s, const char *with) { return strncmp(s, with, strlen(with)) == 0; }

/* The first line that begins so, its cells joined by |. */
static int sheet_line(const sheet *s, const char *key, const char *path)
{
    for (int i = 1; i < s->lines; i++) {
        char joined[1024] = "";
        for (int k = 0; k < s->columns; k++) {
            size_t n = strlen(joined);
            snprintf(joined + n, sizeof joined - n, "%s|", s->cell[i][k]);
        }
        if (begins(joined, key)) return i;
    }
    die(2, "%s: no row \"%s\"", path, key);
}

static double sheet_number(const sheet *s, int line, int column, const char *path)
{
    char *end;
    double x = strtod(s->cell[line][column], &end);
    if (end == s->cell[line][column] || !isfinite(x) || x < 0)
        die(2, "%s: \"%s\" is no error and no time", path, s->cell[line][column]);
    return x;
}

static cost cost_read(const subject *of, const char *directory)
{
    char path[200];
    failure f;
    cost c = {.of = of};
    int error = 0, time;
    snprintf(path, sizeof path, "%s/%s.csv", directory, of->chapter);
    char *text = file_read(path, &(size_t){0}, &f);
    if (!text) fail(f);
    sheet s = sheet_read(text, path);
    while (error < s.columns && strcmp(s.cell[0][error], of->error) != 0) error++;
    for (time = error; time < s.columns && !begins(s.cell[0][time], "time"); time++) {}
    if (time >= s.columns) die(2, "%s: no column \"%s\" with a time behind it", path, of->error);
    int naive = sheet_line(&s, of->naive, path), now = sheet_line(&s, of->now, path);
    c.naive_error = sheet_number(&s, naive, error, path);
    c.naive_time = sheet_number(&s, naive, time, path);
    c.now_error = sheet_number(&s, now, error, path);
    c.now_time = sheet_number(&s, now, time, path);
    if (!(c.naive_error > 0 && c.naive_time > 0 && c.now_time > 0))
        die(2, "%s: \"%s\" does not err, or takes no time", path, of->naive);
    free(text);
    return c;
}

/* ---- the plot ---- */

enum { plot_left = 80, plot_right = 900, plot_top = 80, plot_bottom = 410, row = 21 };

/* Across: a tenth to ten times the time. Up: 1e-4 to 2 times the error. */
static double place_x(const cost *c)
{
    double decades = log10(c->now_time / c->naive_time);
    return plot_left + (plot_right - plot_left) * (fmin(1, fmax(-1, decades)) + 1) / 2;
}

static double place_y(double share)
{
    double decades = log10(fmin(2, fmax(1e-4, share)));
    return plot_top + (plot_bottom - plot_top) * (0.4 - decades) / 4.4;
}

static const char *part_colour(const cost *c)
{
    int n = atoi(c->of->chapter);
    return n < 9 ? FIGURE_BLUE : n < 18 ? FIGURE_GREEN : FIGURE_RED;
}

static int by_height(const void *a, const void *b)
{
    const cost *x = *(cost *const *)a, *y = *(cost *const *)b;
    double p = x->now_error / x->naive_error, q = y->now_error / y->naive_error;
    return (p < q) - (p > q);
}

static int by_time(const void *a, const void *b)
{
    const cost *x = *(cost *const *)a, *y = *(cost *const *)b;
    double p = x->now_time / x->naive_time, q = y->now_time / y->naive_time;
    return (p > q) - (p < q);
}

typedef struct { double from, to, y; } place;  /* of a label, or a dot */

/* Beside its dot, away from the middle if there is room; below its line and what is in its way. */
static place label(figure *g, const cost *c, double x, double y, const place *used, int n)
{
    char text[128];
    double middle = (plot_left + plot_right) / 2.0;
    snprintf(text, sizeof text, "*%.2s* %s: %s", c->of->chapter, c->of->chapter + 3, c->of->what);
    for (char *t = text; *t && *t != ':'; t++) if (*t == '_') *t = ' ';  /* _ would slant */
    double width = 7.4 * (double)strlen(text);
    bool left = x < middle ? x - width > plot_left : x + width > plot_right + 20;
    place p = {left ? x - width : x + 9, left ? x - 9 : x + width, y};
    if (n > 0 && left == (x > middle)) p.y += 16;
    for (int i = 0; i < n; i++)
        if (used[i].from < p.to && p.from < used[i].to && fabs(p.y - used[i].y) < 16)
            p.y = used[i].y + 16;
    figure_text(g, x, -p.y, left ? -10 : 10, 5, left ? FIGURE_RIGHT : FIGURE_LEFT, part_colour(c),
                text);
    return p;
}

static void frame(figure *g, double top, double bottom)
{
    static const char *const ticks[] = {"1/10", "1/5", "1/2", "1", "2", "5", "10 x"};
    static const double at[] = {0.1, 0.2, 0.5, 1, 2, 5, 10};
    double middle = (plot_left + plot_right) / 2.0;
    double quicker[] = {plot_left, -top, middle, -top, middle, -bottom, plot_left, -bottom};
    double slower[] = {middle, -top, plot_right, -top, plot_right, -bottom, middle, -bottom};
    figure_polygon(g, 4, quicker, FIGURE_GREEN, 0.07, FIGURE_GREY);
    figure_polygon(g, 4, slower, FIGURE_ORANGE, 0.09, FIGURE_GREY);
    for (int i = 0; i < 7; i++) {
        double x = place_x(&(cost){.naive_time = 1, .now_time = at[i]});
        figure_line(g, x, -top, x, -bottom, i == 3 ? FIGURE_GREY : "#dddddd", 1, FIGURE_WHOLE);
        figure_text(g, x, -bottom, 0, 18, FIGURE_MIDDLE, FIGURE_BLACK, ticks[i]);
    }
}

/* Above: what still errs, labels at least a line apart. */
static void draw_upper(figure *g, cost **c, int n)
{
    static const char *const ticks[] = {"1 x", "1/10", "1/100", "1/1000", "1/10000"};
    double x1 = (plot_left + plot_right) / 2.0;
    place used[2 * chapters];
    frame(g, plot_top, plot_bottom);
    for (int i = 0; i < 5; i++) {
        double y = place_y(pow(10, -i));
        figure_line(g, plot_left, -y, plot_right, -y, "#dddddd", 1, FIGURE_WHOLE);
        figure_text(g, plot_left, -y, -8, 5, FIGURE_RIGHT, FIGURE_BLACK, ticks[i]);
    }
    qsort(c, (size_t)n, sizeof *c, by_height);
    for (int i = 0; i < n; i++) {
        double x = place_x(c[i]);
        used[i] = (place){x - 7, x + 7, place_y(c[i]->now_error / c[i]->naive_error)};
    }
    for (int i = 0; i < n; i++) {
        double x = place_x(c[i]), y = place_y(c[i]->now_error / c[i]->naive_error);
        figure_line(g, x1, -place_y(1), x, -y, "#bbbbbb", 1, FIGURE_WHOLE);
        figure_dot(g, x, -y, 6, part_colour(c[i]));
        used[n + i] = label(g, c[i], x, y, used, n + i);
    }
    figure_dot(g, x1, -place_y(1), 6, FIGURE_BLACK);
    figure_text(g, x1, -place_y(1), 0, -13, FIGURE_MIDDLE, FIGURE_BLACK, "the naive way");
}

/* Below: what errs in no trial, a line each. */
static void draw_lower(figure *g, cost **c, int n, double top)
{
    double bottom = top + row * (n + 0.7);
    frame(g, top, bottom);
    qsort(c, (size_t)n, sizeof *c, by_time);
    for (int i = 0; i < n; i++) {
        double x = place_x(c[i]), y = top + row * (i + 0.85);
        figure_dot(g, x, -y, 6, part_colour(c[i]));
        label(g, c[i], x, y, NULL, 0);
    }
    figure_text(g, plot_left, -(top + bottom) / 2, -8, 5, FIGURE_RIGHT, FIGURE_BLACK, "none");
    figure_text(g, (plot_left + plot_right) / 2.0, -bottom, 0, 44, FIGURE_MIDDLE, FIGURE_BLACK,
                "*time of the default*, by the time of the naive way");
}

static void draw(cost costs[chapters])
{
    options o = {0};
    cost *upper[chapters], *lower[chapters];
    int n = 0, m = 0;
    for (int i = 0; i < chapters; i++)
        if (costs[i].now_error > 0) upper[n++] = &costs[i];
        else lower[m++] = &costs[i];
    double top = plot_bottom + 60;
    figure g = figure_begin(&o, "costs.svg", 980, (int)(top + row * (m + 0.7) + 100));
    figure_text(&g, 490, -32, 0, 0, FIGURE_MIDDLE, FIGURE_BLACK,
                "*What accuracy costs:* each chapter's default beside its naive way");
    figure_text(&g, 100, -60, 0, 8, FIGURE_LEFT, FIGURE_GREEN, "less error in *less time*");
    figure_text(&g, 894, -60, 0, 8, FIGURE_RIGHT, FIGURE_RED, "less error for *more time*");
    figure_text(&g, 12, -60, 0, 8, FIGURE_LEFT, FIGURE_BLACK, "*error left*");
    draw_upper(&g, upper, n);
    draw_lower(&g, lower, m, top);
    double y = -(top + row * (m + 0.7) + 78);
    static const struct { const char *colour, *name; } part[] = {
        {FIGURE_BLUE, "rays and shapes"}, {FIGURE_GREEN, "structures"},
        {FIGURE_RED, "light"}};
    for (int i = 0; i < 3; i++) {
        figure_dot(&g, 270 + 180 * i, y, 6, part[i].colour);
        figure_text(&g, 270 + 180 * i, y, 12, 5, FIGURE_LEFT, part[i].colour, part[i].name);
    }
    figure_end(&g);
}

int main(int argc, char **argv)
{
    if (argc != 2) die(2, "costs: the directory of the CSV files, please: make costs");
    cost costs[chapters];
    table t = table_new("", "chapter|what errs|naive|default|error|now|time, default by naive");
    for (int i = 0; i < chapters; i++) {
        const subject *of = &subjects[i];
        cost c = costs[i] = cost_read(of, argv[1]);
        table_text(&t, "%s", of->chapter), table_text(&t, "%s", of->what);
        table_text(&t, "%s", of->naive), table_text(&t, "%s", of->now);
        table_number(&t, c.naive_error), table_number(&t, c.now_error);
        table_number(&t, c.now_time / c.naive_time);
    }
    printf("# What accuracy costs, a chapter a line; errors in the units of its table\n");
    table_print(&t, stdout);
    table_free(&t);
    draw(costs);
    printf("-> images/costs.svg\n");
    return 0;
}
