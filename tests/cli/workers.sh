#!/bin/sh
# Workers on one folder that are killed at random moments: what is missing, and only that, is run again, and the summary is
# to the last bit that of a run that nobody disturbed. $2: how many moments (default 6); $3: seed (default 1).
. "$(dirname "$0")/common.sh"
moments=${2:-6}
seed=${3:-1}

appears() { # FILE: waits for it, a minute at most
  for _ in $(seq 600); do
    [ -e "$1" ] && return
    sleep 0.1
  done
}

rows() { sed 's/,[^,]*,\([^,]*\),\([^,]*\)$/,\1,\2/' "$1"; } # without the seconds

random() { # from 0 to 1, by the seed and how often it was asked
  asked=$((${asked:-0} + 1))
  awk -v seed="$((seed * 1000003 + asked * 7919))" 'BEGIN { srand(seed); rand(); print rand() }'
}

begin() { # NUMBER: a worker of this number
  "$stiction" run drag --worker --no-figures --set steps=300 --out shared >"log.$1" 2>&1 </dev/null &
  eval "worker_$1=\$!"
}

running() { [ -n "$(cases_running)" ]; } # whether a case runs still

stamps() { # of cases that have ended well: name and when
  grep -l '"verdict":"finished"' shared/*/manifest.json 2>/dev/null | while read -r file; do
    stat -c '%n %y %i' "$file"
  done | sort
}

changed drag "s/mu = { 0, 0.2, 0.4 }/mu = { $(seq -s ', ' 0 0.02 0.78) }/"
expect 0 "checks held" "$stiction" run drag --no-figures --set steps=300 --out alone
rows alone/summary.csv >one
killed=0
rounds=0
while [ "$killed" -lt "$moments" ]; do
  rounds=$((rounds + 1))
  rm -rf shared
  for which in 1 2 3; do begin $which; done
  while [ "$killed" -lt "$moments" ] && [ "$(stamps | wc -l)" -lt 36 ]; do
    sleep "$(random)"
    which=$(random | awk '{ print 1 + int(3 * $1) }')
    eval "id=\$worker_$which"
    kill -KILL "$id" 2>/dev/null && killed=$((killed + 1))
    wait "$id" 2>/dev/null
    begin "$which"
  done
  # shellcheck disable=SC2154 # set by begin
  kill -KILL "$worker_1" "$worker_2" "$worker_3" 2>/dev/null
  wait
  for _ in $(seq 100); do # what they had begun ends too
    running || break
    sleep 0.1
  done
  stamps >before
  expect 0 "checks held" "$stiction" run drag --worker --no-figures --set steps=300 --out shared
  stamps >after
  holds "round $rounds: a case that had finished ran again: $(comm -23 before after)" [ -z "$(comm -23 before after)" ]
  rows shared/summary.csv >other
  holds "round $rounds: the same summary: $(diff one other)" cmp -s one other
  holds "round $rounds: claims are left: $(ls -A shared/.claims)" [ -z "$(ls -A shared/.claims)" ]
done
echo "$killed workers killed in $rounds rounds, seed $seed"

# a worker waits for the last cases, another that finds nothing to begin leaves them to it; who waits takes over
"$stiction" run drag --worker --no-figures --set steps=30000 --where 'mu == 0' --out last >log.1 2>&1 </dev/null &
busy=$!
appears last/mu0/series.h5
"$stiction" run drag --worker --no-figures --set steps=30000 --where 'mu == 0' --out last >log.2 2>&1 </dev/null &
waits=$!
appears "last/.claims/=standby"
expect 0 "process $waits on|waits for the last ones|this worker did 0 cases" \
  "$stiction" run drag --worker --no-figures --set steps=30000 --where 'mu == 0' --out last
expect 0 "0 of 40 cases done, 0 failed, 1 running, 39 waiting|process $busy on|2 workers" "$stiction" status drag --set steps=30000 --out last
expect 0 "mu0: running: it runs: process $busy on" "$stiction" show last
kill -KILL "$busy"
wait "$busy" 2>/dev/null
wait "$waits" || complain "who waited: $(cat log.2)"
holds "it did not take over: $(cat log.2)" grep -q '^mu0 .*finished' last/summary.csv log.2

# told to end, it does, and its claim is nobody's
"$stiction" run drag --worker --no-figures --set steps=60000 --out told >log.1 2>&1 </dev/null &
id=$!
appears told/.claims
for _ in $(seq 600); do
  "$stiction" status told >output 2>&1 && grep -q "0 of 40 cases done, 0 failed, 1 running, 39 waiting" output && break
  sleep 0.1
done
holds "cases that have not begun are counted: $(cat output)" grep -q "1 running, 39 waiting" output
kill "$id"
wait "$id"
code=$?
holds "told to end it ended with $code: $(cat log.1)" [ "$code" = 1 ]
holds "no word: $(cat log.1)" grep -q "stopped; finished cases are kept, the same command goes on from here" log.1
holds "claims are left: $(ls -A told/.claims)" [ -z "$(ls -A told/.claims)" ]
expect 0 "nobody works on it; 'stiction run STUDY' goes on from here" "$stiction" status drag --set steps=60000 --out told
expect 0 "cases that have not begun do not show in the folder: 'stiction status STUDY' counts them" "$stiction" status told

# nothing can be written any more: this worker ends and fails no case, another one goes on
expect 1 "File too large|this run ends, and leaves case|to those that can write" \
  sh -c 'ulimit -f 200 && exec "$@"' sh "$stiction" run drag --worker --no-figures --set steps=400 --out full
holds "a case failed for want of room" [ -z "$(grep -rl '^{"result":' full)" ]
holds "claims are left: $(ls -A full/.claims)" [ -z "$(ls -A full/.claims)" ]
expect 0 "checks held" "$stiction" run drag --worker --no-figures --set steps=400 --out full

# a plain run shows itself too, and who is dead
"$stiction" run drag --jobs 1 --no-figures --set steps=60000 --out plain >log.1 2>&1 </dev/null &
id=$!
for _ in $(seq 600); do
  "$stiction" status drag --set steps=60000 --out plain >output 2>&1 && grep -q "mu0 .* of 2 s, step" output && break
  sleep 0.1
done
holds "a run in another terminal: $(cat output)" grep -q "process $id on .* mu0 .* of 2 s, step" output
kill -KILL "$id"
wait "$id" 2>/dev/null
for _ in $(seq 100); do
  "$stiction" status plain >output 2>&1
  grep -q "dead: its process has ended" output && break
  sleep 0.1
done
holds "who is dead: $(cat output)" grep -q "process $id on .*dead: its process has ended" output
sed -i 's/^{"result":.*/{/' plain/mu0/manifest.json # as of a case that was killed with it
expect 0 "mu0: not finished: its worker is dead: process $id on" "$stiction" show plain

# batch systems: one clear message each
expect 2 "--on slurm: there is no sbatch here|stiction run STUDY --worker" env PATH=/nowhere "$stiction" run drag --on slurm --out batch
mkdir -p bin
printf '#!/bin/sh\necho "sbatch: error: Batch job submission failed: Invalid job array specification" >&2\nexit 1\n' >bin/sbatch
chmod +x bin/sbatch
expect 2 "--on slurm: sbatch refused the job (exit code 1): sbatch: error: Batch job submission failed: Invalid job array specification" \
  env PATH="$work/bin:$PATH" "$stiction" run drag --on slurm --out batch
printf '#!/bin/sh\necho "$@" >>%s/asked\necho "77;cluster"\n' "$work" >bin/sbatch
expect 0 "job 77: 3 workers for 40 cases|stiction status drag --out batch|squeue --job 77|scancel 77" \
  env PATH="$work/bin:$PATH" "$stiction" run drag --on slurm --workers 3 --time 1:00:00 --partition long --sbatch=--mem=2G \
  --set "side=1 mm" --out batch
holds "one array: $(cat asked)" [ "$(grep -c -- '--array=1-3 .*--time=1:00:00 --partition=long --mem=2G .*/batch/slurm/worker.sh' asked)" = 1 ]
holds "the worker: $(cat batch/slurm/worker.sh)" \
  grep -q "^exec .* run $work/drag --worker --out $work/batch --set 'side=1 mm'$" batch/slurm/worker.sh
expect 2 "--on pbs: only slurm is known" "$stiction" run drag --on pbs
expect 2 "--time is about workers that a batch system starts; give --on slurm too" "$stiction" run drag --time 1:00
expect 2 "--worker: a sweep that is shared takes no --force" "$stiction" run drag --worker --force
expect 2 "there is neither an output folder nor a study at 'nowhere'" "$stiction" status nowhere
finish
