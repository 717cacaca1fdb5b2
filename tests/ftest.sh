#!/usr/bin/env bash
# All functional tests: the built programs, whole pictures, properties. In release, since some render large pictures.
set -euo pipefail
cd "$(dirname "$0")/.."

cargo test --workspace --release --test '*' "$@"
