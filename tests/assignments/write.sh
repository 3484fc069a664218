#!/bin/sh
# write.sh NN FOLDER: writes the student's folder of assignment NN, and FOLDER.tar.gz: the handout (from the page
# and from NN/handout.md), a file to complete for each exercise, what it needs of the book, a Makefile, the
# public tests. From the root of the tree. A folder that is there already is left alone: it may hold work.
set -eu
here=tests/assignments
NN=$1 out=$2
[ ! -e "$out" ] || { echo "assignment: $out is there already; remove it first" >&2; exit 2; }
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT
cut=$scratch/cut
sh "$here/cut.sh" "$NN" "$cut"
page=$(echo chapters/"$NN"_*/README.md)
name=$(basename "$(dirname "$page")")
${CC:-cc} -std=c11 -O1 -iquote . -iquote "$here" -iquote "$here/$NN" -o "$scratch/judge" "$here/judge.c" -lm

mkdir -p "$out/tests" "$out/images"
cp -R "$cut/book" "$out/"
cp "$cut/stubs"/* "$out/"
mkdir "$out/tests/stubs" && cp "$cut/stubs"/* "$out/tests/stubs/"
cp "$here/exam.h" "$here/test.c" "$here/$NN/question.h" "$here/$NN/solve.h" "$here/$NN/public.h" "$out/tests/"

# The table of exercises: points are those of the checks.
"$scratch/judge" list >"$scratch/checks"
exercises() {
    echo '| file | functions | points: public tests | hidden, easy and hard | hours |'
    echo '|---|---|---|---|---|'
    while IFS="$(printf '\t')" read -r number file hours _; do
        awk -F'\t' -v e="$number" -v file="$file" -v hours="$hours" \
            -v names="$(awk -F'|' -v n="$number" '$1 + 0 == n { print $4 }' "$here/$NN/exercises")" '
            $1 == e { if ($5) public += $3; else hidden += $3 }
            END { n = split(names, f, " "); for (i = 1; i <= n; i++) s = s (i > 1 ? ", " : "") "`" f[i] "`"
                  print "| `" file "` | " s " | " public + 0 " | " hidden + 0 " | " hours " |" }' "$scratch/checks"
    done <"$cut/list"
}

# A section of the page, from its heading to the next; pictures beside the handout, other links as plain text.
section() {
    awk -v heading="## $1" '/^## / { on = $0 == heading } on' "$page" |
        sed -e 's#!\[\([^]]*\)\](\.\./\.\./images/\([^)]*\))#!<\1>(images/\2)#g' -e 's#\[\([^]]*\)\]([^)]*)#\1#g' \
            -e 's#!<\([^>]*\)>(images/#![\1](images/#g'
}
sum=$(awk -F'\t' '{ s += $3 } END { print s }' "$scratch/checks")
{
    echo "# Assignment $NN: $(sed -n '1s/^# [0-9]* //p' "$page")"
    echo
    sed -n 's/^\*\*\(.*\)\*\*$/**\1**/p' "$page" | head -n 1
    echo
    # The shell would take the dollars of formulas; sed reads a file word by word.
    sed -e "s/@SUM@/$sum/" -e "s/@REST@/$((100 - sum))/" "$here/handout.md" >"$scratch/rules"
    sed -e '/^@EXERCISES@$/,$d' "$scratch/rules"
    exercises
    sed -e '1,/^@EXERCISES@$/d' "$scratch/rules"
    cat "$here/$NN/handout.md"
    echo
    section "The idea"
    section "The formulas"
} >"$out/README.md"
grep -o 'images/[A-Za-z0-9_.]*' "$out/README.md" | sort -u | while read -r f; do cp "$f" "$out/images/"; done
awk '/^## Prediction/ { on = 1; print "# Prediction, assignment '"$NN"'\n\nWrite this before you run anything.\n"; next }
     /^## / { on = 0 } on && /^[0-9]+\. / { print; print "\n   *I expect:*\n\n   *because:*\n\n   *afterwards (what happened, and why):*\n" }' \
    "$here/$NN/handout.md" >"$out/prediction.md"
sed -e "s/@NAME@/$name/g" "$here/student.mk" >"$out/Makefile"
tar -C "$(dirname "$out")" -czf "$out.tar.gz" "$(basename "$out")"
echo "$out: README.md says what to do; $out.tar.gz is to be given out"
