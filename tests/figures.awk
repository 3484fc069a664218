# figures.awk FILE..: the figures of a chapter's sentences that stand nowhere else, each as "PAGE:LINE: FIGURE". The
# files are tests/figures.txt, the chapter's headers and programs, and its pages last.
#
# A figure has two significant digits or more; whole numbers below 28 without a unit are left (chapters are numbered so),
# and so are formulas, `code`, links, sizes as 640 x 480, references as (9.1), section 26.1, years, and the sources.
# It is known, to as many digits as are said, if
#   with a unit (12 ns, 1.5 MB, 60 %, 3.5 times, also the first of 3 to 5 ns) a cell of the pages' tables has it in a
#               column of that unit: of times, of bytes, of percent or shares (60 % for 0.599), of numbers without unit;
#   whole       a table or a block of the pages shows it, or the code has it outside comments: 17.9 million for 17900000;
#   else, and if it has two digits and is no round number, a table or a block of the pages shows it: among the numbers
#               of code any two digits are found.
# It need not be if its paragraph names a command: but not the one that prints the tables, since what that prints is
# there to be compared. If it names a test, the numbers of the tests of the chapter and of those that its pages name
# count, too; else not. What follows from these, or is nothing that the program prints, says figures.txt.

# What a page says besides figures, and that may hold digits.
function plain(text) {
    gsub(/`[^`]*`/, " ", text); gsub(/\$\$[^$]*\$\$/, " ", text); gsub(/\$[^$]*\$/, " ", text)
    gsub(/\]\([^)]*\)/, "]", text); gsub(/https?:[^ ]*/, " ", text); gsub(/<sup>[^<]*<.sup>|<[^>]*>/, " ", text)
    gsub(/\([0-9]+\.[0-9]+[a-z]?(, [0-9]+\.[0-9]+[a-z]?)*\)/, " ", text)
    gsub(/(RTR|Gems|Embree|POV-Ray|gcc|[Ee]quation|[Cc]hapter|ch\.|[Ss]ection|[Ll]ecture)[*,]* [0-9.]+(( and| to|,) [0-9.]+)*/, " ", text)
    gsub(/[0-9.]+ (x|×) [0-9.]+|\*Time:\* [0-9]+ minutes/, " ", text)
    return text
}
# The next number of `rest`: `word`, its value, half a unit of its last digit, and what stands on either side.
function next_number(   digits, exponent, decimals, zeros) {
    if (!match(rest, /[0-9]+(,[0-9][0-9][0-9])+(\.[0-9]+)?|[0-9]*\.[0-9]+(e[-+]?[0-9]+)?|[0-9]+(e[-+]?[0-9]+)?/)) return 0
    before = substr(rest, 1, RSTART - 1); word = substr(rest, RSTART, RLENGTH); rest = substr(rest, RSTART + RLENGTH)
    digits = word; gsub(/,/, "", digits); value = digits + 0; exponent = 0
    if (match(digits, /e/)) { exponent = substr(digits, RSTART + 1) + 0; digits = substr(digits, 1, RSTART - 1) }
    whole = index(digits, ".") == 0
    decimals = whole ? 0 : length(digits) - index(digits, ".")
    gsub(/\./, "", digits); sub(/^0+/, "", digits)
    zeros = whole && match(digits, /0+$/) ? RLENGTH : 0  # of 9000 two digits are said, or more
    if (zeros > length(digits) - 2) zeros = length(digits) - 2
    half = 0.5001 * 10 ^ (exponent - decimals + (zeros > 0 ? zeros : 0))
    figure = length(digits) > 1 || decimals > 1
    return 1
}
# Is it one that is asked about?
function asked() {
    if (!figure || before ~ /([A-Za-z_^]|[A-Za-z0-9]-)$/) return 0
    if (rest ~ /^[A-Za-z_]/ && rest !~ /^(x|ns|us|ms|s|B|KB|MB|GB)([^A-Za-z]|$)/) return 0
    if (whole && value < 28 && rest !~ /^ ?(%|x |times|ns|us|ms|seconds|bytes)/) return 0
    return !(whole && word !~ /,/ && value < 2030 && value > (before ~ /in $/ ? 1600 : 1950) && value != 2000)
}
# From where numbers count: of pages always; of code for whole ones, but not for 10 to 99 that are not round; of tests
# where one is named.
function near(v, h, in_tests,   i, coded) {
    coded = whole && (value >= 100 || value % 10 == 0 || value == 32 || value == 64)
    for (i = 1; i <= n; i++)
        if (have[i] >= v - h && have[i] <= v + h &&
            (of[i] == "test" ? tested : !in_tests && (of[i] == "page" || coded))) return 1
    return 0
}
function near_cell(u, v, h,   i) {
    for (i = 1; i <= cells; i++) if (unit[i] == u && cell[i] >= v - h && cell[i] <= v + h) return 1
    return 0
}
# The unit that a text begins with or, if `within`, has anywhere: s (scale: in seconds), B, %, x; "" for none.
function unit_of(text, within,   i) {
    scale = 1
    for (i = 1; i <= names; i++)
        if (text ~ ("^ ?" name[i] "([^A-Za-z]|$)") || (within && text ~ ("(^|[^A-Za-z])" name[i] "([^A-Za-z]|$)"))) {
            scale = size[i]; return measure[i] }
    return text ~ /^ ?%/ || (within && text ~ /%/) ? "%" : text ~ /^ ?(times|x |×)/ ? "x" : "" }
# So of the text behind a figure, which may be the first of several: 3 to 5 ns, 1.2, 1.3 and 1.4 ms.
function unit_behind(text) {
    while (match(text, /^(,? (to|and|or)|,|-|–) ?[0-9.]*[0-9]/)) text = substr(text, RSTART + RLENGTH)
    return unit_of(text) }
function known_cell(u) {
    if (u == "x") return near_cell("", value, half)
    return near_cell(u, value * scale, half * scale) || (u == "%" && near_cell("share", value / 100, half / 100)) }
function known(   u) {
    u = unit_behind(rest)
    if (u != "") return known_cell(u) || near(value, half, 1) || (u == "%" && near(value / 100, half / 100, 1))
    if (near(value, half)) return 1
    if (rest ~ /^ thousand/) return near(value * 1e3, half * 1e3)
    if (rest ~ /^ million/) return near(value * 1e6, half * 1e6)
    return rest ~ /^ billion/ && near(value * 1e9, half * 1e9)
}
# Does the figure (`due`, to within `off`) follow from an expression of numbers that the pages show?
function follows(expression, due, off,   command, result) {
    sub(/^= */, "", expression); rest = expression
    while (next_number()) if (figure) { whole = 0; tested = 0; if (!near(value, half)) return 0 }
    command = "awk \047BEGIN { printf \"%.12g\", " expression " }\047"; command | getline result; close(command)
    return result >= due - off && result <= due + off
}
# CHAPTER/PAGE of a path, as figures.txt has it.
function page_of(path) { sub(/:[0-9]*$/, "", path); return match(path, /[^\/]*\/[^\/]*$/) ? substr(path, RSTART) : path }
# An unknown figure: unless figures.txt says what it is, it is printed.
function unknown(at,   key, behind, is) {
    key = page_of(at) " " word; is = word; behind = rest; used[key] = 1
    if (!(key in reason)) print at ": " is
    else if (reason[key] ~ /^=/ && !follows(reason[key], value, half)) print at ": " reason[key] " is not " is
    rest = behind
}
function source(text, from) {
    rest = text
    while (next_number()) if (!seen[value, from]++) { have[++n] = value; of[n] = from }
}
# A row of a table, its cells divided by |: the first one names the columns.
function row(line,   c, i, k, u) {
    k = split(line, c, "|")
    for (i = 1; i <= k; i++) {
        if (!columns) { head[i] = unit_of(c[i], 1); if (head[i] == "" && i > 1) head[i] = unit_of(title, 1)
                        head_scale[i] = scale; continue }
        rest = c[i]
        while (next_number()) {
            u = unit_of(rest); if (u == "" || u == "x") { u = head[i]; scale = head_scale[i] }
            cell[++cells] = value * scale; unit[cells] = u
            if (u == "" && value <= 1.5) { cell[++cells] = value; unit[cells] = "share" } } }
    columns = k
}
# A line of a block or of a table of the page.
function block(line) {
    if (line !~ /real = (double|float)$/) source(line, "page")
    sub(/^ +/, "", line)
    if (line ~ /^# .*real = (double|float)$/) { columns = 0; table = 1 }
    else if (line ~ /^# /) { title = line; table = 0 }
    else if (line ~ /^ *\|[-:| ]*$/) return
    else if (line ~ /^ *\|/) { if (!table) { columns = 0; title = ""; table = 1 }
                              gsub(/^ *\| *| *\| *$/, "", line); row(line) }
    else if (line ~ /^ *$/) table = 0
    else if (table) { gsub(/   */, "|", line); row(line) }
}
# A line of code without its comments, which are sentences, too.
function uncommented(line) {
    if (comment && !match(line, /\*\//)) return ""
    if (comment) line = substr(line, RSTART + 2)
    gsub(/\/\*([^*]|\*[^\/])*\*\//, " ", line); sub(/\/\/.*/, "", line)
    comment = match(line, /\/\*/)
    return comment ? substr(line, 1, RSTART - 1) : line
}
function paragraph() { if (said != "") { text[++paragraphs] = said; where[paragraphs] = start }; said = "" }
function has_command(text) {
    gsub(/`[^`]*(--full|make (run|full)-)[^`]*`/, " ", text)
    return text ~ /`[^`]*(build\/|make |valgrind|--[a-z]|-O[0-3]|-march)[^`]*`/
}

BEGIN { names = split("ns us ms s seconds second nanoseconds milliseconds bytes byte B KB MB GB", name, " ")
        split("1e-9 1e-6 1e-3 1 1 1 1e-9 1e-3 1 1 1 1e3 1e6 1e9", size, " "); split("s s s s s s s s B B B B B B", measure, " ") }
FILENAME ~ /figures\.txt$/ { if ($0 !~ /^#|^ *$/) { key = $1 " " $2; reason[key] = $0; sub(/^[^ ]+ +[^ ]+ +/, "", reason[key]) }
                             next }
FNR == 1 { paragraph(); if (FILENAME ~ /\.md$/) read_page[page_of(FILENAME)] = 1
           page = FILENAME ~ /\.md$/; from = FILENAME ~ /^tests\// ? "test" : "code"
           fence = comment = sources = table = 0 }
!page { source(uncommented($0), from); next }
/^```/ { paragraph(); fence = !fence; program = fence && $0 !~ /^```$/; table = 0; next }
fence && program { source($0, "code"); next }
/^    |^ *\|/ || fence { paragraph(); block($0); next }
{ table = 0 }
/^#/ { paragraph(); sources = /Sources/; next }
/^ *$/ { paragraph(); next }
sources || /^\*Sources?:/ { next }
/^ *([-*]|[0-9]+\.) / { paragraph(); sub(/^ *([-*]|[0-9]+\.) /, "") }
{ if (said == "") start = FILENAME ":" FNR; said = said " " $0 }
END {
    paragraph()
    for (k = 1; k <= paragraphs; k++) {
        if (has_command(text[k])) continue
        tested = text[k] ~ /test_[a-z]|tests\/[0-9a-z]/
        rest = plain(text[k])
        while (next_number()) if (asked() && !known()) unknown(where[k])
    }
    for (key in reason)
        if (!(key in used) && (substr(key, 1, index(key, " ") - 1) in read_page)) print "figures.txt: not needed: " key
}
