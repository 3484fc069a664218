/* What is asked in assignment 19, and what is answered. */
#ifndef QUESTION_19_H
#define QUESTION_19_H
#include "common/random.h"
#include "chapters/19_whitted/first.h"

typedef struct {
    vec3 d, n;         /* exercise 1: unit, d . n <= 0 */
    real n1, n2;       /* 1, 2; 4: outside, of the ball */
    real ci, ct;       /* 2: cosines on both sides; 3: outside */
    real T;            /* 3: the share that one way through the glass leaves */
    sphere ball;       /* 4 */
    ray r;             /* 4, 5 */
    first_scene s;     /* 5 */
    real least;        /* 5 */
} question;

typedef struct { bool is; real x, y; vec3 v, w; int rays; } answer;

/* Questions do not hold what is due. */
static inline void question_forget(question *q) { (void)q; }
#endif
