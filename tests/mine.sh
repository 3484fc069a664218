#!/bin/sh
# A reader's own function among the chapter's: `make mine-04 MINE=my.h` compiles 04's program with it, and runs it
# in build/mine-04, where its pictures and plots go. Without MINE the chapter's mine.h, which is one to begin with.
#   sh tests/mine.sh 04 my.h [OPTION..]       exit 2: no such file, no such function, does not compile
#   sh tests/mine.sh tests                    .ci/run
: "${CC:=cc}" "${BUILD:=build}" "${MAKE:=make}"

# wants NUMBER: the program, and what it must be given
wants() {
    case $1 in
    03) program=03_sphere name=mine_sphere_hit; form='bool mine_sphere_hit(sphere s, ray r, hit *out)' ;;
    04) program=04_triangle name=mine_triangle_hit; form='bool mine_triangle_hit(triangle tri, ray r, hit *out)' ;;
    09) program=09_aabb name=mine_aabb_hit; form='bool mine_aabb_hit(aabb b, ray r, real *t_enter)' ;;
    17) program=17_compare name=mine_build; form='a structure called mine, with mine_options, mine_build' ;;
    *) return 1 ;;
    esac
}
end() { echo "$1" >&2; exit 2; }

if [ "${1:-}" != tests ]; then
    wants "${1:-}" || end "mine-${1:-}: there are mine-03 (sphere), mine-04 (triangle), mine-09 (box), mine-17 (structure)"
    file=${2:-chapters/$program/mine.h} dir=$BUILD/mine-$1 page=chapters/$program/mine.h number=$1
    binary=${QUICK:+quick/}$program
    if [ ! -f "$file" ] || [ ! -r "$file" ]; then end "mine-$number: $file: no such file"; fi
    grep -qw "$name" "$file" || end "mine-$number: $file lacks $name; wanted is $form: see $page"
    path=$(cd "$(dirname "$file")" && pwd)/$(basename "$file")
    case $path in *[\"\\]*) end "mine-$number: $path: a path without \" and \\, please" ;; esac
    mkdir -p "$dir/build" "$dir/images" && rm -f "$dir/$binary"
    if ! $MAKE -s --no-print-directory CC="$CC" BUILD="$dir" MINE="$path" "$dir/$binary" 2>"$dir/errors"
    then
        grep -E 'error|warning' "$dir/errors" | head -n 5 >&2
        end "mine-$number: $file does not compile; wanted is $form: see $page, and all messages in $dir/errors"
    fi
    cat "$dir/errors" >&2
    shift; [ $# -eq 0 ] || shift
    (cd "$dir" && "./$binary" "$@"); status=$?
    echo "   pictures and plots: $dir/images $dir/build"
    [ "$number" != 17 ] || echo "   all its hits by brute force: $dir/$binary --verify --only mine"
    exit "$status"
fi

. tests/check.sh
export QUICK=yes  # compiled soon rather than to be fast

# tried STATUS TEXT NUMBER FILE [OPTION..]: ends with this status, and says the text
tried() {
    status=$1 text=$2; shift 2
    sh tests/mine.sh "$@" >"$scratch/said" 2>&1; got=$?
    if [ $got -eq "$status" ] && grep -qF "$text" "$scratch/said"; then ok
    else no "mine.sh $*: status $got, wanted $status and '$text': $(head -n 5 "$scratch/said")"; fi
}
# wrong NUMBER FROM TO: its mine.h with one thing changed
wrong() {
    wants "$1"
    sed "s/$2/$3/" "chapters/$program/mine.h" >"$scratch/wrong.h"
    if cmp -s "$scratch/wrong.h" "chapters/$program/mine.h"; then no "$1: nothing was changed: $2"; else ok; fi
}

for n in 03 04 09; do tried 0 'mine: right' "$n" '' --quick; done
tried 0 'as brute force' 17 '' --verify --scene tetra --only mine --quick
tried 0 '/17_compare --verify --only mine' 17 '' --scene tetra --only mine --quick
tried 2 'there are mine-03' 05 ''
tried 2 'no such file' 04 "$scratch/none.h"
tried 2 'no such file' 04 "$scratch"
echo 'static int my_hit;' >"$scratch/own.h"
tried 2 'lacks mine_triangle_hit' 04 "$scratch/own.h"
echo 'mine_triangle_hit = ;' >"$scratch/own.h"
tried 2 'does not compile' 04 "$scratch/own.h"

# A folder with a blank; functions with a mistake: the ray, what is expected, what is given.
wrong 04 'u >= 0' 'u >= 1'
mkdir "$scratch/a b" && cp "$scratch/wrong.h" "$scratch/a b"
tried 1 '  expected: t = ' 04 "$scratch/a b/wrong.h" --quick
tried 1 '  mine: no hit' 04 "$scratch/wrong.h" --quick
wrong 03 '(middle + sqrt(half2))' '(middle - sqrt(half2))'
tried 1 'mine: wrong ray: o = ' 03 "$scratch/wrong.h" --quick
wrong 09 'return r.tmin <= r.tmax' 'return r.tmax > 0'
tried 1 '  expected: no hit' 09 "$scratch/wrong.h" --quick
wrong 17 'm->box\[i\], hair' 'm->box[i], 0'
tried 1 ' itself, and the box that lists it: x ' 17 "$scratch/wrong.h" --verify --scene teapot --scale 3 --only mine
sed '/item_cell mine_cell_of/,/^}/d; /define MINE_CELL/d' "$scratch/wrong.h" >"$scratch/own.h"
tried 1 ' itself: x ' 17 "$scratch/own.h" --verify --scene teapot --scale 3 --only mine

report
