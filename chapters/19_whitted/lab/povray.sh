#!/bin/sh
# The forty balls by build/19_whitted and by POV-Ray 3.7 (Debian: povray), in turn, one thread each, one
# ray a pixel, no antialiasing; seconds of the processor for tracing alone. Prints medians and ratios.
rounds=${1:-9} scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT
command -v povray >/dev/null || { echo "povray.sh: povray is not installed" >&2; exit 1; }
for k in $(seq "$rounds"); do
    build/19_whitted --povray "$scratch/forty.pov" | awk '/seconds/ { print $(NF - 1) }' >>"$scratch/ours"
    povray "+I$scratch/forty.pov" "+O$scratch/forty.png" +W480 +H360 -A +WT1 -D +Q9 2>&1 |
        sed -n '/Trace Time/,$s/.*with \(.*\) CPU-seconds total.*/\1/p' >>"$scratch/theirs"
done
for who in ours theirs; do
    sort -n "$scratch/$who" | awk -v who=$who '{ t[NR] = $1 } END { print who, t[int((NR + 1) / 2)], t[1] }'
done | awk '{ print $1 ": median " $2 " s, least " $3 " s"; m[NR] = $2; l[NR] = $3 }
            END { printf "ratio of medians %.2f, of the least %.2f\n", m[2] / m[1], l[2] / l[1] }'
