#!/bin/sh
# shellcheck disable=SC2016
# The tables in the pages are what the programs print: for each block of README.md and MEASURED.md that
# begins with a title "# ..." and a line "# ...; real = ..", the program of the chapter must print a table
# of that title and precision, with the same header, the same rows and the same cells, but for those that
# are times. FULL=1: the programs run with --full, and every table must be found; otherwise those that
# the default run prints are compared. TABLES=no: no program runs, only the form of the pages is tested.
# REAL=float: of programs built so, the tables in float, all of which must be found.
# BRIEF: programs that run without --full even then, and whose other tables are not asked for.
# KEEP, a folder by its whole path: what the programs print and their CSV are kept there, as notes.sh reads them.
# BUILD names the directory of the programs, JOBS how many at a time.
. tests/check.sh
case ${BUILD:=build} in /*) ;; *) BUILD=$root/$BUILD ;; esac

# tables FILE: each line "title<TAB>real<TAB>header<TAB>row<TAB>row..", cells divided by |, timed ones as *; without
# those below a line "$ command", which another program prints
tables() {
    tr -d '\r' <"$1" | awk -v page="${2:-}" '
        function cells(line) { gsub(/^ +| +$/, "", line); gsub(/   */, "|", line); return line }
        # A column of times, or of what follows from them; in a table of times all but the first.
        function timed(name) {
            return name ~ /time|\[(n|u|m)?s[] \/]|\/s$|ns\/|per second|ratio|efficiency|pays|front|\[time/ }
        function mask(line,   n, c, i, out) {
            n = split(line, c, "|"); out = c[1]
            for (i = 2; i <= n; i++)
                out = out "|" (hidden[i] || (all && i > 1) ? "*" : c[i])
            return out }
        function flush() { if (title != "" && body != "") print title "\t" real "\t" body
                           title = ""; body = ""; state = 0 }
        { line = $0; sub(/^    /, "", line) }
        /^```/ { fence = !fence; other = 0 }
        line ~ /^\$ / { flush(); other = 1 }
        !fence && /^[^ ]/ { other = 0 }
        other { next }
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

# differ PAGE OUTPUT REAL [FULL]: what the page says and the output does not; with FULL also what is not printed
differ() {
    tables "$1" >"$scratch/said"; tables "$2" >"$scratch/printed"
    awk -F'\t' -v full="${4:-}" -v real="$3" '
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
printf '\n    $ make other\n    # B\n    # x; real = double\n    naive  error\n    1      2\n' >>"$scratch/page"
printf '# A\n# y; real = double\nmethod  error  time [ns]\nnaive     0.5       99\n\n' >"$scratch/same"
sed 's/0\.5/0.6/' "$scratch/same" >"$scratch/other"
sed 's/naive/robust/' "$scratch/same" >"$scratch/row"
seen=$(for f in same other row; do differ "$scratch/page" "$scratch/$f" double yes | cut -f1; done |
    tr '\n' ' ')
if [ "$seen" = "SAME OTHER OTHER " ]; then ok; else no "two planted differences, seen: $seen"; fi

# What one sees of a chapter's tables without running a program: a title without its line "real = ..", or a line without
# its title; one title twice in the same precision, as when a table was written over another; a table in float that is
# nowhere in double, as a reader's program prints it; a page with tables that names no command that prints them.
form() {  # form FOLDER: a line for each fault
    awk -v number="$(basename "$1" | cut -c1-2)" '
        function block_ends() { last = title = ""; shown = 0 }
        function page_ends() { if (tables && !command) print page ": no command prints its tables"
                               tables = command = fence = 0; page = FILENAME; block_ends() }
        function table(line,   real) {
            real = last; tables++; gsub(/  +/, "|", line)
            if (title !~ /^# / || !sub(/.*; real = /, "", real) || real !~ /^(double|float)$/)
                print page ":" FNR ": no title, or no real = .., above: " line
            else if (said[title, real, line]++) print page ":" FNR ": twice in " real ": " title
            if (real == "float") float[title, line] = 1 }
        function is_twin(t,   part) { split(t, part, SUBSEP)
            if (!((part[1], "double", part[2]) in said)) print page ": said in float only: " part[1] }
        FNR == 1 { page_ends() }
        $0 ~ "(build/" number "_[a-z_]* --full|make (run|full)-" number ")" { command = 1 }
        /^```/ { fence = !fence; block_ends(); next }
        { line = $0; inside = sub(/^    /, "", line) || fence }
        !inside && !/^ *$/ { block_ends(); next }
        line ~ /^\$ / { shown = 1 }  # the command itself stands above what it printed
        last ~ /^# / && line !~ /^# | = / && line ~ /[^ ]  +[^ ]/ && !shown { table(line) }
        { title = last; last = line }
        END { page_ends(); for (t in float) is_twin(t) }' "$1"/*.md
}
# figures FOLDER [FILE]: numbers of its sentences that neither table nor program has (figures.awk says which count), that
# have no command or test beside, and of which tests/figures.txt or FILE does not say where they are from.
figures() {
    # shellcheck disable=SC2046
    awk -f tests/figures.awk "${2:-tests/figures.txt}" $(find "$1" -name '*.[ch]') $({ grep -oh 'tests/[0-9a-z_]*\.[ch]' "$1"/*.md
        ls tests/"$(basename "$1" | cut -c1-2)"_*.[ch]; } 2>/dev/null | sort -u) "$1/README.md" "$1/MEASURED.md"
}
for folder in chapters/[0-9]*_*; do
    faults=$(form "$folder"; figures "$folder")
    if [ -z "$faults" ]; then ok; else no "$folder: $faults"; fi
done
# Both see what they are there to see, and nothing else.
planted=$scratch/03_planted
mkdir "$planted" && echo 'real pi = (real)3.14159, n = 450, m = 45;  /* not 555 */' >"$planted/first.h"
printf '03_planted/README.md %s\n' '83 = 1024 / 12.3' '84 = 1024 / 12.3' '85 = 1025 / 12.3' '86 not said' '87 from afar' >"$scratch/figures.txt"
cat >"$planted/README.md" <<'EOF'
Right: 60 %, 599 thousandths, 1,024, in 1975, 640 x 480, $7.77$, `8.88`, (9.99, 9.98), RTR 26.1, 2 of 3; 450 boxes,
12 ns, 0.0123 us, 12 to 13.6 ns, 1.5 KB, 12.4 bytes, 1024 times, 83 %, 87 %.

Wrong: 61 %, 9000, 0.71, 77 rays, 1.25, 400,000, .598, and 555 of a comment. `build/03_planted --full` is no proof.
So are 450 ns, 13 ns, 13.5 to 13.6 ns, 60 bytes, 1024 ms, 12 times, 84 %, 85 %, 3.14 and 45, of code.

- `make first-03` prints 4321.
- `test_planted` of `tests/vec3.c` has 400,000, but not 8765.

    # A
    # x; real = double
    share  rays
    0.599  1024

    # D
    # x; real = double
    method  time [ns]  bytes a ray  a ray
     naive       12.3         1500     60
    robust       13.6         12.4     63
EOF
cat >"$planted/MEASURED.md" <<'EOF'
    # A
    # x; real = double
    share  rays
    599    7

    # B
    # x; real = float
    share  rays
    0.5    7

    # C
    # x
    share  rays
    0.5    7
EOF
seen="$(figures "$planted" "$scratch/figures.txt" | sed 's/.* //' | tr '\n' ' ')$(form "$planted" | sed 's/[^ ]*: //; s/ .*//' | tr '\n' ' ')"
if [ "$seen" = "61 9000 0.71 77 1.25 400,000 .598 555 450 13 13.5 60 1024 12 84 85 3.14 45 8765 86 no no twice said " ]; then ok; else no "planted faults, seen: $seen"; fi

# A page in the form of a lecture (it has a part "The idea"): its parts in order, its code word for word in
# first.h or first.c, or in the header that its fence names (```c path.h), the numbers of its formulas rising, nothing in them that a renderer would drop, no
# more words than a sitting takes, no table of more than eight rows and six columns (17 has a row a scene), and every file that
# it links to or shows is there.
lecture() {  # lecture FOLDER: a line for each fault
    awk -v folder="$1" '
        function slurp(file,   text, line) { text = ""
            while ((getline line < file) > 0) text = text line "\n"
            close(file); return text }
        BEGIN { board = slurp(folder "/first.h") "\n" slurp(folder "/first.c")
                n = split("The idea|The formulas|The code|Try it|Where it breaks|What accuracy costs|" \
                          "Only what is called for|What the notes say|Exercises|Going on", part, "|")
                for (i = 1; i <= n; i++) place[part[i]] = i }
        function compare() { if (code != "" && kind == "c" && !index(text, code))
                                 print "not in " named ": " substr(code, 1, index(code, "\n") - 1)
                             code = "" }
        function tall() { if (rows > (folder ~ /17_/ ? 11 : 8)) print "a table of " rows " rows"
                          table = rows = 0 }
        /^ *# .*; real = / { table = 1; next }
        table == 1 { sub(/^ +/, ""); table = 2
                     if (split($0, cell, /  +/) > 6) print "a table of more than six columns: " $0
                     next }
        table && /^( *$|```| *#)/ { tall() }
        table { rows++ }
        /^```/ { compare()
                 kind = kind == "" ? (/^```c( |$)/ ? "c" : "other") : ""; code = ""
                 if (kind == "c") { named = NF > 1 ? $2 : "first.h"
                                    text = NF > 1 ? slurp(folder "/" $2) : board }
                 next }
        kind != "" && /^ *$/ { compare() }  # what stands between may be left out
        kind != "" { code = code ($0 ~ /^ *$/ ? "" : $0 "\n"); next }
        /^    / { next }
        /^## / { name = substr($0, 4)
                 if (!(name in place)) print "no part of a lecture: " name
                 else if (place[name] <= last) print "out of order: " name
                 else last = place[name]
                 have[name] = 1 }
        /\$\$/ && /\\(tag|,|;|!)/ { print "a formula that some renderers drop: " $0 }
        /\$\$.*\([0-9]+\.[0-9]+\)/ { number = $0; sub(/.*\(/, "", number); sub(/\).*/, "", number)
                 split(number, at, "."); if (at[2] + 0 <= risen) print "numbers do not rise: " number
                 risen = at[2] + 0 }
        { words += NF }
        END { tall(); split("The idea|The formulas|The code|Try it|Exercises|Going on", must, "|")
              for (i in must) if (!(must[i] in have)) print "lacks: " must[i]
              if (words > 1200) print words " words: at most 1200 beside code and tables" }' "$1/README.md"
}
links() {  # links FILE: files that it shows or leads to and that are not there
    page_folder=$(dirname "$1")
    tr ')' '\n' <"$1" | sed -n 's/.*](\([^#: ]*\)\(#.*\)\{0,1\}$/\1/p' | sort -u | while read -r to; do
        [ -z "$to" ] || [ -e "$page_folder/$to" ] || echo "leads nowhere: $to"
    done
}
for page in README.md chapters/README.md chapters/*/*.md; do
    faults=$(links "$page"; grep -q '^## The idea' "$page" && lecture "$(dirname "$page")")
    if [ -z "$faults" ]; then ok; else no "$page: $faults"; fi
done
mkdir -p "$scratch/page_of" && printf '# A\n## The code\n```c\nint x;\n```\n```c first.c\nint x;\n\nint y;\n```\n## The idea\n[a](b.h)\n$$x \\, (1.2)$$\n$$y (1.1)$$\n%s%s%s\n' \
    '    # Linux; real = double' '
    a  b  c  d  e  f  g' "$(printf '\n    1%.0s' 1 2 3 4 5 6 7 8 9)" \
    >"$scratch/page_of/README.md"
printf 'int y;\n' | tee "$scratch/page_of/first.h" >"$scratch/page_of/first.c"
seen=$( (lecture "$scratch/page_of"; links "$scratch/page_of/README.md") | wc -l)
if [ "$seen" -eq 12 ]; then ok; else no "12 planted faults of a page, $seen seen"; fi

# make costs names columns and rows of tables that the pages show: a row by the cells that it begins with.
named() {  # named FILE: "CHAPTER<TAB>column or row<TAB>TEXT"
    awk '/^static const subject/ { on = 1; next } on && /^};/ { exit }
         on { all = all $0 }
         END { n = split(all, part, "\"")
               for (i = 2; i + 8 <= n; i += 10) {
                   print part[i] "\tcolumn\t" part[i + 4]
                   print part[i] "\trow\t" part[i + 6]; print part[i] "\trow\t" part[i + 8] } }' "$1"
}
shows() {  # shows CHAPTER KIND TEXT: some table of its pages does
    cat chapters/"$1"/*.md | sed -E 's/^ +//; s/  +/|/g; s/$/|/' |
        awk -v kind="$2" -v text="$3" '{ i = index($0, text); if (kind == "row" ? i == 1 : i) found = 1 }
                                       END { exit !found }'
}
named tests/costs/costs.c >"$scratch/named"
while IFS='	' read -r chapter kind text; do
    if shows "$chapter" "$kind" "$text"; then ok; else no "costs.c: no table of $chapter has the $kind $text"; fi
done <"$scratch/named"
if [ "$(wc -l <"$scratch/named")" -ge 60 ]; then ok; else no "costs.c: fewer than 60 names were read"; fi
if shows 03_sphere row 'sphere_hit|' && ! shows 03_sphere row 'here_hit|'; then ok; else no "rows of tables"; fi

# Programs cut short, or with another compiler's libm, would print other numbers.
if [ -n "${CHECK_DIVISOR:-}" ] || [ "${TABLES:-}" = no ]; then report; exit; fi

full() { case " ${BRIEF:-} " in *" $1 "*) ;; *) echo "${FULL:+--full}" ;; esac; }  # full NAME: does it run so?
names=$(cd "$root/chapters" && printf "%s\n" [0-9]*_*)
[ -n "${ONLY:-}" ] && names=$ONLY
# Those that have tables in this precision.
names=$(for name in $names; do grep -q "real = ${REAL:-double}$" "chapters/$name"/*.md && echo "$name"; done)
run_one() {
    cd "$scratch/run/$1" && ln -s "$root/chapters" chapters || return
    # shellcheck disable=SC2046
    "$BUILD/$1" $(full "$1") ${KEEP:+--csv "$KEEP/$1.csv"} >"$scratch/run/$1.out" 2>"$scratch/run/$1.err" </dev/null ||
        echo "$1 ended with $?: $(head -n 1 "$scratch/run/$1.err")" >>"$scratch/run/failed"
    if [ "$1" = 27_effects ] && [ -n "$(full "$1")" ]; then "$BUILD/27_tax" >>"$scratch/run/$1.out"; fi
}
mkdir "$scratch/run"; : >"$scratch/run/failed"
# Each worker takes the next program that nobody has taken, the longest first: 17, and then the last chapters.
longest_first=$(printf '%s\n' "$names" | sort -r | awk '/^17/ { print; next } { rest = rest $0 "\n" } END { printf "%s", rest }')
worker() {
    for name in $longest_first; do
        if [ -x "$BUILD/$name" ] && mkdir "$scratch/run/$name" 2>/dev/null; then (run_one "$name"); fi
    done
}
for name in $names; do [ -x "$BUILD/$name" ] || no "$name is not built"; done
at_work=1
while [ $at_work -lt "${JOBS:-2}" ]; do worker & at_work=$((at_work + 1)); done
worker
wait
[ -z "${KEEP:-}" ] || cp "$scratch"/run/*.out "$KEEP"
[ -s "$scratch/run/failed" ] && no "$(cat "$scratch/run/failed")"
for name in $names; do
    lines=$(grep -c '' "$scratch/run/$name.out" 2>/dev/null)
    [ -n "$(full "$name")" ] || [ "${lines:-0}" -le 30 ] || no "$name prints $lines lines, more than a screen"
    for page in README.md MEASURED.md; do
        if ! [ -f "$root/chapters/$name/$page" ] || ! [ -f "$scratch/run/$name.out" ]; then continue; fi
        [ "${REAL:-double}" = float ] && all=yes || all=$(full "$name")
        differ "$root/chapters/$name/$page" "$scratch/run/$name.out" "${REAL:-double}" "$all" >"$scratch/found"
        passed=$((passed + $(grep -c '^SAME' "$scratch/found")))
        while IFS='	' read -r verdict text; do
            [ "$verdict" = SAME ] || no "$name/$page: $verdict: $text"
        done <"$scratch/found"
    done
done
report
