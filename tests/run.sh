#!/bin/sh
# Runs the named tests (programs of $BUILD/test_NAME, or scripts), shows what failed, and adds up:
# the last line is "N passed, N failed". A test that dies without its own count is one failure.
passed=0 failed=0
for t in "$@"; do
    case $t in
    *.sh) output=$(sh "tests/$t" 2>&1); status=$? ;;
    *)    output=$("$BUILD/test_$t" 2>&1); status=$? ;;
    esac
    line=$(printf '%s\n' "$output" | tail -n 1)
    p=$(printf '%s\n' "$line" | sed -n 's/.* \([0-9][0-9]*\) passed, [0-9][0-9]* failed$/\1/p')
    f=$(printf '%s\n' "$line" | sed -n 's/.* \([0-9][0-9]*\) failed$/\1/p')
    printf '%s\n' "$output"
    if [ -z "$p" ] || { [ "$status" -ne 0 ] && [ "$f" -eq 0 ]; }; then
        echo "$t: ended with status $status"
        p=${p:-0} f=$((${f:-0} + 1))
    fi
    passed=$((passed + p)) failed=$((failed + f))
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
