#!/usr/bin/env bash
# Runs all functional tests: the built programs, whole pictures, properties, hard rays, and the shaders against the CPU.
# The last command checks the digests of the programs in the release profile.
set -euo pipefail
cd "$(dirname "$0")/.."

cargo test --workspace --test '*' "$@"
cargo test -p cli --release --test digests "$@"
