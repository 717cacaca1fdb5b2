#!/usr/bin/env bash
# Looks for known faults of the dependencies: cargo deny check advisories, for the workspace, python and tests/fuzz/targets.
#
#   tests/advisories.sh                            # if cargo-deny or the list is missing: says so and succeeds
#   ADVISORIES_REQUIRED=1 tests/advisories.sh      # if cargo-deny or the list is missing: fails
#
# Needs cargo-deny (cargo install cargo-deny --locked) and the list of faults, which cargo-deny downloads from GitHub.
set -euo pipefail
cd "$(dirname "$0")/.."

[ "${1:-}" != --help ] || { sed -n '2,7s/^# \{0,1\}//p' tests/advisories.sh; exit; }
ignored() {
    echo "advisories ... ignored: $1"
    [ -z "${ADVISORIES_REQUIRED:-}" ]
    exit
}

command -v cargo-deny >/dev/null || ignored "cargo-deny is missing; cargo install cargo-deny --locked"

# The list is downloaded in a separate step, because a failed download is no fault of the project.
log=$(mktemp)
trap 'rm -f "$log"' EXIT
timeout 120 cargo deny fetch db >"$log" 2>&1 || ignored "the list cannot be had: $(awk 'NF { line = $0 } END { print substr(line, 1, 200) }' "$log")"

for manifest in Cargo.toml python/Cargo.toml tests/fuzz/targets/Cargo.toml; do
    cargo deny --manifest-path "$manifest" check --disable-fetch advisories
    echo "advisories of $manifest ... ok"
done
