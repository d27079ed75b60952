#!/usr/bin/env bash
# The golden hashes from the module with threads and the one without, on 1, 2 and 3 threads: of the
# worlds of tests/bits and of built-in scenes, with SKV_LONG_TESTS=1 of all of them, and for longer.
# Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_web_bits.sh BUILD SOURCE}")
cd "${2:?usage: test_web_bits.sh BUILD SOURCE}"
# shellcheck source=tests/bits/lib.sh
source tests/bits/lib.sh
# shellcheck source=tests/web/lib.sh
source tests/web/lib.sh
make_modules

lengths=(6)
names='dam-break|pipes'
team=(1 3)
if [[ ${SKV_LONG_TESTS:-0} == 1 ]]; then
    lengths=(6 60)
    names='.*'
    team=(1 2 3)
fi
for threads in "${team[@]}"; do
    for frames in "${lengths[@]}"; do
        # Of the reference solver, which takes most of it, a second is seen without threads.
        fast=()
        ((threads == 1 || frames == 6)) || fast=(fast)
        same "worlds, $threads threads" <(golden_worlds "$frames" "${fast[@]}") \
            in_wasm "$threads" bits "$frames" "${fast[@]}"
    done
    same "scenes, $threads threads" <(grep -E "^($names) " tests/bits/golden-scenes.txt) \
        in_wasm "$threads" scenes "$names"
done
verdict
