#!/bin/sh
# Homework (tests/assignments/): of each assignment the untouched folder gets 0 on every exercise, our own solution
# all points, and three half-right ones something in between, in their order; and submissions that do harm get
# their score and a message. No part of `make test`: it compiles some hundred programs.   ONLY=04: one assignment
#
# Keeps the tables of chapters/teaching.md, too: `sh tests/assignments.sh tables` prints them.
set -u
. tests/check.sh
is() { if [ "$1" = "$2" ]; then ok; else no "$3: $1, expected $2"; fi; }
export BUILD="${BUILD:-build}"
here=tests/assignments
tab=$(printf '\t')
seed=${SEED:-1}

# of FOLDER: grades it; sets table, each ("points of exercise 1, 2, ..") and points
of() {
    table=$(SEED=$seed RESULTS=$scratch/results.json sh $here/grade.sh "$1" 2>&1) || no "grading $1: $table"
    each=$(echo "$table" | awk '/^[0-9]_/ { split($4, p, "/"); printf "%s%s", n++ ? " " : "", p[1] }')
    points=$(echo "$table" | awk '/^sum/ { split($2, p, "/"); print p[1] }')
}

# summary NN: its row in the table of chapters/teaching.md
summary() {
    title=$(sed -n '1s/^# [0-9]* //p' chapters/"$1"_*/README.md)
    awk -F"$tab" -v title="$1 $title" -v list="$cut/list" '
        BEGIN { while ((getline line <list) > 0) { split(line, f, FS); hours += f[3]; own[f[1]] = f[4] == "own"
                    name = f[2]; sub(/^[0-9]_/, "", name); sub(/\.h$/, "", name)
                    if (f[4] == "own") new = new (new == "" ? "" : ", ") name
                    else old = old (old == "" ? "" : ", ") name } }
        { sum += $3; if (!own[$1]) book += $3; if ($5) public += $3; if ($4) hard += $3 }
        END { printf "| %s | %s | %s | %g | %d | %d | %d | %d |\n", title, old, new, hours, book, sum - book, public, hard }' \
        "$scratch/checks"
}
: >"$scratch/summary"
: >"$scratch/mistakes"

for NN in ${ONLY:-$(cd $here && echo [0-9][0-9])}; do
    stub=$scratch/stub_$NN
    sh $here/write.sh "$NN" "$stub" >/dev/null || no "$NN: no folder is written"
    if [ -s "$stub.tar.gz" ] && tar -tzf "$stub.tar.gz" | grep -q "stub_$NN/README.md"; then ok; else no "$NN: tar.gz"; fi
    # The handout has its parts; nothing that is hidden, and no solution, is in the student's folder.
    for part in '## Exercises' '## Prediction' Rubric '## The idea' '## The formulas'; do
        if grep -q "$part" "$stub/README.md"; then ok; else no "$NN: the handout has no $part"; fi
    done
    missing=$(grep -o '](images/[^)]*' "$stub/README.md" | sed 's/](//' | while read -r f; do [ -f "$stub/$f" ] || echo "$f"; done)
    is "$missing" '' "$NN: pictures that the handout lacks"
    # Each exercise that is not in the book begins with its contract.
    bare=$(grep '| own |' $here/"$NN"/exercises | tr -d ' ' | cut -d'|' -f1-2 | tr '|' _ | while read -r f; do
        [ "$(head -c 2 "$stub/$f.h")" = '/*' ] || echo "$f.h"; done)
    is "$bare" '' "$NN: files without a contract"
    if find "$stub" | grep -E 'hidden|reference|halves'; then no "$NN: that has no place in the folder"; else ok; fi
    export ASSIGNMENT="$NN"
    of "$stub"
    cut=$BUILD/assignments/$NN
    "$cut/judge" list >"$scratch/checks"
    summary "$NN" >>"$scratch/summary"
    is "$(echo "$each" | tr -d ' 0')" '' "$NN: the untouched folder, seed $seed"
    # Its public tests run, fail, and say what is due.
    said=$(cd "$stub" && make 2>&1)
    is "$(echo "$said" | grep -c '^FAILED')" "$("$cut/judge" list | awk -F"$tab" '$5 == 1' | wc -l | tr -d ' ')" \
        "$NN: public tests that the stubs fail"
    if echo "$said" | grep -q warning; then no "$NN: $said"; else ok; fi

    of "$cut/reference"
    all=$points
    is "$(echo "$table" | awk '/^sum/ { print $2 }')" "85/85" "$NN: our own solution, seed $seed: $table"
    # What the book prints earns at most 30.
    book=$(awk -F"$tab" '$4 != "own" { print $1 }' "$cut/list")
    sum=$("$cut/judge" list | awk -F"$tab" -v b=" $(echo "$book" | tr '\n' ' ')" 'index(b, " " $1 " ") { s += $3 } END { print s }')
    if [ "$sum" -le 30 ]; then ok; else no "$NN: $sum points are in the book"; fi
    # And our own solution passes in the student's folder, compiled as students do.
    mkdir "$scratch/own_$NN" && cp -R "$stub/." "$scratch/own_$NN" && cp "$cut/reference"/*.h "$scratch/own_$NN/"
    said=$(cd "$scratch/own_$NN" && make 2>&1)
    if echo "$said" | grep -E 'FAILED|warning|alone'; then no "$NN: our own solution in the student's folder: $said"; else ok; fi

    before=0
    for half in 1 2 3; do
        dir=$scratch/half_${NN}_$half
        mkdir "$dir" && cp "$cut/stubs"/* "$dir/"
        grep "^$half " "$here/$NN/halves" | while IFS='|' read -r _ exercise _ edit; do
            file=$(basename "$cut/reference/$(echo "$exercise" | tr -d ' ')"_*.h)
            case $edit in
            '' | ' ') cp "$cut/reference/$file" "$dir/" ;;
            *) sed -e "${edit# }" "$cut/reference/$file" >"$dir/$file"
               ! cmp -s "$cut/reference/$file" "$dir/$file" || echo "$NN: half $half: sed changes nothing in $file" ;;
            esac
        done >"$scratch/idle"
        if [ -s "$scratch/idle" ]; then no "$(cat "$scratch/idle")"; else ok; fi
        of "$dir"
        if echo "$table" | grep -q 'does not compile'; then no "$NN: half $half: $table"; else ok; fi
        # Each mistake, and what it leaves of the exercise's points: not all of them, or it is none.
        grep "^$half " "$here/$NN/halves" | while IFS='|' read -r _ exercise words edit; do
            [ -n "${edit# }" ] || continue
            exercise=$(echo "$exercise" | tr -d ' ')
            row=$(echo "$table" | awk -v e="$exercise" '$1 ~ "^" e "_" { f = $1; sub(/^[0-9]_/, "", f); sub(/\.h$/, "", f)
                print f " | " $4 }')
            echo "| $NN | ${row%% |*} |$words| ${row##*| } |"
            echo "$row" | awk '{ split($3, p, "/"); exit p[1] < p[2] }' && echo "$NN, $words: all points" >>"$scratch/unseen"
        done >>"$scratch/mistakes"
        if [ "${points:-0}" -gt "$before" ] && [ "$points" -lt "$all" ]; then ok
        else no "$NN: half $half has ${points:-none} ($each), after $before and before $all; seed $seed"; fi
        [ -z "${V:-}" ] || echo "$NN: half $half: $each, together $points"
        before=${points:-0}
    done
    unset ASSIGNMENT
done

if [ "${1:-}" = tables ]; then
    echo "| assignment | from the book | new | hours | points: from the book | new | in public tests | for hard cases |"
    echo "|---|---|---|---|---|---|---|---|"
    cat "$scratch/summary"; echo
    echo "| | exercise | what is wrong | points |"; echo "|---|---|---|---|"; cat "$scratch/mistakes"
    exit
fi
unseen=$(cat "$scratch/unseen" 2>/dev/null)
is "$unseen" '' "mistakes that no check sees"
# What teaching.md says of these assignments is what was measured; it names some of the mistakes.
for NN in ${ONLY:-$(cd $here && echo [0-9][0-9])}; do grep "^| $NN " chapters/teaching.md; done >"$scratch/page"
while read -r row; do
    if cat "$scratch/summary" "$scratch/mistakes" | grep -qxF "$row"; then ok
    else no "chapters/teaching.md: not what was measured: $row"; fi
done <"$scratch/page"
if [ -s "$scratch/page" ]; then ok; else no 'chapters/teaching.md has no row'; fi

# ---------------------------------------------------------------------------------------------------------------
# A class of submissions that do harm, all to exercise 3 of assignment 04; its other files are missing.
class=$scratch/class
mkdir "$class"
cut=$BUILD/assignments/04 canary=$scratch/canary
: >"$canary"

# plant NAME BODY: a submission whose function begins with BODY, and then is right
plant() {
    mkdir "$class/$1"
    awk -v body="$2" '{ print } /^{/ { print body }' "$cut/reference/3_sided.h" >"$class/$1/3_sided.h"
}
# file NAME: a submission with the file that is the input
file() { mkdir "$class/$1" && cat >"$class/$1/3_sided.h"; }

if [ "${ONLY:-04}" = 04 ]; then
    sh $here/grade.sh "$cut/stubs" >/dev/null 2>&1  # the cut is there, and new
    plant honest ''
    plant broken 'int x = ;'
    plant loops 'for (;;) {}'
    plant forks 'static int calls; if (calls++ < 3) fork();'  # three times will do: where nothing stops it, too
    plant prints 'static int calls; char s[1001]; memset(s, 120, 1000); s[1000] = 0; extern int puts(const char *); if (calls++ < 100) for (int i = 0; i < 10; i++) puts(s);'
    plant leaves 'extern void exit(int); exit(0);'
    plant late 'static int calls; extern void exit(int); if (calls++ == 100) exit(0);'
    plant crashes '*(volatile int *)0 = 1;'
    plant deep 'if (side < 100) return triangle_hit_sided(tri, r, 1000, out); else if (side < 100000000) return !triangle_hit_sided(tri, r, side + 1, out);'
    plant writes "extern int open(const char *, int, ...); open(\"$canary.made\", 0101, 0600);"
    plant reads "extern int open(const char *, int, ...); open(\"$canary\", 0);"
    plant removes "unlink(\"$canary\");"
    plant kills 'extern int kill(int, int); kill(getppid(), 9);'
    plant eats 'for (int i = 0; i < 100; i++) { char *p = malloc(100000000); if (!p) *(volatile int *)0 = 1; memset(p, 1, 100000000); }'
    plant answers 'char s[4096]; memset(s, 0, sizeof s); for (int i = 0; i < 10000; i++) if (write(3, s, sizeof s) < 0) break;'
    plant passes 'extern int puts(const char *); puts("3\\tfront, back, both\\t8\\t8\\t0\\t1\\tall 600 right");'
    file includes <<'END'
#include "/etc/passwd"
END
    printf 'int x;/**/%%:include "/etc/passwd"\n' | file digraph
    printf 'int x;\n??=include "/etc/passwd"\n' | file trigraph
    printf 'a\\\nsm(".incbin \\"/etc/passwd\\"");\n' | file splices
    printf '__asm__(".incbin \\"/etc/passwd\\"");\n' | file assembles
    printf 'static void f(void) __attribute__((constructor)); static void f(void) {}\n' | file attribute
    printf 'int big[400000000] = {1};\n' | file 'big =x()'
    head -c 100000 /dev/zero | tr '\000' ' ' | file long
    mkdir "$class/link" "$class/pipe" "$class/folder" "$class/folder/3_sided.h" "$class/empty"
    ln -s "$PWD/$cut/reference/3_sided.h" "$class/link/3_sided.h"
    mkfifo "$class/pipe/3_sided.h"
    ln -s "$class/honest" "$class/linked"
    echo text >"$class/text"
    said=$(CLASS=yes ASSIGNMENT=04 SEED=$seed GRADES=$scratch/grades.csv sh $here/grade.sh "$class" 2>&1) || no "the class: $said"

    # got NAME POINTS WORDS: its line in grades.csv, and what its part of the report says
    got() {
        is "$(awk -F, -v n="$1" '$1 == n { print $3 }' "$scratch/grades.csv")" "$2" "class: points of $1"
        if echo "$said" | awk -v n="== $1" '/^== / { on = $0 == n } on' | grep -q "$3"; then ok
        else no "class: of $1 nobody says $3: $(echo "$said" | awk -v n="== $1" '/^== / { on = $0 == n } on')"; fi
        if [ -z "$2" ]; then return; fi
        json=$BUILD/grades/$1.json
        is "$(grep -c '"score": ' "$json")" "$("$cut/judge" list | wc -l | tr -d ' ')" "class: tests in $json"
        if command -v python3 >/dev/null && ! python3 -m json.tool "$json" >/dev/null; then no "$json"; else ok; fi
    }
    got honest 15 '3_sided.h  *8/8  *7/7'
    got broken 0 'does not compile.*error'
    got loops 0 'more time than it may'
    got prints 15 'printed 1001000 bytes'
    got leaves 0 'no answer to case 0 of 600: it ended with exit(0)'
    got late 0 'no answer to case 100 of 600: it ended with exit(0)'
    got crashes 0 'crashed: signal 11'
    got deep 0 'crashed: signal 11'
    got eats 0 'crashed: signal 11'
    got answers 0 '3 front, back, both: '
    got passes 15 'printed'
    for name in includes digraph trigraph; do got $name 0 'line [12]: # has no place here'; done
    got splices 0 'line 1: a line may not end'
    for name in assembles attribute; do got $name 0 'line 1: asm, attributes and pragmas'; done
    got big__x__ 0 'does not compile'
    got long 0 'longer than 65536'
    got link 0 '3_sided.h is a link'
    got pipe 0 '3_sided.h is no file'
    got folder 0 '3_sided.h is no file'
    got empty 0 '3_sided.h is missing'
    got linked '' 'is no folder'
    got text '' 'is no folder'
    if echo "$said" | grep -q 'system calls refused'; then
        for name in forks writes reads kills removes; do got $name 0 'tried to open a file, start a process'; done
        if [ -f "$canary" ] && [ ! -f "$canary.made" ]; then ok; else no 'a submission removed a file, or made one'; fi
    else echo "assignments.sh: no seccomp here: what opens files and starts processes is not tested"; fi
    if grep -q '^[=+@-]' "$scratch/grades.csv"; then no 'grades.csv: a formula'; else ok; fi
fi

report
