/* first.h: what a ray sees of one ball less another, A - B: constructive solid geometry (构造实体几何).
 * Wrong where the eye is in A or in B: of the hits it keeps those with t > 0, forgets the way in
 * behind the eye, and takes the way out for one. spans.h keeps the hits of the whole line. */
#ifndef FIRST_CSG_H
#define FIRST_CSG_H
#include "../03_sphere/first.h"

/* Where the ray crosses a surface: of ball 0, which is A, or of ball 1, which is B. */
typedef struct { real t; int ball; } first_crossing;

/* The crossings with t > 0, nearest first; how many. */
static inline int first_crossings(const sphere ball[2], ray r, first_crossing at[4])
{
    int n = 0;
    for (int k = 0; k < 2; k++) {
        real t[2];
        if (!first_sphere_roots(ball[k], r, &t[0], &t[1])) continue;
        for (int i = 0; i < 2; i++) {
            if (!(t[i] > 0)) continue;
            int j = n++;
            for (; j > 0 && at[j - 1].t > t[i]; j--) at[j] = at[j - 1];
            at[j] = (first_crossing){t[i], k};
        }
    }
    return n;
}

/* A point is in the difference (差集) if it is in A and not in B.                          (6.1) */
static inline bool first_in_difference(const bool in[2]) { return in[0] && !in[1]; }

/* Walk along the ray: each crossing takes us into its ball, or out of it.                   (6.2)
 * The surface of A - B is where the answer to (6.1) changes. */
static inline bool first_difference_hit(const sphere ball[2], ray r, hit *out)
{
    first_crossing at[4];
    bool in[2] = {false, false};  /* we begin outside of both, it seems */
    int n = first_crossings(ball, r, at);
    for (int i = 0; i < n; i++) {
        bool before = first_in_difference(in);
        in[at[i].ball] = !in[at[i].ball];
        if (first_in_difference(in) == before || !ray_covers(r, at[i].t)) continue;
        *out = (hit){at[i].t, 0, 0, (uint32_t)at[i].ball};
        return true;
    }
    return false;
}

/* The normal points out of A - B: where B was cut away, into B. */
static inline vec3 first_difference_normal(const sphere ball[2], vec3 p, hit h)
{
    vec3 n = first_sphere_normal(ball[h.shape], p);
    return h.shape == 0 ? n : vneg(n);
}
#endif
