#!/usr/bin/env bash
# A study that GNU parallel hands to two workers: killed in the middle, program and workers together,
# and taken up again, it does nothing twice, loses nothing, and its table is that of one worker, byte
# for byte.
# Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_cli_parallel.sh BUILD SOURCE}")

fail() {
    printf '%s\n' "$*"
    exit 1
}

command -v parallel >/dev/null || fail "parallel is missing; ./test.sh installs it"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
# Workers' jobs, each of which notes itself: GNU parallel gives them groups of their own. One that comes
# late sees that all is to end.
cat >worker <<END
#!/bin/sh
echo \$\$ >>"$work/pids"
[ ! -e "$work/stop" ] || exit 1
exec "$build/skvalp" "\$@"
END
chmod +x worker

# list FOLDER: the jobs of the study, for the workers.
study=(lab dam-break --sweep particles=400:600:5 --sweep 'fluid.law=calibrated,clavet')
list() {
    "$build/skvalp" "${study[@]}" --jobs "$1" | sed "s|^'*$build/skvalp'*|./worker|"
}

# done_of FOLDER: the tables that are there, with what would change if one was written again.
done_of() {
    find "$1" -name 'dam-break*.csv' -printf '%f %i %T@\n' | sort
}

alive() {
    [[ -e /proc/$1 && $(<"/proc/$1/stat") != *') Z '* ]] 2>/dev/null
}

list one >one.txt
[[ $(wc -l <one.txt) == 10 ]] || fail "the list has other than ten jobs: $(<one.txt)"
sh -e one.txt
"$build/skvalp" lab --gather one --csv one.csv

# Killed when some runs are done and one is at work, which its file shows; if all were done before
# that was seen, once more.
for try in {1..20}; do
    rm -rf two pids log stop
    list two >two.txt
    parallel --will-cite -j2 --joblog log <two.txt &
    parallel=$!
    until [[ $(done_of two | wc -l) -ge 2 && -n $(find two -name '.skvalp-*') ]] || ! alive "$parallel"; do
        sleep 0.01
    done
    touch stop
    kill -KILL "$parallel" 2>/dev/null || true
    wait "$parallel" 2>/dev/null || true
    while read -r pid; do
        kill -KILL "$pid" 2>/dev/null || true
        while alive "$pid"; do sleep 0.01; done
    done <pids
    done_of two >before
    (($(wc -l <before) == 10)) || break
done
(($(wc -l <before) < 10)) || fail "in $try tries all runs were done before they were killed"

status=0
"$build/skvalp" lab --gather two --csv two.csv 2>notes || status=$?
((status == 1)) || fail "gathering half a study ends with $status: $(<notes)"
lack=$((10 - $(wc -l <before)))
grep -q "lab: $lack of 10 runs lack" notes || fail "$lack runs lack, and this is said: $(<notes)"

rm stop
# Taken up from parallel's log, then without it, then by one worker.
parallel --will-cite -j2 --resume --joblog log <two.txt || fail "going on from parallel's log failed"
parallel --will-cite -j2 <two.txt || fail "going on without a log failed"
sh -e two.txt || fail "going on with one worker failed"
done_of two >after
[[ $(wc -l <after) == 10 ]] || fail "of ten tables $(wc -l <after) are there"
[[ -z $(comm -23 before after) ]] || fail "runs were done again: $(comm -23 before after)"
[[ -z $(find two -name '.skvalp-*') ]] || fail "what was killed has left files: $(ls -A two)"
"$build/skvalp" lab --gather two --csv two.csv
cmp one.csv two.csv || fail "two workers' table is another than one worker's"
printf 'parallel: killed with %d of 10 runs done, taken up again, the table is the same\n' \
    "$(wc -l <before)"
