#!/usr/bin/env bash
# The same bits from scalar code, SSE2, AVX2 and AVX-512, on one thread and on one other number of them.
# With SKV_LONG_TESTS=1 from gcc and clang, Debug, which takes ten times as long, and Release; the widest
# instruction set on 1 to 16 threads; and the built-in scenes by clang's program.
# Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_bits_native.sh BUILD SOURCE}")
cd "${2:?usage: test_bits_native.sh BUILD SOURCE}"
# shellcheck source=tests/bits/lib.sh
source tests/bits/lib.sh

case $(uname -m) in
x86_64)
    sets=(scalar sse2)
    grep -qw avx2 /proc/cpuinfo && sets+=(avx2) || printf 'bits: this processor has no AVX2\n'
    grep -qw avx512dq /proc/cpuinfo && sets+=(avx512) ||
        printf 'bits: this processor has no AVX-512\n'
    ;;
aarch64) sets=(scalar neon) ;;
*) sets=(scalar) ;;
esac
many=(2 3 4 8 16)

# cached NAME: a setting of the build folder.
cached() {
    sed -n "s/^$1:[A-Z]*=//p" "$build/CMakeCache.txt"
}
normal=$(basename "$(realpath "$(cached CMAKE_C_COMPILER)")")-$(cached CMAKE_BUILD_TYPE)

compilers=(gcc)
types=(Release)
if [[ ${SKV_LONG_TESTS:-0} == 1 ]]; then
    compilers+=(clang-19)
    types+=(Debug)
fi
# same_scenes FOLDER: the built-in scenes, which a program reads and fills with water, give the golden hashes.
same_scenes() {
    if ! ninja -C "$1" skvalp-cli >"$build/bits/program.log" 2>&1; then
        complain "$1: the program cannot be built ($build/bits/program.log)"
    elif ! env -u SKV_LONG_TESTS bash tests/bits/test_bits_scenes.sh "$1" .; then
        complain "$1: the built-in scenes have other bits"
    fi
}

turn=0
for compiler in "${compilers[@]}"; do
    for type in "${types[@]}"; do
        folder=$build
        # The build folder holds one of the four already, unless it is built in a special way.
        [[ $normal == "$(basename "$(realpath "$(command -v "$compiler")")")-$type" &&
            -z $(cached CMAKE_C_FLAGS) ]] ||
            folder=$(core "$compiler-$type" -DCMAKE_C_COMPILER="$compiler" \
                -DCMAKE_BUILD_TYPE="$type" -DSKVALP_CORE_ONLY=OFF -DSKVALP_TESTS=ON -DSKVALP_APP=OFF)
        for set in "${sets[@]}"; do
            set_is "$compiler $type" "$set" "$folder/bits_hashes" "$set"
            threads=(1 "${many[turn++ % ${#many[@]}]}")
            [[ $type == Release ]] || threads=("${threads[0]}")
            [[ $type == Debug || $set != "${sets[-1]}" || ${SKV_LONG_TESTS:-0} != 1 ]] ||
                threads=(1 "${many[@]}")
            # The reference solver's worlds by the first set, also for each number of its threads.
            fast=(fast)
            [[ $set != "${sets[0]}" ]] || fast=()
            for count in "${threads[@]}"; do
                same_worlds "$compiler $type, $set, $count threads" "$short_run" \
                    "$folder/bits_hashes" "$set" "$count" "$short_run" "${fast[@]}"
            done
        done
        # The long run, on what a user gets: the widest instruction set.
        [[ $type == Debug ]] ||
            same_worlds "$compiler $type" "$long_run" "$folder/bits_hashes" best 1 "$long_run"
        [[ $compiler-$type != clang-19-Release ]] || same_scenes "$folder"
    done
done
verdict
