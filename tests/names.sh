#!/bin/sh
# shellcheck disable=SC2016
# Names in the tree: no two headers define the same guard, type or macro, nor a function that a concept or
# common/ defines; and what a header's contract (its first comment) calls exists, with so many arguments.
. tests/check.sh

headers() { find "$1/common" "$1/chapters" -name '*.h' | sort; }

# Of the arguments in a text that begins behind their parenthesis; -1: it does not end.
count='function count(list,   i, c, depth, n) {
    n = list ~ /^ *(void)? *\)/ ? 0 : 1; depth = 0
    for (i = 1; i <= length(list); i++) {
        c = substr(list, i, 1)
        if (c ~ /[({[]/) depth++
        if (c ~ /[]})]/ && depth-- == 0) return n
        if (c == "," && depth == 0) n++
    }
    return -1 }'

# defined DIR: "kind name arguments file" for each guard, type, macro and function of the headers below DIR
defined() {
    headers "$1" | xargs awk "$count"'
        function said(kind, name, n) { print kind, name, n, FILENAME }
        # EIGHT(name) is a name in each dialect, EIGHT_FILE what is compiled in them (15)
        /^#define EIGHT_FILE/ { next }
        !/^#/ { while (match($0, /EIGHT\([a-z_0-9]+\)/))
            $0 = substr($0, 1, RSTART - 1) substr($0, RSTART + 6, RLENGTH - 7) substr($0, RSTART + RLENGTH) }
        FNR == 1 { open = "" ; inside = 0 }
        open != "" { open = open $0; if ((n = count(open)) >= 0) { said("function", name, n); open = "" } next }
        /^STRUCTURE_VERBS(_OF)?\(/ { name = $0; gsub(/.*\(|[,)].*/, "", name)  # makes these four
            said("function", name "_hit", 3); said("function", name "_hit_counted", 4)
            said("function", name "_occluded", 2); said("function", name "_occluded_counted", 3) }
        /^#ifndef [A-Z0-9_]+_H$/ { said("guard", $2, 0) }
        /^#define [A-Za-z_]/ && !/_H$/ {
            name = $2; sub(/\(.*/, "", name); rest = $0; sub(/^#define [A-Za-z_0-9]+/, "", rest)
            n = rest ~ /^\(/ ? count(substr(rest, 2)) : 0
            if (rest ~ /^\([^)]*\.\.\./) n = -1
            said("macro", name, n) }
        /^typedef .*;/ && (!/{/ || /}/) {
            name = $0; sub(/ *\/\*.*/, "", name)
            if (name ~ /}/) { sub(/.*} */, "", name); sub(/;.*/, "", name) }
            else if (name ~ /\(\*/) { sub(/.*\(\* */, "", name); sub(/\).*/, "", name) }
            else { sub(/;.*/, "", name); sub(/\(.*/, "", name); sub(/.*[ *]/, "", name) }
            sub(/\[.*/, "", name); said("type", name, 0) }
        /^} [a-z_0-9]+;/ { name = $2; sub(/;.*/, "", name); said("type", name, 0) }
        /^((__attribute__.* )?static|[a-z]+_inline) (inline |_Noreturn |__attribute__[^ ]* )*[a-zA-Z_]/ && /^[^=]*\(/ {
            name = $0; sub(/__attribute__\(\([^)]*\)\)/, "", name); sub(/__attribute__\(\([^)]*\([^)]*\)\)\)/, "", name)
            rest = name; sub(/\(.*/, "", name); sub(/.*[ *]/, "", name); sub(/^[^(]*\(/, "", rest)
            n = count(rest)
            if (n >= 0) said("function", name, rest ~ /\.\.\./ ? -1 : n); else open = rest }'
}

# clashes: from "kind name n file": what two headers define
clashes() {
    sort -u | awk '
        { k = $1 == "guard" || $1 == "function" ? $1 : "type"; key = k " " $2
          if (seen[key, $4]++) next
          files[key] = files[key] " " $4; n[key]++
          if ($4 !~ /\/lab\//) concept[key] = 1 }
        END { for (key in n) if (n[key] > 1 && (key !~ /^function/ || concept[key])) print key ":" files[key] }' | sort
}

# promises DIR DEFINED: calls in contracts of what does not exist, or takes another number of arguments
promises() {
    headers "$1" | xargs awk "$count"'
        FILENAME == ARGV[1] { if ($1 == "function" || $1 == "macro") takes[$2] = takes[$2] " " $3; next }
        FNR == 1 { contract = 1; text = "" }
        contract { line = $0; gsub(/"[^"]*"/, "s", line); text = text "\n" line }
        contract && /\*\// { contract = 0
            while (match(text, /[a-z][a-z0-9]+_[a-z0-9_]+\(/)) {
                before = RSTART > 1 ? substr(text, RSTART - 1, 1) : " "
                name = substr(text, RSTART, RLENGTH - 1); text = substr(text, RSTART + RLENGTH)
                if (before ~ /[A-Za-z0-9_.>]/) continue
                end = index(text, ")"); list = text; gsub(/\n *\*/, " ", list)
                if (list ~ /^[^)]*\.\./) many = 1; else many = 0
                n = count(list)
                if (!(name in takes)) print FILENAME ": " name " does not exist"
                else if (!many && takes[name] !~ (" " n "( |$)") && takes[name] !~ / -1/)
                    print FILENAME ": " name " takes" takes[name] " arguments, not " n
            } }' "$2"
}

defined . >"$scratch/defined"
if [ "$(wc -l <"$scratch/defined")" -gt 1000 ]; then ok; else no "hardly a name was found"; fi
clashes <"$scratch/defined" >"$scratch/clashes"
if [ -s "$scratch/clashes" ]; then no "defined by two headers: $(cat "$scratch/clashes")"; else ok; fi
promises . "$scratch/defined" >"$scratch/promises"
if [ -s "$scratch/promises" ]; then no "contracts: $(cat "$scratch/promises")"; else ok; fi

# Both rules see what they are there to see.
mkdir -p "$scratch/tree/common" "$scratch/tree/chapters/01_a/lab" "$scratch/tree/chapters/02_b/lab"
cat >"$scratch/tree/chapters/01_a/a.h" <<'END'
/* a.h: a thing.
 *   thing_make(1, 2)   thing_free(&t)   thing_two(a, b), thing_any(..) */
#ifndef A_H
typedef struct { int x; } thing;
static inline thing thing_make(int x,
                               int y) { return (thing){x + y}; }
static inline void thing_free(thing *t, int n) { t->x = n; }
static inline void helper(void) { }
#endif
END
printf '#ifndef A_H\ntypedef enum { X } thing;\nstatic inline int helper(void) { return 0; }\n' \
    >"$scratch/tree/chapters/02_b/lab/b.h"
seen=$(defined "$scratch/tree" | tee "$scratch/planted" | clashes | wc -l)
if [ "$seen" -eq 3 ]; then ok; else no "3 clashes were planted, $seen seen"; fi
seen=$(promises "$scratch/tree" "$scratch/planted" | wc -l)
if [ "$seen" -eq 3 ]; then ok; else no "3 false promises were planted, $seen seen"; fi

report
