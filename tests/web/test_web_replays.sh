#!/usr/bin/env bash
# Replays and links go in WebAssembly as they go natively, on 1 and 3 threads, with SKV_LONG_TESTS=1 also
# on 2, and what was played there goes the same way here. Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_web_replays.sh BUILD SOURCE}")
cd "${2:?usage: test_web_replays.sh BUILD SOURCE}"
# shellcheck source=tests/web/lib.sh
source tests/web/lib.sh
make_modules

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

team=(1 3)
[[ ${SKV_LONG_TESTS:-0} != 1 ]] || team=(1 2 3)
for threads in "${team[@]}"; do
    in_wasm "$threads" game u-tube "$work/$threads.skvr" || complain "a game on $threads threads failed"
done
cmp -s "$work/1.skvr" "$work/3.skvr" || complain "a game on 3 threads gives another file than on one"
"$build/skvalp" share dam-break --particles 300 >"$work/link"
"$build/write_replays" "$work"
sources=("$work"/{skewed,game,wind}.skvr "$work"/[123].skvr)
played "${sources[@]}" >"$work/native"
grep -c same "$work/native" | grep -qx $((2 + ${#team[@]})) || complain "natively not all went as recorded: $(cat "$work/native")"
for threads in "${team[@]}"; do
    same "replays, $threads threads" "$work/native" in_wasm "$threads" replay "${sources[@]}"
done
same "a link" <("$build/skvalp" run dam-break --particles 300 --seconds 0 --json |
    sed -n 's/.*"hash": *"\([0-9a-f]*\)".*/0 \1 same/p') in_wasm 2 replay "$(cat "$work/link")"
verdict
