#!/usr/bin/env bash
# All unit tests: those beside the functions they test, and the examples in the documentation.
set -euo pipefail
cd "$(dirname "$0")/.."

cargo test --workspace --lib --bins "$@"
cargo test --workspace --doc "$@"
