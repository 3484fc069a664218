/* forty.h: forty balls of mirror, glass and paint, the largest of them the ground: the scene that
 * speed is measured on.
 *
 *   whitted_stage *f = forty_new();       stage_tracer(f); stage_end(f), free(f)
 *   camera c = forty_camera(aspect)
 *
 * Always the same balls; three suns. Glass casts no shadow here.
 */
#ifndef WHITTED_SCENES_FORTY_H
#define WHITTED_SCENES_FORTY_H

#include "whitted_stage.h"

enum { forty_balls = 40 };

/* ---------------------------------------------------------------------------------------------- */

/* x, y, z of the centre and the radius, in thousandths; by turns mirror, glass, paint. */
static const int forty_ball[forty_balls][4] = {
    {0, 0, -1000000, 1000000}, {1934, 3162, 2049, 480}, {-3768, 525, 1895, 591},
    {-3094, 553, 583, 583}, {592, -3095, 451, 451}, {3331, 2926, 353, 353},
    {-2890, 1740, 545, 545}, {2971, -1524, 251, 251}, {2979, -886, 1685, 613},
    {-2362, 4328, 2530, 501}, {-1610, -310, 581, 581}, {-3479, -789, 312, 304},
    {-150, 2437, 367, 367}, {-3817, 2798, 647, 611}, {-1071, 1428, 541, 541},
    {-2553, 4441, 267, 267}, {3437, 4336, 530, 530}, {2378, 3678, 527, 527},
    {-3271, -474, 2436, 600}, {3394, 1161, 376, 376}, {-2580, -2574, 367, 367},
    {3974, -1908, 505, 505}, {268, 47, 615, 615}, {2610, 445, 470, 470}, {3329, -2938, 271, 271},
    {-2955, 2653, 1846, 560}, {-1641, 425, 2299, 563}, {-372, 705, 1564, 611},
    {-770, -2028, 358, 358}, {2158, 2327, 430, 430}, {1198, 1445, 600, 600},
    {1179, 3181, 552, 552}, {2959, 2307, 2511, 562}, {235, -1871, 2465, 442},
    {-3567, -2132, 334, 334}, {909, -2441, 263, 263}, {647, 4466, 1308, 376},
    {-962, 4489, 1796, 610}, {-1810, 4282, 976, 447}, {-203, 1959, 2055, 475}};

static inline whitted_stage *forty_new(void)
{
    static const double sun[3][4] = {{5, -6, 9, 2}, {-6, -4, 5, 0.7}, {1, 8, 6, 0.4}};
    whitted_stage *f = allocate(1, sizeof *f);
    for (int k = 0; k < forty_balls; k++) {
        const int *b = forty_ball[k];
        vec3 c = {(real)b[0] / 1000, (real)b[1] / 1000, (real)b[2] / 1000};
        whitted_look paint = whitted_paint(0.3 + 0.15 * (k * 7 % 5), 0.3 + 0.15 * (k * 3 % 5),
                                               0.3 + 0.1 * (k * 11 % 7));
        stage_ball(f, c, (real)b[3] / 1000, k % 3 == 1 ? whitted_mirror(0.9)
                                            : k % 3 == 2 ? whitted_clear((uint32_t)k, 1) : paint);
        f->media[k] = (medium){k % 3 == 2 ? (real)1.5 : 1, {0, 0, 0}, 0};
    }
    f->checks = 1, f->look[0] = whitted_paint(0.3, 0.3, 0.3), f->odd = whitted_paint(0.8, 0.8, 0.8);
    for (int k = 0; k < 3; k++) {
        const double *s = sun[k], E = s[3];
        f->light[k] = (light){LIGHT_DIRECTIONAL, vunit(vec(s[0], s[1], s[2])), vec(E, E, E)};
    }
    f->clear = true;
    f->w = (whitted){.n = 3, .least = (real)1 / 256, .apart = true,
                     .background = {0.35, 0.55, 0.85}, .ambient = {0.1, 0.1, 0.1}};
    stage_begin(f, 8);
    return f;
}

static inline camera forty_camera(real aspect)
{
    return camera_at(vec(0, -11, 4.5), vec(0, 0.4, 0.9), vec(0, 0, 1), 31, aspect);
}

#endif
