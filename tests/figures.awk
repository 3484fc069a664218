# figures.awk FILE..: the figures of a chapter's sentences that stand nowhere else, each as "PAGE:LINE: FIGURE". The
# files are the chapter's headers and programs, and its pages last.
#
# A figure has two significant digits or more; whole numbers below 28 without a unit are left (chapters are numbered so),
# and so are formulas, `code`, links, sizes as 640 x 480, references as (9.1), section 26.1, years, and the sources.
# It is known if a table or a block of the chapter's pages shows it, or its code, outside comments, has it: to as many
# digits as are said, 60 % for 0.599, 17.9 million for 17900000. It need not be if its paragraph names a command: but
# not the one that prints the tables, since what that prints is there to be compared. If it names a test, the numbers of
# the tests of the chapter and of those that its pages name count, too; else not: among so many any number is found.

# What a page says besides figures, and that may hold digits.
function plain(text) {
    gsub(/`[^`]*`/, " ", text); gsub(/\$\$[^$]*\$\$/, " ", text); gsub(/\$[^$]*\$/, " ", text)
    gsub(/\]\([^)]*\)/, "]", text); gsub(/https?:[^ ]*/, " ", text); gsub(/<sup>[^<]*<.sup>|<[^>]*>/, " ", text)
    gsub(/\([0-9]+\.[0-9]+[a-z]?\)/, " ", text)
    gsub(/(RTR|Gems|Embree|gcc|[Ee]quation|[Cc]hapter|ch\.|[Ss]ection|[Ll]ecture)[*,]* [0-9.]+(( and| to|,) [0-9.]+)*/, " ", text)
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
function near(v, h,   i) {
    for (i = 1; i <= n; i++) if (have[i] >= v - h && have[i] <= v + h && (tested || !(i in of_test))) return 1
    return 0
}
function known() {
    if (near(value, half)) return 1
    if (rest ~ /^ ?%/) return near(value / 100, half / 100)
    if (rest ~ /^ thousand/) return near(value * 1e3, half * 1e3)
    if (rest ~ /^ million/) return near(value * 1e6, half * 1e6)
    return rest ~ /^ billion/ && near(value * 1e9, half * 1e9)
}
function source(text) {
    rest = text
    while (next_number())
        if (!((value, in_test) in seen)) { seen[value, in_test] = 1; have[++n] = value; if (in_test) of_test[n] = 1 }
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

FNR == 1 { paragraph(); page = FILENAME ~ /\.md$/; in_test = FILENAME ~ /^tests\//; fence = comment = sources = 0 }
!page { source(uncommented($0)); next }
/^```/ { paragraph(); fence = !fence; next }
/^    |^ *\|/ || fence { paragraph(); if ($0 !~ /real = (double|float)$/) source($0); next }
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
        while (next_number()) if (asked() && !known()) print where[k] ": " word
    }
}
