#!/bin/sh
# shellcheck disable=SC2016
# Names in the tree: no two headers, laboratories included, define the same guard, type, macro, function or
# enumerator; what a header's contract (its first comment) calls exists, with so many arguments; and what the map
# and the notes name exists.
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

# defined DIR: "kind name arguments file" for each guard, type, macro, function and enumerator (an enum's constant,
# but for those within a function) of the headers below DIR
defined() {
    headers "$1" | xargs awk "$count"'
        function said(kind, name, n) { print kind, name, n, FILENAME }
        # enumerators TEXT: of an enum, from behind its brace; commas within parentheses or quotes part none
        function enumerators(text,   i, c, depth, item) {
            gsub(/\047[^\047]*\047|"[^"]*"/, "0", text); sub(/[}].*/, "", text); text = text ","
            for (i = 1; i <= length(text); i++) {
                c = substr(text, i, 1)
                if (c == "(") depth++
                if (c == ")") depth--
                if (c != "," || depth) { item = item c; continue }
                if (match(item, /^[ \t]*[A-Za-z_][A-Za-z_0-9]*[ \t]*(=|$)/)) {
                    sub(/^[ \t]*/, "", item); sub(/[ \t=].*/, "", item); said("enumerator", item, 0) }
                item = "" } }
        # EIGHT(name) is a name in each dialect, EIGHT_FILE what is compiled in them (15)
        /^#define EIGHT_FILE/ { next }
        !/^#/ { while (match($0, /EIGHT\([a-z_0-9]+\)/))
            $0 = substr($0, 1, RSTART - 1) substr($0, RSTART + 6, RLENGTH - 7) substr($0, RSTART + RLENGTH) }
        FNR == 1 { open = listed = ""; below = within = remark = 0 }
        {   # without comments; enums of a function, whose brace stands alone or behind its arguments, are its own
            code = $0
            if (remark) { if (index(code, "*/")) { sub(/^.*\*\//, "", code); remark = 0 } else code = "" }
            gsub(/\/\*([^*]|\*[^\/])*\*\//, "", code)
            if (index(code, "/*")) { sub(/\/\*.*/, "", code); remark = 1 }
            if (code ~ /^[{]/) within = 1
            if (code ~ /^[}]/) within = 0
            if (listed != "") listed = listed " " code
            else if (!within && match(code, /(^|[ \t])enum( [a-z_0-9]+)? *[{]/) && substr(code, 1, RSTART) !~ /[)]/)
                listed = substr(code, RSTART + RLENGTH) " "
            if (listed ~ /[}]/) { enumerators(listed); listed = "" } }
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
            sub(/\[.*/, "", name); sub(/^__attribute__.*\) */, "", name)
            if (name == "") below = 1; else said("type", name, 0); next }
        below { below = 0; name = $1; sub(/;.*/, "", name); said("type", name, 0); next }
        /^} [a-z_0-9]+;/ { name = $2; sub(/;.*/, "", name); said("type", name, 0) }
        /^(struct|union) [a-z_0-9]+ *[{]/ { name = $2; sub(/[{].*/, "", name); said("type", name, 0) }
        /^((__attribute__.* )?static|[a-z]+_inline) (inline |_Noreturn |__attribute__[^ ]* )*[a-zA-Z_]/ && /^[^=]*\(/ {
            name = $0; sub(/__attribute__\(\([^)]*\)\)/, "", name); sub(/__attribute__\(\([^)]*\([^)]*\)\)\)/, "", name)
            rest = name; sub(/\(.*/, "", name); sub(/.*[ *]/, "", name); sub(/^[^(]*\(/, "", rest)
            if (name == "") next  # a pointer to a function
            n = count(rest)
            if (n >= 0) said("function", name, rest ~ /\.\.\./ ? -1 : n); else open = rest }'
}

# clashes: from "kind name n file": what two headers define, be it a type in one, a function in the other
clashes() {
    sort -u | awk '
        { key = $1 == "guard" ? $1 " " $2 : $2
          if (seen[key, $4]++) next
          files[key] = files[key] " " $4; n[key]++ }
        END { for (key in n) if (n[key] > 1) print key ":" files[key] }' | sort
}

# bare: from "kind name n file": guards of one word (SPHERE_H), of which a chapter has one, its concept's
bare() {
    awk '$1 == "guard" && $2 ~ /^[A-Z0-9]+_H$/ && match($4, /chapters\/[^\/]*\//) {
             c = substr($4, RSTART, RLENGTH); n[c]++; said[c] = said[c] " " $2 }
         END { for (c in n) if (n[c] > 1) print c ":" said[c] }'
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

# lost DIR: headers, and names with a _, that chapters/README.md and the notes below DIR put in backticks, and no
# file has; MINE=my.h is the reader's own
lost() {
    (cd "$1" && find common chapters tests -name '*.[ch]' >"$scratch/files" && {
        sed 's|.*/||' "$scratch/files"; xargs cat <"$scratch/files" | grep -oE '[A-Za-z_][A-Za-z_0-9]*'; } |
        LC_ALL=C sort -u >"$scratch/has"
    cd "$1" && grep -ohE '`[^`]*`' chapters/README.md chapters/notes/*.md | grep -v MINE= |
        grep -oE '[a-z][a-z0-9_]*\.h|[a-z][a-z0-9]*_[a-z0-9_]+' | LC_ALL=C sort -u | LC_ALL=C comm -23 - "$scratch/has")
}

defined . >"$scratch/defined"
if [ "$(wc -l <"$scratch/defined")" -gt 1000 ]; then ok; else no "hardly a name was found"; fi
clashes <"$scratch/defined" >"$scratch/clashes"
if [ -s "$scratch/clashes" ]; then no "defined by two headers: $(cat "$scratch/clashes")"; else ok; fi
bare <"$scratch/defined" >"$scratch/bare"
if [ -s "$scratch/bare" ]; then no "guards without the chapter's prefix: $(cat "$scratch/bare")"; else ok; fi
promises . "$scratch/defined" >"$scratch/promises"
if [ -s "$scratch/promises" ]; then no "contracts: $(cat "$scratch/promises")"; else ok; fi
gone=$(lost .)
if [ -z "$gone" ]; then ok; else no "the map or the notes name what does not exist: $gone"; fi
if [ "$(wc -l <"$scratch/has")" -gt 1000 ]; then ok; else no "hardly a word was found"; fi

# The rules see what they are there to see, and no more: guard, type, tag, function, draw, thing_kind, a_few and a_most clash.
mkdir -p "$scratch/tree/common" "$scratch/tree/chapters/01_a/lab" "$scratch/tree/chapters/02_b/lab"
cat >"$scratch/tree/chapters/01_a/a.h" <<'END'
/* a.h: a thing.
 *   thing_make(1, 2)   thing_free(&t)   thing_two(a, b), thing_any(..) */
#ifndef A_H
typedef struct { int x; } thing;
typedef struct { int x; } __attribute__((aligned(64))) thing_kind;
typedef struct { int x; } thing_tag;
#ifndef C_H
enum { a_few = 3, a_most = MOST(a_few, own) };  /* not enum { in_a_comment, */
static inline thing thing_make(int x,
                               int y) { return (thing){x + y}; }
static inline void thing_free(thing *t, int n) { t->x = n; }
static inline void helper(void) { enum { own = 1 }; }
#endif
END
printf 'static inline void draw(void)\n{\n    enum { own = 1 };\n}\n' >"$scratch/tree/chapters/01_a/lab/l.h"
cat >"$scratch/tree/chapters/02_b/lab/b.h" <<'END'
#ifndef A_H
typedef enum { X } thing;
typedef enum {
    B_COMMA = ',', a_few,  /* enum { in_a_comment, */
    a_most
} b_kind;
typedef struct { enum { B_SMALL, MOST = (B_COMMA, X) } size; b_kind x, y; }
    thing_kind;
static inline int helper(void) { return 0; }
struct thing_tag { int x; };
static inline void draw(int own) { (void)own; }
END
seen=$(defined "$scratch/tree" | tee "$scratch/planted" | clashes | wc -l)
if [ "$seen" -eq 8 ]; then ok; else no "8 clashes were planted, $seen seen"; fi
if [ "$(grep -c '^enumerator' "$scratch/planted")" -eq 8 ]; then ok; else no "8 enumerators were planted"; fi
if [ "$(bare <"$scratch/planted")" = "chapters/01_a/: A_H C_H" ]; then ok; else no "two bare guards were planted"; fi
seen=$(promises "$scratch/tree" "$scratch/planted" | wc -l)
if [ "$seen" -eq 3 ]; then ok; else no "3 false promises were planted, $seen seen"; fi
mkdir -p "$scratch/tree/chapters/notes" "$scratch/tree/tests"
printf 'of no_code: `thing_make`, `lab/l.h`; gone: `thing_lost`, `made.h`; `MINE=my.h`\n' >"$scratch/tree/chapters/README.md"
printf 'gone: `(1.2) a_third(x)`, `b.h`\n' >"$scratch/tree/chapters/notes/a.md"
seen=$(lost "$scratch/tree" | wc -l)
if [ "$seen" -eq 3 ]; then ok; else no "3 names that are gone were planted, $seen seen"; fi

report
