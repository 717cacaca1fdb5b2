#!/usr/bin/env bash
# Runs all unit tests: those beside the functions they test, and the examples in the comments.
#
#   tests/utest.sh [common | aos | soa | OPTION OF cargo test]...
#
#   tests/utest.sh aos          # the tests of this layout: the statement's utest-aos; likewise soa
#   tests/utest.sh common       # the other tests of the evaluated programs: the statement's utest-common
#   tests/utest.sh cylinder     # only the tests with this word in their names
set -euo pipefail
cd "$(dirname "$0")/.."

[ "${1:-}" != --help ] || { sed -n '2,8s/^# \{0,1\}//p' tests/utest.sh; exit; }
evaluated=(-p cpu -p cli -p output --lib --bins)
case ${1:-} in
    aos | soa) exec cargo test "${evaluated[@]}" "$1::" "${@:2}" ;;
    common) exec cargo test "${evaluated[@]}" "${@:2}" -- --skip aos:: --skip soa:: ;;
esac
. tests/steps.sh
step cargo test --workspace --lib --bins --no-fail-fast "$@"
step cargo test --workspace --doc --no-fail-fast "$@"
finish
