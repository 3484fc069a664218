/* 26 The Cornell box, path traced: left one sample a pixel, right 25. Shown twice as bright.
cc -std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize -o 26_path_tracer_first chapters/26_path_tracer/first.c -lm
   26_path_tracer_first [SAMPLES a pixel, 1 to 65536] [PICTURE.png] */
#include "../../common/image.h"
#include "first.h"

enum { side = 320, most = 65536 };

int main(int argc, char **argv)
{
    char *end = "";
    long N = argc > 1 ? strtol(argv[1], &end, 10) : 0;
    bool given = argc > 1 && isdigit((unsigned char)argv[1][0]) && *end == 0;
    const char *path = picture_path_after(given, argc, argv, "26_path_tracer_first");
    failure f = {2, "samples a pixel: 1 to 65536"};
    if (!given) N = 25;
    if (N < 1 || N > most) fail(f);

    image im = image_new(2 * side, side);
    first_scene s = first_cornell();
    first_camera c = first_cornell_inside(side, side);
    for (int y = 0; y < side; y++) {
        for (int x = 0; x < side; x++) {
            vec3 sum = vec(0, 0, 0);
            for (int i = 0; i < N; i++) {
                random_stream random = random_start(1, y * side + x, i);
                real px = x + random_next(&random), py = y + random_next(&random);
                sum = vadd(sum, first_path(&s, first_camera_ray(c, px, py), &random));
                if (i == 0) image_set(&im, x, y, vscale(sum, 2));
            }
            image_set(&im, side + x, y, vscale(sum, 2.0 / (double)N));
        }
        if (N > 100 && isatty(2)) fprintf(stderr, "\r%d of %d rows ", y + 1, side);
    }
    return picture_end(path, &im);
}
