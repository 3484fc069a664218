/* html.h: where results go: to the screen, and into a report: one HTML file that needs no other.
 *
 *   html_report *r = html_begin(&o, "report.html", "Title");   path NULL: the screen alone
 *   html_element(r, "h2", "Growth")    in the report alone
 *   html_first(r, "p", text)           likewise, before all that is said otherwise
 *   html_note(r, "%zu rays", n)        "# 7 rays" on the screen, a paragraph in the report
 *   html_table(r, &t)                  output_extra_table, and in the report
 *   html_plot(r, &p, "x.svg")          output_plot, and in the report
 *   html_picture(r, &im, "caption")    in the report alone
 *   html_end(r)                        writes the file
 */
#ifndef COMPARE_LAB_HTML_H
#define COMPARE_LAB_HTML_H

#include "../../../common/lab/report.h"

typedef struct {
    const options *o;
    file_writer file;
    const char *path;
    FILE *body;  /* kept, in `text`, until the end; NULL: there is no report */
    char *text;
    size_t size;
} html_report;

/* ---------------------------------------------------------------------------------------------- */

static inline void html_escaped(FILE *out, const char *text)
{
    for (; *text; text++)
        if (strchr("<>&\"", *text)) fprintf(out, "&#%d;", *text);
        else putc(*text, out);
}

cold_inline html_report *html_begin(const options *o, const char *path, const char *title)
{
    static const char *const style =
        "body { font: 16px/1.5 sans-serif; max-width: 70em; margin: 0 auto; padding: 1em; "
        "color: #222; background: white; }\n"
        "h1, h3 { line-height: 1.2; } h2 { margin-top: 2em; border-bottom: 1px solid #ccc; }\n"
        "h3 { font-size: 95%; margin: 1.5em 0 .3em; } figure { margin: 1em 0; }\n"
        ".wide { overflow-x: auto; margin: .3em 0 1em; }\n"
        ".run, .note { color: #555; font-size: 90%; overflow-wrap: anywhere; }\n"
        ".note { margin: .3em 0; } table { border-collapse: collapse; font-size: 85%; }\n"
        "th, td { padding: .2em .6em; border-bottom: 1px solid #ddd; text-align: left; }\n"
        "th { vertical-align: bottom; } td { white-space: nowrap; }\n"
        ".n { text-align: right; font-variant-numeric: tabular-nums; }\n"
        "th, td:first-child { background: #f4f4f4; }\n"
        "td:first-child, th:first-child { position: sticky; left: 0; }\n"
        "img, svg { max-width: 100%; height: auto; }\n"
        "td svg { max-width: none; overflow: visible; }\n"
        "@media (max-width: 900px) { .wide > svg, .wide > img { max-width: none; } }\n";
    failure f;
    struct utsname u;
    html_report *r = allocate(1, sizeof *r);
    *r = (html_report){.o = o, .path = path};
    if (!path) return r;
    if (!file_begin(&r->file, path, &f)) fail(f);
    FILE *out = r->file.stream;
    r->body = open_memstream(&r->text, &r->size);
    if (!r->body) die(1, "%s: no room for a report", path);
    fprintf(out,
            "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
            "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
            "<title>%s</title>\n<style>\n%s</style></head><body>\n<h1>%s</h1>\n<p class=\"run\">",
            title, style, title);
    if (uname(&u) >= 0) fprintf(out, "%s %s, %d cores; ", u.sysname, u.machine, parallel_cores());
    fprintf(out, "%s%s; flags %s; real = %s</p>\n", strstr(__VERSION__, "lang") ? "" : "gcc ",
            __VERSION__, BUILD_FLAGS, real_is_float ? "float" : "double");
    return r;
}

/* <tag>text</tag>, where there is a report. */
static inline void html_tag(FILE *out, const char *tag, const char *text)
{
    if (!out) return;
    fprintf(out, "<%s>", tag);
    html_escaped(out, text);
    fprintf(out, "</%.*s>\n", (int)strcspn(tag, " "), tag);
}

static inline void html_element(const html_report *r, const char *tag, const char *text)
{
    html_tag(r->body, tag, text);
}

static inline void html_first(const html_report *r, const char *tag, const char *text)
{
    html_tag(r->file.stream, tag, text);
}

__attribute__((format(printf, 2, 3)))
static inline void html_note(const html_report *r, const char *format, ...)
{
    char text[4096];
    va_list list;
    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    printf("# %s\n", text);
    html_element(r, "p class=\"note\"", text);
}

static inline void html_table(const html_report *r, table *t)
{
    FILE *out = r->body;
    html_element(r, "h3", t->title);
    if (out) fprintf(out, "<div class=\"wide\"><table>\n");
    for (size_t i = 0; out && i < t->n; i++) {
        size_t column = i % t->columns;
        fprintf(out, "%s<%s%s>", column ? "" : "<tr>", i < t->columns ? "th" : "td",
                t->number[column] ? " class=\"n\"" : "");
        html_escaped(out, t->cell[i]);
        fprintf(out, "</%s>%s", i < t->columns ? "th" : "td",
                column + 1 == t->columns ? "</tr>\n" : "");
    }
    if (out) fprintf(out, "</table></div>\n");
    output_extra_table(r->o, t);
}

/* On a narrow screen plots and pictures are scrolled, not shrunk: labels stay legible. */
static inline void html_plot(const html_report *r, plot *p, const char *name)
{
    if (r->body) fprintf(r->body, "<div class=\"wide\">");
    if (r->body) plot_write(p, r->body), fprintf(r->body, "</div>\n");
    output_plot(r->o, p, name);
}

static inline void html_base64(FILE *out, const unsigned char *b, size_t n)
{
    static const char digit[] =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (size_t i = 0; i < n; i += 3) {
        uint32_t x = 0;
        for (size_t k = 0; k < 3; k++) x = x << 8 | (i + k < n ? b[i + k] : 0);
        for (size_t k = 0; k < 4; k++) putc(i + k <= n ? digit[x >> (18 - 6 * k) & 63] : '=', out);
    }
}

static inline void html_picture(const html_report *r, const image *im, const char *caption)
{
    size_t bad, n;
    char *png;
    if (!r->body) return;
    FILE *out = open_memstream(&png, &n);
    uint8_t *rgb = image_bytes(im, &bad);
    if (out) png_write(out, rgb, im->width, im->height);
    if (!out || fclose(out) != 0) die(1, "%s: no room for a picture", r->path);
    fprintf(r->body, "<figure><div class=\"wide\"><img alt=\"");
    html_escaped(r->body, caption);
    fprintf(r->body, "\" src=\"data:image/png;base64,");
    html_base64(r->body, (const unsigned char *)png, n);
    fprintf(r->body, "\"></div>");
    html_element(r, "figcaption", caption);
    fprintf(r->body, "</figure>\n");
    free(rgb), free(png);
}

cold_inline void html_end(html_report *r)
{
    failure f;
    if (r->path) {
        if (fclose(r->body) != 0) die(1, "%s: no room for a report", r->path);
        fprintf(r->file.stream, "%s</body></html>\n", r->text);
        free(r->text);
        if (!file_commit(&r->file, &f)) fail(f);
        output_note(r->path);
    }
    free(r);
}

#endif
