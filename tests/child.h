/* child.h: runs a function in a child process; what it printed, and how it ended.
 *
 *   child_result r = child_run(function, context);      r.status is its exit code, or 128 + signal
 */
#ifndef CHILD_H
#define CHILD_H

#include "../common/posix.h"
#include <stdio.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

typedef struct { int status; char out[4096], err[4096]; } child_result;

static inline void child_slurp(FILE *from, char *to, size_t room)
{
    rewind(from);
    to[fread(to, 1, room - 1, from)] = 0;
    fclose(from);
}

static inline int child_status(int status)
{
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

static inline child_result child_run(void (*function)(void *), void *context)
{
    child_result r = {0, "", ""};
    FILE *out = tmpfile(), *err = tmpfile();
    if (!out || !err) abort();
    fflush(stdout);
    pid_t pid = fork();
    if (pid == 0) {
        dup2(fileno(out), STDOUT_FILENO);
        dup2(fileno(err), STDERR_FILENO);
        function(context);
        exit(0);
    }
    waitpid(pid, &r.status, 0);
    r.status = child_status(r.status);
    child_slurp(out, r.out, sizeof r.out);
    child_slurp(err, r.err, sizeof r.err);
    return r;
}

#endif
