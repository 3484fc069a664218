#!/bin/sh
# A ray's way through 26: the files whose functions path_start (a sample's random numbers) and path_row
# enter, and what these enter in turn, in a scene: `sh tests/way.sh` lists them. In the Cornell box 25 at most; all are named in 26's MEASURED.md,
# and it names no other. (gcc -finstrument-functions; addr2line says where a function is.)
. tests/check.sh
page=chapters/26_path_tracer/MEASURED.md

cat >"$scratch/way.c" <<'END'
#include "chapters/26_path_tracer/lab/showcase.h"
#define plain __attribute__((no_instrument_function))
enum { most = 1 << 12 };
static bool inside;
static void *seen[most];
plain void __cyg_profile_func_exit(void *f, void *from) { (void)f, (void)from; }
plain void __cyg_profile_func_enter(void *f, void *from)
{
    size_t k = (size_t)f / 4 % most;
    (void)from;
    if (!inside) return;
    while (seen[k] && seen[k] != f) k = (k + 1) % most;
    if (!seen[k]) printf("%p\n", seen[k] = f);
}
int main(int argc, char **argv)
{
    showcase c;
    failure f;
    path_tracer t;
    path_counts n = {0};
    if (argc != 2 || !showcase_of(argv[1], 1, &c, &f)) return 1;
    path_tracer_of(&c.s, showcase_sky(&c), path_defaults, &t);
    for (int y = 0; y < 32; y++) {
        path_random s[32];
        path_walk walk[32];
        for (int x = 0; x < 32; x++) {
            inside = true;
            s[x] = path_start(&t.how, 1, (uint64_t)(32 * y + x), 0, 1);
            inside = false;
            path_pair(&s[x]), path_begin(&walk[x], camera_ray(c.eye, (real)x, (real)y, 32, 32));
        }
        inside = true, path_row(&t, walk, s, 32, &n), inside = false;
    }
    return 0;
}
END
${GCC:-gcc} -std=c11 -O0 -g -march=native -no-pie -finstrument-functions -w -I. -o "$scratch/way" \
    "$scratch/way.c" -lm -lpthread || exit 1
for scene in cornell spheres metal teapot rough; do
    "$scratch/way" $scene | addr2line -e "$scratch/way" | sed 's|:.*||' | xargs realpath --relative-to=. |
        sort -u >"$scratch/$scene"
    echo "$scene: $(wc -l <"$scratch/$scene") files"
done
if [ "$(wc -l <"$scratch/cornell")" -le 25 ]; then ok; else no "more than 25 files in the box"; fi
sort -u "$scratch/cornell" "$scratch"/[smtr]* | grep '^c.*\.h$' | sed 's|^chapters/||' >"$scratch/all"
awk '/^## / { on = 0 } /^## A ray.s way/ { on = 1 } on' $page | grep -o '([^)]*\.h)' | tr -d '()' |
    sed 's|^\.\./\.\./||; s|^\.\./||; /\//!s|^|26_path_tracer/|' | sort -u >"$scratch/said"
if diff "$scratch/said" "$scratch/all"; then ok; else no "$page names other files (<) than rays cross (>)"; fi
report
