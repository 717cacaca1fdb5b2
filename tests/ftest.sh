#!/usr/bin/env bash
# All functional tests: the built programs, whole pictures, properties, hard rays, and the shaders against the CPU. What
# renders large pictures or many rays runs in release; the shaders need no such thing.
set -euo pipefail
cd "$(dirname "$0")/.."

cargo test --workspace --exclude shaders --exclude gpu-check --exclude hostile --release --test '*' "$@"
cargo test -p shaders -p gpu-check -p hostile --test '*' "$@"
