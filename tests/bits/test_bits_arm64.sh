#!/usr/bin/env bash
# The same bits on arm64, with NEON and in scalar code, on one thread and several; under an emulator
# where the machine is none. Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_bits_arm64.sh BUILD SOURCE}")
cd "${2:?usage: test_bits_arm64.sh BUILD SOURCE}"
# shellcheck source=tests/bits/lib.sh
source tests/bits/lib.sh

for tool in aarch64-linux-gnu-gcc qemu-aarch64; do
    command -v "$tool" >/dev/null || complain "$tool is missing; ./test.sh installs it"
done
((bad == 0)) || exit 1

# Static, so that it needs no arm64 libraries to be found.
folder=$(core arm64 -DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR=aarch64 \
    -DCMAKE_C_COMPILER=aarch64-linux-gnu-gcc -DCMAKE_EXE_LINKER_FLAGS=-static \
    -DCMAKE_BUILD_TYPE=Release)
set_is arm64 neon qemu-aarch64 "$folder/bits_hashes"
same_worlds "arm64, NEON" "$short_run" qemu-aarch64 "$folder/bits_hashes" 1 "$short_run"
same_worlds "arm64, NEON, 3 threads" "$short_run" \
    qemu-aarch64 "$folder/bits_hashes" 3 "$short_run"
export SKVALP_ISA=scalar
set_is arm64 scalar qemu-aarch64 "$folder/bits_hashes"
same_worlds "arm64, scalar" "$short_run" qemu-aarch64 "$folder/bits_hashes" 1 "$short_run"
verdict
