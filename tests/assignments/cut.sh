#!/bin/sh
# cut.sh NN FOLDER: cuts assignment NN out of the book. In FOLDER then are
#   book/       the files that it needs; instead of the functions of its exercises they have #include "N_name.h"
#   reference/  N_name.h of each exercise, as it should be
#   stubs/      the same with bodies that compile and give a defined, wrong answer
#   list        exercise, file, hours, and the file of the book that it is cut from (or "own"), tabs between
# From the root of the tree.
set -eu
here=tests/assignments
NN=$1 out=$2
[ -f "$here/$NN/exercises" ] || {
    echo "assignment $NN: there are" "$(cd "$here" && echo [0-9][0-9])" >&2
    exit 2
}
rm -rf "$out" && mkdir -p "$out/book/chapters" "$out/reference" "$out/stubs"
# What judge and picture need is what the compiler says that it reads; of common/ all that lies in front.
cp -R common "$out/book/" && rm -rf "$out/book/common/lab" "$out/book/common/numbers"
for picture in chapters/"$NN"_*/first.c; do cp "$picture" "$out/picture.c"; done
for c in "$here/judge.c" "$picture"; do
    ${CC:-cc} -std=c11 -MM -iquote . -iquote "$here" -iquote "$here/$NN" "$c"
done >"$out/reads"
tr -s ' \134' '\n' <"$out/reads" | sed -e ':a' -e 's#[^/. ][^/ ]*/\.\./##' -e ta | grep '^chapters/' | sort -u |
    while read -r f; do mkdir -p "$out/book/$(dirname "$f")" && cp "$f" "$out/book/$f"; done
rm "$out/picture.c" "$out/reads"
: >"$out/list"
# exercises: NUMBER | NAME | FILE of the book, or own | FUNCTIONS | HOURS
grep -v '^#' "$here/$NN/exercises" | while IFS='|' read -r number name from names hours; do
    number=${number%% *} name=${name# } name=${name% } from=${from# } from=${from% }
    file=${number}_$name.h
    if [ "$from" = own ]; then source=$here/$NN/reference/$file
    else
        source=$from cut=$out/book/$from
        [ -f "$cut" ] || { mkdir -p "$(dirname "$cut")" && cp "$from" "$cut"; }
        awk -v names="$names" -v what=rest -v instead="#include \"$file\"" -f "$here/cut.awk" "$cut" >"$out/cut"
        mv "$out/cut" "$cut"
    fi
    awk -v names="$names" -v what=stub -f "$here/cut.awk" "$source" >"$out/stubs/$file"
    if [ "$from" = own ]; then cp "$source" "$out/reference/$file"
    else awk -v names="$names" -v what=take -f "$here/cut.awk" "$source" >"$out/reference/$file"; fi
    printf '%s\t%s\t%s\t%s\n' "$number" "$file" "${hours# }" "$from" >>"$out/list"
done
