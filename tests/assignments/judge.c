/* judge.c: asks and marks. It holds none of the student's code, and runs none.
 *
 *   judge list                                          exercise, check, points, hard, public
 *   judge ask EXERCISE LEVEL SEED >QUESTIONS            LEVEL: easy or hard
 *   judge mark EXERCISE LEVEL SEED ANSWERS VERDICT      and what each got, and why not more
 *
 * Lines of fields with a tab between; VERDICT says how the worker ended. */
#include "exam.h"
#include "public.h"
#include "hidden.h"

enum { of_public = sizeof public_checks / sizeof *public_checks,
       of_hidden = sizeof hidden_checks / sizeof *hidden_checks };

static const exam_check *check_of(int c)
{
    return c < of_public ? &public_checks[c] : &hidden_checks[c - of_public];
}

static void list(void)
{
    for (int c = 0; c < of_public + of_hidden; c++)
        printf("%d\t%s\t%g\t%d\t%d\n", check_of(c)->exercise, check_of(c)->name,
               check_of(c)->points, check_of(c)->hard, c < of_public);
}

static void ask(const exam_check *check, uint64_t seed, int c)
{
    for (int i = 0; i < check->cases; i++) {
        question q = exam_question(check, seed, c, i);
        question_forget(&q);
        if (fwrite(&q, sizeof q, 1, stdout) != 1) exit(1);
    }
}

static void mark(const exam_check *check, uint64_t seed, int c, FILE *answers, const char *verdict)
{
    char why[exam_why] = "";
    answer *a = calloc((size_t)check->cases, sizeof *a);
    if (!a) exit(1);
    int n = answers ? (int)fread(a, sizeof *a, (size_t)check->cases, answers) : 0;
    int right = exam_mark(check, seed, c, a, n, verdict, why);
    free(a);
    printf("%d\t%s\t%g\t%g\t%d\t%d\t", check->exercise, check->name,
           right == check->cases ? check->points : 0, check->points, check->hard, c < of_public);
    if (right == check->cases) printf("all %d right\n", right);
    else printf("%d of %d right; %s\n", right, check->cases, why);
}

int main(int argc, char **argv)
{
    if (argc == 2 && strcmp(argv[1], "list") == 0) return list(), 0;
    bool asks = argc == 5 && strcmp(argv[1], "ask") == 0;
    if (!asks && !(argc == 7 && strcmp(argv[1], "mark") == 0)) return 2;
    int exercise = atoi(argv[2]);
    bool hard = strcmp(argv[3], "hard") == 0;
    uint64_t seed = strtoull(argv[4], NULL, 10);
    FILE *answers = asks ? NULL : fopen(argv[5], "rb");
    for (int c = 0; c < of_public + of_hidden; c++) {
        const exam_check *check = check_of(c);
        if (check->exercise != exercise || check->hard != hard) continue;
        if (asks) ask(check, seed, c);
        else mark(check, seed, c, answers, argv[6]);
    }
    return 0;
}
