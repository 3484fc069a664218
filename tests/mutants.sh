#!/bin/sh
# How much do the tests see? Breaks concept headers in one place at a time, as a slip of the hand would (an
# operator, a comparison, a constant, a sign, a condition left out), builds the tests that include the
# file, runs them, and counts the mutants that none of them notices.
#   FILES="chapters/09_aabb/aabb.h .." SEED=1 N=20 sh tests/mutants.sh      make mutants FILES=.. SEED=.. N=..
# Without FILES: all concept headers. EDIT='s/64 \*/16 */': the lines that sed changes so, instead of slips.
# In a copy; the tree stays as it is. A mutant that does not compile is drawn anew. One that hangs counts as seen:
# a test that takes LIMIT seconds of processor time, or waits ten times as long, is ended; a busy machine ends
# none. A test that fails without a mutant sees nothing: it is named and left out (those that run programs want
# `make` first). What survives is printed with its line: kill it by a test, or say why it is equivalent. Not
# part of make test: a mutant takes some seconds, one that survives minutes.
root=$PWD
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT
trap 'exit 130' INT TERM
: "${SEED:=1}" "${N:=20}" "${CC:=cc}" "${LIMIT:=120}" "${EDIT:=}" "${V:=}"
flags="-std=c11 -O1 -ffp-contract=off -fno-tree-slp-vectorize -w ${REAL:+-DREAL=$REAL}"
if [ -z "$FILES" ]; then
    FILES=$(find chapters -name '*.h' ! -path '*/lab/*' ! -path '*/trials/*' ! -path '*/scenes/*' ! -name first.h | sort)
fi
for f in $FILES; do [ -r "$f" ] || { echo "mutants.sh: $f: no such file" >&2; exit 2; }; done
cp -r chapters common tests "$scratch"
cd "$scratch" || exit 1

# candidates FILE: "FILE<TAB>line<TAB>new text" for each place; comments and preprocessor lines stay.
candidates() {
    awk -v file="$1" '
        function offer(at, length_, by) {
            print file "\t" NR "\t" substr(text, 1, at - 1) by substr(text, at + length_) }
        function each(pattern, by,    from, rest, at) {
            from = 1
            while (match(substr(code, from), pattern)) {
                at = from + RSTART - 1
                offer(at, RLENGTH, by)
                from = at + RLENGTH
            } }
        BEGIN { inside = 0 }
        { text = $0; code = $0
          if (inside) { if ((at = index(code, "*/"))) { code = sprintf("%" (at + 1) "s", "") substr(code, at + 2)
                                                       inside = 0 } else next }
          while ((at = index(code, "/*"))) {
              rest = substr(code, at + 2)
              if ((end = index(rest, "*/")))
                  code = substr(code, 1, at - 1) sprintf("%" (end + 3) "s", "") substr(rest, end + 2)
              else { code = substr(code, 1, at - 1); inside = 1 }
          }
          while (match(code, /"([^"\\]|\\.)*"/))
              code = substr(code, 1, RSTART - 1) sprintf("%" RLENGTH "s", "") substr(code, RSTART + RLENGTH)
          if (code ~ /^#/ || code !~ /^[ \t]/) next
          each(" <= ", " < "); each(" < ", " <= "); each(" >= ", " > "); each(" > ", " >= ")
          each(" == ", " != "); each(" != ", " == "); each(" && ", " || "); each(" [|][|] ", " \\&\\& ")
          each(" [+] ", " - "); each(" - ", " + "); each(" [*] ", " / "); each(" / ", " * ")
          each(" [+]= ", " -= "); each(" -= ", " += ")
          each("real_min\\(", "real_max("); each("real_max\\(", "real_min(")
          each("return true;", "return false;"); each("return false;", "return true;")
          each("if \\(", "if (0 \\&\\& "); each("if \\(", "if (1 || "); each("fabs\\(", "(")
          each("[( ]0\\.5[,;) ]", " 0.25 "); each("[( ]2[,;) ]", " 3 ")
          if (code ~ /eps/ && match(code, /[0-9]+(\.[0-9]+)? \* [a-z_]*eps(ilon)?/))   # a bound, halved twice
              offer(RSTART, RLENGTH, "0.25 * " substr(text, RSTART, RLENGTH)) }' "$1" | sed 's/\\&/\&/g'
}
edited() {  # edited FILE: the same for EDIT
    sed "$EDIT" "$1" | awk -v file="$1" 'NR == FNR { old[NR] = $0; next }
        $0 != old[FNR] { print file "\t" FNR "\t" $0 }' "$1" -
}
for f in $FILES; do if [ -n "$EDIT" ]; then edited "$f"; else candidates "$f"; fi; done |
    awk -v seed="$SEED" 'BEGIN { srand(seed) } { print rand() "\t" $0 }' | sort -n | cut -f2- >order

# Who includes FILE?
for t in tests/*.c; do
    # shellcheck disable=SC2086
    $CC $flags -MM "$t" 2>/dev/null | tr -s ' ' '\n' | sed -e ':a' -e 's#[^/. ][^/]*/\.\./##' -e 'ta' -e "s#^#$t #"
done >includes

# fails TEST: does it, as the headers are now? 2: it does not compile
fails() {
    # shellcheck disable=SC2086
    $CC $flags -o mutant "$1" -lm -lpthread 2>/dev/null || return 2
    # shellcheck disable=SC3045
    ! (cd "$root" && ulimit -t "$LIMIT" && CHECK_DIVISOR=${CHECK_DIVISOR:-8} timeout "$((10 * LIMIT))" \
        "$scratch/mutant" || exit 1) >/dev/null 2>&1
}
: >sound
: >broken
# sees TEST FILE: it passes with the old FILE, so what it saw is the mutant
sees() {
    grep -qx "$1" sound && return 0
    cp "$2" held && cp "$root/$2" "$2"
    if fails "$1"; then echo "$1" >>broken; echo "fails without a mutant, left out: $1"
    else echo "$1" >>sound; fi
    cp held "$2"
    grep -qx "$1" sound
}

tried=0 seen=0
tab=$(printf '\t')
while [ "$tried" -lt "$N" ] && IFS=$tab read -r file line new <&3; do
    tests=$(awk -v f="$file" '$2 == f { print $1 }' includes)
    [ -n "$tests" ] || continue
    cp "$root/$file" "$file"
    awk -v n="$line" -v by="$(printf '%s' "$new" | sed 's/\\/\\\\/g')" 'NR == n { print by; next } { print }' \
        "$root/$file" >"$file"
    killed='' compiled=1
    for t in $tests; do
        grep -qx "$t" broken && continue
        fails "$t"
        case $? in
        2) compiled=''; break ;;
        0) if sees "$t" "$file"; then killed=$t; break; fi ;;
        esac
    done
    cp "$root/$file" "$file"
    [ -n "$compiled" ] || continue
    tried=$((tried + 1))
    if [ -n "$killed" ]; then seen=$((seen + 1)); [ -z "$V" ] || echo "$killed: $file:$line"
    else echo "survives: $file:$line: $(printf '%s' "$new" | sed 's/^ *//')"; fi
done 3<order
echo "$seen of $tried mutants seen"
