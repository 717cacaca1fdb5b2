#!/usr/bin/env bash
# Runs all unit tests: those beside the functions they test, those of the counters, and the examples in the comments.
set -euo pipefail
cd "$(dirname "$0")/.."

cargo test --workspace --lib --bins "$@"
cargo test -p cpu --features counters --test counters "$@"
cargo test --workspace --doc "$@"
