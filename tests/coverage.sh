#!/bin/sh
# Which lines and branches of the concept headers do the tests pass? gcc --coverage and gcov (gcc's own).
#   TESTS="03_sphere 09_aabb" sh tests/coverage.sh        make coverage [TESTS=..]; without TESTS: all of them
# A table of the headers with what nobody passed, least first, and the sum. Nothing is inlined by force:
# gcov would count the branches of each copy. A function that no test of TESTS calls is not seen at all. Tests
# run with a CHECK_DIVISOR-th (20) of their counts; those that run programs find them in BUILD, not counted.
: "${TESTS:=}" "${CHECK_DIVISOR:=20}" "${CC:=gcc}"
export CHECK_DIVISOR
root=$PWD
out=$root/build/coverage
mkdir -p "$out" || exit 1
[ -n "$TESTS" ] || TESTS=$(find tests -maxdepth 1 -name '*.c' | sed -e 's#.*/##' -e 's/\.c$//' | sort)
for t in $TESTS; do
    mkdir -p "$out/$t" || exit 1
    rm -f "$out/$t"/*
    $CC -std=c11 -O0 --coverage -ffp-contract=off -Dflatten= -Dalways_inline=unused -w -o "$out/$t/test" "$PWD/tests/$t.c" -lm -lpthread || exit 1
    "$out/$t/test" >"$out/$t/log" 2>&1 || echo "coverage.sh: $t failed: $(tail -n 1 "$out/$t/log")" >&2
    (cd "$out/$t" && gcov -p -b -c ./*.gcda >/dev/null 2>&1)
done
# FILE LINE PASSED, and for branches FILE LINE.NUMBER PASSED, of concept headers; the best of all tests
find "$out" -name '*.h.gcov' -exec awk -F: '
    FNR == 1 { file = ""; taken = 0 }
    / 0:Source:/ { file = $4; sub(/.*\/chapters\//, "chapters/", file); sub(/.*\/common\//, "common/", file)
                   if (file ~ /\/(lab|trials|scenes|tests)\// || file ~ /first\.h$/ || file ~ /^\/|^\.\./) file = "" }
    file == "" { next }
    /^branch/ { split($0, w, " "); print file, line "." w[2], (w[3] == "taken" && w[4] > 0); next }
    /^ *[0-9#=-]+\*?: *[0-9]+:/ { line = $2 + 0; n = $1; gsub(/[ *]/, "", n)
                                if (n != "-") print file, line, (n ~ /^[0-9]/ && n > 0) }' {} + |
awk '{ key = $1 " " $2; if (!(key in best) || $3 > best[key]) best[key] = $3 }
     END { for (key in best) print key, best[key] }' | sort -k1,1 -k2,2n |
awk '{ branch = $2 ~ /\./; n[$1, branch]++; hit[$1, branch] += $3; all[branch]++; got[branch] += $3; name[$1] = 1
       if (!branch && !$3) left[$1] = left[$1] " " $2 }
     END { for (f in name)
               printf "%5.1f %% of lines, %5.1f %% of branches  %s%s\n", 100 * hit[f, 0] / n[f, 0],
                      n[f, 1] ? 100 * hit[f, 1] / n[f, 1] : 100, f, left[f] == "" ? "" : ":" left[f] | "sort -n"
           close("sort -n")
           printf "%.1f %% of %d lines, %.1f %% of %d branches\n", 100 * got[0] / all[0], all[0],
                  100 * got[1] / all[1], all[1] }'
