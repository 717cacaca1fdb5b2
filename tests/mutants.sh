#!/usr/bin/env bash
# Which mistakes in cpu no test would notice: cargo-mutants on the parsers, camera, materials, intersections, image and
# output, against cpu's own unit tests. Half an hour on one core; arguments go to cargo mutants, such as -f FILE. What
# follows -- goes to cargo test: tests/mutants.sh -f cpu/src/output.rs -- output::
#
# Needs cargo install --locked cargo-mutants. Mutants do what nobody meant, and one of output.rs may well rename a file
# over what it is told to write to: as root this runs where nothing outside the temporary folders can be changed.
set -euo pipefail
cd "$(dirname "$0")/.."

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
