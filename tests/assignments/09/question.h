/* What is asked in assignment 09, and what is answered. */
#ifndef QUESTION_09_H
#define QUESTION_09_H
#include "chapters/09_aabb/first.h"

/* A box that stands at any angle: its axes are unit vectors at right angles, and it reaches from
 * c by half.x along u and along -u, by half.y along v, by half.z along w. */
typedef struct { vec3 c, u, v, w, half; } turned_box;

typedef struct {
    aabb a, b;          /* the box; in exercise 5 a moves */
    vec3 move;          /* 5 */
    turned_box box;     /* 4 */
    ray r;
    bool is_due;        /* what is due, where it is known by construction */
    real t;
    vec3 n;
} question;

typedef struct { bool is; int face; real t0, t1; vec3 n; } answer;
/* Who answers does not get to see what is due. */
static inline void question_forget(question *q)
{
    q->is_due = false, q->t = 0, q->n = vec(0, 0, 0);
}
#endif
