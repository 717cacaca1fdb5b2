#!/usr/bin/env bash
# Runs the SIMD code under valgrind and, with a nightly toolchain, under the address sanitizer and miri. On one core,
# valgrind and the sanitizer take some minutes each, and miri twenty.
#
#   tests/memory.sh [valgrind|sanitizer|miri]
#
#   tests/memory.sh              # all three; without a nightly toolchain, valgrind alone
#   tests/memory.sh valgrind     # 64 renderings
#
# valgrind and miri cannot run AVX-512; the sanitizer runs the instruction sets of the machine. Only miri finds
# undefined behaviour that reads and writes no wrong address.
set -euo pipefail
cd "$(dirname "$0")/.."

[ "${1:-}" != --help ] || { sed -n '2,11s/^# \{0,1\}//p' tests/memory.sh; exit; }
host=x86_64-unknown-linux-gnu

valgrind_all() {
    command -v valgrind >/dev/null || { echo "tests/memory.sh: valgrind is missing: apt-get install valgrind" >&2; exit 1; }
    cargo build --release -p cli
    folder=$(mktemp -d)
    trap 'rm -rf "$folder"' EXIT
    count=0
    for scene in tests/cases/*/; do
        { cat "$scene/config.txt"; echo; echo "image_width: 20"; echo "samples_per_pixel: 2"; } > "$folder/config.txt"
        for set in portable avx2; do
            for program in render-aos render-soa; do
                RENDER_INSTRUCTION_SET=$set valgrind --quiet --error-exitcode=9 --leak-check=no \
                    "${CARGO_TARGET_DIR:-target}/release/$program" "$folder/config.txt" "$scene/scene.txt" "$folder/$set-$program.ppm"
                cmp "$folder/portable-render-aos.ppm" "$folder/$set-$program.ppm"
                count=$((count + 1))
            done
        done
    done
    echo "valgrind: $count renderings without a complaint"
}

sanitizer_all() {
    # Leaks are not reported, because some are on purpose: a name that a signal handler may use is never freed.
    export RUSTFLAGS=-Zsanitizer=address ASAN_OPTIONS=detect_odr_violation=0:detect_leaks=0
    export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-target}/sanitizer
    cargo +nightly test --target $host -p cpu -p output --lib
    cargo +nightly test --target $host -p tests --test properties
    cargo +nightly test --target $host -p fuzz-oracles --test smoke
}

miri_all() {
    cargo +nightly miri --version >/dev/null 2>&1 || {
        echo "tests/memory.sh: miri is missing: rustup component add --toolchain nightly miri rust-src" >&2
        exit 1
    }
    # Without the second flag miri adds random errors to the last bits of functions such as `powf`.
    export MIRIFLAGS="-Zmiri-disable-isolation -Zmiri-no-extra-rounding-error"
    export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-target}/miri
    # miri offers the target features that are given at compile time: first none, for the portable set, then AVX2.
    for features in "" "-Ctarget-feature=+avx2,+fma,+bmi1,+bmi2,+lzcnt,+popcnt"; do
        # Tests that take miri too long are left out.
        RUSTFLAGS=$features cargo +nightly miri test -p cpu --lib -- \
            simd:: sampling:: layout:: render:: --skip a_channel_of_ones_is_one_in_every_sample
        RUSTFLAGS=$features cargo +nightly miri test -p cpu --test small_pictures
    done
}

case "${1:-all}" in
    valgrind) valgrind_all ;;
    sanitizer) sanitizer_all ;;
    miri) miri_all ;;
    all) (valgrind_all) && (sanitizer_all) && miri_all ;;
    *) sed -n '2,11s/^# \{0,1\}//p' tests/memory.sh >&2; exit 2 ;;
esac
