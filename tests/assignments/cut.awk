# Cuts functions out of a header. -v names="f g"; -v what=
#   take   prints these functions, each with the comment in front of it
#   stub   the same with another body: an answer that is defined, and wrong: false, or zeros
#   rest   prints all else; in place of the first function stands -v instead="LINE"
# Functions begin with `static inline`, and end with a line "}" or on their own line.
function flush() { if (held != "") { if (what == "rest") printf "%s", held; held = "" } }
# Of what returns nothing, all that the parameters point to becomes 0.
function body(type,   s, p) {
    if (type == "void") {
        sub(/^[^(]*\(/, "", signature)
        while (match(signature, /\*[a-z_0-9]+/)) {
            p = substr(signature, RSTART, RLENGTH); signature = substr(signature, RSTART + RLENGTH)
            s = s (s == "" ? "    " : ", ") p " = 0"
        }
        return s ";"
    }
    if (type == "bool") return "    return false;"
    if (type ~ /^(int|real|double)$/) return "    return 0;"
    if (type == "vec3") return "    return vec(0, 0, 0);"
    return "    return (" type "){0};"
}
function taken(   i, n, list) {
    n = split(names, list, " ")
    for (i = 1; i <= n; i++) if (index($0, list[i] "(") && $0 ~ ("[ *]" list[i] "\\(")) return 1
    return 0
}
/^static inline .*\(/ && !inside && taken() {
    found++
    type = $3
    if (what == "rest") { if (found == 1) print instead }
    else { if (found > 1) print ""; printf "%s", held }
    held = ""
    inside = 1; signature = ""; begun = 0
}
inside {
    if (what == "take") print
    if (what == "stub" && !begun) {
        line = $0
        if (line ~ /\{.*\}[ \t]*$/) { sub(/[ \t]*\{.*/, "", line); begun = 1 }
        if ($0 == "{") begun = 1
        else { print line; signature = signature line }
        if (begun) print "{\n" body(type) "  /* your code */\n}"
    }
    if ($0 == "}" || $0 ~ /^static inline .*\{.*\}[ \t]*$/) { inside = 0; gone = 1 }
    next
}
# A comment is held until it is known what follows it. One empty line goes with a function.
gone && /^$/ { gone = 0; if (found > 1) next }
{ gone = 0 }
/^\/\*/ { flush(); held = $0 "\n"; comment = $0 !~ /\*\//; if (what != "rest" && /^\/\* ---/) held = ""; next }
comment { held = held $0 "\n"; if (/\*\//) comment = 0; next }
held != "" && !/^static inline/ { flush() }
held != "" { flush() }
what == "rest" { print }
END { flush(); if (!found) exit 3 }
