/* 21_distributed: what Whitted's way cannot do: soft shadows, gloss, open skies, lenses.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 21_distributed chapters/21_distributed/main.c -lm -lpthread
 *
 * Without options: a showroom with all effects and with none, and the error of pictures against
 * time. With --full also the two failures and their mends, and motion. */
#include "../../common/output.h"
#include "lab/extent_figure.h"
#include "lab/measure.h"

int main(int argc, char **argv)
{
    const char *effects = "all";
    char path[64];
    bool all = false;
    const option own[] = {
        {"effects", OPTION_TEXT, &effects, 0, 0, "of s (soft) g (gloss) o (occlusion) l (lens)"},
        {"spend-all", OPTION_FLAG, &all, 0, 0, "send what cannot contribute, too"}, {0}};
    options o = {.width = 640, .height = 360, .seed = 1, .samples = 8,
                 .quick_width = 160, .quick_height = 90, .quick_samples = 2};
    o = options_read(argc, argv, "21_distributed", "One set of samples for all effects.", o, own);
    if (o.out && o.csv) die(2, "--out draws, --csv measures: one of them");
    static const char letters[] = "sgol";
    bool every = strcmp(effects, "all") == 0, named = every || strcmp(effects, "none") == 0;
    int chosen = every ? LOOK_ALL : 0;
    for (const char *c = effects; *c && !named; c++) {
        const char *at = strchr(letters, *c);
        if (!at) die(2, "--effects %s: all, none, or letters of s g o l", effects);
        chosen |= 1 << (at - letters);
    }
    if (!every && !o.out) {  /* images/ is for the text */
        snprintf(path, sizeof path, "build/21_distributed_%.20s.png", effects);
        mkdir("build", 0777);
        o.out = path;
    }
    draw_showroom(&o, chosen, all, "21_distributed.png");
    if (o.out) return output_done(&o);
    draw_showroom(&o, 0, false, "21_distributed_whitted.png");
    draw_extent(&o);
    if (o.full && !getenv("BENCH_ONCE"))  /* bench.h: the tables are all that is asked for */
        draw_teapot(&o), draw_cornell(&o), draw_motion(&o);
    table_of_pictures(&o);
    return output_done(&o);
}
