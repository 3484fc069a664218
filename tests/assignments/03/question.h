/* What is asked in assignment 03, and what is answered. */
#ifndef QUESTION_03_H
#define QUESTION_03_H
#include "common/random.h"
#include "chapters/03_sphere/first.h"

typedef struct {
    sphere s, other;      /* exercises 1, 2; 4: both move */
    vec3 v, w;            /* 4: how far they move in the time 1 */
    vec3 radii;           /* 3: the ellipsoid has the centre s.c */
    vec3 a, b;            /* 5: the ends of the segment; s.r is the radius */
    ray r;
} question;

typedef struct { bool is; real t0, t1; vec3 n; } answer;

/* Questions do not hold what is due: the judge looks for it by bisection. */
static inline void question_forget(question *q) { (void)q; }
#endif
