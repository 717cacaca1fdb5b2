#!/usr/bin/env bash
# Tests lab/slurm on a real Slurm of one node, which this script starts on this machine and stops at the end.
#
#   tests/slurm.sh
#
# In run 1 all tasks and the join must succeed. In run 2 a task fails: the join must be cancelled, and the commands that
# `submit` prints must finish the run. Needs root, and Debian's slurm-wlm and munge (tests/run --slurm installs them).
# Writes only into a temporary folder, except for Slurm's folder of control groups (cgroups) on this machine.
set -euo pipefail
cd "$(dirname "$0")/.."

[ "${1:-}" != --help ] || { sed -n '2,8s/^# \{0,1\}//p' tests/slurm.sh; exit 0; }
say() { echo "tests/slurm.sh: $*"; }
fail() { say "FAILED: $*" >&2; tail -n 20 "$work"/*.log >&2 2>/dev/null || true; exit 1; }
for program in munged slurmctld slurmd sbatch; do
    command -v $program >/dev/null || { say "$program is missing: apt-get install slurm-wlm munge" >&2; exit 2; }
done
[ "$(id -u)" -eq 0 ] || { say "root is needed to start slurmd" >&2; exit 2; }

work=$(mktemp -d /tmp/slurm.XXXXXX)
started=()
# drain SECONDS: waits until no job is left. Fails if jobs are left after this time, or if a daemon has ended. A failure
# of squeue, which may come from a busy machine, does not mean that the queue is empty.
drain() {
    local jobs process
    for try in $(seq "$1"); do
        if jobs=$(squeue -h 2>/dev/null) && [ -z "$jobs" ]; then
            return
        fi
        for process in "${started[@]}"; do
            kill -0 "$process" 2>/dev/null || { say "a daemon of Slurm has ended" >&2; return 1; }
        done
        sleep 1
    done
    say "these jobs are left: $jobs" >&2
    return 1
}

# Ends the jobs before the daemons, because a job goes on when its daemon has ended.
stop() {
    if squeue -h >/dev/null 2>&1; then
        scancel --user=root 2>/dev/null || true
        drain 60 || true
    fi
    for process in "${started[@]}"; do kill "$process" 2>/dev/null || true; done
    for process in "${started[@]}"; do wait "$process" 2>/dev/null || true; done
    # If slurmctld ended early, jobs are left. They have the configuration's path in their environment.
    for environment in /proc/[0-9]*/environ; do
        if grep -qzxF "SLURM_CONF=$work/slurm.conf" "$environment" 2>/dev/null; then
            kill -KILL "${environment//[!0-9]/}" 2>/dev/null || true
        fi
    done
    rm -rf "$work"
}
trap stop EXIT
trap 'exit 130' INT TERM HUP

# munged refuses a folder that other users may write to. Slurm finds munged by its socket.
chmod 755 "$work"
install -d -m 755 "$work"/{munge,state,spool}
dd if=/dev/urandom of="$work/munge/key" bs=1024 count=1 status=none
chmod 400 "$work/munge/key"
munged --foreground --force --key-file="$work/munge/key" --socket="$work/munge/socket" --pid-file="$work/munge/pid" \
    --log-file="$work/munge/log" --seed-file="$work/munge/seed" >"$work/munged.log" 2>&1 &
started+=($!)

cat >"$work/slurm.conf" <<END
ClusterName=tests
SlurmctldHost=$(hostname)(127.0.0.1)
SlurmUser=root
SlurmctldPort=16817
SlurmdPort=16818
AuthType=auth/munge
AuthInfo=socket=$work/munge/socket
CredType=cred/munge
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
SlurmctldLogFile=$work/slurmctld.log
SlurmdLogFile=$work/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=2,batch_sched_delay=1
ReturnToService=2
MpiDefault=none
NodeName=$(hostname) NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
END
echo "CgroupPlugin=cgroup/v1" >"$work/cgroup.conf"
export SLURM_CONF="$work/slurm.conf"

until [ -S "$work/munge/socket" ]; do
    kill -0 "${started[0]}" 2>/dev/null || fail "munged does not start"
    sleep 0.2
done
slurmctld -D -f "$SLURM_CONF" >"$work/slurmctld-out.log" 2>&1 &
started+=($!)
sleep 2
slurmd -D -f "$SLURM_CONF" >"$work/slurmd-out.log" 2>&1 &
started+=($!)
for try in $(seq 60); do
    [ "$(sinfo -h -o %T 2>/dev/null)" = idle ] && break
    [ "$try" -lt 60 ] || fail "the node does not become idle: $(sinfo 2>&1)"
    sleep 1
done
say "$(sinfo --version) runs on $(hostname)"

if [ -z "${RENDER_LAB:-}" ]; then
    cargo build --release --bin render-lab
    RENDER_LAB=$(realpath "${CARGO_TARGET_DIR:-target}")/release/render-lab
fi
export RENDER_LAB
tasks=$("$RENDER_LAB" bench tasks | wc -l)

say "run 1: $tasks tasks and a join"
lab/slurm/submit "$work/good" --quick --repeats 1 | tee "$work/said.log"
drain 1200 || fail "run 1 does not end"
[ "$(ls "$work"/good/part-*.json | wc -l)" -eq "$tasks" ] || fail "run 1 has not $tasks parts"
[ -s "$work/good/bench.json" ] || fail "run 1 has no bench.json"

say "run 2: a task that fails"
# Task 1 fails until the file "healed" is there. The results of all other tasks are those of run 1. The folder's name
# has a space, because the commands that `submit` prints must work with such a name too.
cat >"$work/render-lab" <<END
#!/usr/bin/env bash
case "\$*" in
    "bench all --part 1/"*) [ -e "$work/healed" ] || exit 3 ;;
    "bench all --part "*) part=\${4%%/*}; cp "$work/good/part-\$part.json" "$work/bad run/"; exit ;;
esac
exec "$RENDER_LAB" "\$@"
END
chmod 755 "$work/render-lab"
RENDER_LAB="$work/render-lab" lab/slurm/submit "$work/bad run" --quick --repeats 1 >"$work/said.log"
drain 300 || fail "the join waits for ever"
[ ! -e "$work/bad run/bench.json" ] || fail "run 2 was joined without its first task"
touch "$work/healed"
export RENDER_LAB="$work/render-lab"
# Runs the commands that `submit` printed.
again=$(sed -n 's/^Run a failed task N again: *//p' "$work/said.log" | sed 's/--array=N/--array=1/')
join=$(sed -n 's/^Then join them: *//p' "$work/said.log")
bash -c "$again" && drain 600 && bash -c "$join" && drain 60 || fail "what submit says does not work: $again; $join"
[ -s "$work/bad run/bench.json" ] || fail "run 2 has no bench.json in the end"
say "passed: $tasks tasks joined; a failed task cancelled the join, was run again and joined"
