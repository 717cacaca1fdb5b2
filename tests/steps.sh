# Sourced by the scripts that run many tests. `step COMMAND...` runs a command and goes on if it fails. `finish` lists what
# failed, with the commands that run it again, and its status is then 1. If one of these scripts is a step of another
# one, only the outer one lists.

set -o pipefail
# Many tests wait for programs, so there are twice as many at once as processors.
export RUST_TEST_THREADS=${RUST_TEST_THREADS:-$((2 * $(nproc)))}
steps_name=$0
steps_owner=no
if [ -z "${STEPS_FAILED:-}" ]; then
    steps_owner=yes
    STEPS_FAILED=$(mktemp)
    export STEPS_FAILED
    trap 'rm -f "$STEPS_FAILED" "$STEPS_FAILED.log."*' EXIT
fi
# The number of failures of the outer script before this one.
steps_before=$(wc -l <"$STEPS_FAILED")

# Prints, for what `cargo test` printed, the commands that run the failed tests again. Their beginning is $1, such as
# "env RENDER_INSTRUCTION_SET=avx2 cargo test".
steps_again() {
    awk -v start="$1" -v quote="'" '
        /^test .* \.\.\. FAILED/ {
            name = $0
            sub(/^test +(\[[^]]*\] +)?/, "", name)
            sub(/ +\.\.\. FAILED.*/, "", name)
            names = names " " (name ~ /[^A-Za-z0-9_:]/ ? quote name quote : name)
        }
        match($0, /to rerun pass `[^`]*`/) {
            print start " " substr($0, RSTART + 15, RLENGTH - 16) (names == "" ? "" : " -- --exact" names)
            names = ""
        }
    '
}

step() {
    local before log status=0 all
    printf -v all '%q ' "$@"
    all=${all% }
    before=$(wc -l <"$STEPS_FAILED")
    log=$STEPS_FAILED.log.$BASHPID
    echo "$steps_name: $*"
    "$@" 2>&1 | tee "$log" || status=$?
    [ $status -eq 0 ] && return
    # A step that is such a script has named its own failures.
    [ "$(wc -l <"$STEPS_FAILED")" -eq "$before" ] || return 0
    # All words up to `test`.
    steps_again "${all%% test *} test" <"$log" >>"$STEPS_FAILED"
    # Something else failed, such as the compiler.
    [ "$(wc -l <"$STEPS_FAILED")" -gt "$before" ] || echo "$all" >>"$STEPS_FAILED"
}

finish() {
    if [ "$(wc -l <"$STEPS_FAILED")" -eq "$steps_before" ]; then
        [ $steps_owner = no ] || echo "$steps_name: 0 failures"
        return
    fi
    if [ $steps_owner = yes ]; then
        echo "$steps_name: FAILED; these commands run it again:"
        sed 's/^/    /' "$STEPS_FAILED"
    fi
    return 1
}

# Prints the path of the folder into which `cargo build --release` puts the programs.
release_folder() {
    local target=${CARGO_TARGET_DIR:-target}
    [[ $target == /* ]] || target=$PWD/$target
    echo "$target/release"
}

# Prints the names of the instruction sets that this machine has. The message about an unknown set lists them.
sets_of_this_machine() {
    local said
    # With all packages: one package alone would be compiled again, with other features.
    cargo build --quiet --workspace --bin render-lab || return
    said=$(RENDER_INSTRUCTION_SET=none "${CARGO_TARGET_DIR:-target}/debug/render-lab" bench tasks 2>&1) || true
    [[ $said == *"this machine has "* ]] || { echo "$steps_name: no list of instruction sets: $said" >&2; return 1; }
    echo "${said##*this machine has }" | tr -d ,
}
