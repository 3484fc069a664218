#!/bin/sh
# The tables in the pages are what the programs print: for each block of README.md and MEASURED.md that
# begins with a title "# ..." and a line "# ...; real = ..", the program of the chapter must print a table
# of that title and precision, with the same header, the same rows and the same cells, but for those that
# are times. FULL=1: the programs run with --full, and every table must be found; otherwise those that
# the default run prints are compared. BUILD names the directory of the programs, JOBS how many at a time.
passed=0 failed=0
ok() { passed=$((passed + 1)); }
no() { failed=$((failed + 1)); echo "pages.sh: FAILED: $1"; }
root=$PWD
case ${BUILD:=build} in /*) ;; *) BUILD=$root/$BUILD ;; esac
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT

# tables FILE: each line "title<TAB>real<TAB>header<TAB>row<TAB>row..", cells divided by |, timed ones as *
tables() {
    tr -d '\r' <"$1" | awk -v page="${2:-}" '
        function cells(line) { gsub(/^ +| +$/, "", line); gsub(/   */, "|", line); return line }
        # A column of times, or of what follows from them; in a table of times all but the first.
        function timed(name) {
            return name ~ /time|\[(n|u|m)?s[] \/]|\/s$|ns\/|per second|ratio|efficiency|pays|front|\[time/ }
        function mask(line,   n, c, i, out) {
            n = split(line, c, "|"); out = c[1]
            for (i = 2; i <= n; i++)
                out = out "|" (hidden[i] || (all && i > 1) ? (c[i] == "-" ? "-" : "*") : c[i])
            return out }
        function flush() { if (title != "" && body != "") print title "\t" real "\t" body
                           title = ""; body = ""; state = 0 }
        { line = $0; sub(/^    /, "", line) }
        state == 2 && line ~ /^#|^ *$|^```/ { flush() }
        state == 2 { body = body "\t" mask(cells(line)); next }
        state == 1 && line ~ /^# .*real = / {
            real = line; sub(/.*real = /, "", real); sub(/[^a-z].*/, "", real); state = 3; next }
        state == 3 { header = cells(line); n = split(header, h, "|"); delete hidden
                     for (i = 1; i <= n; i++) hidden[i] = timed(h[i])
                     all = title ~ /\[ns\]|[Nn]anoseconds|[Mm]illiseconds|[Ss]econds|: time/
                     body = header; state = 2; next }
        line ~ /^# / { title = line; state = 1; next }
        { state = 0 }
        END { flush() }'
}

# differ PAGE OUTPUT: what the page says and the output does not; with FULL also what is not printed
differ() {
    tables "$1" >"$scratch/said"; tables "$2" >"$scratch/printed"
    awk -F'\t' -v full="${FULL:-}" -v real="${REAL:-double}" '
        NR == FNR { seen[$1, $2] = seen[$1, $2] $0 "\n"; next }
        $2 != real { next }
        !(($1, $2) in seen) { if (full) print "MISSING\t" $1; next }
        index(seen[$1, $2], $0 "\n") { print "SAME\t" $1; next }
        { split(seen[$1, $2], p, "\n"); n = split($0, a, "\t"); m = split(p[1], b, "\t"); why = ""
          for (i = 3; i <= n && why == ""; i++) if (a[i] != b[i]) why = a[i] "  <>  " b[i]
          if (why == "") why = (m - 2) " lines printed, " (n - 2) " said"
          print "OTHER\t" $1 ": " why }' "$scratch/printed" "$scratch/said"
}

# The comparison sees what it is there to see.
printf '    # A\n    # x; real = double\n    method  error  time [ns]\n    naive     0.5       12\n' >"$scratch/page"
printf '# A\n# y; real = double\nmethod  error  time [ns]\nnaive     0.5       99\n\n' >"$scratch/same"
sed 's/0\.5/0.6/' "$scratch/same" >"$scratch/other"
sed 's/naive/robust/' "$scratch/same" >"$scratch/row"
seen=$(for f in same other row; do differ "$scratch/page" "$scratch/$f" | cut -f1; done | tr '\n' ' ')
if [ "$seen" = "SAME OTHER OTHER " ]; then ok; else no "two planted differences, seen: $seen"; fi

# Programs cut short, or with another compiler's libm, would print other numbers.
if [ -n "${CHECK_DIVISOR:-}" ]; then echo "pages.sh: $passed passed, $failed failed"; exit $failed; fi

names=$(cd "$root/chapters" && printf "%s\n" [0-9]*_*)
[ -n "${ONLY:-}" ] && names=$ONLY
run_one() {
    mkdir -p "$scratch/run/$1" && cd "$scratch/run/$1" || return
    "$BUILD/$1" ${FULL:+--full} >"$scratch/run/$1.out" 2>"$scratch/run/$1.err" </dev/null ||
        echo "$1 ended with $?: $(head -n 1 "$scratch/run/$1.err")" >>"$scratch/run/failed"
}
mkdir "$scratch/run"; : >"$scratch/run/failed"
at_work=0
for name in $names; do
    [ -x "$BUILD/$name" ] || { no "$name is not built"; continue; }
    cat "$root/chapters/$name"/*.md | grep -q "real = ${REAL:-double}" || continue
    run_one "$name" &
    at_work=$((at_work + 1))
    if [ $at_work -ge "${JOBS:-2}" ]; then wait; at_work=0; fi
done
wait
[ -s "$scratch/run/failed" ] && no "$(cat "$scratch/run/failed")"
for name in $names; do
    for page in README.md MEASURED.md; do
        if ! [ -f "$root/chapters/$name/$page" ] || ! [ -f "$scratch/run/$name.out" ]; then continue; fi
        differ "$root/chapters/$name/$page" "$scratch/run/$name.out" >"$scratch/found"
        passed=$((passed + $(grep -c '^SAME' "$scratch/found")))
        while IFS='	' read -r verdict text; do
            [ "$verdict" = SAME ] || no "$name/$page: $verdict: $text"
        done <"$scratch/found"
        # A table without its line "real = .." could not be compared: none may stand there.
    done
done
echo "pages.sh: $passed passed, $failed failed"
[ "$failed" -eq 0 ]
