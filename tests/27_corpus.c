/* Hostile and broken files: those of tests/corpus/, found by a fuzzer or written by hand, as they
 * are and changed at random. Each is read, or refused with a message that names a file, and nothing
 * else happens: no crash, no hang (a watchdog ends the test), no leak (under the sanitizers).
 *
 * What begins with ok_ must be read, what begins with bad_ refused.
 */
#include "../chapters/27_effects/lab/explain.h"
#include "27_files.h"
#include "../common/random.h"
#include <dirent.h>

static random_stream rng;
static size_t below(size_t n) { return (size_t)(random_next_bits(&rng) % n); }
static FILE *nowhere;

/* All that is done with a scene short of drawing it. */
static void use(const studio *s)
{
    studio_view v;
    camera c;
    failure f;
    plan p = plan_of(s);
    if (studio_camera(s, 1, &v, &c, &f)) explain(nowhere, s, &p, &v);
    for (size_t i = 0; i < s->emitters; i++)
        if (vzero(s->material[studio_emitter_material(s, i)].mtl.ke))
            check(false, "an emitter that does not emit");
    plan_free(&p);
}

/* By its ending, as a program would come to read it: what was read is used; what was refused, for a
 * reason that may be shown. True: it was read. */
static bool feed(const char *name)
{
    studio s;
    failure f = {0, ""};
    char text[300];
    const char *read = name;
    if (ends_with(name, ".ppm") || ends_with(name, ".pfm") || ends_with(name, ".mtl")) {
        snprintf(text, sizeof text, "%s \"%s\"\n", ends_with(name, ".mtl") ? "mtl" : "environment",
                 name);
        put("feed.scene", text), read = "feed.scene";
    }
    bool ok = read_scene(read, &s, &f);
    if (ok) use(&s), studio_free(&s);
    else if (!(f.exit_code == 1 || f.exit_code == 2) || !strchr(f.text, ':'))
        check(false, "%s: exit %d, '%s'", name, f.exit_code, f.text);
    for (const char *p = f.text; !ok && *p; p++)
        if ((unsigned char)*p < ' ' || *p == 127)
            check(false, "%s: byte %d in a message", name, *p);
    return ok;
}

/* A copy with bytes changed, left out, doubled, or cut off. */
static void spoil(const char *text, size_t n, const char *name)
{
    char *copy = allocate(2 * n + 16, 1);
    const char *ending = strrchr(name, '.'), tokens[] = "-./\\#\"\n \r0919eE+nvfpsc";
    char to[32];
    snprintf(to, sizeof to, "spoilt%.8s", ending ? ending : "");
    memcpy(copy, text, n);
    size_t at = below(n + 1), k = n ? below(n - (at < n ? at : n - 1)) : 0, size = n;
    switch (below(4)) {
    case 0: size = at; break;
    case 1: if (at < n) copy[at] = tokens[below(sizeof tokens - 1)]; break;
    case 2: if (at < n) copy[at] = (char)below(256); break;
    case 3:
        memmove(copy + at + k, copy + at, n - at);
        size = n + k;
        break;
    }
    put_bytes(to, copy, size), free(copy);
    (void)feed(to);
}

int main(void)
{
    const char *const corpus = "tests/corpus";
    DIR *d = opendir(corpus);
    size_t files = 0, bytes = 0, rounds = check_count(8);
    rng = random_start(27, 3, 0);
    if (!mkdtemp(directory)) abort();
    nowhere = fopen("/dev/null", "w");
    seconds_at_most(120);
    check(d && nowhere, "tests/corpus is there: run this from the top of the tree");
    for (int pass = 0; d && pass < 2; pass++) {
        rewinddir(d);
        for (struct dirent *e; (e = readdir(d)) != NULL;) {
            char path[400], name[64];
            size_t n;
            failure f;
            if (e->d_name[0] == '.') continue;
            snprintf(name, sizeof name, "%.60s", e->d_name);
            snprintf(path, sizeof path, "%s/%s", corpus, name);
            char *text = file_read(path, &n, &f);
            if (!text) abort();
            if (pass == 0) put_bytes(name, text, n), files++, bytes += n;  /* they name others */
            else {
                bool ok = feed(name);
                check(ok || strncmp(name, "ok_", 3) != 0, "%s is refused", name);
                check(!ok || strncmp(name, "bad_", 4) != 0, "%s is read", name);
                for (size_t i = 0; i < rounds; i++) spoil(text, n, name);
            }
            free(text);
        }
    }
    check(files >= 30 && bytes < 100000, "%zu files, %zu bytes", files, bytes);
    if (d) closedir(d);
    if (nowhere) fclose(nowhere);
    remove_directory();
    return check_report("27_corpus");
}
