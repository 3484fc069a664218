#!/bin/sh
# Commands in the texts: what stands in `..` or in a block, and begins with make, cc or build/NN_name.
#   sh tests/commands.sh check    are its target, its program, options and files there?          .ci/run
#   sh tests/commands.sh          runs each, as printed, in a fresh clone of what is committed; LIMIT
#                                 seconds at most (300). Ends with those left out, and why.      make commands
# Each is run once, in the order of the texts. What stands in [--..] is optional, and not run. Files that texts
# name (FILE.obj, R.rays, my.h ..) are made before. BUILD: where check finds the programs.
unset MAKEFLAGS MFLAGS MAKELEVEL
. tests/check.sh
: "${BUILD:=build}" "${LIMIT:=300}"
trap 'exit 130' INT TERM

# commands PAGE..: each once, "PAGE:LINE<TAB>COMMAND". In a block a command ends at two spaces, or at " #".
commands() {
    awk '
        function add(at, c) {
            sub(/(  | #).*/, "", c); sub(/ *\[--.*/, "", c); sub(/ \.\.$/, "", c); sub(/ +$/, "", c)
            if (c !~ /^(make|cc|build\/(float\/)?[0-9][0-9]_[a-z_0-9]*)( |$)/ || seen[c]++) return
            print at "\t" c }
        FNR == 1 { fence = 0; begun = "" }
        /^```/ { fence = !fence; next }
        fence || /^    / {
            line = $0; sub(/^ +/, "", line); line = begun line; begun = ""
            if (sub(/\\$/, "", line)) begun = line; else add(FILENAME ":" FNR, line)
            next }
        { line = $0
          while (match(line, /`[^`]+`/)) {
              add(FILENAME ":" FNR, substr(line, RSTART + 1, RLENGTH - 2)); line = substr(line, RSTART + RLENGTH) } }
        ' "$@"
}

# ---- check ----

# Names of targets, and help of programs, are asked for once.
target() {  # target NAME: does the Makefile have it?
    [ -s "$scratch/targets" ] || make -pn help 2>/dev/null |
        sed -n 's/^\([a-zA-Z0-9_/-]*\):\([^=].*\)\{0,1\}$/\1/p' | sort -u >"$scratch/targets"
    case $1 in
    build/float/*) [ -f "chapters/${1##*/}/main.c" ] ;;
    mine-[0-9][0-9]) [ -f "$(echo chapters/"${1#mine-}"_*/mine.h)" ] ;;
    bug-[0-9][0-9] | bug-[0-9][0-9]-answer) number=${1#bug-}; [ -f "tests/bugs/${number%%-*}.patch" ] ;;
    *) grep -qx -e "$1" "$scratch/targets" ;;
    esac
}
option() {  # option PROGRAM --NAME
    [ -s "$scratch/$1" ] || "$BUILD/$1" --help >"$scratch/$1" || return
    grep -q -e "^  $2[ 	]" "$scratch/$1"
}
# faults COMMAND: what it asks for and is not there
faults() {
    echo "$1" | sed "s/'[^']*'/quoted/; s/\"[^\"]*\"/quoted/" | awk '{ gsub(/ && /, "\n"); print }' >"$scratch/parts"
    while read -r first rest; do
        case $first in
        make)
            for word in $rest; do
                case $word in
                *=* | quoted | *NN | picture) ;;  # picture: in the Makefile of a handout
                -*) break ;;
                *) target "$word" || echo "no target $word" ;;
                esac
            done ;;
        build/*)
            name=${first##*/}
            if [ ! -f "chapters/$name/main.c" ]; then echo "no program $name"; continue; fi
            for word in $rest; do
                case $word in
                --*) option "$name" "${word%%=*}" || echo "$name has no $word" ;;
                chapters/* | tests/*) [ -e "$word" ] || echo "no file $word" ;;
                esac
            done ;;
        cc)
            for word in $rest; do
                case $word in *.c) [ -f "$word" ] || echo "no file $word" ;; esac
            done ;;
        esac
    done <"$scratch/parts"
}
check() {
    commands "$@" >"$scratch/all"
    while IFS='	' read -r at command; do
        found=$(faults "$command")
        if [ -z "$found" ]; then ok; else no "$at: $command: $found"; fi
    done <"$scratch/all"
}
# The check sees what it is there to see.
planted() {
    # shellcheck disable=SC2016
    printf '%s\n' '`make run-28`, `make bug-99`, `make run-04`, `build/04_triangle --quikc`, `build/04_triangel`' '' \
        '    build/14_bvh chapters/none.obj --out x.png    a file' '    make mine-05 && build/04_triangle --quick # x' \
        '    build/17_compare FILE.obj [--torture NO]' '    cc -o x chapters/04_triangle/none.c' >"$scratch/page.md"
    commands "$scratch/page.md" | cut -f2 | while read -r command; do faults "$command"; done >"$scratch/seen"
    if [ "$(wc -l <"$scratch/seen")" -eq 7 ]; then ok; else no "7 planted faults: $(cat "$scratch/seen")"; fi
}

# ---- run ----

# left_out COMMAND: why it is not run; nothing if it is
left_out() {
    case $1 in
    "make test" | "make test REAL=float" | "make soak"* | "make precision" | "make hard-cases" | "make REAL=float" | \
        "make run" | "make full" | "make costs" | "make notes" | "make coverage" | "make compilers" | "make mutants"*)
        echo "minutes: .ci/run or its own target" ;;
    "make showpiece" | *"--time 60"* | *"26_path_tracer --scene teapot --size 720x480 --samples 512"* | \
        *"27_effects/scenes/demo.scene --error 0.01"* | *"--samples 500 --size 2000x800"*)
        echo "minutes of drawing" ;;
    "make full-"* | *" --full"*) echo "minutes: make pages FULL=1 compares all that it prints" ;;
    "make book") echo "needs pandoc: .ci/run" ;;
    "make commands") echo "this very run" ;;
    "make embree"*) echo "needs Embree" ;;
    "make grade"* | "make -C /autograder"*) echo "needs submissions: tests/assignments.sh" ;;
    *TEST=my_test.c) echo "needs a test of one's own: tests/bugs.sh" ;;
    "make picture") echo "in a student's folder: tests/assignments.sh" ;;
    *-NN | *NAME*) echo "NN and NAME stand for many" ;;
    *SLURM*) echo "on a cluster" ;;
    esac
}

# ready COMMAND: the files that it names and that the texts do not make
ready() {
    teapot=chapters/07_mesh/scenes/teapot.obj
    for file in FILE.obj a.obj model.obj; do cp $teapot $file; done
    for file in FILE.nff b.nff; do cp tests/corpus/ok_all.nff $file; done
    # One ray: o = (0, -8, 2), tmin = 0, d = (0, 1, 0), tmax = inf, float32.
    printf '\0\0\0\0\0\0\0\301\0\0\0\100\0\0\0\0\0\0\0\0\0\0\200\77\0\0\0\0\0\0\200\177' >R.rays
    cp R.rays FILE
    case $1 in "make mine-"*MINE=my.h) number=${1#make mine-}; cp chapters/"${number%% *}"_*/mine.h my.h ;; esac
    case $1 in *"--merge [0-7].state"*)
        for k in 0 1 2 3 4 5 6 7; do
            build/26_path_tracer --range $((k * 8)):$((k * 8 + 8)) --save $k.state --out $k.png
        done ;;
    esac
}

run_all() {
    git clone -q "$root" "$scratch/a clone" && cd "$scratch/a clone" || exit 1  # a blank in its path
    (cd "$root" && commands "$@") >"$scratch/all"
    if make >"$scratch/said" 2>&1; then ok; else no "make: $(tail -n 3 "$scratch/said")"; fi  # as long as it takes
    while IFS='	' read -r at command; do
        why=$(left_out "$command")
        if [ -n "$why" ]; then echo "left out: $command: $why" >>"$scratch/out"; continue; fi
        ready "$command" >/dev/null 2>&1
        start=$(date +%s)
        timeout "$LIMIT" sh -c "$command" >"$scratch/said" 2>&1 </dev/null
        status=$? took=$(($(date +%s) - start))
        [ $took -lt 20 ] || echo "$took s: $command"
        if [ $status -eq 0 ]; then ok
        elif [ $status -eq 124 ]; then no "$at: $command: more than $LIMIT s"
        else no "$at: $command: exit $status: $(tail -n 3 "$scratch/said")"; fi
    done <"$scratch/all"
    changed=$(git status --porcelain | grep -v '^??')  # make run draws the same pictures, byte for byte
    if [ -z "$changed" ]; then ok; else no "committed files are others now: $changed"; fi
    cat "$scratch/out"
}

mode=${1:-run}
set -- README.md chapters/README.md chapters/*.md chapters/notes/*.md chapters/*/README.md chapters/*/MEASURED.md \
    tests/README.md tests/assignments/README.md
case $mode in
check) planted; check "$@" ;;
run) run_all "$@" ;;
*) echo "commands.sh: check, or nothing" >&2; exit 2 ;;
esac
report
