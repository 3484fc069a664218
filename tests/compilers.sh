#!/bin/sh
# Does a picture depend on who compiled the program? Each main.c and first.c, built by gcc and clang (those that are
# there) without optimisation and with much of it, for any machine and for this one, draws its picture; it is compared
# with that of gcc -O2 or of the first compiler there is, byte by byte. Nothing is contracted to fma, as everywhere.
# Allowed: one byte in 1000 may differ by more than 2 of 255: a last bit decides at edges, and where chance
# throws a coin. Prints a line for each picture that differs at all.
#   sh tests/compilers.sh          make compilers         FILES="chapters/03_sphere/main.c ..": those
: "${FILES:=}" "${JOBS:=$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 1)}"
[ -n "$FILES" ] || FILES=$(echo chapters/*/first.c chapters/*/main.c)
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT
trap 'exit 130' INT TERM
compilers=$(for c in gcc clang cc; do command -v "$c" >/dev/null 2>&1 && echo "$c"; done | head -n 2)

draw() {  # draw PROGRAM-SOURCE COMPILER FLAGS: prints its bytes as numbers, a line each
    out=$(mktemp -d -p "$scratch")
    # shellcheck disable=SC2086
    $2 -std=c11 $3 -ffp-contract=off ${slp:-} -w -o "$out/run" "$1" -lm -lpthread || return 1
    case $1 in */first.c) set -- x.ppm ;; *) set -- --quick --out x.ppm ;; esac
    (cd "$out" && ./run "$@" >log 2>&1) || return 1
    od -An -v -tu1 -w1 "$out/x.ppm" && rm -r "$out"
}
one() {  # one PROGRAM-SOURCE: a line for each way to compile it
    base=$(mktemp -p "$scratch")
    for how in '-O2' '-O0' '-O3' '-O3 -march=native'; do
        for c in $compilers; do
            slp=; [ "$c" = clang ] || slp=-fno-tree-slp-vectorize
            now=$(mktemp -p "$scratch")
            draw "$1" "$c" "$how" >"$now" || { echo "$1: $c $how: FAILED: does not compile or draw"; continue; }
            [ -s "$base" ] || { mv "$now" "$base"; continue; }
            paste "$base" "$now" | awk -v what="$1: $c $how" '
                { d = $1 - $2; if (d < 0) d = -d; differ += d > 0; far += d > 2; if (d > most) most = d }
                END { print what ": " differ + 0 " of " NR " bytes differ, " far + 0 " by more than 2, at most by " \
                          most + 0 (far * 1000 > NR || NF < 2 ? ": FAILED" : "") }'
            rm -f "$now"
        done
    done
}
if [ "${1:-}" = one ]; then one "$2"; exit; fi
# shellcheck disable=SC2086
printf '%s\n' $FILES | xargs -P "$JOBS" -I{} sh "$0" one {} >"$scratch/lines"
grep -v ': 0 of ' "$scratch/lines" | sort
failed=$(grep -c FAILED "$scratch/lines")
echo "compilers.sh: $(($(wc -l <"$scratch/lines") - failed)) passed, $failed failed"
[ "$failed" -eq 0 ]
