#!/bin/sh
# For so many minutes what `make test` does for seconds: readers are fuzzed, structures and 27's plan meet
# random rays and scenes, means are drawn, faults strike, programs get random options. No round has the random
# numbers of another: tests are built with RANDOM_OFFSET (random.h), so what holds for their own seeds has to
# hold for others, too.
#   MINUTES=30 sh tests/soak.sh     make soak MINUTES=30     again: MINUTES=0 OFFSET=.. TEST=27_proof sh tests/soak.sh
# Ends with the test in hand when the time is up, after one at least. In a tree where `make` was done before.
: "${MINUTES:=10}" "${OFFSET:=$(date +%s)}" "${CC:=cc}" "${BUILD:=build}"
# All that draw random numbers, in another order each time.
tests=${TEST:-$(grep -lE 'random_|structure\.h|27_seen\.h' tests/*.c | sed 's#tests/\(.*\)\.c#\1#' |
    awk -v s="$OFFSET" 'BEGIN { srand(s) } { print rand() "\t" $0 }' | sort | cut -f 2)}
programs='03_sphere 07_mesh 10_grid 12_kdtree 14_bvh 19_whitted 21_distributed 26_path_tracer 27_effects'
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT
trap 'exit 130' INT TERM
case $BUILD in /*) ;; *) BUILD=$PWD/$BUILD ;; esac
export BUILD
end=$(($(date +%s) + 60 * MINUTES)) passed=0 failed=0
ok() { passed=$((passed + 1)); }
no() { failed=$((failed + 1)); tail -n 20 "$scratch/log"; echo "soak.sh: FAILED: OFFSET=$OFFSET: $*"; }
over() { [ "$(date +%s)" -ge "$end" ]; }

one_test() {
    # shellcheck disable=SC2086
    $CC -std=c11 -O1 -ffp-contract=off -fno-tree-slp-vectorize -w ${REAL:+-DREAL=$REAL} -DRANDOM_OFFSET="$OFFSET" \
        -o "$scratch/test" "tests/$1.c" -lm -lpthread && CHECK_DIVISOR=4 "$scratch/test" >"$scratch/log" 2>&1
}
# Two of its own numeric options, anywhere in their ranges up to 64. Done or refused, nothing else.
one_program() {
    options=$("$BUILD/$1" --help | sed -n 's/^  \(--[a-z-]*\) [NX] .*\[\([0-9.e-]*\) to \([0-9.e]*\)\].*/\1 \2 \3/p' |
        awk -v s="$OFFSET" 'BEGIN { srand(s) } { a[NR] = $0 } END { for (k = 0; k < 2 && NR; k++) {
            split(a[1 + int(rand() * NR)], w, " "); hi = w[3] < 64 ? w[3] : 64; x = w[2] + rand() * (hi - w[2])
            print w[1], x == int(x) || rand() < .8 ? int(x) : x } }')
    # shellcheck disable=SC2086
    (cd "$scratch" && timeout 120 "$BUILD/$1" --quick --size 24x18 $options --out x.png) >"$scratch/log" 2>&1
    status=$?
    [ $status -eq 124 ] && echo "soak.sh: $1 $(echo "$options" | tr '\n' ' '): two minutes were not enough"
    [ $status -eq 0 ] || [ $status -eq 2 ] || [ $status -eq 124 ]
}
while :; do
    for t in $tests; do
        if one_test "$t"; then ok; else no "$t"; fi
        over && break 2
        for p in $programs; do
            [ -x "$BUILD/$p" ] || continue
            if one_program "$p"; then ok; else no "$p $(echo "$options" | tr '\n' ' ')"; fi
            OFFSET=$((OFFSET + 1))
        done
        if SEED=$OFFSET FAULTS=3 sh tests/faults.sh >"$scratch/log" 2>&1; then ok; else no "faults.sh"; fi
    done
done
echo "soak.sh: $passed passed, $failed failed"
[ "$failed" -eq 0 ]
