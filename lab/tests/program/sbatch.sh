#!/usr/bin/env bash
# Replaces sbatch in a test. Runs the job script after the options once for each task of the array, and prints a job
# number as `sbatch --parsable` does. For most tasks it copies an empty result instead, because measuring takes too long
# for a test.
set -euo pipefail
echo "$*" >> "$STUB_LOG"
tasks=1
while [[ "$1" == --* ]]; do
    [[ "$1" == --array=1-* ]] && tasks="${1#--array=1-}"
    shift
done
script="$1"
shift
for ((task = 1; task <= tasks; task++)); do
    # Only the first task is run.
    if ((tasks > 1 && task > 1)); then
        (($# >= 1)) && cp "$1/empty.json" "$1/part-$task.json"
        continue
    fi
    SLURM_ARRAY_TASK_ID="$task" SLURM_ARRAY_TASK_COUNT="$tasks" bash "$script" "$@" 2>> "$STUB_LOG"
done
echo "77;cluster"
