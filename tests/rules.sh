#!/bin/sh
# The rules of the tree: who may include whom, that each main.c compiles alone by its own line 2, and
# that the common module stays small. `sh tests/rules.sh graph` prints the include graph instead.
. tests/check.sh

# includes DIR: "FILE TARGET" for each #include "..." below DIR, both relative to DIR; what dialects.h includes by
# EIGHT_FILE, too, for who defines that
includes() {
    (cd "$1" && grep -rH --include='*.h' '^#define EIGHT_FILE ' chapters 2>/dev/null) |
        sed 's#^\([^:]*\):.*"\.\./\.\./\(.*\)"$#\1 \2#'
    (cd "$1" && grep -rHoE --include='*.[hc]' '^[ 	]*#[ 	]*include[ 	]*"[^"]*"' common chapters 2>/dev/null) |
        sed -e 's#^\([^:]*/\)\([^:/]*\):.*"\(.*\)"$#\1\2 \1\3#' \
            -e ':a' -e 's#[^/. ][^/ ]*/\.\./##' -e 'ta' -e 's#/\./#/#g'
}

# violations DIR: a line for each include that breaks a rule:
#   common/       the C library and common/ itself; common/numbers/ and common/lab/ also common/, lab/ all three
#   concept       what lies in a chapter but not in its lab/: no lab/ at all, its own, another's or common/lab/,
#                 and no trials/. Free of this: main.c, and trials/, where chapters measure what others share
#   11 to 14      no concept of 10, as they cut space, or boxes, without a grid; but 11 its mailbox
#   lab/, main.c  its own chapter's lab/, no other's
#   everybody     chapters of lower numbers; no main.c
violations() {
    includes "$1" | awk '
        function chapter(path) { return path ~ /^chapters\/[0-9][0-9]_/ ? substr(path, 10, 2) : "" }
        function folder(path) { sub(/^chapters\//, "", path); sub(/\/.*/, "", path); return path }
        function room(path) { return path ~ /^common\/lab\// ? 3 : path ~ /^common\/numbers\// ? 2 : 1 }
        { from = chapter($1); to = chapter($2); wrong = ""
          lab = $2 ~ /^(chapters\/[^\/]*|common)\/lab\//
          judge = $1 ~ /\/(lab|trials)\// || $1 ~ /\/main\.c$/ }
        $2 ~ /\/main\.c$/ { wrong = "includes a main.c" }
        wrong == "" && $2 ~ /^common\// && from == "" && room($2) > room($1) {
            wrong = "is in common/ and includes a room behind it" }
        wrong == "" && $2 !~ /^common\// {
            if (to == "") wrong = "includes from outside"
            else if (from == "") wrong = "is in common/ and includes a chapter"
            else if (to > from) wrong = "includes a later chapter"
            else if (to == from && folder($1) != folder($2)) wrong = "includes from another chapter of its number"
            else if (lab && folder($1) != folder($2)) wrong = "includes the laboratory of another chapter"
        }
        wrong == "" && from != "" && !judge {
            if (lab) wrong = "is a concept and includes a laboratory"
            else if ($2 ~ /^chapters\/[^\/]*\/trials\//) wrong = "is a concept and includes trials"
            else if (from ~ /^1[1-4]$/ && to == "10" && !(from == "11" && $2 ~ /\/mailbox\.h$/))
                wrong = "builds on the grid"
        }
        wrong != "" { print $1 " " wrong ": " $2 }'
    # A macro could hide what is included. Two may: a reader's own file (make mine-NN), and that of the dialects (15).
    (cd "$1" && grep -rHE --include='*.[hc]' '^[ 	]*#[ 	]*include[ 	]*[A-Za-z_]' common chapters 2>/dev/null) |
        grep -vE '^chapters/[^:]*/lab/[a-z]*\.h:#include MINE$|^common/numbers/dialects\.h:#include EIGHT_FILE$'
}

if [ "${1:-}" = graph ]; then
    includes . | sed -n 's#^chapters/\([^/]*\)/[^ ]* chapters/\([^/]*\)/.*#\1 \2#p' | sort -u |
        awk '$1 != $2 { n[$1] = n[$1] " " $2 } END { for (c in n) print c " <-" n[c] }' | sort
    exit 0
fi

broken=$(violations .)
if [ -z "$broken" ]; then ok; else no "$broken"; fi

# The rule sees what it is there to see: who includes what, 16 times wrong and 10 times right.
plant() {  # plant FILE INCLUDED...
    mkdir -p "$scratch/tree/$(dirname "$1")"
    file=$1; shift
    printf '# include "%s"\n' "$@" >"$scratch/tree/$file"
}
plant common/x.h ../chapters/01_a/a.h lab/table.h
plant common/lab/table.h ../x.h
plant common/numbers/sum.h ../lab/table.h
plant chapters/01_a/a.h ../02_b/b.h ../../common/x.h
plant chapters/01_a/lab/l.h ../a.h ../../../common/lab/table.h
plant chapters/01_a/c.h lab/l.h ../../common/lab/table.h
plant chapters/01_b/a.h ../01_a/a.h
plant chapters/02_b/b.h ../01_a/main.c ../../tests/check.h
plant chapters/02_b/lab/l.h ../../01_a/lab/l.h ../b.h ../../01_a/trials/t.h
plant chapters/01_a/trials/t.h ../a.h ../../../common/lab/table.h
plant chapters/02_b/c.h ../01_a/trials/t.h
plant chapters/01_a/d.h trials/t.h
plant chapters/11_c/c.h ../10_d/d.h
plant chapters/11_c/lab/l.h ../../10_d/d.h
plant chapters/11_c/f.h ../10_d/mailbox.h
plant chapters/12_e/e.h ../10_d/mailbox.h
printf '#define EIGHT_FILE "../../chapters/11_c/lab/l.h"\n#include EIGHT_FILE\n' >"$scratch/tree/chapters/11_c/e.h"
seen=$(violations "$scratch/tree" | wc -l)
if [ "$seen" -eq 16 ]; then ok; else no "16 broken includes were planted, $seen were found"; fi

# reached DIR FILE: what FILE includes, and what that includes, and so on
reached() {
    includes "$1" | awk -v from="$2" '
        { into[$1] = into[$1] " " $2 }
        END { todo[n = 1] = from
              while (n > 0) {
                  k = split(into[todo[n--]], to, " ")
                  for (i = 1; i <= k; i++) if (!seen[to[i]]++) { print to[i]; todo[++n] = to[i] }
              } }'
}

# bvh_mesh.h keeps its promise: a program that has only triangles need not know the other shapes.
reached . chapters/14_bvh/bvh_mesh.h >"$scratch/reached"
if grep -q '^chapters/07_mesh/mesh\.h$' "$scratch/reached"; then ok; else no "bvh_mesh.h is not seen to reach mesh.h"; fi
shapes=$(grep -E '^chapters/(03_sphere/|07_mesh/(shape|cone|polygon|scene)\.h)' "$scratch/reached")
if [ -z "$shapes" ]; then ok; else no "bvh_mesh.h has only triangles and includes $shapes"; fi

# Each main.c names its compile command in line 2, the same for all. In a tree that holds only common/
# and chapters/ the first is compiled by it, and run. With WHOLE=1 (.ci/run) the compiler reads every one there;
# without, the Makefile's build has read them, if not each alone, and the includes above lie in those two folders.
mkdir "$scratch/alone" && cp -R common chapters "$scratch/alone"
flags='-std=c11 -O2 -ffp-contract=off -fno-tree-slp-vectorize'
for main in chapters/*/main.c; do
    name=$(basename "$(dirname "$main")")
    line=$(sed -n 2p "$main")
    if [ "$line" = "cc $flags -o $name $main -lm -lpthread" ]; then ok
    else no "$main: line 2 is not its compile command: $line"; continue; fi
    command=${CC:-cc}${line#cc}
    case $name in
    01_*) command="$command && ./$name --help" ;;
    *) [ -n "${WHOLE:-}" ] || continue; command="$command -fsyntax-only" ;;
    esac
    if (cd "$scratch/alone" && sh -c "$command" >/dev/null) 2>"$scratch/err"
    then ok; else no "$main does not compile alone: $(head -n 3 "$scratch/err")"; fi
done
name=

# The Makefile builds many programs as one, where none notices what it forgot to include, and without -Wshadow; and in
# float it leaves two warnings out, for first.h (see there). Here each file is read alone, with all warnings.
if [ "${REAL:-double}" = float ]; then
    for c in chapters/*/main.c tests/*.c; do
        ${CC:-cc} -std=c11 -fsyntax-only -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wdouble-promotion \
            -Wno-float-conversion -Wno-implicit-float-conversion -Wno-enum-float-conversion -DREAL=float -DBUILD_FLAGS='""' "$c" 2>&1  # x = 0.1 may round
    done | grep -E 'warning:|error:' | grep -v '/first\.h:.*warning:' >"$scratch/widened"
    if [ -s "$scratch/widened" ]; then no "float: $(head -n 5 "$scratch/widened")"; else ok; fi
fi

# The path of a clone may hold a blank, so in recipes it stands in quotes; a BUILD that cannot be is refused.
# shellcheck disable=SC2016  # $(..) is of make
bare=$(grep -n '^	.*[^"]$(\(CURDIR\|abspath\)' Makefile)
if [ -z "$bare" ]; then ok; else no "Makefile: a path without quotes: $bare"; fi
# `make` alone builds the programs: it once made the first target of a template instead, and said nothing.
make -n all BUILD=build/none >"$scratch/all" 2>&1; make -n BUILD=build/none >"$scratch/default" 2>&1
if grep -q build/none/27_effects "$scratch/all" && cmp -s "$scratch/all" "$scratch/default"
then ok; else no "make alone is not make all: $(head -n 2 "$scratch/default")"; fi
# soak.sh builds its tests itself, with other random numbers: `make soak MINUTES=` once built all 105 before, for nothing.
make -n soak MINUTES=1 BUILD=build/none >"$scratch/soak" 2>&1
if grep -q 'tests/soak\.sh' "$scratch/soak" && ! grep -q build/none/test_ "$scratch/soak"
then ok; else no "make soak MINUTES=1 builds tests that it does not run, or runs none"; fi
# A make that another calls takes its turns from the -j of that one. Of a -j of its own it warns, as did `make -j4 run`.
(unset MAKEFLAGS MAKELEVEL; for j in '' -j3; do make $j -n run full csv hard-cases precision BUILD=build/none; done) \
    2>&1 | grep warning: >"$scratch/warned"
if [ -s "$scratch/warned" ]; then no "make -j3 run: $(head -n 1 "$scratch/warned")"; else ok; fi
for wrong in BUILD= BUILD=/ 'BUILD=a b' REAL=long; do
    if make -n "$wrong" help >/dev/null 2>&1; then no "make takes $wrong"; else ok; fi
done
# What was only half written, by a compiler or a cp that was ended in the midst, is made again by the next `make`.
mkdir "$scratch/bin"
cat >"$scratch/bin/half" <<'END'
while [ $# -gt 1 ]; do [ "$1" != -o ] || out=$2; shift; done  # cp: the last of all
echo half >"${out:=$1}"; [ ! -e "$0.now" ] || exit 1; echo whole >>"$out"
END
printf '#!/bin/sh\n. "%s/bin/half"\n' "$scratch" | tee "$scratch/bin/cp" >"$scratch/bin/cc"
chmod +x "$scratch/bin/cp" "$scratch/bin/cc"
for tool in cc cp; do
    touch "$scratch/bin/$tool.now"
    for status in 1 0; do
        (unset MAKEFLAGS MAKELEVEL; ASKED=$scratch/bin/cc PATH=$scratch/bin:$PATH \
            make CC="$scratch/bin/cc" BUILD="$scratch/half" all firsts) >"$scratch/said" 2>&1 && got=0 || got=1
        if [ "$got" -eq $status ]; then ok; else no "half a $tool: make ended with $got: $(tail -n 3 "$scratch/said")"; fi
        rm -f "$scratch/bin/$tool.now"
    done
    cut=$(grep -slx half "$scratch"/half/* | xargs grep -Lx whole)
    if [ -z "$cut" ]; then ok; else no "half a $tool was taken for whole: $cut"; fi
    rm -r "$scratch/half"
done

# Each room of common/ has its cap: what is shared stays small.
cap() {  # cap FOLDER LINES
    lines=$(cat "$1"/*.h | wc -l)
    if [ "$lines" -le "$2" ]; then ok; else no "$1/ has $lines lines, at most $2 are wanted"; fi
}
cap common 1500
cap common/numbers 1170  # 1000, and eight.h with dialects.h, which were concepts of 15: 201
cap common/lab 1275  # 1200, and t_test.h, which was a concept of 20
# The tree of 15, without first.h; eight.h and dialects.h count above: 700, and where patches and rows hang on. Rays side
# by side, up to 1000 in all, the path tracer's speed asked for: in the Cornell box they take little more than half the time.
lines=$(cd chapters/15_wide_bvh && cat bvh8.h build.h ray8.h tree8.h walk.h | wc -l)
if [ "$lines" -le 713 ]; then ok; else no "the tree of 15_wide_bvh has $lines lines, at most 713 are wanted"; fi
lines=$(cd chapters/15_wide_bvh && cat [!f]*.h | wc -l)
if [ "$lines" -le 1000 ]; then ok; else no "the concept of 15_wide_bvh has $lines lines, at most 1000 are wanted"; fi
# In front, where the lesson is: no short book, no laboratory, no readers of files, no shared scenes.
lines=$(find chapters -name '*.h' ! -name first.h ! -path '*/lab/*' ! -path '*/trials/*' ! -path '*/files/*' \
    ! -path '*/scenes/*' -exec cat {} + | wc -l)
if [ "$lines" -le 20000 ]; then ok; else no "concepts have $lines lines, at most 20000 are wanted"; fi
lines=$(wc -l < common/vec3.h)
if [ "$lines" -lt 150 ]; then ok; else no "vec3.h has $lines lines, fewer than 150 are wanted"; fi
for main in chapters/*/main.c; do  # options, then calls
    lines=$(wc -l < "$main")
    if [ "$lines" -le 80 ]; then ok; else no "$main has $lines lines, at most 80 are wanted"; fi
done
# Characters, not bytes; line 2 of a main.c or first.c is a command and may be longer.
long=$(LC_ALL=C find common chapters tests -name '*.[hc]' -exec awk '{ gsub(/[\200-\277]/, "") }
    length > 100 && !(FNR == 2 && FILENAME ~ /(main|first)\.c$/) { print FILENAME ":" FNR }' {} +)
if [ -z "$long" ]; then ok; else no "lines longer than 100 columns: $long"; fi

# In which order the arguments of a call are computed, C leaves to the compiler: where two of them draw from a
# stream, gcc and clang give a function other numbers. (Braces, such as vec's, both fill from left to right.)
two_draws() {  # two_draws FILES..: a line for each such call
    awk '
        collect { if (match($0, /[a-z_0-9]+\([^()]*random_stream \*/)) {
                      name = substr($0, RSTART, RLENGTH); sub(/\(.*/, "", name); draws[name] = 1 }
                  next }
        FNR == 1 { depth = 0 }
        { gsub(/"([^"\\]|\\.)*"/, ""); sub(/\/\*.*/, "")
          while (match($0, /[A-Za-z_0-9]*[(]|[][){},;]/)) {
              name = substr($0, RSTART, RLENGTH - 1); c = substr($0, RSTART + RLENGTH - 1, 1)
              $0 = substr($0, RSTART + RLENGTH)
              if (c ~ /[[({]/) {
                  n[++depth] = now[depth] = 0; drew[depth] = name in draws
                  call[depth] = name != "" && name !~ /^(if|for|while|switch|vec)$/
              } else if (c == ",") { n[depth] += now[depth]; now[depth] = 0
              } else if (c == ";") now[depth] = 0
              else {
                  n[depth] += now[depth]
                  if (call[depth] && n[depth] > 1) print FILENAME ":" FNR
                  if (drew[depth] || n[depth]) now[depth - 1] = 1
                  depth--
              } } }' collect=1 "$@" collect=0 "$@"
}
printf 'real next(random_stream *s);\nreal x = f(next(s), 2, g(-next(s)));\n' >"$scratch/two.c"
if [ "$(two_draws "$scratch/two.c")" = "$scratch/two.c:2" ]; then ok; else no "a planted call is not seen"; fi
# shellcheck disable=SC2046  # no name holds a blank
twice=$(two_draws $(find common chapters tests -name '*.[ch]'))
if [ -z "$twice" ]; then ok; else no "two arguments of a call draw random numbers: $twice"; fi

report
