#!/usr/bin/env bash
# The built-in scenes, each with both laws, give the golden hashes after a second: one run of four on 3
# threads, the others on 1. With SKV_LONG_TESTS=1 all are on 1, and again one of four on 16, the others on 3:
# many threads on few processors take thirty times as long as one. Arguments: build folder, source folder;
# --print before them prints the hashes instead, for scripts/update-golden.sh.
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
    same "built-in scenes, 1 thread" "$golden_scenes" hashes 1
    same "built-in scenes, 3 and 16 threads" "$golden_scenes" hashes 3 3 3 16
else
    same "built-in scenes, 1 and 3 threads" "$golden_scenes" hashes 1 1 1 3
fi
verdict
