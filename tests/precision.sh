#!/bin/sh
# Sets the tables of $BUILD/float/NAME and $BUILD/double/NAME side by side: the columns whose names
# begin with "error" or "time", or tell a time by their unit (build_s, ns_per_ray), behind the
# columns that say of what. The programs run as they are, not --quick: their times are medians.
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT
for name in "$@"; do
    echo; echo "== $name"
    for real in float double; do
        (cd "$scratch" && "$OLDPWD/$BUILD/$real/$name" --csv "$scratch/$real.csv" >/dev/null) || exit 1
        sed 's/"\([^",]*\),\([^"]*\)"/\1;\2/g' "$scratch/$real.csv" > "$scratch/$real.plain"
    done
    awk -F, '
        FNR == 1 { file++; columns = NF }
        file == 1 { for (i = 1; i <= NF; i++) one[FNR, i] = $i; next }
        {
            row = ""
            for (i = 1; i <= columns; i++) {
                if (FNR == 1) measured[i] = $i ~ /^(error|time)|^ns_|_s$/
                if (!measured[i]) row = row (row == "" ? "" : "|") $i
                else if (FNR == 1) row = row "|" $i " float|double"
                else row = row "|" one[FNR, i] "|" $i
            }
            print row
        }' "$scratch/float.plain" "$scratch/double.plain" |
        awk -F'|' '
            { for (i = 1; i <= NF; i++) { cell[NR, i] = $i; if (length($i) > width[i]) width[i] = length($i) }
              fields[NR] = NF }
            END { for (r = 1; r <= NR; r++) { for (i = 1; i <= fields[r]; i++)
                      printf("%-" width[i] "s%s", cell[r, i], i < fields[r] ? "  " : "\n") } }'
done
