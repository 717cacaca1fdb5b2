#!/usr/bin/env bash
# Prints a table of the lines and functions of cpu that the tests run. The lines that they miss go to
# target/coverage/missing.txt.
#
#   tests/coverage.sh [OPTION OF cargo llvm-cov report]...
#
#   tests/coverage.sh --fail-under-lines 95
#
# Needs cargo install --locked cargo-llvm-cov, and LLVM's tools of the compiler's version (rustc -vV names it): the
# component llvm-tools, or Debian's llvm-22 with LLVM_COV=llvm-cov-22 LLVM_PROFDATA=llvm-profdata-22.
set -euo pipefail
cd "$(dirname "$0")/.."

[ "${1:-}" != --help ] || { sed -n '2,11s/^# \{0,1\}//p' "$0"; exit; }
cargo llvm-cov clean --workspace
cargo llvm-cov --no-report test -p cpu --lib
cargo llvm-cov --no-report test -p tests --tests
cargo llvm-cov --no-report test -p cli --test programs --test machine --test digests
# Forced, so that the way in which an instruction set is asked for by name is run too.
for set in portable avx2; do
    RENDER_INSTRUCTION_SET=$set cargo llvm-cov --no-report test -p cli --test programs pictures
done
others='/(cli|gpu-check|lab|shaders|tests)/|/\.cargo/|/rustc/'
mkdir -p target/coverage
# A program that may write no larger file leaves half a profile; --failure-mode all fails where there is no whole one.
cargo llvm-cov report --failure-mode all --ignore-filename-regex "$others" --show-missing-lines > target/coverage/missing.txt
cargo llvm-cov report --failure-mode all --ignore-filename-regex "$others" --summary-only "$@"
