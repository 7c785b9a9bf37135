#!/bin/sh
# A job array of Slurm's: 40 cases end whole although workers are killed; a worker whose cases have two ranks, where this
# build has them. Debian's slurm-wlm, started here on loopback and stopped again; exit code 77, with the reason, where it is
# not installed or does not start.
. "$(dirname "$0")/common.sh"

skip() {
  echo "skipped: $*"
  exit 77
}

steps=${2:-6000} # so many that a case can be seen to run
slurm=$work/slurm
daemons=
stop_daemons() {
  for id in $daemons; do kill "$id" 2>/dev/null; done
  for id in $daemons; do wait "$id" 2>/dev/null; done
  rm -rf "$work"
}
trap stop_daemons EXIT

for program in munged slurmctld slurmd sbatch squeue scancel; do
  PATH=$PATH:/usr/sbin command -v $program >/dev/null || skip "$program is not installed (Debian: slurm-wlm, munge)"
done
[ "$(id -u)" = 0 ] || skip "slurmd wants to be root"
PATH=$PATH:/usr/sbin
unset SLURM_CONF

start_slurm() {
  chmod 755 "$work" # jobs' logs, sockets
  mkdir -p "$slurm/state" "$slurm/spool"
  dd if=/dev/urandom of="$slurm/key" bs=128 count=1 2>/dev/null
  chmod 600 "$slurm/key"
  munged --foreground --force --socket="$slurm/munge" --key-file="$slurm/key" --pid-file="$slurm/munged.pid" \
    --log-file="$slurm/munged.log" --seed-file="$slurm/seed" >"$slurm/munged.out" 2>&1 &
  daemons="$daemons $!"
  name=$(hostname -s)
  port=$((20000 + $$ % 20000))
  cat >"$slurm/slurm.conf" <<C
ClusterName=stiction
SlurmctldHost=$name(127.0.0.1)
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$slurm/munge
SlurmctldPort=$port
SlurmdPort=$((port + 1))
StateSaveLocation=$slurm/state
SlurmdSpoolDir=$slurm/spool
SlurmctldPidFile=$slurm/slurmctld.pid
SlurmdPidFile=$slurm/slurmd.pid
SlurmctldLogFile=$slurm/slurmctld.log
SlurmdLogFile=$slurm/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
SwitchType=switch/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_min_interval=100000
SlurmdParameters=config_overrides
KillWait=5
NodeName=node NodeHostname=$name NodeAddr=127.0.0.1 CPUs=4 State=UNKNOWN
PartitionName=main Nodes=node Default=YES MaxTime=60 State=UP
C
  export SLURM_CONF="$slurm/slurm.conf"
  await "[ -S $slurm/munge ]" || skip "munged does not start: $(cat "$slurm"/munged.*)"
  slurmctld -D -i >"$slurm/slurmctld.out" 2>&1 &
  daemons="$daemons $!"
  slurmd -D -N node >"$slurm/slurmd.out" 2>&1 &
  daemons="$daemons $!"
  await 'sinfo -h -o %T 2>/dev/null | grep -q idle' ||
    skip "slurmctld and slurmd do not start: $(tail -n 3 "$slurm"/slurmctld.log "$slurm"/slurmd.log 2>&1)"
}

rows() { sed 's/,[^,]*,\([^,]*\),\([^,]*\)$/,\1,\2/' "$1"; } # without the seconds

results() { grep -rl --include=manifest.json '^{"result":' "$1" | wc -l; }

holders() { # names of workers that have a case now
  for claim in shared/.claims/*; do
    case $claim in
    */worker+* | */=* | */dead.* | */probe.*) ;;
    *) head -n 1 "$claim" 2>/dev/null ;;
    esac
  done
}

start_slurm
changed drag "s/mu = { 0, 0.2, 0.4 }/mu = { $(seq -s ', ' 0 0.02 0.78) }/"
set -- --no-figures --set steps=$steps
expect 0 "checks held" "$stiction" run drag "$@" --out alone
holds "40 cases" [ "$(wc -l <alone/summary.csv)" = 41 ]

expect 2 "--on slurm: sbatch refused the job|nowhere" "$stiction" run drag "$@" --out shared --on slurm --partition nowhere
expect 0 ": 4 workers for 40 cases|stiction status drag --out shared|scancel" \
  "$stiction" run drag "$@" --out shared --on slurm --workers 4 --time 10 --partition main --sbatch=--job-name=sweep
job=$(sed -n 's/^job \([0-9]*\):.*/\1/p' output)
await '[ "$(results shared)" -ge 3 ]' || complain "nothing runs: $(squeue; cat shared/slurm/*.log)"
await '"$stiction" status drag --set steps=$steps --out shared >output && grep -q "of job $job" output' ||
  complain "status does not tell of tasks: $(cat output)"

# one is told to end, as before its time limit: its case is nobody's again
scancel --signal=TERM --batch "${job}_1"
await 'grep -q "stopped; finished cases are kept" shared/slurm/${job}_1.log' ||
  complain "told to end: $(cat "shared/slurm/${job}_1.log")"

# others are killed outright
for after in 6 10 14; do
  await "[ \$(results shared) -ge $after ]"
  dead=
  for worker in $(holders | sort -u); do # of those killed before too
    id=${worker%+*}
    [ -n "$dead" ] || ! kill -KILL "${id##*+}" 2>/dev/null || dead=$worker
  done
  [ -n "$dead" ] || complain "there is no worker to be killed: $(holders)"
done
await '! squeue -h -j $job 2>/dev/null | grep -q .' 600
if [ "$(results shared)" -lt 40 ] || ! grep -q "checks held" shared/slurm/*.log; then # Slurm's own word: all four are gone
  expect 0 " for |cases" "$stiction" run drag "$@" --out shared --on slurm --workers 2
  job=$(sed -n 's/^job \([0-9]*\):.*/\1/p' output)
  await '! squeue -h -j $job 2>/dev/null | grep -q .' 600
fi
await 'grep -q "checks held" shared/slurm/*.log' || complain "no worker judged: $(tail -n 5 shared/slurm/*.log)"
rows alone/summary.csv >one
rows shared/summary.csv >other
holds "the same summary: $(diff one other)" cmp -s one other
holds "claims are left: $(ls -A shared/.claims)" [ -z "$(ls -A shared/.claims)" ]
expect 0 "nothing to submit" "$stiction" run drag "$@" --out shared --on slurm
expect 0 "40 of 40 cases done, 0 failed, 0 running, 0 waiting" "$stiction" status drag --set steps=$steps --out shared

# two tasks share each case
cp -r "$here/block" .
"$stiction" run block --ranks 2 --no-figures --case lawlinear --out probe >output 2>&1
if grep -q "built without PETSc" output; then
  echo "without ranks: petsc-dev is not installed, or was not when this was built"
  finish
fi
expect 0 ": 1 worker for 2 cases" "$stiction" run block --ranks 2 --no-figures --out tasks --on slurm --workers 1
job=$(sed -n 's/^job \([0-9]*\):.*/\1/p' output)
scontrol show job "$job" >job
await '[ "$(results tasks)" = 2 ]' || complain "two ranks do not end: $(cat tasks/slurm/*.log)"
await '! squeue -h -j $job 2>/dev/null | grep -q .' 60
holds "two tasks: $(cat job)" grep -q "NumTasks=2" job
holds "the manifest tells of ranks" grep -q '"ranks": 2' tasks/lawfinite/manifest.json
expect 0 "finished" "$stiction" run block --no-figures --set bulk=multigrid --out whole
numbers_of_block whole >whole.csv
numbers_of_block tasks >tasks.csv
holds "ranks in tasks: $(near whole.csv tasks.csv 1e-8)" near whole.csv tasks.csv 1e-8
finish
