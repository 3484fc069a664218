# notes_ledger.awk: prints the ledger of the pages beside the notes, with what the programs found.
#
#     awk -v csv=DIRECTORY -f tests/notes_ledger.awk chapters/notes/*.md
#
# A row of a page may name a measurement in a comment, <!-- 07; first; error: an edge; > 0 -->: the chapter, the
# row (cells that it begins with, commas between), the column, and what must hold of the number found in
# DIRECTORY/07_*.csv: <, > or = a number, or another row. Exit 1: something does not hold, or is not there.
# Without csv the comments are left out.
function cells(line, out,   n, i, c, quoted, cell) {  # RFC 4180
    n = 0; cell = ""; quoted = 0; line = line ","
    for (i = 1; i <= length(line); i++) {
        c = substr(line, i, 1)
        if (c == "\"") quoted = !quoted
        else if (c == "," && !quoted) { out[++n] = cell; cell = "" }
        else cell = cell c
    }
    return n
}
# The cell of that chapter's table, "" if there is none.
function found(chapter, row, column,   file, command, line, n, i, k, name, out, begin) {
    command = "ls " csv "/" chapter "_*.csv 2>/dev/null"
    if ((command | getline file) <= 0) file = ""
    close(command)
    if (file == "") return ""
    name = ""
    for (i = 0; (getline line < file) > 0 && name == ""; i++) {
        n = cells(line, out)
        if (i == 0) { for (k = 1; k <= n && out[k] != column; k++) ; column = k; if (k > n) break; continue }
        begin = out[1]
        for (k = 1; k <= n && name == ""; k++) {
            if (begin == row) name = out[column]
            begin = begin "," out[k + 1]
        }
    }
    close(file)
    return name
}
function holds(value, relation, limit) {
    if (relation == "<") return value + 0 < limit + 0
    if (relation == ">") return value + 0 > limit + 0
    return value + 0 == limit + 0
}
function trim(s) { gsub(/^ +| +$/, "", s); return s }
/^\| / && $0 !~ /^\| the notes/ {
    what = $0; mark = ""
    if (match(what, /<!-- [0-9][0-9];.*-->/)) {
        mark = substr(what, RSTART + 4, RLENGTH - 7)
        what = substr(what, 1, RSTART - 1) substr(what, RSTART + RLENGTH)
    }
    n = split(what, part, /\|/)
    for (i = 1; i <= n; i++) { gsub(/\[|\]\([^)]*\)|[*`]/, "", part[i]); part[i] = trim(part[i]) }
    number = part[n - 3]
    printf "%s\n    %s%s\n", part[2], part[3], (number != "" ? "  -- " number : "")
    if (mark == "" || csv == "") next
    split(mark, m, /; */)
    for (i = 1; i <= 4; i++) m[i] = trim(m[i])
    value = found(m[1], m[2], m[3])
    relation = substr(m[4], 1, 1); limit = trim(substr(m[4], 2))
    against = limit
    if (limit !~ /^-?[0-9.]+$/) { limit = found(m[1], limit, m[3]); against = limit ", " against }
    good = value != "" && limit != "" && holds(value, relation, limit)
    printf("    %s: %s, %s: %s %s %s%s\n", m[1], m[2], m[3], (value == "" ? "nothing" : value), relation,
        against, (good ? "" : "  DOES NOT HOLD"))
    measured++; if (!good) broken++
}
END {
    if (csv != "") printf "%d of %d measured claims hold\n", measured - broken, measured
    exit broken > 0
}
