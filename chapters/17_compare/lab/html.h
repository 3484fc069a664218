/* html.h: a report in one file that needs nothing else: tables, charts as SVG, pictures within.
 *
 *   html_report *r = html_begin("report.html", "Title");   path NULL: NULL, and all that follows
 *                                                          does nothing
 *   html_heading(r, "Verdict"), html_element(r, "p", "text")
 *   html_table(r, &o, &t)              output_extra_table, and in the report
 *   html_plot(r, &o, &p, "x.svg")      output_plot, and in the report
 *   html_picture(r, &im, "caption")
 *   html_end(r)                        writes the file
 */
#ifndef COMPARE_LAB_HTML_H
#define COMPARE_LAB_HTML_H

#include "../../../common/lab/report.h"

typedef struct { file_writer file; const char *path; } html_report;

/* ---------------------------------------------------------------------------------------------- */

static inline FILE *html_file(const html_report *r) { return r->file.stream; }

static inline void html_escaped(FILE *out, const char *text)
{
    for (; *text; text++)
        if (strchr("<>&\"", *text)) fprintf(out, "&#%d;", *text);
        else putc(*text, out);
}

/* Where the system says: its name for the processor. */
static inline void html_processor(FILE *out)
{
    char line[256];
    FILE *in = fopen("/proc/cpuinfo", "r");
    while (in && fgets(line, sizeof line, in)) {
        const char *name = strchr(line, ':');
        if (strncmp(line, "model name", 10) != 0 || !name) continue;
        line[strcspn(line, "\n")] = 0;
        html_escaped(out, name + 2);
        fprintf(out, "; ");
        break;
    }
    if (in) fclose(in);
}

static inline html_report *html_begin(const char *path, const char *title)
{
    failure f;
    if (!path) return NULL;
    html_report *r = allocate(1, sizeof *r);
    r->path = path;
    if (!file_begin(&r->file, path, &f)) fail(f);
    fprintf(html_file(r),
            "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
            "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
            "<title>%s</title>\n<style>\n"
            "body { font: 16px/1.5 sans-serif; max-width: 70em; margin: 0 auto; padding: 1em; "
            "color: #222; background: white; }\n"
            "h1 { line-height: 1.2; } h2 { margin-top: 2em; border-bottom: 1px solid #ccc; }\n"
            ".wide { overflow-x: auto; margin: 1em 0; } .run { color: #555; font-size: 90%%; "
            "overflow-wrap: anywhere; }\n"
            "table { border-collapse: collapse; font-size: 85%%; } caption { text-align: left; "
            "font-weight: bold; padding: .3em 0; }\n"
            "th, td { padding: .2em .6em; border-bottom: 1px solid #ddd; text-align: left; }\n"
            "th { vertical-align: bottom; background: #f4f4f4; } .n { text-align: right; "
            "font-variant-numeric: tabular-nums; }\n"
            "td:first-child, th:first-child { position: sticky; left: 0; background: #f4f4f4; }\n"
            "svg, img { max-width: 100%%; height: auto; } figure { margin: 1em 0; }\n"
            ".wide > svg { max-width: none; } @media (min-width: 900px) { .wide > svg { "
            "max-width: 100%%; } }\n"
            "</style></head><body>\n<h1>%s</h1>\n<p class=\"run\">", title, title);
    struct utsname u;
    if (uname(&u) >= 0) fprintf(html_file(r), "%s %s, %d cores; ", u.sysname, u.machine,
                                parallel_cores());
    html_processor(html_file(r));
    fprintf(html_file(r), "%s%s; flags %s; real = %s</p>\n",
            strstr(__VERSION__, "lang") ? "" : "gcc ", __VERSION__, BUILD_FLAGS,
            real_is_float ? "float" : "double");
    return r;
}

/* <tag>text</tag>, where there is a report. */
static inline void html_element(const html_report *r, const char *tag, const char *text)
{
    if (!r) return;
    fprintf(html_file(r), "<%s>", tag);
    html_escaped(html_file(r), text);
    fprintf(html_file(r), "</%s>\n", tag);
}

static inline void html_heading(const html_report *r, const char *text)
{
    html_element(r, "h2", text);
}

static inline void html_rows(FILE *out, const table *t)
{
    fprintf(out, "<div class=\"wide\"><table><caption>");
    html_escaped(out, t->title);
    fprintf(out, "</caption>\n");
    for (size_t i = 0; i < t->n; i++) {
        size_t column = i % t->columns;
        const char *cell = i < t->columns ? "th" : "td";
        fprintf(out, "%s<%s%s>", column ? "" : "<tr>", cell,
                t->number[column] ? " class=\"n\"" : "");
        html_escaped(out, t->cell[i]);
        fprintf(out, "</%s>%s", cell, column + 1 == t->columns ? "</tr>\n" : "");
    }
    fprintf(out, "</table></div>\n");
}

static inline void html_table(const html_report *r, const options *o, table *t)
{
    if (r) html_rows(html_file(r), t);
    output_extra_table(o, t);
}

/* On a narrow screen it is scrolled rather than shrunk. */
static inline void html_plot(const html_report *r, const options *o, plot *p, const char *name)
{
    if (r) fprintf(html_file(r), "<div class=\"wide\">");
    if (r) plot_write(p, html_file(r));
    if (r) fprintf(html_file(r), "</div>\n");
    output_plot(o, p, name);
}

static inline void html_base64(FILE *out, const unsigned char *b, size_t n)
{
    static const char digit[] =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (size_t i = 0; i < n; i += 3) {
        uint32_t x = (uint32_t)b[i] << 16;
        if (i + 1 < n) x |= (uint32_t)b[i + 1] << 8;
        if (i + 2 < n) x |= b[i + 2];
        putc(digit[x >> 18], out), putc(digit[x >> 12 & 63], out);
        putc(i + 1 < n ? digit[x >> 6 & 63] : '=', out);
        putc(i + 2 < n ? digit[x & 63] : '=', out);
    }
}

static inline void html_picture(const html_report *r, const image *im, const char *caption)
{
    if (!r) return;
    size_t bad;
    FILE *scratch = tmpfile();
    if (!scratch) die(1, "%s: no room for a picture", r->path);
    uint8_t *rgb = image_bytes(im, &bad);
    png_write(scratch, rgb, im->width, im->height);
    free(rgb);
    size_t n = (size_t)ftell(scratch);
    unsigned char *bytes = allocate(n, 1);
    rewind(scratch);
    n = fread(bytes, 1, n, scratch);
    fclose(scratch);
    fprintf(html_file(r), "<figure><img alt=\"");
    html_escaped(html_file(r), caption);
    fprintf(html_file(r), "\" src=\"data:image/png;base64,");
    html_base64(html_file(r), bytes, n);
    fprintf(html_file(r), "\">");
    html_element(r, "figcaption", caption);
    fprintf(html_file(r), "</figure>\n");
    free(bytes);
}

static inline void html_end(html_report *r)
{
    failure f;
    if (!r) return;
    fprintf(html_file(r), "</body></html>\n");
    if (!file_commit(&r->file, &f)) fail(f);
    output_note(r->path);
    free(r);
}

#endif
