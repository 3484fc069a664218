#!/bin/sh
# grade.sh SUBMISSION.. : grades folders with the files of one assignment. From the root of the tree.
#
#   ASSIGNMENT=04   which; else the one most of whose files are there
#   SEED=N          of the questions; else a new one, which the table names
#   RESULTS=FILE    of one submission, as Gradescope reads it; else build/results.json
#   GRADES=FILE     of a class, a line for each; else build/grades.csv, and build/grades/NAME.json
#   CLASS=yes       the argument is a folder with a folder for each submission
#
# A submission is never trusted. Of its folder only regular files with the names of the exercises are read, as
# text, without directives of the preprocessor; each is compiled among our own code for all other exercises,
# under limits, and run in a jail (jail.c). Our own program asks and marks (exam.h).
# results.json: Gradescope's "Autograder Specifications", section "Output format".
set -u
LC_ALL=C
export LC_ALL
here=tests/assignments
build=${BUILD:-build}/assignments
CC=${CC:-cc}
flags='-std=c11 -O1 -ffp-contract=off -fno-tree-slp-vectorize -Wno-unused-parameter'
tab=$(printf '\t')
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT
trap 'exit 130' INT TERM
stop() { echo "grade: $*" >&2; exit 2; }

# Whether the jail refuses system calls needs a program without libraries of the system; ask once.
prepare_jail() {
    mkdir -p "$build"
    [ -z "$(find "$here/jail.c" -newer "$build/jail" 2>&1)" ] || $CC -std=c11 -O1 -o "$build/jail" "$here/jail.c" || stop "no jail"
    jail='limits only: use a machine to throw away' static='' run=limit
    echo 'int main(void) { return 0; }' >"$scratch/static.c"
    if "$build/jail" can && $CC -static -o "$scratch/static" "$scratch/static.c" 2>/dev/null; then
        jail='system calls refused' static=-static run=run
    fi
}

# prepare NN: the cut, and the judge, unless they are newer than all that they are made of.
prepare() {
    cut=$build/$1 judge=$build/$1/judge
    [ -z "$(find "$here" common chapters/*/first.[hc] -newer "$judge" -type f 2>&1 | head -n 1)" ] && return
    sh "$here/cut.sh" "$1" "$cut" || exit 2
    # shellcheck disable=SC2086
    $CC $flags -iquote . -iquote "$here" -iquote "$here/$1" -o "$judge" "$here/judge.c" -lm || stop "no judge"
}

# assignment_of FOLDER: the assignment most of whose files are there
assignment_of() {
    best=0
    for list in "$here"/[0-9][0-9]/exercises; do
        n=$(grep -v '^#' "$list" | tr -d ' ' | cut -d'|' -f1-2 | tr '|' _ | while read -r f; do
            [ -f "$1/$f.h" ] && echo x
        done | wc -l)
        [ "$n" -gt "$best" ] && best=$n && basename "$(dirname "$list")"
    done | tail -n 1
}

# admit FILE COPY: copies the text of a submitted file; says why not, if it is none that may be compiled.
admit() {
    if [ -L "$1" ]; then echo "is a link: only files are taken"; return 1; fi
    if [ ! -e "$1" ]; then echo "is missing"; return 1; fi
    if [ ! -f "$1" ] || [ ! -r "$1" ]; then echo "is no file that can be read"; return 1; fi
    if [ "$(($(wc -c <"$1")))" -gt 65536 ]; then echo "is longer than 65536 bytes"; return 1; fi
    tr -d '\r\000' <"$1" >"$2"
    # What could make the compiler read other files: directives, in all their spellings, and assembler. Each is a
    # single word or sign, since without directives there is no macro that could put it together.
    awk '/#|%:|\?\?/ { print "line " NR ": # has no place here: no directives, and what is needed is included"; exit 1 }
         /\\[ \t\v\f]*$/ { print "line " NR ": a line may not end with \\"; exit 1 }
         /(^|[^A-Za-z0-9_])_*(asm|attribute|Pragma)_*([^A-Za-z0-9_]|$)/ {
             print "line " NR ": asm, attributes and pragmas have no place here"; exit 1 }' "$2"
}

# compile EXERCISE FILE: this file of the submission among our own code for all other exercises
compile() {
    # shellcheck disable=SC2086
    TMPDIR=$scratch "$build/jail" build $CC $flags $static -w -iquote "$scratch/taken" -iquote "$cut/reference" \
        -iquote "$cut/book" -iquote "$here/$assignment" \
        -o "$scratch/worker" "$here/worker.c" -lm
}

# marks NUMBER FILE FOLDER: a line for each check, as judge.c writes them
marks() {
    rm -rf "$scratch/taken" "$scratch/worker"
    mkdir "$scratch/taken"
    verdict=
    if ! why=$(admit "$3/$2" "$scratch/taken/$2"); then verdict="$2 $why"
    elif ! why=$(compile); then
        verdict="$2 does not compile: $(printf '%s' "$why" | tr -cd '\n\t -~' | tr '\t' ' ' |
            sed "s#$scratch/taken/##g" | grep error | head -n 3 | cut -c1-120 | tr '\n' ';')"
    fi
    for level in easy hard; do
        : >"$scratch/answers" && chmod 600 "$scratch/answers"
        said=$verdict
        if [ -z "$verdict" ]; then
            "$judge" ask "$1" $level "$seed" >"$scratch/questions"
            said=$("$build/jail" $run "$scratch/questions" "$scratch/answers" "$scratch/worker" "$1")
            case $said in *printed*) printf '%s\t%s\n' "$1" "${said#*; }" >>"$scratch/remarks" ;; esac
        fi
        "$judge" mark "$1" $level "$seed" "$scratch/answers" "$said"
    done
}

# table: what judge.c wrote, for people
table() {
    awk -F"$tab" -v files="$cut/list" '
        BEGIN { while ((getline line <files) > 0) { split(line, f, FS); file[f[1]] = f[2] }
                printf "%-18s %10s %10s %10s\n", "exercise", "easy", "hard", "points" }
        { got[$1, $5] += $3; of[$1, $5] += $4; if (!seen[$1]++) order[++n] = $1
          if ($3 == $4) next
          # What is wrong with a file is said once, not for each check.
          at = index($7, ": " file[$1])
          if (at && !about[$1]++) why[++w] = $1 ": " substr($7, at + 2)
          else if (!at) why[++w] = sprintf("%d %s%s: %s", $1, $2, $6 ? "" : " (hidden)", $7) }
        function share(a, b) { return b ? a "/" b : "-" }
        END { for (i = 1; i <= n; i++) { e = order[i]
                  printf "%-18s %10s %10s %10s\n", file[e], share(got[e, 0] + 0, of[e, 0]),
                      share(got[e, 1] + 0, of[e, 1]), share(got[e, 0] + got[e, 1], of[e, 0] + of[e, 1])
                  sum += got[e, 0] + got[e, 1]; most += of[e, 0] + of[e, 1] }
              printf "%-18s %10s %10s %10s\n", "sum", "", "", share(sum, most)
              for (i = 1; i <= w; i++) print "  " why[i] }' "$scratch/marks"
    awk -F"$tab" '!seen[$0]++ { print "  " $1 ": " $2 }' "$scratch/remarks"
}

# json: the same as results.json; hidden checks are shown when the assignment is due
json() {
    awk -F"$tab" -v seed="$seed" -v jail="$jail" -v NN="$assignment" '
        function text(s,   i, c, out) {
            for (i = 1; i <= length(s); i++) {
                c = substr(s, i, 1)
                out = out (c == "\\" || c == "\"" ? "\\" c : c ~ /[ -~]/ ? c : "?")
            }
            return "\"" out "\"" }
        BEGIN { print "{"; print "  \"output\": " text("assignment " NN ", seed " seed ", jail: " jail \
                    "; the prediction is graded by hand") ","; print "  \"tests\": [" }
        { if (NR > 1) print ","
          printf "    {\"name\": %s, \"number\": %s, \"score\": %g, \"max_score\": %g, \"status\": \"%s\", ", \
              text($2), text($1), $3, $4, $3 == $4 ? "passed" : "failed"
          printf "\"output\": %s, \"visibility\": \"%s\"}", text($7), $6 ? "visible" : "after_due_date" }
        END { print "\n  ]"; print "}" }' "$scratch/marks"
}

# grade FOLDER RESULTS: writes the table to the screen and results.json; sets score and most
grade() {
    assignment=${ASSIGNMENT:-$(assignment_of "$1")}
    : >"$scratch/marks" && : >"$scratch/remarks"
    score=0 most=0
    [ -n "$assignment" ] || { echo "$1: no file of any assignment is here"; return; }
    [ -f "$here/$assignment/exercises" ] || stop "there is no assignment $assignment"
    prepare "$assignment"
    while IFS=$tab read -r number file _; do
        marks "$number" "$file" "$1" </dev/null >>"$scratch/marks"
    done <"$cut/list"
    echo "assignment $assignment, seed $seed, jail: $jail"
    table
    if [ -f "$1/prediction.md" ] && [ ! -L "$1/prediction.md" ]; then
        echo "  prediction.md: $(($(tr -d '\000' <"$1/prediction.md" | head -c 65536 | wc -w))) words, to be read by you"
    else echo "  prediction.md is missing"; fi
    json >"$scratch/json" && cp "$scratch/json" "$2"
    score=$(awk -F"$tab" '{ s += $3 } END { print s + 0 }' "$scratch/marks")
    most=$(awk -F"$tab" '{ s += $4 } END { print s + 0 }' "$scratch/marks")
}

[ $# -eq 1 ] || stop "SUBMISSION=folder or SUBMISSIONS=folder of folders"
[ -d "$1" ] || stop "$1 is no folder"
seed=${SEED:-$(od -An -N4 -tu4 /dev/urandom | tr -d ' ')}
case $seed in '' | *[!0-9]*) stop "SEED is a number, not $seed" ;; esac
prepare_jail
if [ "${CLASS:-no}" = no ]; then
    grade "$1" "${RESULTS:-${BUILD:-build}/results.json}"
    [ -n "$assignment" ] || exit 2
    exit 0
fi
grades=${GRADES:-${BUILD:-build}/grades.csv}
mkdir -p "${BUILD:-build}/grades"
echo 'submission,assignment,points,of,seed,exercises' >"$scratch/csv"
for folder in "$1"/*; do
    # What stands in the table: letters, digits, and what no spreadsheet takes for a formula.
    name=$(basename "$folder" | tr -c 'A-Za-z0-9._\n-' _ | tr '\n' ' ' | sed 's/ *$//; s/^[-.]/_/; s/ /_/g')
    echo; echo "== $name"
    if [ -L "$folder" ] || [ ! -d "$folder" ]; then echo "is no folder"; continue; fi
    grade "$folder" "${BUILD:-build}/grades/$name.json"
    each=$(awk -F"$tab" '{ got[$1] += $3 } END { for (e = 1; e in got; e++) printf "%s%g", (e > 1 ? " " : ""), got[e] }' \
        "$scratch/marks")
    echo "$name,$assignment,$score,$most,$seed,$each" >>"$scratch/csv"
done
cp "$scratch/csv" "$grades"
echo; echo "$grades"
