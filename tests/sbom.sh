#!/usr/bin/env bash
# Writes a bill of materials (CycloneDX 1.5, JSON) for each of render-aos, render-soa and render-lab at the commit that
# is checked out. The bill lists the packages that are compiled into the program.
#
#   tests/sbom.sh FOLDER
#
#   tests/sbom.sh /tmp/materials     # writes /tmp/materials/render-aos.cdx.json and two others
#
# Needs cargo install --locked cargo-cyclonedx, which is no dependency of the project.
set -euo pipefail
cd "$(dirname "$0")/.."

help() { sed -n '2,9s/^# \{0,1\}//p' tests/sbom.sh; }
[ "${1:-}" != --help ] || { help; exit; }
[ $# -eq 1 ] && [[ $1 != -* ]] || { help >&2; exit 2; }
mkdir -p "$1"
folder=$(cd "$1" && pwd)
[ -z "$(git status --porcelain --untracked-files=no)" ] || { echo "tests/sbom.sh: there are changes that no commit has" >&2; exit 1; }

# cargo-cyclonedx writes its files beside every Cargo.toml, so it runs on a copy.
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
git archive HEAD | tar -x -C "$copy"
# One commit gives the same bytes in every run: the time is that of the commit, and the name of the copy is replaced.
SOURCE_DATE_EPOCH=$(git log -1 --format=%ct)
export SOURCE_DATE_EPOCH
cargo cyclonedx --manifest-path "$copy/Cargo.toml" --describe binaries --format json --spec-version 1.5 --quiet
for program in cli/render-aos cli/render-soa lab/render-lab; do
    sed "s|$copy|/render|g" "$copy/${program}_bin.cdx.json" > "$folder/${program#*/}.cdx.json"
done
