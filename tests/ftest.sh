#!/usr/bin/env bash
# Runs all functional tests: the built programs, whole pictures, properties, hard rays, and the shaders against the CPU.
# The programs whose pictures are compared with digests are those that users build, with --release.
#
#   tests/ftest.sh [programs | OPTION OF cargo test]...
#
#   tests/ftest.sh programs     # only those of render-aos and render-soa, with right and wrong inputs
#   tests/ftest.sh cylinder     # only the tests with this word in their names
set -euo pipefail
cd "$(dirname "$0")/.."

[ "${1:-}" != --help ] || { sed -n '2,8s/^# \{0,1\}//p' tests/ftest.sh; exit; }
. tests/steps.sh
packages=(--workspace)
if [ "${1:-}" = programs ]; then
    shift
    packages=(-p cli)
fi
# The programs that users build take a minute of one processor, because they are optimised across packages. So the tests
# are compiled at the same time. The messages of the first build come from the same command below, which waits for it.
release=(cargo build --release -p cli --bins)
"${release[@]}" >/dev/null 2>&1 &
cargo build "${packages[@]}" --test '*' || true
step "${release[@]}"
step env RENDER_PROGRAMS="$(release_folder)" cargo test "${packages[@]}" --test '*' --no-fail-fast "$@"
finish
