/* worker.c EXERCISE: reads questions from its input, asks the student's function, writes answers to
 * file descriptor 3. Each answer is written at once: what follows a crash is lost, no more. */
#include "common/posix.h"
#include <unistd.h>
#include "question.h"
#include "solve.h"

int main(int argc, char **argv)
{
    static question q;
    int exercise = argc > 1 ? argv[1][0] - '0' : 0;
    while (read(0, &q, sizeof q) == (ssize_t)sizeof q) {
        static answer a;
        a = solve(exercise, &q);
        if (write(3, &a, sizeof a) != (ssize_t)sizeof a) return 1;
    }
    return 0;
}
