#!/bin/sh
# Runs the named tests (programs test_NAME of $TESTS, or of $BUILD, or scripts), as many at a time as there are
# cores, or $JOBS; shows what each prints, and adds up: the last line is "N passed, N failed". A test
# that dies without its own count is one failure.
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT
workers=
trap 'kill $workers 2>/dev/null; exit 130' INT TERM

# Prints the output of test $1, and leaves "PASSED FAILED" in a file of its own.
run_one() {
    case $1 in
    *.sh) sh "tests/$1" >"$scratch/$1.output" 2>&1; status=$? ;;
    *)    "${TESTS:-$BUILD}/test_$1" >"$scratch/$1.output" 2>&1; status=$? ;;
    esac
    line=$(tail -n 1 "$scratch/$1.output")
    p=$(printf '%s\n' "$line" | sed -n 's/.* \([0-9][0-9]*\) passed, [0-9][0-9]* failed$/\1/p')
    f=$(printf '%s\n' "$line" | sed -n 's/.* \([0-9][0-9]*\) failed$/\1/p')
    if [ -z "$p" ] || { [ "$status" -ne 0 ] && [ "$f" -eq 0 ]; }; then
        echo "$1: ended with status $status" >>"$scratch/$1.output"
        p=${p:-0} f=$((${f:-0} + 1))
    fi
    cat "$scratch/$1.output"
    echo "$p $f" >"$scratch/$1.sum"
}

# Takes the next test that nobody has taken: mkdir succeeds for one only.
worker() {
    for t in "$@"; do mkdir "$scratch/$t.taken" 2>/dev/null && run_one "$t"; done
}

cores=$(getconf _NPROCESSORS_ONLN 2>/dev/null) || cores=1
jobs=${JOBS:-$cores}
while [ "$jobs" -gt 1 ]; do worker "$@" & workers="$workers $!" jobs=$((jobs - 1)); done
worker "$@"
wait
passed=0 failed=0
for t in "$@"; do
    p=0 f=1
    read -r p f <"$scratch/$t.sum" || echo "$t: did not end"
    passed=$((passed + p)) failed=$((failed + f))
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
