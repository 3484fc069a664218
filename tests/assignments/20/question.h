/* What is asked in assignment 20, and what is answered. */
#ifndef QUESTION_20_H
#define QUESTION_20_H
#include "chapters/20_monte_carlo/first.h"

enum { question_most = 64 };
typedef struct {
    int n;                    /* how many of f, g, weight */
    real f[question_most];    /* exercises 1, 5: samples; 4: weights */
    real g[question_most];    /* 5: samples of the other function */
    real G;                   /* 5: its true mean */
    real a, b;                /* 3: heights of the density at 0 and 1, but for a factor */
    real u, v;                /* 2, 3, 4: in [0,1) */
    bool cosine;              /* 2: which of the two */
} question;

typedef struct { int i; real x, p, error; vec3 d; } answer;

/* Questions do not hold what is due. */
static inline void question_forget(question *q) { (void)q; }
#endif
