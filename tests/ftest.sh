#!/usr/bin/env bash
# Runs all functional tests: the built programs, whole pictures, properties, hard rays, and the shaders against the CPU.
# The last command checks the digests of the programs in the release profile.
#
#   tests/ftest.sh [OPTION OF cargo test]...
#
#   tests/ftest.sh cylinder     # only the tests with this word in their names
set -euo pipefail
cd "$(dirname "$0")/.."

[ "${1:-}" != --help ] || { sed -n '2,7s/^# \{0,1\}//p' tests/ftest.sh; exit; }
cargo test --workspace --test '*' "$@"
cargo test -p cli --release --test digests "$@"
