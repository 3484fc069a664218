#!/bin/sh
# The rules of the tree: who may include whom, that each main.c compiles alone by its own line 2, and
# that the common module stays small. `sh tests/rules.sh graph` prints the include graph instead.
passed=0 failed=0
ok() { passed=$((passed + 1)); }
no() { failed=$((failed + 1)); echo "rules.sh: FAILED: $1"; }
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT

# includes DIR: "FILE TARGET" for each #include "..." below DIR, both relative to DIR
includes() {
    (cd "$1" && grep -rHoE '^[ 	]*#[ 	]*include[ 	]*"[^"]*"' common chapters 2>/dev/null) |
        sed 's/:.*"\(.*\)"$/ \1/' | while read -r file target; do
            echo "$file $(echo "${file%/*}/$target" | sed -e ':a' -e 's#[^/.][^/]*/\.\./##' -e 'ta' -e 's#/\./#/#g')"
        done
}

# violations DIR: a line for each include that breaks the rule
violations() {
    includes "$1" | while read -r file target; do
        from=$(echo "$file" | sed -n 's#^chapters/\([0-9][0-9]\)_.*#\1#p')
        to=$(echo "$target" | sed -n 's#^chapters/\([0-9][0-9]\)_.*#\1#p')
        case $target in
        */main.c) echo "$file includes a main.c: $target" ;;
        common/*) ;;
        chapters/[0-9][0-9]_*)
            if [ -z "$from" ]; then echo "$file: common/ includes a chapter: $target"
            elif [ "$to" -gt "$from" ]; then echo "$file includes a later chapter: $target"
            elif [ "$to" -eq "$from" ] && [ "${target%/*}" != "${file%/*}" ]; then
                echo "$file includes from another chapter of its number: $target"
            fi ;;
        *) echo "$file includes from outside: $target" ;;
        esac
    done
}

if [ "${1:-}" = graph ]; then
    includes . | sed -n 's#^chapters/\([^/]*\)/[^ ]* chapters/\([^/]*\)/.*#\1 \2#p' | sort -u |
        awk '$1 != $2 { n[$1] = n[$1] " " $2 } END { for (c in n) print c " <-" n[c] }' | sort
    exit 0
fi

broken=$(violations .)
if [ -z "$broken" ]; then ok; else no "$broken"; fi

# The rule sees what it is there to see.
mkdir -p "$scratch/tree/common" "$scratch/tree/chapters/01_a" "$scratch/tree/chapters/02_b"
echo '#include "../chapters/01_a/a.h"' > "$scratch/tree/common/x.h"
printf '#include "../02_b/b.h"\n#include "../../common/x.h"\n' > "$scratch/tree/chapters/01_a/a.h"
printf '# include "../01_a/main.c"\n#include "../01_a/a.h"\n#include "../../tests/check.h"\n' \
    > "$scratch/tree/chapters/02_b/b.h"
seen=$(violations "$scratch/tree" | wc -l)
if [ "$seen" -eq 4 ]; then ok; else no "4 broken includes were planted, $seen were found"; fi

# Each main.c compiles by its own line 2, in a directory that holds only what it includes, and runs.
# -O0 instead of its own -O2 saves a minute, and cli.sh runs the programs for good. Line 2 has flags of
# its own: where others are what is tested, not all is compiled again; CHECK_DIVISOR=10 takes every tenth.
count=0
for main in chapters/*/main.c; do
    name=$(basename "$(dirname "$main")")
    line=$(sed -n 2p "$main")
    case $line in
    "cc -std=c11 "*" -o $name $main "*) ok ;;
    *) no "$main: line 2 is not its compile command: $line"; continue ;;
    esac
    count=$((count + 1))
    if [ $((count % ${CHECK_DIVISOR:-1})) -ne 0 ] || [ "${REAL:-double}" = float ]; then continue; fi
    alone="$scratch/alone_$name"
    mkdir -p "$alone"
    for file in $(${CC:-cc} -std=c11 -MM "$main" | sed -e 's/^[^:]*://' -e 's/\\$//'); do
        mkdir -p "$alone/$(dirname "$file")" && cp "$file" "$alone/$file"
    done
    if (cd "$alone" && sh -c "$(echo "$line" | sed "s/^cc /${CC:-cc} /; s/ -O2 / -O0 /")" && "./$name" --help >/dev/null) 2>"$scratch/err"
    then ok; else no "$main does not compile and run alone: $(head -n 3 "$scratch/err")"; fi
done

lines=$(cat common/*.h | wc -l)
if [ "$lines" -le 1500 ]; then ok; else no "common/ has $lines lines, at most 1500 are wanted"; fi
lines=$(wc -l < common/vec3.h)
if [ "$lines" -lt 150 ]; then ok; else no "vec3.h has $lines lines, fewer than 150 are wanted"; fi
# Characters, not bytes; line 2 of a main.c is a command and may be longer.
long=$(LC_ALL=C awk '{ gsub(/[\200-\277]/, "") }
    length > 100 && !(FNR == 2 && FILENAME ~ /main\.c$/) { print FILENAME ":" FNR }' \
    common/*.h chapters/*/*.[hc] tests/*.[hc])
if [ -z "$long" ]; then ok; else no "lines longer than 100 columns: $long"; fi

echo "rules.sh: $passed passed, $failed failed"
[ "$failed" -eq 0 ]
