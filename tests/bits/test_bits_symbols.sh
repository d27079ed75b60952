#!/usr/bin/env bash
# What would break bit-equality and can be seen in what was compiled: a call into libm that is not
# exact by its definition, or an instruction that multiplies and adds in one. And that the sources
# refuse to be compiled with -ffast-math. Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_bits_symbols.sh BUILD SOURCE}")
cd "${2:?usage: test_bits_symbols.sh BUILD SOURCE}"
# shellcheck source=tests/bits/lib.sh
source tests/bits/lib.sh

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# The functions of libm; those of them that IEEE 754 or C define to the last bit. fmin and fmax are
# not among these: of 0 and -0 they may return either.
libm=$(gcc -print-file-name=libm.so.6)
nm -D --defined-only "$libm" | awk '{ sub(/@.*/, "", $NF); print $NF }' | sort -u >"$work/libm"
printf '%s\n' ceil ceilf fabs fabsf floor floorf sqrt sqrtf trunc truncf | sort >"$work/exact"
comm -23 "$work/libm" "$work/exact" >"$work/inexact"
(($(wc -l <"$work/inexact") > 100)) || complain "the functions of libm were not found in $libm"

# The core's files, whose results are particles and readings.
find src/base src/model src/solver src/terrain src/calm src/world src/measure -name '*.c' -printf '%f.o\n' |
    sort >"$work/core"

# inexact_calls ARCHIVE: "file function" for every forbidden call from the core's files.
inexact_calls() {
    nm -A --undefined-only "$1" 2>/dev/null | awk -v core="$work/core" -v bad="$work/inexact" '
        BEGIN {
            while ((getline line <core) > 0) is_core[line] = 1
            while ((getline line <bad) > 0) is_bad[line] = 1
        }
        {
            split($1, part, ":")
            if (is_core[part[2]] && is_bad[$NF]) print part[2], $NF
        }'
}

while read -r line; do
    complain "not the same in every C library: $line"
done < <(inexact_calls "$build/src/libskvalp.a")
fuses_nothing "$build/src/libskvalp.a" objdump

# Both rules bite.
cat >"$work/exact.c" <<'END'
#include <math.h>
double sin_of(double x) { return sin(x); }
float smaller(float a, float b) { return fminf(a, b); }
float fused(float a, float b, float c) { return a * b + c; }
END
options=()
[[ $(uname -m) != x86_64 ]] || options=(-mfma)
gcc -O2 -ffp-contract=fast "${options[@]}" -c "$work/exact.c" -o "$work/exact.c.o"
ar rc "$work/sin.a" "$work/exact.c.o"
[[ $(inexact_calls "$work/sin.a" | sort | tr '\n' ' ') == 'exact.c.o fminf exact.c.o sin ' ]] ||
    complain "a call of sin and one of fminf go unnoticed"
[[ -n $(fused "$work/sin.a" objdump) ]] || complain "a fused instruction goes unnoticed"

compilers=(gcc)
[[ ${SKV_LONG_TESTS:-0} != 1 ]] || compilers+=(clang-19)
for compiler in "${compilers[@]}"; do
    for option in -ffast-math -ffinite-math-only; do
        said=$("$compiler" -std=c17 "$option" -Iinclude -Isrc -fsyntax-only src/base/exact.c 2>&1) &&
            complain "$compiler $option compiles without an objection"
        [[ $said == *'change the results'* ]] || complain "$compiler $option: says $said"
    done
done

((bad == 0)) || exit 1
printf 'bits: the core calls nothing inexact and fuses nothing\n'
