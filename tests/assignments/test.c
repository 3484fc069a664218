/* test.c [EXERCISE] [SEED]: the public checks of an assignment, asked and marked in one program, so
 * that a debugger sees everything. Grading has other seeds, and more and harder checks. */
#include "exam.h"
#include "public.h"
#include "solve.h"

int main(int argc, char **argv)
{
    int only = argc > 1 ? atoi(argv[1]) : 0, failed = 0;
    uint64_t seed = argc > 2 ? strtoull(argv[2], NULL, 10) : 1;
    for (int c = 0; c < (int)(sizeof public_checks / sizeof *public_checks); c++) {
        const exam_check *check = &public_checks[c];
        char why[exam_why];
        if (only && check->exercise != only) continue;
        answer *a = calloc((size_t)check->cases, sizeof *a);
        if (!a) return 1;
        for (int i = 0; i < check->cases; i++) {
            question q = exam_question(check, seed, c, i);
            question_forget(&q);
            a[i] = solve(check->exercise, &q);
        }
        int right = exam_mark(check, seed, c, a, check->cases, "", why);
        free(a);
        bool ok = right == check->cases;
        failed += !ok;
        printf("%s %d %-32s %4d of %4d right %5g points\n", ok ? "passed" : "FAILED",
               check->exercise, check->name, right, check->cases, ok ? check->points : 0);
        if (!ok) printf("       %s\n", why);
    }
    return failed > 0;
}
