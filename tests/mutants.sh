#!/usr/bin/env bash
# Finds mistakes in cpu that no test would notice: runs cargo-mutants on the parsers, camera, materials, intersections,
# image and output, against cpu's own unit tests. All files take an hour on one core.
#
#   tests/mutants.sh [OPTION OF cargo mutants]... [-- OPTION OF cargo test...]
#
#   tests/mutants.sh                                            # all files
#   tests/mutants.sh -f cpu/src/output.rs -- output::           # one file, against the tests of its module
#
# Needs cargo install --locked cargo-mutants. A mutant of output.rs may rename a file over a device that a test writes to.
# So as root this runs where the devices cannot be replaced.
set -euo pipefail
cd "$(dirname "$0")/.."

[ "${1:-}" != --help ] || { sed -n '2,11s/^# \{0,1\}//p' "$0"; exit; }
files=(input/{text,config,scene,material,error,reader} geometry/{camera,sphere,cylinder,ray} materials/scatter image image/{quantize,ppm}
    output output/{folder,place,stdout,stop,temporary} render/{background,surface} program layout)
if [ $# -eq 0 ]; then
    for file in "${files[@]}"; do
        set -- "$@" "--file=cpu/src/$file.rs"
    done
fi

if [ "$(id -u)" -eq 0 ] && [ -z "${MUTANTS_CONFINED:-}" ]; then
    # Devices in a read-only folder can be written to, but not replaced.
    MUTANTS_CONFINED=1 exec unshare --mount bash -c 'mount --bind /dev /dev && mount -o remount,bind,ro /dev && exec "$@"' confined "$0" "$@"
fi
# Without optimisation a mutant is built in a second or two.
export CARGO_PROFILE_DEV_OPT_LEVEL=0 CARGO_PROFILE_DEV_DEBUG=none
# The library alone, in the build too: the other tests' programs take far longer to build.
cargo mutants -p cpu --minimum-test-timeout 12 --no-shuffle --cargo-arg=--lib "$@"
