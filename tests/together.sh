#!/bin/sh
# Many tests as one program, so that what they include is compiled once: sh tests/together.sh NAMES.. >x.c
# It runs that test by whose name it is called: a link test_04_a to it runs 04_a. First come the headers of chapters
# and common/. In each test then what it defines itself bears its name, too: `static int f(void)` is f_04_a.
# (Not what is also the name of a member that the test uses: the compiler says so. So with enumerators: each is one.)
cd "$(dirname "$0")" || exit 1
for t in "$@"; do
    sed -n 's/^#include "\(\.\.\/.*\)"/#include "tests\/\1"/p; /^#include </p' "$t.c"
done | awk '!seen[$0]++'
for t in "$@"; do
    awk -v t="$t" '
        function own(name) {  # the last word before ( [ = ; or ,
            sub(/struct [{].*[}]/, "", name); sub(/ *[[(=;,].*/, "", name); sub(/.*[ *]/, "", name)
            if (name ~ /^[A-Za-z_]/) names[name] }
        /^#define / { name = $2; sub(/\(.*/, "", name); macros[name] }
        /^static / { sub(/__attribute__ *\(\([^)]*\)\)/, ""); own($0) }
        /^typedef .*;$/ && !/[(][*]/ { own($0) }
        /^} [a-z_0-9]+(;|\[)/ { own($0) }
        END { for (n in names) print "#define " n " " n "_" t
              print "#define main main_" t "\n#include \"tests/" t ".c\"\n#undef main"
              for (n in names) print "#undef " n
              for (n in macros) print "#undef " n }' "$t.c"
done
printf 'int main(int argc, char **argv)\n{\n    const char *name = argc > 0 ? strrchr(argv[0], %s) : NULL;\n' "'/'"
for t in "$@"; do echo "    if (name && strcmp(name, \"/test_$t\") == 0) return main_$t();"; done
printf '    return 2;\n}\n'
