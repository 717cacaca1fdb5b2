#!/usr/bin/env bash
# Finds mistakes in cpu and output that no unit test would notice: runs cargo-mutants on the parsers, camera, materials,
# intersections, image and the writer, against the unit tests of cpu and output. All files take an hour on one core.
#
#   tests/mutants.sh [OPTION OF cargo mutants]... [-- OPTION OF cargo test...]
#
#   tests/mutants.sh                                            # all files
#   tests/mutants.sh -f cpu/src/input/text.rs -- input::        # one file, against the tests of its module
#
# Needs cargo install --locked cargo-mutants. A mutant of output may rename a file over a device that a test writes to.
# So if root starts this script, it mounts /dev read-only for itself.
set -euo pipefail
cd "$(dirname "$0")/.."

[ "${1:-}" != --help ] || { sed -n '2,11s/^# \{0,1\}//p' tests/mutants.sh; exit; }
files=(input/{text,config,scene,material,error,reader} geometry/{camera,sphere,cylinder,cap,tie,ray} materials/scatter image image/{quantize,ppm}
    render/{background,surface_hit} layout)
if [ $# -eq 0 ]; then
    for file in "${files[@]}"; do
        set -- "$@" "--file=cpu/src/$file.rs"
    done
    set -- "$@" "--file=cli/output/src/*.rs"
fi

if [ "$(id -u)" -eq 0 ] && [ -z "${MUTANTS_CONFINED:-}" ]; then
    # Devices in a read-only folder can be written to, but not replaced.
    MUTANTS_CONFINED=1 exec unshare --mount bash -c 'mount --bind /dev /dev && mount -o remount,bind,ro /dev && exec "$@"' confined tests/mutants.sh "$@"
fi
# Without optimisation a mutant is built in one or two seconds.
export CARGO_PROFILE_DEV_OPT_LEVEL=0 CARGO_PROFILE_DEV_DEBUG=none
# --lib applies to the build too: the programs of the other tests take far longer to build.
cargo mutants -p cpu -p output --minimum-test-timeout 12 --no-shuffle --cargo-arg=--lib "$@"
