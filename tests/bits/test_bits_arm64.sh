#!/usr/bin/env bash
# The same bits on arm64, in an emulator: from gcc and clang, with NEON and in scalar code, on one
# thread and several. The emulator takes minutes: without SKV_LONG_TESTS=1 only what gcc makes of NEON
# is built and run. Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_bits_arm64.sh BUILD SOURCE}")
cd "${2:?usage: test_bits_arm64.sh BUILD SOURCE}"
# shellcheck source=tests/bits/lib.sh
source tests/bits/lib.sh

for tool in aarch64-linux-gnu-gcc aarch64-linux-gnu-objdump clang-19 ld.lld-19 qemu-aarch64; do
    command -v "$tool" >/dev/null || complain "$tool is missing; ./test.sh installs it"
done
((bad == 0)) || exit 1

# arm64 NAME CMAKE-OPTION...: builds the core for arm64; static, so that it needs no libraries there.
arm64() {
    local name=$1
    shift
    core "$name" -DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR=aarch64 \
        -DCMAKE_BUILD_TYPE=Release "$@"
}

gcc=$(arm64 arm64-gcc -DCMAKE_C_COMPILER=aarch64-linux-gnu-gcc -DCMAKE_EXE_LINKER_FLAGS=-static)
folders=("$gcc")
if [[ ${SKV_LONG_TESTS:-0} == 1 ]]; then
    clang=$(arm64 arm64-clang-19 -DCMAKE_C_COMPILER=clang-19 \
        -DCMAKE_C_COMPILER_TARGET=aarch64-linux-gnu \
        "-DCMAKE_EXE_LINKER_FLAGS=-static -fuse-ld=lld-19")
    folders+=("$clang")
fi
for folder in "${folders[@]}"; do
    set_is "arm64, $folder" neon qemu-aarch64 "$folder/bits_hashes" best
    fuses_nothing "$folder/src/libskvalp.a" aarch64-linux-gnu-objdump
done
same_worlds "arm64, gcc, NEON, 3 threads" "$short_run" \
    qemu-aarch64 "$gcc/bits_hashes" best 3 "$short_run"
set_is "arm64, scalar" scalar qemu-aarch64 "$gcc/bits_hashes" scalar
if [[ ${SKV_LONG_TESTS:-0} == 1 ]]; then
    same_worlds "arm64, clang, NEON" "$short_run" \
        qemu-aarch64 "$clang/bits_hashes" best 1 "$short_run"
    same_worlds "arm64, gcc, scalar" "$short_run" \
        qemu-aarch64 "$gcc/bits_hashes" scalar 1 "$short_run" fast
fi
verdict
