#!/usr/bin/env bash
# The rows of all experiments, bit by bit as they are natively; with SKV_LONG_TESTS=1 those of finer
# worlds, too. Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_web_lab.sh BUILD SOURCE}")
cd "${2:?usage: test_web_lab.sh BUILD SOURCE}"
# shellcheck source=tests/web/lib.sh
source tests/web/lib.sh
make_modules

work=$(mktemp)
trap 'rm -f "$work"' EXIT
sizes=(400)
team=(2)
if [[ ${SKV_LONG_TESTS:-0} == 1 ]]; then
    sizes=(400 1000)
    team=(1 2 3)
fi
for particles in "${sizes[@]}"; do
    "$build/web_reference" lab "$particles" >"$work"
    for threads in "${team[@]}"; do
        same "$particles particles, $threads threads" "$work" in_wasm "$threads" lab "$particles"
    done
done
verdict
