#!/usr/bin/env bash
# The same bits in WebAssembly, with SKV_LONG_TESTS=1 also where it is hardly optimised. That it builds and runs at all shows that
# the core needs no C library. Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_bits_wasm.sh BUILD SOURCE}")
cd "${2:?usage: test_bits_wasm.sh BUILD SOURCE}"
# shellcheck source=tests/bits/lib.sh
source tests/bits/lib.sh

for tool in clang-19 wasm-ld-19 node; do
    command -v "$tool" >/dev/null || complain "$tool is missing; ./test.sh installs it"
done
((bad == 0)) || exit 1

types=(Release)
[[ ${SKV_LONG_TESTS:-0} != 1 ]] || types+=(Debug)
for type in "${types[@]}"; do
    folder=$(core "wasm-$type" --toolchain cmake/wasm32.cmake -DCMAKE_BUILD_TYPE="$type")
    hashes=(node tests/bits/hashes.mjs "$folder/bits_hashes.wasm")
    set_is "wasm $type" wasm "${hashes[@]}"
    same_worlds "wasm $type" "$short_run" "${hashes[@]}" 1 "$short_run"
    [[ $type == Debug ]] || same_worlds "wasm $type" "$long_run" "${hashes[@]}" 1 "$long_run"
done
verdict
