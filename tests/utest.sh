#!/usr/bin/env bash
# Runs all unit tests: those beside the functions they test, those of the counters, and the examples in the comments.
#
#   tests/utest.sh [OPTION OF cargo test]...
#
#   tests/utest.sh cylinder     # only the tests with this word in their names
set -euo pipefail
cd "$(dirname "$0")/.."

[ "${1:-}" != --help ] || { sed -n '2,6s/^# \{0,1\}//p' tests/utest.sh; exit; }
cargo test --workspace --lib --bins "$@"
cargo test -p cpu --features counters --test counters "$@"
cargo test --workspace --doc "$@"
