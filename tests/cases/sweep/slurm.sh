#!/bin/bash
# A sweep in a real Slurm: controller, daemon and munge of this machine, started and ended here: slurm.sh FURNAS.
# Says 77, with a sentence, where they are not installed.

set -eu

furnas=$1
for program in munged slurmctld slurmd sbatch squeue; do
  PATH=$PATH:/usr/sbin command -v $program >/dev/null 2>&1 || {
    echo "skipped: $program is not installed (Debian: apt-get install slurm-wlm munge)"
    exit 77
  }
done
[ "$(id -u)" = 0 ] || {
  echo "skipped: the daemon of Slurm runs jobs for root only when it runs as root"
  exit 77
}
export PATH=$PATH:/usr/sbin

room=$(mktemp -d /tmp/furnas_slurm_XXXXXX)
started=()
job=
finish() {
  [ -z "$job" ] || { scancel "$job" && sleep 2; } || true  # a task would outlive the daemons
  for process in "${started[@]}"; do kill "$process" 2>/dev/null || true; done
  for process in "${started[@]}"; do
    for _ in $(seq 100); do kill -0 "$process" 2>/dev/null || break; sleep 0.1; done
  done
  rm -rf "$room"
}
trap finish EXIT

port=$((20000 + RANDOM % 20000))
mkdir -p "$room/state" "$room/spool" "$room/munge"
chmod 700 "$room/munge"
chmod 755 "$room"
dd if=/dev/urandom of="$room/munge/key" bs=1024 count=1 status=none
chmod 600 "$room/munge/key"
munged --foreground --force --key-file="$room/munge/key" --socket="$room/munge.socket" --pid-file="$room/munge/pid" \
  --log-file="$room/munge/log" --seed-file="$room/munge/seed" &
started+=($!)

cat >"$room/slurm.conf" <<CONF
ClusterName=furnas
SlurmctldHost=$(hostname -s)(127.0.0.1)
SlurmctldPort=$port
SlurmdPort=$((port + 1))
AuthType=auth/munge
AuthInfo=socket=$room/munge.socket
CredType=cred/munge
SlurmUser=root
StateSaveLocation=$room/state
SlurmdSpoolDir=$room/spool
SlurmctldPidFile=$room/slurmctld.pid
SlurmdPidFile=$room/slurmd.pid
SlurmctldLogFile=$room/slurmctld.log
SlurmdLogFile=$room/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory
JobAcctGatherType=jobacct_gather/none
MpiDefault=none
ReturnToService=2
JobRequeue=1
MinJobAge=3600
NodeName=$(hostname -s) NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=1500 State=UNKNOWN
PartitionName=test Nodes=ALL Default=YES MaxTime=INFINITE State=UP
CONF
export SLURM_CONF=$room/slurm.conf
slurmctld -D -f "$SLURM_CONF" >/dev/null 2>&1 &
started+=($!)
slurmd -D -f "$SLURM_CONF" >/dev/null 2>&1 &
started+=($!)

fail() {
  echo "failed: $1"
  tail -n 20 "$room"/slurmctld.log "$room"/slurmd.log "$room"/out/slurm-*.out 2>/dev/null
  exit 1
}
for _ in $(seq 300); do
  [ "$(sinfo -h -o %t 2>/dev/null)" = idle ] && break
  sleep 0.2
done
[ "$(sinfo -h -o %t)" = idle ] || fail "the node does not come up"

# Four samples of some thirty seconds, so that a task of one core, whose worker has a minute less than Slurm gives
# it, takes two at least.
cat >"$room/case.toml" <<CASE
[mixture]
large = 100
start_fraction = 0.25
[stop]
kinetic_energy = 1e-30
steps = ${FURNAS_SLURM_STEPS:-5_000_000}
[output]
picture = "none"
[sweep]
samples = 4
CASE
"$furnas" sweep "$room/case.toml" --out "$room/out" --slurm --jobs 1 --walltime 2m --partition test | tee "$room/said"
submit=$(sed -n 's/^submit *//p' "$room/said")
job=$($submit | awk '{ print $4 }')
[ -n "$job" ] || fail "$submit"
for _ in $(seq 1500); do
  [ -z "$(squeue -h -j "$job")" ] && break
  sleep 1
done
[ -z "$(squeue -h -j "$job")" ] || fail "the job does not end"

restarts=$(scontrol show job "$job" | sed -n 's/.*Restarts=\([0-9]*\).*/\1/p' | awk '{ n += $1 } END { print n }')
done_samples=$(grep -l '^done' "$room"/out/turns/* | wc -l)
rows=$(grep -c ',budget,all steps are spent' "$room/out/sweep.csv" || true)
echo "tasks begun again $restarts, samples done $done_samples, rows of the table $rows"
[ "$done_samples" = 4 ] || fail "not every sample is done once"
[ "$rows" = 4 ] || fail "the table is not whole"
[ "$restarts" -ge 1 ] || fail "no task was begun again after its time"
"$furnas" sweep "$room/case.toml" --out "$room/out" 2>&1 | grep -q '4 of 4 samples are finished' || fail "not finished"
