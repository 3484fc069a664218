#!/bin/sh
# Every built program of a chapter: misuse, files that can't be read or written, full disks, Ctrl-C,
# and what the options promise. BUILD names the directory of the programs, CC the compiler.
. tests/check.sh
case ${BUILD:=build} in /*) ;; *) BUILD=$root/$BUILD ;; esac
trap 'chmod -R u+w "$scratch"; rm -rf "$scratch"' EXIT

# run STATUS ARGUMENTS...: runs the program, which must end with that status
run() {
    expected=$1; shift
    "$program" "$@" >out 2>err </dev/null
    status=$?
    if [ $status -eq "$expected" ]; then ok
    else no "$* ended with $status, not $expected: $(head -c 300 err)"; fi
}
# says TEXT: the one line on stderr names the program and has the text; stdout is empty. The shell looks itself:
# most questions of this file are asked here.
says() {
    if { read -r first && ! read -r _; } <err && [ ! -s out ]; then
        case $first in "$name: "*"$1"*) ok; return ;; esac
    fi
    no "stderr lacks '$1': $(head -c 300 err)"
}
misuse() {  # misuse TEXT ALLOWED ARGUMENTS...
    text=$1 allowed=$2; shift 2
    run 2 "$@"; says "$text"; says "$allowed"
}
# table_or_misuse ARGUMENTS...: --csv is heeded, or refused at once; tiny.csv is there if it was heeded
table_or_misuse() {
    rm -f tiny.csv
    "$program" --quick --size 1x1 --csv tiny.csv "$@" >out 2>err </dev/null
    status=$?
    if [ $status -eq 2 ]; then
        says "--csv"
        if [ -e tiny.csv ]; then no "misuse left files behind"; else ok; fi
    elif [ $status -eq 0 ] && [ -s tiny.csv ]; then ok
    else no "--csv $* ended with $status, no table: $(head -c 300 err)"; fi
}
no_part() { if [ -z "$(find . -name '*.part')" ]; then ok; else no "a .part file is left"; fi; }

# whole FILE: the picture begins as its ending wants; a PPM has all its bytes
whole() {
    case $1 in
    *.p3.ppm) magic=P3 ;; *.ppm) magic=P6 ;; *.pfm) magic=PF ;; *.png) magic=PNG ;;
    esac
    if [ ! -f "$1" ] || ! head -c 8 "$1" | LC_ALL=C grep -qa "$magic"; then no "$1 is no picture"; return
    elif [ "$magic" = PNG ] && command -v pngcheck >/dev/null && ! pngcheck -q "$1" >/dev/null
    then no "$1: $(pngcheck "$1")"; return
    elif [ "$magic" = P6 ]; then
        expected=$(head -n 3 "$1" | awk '{ n += length + 1 } NR == 2 { n += 3 * $1 * $2 } END { print n }')
        if [ "$(wc -c <"$1")" -ne "$expected" ]; then no "$1 is cut off"; return; fi
    fi
    ok
}

# The shell makes its background jobs ignore Ctrl-C: this hands them the signal back, and leaves a file that says
# so. Who sends Ctrl-C before, on a busy machine, waits for a whole picture of 2000x2000.
echo '#include <fcntl.h>
#include <signal.h>
#include <unistd.h>
int main(int c, char **v) { signal(SIGINT, SIG_DFL); creat("heard", 0600); return c < 2 || execv(v[1], v + 1); }' \
    >"$scratch/hear.c"
${CC:-cc} -o "$scratch/hear" "$scratch/hear.c" || { echo "cli.sh: hear.c does not compile"; exit 1; }

# interrupt SECONDS: Ctrl-C after so long; status in $status
interrupt() {
    rm -f big.ppm heard
    "$scratch/hear" "$program" --size 2000x2000 --out big.ppm >out 2>err </dev/null &
    pid=$!
    until [ -e heard ]; do sleep 0.01; done
    sleep "$1"
    kill -INT $pid 2>/dev/null
    wait $pid
    status=$?
}

turn=0 count=0 divisor=${CLI_DIVISOR:-${CHECK_DIVISOR:-7}}
case $divisor in
'' | *[!0-9]* | 0*) echo "cli.sh: CLI_DIVISOR is $divisor: allowed are whole numbers from 1" >&2; exit 2 ;;
esac
[ "$divisor" -le 1 ] || echo "cli.sh: ${CLI_REST:+all but }one program of $divisor does all; all of them: CLI_DIVISOR=1"
for main in "$root"/chapters/${ONLY:-*}/main.c; do  # ONLY=14_bvh: that one
    name=$(basename "$(dirname "$main")")
    program=$BUILD/$name
    if [ ! -x "$program" ]; then no "not built"; continue; fi
    mkdir "$scratch/$name" && cd "$scratch/$name" || exit 1
    # Asked is every seventh program; with CHECK_DIVISOR=10 or CLI_DIVISOR=10 every tenth. CLI_REST=yes: all but these;
    # so .ci/run, which goes through twice, asks each of them.
    count=$((count + 1)) asked=$((count % divisor == divisor - 1))
    [ -z "${CLI_REST:-}" ] || asked=$((1 - asked))

    run 0 --help
    if [ ! -s err ] && grep -q "^usage: $name" out; then ok; else no "--help is not on stdout"; fi
    help=$(cat out)
    for option in out size threads seed csv preview quick help; do
        case $help in *"
  --$option"[\ \	]*) ok ;; *) no "--help lacks --$option" ;; esac
    done
    # What all programs do alike, as common/options.h does it, is asked of a tenth only where a tenth is asked.
    if [ $asked -eq 0 ] && [ "$divisor" -ge 10 ]; then
        run 0 --quick --size 48x36
        cd "$root" || exit 1
        continue
    fi
    misuse "unknown option --bogus" "--help" --bogus
    misuse "stray: " "--help" stray
    misuse "--size 4:" "from 1 to 16384" --size 4
    misuse "--size 0x5" "WxH" --size=0x5
    misuse "--threads 257" "from 1 to 256" --threads 257
    misuse "--seed -1" "from 0" --seed -1
    misuse "--csv needs a value" "names of files" --quick --csv
    misuse "--quick takes no value" "--quick=yes" --quick=yes
    misuse "x.jpg" ".png, .ppm, .p3.ppm or .pfm" --out x.jpg
    run 1 --out no/such/x.png; says "no/such/x.png: cannot write: No such file"
    run 1 --csv no/such.csv; says "no/such.csv: cannot write: No such file"
    run 1 --csv .; says "cannot write: Is a directory"
    # Options of a program that name a file to read: missing, a directory, not of that kind.
    for option in $("$program" --help | sed -n -e 's/^  --\([a-z]*\) FILE .*/\1/p' \
            -e 's/^  --\([a-z]*\) TEXT .*FILE.*/\1/p'); do
        case $option in out | csv | hits | save | costs | report) continue ;; esac
        run 1 --quick "--$option" no/such.file; says "no/such.file: cannot read: No such file"
        run 1 --quick "--$option" .; says "cannot read: Is a directory"
        head -c 1000 "$program" >garbage
        run 2 --quick "--$option" garbage; says "garbage"
    done
    if [ -z "$(find . ! -name out ! -name err ! -name garbage ! -name .)" ]; then ok
    else no "misuse left files behind: $(ls)"; fi

    # All that follows for those asked, for the others one run.
    if [ $asked -eq 0 ]; then
        run 0 --quick --size 48x36
        cd "$root" || exit 1
        continue
    fi

    "$program" --help >help

    # One thread or three, the same bytes; the CSV has a header and rows of the same width.
    run 0 --quick --threads 1 --csv table.csv
    if awk -F'"' '{ gsub(",", ";", $2); n = gsub(",", ",", $0) } NR == 1 { m = n }
                  n != m || m == 0 { bad = 1 } END { exit bad || NR < 2 }' table.csv
    then ok; else no "the CSV is no table"; fi
    mv build/quick one
    run 0 --quick --threads 3
    for picture in one/*.png; do
        whole "$picture"
        if cmp -s "$picture" "build/quick/${picture#one/}"; then ok
        else no "$picture depends on the number of threads"; fi
    done
    if [ ! -d images ]; then ok; else no "--quick writes into images/"; fi

    # An output that is an input or another output is refused; so is a device that never ends.
    run 2 --quick --out one.ppm --csv one.ppm; says "--out one.ppm: is the file of --csv"
    run 2 --quick --out one.ppm --csv ./one.ppm; says "is the file of --csv"
    misuse "unknown option -x" "--help" -x
    if grep -q '^  --mesh FILE' help; then
        printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >one.obj
        cp one.obj kept.obj
        for option in csv out; do
            ln -s one.obj one.ppm
            run 2 --quick one.obj --$option one.ppm; says "--$option one.ppm: is the file of --mesh"
            if cmp -s one.obj kept.obj; then ok; else no "the model is gone"; fi
            rm one.ppm
        done
        run 1 --quick --mesh /dev/zero; says "a device"
        run 0 --quick --size 48x36 one.obj
        if [ ! -d images ]; then ok; else no "a picture of a model of one's own is in images/"; fi
    fi

    # A picture, and a mesh, with a table.
    table_or_misuse --out tiny.ppm
    sizes='1x300 300x1'
    if [ -e tiny.csv ]; then whole tiny.ppm; else sizes="1x1 $sizes"; fi
    if grep -q '^  --mesh FILE' help; then table_or_misuse --mesh one.obj; fi
    if grep -q '^  --save FILE' help; then table_or_misuse --save saved.obj; fi
    for size in $sizes; do  # fewer pixels than panels, tiles, threads
        run 0 --quick --size "$size" --out tiny.ppm
        whole tiny.ppm
    done

    # By ending, in turn; a full disk; a file that may not grow.
    set -- .png .ppm .p3.ppm .pfm
    shift $turn; turn=$(((turn + 1) % 4))
    rm -rf build
    run 0 --quick --size 96x72 --out "picture$1" --seed 3
    whole "picture$1"
    if [ ! -d build ]; then ok; else no "--out draws other pictures, too"; fi
    if grep -q '^  --samples N' help; then  # --quick takes few, unless it is told how many
        run 0 --quick --size 96x72 --out "many$1" --seed 3 --samples 25
        if cmp -s "many$1" "picture$1"; then no "--samples is not heeded"; else ok; fi
        if [ "$name" = 02_camera ]; then  # squares only, and it says so
            if [ ! -s err ]; then ok; else no "--samples 25: $(cat err)"; fi
            run 0 --quick --size 9x7 --out "many$1" --samples 15
            if grep -q -e "--samples 15: 9" err; then ok; else no "--samples 15 becomes 9, unannounced"; fi
        fi
    fi
    if [ -c /dev/full ]; then  # Linux alone has it
        ln -s /dev/full full.ppm
        run 1 --quick --size 96x72 --out full.ppm
        if grep -q "full.ppm: cannot write: No space left" err; then ok; else no "$(cat err)"; fi
        if [ -L full.ppm ]; then ok; else no "the link to the full disk is gone"; fi
    fi
    echo old >old.ppm
    (ulimit -f 4; "$program" --quick --size 96x72 --out old.ppm >out 2>err)
    status=$?
    if [ $status -eq 1 ] && grep -q "old.ppm: cannot write: " err; then ok
    else no "a file that may not grow: $status, $(cat err)"; fi
    if [ "$(cat old.ppm)" = old ]; then ok; else no "the old picture is gone"; fi
    no_part
    if [ "$turn" -eq 2 ] && [ -c /dev/full ]; then
        run 1 --quick --size 96x72 --csv /dev/full
        if grep -q "/dev/full: cannot write: No space left" err; then ok; else no "$(cat err)"; fi
        "$program" --quick --size 96x72 >/dev/full 2>err
        status=$?
        if [ $status -eq 1 ] && grep -q "standard output: cannot write" err; then ok
        else no "a table to a full disk: $status, $(cat err)"; fi
    fi

    # Ctrl-C: a whole picture and exit 130, unless it was too early or all was done.
    for seconds in 0.03 0.1 0.2 0.5 1 2 4 8 16; do
        interrupt $seconds
        [ -f big.ppm ] && break
    done
    if [ $status -eq 130 ] || [ $status -eq 0 ]; then ok; else no "Ctrl-C ended with $status"; fi
    whole big.ppm
    no_part
    cd "$root" || exit 1
done
# Models that make no view are named; what is no file is no library; nothing is written where one of two may not be;
# where rays are dear there are fewer of them, or it is refused, and said.
mkdir "$scratch/models" && cd "$scratch/models" || exit 1
printf 'v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n' >point.obj
printf 'v 1e308 1 1\nv 1 -1e308 1\nv 1 1 1e308\nf 1 2 3\n' >far.obj
printf 'mtllib mine.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0.2\nusemtl a\nf 1 2 3\n' >in.obj
printf 'newmtl a\nKd 1 0 0\n' >mine.mtl
sed 's,mine.mtl,/dev/zero,' in.obj >zero.obj
sed 's,mine.mtl,.,' in.obj >folder.obj
awk 'BEGIN { print "v 0 0 0\nv 1 0 0\nv 0 1 0.2"; while (n++ < 20000) print "f 1 2 3" }' >pile.obj
tells() { if grep -q -e "$2" "$1"; then ok; else no "$1 lacks '$2': $(head -c 300 "$1")"; fi; }
for name in 07_mesh 10_grid 11_octree 12_kdtree 13_bsp 14_bvh 15_wide_bvh 17_compare 26_path_tracer 27_effects; do
    program=$BUILD/$name
    [ -x "$program" ] || continue
    for model in point far; do
        case $name$model in  # which give a point and its surroundings a size
        07_meshpoint | 27_effectspoint) run 0 --quick --size 48x36 $model.obj ;;
        *) run 2 --quick --size 48x36 $model.obj; tells err "^$name: $model.obj:" ;;
        esac
    done
    case $name in
    07_mesh)
        run 0 --quick --size 48x36 zero.obj; tells err "zero.obj: mtllib /dev/zero: no such file"
        run 0 --quick --size 48x36 folder.obj; tells err "folder.obj: mtllib .: no such file"
        run 2 in.obj --save mine.obj; tells err "mine.mtl: not replaced"
        if [ ! -e mine.obj ]; then ok; else no "a mesh without its materials"; fi
        run 0 in.obj --save other.obj
        if [ -s other.obj ] && [ -s other.mtl ]; then ok; else no "no mesh with materials"; fi ;;
    10_grid | 11_octree | 12_kdtree | 13_bsp | 14_bvh | 15_wide_bvh)
        run 0 --quick --size 96x72 --out pile.ppm pile.obj
        tells out "a ray takes .* tests: one for .* pixels instead of"; whole pile.ppm
        run 0 --quick --size 96x72 --out pile.ppm in.obj
        if grep -q "instead of" out; then no "fewer rays of one triangle"; else ok; fi ;;
    26_path_tracer)
        run 0 --quick --size 48x36 in.obj
        if grep -q "used here" err; then no "Kd is not used: $(cat err)"; else ok; fi
        if grep -q "instead of" out; then no "fewer samples of one triangle"; else ok; fi
        run 2 --quick --size 640x640 pile.obj; says "pile.obj: a ray takes "; says "--samples 1 draws"
        run 0 --quick --size 8x6 pile.obj; tells out "1 samples a pixel instead of 4"
        run 0 --quick --size 8x6 --samples 2 pile.obj
        if grep -q "instead of" out; then no "--samples is not heeded"; else ok; fi ;;
    27_effects)
        run 0 --quick --size 8x6 --samples 3; tells out "^# 3 samples a pixel"
        run 2 in.obj --mesh point.obj; says "in.obj and point.obj: one file at a time" ;;
    esac
done
# What holds many of them (together.sh), called by a name that is none of theirs.
cd "$scratch" || exit 1
for name in shapes structures light paths; do
    program=$BUILD/$name
    if [ -x "$program" ]; then run 2 --help; says "knows by its name which of these it is, so keep the name: "; fi
done
cd "$root" || exit 1
name=cli.sh
if [ "$failed" -gt 0 ] || [ "$passed" -gt 0 ]; then :; else no "no program was found"; fi
report
