#!/usr/bin/env bash
# A sweep on Slurm with two nodes on this machine: a task of one is preempted, the other node is killed in the middle.
# The table is that of a sweep without Slurm, bit by bit. Everything lies in a temporary folder, with a munged and ports
# of its own; skipped where slurm-wlm and munge are not installed.
# tests/scripts/sweep_slurm_test.sh KNUCKLE [RUNS]
set -euo pipefail
program=$(realpath "$1") runs=${2:-30}
root=$(realpath "$(dirname "${BASH_SOURCE[0]}")/../..")
export PATH=$PATH:/usr/sbin
for tool in slurmctld slurmd sbatch munged; do
    command -v "$tool" >/dev/null || { echo "skipped: no $tool (apt-get install slurm-wlm munge)"; exit 77; }
done
[[ $(id -u) == 0 ]] || { echo "skipped: slurmd wants to be root"; exit 77; }

folder=$(mktemp -d)
services=()
# Processes of a node's tasks, of all nodes without one: the workers, and Slurm's process above each.
task_processes() {
    local file process
    for file in /proc/[0-9]*/environ; do
        process=${file#/proc/} process=${process%/environ}
        if grep -qz "^SLURM_CONF=$folder/" "$file" && grep -qz "^SLURMD_NODENAME=${1:-}" "$file"; then
            echo "$process"
            awk '{ print $4 }' "/proc/$process/stat"
        fi
    done 2>/dev/null | sort -un | while read -r process; do
        if grep -qxE 'knuckle|slurmstepd' "/proc/$process/comm" 2>/dev/null; then echo "$process"; fi
    done
}
cleanup() {
    local processes
    processes=$(task_processes || true)
    kill -9 ${services[@]+"${services[@]}"} $processes 2>/dev/null || true
    rm -rf "$folder" 2>/dev/null || { sleep 1; rm -rf "$folder"; } || true
}
trap cleanup EXIT
fail() {
    printf '%s\n' "$@" >&2
    tail -n 20 "$folder"/*.log >&2 || true
    exit 1
}
# wait_until SECONDS COMMAND ...
wait_until() {
    local end=$((SECONDS + $1))
    shift
    until "$@"; do
        ((SECONDS < end)) || fail "waited in vain for: $*"
        sleep 0.2
    done
}

host=$(hostname -s)
mkdir "$folder"/{state,n1,n2}
head -c 1024 /dev/urandom >"$folder/munge.key"
chmod 600 "$folder/munge.key"
munge=$(shuf -i 20000-29000 -n 1)
cat >"$folder/slurm.conf" <<CONF
ClusterName=test
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$munge
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$folder/munge.socket
CryptoType=crypto/munge
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/%n
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/%n.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/%n.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmdTimeout=10
ReturnToService=2
KillWait=5
MpiDefault=none
NodeName=n1 NodeHostname=$host NodeAddr=127.0.0.1 Port=$((munge + 1)) CPUs=1
NodeName=n2 NodeHostname=$host NodeAddr=127.0.0.1 Port=$((munge + 2)) CPUs=1
PartitionName=test Nodes=ALL Default=YES State=UP
CONF
export SLURM_CONF=$folder/slurm.conf
# start NAME COMMAND ...
start() {
    local name=$1
    shift
    "$@" >"$folder/$name.said.log" 2>&1 &
    services+=($!)
    disown
}
start munged munged --foreground --force --key-file="$folder/munge.key" --socket="$folder/munge.socket" \
    --pid-file="$folder/munge.pid" --log-file="$folder/munge.log" --seed-file="$folder/munge.seed"
wait_until 10 test -S "$folder/munge.socket"
start slurmctld slurmctld -D
start n1 slurmd -D -N n1
start n2 slurmd -D -N n2
second=${services[-1]}
both_idle() { [[ $(sinfo -h -N -o '%N %t' 2>/dev/null) == $'n1 idle\nn2 idle' ]]; }
wait_until 30 both_idle

cat >"$folder/throw.json" <<SCENE
{
  "duration": 1, "diameter": 0.06, "colliders": [{ "type": "plane" }],
  "objects": [{ "type": "actor", "name": "doll", "file": "$root/assets/models/humanoid.glb",
                "position": [0, 0.3, 0], "velocity": [0, 0, 0] }],
  "render": { "width": 64, "height": 36 }
}
SCENE
cat >"$folder/plan.json" <<PLAN
{
  "scene": "throw.json", "runs": $runs, "seed": 7, "checkpoint": 0.2, "bodies": ["doll/hips"],
  "fields": [{ "path": "objects.0.velocity", "range": [[1, 1, -1], [4, 3, 1]] }]
}
PLAN
sweep() { "$program" --device software sweep "$@"; }
done_runs() { ls "$folder"/farm/run_*/done.json 2>/dev/null | wc -l; }
some_done() { (($(done_runs) >= runs / 3)); }
all_done() { (($(done_runs) == runs)); }

sweep "$folder/plan.json" -o "$folder/farm" --slurm='--time=10' --jobs 4
# A task that Slurm preempts: all of its processes get SIGTERM.
one_done() { (($(done_runs) >= 1)); }
one_stopped() { grep -qs '^knuckle: stopped' "$folder"/farm/slurm_*.log; }
wait_until 60 one_done
scontrol requeue "$(squeue -h -t running -w n1 -o %F_%K)"
wait_until 60 one_stopped
wait_until 120 some_done
doomed=$(task_processes n2)
[[ -n $doomed ]] || fail "no task on the second node"
kill -9 "$second" $doomed
echo "node n2 killed with $(wc -w <<<"$doomed") processes of its task, after $(done_runs) of $runs runs"
wait_until 300 all_done
! grep -ls '"failed":true' "$folder"/farm/run_*/end.* || fail "who was stopped counts as failed"
sweep collect "$folder/plan.json" -o "$folder/farm"
claims=$(ls "$folder"/farm/run_*/claim.* | wc -l)
((claims > runs)) || fail "the killed node had no run that another took over"

sweep "$folder/plan.json" -o "$folder/here" --jobs 2 2>/dev/null
sweep -q collect "$folder/plan.json" -o "$folder/here"
cmp "$folder/farm/table.csv" "$folder/here/table.csv" || fail "the tables differ"
[[ $(wc -l <"$folder/farm/table.csv") == $((runs + 1)) ]] || fail "the table is not whole"
! grep -q ',,' "$folder/farm/table.csv" || fail "the table has gaps"
echo "$runs runs, $claims claims: the table is that of one machine, bit by bit"
