#!/usr/bin/env bash
# The built-in scenes, each with both laws, give the golden hashes after a second, on 1 and 3
# threads; with SKV_LONG_TESTS=1 also on 16. Arguments: build folder, source folder; --print before
# them prints the hashes instead, for scripts/update-golden.sh.
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

# hashes THREADS: one line "scene law hash" for each.
hashes() {
    local scene law
    while read -r scene _; do
        for law in calibrated clavet; do
            printf '%s %s %s\n' "$scene" "$law" "$("$build/skvalp" run "$scene" --law "$law" \
                --seconds 1 --particles 700 --threads "$1" --quiet --json |
                sed -n 's/.*"hash": *"\([0-9a-f]*\)".*/\1/p')"
        done
    done < <("$build/skvalp" scenes)
}

if ((print)); then
    hashes 1
    exit
fi
threads=(1 3)
[[ ${SKV_LONG_TESTS:-0} != 1 ]] || threads=(1 3 16)
for count in "${threads[@]}"; do
    same "built-in scenes, $count threads" "$golden_scenes" hashes "$count"
done
verdict
