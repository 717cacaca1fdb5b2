# Sourced by dist/build and python/build-wheel in the project's folder.

# Prints the licences of all packages that are compiled into the packages of these folders, with the texts that they
# bring. cargo must have fetched the packages' sources.
licences() {
    local folder package licence name version rest sources=${CARGO_HOME:-~/.cargo}/registry/src
    for folder in "$@"; do
        cargo tree --locked --manifest-path "$folder/Cargo.toml" --edges normal --prefix none --format '{p}|{l}' --no-dedupe
    done | LC_ALL=C sort -u | while IFS='|' read -r package licence; do
        read -r name version rest <<<"$package"
        # A package with a path belongs to this project.
        [ -z "${rest//(proc-macro)/}" ] || continue
        printf '\n======== %s %s (%s)\n' "$name" "${version#v}" "$licence"
        find "$sources"/*/"$name-${version#v}" -maxdepth 1 -type f \
            \( -iname 'licen[cs]e*' -o -iname 'copying*' -o -iname 'notice*' -o -iname 'copyright*' \) -print0 |
            LC_ALL=C sort -z | xargs -0 --no-run-if-empty cat
    done
}
