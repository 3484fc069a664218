#!/bin/sh
# All pages as one file: `make book` writes build/book.html, contents on the left, formulas as MathML, pictures
# inside. It needs pandoc; links to code lead from build/ into the tree. Exit 2: no pandoc; 1: a formula that
# pandoc cannot read, or a picture that is not there. PICTURES=no: pictures stay files (soon done).
build=${1:-build}
command -v pandoc >/dev/null 2>&1 ||
    { echo "book: pandoc is missing: install it (Debian: apt-get install pandoc)" >&2; exit 2; }
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT
mkdir -p "$build" || exit 1

page() {  # page FILE: adds it to the text; "TITLE<TAB>ANCHOR" goes to standard output
    pandoc -f gfm+tex_math_dollars -t html5 --mathml --wrap=none -M page="$1" \
        --lua-filter=tests/book/page.lua "$1" >"$scratch/page" 2>>"$scratch/err" || exit 1
    { echo '<section>'; cat "$scratch/page"; echo '</section>'; } >>"$scratch/text"
    printf '%s\t%s\n' "$(sed -n 's/^# //p' "$1" | head -n 1 | sed 's/[*`]//g; s/&/\&amp;/g; s/</\&lt;/g')" \
        "$(printf '%s' "$1" | sed 's/\.md$//; s#/#-#g')"
}
entry() { page "$1" | awk -F'\t' '{ print "<a href=\"#" $2 "\">" $1 "</a><br>" }'; }
{
    echo '<p>The book</p>'
    entry README.md
    for f in chapters/*.md tests/README.md; do entry "$f"; done
    echo '<p>Beside the notes</p>'
    for f in rtr games101 path_tracing fcg gems; do entry chapters/notes/$f.md; done
    echo '<p>Chapters</p>'
    for f in chapters/[0-9]*/README.md; do
        entry "$f" | sed 's/<br>$//'
        for more in "$(dirname "$f")"/[A-Z]*.md; do
            [ "$more" = "$f" ] || page "$more" | awk -F'\t' '{ name = tolower($2); sub(/.*-/, "", name)
                print "<small><a href=\"#" $2 "\">" name "</a></small>" }'
        done
        echo '<br>'
    done
} >"$scratch/contents"
{
    echo '<!DOCTYPE html><html lang="en"><head><meta charset="utf-8">'
    echo '<meta name="viewport" content="width=device-width, initial-scale=1">'
    echo '<title>A book on ray tracing that you can compile</title><style>'
    cat tests/book/book.css
    echo '</style></head><body><input type="checkbox" id="menu"><nav>'
    cat "$scratch/contents"
    echo '</nav><label for="menu">contents</label><main>'
    cat "$scratch/text"
    echo '</main></body></html>'
} >"$build/book.html" || exit 1

# Links between pages lead somewhere.
grep -oE 'href="#[^"]*"' "$build/book.html" | sed 's/href="#//; s/"//' | sort -u >"$scratch/wanted"
grep -oE ' id="[^"]*"' "$build/book.html" | sed 's/ id="//; s/"//' | sort -u >"$scratch/there"
comm -23 "$scratch/wanted" "$scratch/there" | sed 's/^/book: no anchor /' >>"$scratch/err"
if [ -s "$scratch/err" ]; then cat "$scratch/err" >&2; exit 1; fi
echo "-> $build/book.html: $(grep -c '^<section>' "$scratch/text") pages," \
    "$(grep -o '<math' "$build/book.html" | wc -l) formulas, $(grep -o 'src="data:' "$build/book.html" | wc -l) pictures"
