#!/usr/bin/env bash
# All unit tests: those beside the functions they test, what is skipped by count, and the examples in the documentation.
set -euo pipefail
cd "$(dirname "$0")/.."

cargo test --workspace --lib --bins "$@"
cargo test -p cpu --features counters --test counters "$@"
cargo test --workspace --doc "$@"
