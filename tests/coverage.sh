#!/usr/bin/env bash
# Prints a table of the lines and functions of cpu and output that the tests run. Lists the lines that no test runs in
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

[ "${1:-}" != --help ] || { sed -n '2,11s/^# \{0,1\}//p' tests/coverage.sh; exit; }
cargo llvm-cov clean --workspace
cargo llvm-cov --no-report test -p cpu -p output --lib
cargo llvm-cov --no-report test -p tests --tests
cargo llvm-cov --no-report test -p cli --test programs --test machine --test digests
# With the variable set, the code that chooses an instruction set by its name is run too.
for set in portable avx2; do
    RENDER_INSTRUCTION_SET=$set cargo llvm-cov --no-report test -p cli --test programs pictures
done
others='/(cli/src|cli/tests|gpu-check|lab|shaders|tests)/|/\.cargo/|/rustc/'
mkdir -p target/coverage
# Tests that limit the size of files leave incomplete profiles. With --failure-mode all, these are ignored, and the
# command fails only if no profile is complete.
cargo llvm-cov report --failure-mode all --ignore-filename-regex "$others" --show-missing-lines > target/coverage/missing.txt
cargo llvm-cov report --failure-mode all --ignore-filename-regex "$others" --summary-only "$@"
