#!/usr/bin/env bash
# Looks for known faults of the dependencies: cargo deny check advisories, for the workspace and for tests/fuzz/targets.
#
# It needs cargo-deny (cargo install cargo-deny --locked) and the list of faults, which cargo-deny gets from GitHub.
# Without either it says so, as a test that is ignored, and succeeds. ADVISORIES_REQUIRED=1 makes that a failure.
set -euo pipefail
cd "$(dirname "$0")/.."

ignored() {
    echo "advisories ... ignored: $1"
    [ -z "${ADVISORIES_REQUIRED:-}" ]
    exit
}

command -v cargo-deny >/dev/null || ignored "cargo-deny is missing; cargo install cargo-deny --locked"

# Getting the list and judging by it are two steps: only the first may fail without a fault of ours.
log=$(mktemp)
trap 'rm -f "$log"' EXIT
timeout 120 cargo deny fetch db >"$log" 2>&1 || ignored "the list cannot be had: $(awk 'NF { line = $0 } END { print substr(line, 1, 200) }' "$log")"

for manifest in Cargo.toml tests/fuzz/targets/Cargo.toml; do
    cargo deny --manifest-path "$manifest" check --disable-fetch advisories
    echo "advisories of $manifest ... ok"
done
