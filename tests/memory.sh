#!/usr/bin/env bash
# The SIMD paths under valgrind and, with a nightly toolchain, under the address sanitizer. Minutes, on one core.
#
#   tests/memory.sh [valgrind|sanitizer]
#
# valgrind knows no AVX-512; the sanitizer runs what the machine has. Neither sees what miri would (miri is no part of
# the toolchains here, and runs no AVX): undefined behaviour that touches no wrong byte.
set -euo pipefail
cd "$(dirname "$0")/.."
host=x86_64-unknown-linux-gnu

valgrind_all() {
    command -v valgrind >/dev/null || { echo "tests/memory.sh: valgrind is missing: apt-get install valgrind" >&2; exit 1; }
    cargo build --release -p cli
    folder=$(mktemp -d)
    trap 'rm -rf "$folder"' EXIT
    count=0
    for scene in tests/cases/*/; do
        { cat "$scene/config.txt"; echo; echo "image_width: 20"; echo "samples_per_pixel: 2"; } > "$folder/config.txt"
        for set in portable sse2 avx2; do
            for program in render-aos render-soa; do
                RENDER_INSTRUCTION_SET=$set valgrind --quiet --error-exitcode=9 --leak-check=no \
                    "target/release/$program" "$folder/config.txt" "$scene/scene.txt" "$folder/$set-$program.ppm"
                cmp "$folder/portable-render-aos.ppm" "$folder/$set-$program.ppm"
                count=$((count + 1))
            done
        done
    done
    echo "valgrind: $count renderings without a complaint"
}

sanitizer_all() {
    # What is leaked is no wrong address: a name that a signal handler has used must not be freed.
    export RUSTFLAGS=-Zsanitizer=address ASAN_OPTIONS=detect_odr_violation=0:detect_leaks=0
    export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-target}/sanitizer
    cargo +nightly test --target $host -p cpu --lib
    cargo +nightly test --target $host -p tests --test properties
    cargo +nightly test --target $host -p hostile --test smoke
}

case "${1:-all}" in
    valgrind) valgrind_all ;;
    sanitizer) sanitizer_all ;;
    all) (valgrind_all) && sanitizer_all ;;
    *) sed -n '2,4p' "$0" >&2; exit 2 ;;
esac
