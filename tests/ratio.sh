#!/usr/bin/env bash
# Prints how many times as fast as the reference render-aos is: the median over rounds of the ratio of user times.
# Each round runs both. With RUNS=11 a round runs render-aos 11 times and takes the median, for very small scenes.
#
#   tests/ratio.sh ROUNDS CONFIG SCENE [ROUNDS CONFIG SCENE ...]
#
#   tests/ratio.sh 5 scenes/spheres/config.txt scenes/spheres/scene.txt
#
# RENDER_INSTRUCTION_SET=portable|neon|avx2|avx512|avx512-throughout forces an instruction set. PROGRAM and YARDSTICK
# replace the two programs, as in YARDSTICK="env RENDER_INSTRUCTION_SET=portable target/release/render-aos".
set -euo pipefail

if [ "${1:-}" = --help ]; then
    sed -n '2,10s/^# \{0,1\}//p' "$0"
    exit
fi
top=$(cd "$(dirname "$0")/.." && pwd)
cargo build --release --quiet --manifest-path "$top/Cargo.toml" -p cli -p bench --bins
target=${CARGO_TARGET_DIR:-$top/target}
program=${PROGRAM:-$target/release/render-aos}
yardstick=${YARDSTICK:-$target/release/reference}
runs=${RUNS:-1}
# A program ignores the name of an instruction set that this machine lacks, so the names are checked here.
for word in ${RENDER_INSTRUCTION_SET:+"RENDER_INSTRUCTION_SET=$RENDER_INSTRUCTION_SET"} $program $yardstick; do
    case $word in RENDER_INSTRUCTION_SET=*) env "$word" "$target/release/instruction-set" >/dev/null || exit 2 ;; esac
done
[ $# -gt 0 ] && [ $(($# % 3)) -eq 0 ] || { sed -n '2,10s/^# \{0,1\}//p' "$0" >&2; exit 2; }

user_seconds() {
    local TIMEFORMAT=%U
    { time $1 "$2" "$3" /dev/null; } 2>&1
}

while [ $# -gt 0 ]; do
    for _ in $(seq "$1"); do
        slow=$(user_seconds "$yardstick" "$2" "$3")
        fast=$(for _ in $(seq "$runs"); do user_seconds "$program" "$2" "$3"; done | sort -n | sed -n "$((runs / 2 + 1))p")
        echo "$slow $fast"
    done | awk -v what="$3" '
        { slow[NR] = $1; fast[NR] = $2; ratio[NR] = $2 > 0 ? $1 / $2 : 0 }
        END {
            n = NR; for (i = 2; i <= n; i++) for (j = i; j > 1 && ratio[j] < ratio[j - 1]; j--) { t = ratio[j]; ratio[j] = ratio[j - 1]; ratio[j - 1] = t }
            middle = n % 2 ? ratio[(n + 1) / 2] : (ratio[n / 2] + ratio[n / 2 + 1]) / 2
            printf "%s: %.2f times (%.2f to %.2f, %d rounds)\n", what, middle, ratio[1], ratio[n], n
        }'
    shift 3
done
