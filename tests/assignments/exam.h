/* exam.h: the checks of an assignment. Each asks questions, and marks the answers to them.
 *
 * An assignment's question.h has the types `question` and `answer` (any struct without pointers)
 * and `question_forget`, which removes what is due from a question before anybody answers it;
 * solve.h has `solve`, which calls the student's functions; public.h and hidden.h have lists of
 * checks. Who asks and marks never runs the student's code where that counts: judge.c writes the
 * questions into a file, worker.c (in a jail) reads them and writes answers, judge.c marks
 * those. What a submission prints, and how it ends, therefore decides nothing.
 *
 * A check is passed if all its cases are right; it holds cases whose answers differ, so that no
 * constant answer passes it. Case i of check c has random numbers of its own: (seed, c, i).
 * */
#ifndef EXAM_H
#define EXAM_H
#include "common/random.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "question.h"

enum { exam_why = 400 };  /* bytes of a message */

typedef struct {
    int exercise;
    const char *name;  /* what is checked, in a few words */
    double points;
    bool hard;
    int cases;
    question (*ask)(random_stream *random, int i);
    /* True if the answer is right; else `why` says what was asked, due and answered. */
    bool (*mark)(const question *q, const answer *a, char why[exam_why]);
} exam_check;

/* ---------------------------------------------------------------------------------------------- */
#define exam_say(why, ...) ((void)snprintf(why, exam_why, __VA_ARGS__), false)

static inline bool exam_near(double a, double b, double bound) { return fabs(a - b) <= bound; }

static inline real exam_between(random_stream *g, double lo, double hi)
{
    return (real)(lo + (hi - lo) * (double)random_next(g));
}

static inline vec3 exam_vector(random_stream *g, double half)
{
    return random_in_cube(g, (real)half);
}

/* Case i of check number c. All bytes are set, padding too: questions are written as they are. */
static inline question exam_question(const exam_check *check, uint64_t seed, int c, int i)
{
    question q;
    random_stream g = random_start(seed, (uint64_t)c, (uint64_t)i);
    memset(&q, 0, sizeof q);
    q = check->ask(&g, i);
    return q;
}

/* Marks `answers` of check->cases answers, the others are missing: that is what `verdict` is about.
 * Returns how many are right; `why` is about the first that is not. */
static inline int exam_mark(const exam_check *check, uint64_t seed, int c, const answer *a,
                            int answers, const char *verdict, char why[exam_why])
{
    int right = 0;
    why[0] = 0;
    for (int i = 0; i < answers; i++) {
        char text[exam_why] = "";
        question q = exam_question(check, seed, c, i);
        if (check->mark(&q, &a[i], text)) right++;
        else if (!why[0]) (void)snprintf(why, exam_why, "case %d: %.380s", i, text);
    }
    if (answers < check->cases && !why[0])
        (void)snprintf(why, exam_why, "no answer to case %d of %d: %.300s", answers, check->cases,
                       verdict);
    return right;
}
#endif
