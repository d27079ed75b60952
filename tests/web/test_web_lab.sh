#!/usr/bin/env bash
# The rows of all experiments, bit by bit as they are natively, on two threads; with SKV_LONG_TESTS=1 also
# on one and those of finer worlds on three. Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_web_lab.sh BUILD SOURCE}")
cd "${2:?usage: test_web_lab.sh BUILD SOURCE}"
# shellcheck source=tests/web/lib.sh
source tests/web/lib.sh
make_modules

work=$(mktemp)
trap 'rm -f "$work"' EXIT
runs=('400 2')
[[ ${SKV_LONG_TESTS:-0} != 1 ]] || runs=('400 1 2' '1000 3')
for run in "${runs[@]}"; do
    read -r particles team <<<"$run"
    "$build/web_reference" lab "$particles" >"$work"
    for threads in $team; do
        same "$particles particles, $threads threads" "$work" in_wasm "$threads" lab "$particles"
    done
done
verdict
