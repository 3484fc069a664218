# notes_ledger.awk: prints the ledger of the pages beside the notes, with what the programs found.
#
#     awk -v csv=DIRECTORY -f tests/notes_ledger.awk chapters/notes/*.md
#
# A row of a page may name a measurement in a comment, <!-- 07; first; error: an edge; > 0 -->: the chapter, the
# row (cells that it begins with, commas between), the column, and what must hold of the number found in
# DIRECTORY/07_*.csv: <, > or = a number, or another row. Exit 1: something does not hold, or is not there.
# A number that leads to a chapter's page is looked for in DIRECTORY/07_*.out, what the program printed, and the
# line where it stands is shown. Without csv neither is done.
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
# The first line of what a chapter's program printed that has the number as a word, "" if none has.
function printed(chapter, number,   file, command, line, n, i, word, at) {
    command = "ls " csv "/" chapter "_*.out 2>/dev/null"
    if ((command | getline file) <= 0) file = ""
    close(command)
    at = ""
    while (file != "" && at == "" && (getline line < file) > 0) {
        n = split(line, word, /[ ,;:()]+/)
        for (i = 1; i <= n; i++) if (word[i] == number) at = line
    }
    if (file != "") close(file)
    return at
}
# Shows where the numbers of a row were printed.
function show_numbers(row,   link, number, chapter, line) {
    while (match(row, /\[`?[0-9][0-9.,]*`?\]\(\.\.\/[0-9][0-9]_[a-z_]*\/[A-Z]*\.md[^)]*\)/)) {
        link = substr(row, RSTART, RLENGTH); row = substr(row, RSTART + RLENGTH)
        number = link; sub(/\].*/, "", number); gsub(/[][`,]/, "", number)
        chapter = link; sub(/.*\.\.\//, "", chapter); chapter = substr(chapter, 1, 2)
        if (number == chapter) continue
        numbers++
        line = printed(chapter, number)
        if (line != "") { again++; gsub(/  +/, "  ", line); printf "    %s: %s\n", chapter, trim(line) }
    }
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
    if (csv != "") show_numbers($0)
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
    if (csv != "")
        printf "%d of %d measured claims hold; %d of %d numbers were printed again\n", measured - broken, measured,
            again, numbers
    exit broken > 0
}
