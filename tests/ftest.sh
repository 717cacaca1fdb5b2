#!/usr/bin/env bash
# Runs all functional tests: the built programs, whole pictures, properties, hard rays, and the shaders against the CPU.
# The last command checks the digests of the programs in the release profile.
#
#   tests/ftest.sh [programs | OPTION OF cargo test]...
#
#   tests/ftest.sh programs     # only those of render-aos and render-soa, with right and wrong inputs
#   tests/ftest.sh cylinder     # only the tests with this word in their names
set -euo pipefail
cd "$(dirname "$0")/.."

[ "${1:-}" != --help ] || { sed -n '2,8s/^# \{0,1\}//p' tests/ftest.sh; exit; }
. tests/steps.sh
# The last command's programs take a minute of one processor to build, so that begins now. Its messages come from the
# last command, which waits for it.
cargo test -p cli --release --test digests --no-run >/dev/null 2>&1 &
if [ "${1:-}" = programs ]; then
    shift
    step cargo test -p cli --test '*' --no-fail-fast "$@"
else
    step cargo test --workspace --test '*' --no-fail-fast "$@"
fi
step cargo test -p cli --release --test digests "$@"
finish
