#!/bin/sh
# The pages beside the lecture notes: every link leads to a file that holds what the link says, a function by
# name or a number; formulas that are cited stand in the chapter they name; every heading of the notes is
# there; each row of the ledger has a verdict. `sh tests/notes.sh table [DIRECTORY]` prints the ledger.
. tests/check.sh
pages=chapters/notes

# The ledger, without and with what programs found: `make notes` gives the directory of their CSV.
if [ "${1:-}" = table ]; then
    awk -v csv="${2:-}" -f tests/notes_ledger.awk $pages/*.md
    exit
fi

# links DIR: "page<TAB>text<TAB>target" for each link of each page
links() {
    for page in "$1"/*.md; do
        grep -oE '\[[^][]+\]\([^)]+\)' "$page" |
            sed -E "s#^\[(.*)\]\((.*)\)\$#$page	\1	\2#"
    done
}
# wrong DIR: links whose target lacks the file, or what the text promises of it
wrong() {
    links "$1" | while IFS='	' read -r page text target; do
        file=$(dirname "$page")/$target
        plain=$(printf '%s' "$text" | tr -d '`')
        if [ ! -e "$file" ]; then echo "$page: no file $target"
        elif [ "$plain" != "$text" ] && ! grep -qwF -e "$plain" "$file"; then echo "$page: $target lacks $plain"
        elif printf '%s' "$plain" | grep -qE '^[0-9][0-9.,]*$' && expr "$target" : '.*\.md$' >/dev/null &&
             ! printf '%s' "$plain" | grep -qE '^[0-9][0-9]$' && ! grep -qF -e "$plain" "$file"
        then echo "$page: $target lacks the number $plain"
        fi
    done
}
wrong $pages >"$scratch/wrong"
while read -r line; do no "$line"; done <"$scratch/wrong"
n=$(links $pages | wc -l)
if [ "$n" -ge 150 ]; then ok; else no "$n links, fewer than 150"; fi
[ -s "$scratch/wrong" ] || ok

# The rule sees what it is there to see: a lost file, a lost function, a lost number.
mkdir -p "$scratch/chapters/notes" "$scratch/chapters/01_a"
echo 'int here; 42.5' >"$scratch/chapters/01_a/a.md"
# shellcheck disable=SC2016
echo '[`here`](../01_a/a.md) [42.5](../01_a/a.md) [`there`](../01_a/a.md) [42.6](../01_a/a.md) [x](../02_b/b.h)' \
    >"$scratch/chapters/notes/p.md"
seen=$(wrong "$scratch/chapters/notes" | wc -l)
if [ "$seen" -eq 3 ]; then ok; else no "3 broken links were planted, $seen were found"; fi

# Formulas: (9.3) stands on a page of chapter 09.
cat $pages/*.md | grep -oE '\([0-9]{1,2}\.[0-9]{1,2}\)' | sort -u >"$scratch/formulas"
while read -r f; do
    [ "$f" = "(26.2)" ] && continue  # the book's own number
    chapter=$(printf '%02d' "$(printf '%s' "$f" | sed -E 's/\(([0-9]+)\..*/\1/')")
    if cat chapters/"$chapter"_*/*.md | grep -qF -e "$f"; then ok; else no "formula $f stands on no page of its chapter"; fi
done <"$scratch/formulas"

# Headings and terms of the five notes, one page each.
has() { page=$1; shift; for t in "$@"; do if grep -qF -e "$t" "$pages/$page"; then ok; else no "$page lacks $t"; fi; done; }
has games101.md 光线追踪解决什么问题 光线投射 Whitted 求交点 隐式 三角形 Möller 包围盒 均匀网格 空间划分 八叉树 KD树 BSP \
    物体划分 层次包围盒 辐射度量学 BRDF 反射方程 渲染方程 全局光照 概率论回顾
has rtr.md 光线追踪基础 26.2 构造实体几何 'trace()' 'shade()' 光线投射 方差 Kajiya DXR
has gems.md 2.1 2.2 2.3 2.4 光线间隔 实例化 RayDesc 有效载荷
has fcg.md 物体顺序 图像顺序 透视 计算视线 正交视图 透视视图 焦距
has path_tracing.md 问题 Direct Global 加速结构 'Monte Carlo' 除非
# A ledger of forty claims at least, each judged.
rows=$(cat $pages/*.md | grep -c '^| .*make run-')
if [ "$rows" -ge 40 ]; then ok; else no "$rows rows that a program decides, fewer than 40"; fi
# Those that the programs measure name a table of their chapter's pages; the ledger sees what does not hold.
grep -ho '<!-- [0-9][0-9];.*-->' $pages/*.md | sed 's/<!-- //; s/ -->//' >"$scratch/marks"
while IFS=';' read -r chapter row column relation; do
    for text in "row ${row# }" "column ${column# }" "row ${relation# ? }"; do
        case $text in "row "[0-9-]*[0-9]) continue ;; esac
        if cat chapters/"$chapter"_*/*.md | sed -E 's/^ +//; s/  +/,/g; s/$/,/' |
            awk -v kind="${text%% *}" -v text="${text#* }" '{ i = index($0, text)
                if (kind == "row" ? i == 1 : i) found = 1 } END { exit !found }'
        then ok; else no "chapter $chapter has no table with the $text"; fi
    done
done <"$scratch/marks"
if [ "$(wc -l <"$scratch/marks")" -ge 25 ]; then ok; else no "fewer than 25 claims are measured by make notes"; fi
printf 'method,size,error,time\n"a, b",1,5,2\nc,1,0,3\n' >"$scratch/01_a.csv"
mark() { printf '| claim | true | 1 <!-- 01; %s --> | code | run |\n' "$@"; }
mark 'a, b; error; > c' 'c,1; error; = 0' 'a, b; time; < 2.5' 'a, b; error; < c' 'd; error; > 0' 'c; place; > 0' \
    >"$scratch/rows"
seen=$(awk -v csv="$scratch" -f tests/notes_ledger.awk "$scratch/rows" | grep -c 'DOES NOT HOLD')
if [ "$seen" -eq 3 ]; then ok; else no "3 of 6 planted claims do not hold, $seen were found"; fi
if awk -v csv="$scratch" -f tests/notes_ledger.awk "$scratch/rows" >/dev/null; then no "it ends with 0"; else ok; fi
report
