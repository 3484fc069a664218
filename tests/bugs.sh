#!/bin/sh
# Planted bugs: bugs/NN.patch is one mistake of one or two lines, as students make them. Above its diff stand
# what is seen (Symptom, Hint), what is built and run (Build, Run, Picture), and who catches it: the Test, by the
# check whose message holds Fails. The tree is never touched: a bug lives in a copy, build/bug-NN.
#   sh tests/bugs.sh                  is each patch whole, and does it apply?           make test
#   sh tests/bugs.sh tests            is each caught by its test, which passes without it?    .ci/run
#   sh tests/bugs.sh show 07          the handout, and what the program says             make bug-07
#   sh tests/bugs.sh try 07 FILE.c    does this test tell the copy from the tree?        make bug-07 TEST=FILE.c
#   sh tests/bugs.sh answer 07        the line, why, and which test catches it           make bug-07-answer
#   sh tests/bugs.sh list             all symptoms                                       make bugs
unset CHECK_DIVISOR CHECK_SOAK MAKEFLAGS MFLAGS MAKELEVEL
: "${CC:=cc}" "${BUILD:=build}" "${JOBS:=2}"
here=tests/bugs

# field NAME PATCH: what stands behind "NAME:", and on the lines below it that begin with a blank
field() {
    awk -v name="$1:" '/^$/ { exit } /^[^ ]/ { on = 0 } $1 == name { on = 1; sub(/^[^ ]* /, "") }
                       on { sub(/^ +/, ""); print }' "$2"
}

# target PATCH: the file that it changes
target() { sed -n 's#^+++ b/##p' "$1"; }

# apply PATCH DIR: in DIR, wherever in the file the lines stand now; false unless they stand there once
apply() {
    awk -v patch="$1" '
        BEGIN { while ((getline line < patch) > 0) {
                    sign = substr(line, 1, 1)
                    if (line ~ /^@@ /) hunks++
                    else if (hunks) {
                        if (sign != "+") old[++n] = substr(line, 2)
                        if (sign != "-") new[++m] = substr(line, 2) } } }
        { file[NR] = $0 }
        END { for (i = 0; i + n <= NR; i++) {
                  for (k = 1; k <= n && file[i + k] == old[k]; k++) continue
                  if (k > n) { found++; at = i } }
              if (found != 1 || hunks != 1) exit 1
              for (i = 1; i <= at; i++) print file[i]
              for (k = 1; k <= m; k++) print new[k]
              for (i = at + n + 1; i <= NR; i++) print file[i] }' "$2/$(target "$1")" >"$2/changed" 2>/dev/null &&
        mv "$2/changed" "$2/$(target "$1")"
}

# copy DIR: a tree of its own, without the answers; what was built there before stays
copy() {
    rm -rf "$1/chapters" "$1/common" "$1/tests"
    mkdir -p "$1/images" && cp -Rp chapters common tests Makefile "$1" && rm -rf "$1/tests/bugs"
}

# make_in DIR TARGET: in double; without warnings, which might name the line
make_in() { make -s --no-print-directory -C "$1" CC="$CC" REAL=double BUILD=build WARN= WARN_FIRST= "$2" >&2; }

# failures DIR TEST: the messages of its checks that fail, or all it says if it does not come to its last line
failures() {
    (cd "$1" && "build/test_$2") >"$1/said" 2>&1
    if tail -n 1 "$1/said" | grep -q ' passed, [0-9]* failed$'; then grep 'FAILED: ' "$1/said"; else cat "$1/said"; fi
}

wanted() {  # wanted NN: its patch, or the end
    case $1 in [0-9][0-9]) [ -r "$here/$1.patch" ] && patch=$here/$1.patch && return ;; esac
    echo "bug $1: there is no such bug; there are: $(cd $here && echo [0-9]*.patch | sed 's/\.patch//g')" >&2
    exit 2
}

both() {  # both NN: the tree, and the tree with the bug
    whole=$BUILD/bug-whole broken=$BUILD/bug-$1
    copy "$whole" && copy "$broken" || exit 1
    apply "$patch" "$broken" || { echo "bug $1: its patch does not apply to this tree" >&2; exit 1; }
}

handout() {  # handout PATCH: all but what gives it away
    echo "bug $(basename "$1" .patch): $(field Part "$1")"
    field Symptom "$1" | sed 's/^/    /'
}

case ${1:-} in
list)
    for patch in "$here"/*.patch; do
        [ "$(field Part "$patch")" = "$part" ] || { part=$(field Part "$patch"); echo; echo "$part"; }
        echo "    bug-$(basename "$patch" .patch)  $(field Symptom "$patch" | sed '2,$s/^/            /')"
    done
    exit ;;
show)
    wanted "$2"; both "$2"
    handout "$patch"
    command=$(field Run "$patch") picture=$(field Picture "$patch")
    for dir in "$whole" "$broken"; do
        make_in "$dir" "$(field Build "$patch")" || exit 1
        echo
        if [ "$dir" = "$whole" ]; then echo "Without it:"; else echo "With it:"; fi
        echo "    $command"
        (cd "$dir" && sh -c "$command" 2>&1) | grep -v -e '^->' -e '^ *the page:' -e '^$' | sed 's/^/    /'
        [ -z "$picture" ] || echo "    picture: $dir/images/$picture"
    done
    echo
    echo "To think about:"
    field Hint "$patch" | sed 's/^/    /'
    echo
    echo "The source is in $broken/chapters. Hand in the line with a sentence on why it is wrong, and a test that"
    echo "passes without it and fails with it (tests/README.md): make bug-$2 TEST=my_test.c"
    echo "The answer: make bug-$2-answer"
    exit ;;
try)
    wanted "$2"
    [ -r "$3" ] || { echo "bug $2: $3: no such file" >&2; exit 2; }
    case $3 in *.c) ;; *) echo "bug $2: $3: a test is a .c file" >&2; exit 2 ;; esac
    both "$2"
    for dir in "$whole" "$broken"; do
        cp "$3" "$dir/tests/mine.c"
        make_in "$dir" build/test_mine || { echo "bug $2: $3 does not compile" >&2; exit 2; }
    done
    if [ -n "$(failures "$whole" mine)" ]; then
        failures "$whole" mine
        echo "bug $2: not caught: $3 fails without the bug, too"; exit 1
    fi
    failures "$broken" mine >"$broken/seen"
    [ -s "$broken/seen" ] || { echo "bug $2: not caught: $3 passes with the bug"; exit 1; }
    sed 's/^/    /' "$broken/seen"
    echo "bug $2: caught by $3, which passes without it"
    exit ;;
answer)
    wanted "$2"
    handout "$patch"; echo
    field Answer "$patch"; echo
    sed -n '/^--- /,$p' "$patch"; echo
    echo "Caught by tests/$(field Test "$patch").c: \"$(field Fails "$patch")\""
    exit ;;
caught)  # caught NN: for `tests`, several at a time. Copies of their own: the whole one is shared, and built
    wanted "$2"; whole=$BUILD/bug-whole broken=$BUILD/bug-$2 test=$(field Test "$patch")
    copy "$broken"; apply "$patch" "$broken" && make_in "$broken" "build/test_$test" || exit 1
    failures "$whole" "$test" | grep -qF "$(field Fails "$patch")" && { echo "bug $2: $test fails without it"; exit 1; }
    failures "$broken" "$test" | grep -qF "$(field Fails "$patch")" || { echo "bug $2: not caught by $test"; exit 1; }
    rm -rf "$broken"; exit ;;
esac

. tests/check.sh

# Of each: it applies, changes one or two lines, and its handout names neither file nor line; its test exists.
for patch in "$here"/*.patch; do
    mkdir -p "$scratch/$(dirname "$(target "$patch")")" && cp "$(target "$patch")" "$scratch/$(target "$patch")"
    if apply "$patch" "$scratch"; then ok; else no "$patch does not apply"; fi
    lines=$(grep -c '^[-+][^-+]' "$patch")
    if [ "$lines" -ge 1 ] && [ "$lines" -le 3 ]; then ok; else no "$patch changes $lines lines"; fi
    lost=
    for name in Part Symptom Hint Build Run Test Fails Answer; do
        [ -n "$(field $name "$patch")" ] || lost="$lost $name"
    done
    if [ -z "$lost" ] && [ -r "tests/$(field Test "$patch").c" ]; then ok; else no "$patch lacks$lost, or its test"; fi
    if { field Symptom "$patch"; field Hint "$patch"; } | grep -qF "$(target "$patch")"
    then no "$patch: its handout names the file"; else ok; fi
done
for part in '01 to 08' '09 to 17' '18, 19' '20 to 23' '24 to 27'; do
    if [ "$(grep -lF "Part: " "$here"/*.patch | xargs grep -lF "($part)" | wc -l)" -ge 2 ]; then ok
    else no "fewer than two bugs in $part"; fi
done

# The page lists them all, as `make bugs` does.
sh tests/bugs.sh list | sed -e 1d -e 's/^./    &/' >"$scratch/list"
sed -n '/^## The bugs/,/^## Your/p' chapters/bugs.md | grep '^    ' >"$scratch/page"
if [ "$(grep . "$scratch/list")" = "$(cat "$scratch/page")" ]; then ok
else no "chapters/bugs.md does not list what \`make bugs\` prints: $(diff "$scratch/list" "$scratch/page" | head -n 4)"; fi

# The rule sees what it is there to see: a line that is not there, and one that stands there twice.
mkdir -p "$scratch/x" && printf 'a\nb\nb\n' >"$scratch/x/y"
plant() { printf -- '--- a/x/y\n+++ b/x/y\n@@ -1 +1 @@\n-%s\n+c\n' "$1" >"$scratch/p"; apply "$scratch/p" "$scratch"; }
if plant z || plant b; then no "a patch that does not apply was applied"; else ok; fi
if plant a && [ "$(head -n 1 "$scratch/x/y")" = c ]; then ok; else no "a patch that applies was not applied"; fi

if [ "${1:-}" = tests ]; then
    # BUILT, a folder: what `make test` has just built there, links among it, are the tests without the bugs.
    copy "$BUILD/bug-whole"
    for patch in "$here"/*.patch; do field Test "$patch"; done | sort -u | sed 's#.*#test_&#' >"$scratch/whole"
    if [ -n "${BUILT:-}" ]; then
        mkdir -p "$BUILD/bug-whole/build"
        while read -r test; do cp "$BUILT/$test" "$BUILD/bug-whole/build" || exit 1; done <"$scratch/whole"
    else
        sed 's#^#build/#' "$scratch/whole" | xargs make -s --no-print-directory -j"$JOBS" -C "$BUILD/bug-whole" \
            CC="$CC" REAL=double BUILD=build WARN= WARN_FIRST=
    fi
    for patch in "$here"/*.patch; do basename "$patch" .patch; done |
        xargs -P "$JOBS" -I{} sh -c 'sh tests/bugs.sh caught {} >'"$scratch"'/{} 2>&1 && echo yes >'"$scratch/{}"
    for patch in "$here"/*.patch; do
        n=$(basename "$patch" .patch)
        if [ "$(tail -n 1 "$scratch/$n")" = yes ]; then ok; else no "$(cat "$scratch/$n")"; fi
    done
fi

report
