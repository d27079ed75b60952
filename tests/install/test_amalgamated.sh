#!/usr/bin/env bash
# The core in one file compiles with `cc -O2 -c skvalp.c` and no more, and gives the golden hashes
# with every instruction set inside; with SKV_LONG_TESTS=1 also by clang, for exactly this processor,
# where fused operations are at hand. For arm64 it compiles, and has none. It refuses -ffast-math.
# Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_amalgamated.sh BUILD SOURCE}")
cd "${2:?usage: test_amalgamated.sh BUILD SOURCE}"
# shellcheck source=tests/install/lib.sh
source tests/install/lib.sh
# shellcheck source=tests/bits/lib.sh
source tests/bits/lib.sh

python3 scripts/amalgamate.py "$work/skvalp" || complain "scripts/amalgamate.py fails"

# made NAME COMPILER [OPTION...]: compiles it and the program that prints the hashes; prints the
# program.
made() {
    local name=$1
    shift
    if ! { (cd "$work/skvalp" && "$@" -O2 -c skvalp.c -o "$work/$name.o") &&
        "$@" "-I$work" -Itests/bits tests/bits/hashes.c tests/bits/worlds.c "$work/$name.o" -lm \
            -pthread -o "$work/$name"; } >"$work/log" 2>&1; then
        grep -m 3 -E 'error|undefined' "$work/log" >&2
        printf '%s does not compile\n' "$name" >&2
        exit 1
    fi
    printf '%s' "$work/$name"
}

program=$(made cc cc)
sets=(scalar) fast=()
[[ $(uname -m) != x86_64 ]] || sets+=(sse2)
! grep -qw avx2 /proc/cpuinfo || sets+=(avx2)
! grep -qw avx512dq /proc/cpuinfo || sets+=(avx512)
for set in "${sets[@]}"; do
    set_is "cc, $set" "$set" "$program" "$set"
    same_worlds "cc, $set" "$short_run" "$program" "$set" 2 "$short_run" "${fast[@]}"
    fast=(fast)
done
! nm -g --defined-only "$work/cc.o" | awk '{ print $3 }' | grep -v '^skv_' ||
    complain "it defines names that are not the library's"

if [[ ${SKV_LONG_TESTS:-0} == 1 ]]; then
    for compiler in gcc clang-19; do
        program=$(made "$compiler-native" "$compiler" -march=native)
        same_worlds "$compiler -march=native" "$short_run" "$program" best 1 "$short_run"
    done
    program=$(made arm64 aarch64-linux-gnu-gcc -static)
    # What it computes is seen by bits/test_bits_arm64, in an emulator that takes minutes.
    set_is arm64 neon qemu-aarch64 "$program" best
    fuses_nothing "$work/arm64.o" aarch64-linux-gnu-objdump
fi
for option in -ffast-math -ffinite-math-only; do
    said=$(cd "$work/skvalp" && cc "$option" -fsyntax-only skvalp.c 2>&1) &&
        complain "$option compiles without an objection"
    [[ $said == *'change the results'* ]] || complain "$option: says ${said:0:100}"
done
verdict
