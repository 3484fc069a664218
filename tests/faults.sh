#!/bin/sh
# What fails, fails well: an allocation, any one of them; a picture larger than memory; a file that may not
# grow, at any byte; a closed standard output; Ctrl-C and SIGTERM at any moment. Always: a message that names
# the program, exit 1 (after a signal 128 + its number), the old picture as it was or the new one whole, and no
# .part file left behind.
#   FAULTS=60 SEED=2 BUILD=build sh tests/faults.sh
# FAULTS of each kind a program (2, then of two programs only); SEED: which; ONLY: programs. Allocations: where
# there is LD_PRELOAD and glibc.
. tests/check.sh
: "${FAULTS:=2}" "${SEED:=1}"
if [ "$FAULTS" -le 2 ]; then programs='14_bvh 27_effects'
else programs='07_mesh 14_bvh 17_compare 26_path_tracer 27_effects'; fi
case ${BUILD:=build} in /*) ;; *) BUILD=$root/$BUILD ;; esac
cd "$scratch" || exit 1
name=faults.sh

# limit BYTES|- COMMAND..: with files of at most so many bytes, and Ctrl-C as a foreground job has it
cat >limit.c <<'C'
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>
int main(int c, char **v)
{
    if (c < 3) return 2;
    struct rlimit r = {(rlim_t)atol(v[1]), (rlim_t)atol(v[1])};
    if (strcmp(v[1], "-") && setrlimit(RLIMIT_FSIZE, &r)) return 2;
    signal(SIGINT, SIG_DFL), signal(SIGTERM, SIG_DFL);
    return execv(v[2], v + 2);
}
C
# The FAIL_AT-th allocation and no other one fails; without FAIL_AT they are counted into $COUNT.
cat >shim.c <<'C'
#include <errno.h>
#include <fcntl.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>
void *__libc_malloc(size_t), *__libc_calloc(size_t, size_t), *__libc_realloc(void *, size_t);
static atomic_long count;
static long at = -1;
__attribute__((constructor)) static void begin(void) { at = getenv("FAIL_AT") ? atol(getenv("FAIL_AT")) : 0; }
__attribute__((destructor)) static void end(void)
{
    char text[32];
    if (at != 0 || !getenv("COUNT")) return;
    int file = open(getenv("COUNT"), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    int n = snprintf(text, sizeof text, "%ld\n", atomic_load(&count));
    if (write(file, text, (size_t)n) != n) abort();
}
static int fails(void) { return at >= 0 && atomic_fetch_add(&count, 1) + 1 == at && (errno = ENOMEM, 1); }
void *malloc(size_t n) { return fails() ? NULL : __libc_malloc(n); }
void *calloc(size_t n, size_t m) { return fails() ? NULL : __libc_calloc(n, m); }
void *realloc(void *p, size_t n) { return fails() ? NULL : __libc_realloc(p, n); }
C
${CC:-cc} -o limit limit.c || no "limit.c does not compile"
shim=
# Not into a program that brings an allocator of its own, as sanitizers do.
if ${CC:-cc} -shared -fPIC -o shim.so shim.c 2>/dev/null && ! grep -q __asan_init "$BUILD/14_bvh" &&
    COUNT=$scratch/counted LD_PRELOAD=$scratch/shim.so "$BUILD/14_bvh" --help >/dev/null 2>&1 && [ -s counted ]
then shim=$scratch/shim.so; fi

# below MOST N: N numbers from 1 to MOST, of this program's and SEED's own
below() { awk -v m="$1" -v n="$2" -v s="$SEED$turn" 'BEGIN { srand(s); while (n--) print 1 + int(rand() * m) }'; }
# survives WHAT: the old picture, or a whole one, which it must be after success; nothing else
survives() {
    if cmp -s x.png whole.png || { [ $status -ne 0 ] && [ "$(cat x.png)" = old ]; }; then ok
    else no "$1: exit $status, and the picture is neither the old one nor whole"; fi
    if [ -z "$(find . -name '*.part')" ]; then ok; else no "$1: a .part file is left"; rm -f ./*.part; fi
}
says() {  # says WHAT TEXT: failed with exit 1 and one line of the program
    if [ $status -eq 1 ] && grep -q "^$name: .*$2" err; then ok
    else no "$1: exit $status: $(head -c 200 err)"; fi
}

turn=0
for name in ${ONLY:-$programs}; do
    turn=$((turn + 1))
    program=$BUILD/$name
    [ -x "$program" ] || { no "not built"; continue; }
    mkdir "$scratch/$name" && cd "$scratch/$name" || exit 1
    set -- "$program" --quick --size 16x12 --threads 2 --out x.png
    "$@" >table 2>err || no "does not run: $(cat err)"
    mv x.png whole.png

    if [ -n "$shim" ]; then
        COUNT=$PWD/counted LD_PRELOAD=$shim "$@" >/dev/null 2>&1
        n=$(cat counted)
        for at in $(seq 1 $((FAULTS / 2))) $(below "$n" $((FAULTS - FAULTS / 2))); do
            echo old >x.png
            FAIL_AT=$at LD_PRELOAD=$shim "$@" >/dev/null 2>err
            status=$?
            [ $status -eq 0 ] || says "allocation $at of $n" "memory"  # the C library may do without
            survives "allocation $at of $n"
        done
    fi

    # A picture that does not fit is not the fault of the model that was read before.
    if [ -n "$shim" ] && [ "$name" != 17_compare ]; then  # which draws no model into --out
        # shellcheck disable=SC3045  # not in POSIX, but every shell of Linux has it
        (ulimit -v 2000000 && "$program" "$root/chapters/07_mesh/scenes/teapot.obj" --size 16384x16384 \
            --threads 2 --out x.png) >/dev/null 2>err
        status=$?
        says "16384 x 16384 pixels in 2 GB" "\(image\|film\)_new: no memory"
    fi

    size=$(wc -c <whole.png)
    for bytes in 0 $(below $((size - 1)) $((FAULTS - 1))); do
        echo old >x.png
        text=$("$scratch/limit" "$bytes" "$@" 2>&1 >/dev/null)  # a pipe: it may grow
        status=$?
        echo "$text" >err
        says "$bytes bytes of $size" "x.png: cannot write: File too large"
        survives "$bytes bytes of $size"
    done

    # Nowhere to print: no picture may be printed into, either.
    for closed in out both; do
        echo old >x.png
        if [ $closed = out ]; then "$@" >&- 2>err; else "$@" >&- 2>&-; fi
        status=$?
        if [ $closed = both ]; then
            if [ $status -eq 1 ]; then ok; else no "stdout and stderr closed: exit $status"; fi
        else says "stdout closed" "standard output: cannot write"; fi
        survives "std$closed closed"
    done

    set -- "$program" --quick --size 600x400 --threads 2 --out x.png
    for ms in $(below 300 "$FAULTS"); do
        for signal in INT TERM; do
            echo old >x.png
            "$scratch/limit" - "$@" >/dev/null 2>err &
            pid=$!
            sleep "$(awk -v ms="$ms" 'BEGIN { print ms / 1000 }')"
            kill -$signal $pid 2>/dev/null
            wait $pid 2>/dev/null
            status=$?
            case $signal$status in
            INT0 | INT130 | TERM0 | TERM143) ok ;;
            *) no "$signal after $ms ms: exit $status: $(cat err)" ;;
            esac
            # Stopped while it draws: what there is of the picture, as a whole file.
            case $(head -c 3 x.png; tail -c 8 x.png | tr -d '\0') in
            old* | *IEND*) ok ;;
            *) no "$signal after $ms ms: half a picture" ;;
            esac
            if [ -z "$(find . -name '*.part')" ]; then ok; else no "$signal after $ms ms: a .part file"; fi
        done
    done
    cd "$scratch" || exit 1
done
# A million samples a pixel take seconds: it is left between two of them.
mkdir "$scratch/long" && cd "$scratch/long" || exit 1
for name in 21_distributed 24_direct_light 25_bounces 26_path_tracer 27_effects; do
    [ -x "$BUILD/$name" ] || { no "not built"; continue; }
    "$scratch/limit" - "$BUILD/$name" --samples 1048576 --size 640x480 --threads 2 --out x.png >/dev/null 2>err &
    pid=$!
    sleep 0.3
    kill -INT $pid
    for tenth in $(seq 100); do
        kill -0 $pid 2>/dev/null || break
        sleep 0.1
    done
    if [ "$tenth" -lt 100 ]; then ok; else no "10 s after Ctrl-C it runs"; kill -KILL $pid; fi
    wait $pid 2>/dev/null
    status=$?
    if [ $status -eq 130 ] && tail -c 8 x.png | grep -q IEND; then ok; else no "stopped: exit $status: $(cat err)"; fi
done
name=faults.sh
report
