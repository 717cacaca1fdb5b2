#!/usr/bin/env bash
# All functional tests: the built programs, whole pictures, properties, hard rays, and the shaders against the CPU; last the
# digests of the programs as they are shipped.
set -euo pipefail
cd "$(dirname "$0")/.."

cargo test --workspace --test '*' "$@"
cargo test -p cli --release --test digests "$@"
