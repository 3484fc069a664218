/* What is asked in assignment 26, and what is answered. */
#ifndef QUESTION_26_H
#define QUESTION_26_H
#include "chapters/26_path_tracer/first.h"

/* When a path ends; see path_roulette. */
typedef struct { int sure; real lo, hi; } roulette_rule;

typedef struct {
    first_scene s;
    ray r;              /* exercises 2, 3 */
    first_point x;      /* 1, 4; its material is that of thing 0 of the scene */
    roulette_rule rule; /* 3 */
    uint64_t seed;
    int samples;
} question;

/* Means over all samples of what the function returns, and of its square; in exercise 3 how many
 * paths had so many hits, those of more in the last. */
enum { answer_lengths = 12 };
typedef struct { vec3 mean, square; int length[answer_lengths]; } answer;

/* Questions do not hold what is due: closed forms and other ways of sampling find it. */
static inline void question_forget(question *q) { (void)q; }
#endif
