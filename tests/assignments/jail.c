/* jail.c: runs a program that nobody trusts, with limits, and says in one line how it ended.
 *
 *   jail run QUESTIONS ANSWERS PROGRAM ARGUMENT..   input from QUESTIONS; descriptor 3 is ANSWERS
 *   jail limit QUESTIONS ANSWERS PROGRAM ARGUMENT..   the same, where `run` cannot hold
 *   jail build PROGRAM ARGUMENT..                   a compiler: prints the first 4000 bytes it says
 *   jail can                                        exit 0: `run` refuses system calls here
 *
 * Limits: processor time, memory, length of files, processes, and time by the clock. `run` on Linux
 * also refuses (seccomp) all system calls but for memory, and reading and writing what is open
 * already: no file, no process, no network, no signal to others; the program must be linked
 * statically. What the program prints is counted and thrown away. */
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { shown = 4000 };  /* bytes of a compiler's messages */
typedef struct { rlim_t cpu, memory, file; int seconds; } limits;
static const limits run_limits = {5, 512u << 20, 16u << 20, 15};
static const limits build_limits = {30, 2048u << 20, 32u << 20, 60};

#ifdef __linux__
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>

#if defined __x86_64__
#define jail_machine AUDIT_ARCH_X86_64
#elif defined __aarch64__
#define jail_machine AUDIT_ARCH_AARCH64
#endif
#endif

#ifdef jail_machine
#define allow(call) \
    BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, __NR_##call, 0, 1), \
    BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW)
#define forbid(call) \
    BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, __NR_##call, 0, 1), \
    BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS)

/* What is in neither list fails with EPERM. execve starts the program; after that it gains nothing:
 * these rules stay, and a program that may open nothing does not get far. */
static bool refuse_system_calls(void)
{
    static struct sock_filter rule[] = {
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(struct seccomp_data, arch)),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, jail_machine, 1, 0),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS),
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(struct seccomp_data, nr)),
        allow(read), allow(write), allow(writev), allow(exit), allow(exit_group), allow(brk),
        allow(mmap), allow(munmap), allow(mremap), allow(mprotect), allow(madvise), allow(fstat),
        allow(rt_sigreturn), allow(rt_sigaction), allow(rt_sigprocmask), allow(getrandom),
        allow(set_tid_address), allow(set_robust_list), allow(clock_gettime), allow(futex),
        allow(execve),
#ifdef __x86_64__
        allow(arch_prctl), forbid(open), forbid(creat), forbid(fork), forbid(vfork),
        forbid(unlink), forbid(rename),
#endif
        forbid(openat), forbid(clone), forbid(socket), forbid(kill),
        forbid(unlinkat), forbid(renameat), forbid(ptrace), forbid(symlinkat), forbid(mkdirat),
#ifdef __NR_clone3
        forbid(clone3),
#endif
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EPERM),
    };
    struct sock_fprog program = {sizeof rule / sizeof *rule, rule};
    return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0
        && prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}
#else
static bool refuse_system_calls(void) { return false; }
#endif

static void limit(int what, rlim_t most)
{
    struct rlimit r = {most, most};
    (void)setrlimit(what, &r);
}

/* The child: descriptors 0 to 3 and no others, limits, the program. Never returns. */
static void become(char **program, const char *in, const char *out, int say, limits l,
                   bool refuse)
{
    int from = open(in, O_RDONLY), to = out ? open(out, O_WRONLY | O_CREAT | O_TRUNC, 0600) : say;
    if (from < 0 || to < 0) _exit(127);
    /* Out of the way first: dup2 must not close what it is to copy next. */
    from = fcntl(from, F_DUPFD, 10), to = fcntl(to, F_DUPFD, 10), say = fcntl(say, F_DUPFD, 10);
    if (dup2(from, 0) < 0 || dup2(say, 1) < 0 || dup2(say, 2) < 0 || dup2(to, 3) < 0) _exit(127);
    for (int d = out ? 4 : 3; d < 1024; d++) close(d);
    (void)setpgid(0, 0);
    limit(RLIMIT_CPU, l.cpu), limit(RLIMIT_AS, l.memory), limit(RLIMIT_FSIZE, l.file);
    limit(RLIMIT_CORE, 0);
    if (out) limit(RLIMIT_NPROC, 1);  /* no fork; that of root is not limited */
    if (refuse && !refuse_system_calls()) _exit(127);
    if (out) execv(program[0], program);
    else execvp(program[0], program);
    _exit(127);
}

static double now(void)
{
    struct timespec t;
    (void)clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Reads what the child says until it is dead, or its time is over: then it is killed, with all
 * that it has started. Returns the status of waitpid; *late: it was killed here; *bytes: what it
 * said. */
static int watch(pid_t child, int from, double seconds, char *text, bool *late, long *bytes)
{
    double end = now() + seconds;
    int status = 0;
    bool open = true;
    *late = false, *bytes = 0;
    for (;;) {
        struct pollfd p = {from, POLLIN, 0};
        char buffer[65536];
        if (open && poll(&p, 1, 20) > 0) {
            ssize_t n = read(from, buffer, sizeof buffer);
            if (n > 0 && *bytes < shown) {
                size_t room = (size_t)(shown - *bytes);
                memcpy(text + *bytes, buffer, (size_t)n < room ? (size_t)n : room);
            }
            if (n > 0) *bytes += n;
            else open = false;
        } else if (waitpid(child, &status, WNOHANG) == child) {
            break;
        } else if (!open) {
            (void)poll(NULL, 0, 5);
        }
        if (!*late && now() > end) *late = true, (void)kill(-child, SIGKILL);
    }
    (void)kill(-child, SIGKILL);
    return status;
}

static void say_end(int status, bool late, long bytes)
{
    int by = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    if (late || by == SIGXCPU || by == SIGKILL) printf("stopped: it took more time than it may");
    else if (by == SIGSYS) printf("stopped: it tried to open a file, start a process, or the like");
    else if (by == SIGXFSZ) printf("stopped: it wrote more than it may");
    else if (by) printf("crashed: signal %d, %s", by, strsignal(by));
    else printf("it ended with exit(%d)", WEXITSTATUS(status));
    if (bytes) printf("; it printed %ld bytes, which nobody reads", bytes);
    printf("\n");
}

int main(int argc, char **argv)
{
    static char text[shown + 1];
    bool refuse = argc > 4 && strcmp(argv[1], "run") == 0, late;
    bool runs = refuse || (argc > 4 && strcmp(argv[1], "limit") == 0);
    int say[2];
    long bytes;
    if (argc == 2 && strcmp(argv[1], "can") == 0) return !refuse_system_calls();
    if (!runs && !(argc > 2 && strcmp(argv[1], "build") == 0)) return 2;
    if (pipe(say) != 0) return 2;
    limits l = runs ? run_limits : build_limits;
    pid_t child = fork();
    if (child < 0) return 2;
    if (child == 0 && runs) become(argv + 4, argv[2], argv[3], say[1], l, refuse);
    if (child == 0) become(argv + 2, "/dev/null", NULL, say[1], l, false);
    (void)setpgid(child, child);  /* whoever comes first */
    close(say[1]);
    int status = watch(child, say[0], l.seconds, text, &late, &bytes);
    if (runs) say_end(status, late, bytes);
    else printf("%s", text);
    return !runs && status != 0;
}
