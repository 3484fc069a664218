/* What is asked in assignment 04, and what is answered. */
#ifndef QUESTION_04_H
#define QUESTION_04_H
#include "chapters/02_camera/first.h"
#include "chapters/04_triangle/first.h"

/* Which sides of a triangle count: the front is the one that sees a, b, c counter-clockwise. */
enum { side_front = 1, side_back = 2, side_both = 3 };

typedef struct {
    first_camera camera;
    real x, y;         /* where in the picture, in pixels */
    triangle tri;      /* exercises 2, 3 */
    int side;          /* 3 */
    vec3 a, b, c, d;   /* 5 */
    ray r;
    hit due;           /* what was aimed at: known before any test */
    bool is_due;
} question;

typedef struct { bool is; ray r; hit h; } answer;
/* Who answers does not get to see what is due. */
static inline void question_forget(question *q)
{
    q->is_due = false, q->due = (hit){0, 0, 0, 0};
}
#endif
