#!/usr/bin/env bash
# The built-in scenes, each with both laws, give the golden hashes after a second: with one law on 1
# thread, with the other on 3, in turn. With SKV_LONG_TESTS=1 all are on 1, 3 and 16. Arguments: build
# folder, source folder; --print before them prints the hashes instead, for scripts/update-golden.sh.
set -euo pipefail
print=0
if [[ ${1-} == --print ]]; then
    print=1
    shift
fi
build=$(realpath "${1:?usage: test_bits_scenes.sh [--print] BUILD SOURCE}")
cd "${2:?usage: test_bits_scenes.sh [--print] BUILD SOURCE}"
# shellcheck source=tests/bits/lib.sh
source tests/bits/lib.sh

# hashes THREADS...: one line "scene law hash" for each; the numbers of threads are taken in turn, which
# changes places from scene to scene.
hashes() {
    local scene law threads=("$@") turn=0
    while read -r scene _; do
        for law in calibrated clavet; do
            printf '%s %s %s\n' "$scene" "$law" "$("$build/skvalp" run "$scene" --law "$law" \
                --seconds 1 --particles 700 --threads "${threads[turn % $#]}" --quiet --json |
                sed -n 's/.*"hash": *"\([0-9a-f]*\)".*/\1/p')"
            turn=$((turn + 1))
        done
        turn=$((turn + 1))
    done < <("$build/skvalp" scenes)
}

if ((print)); then
    hashes 1
    exit
fi
if [[ ${SKV_LONG_TESTS:-0} == 1 ]]; then
    for count in 1 3 16; do
        same "built-in scenes, $count threads" "$golden_scenes" hashes "$count"
    done
else
    same "built-in scenes, 1 and 3 threads" "$golden_scenes" hashes 1 3
fi
verdict
