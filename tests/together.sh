#!/bin/sh
# Many programs as one, so that what they include is compiled once: sh tests/together.sh PROGRAMS.. >x.c
# Programs as in build/: 04_triangle, 04_triangle_first, test_04_a. It is the one by whose name it is called, so that
# a copy or a link of each name belongs to it. First come the headers of chapters and common/ that they include, then
# their texts, in which what a program itself defines bears its name, too: `static int f(void)` is f_test_04_a.
# (Not what is also the name of a member that it declares: the compiler says so.) TEXTS=O0: gcc optimises
# the headers, but not these texts.
cd "$(dirname "$0")/.." || exit 1
file_of() {
    case $1 in test_*) echo "tests/${1#test_}.c" ;; *_first) echo "chapters/${1%_first}/first.c" ;;
    *) echo "chapters/$1/main.c" ;; esac
}
for p in "$@"; do
    file=$(file_of "$p")
    case $file in tests/*) of='\.\.\/' ;; *) of= ;; esac  # what tests share, tests/*.h, may differ in each
    sed -n "s/^#include \"\($of.*\)\"/#include \"$(dirname "$file" | sed 's/\//\\\//g')\/\1\"/p; /^#include </p" "$file"
done | awk '!seen[$0]++'
[ -z "${TEXTS:-}" ] || printf '#if defined __GNUC__ && !defined __clang__\n#pragma GCC optimize ("%s")\n#endif\n' "$TEXTS"
for p in "$@"; do
    file=$(file_of "$p")
    awk -v p="$p" -v folder="$(dirname "$file")" '
        function own(name) {  # the last word before ( [ = ; or ,
            sub(/struct [{].*[}]/, "", name); sub(/ *[[(=;,].*/, "", name); sub(/.*[ *]/, "", name)
            if (name ~ /^[A-Za-z_]/) names[name] }
        function renamed(line,  out, word, before) {  # but for members, and what is said
            while (match(line, /"([^"\\]|\\.)*"|[A-Za-z_][A-Za-z_0-9]*|[^A-Za-z_"]+|"/)) {
                word = substr(line, 1, RLENGTH); line = substr(line, 1 + RLENGTH)
                out = out word (word in names && before !~ /([.]|->)$/ ? "_" p : "")
                before = word }
            return out }
        NR == FNR && /^#define / { sub(/\(.*/, "", $2); macros[$2] }
        NR == FNR && /^enum [{]/ { gsub(/enum [{]|[}];/, ""); n = split($0, e, ","); for (i = 1; i <= n; i++) own(e[i]) }
        NR == FNR && /^static / { sub(/__attribute__ *\(\([^)]*\)\)/, ""); own($0) }
        NR == FNR && (/^typedef .*;$/ && !/[(][*]/ || /^} [a-z_0-9]+(;|\[)/) { own($0) }
        NR == FNR { next }
        FNR == 1 { names["main"]; print "#line 1 \"" FILENAME "\"" }
        /^#include "/ { sub(/"/, "\"" folder "/"); print; next }
        { print renamed($0) }
        END { for (n in macros) print "#undef " n }' "$file" "$file"
done
cat <<'END'
#include <stdio.h>
#include <string.h>
int main(int argc, char **argv)
{
    const char *path = argc > 0 ? argv[0] : "", *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
END
for p in "$@"; do
    case $p in test_*) with= ;; *) with='argc, argv' ;; esac
    printf '    if (strcmp(name, "%s") == 0) return main_%s(%s);\n' "$p" "$p" "$with"
done
printf '    fprintf(stderr, "%%s: knows by its name which of these it is, so keep the name: %s\\n", name);\n    return 2;\n}\n' "$*"
