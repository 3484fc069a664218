#!/bin/sh
# The short book, first.h and first.c of each chapter: what they may include, how long they may be, that
# each compiles by its own line 2 beside nothing but what it includes, and what it does when it runs.
. tests/check.sh
at_most() { if [ "$1" -le "$2" ]; then ok; else no "$3 has $1 lines, at most $2 are wanted"; fi; }
BUILD=${TESTS:-${BUILD:-build}}
case $BUILD in /*) ;; *) BUILD=$root/$BUILD ;; esac

# strangers DIR: each #include of a first.h or first.c below DIR that is neither the C library, nor one
# of vec3.h, image.h, random.h, nor the first.h of a chapter of the same or a lower number
strangers() {
    (cd "$1" && grep -HE '^[ 	]*#[ 	]*include' chapters/*/first.[hc]) | awk -F: '
        { file = $1; split(file, part, "/"); own = substr(part[2], 1, 2); line = $0
          sub(/^[^:]*:[ \t]*#[ \t]*include[ \t]*/, "", line); sub(/[ \t]*(\/\*.*)?$/, "", line) }
        line ~ /^<(assert|ctype|errno|float|inttypes|limits|math|stdbool|stddef|stdint|stdio|stdlib|string|tgmath|time)\.h>$/ { next }
        line ~ /^"\.\.\/\.\.\/common\/(vec3|image|random)\.h"$/ { next }
        line == "\"first.h\"" { next }
        line ~ /^"\.\.\/[0-9][0-9]_[a-z_]*\/first\.h"$/ && substr(line, 5, 2) <= own { next }
        { print file " includes " line }'
}
found=$(strangers .)
if [ -z "$found" ]; then ok; else no "$found"; fi

# The rule sees what it is there to see.
mkdir -p "$scratch/tree/chapters/01_a" "$scratch/tree/chapters/02_b"
printf '#include "../02_b/first.h"\n#include "../../common/table.h"\n# include <pthread.h>\n#include "a.h"\n' \
    > "$scratch/tree/chapters/01_a/first.h"
printf '#include "../01_a/a.h"\n#include "../../common/vec3.h"\n#include <math.h>\n#include "../01_a/first.h"\n' \
    > "$scratch/tree/chapters/02_b/first.c"
seen=$(strangers "$scratch/tree" | wc -l)
if [ "$seen" -eq 5 ]; then ok; else no "5 broken includes were planted, $seen were found"; fi

# Lines: of each file, of all, and of the spine.
for f in chapters/*/first.h; do at_most "$(wc -l <"$f")" 150 "$f"; done
for f in chapters/*/first.c; do at_most "$(wc -l <"$f")" 80 "$f"; done
at_most "$(cat chapters/*/first.[hc] | wc -l)" 4000 "the short book"
spine=
for n in 01 02 03 18 19 04 07 09 14 20 22 23 24 25 26; do
    spine="$spine $(echo chapters/"$n"_*/first.h) $(echo chapters/"$n"_*/first.c)"
done
# shellcheck disable=SC2086
at_most "$(cat $spine | wc -l)" 2200 "the spine"
# The spine reads without the side roads.
# shellcheck disable=SC2086
side=$(grep -nE '^#include "\.\./(10|11|12|13|16|17|21|27)_' $spine)
if [ -z "$side" ]; then ok; else no "the spine includes a side road: $side"; fi
side=$(grep -nE '^#include "\.\./(04|07|09|14)_' chapters/1[89]_*/first.[hc])
if [ -z "$side" ]; then ok; else no "18 and 19 come before meshes in the spine: $side"; fi

# Written as on a board: no attributes, no macros but the guard, no casts to real.
board=$(grep -nE '__attribute__|\(real\)|^#[ 	]*define' chapters/*/first.[hc] | grep -vE '#define FIRST_[A-Z_]*_H$')
if [ -z "$board" ]; then ok; else no "attributes, macros or casts: $board"; fi

# Each formula that the code cites is on the chapter's page; the top of a first.h has three lines.
for f in chapters/*/first.h; do
    dir=$(dirname "$f") lost=
    for k in $(grep -oE '\([1-9][0-9]?\.[0-9]+\)' "$f" | tr -d '()' | sort -u); do
        page=$(echo chapters/"$(printf '%02d' "${k%%.*}")"_*/README.md)
        grep -qF "($k)" "$page" || lost="$lost ($k)"
    done
    if [ -z "$lost" ]; then ok; else no "$f cites what its page lacks:$lost"; fi
    if [ "$(sed -n '1,/\*\//p' "$f" | wc -l)" -eq 3 ]; then ok; else no "$f: its top has not three lines"; fi
    if [ -f "$dir/first.c" ]; then ok; else no "$dir has a first.h, and no first.c"; fi
done

# Each program, in a folder that holds nothing but it: every seventh one draws (the committed picture, byte for byte;
# none is committed in float), with a part of the counts one of eight. With WHOLE=1 (.ci/run) each is compiled by its line 2
# beside only what it includes, and draws. Without, the Makefile has compiled it. Other flags: `make compilers`.
flags='-std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize'
every=7
[ "${CHECK_DIVISOR:-1}" -gt 1 ] && every=8
[ -n "${WHOLE:-}" ] && every=1
[ $every -eq 1 ] || echo "first.sh: one program of $every draws; all of them: WHOLE=1"
count=0
for main in chapters/*/first.c; do
    name=$(basename "$(dirname "$main")")_first
    alone=$scratch/$name
    mkdir "$alone"
    line=$(sed -n 2p "$main")
    if [ "$line" = "cc $flags -o $name $main -lm" ]; then ok
    else no "$main: line 2 is not its compile command: $line"; continue; fi
    if [ -z "${WHOLE:-}" ]; then
        cp "$BUILD/$name" "$alone"
    else
        for f in $(${CC:-cc} -std=c11 -MM "$main" | sed -e 's/^[^:]*://' -e 's/\\$//'); do
            f=$(echo "$f" | sed -e ':a' -e 's#[^/. ][^/ ]*/\.\./##' -e 'ta')
            mkdir -p "$alone/$(dirname "$f")" && cp "$f" "$alone/$f"
        done
        if (cd "$alone" && sh -c "${CC:-cc}${line#cc} -DREAL=${REAL:-double}") 2>"$scratch/err"
        then ok; else no "$main does not compile alone: $(head -n 3 "$scratch/err")"; continue; fi
    fi
    # Misuse: one line that names the program, exit 2, and nothing written.
    for bad in 'a.png b.png' '--help' 'picture.gif'; do
        # shellcheck disable=SC2086
        (cd "$alone" && "./$name" $bad >out 2>err)
        status=$?
        if [ $status -eq 2 ] && [ "$(grep -c "^$name: " "$alone/err")" -eq 1 ] && [ ! -s "$alone/out" ]; then ok
        else no "$name $bad ended with $status: $(head -n 2 "$alone/err")"; fi
    done
    width=$(od -An -tu1 -j16 -N4 "images/$name.png" | awk '{ print (($1 * 256 + $2) * 256 + $3) * 256 + $4 }')
    if [ "$width" -ge 640 ]; then ok; else no "images/$name.png is ${width:-not there or 0} wide, 640 at least are wanted"; fi
    count=$((count + 1))
    [ $((count % every)) -eq $((3 % every)) ] || continue
    if (cd "$alone" && "./$name" >out 2>err); then ok; else no "$name: $(head -n 3 "$alone/err")"; continue; fi
    folder=images; [ "${REAL:-double}" = float ] && folder=build
    if [ "$(tail -n 1 "$alone/out")" = "-> $folder/$name.png" ]; then ok; else no "$name: does not say where its picture is"; fi
    # The committed picture; or, where the C library rounds otherwise, that of this build. In float none is
    # committed, and this build's program has drawn already.
    if [ "$folder" = build ] && [ -z "${WHOLE:-}" ]; then :
    elif cmp -s "$alone/$folder/$name.png" "images/$name.png" || [ "${CHECK_DIVISOR:-1}" -gt 1 ]; then ok
    else
        (cd "$alone" && "$BUILD/$name" again.png >out 2>err)
        if cmp -s "$alone/$folder/$name.png" "$alone/again.png"; then ok; else no "$name: two builds, two pictures"; fi
    fi
done

report
