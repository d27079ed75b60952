#!/usr/bin/env bash
# The stage under ThreadSanitizer: its threads at once, with everything that a face can ask for.
# With SKV_LONG_TESTS=1 all programs of the session that have two; none in a long form of its own,
# since the sanitizer makes each of them take twenty times as long.
# Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_tsan.sh BUILD SOURCE}")
source=$(realpath "${2:?usage: test_tsan.sh BUILD SOURCE}")

# Another sanitizer's build has been here already.
if grep -q 'CMAKE_C_FLAGS:STRING=.*-fsanitize' "$build/CMakeCache.txt"; then
    echo "tsan: not in a build with other sanitizers"
    exit
fi
programs=(test_stress)
[[ ${SKV_LONG_TESTS:-0} != 1 ]] || programs+=(test_session test_tools test_threads test_stage test_time test_sharing)
unset SKV_LONG_TESTS
cmake -S "$source" -B "$build/tsan" -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo -DSKVALP_APP=OFF \
    "-DCMAKE_C_COMPILER=$(sed -n 's/^CMAKE_C_COMPILER:[A-Z]*=//p' "$build/CMakeCache.txt")" \
    "-DCMAKE_C_FLAGS=-fsanitize=thread -fno-omit-frame-pointer" >"$build/tsan.log" 2>&1 ||
    { tail -n 5 "$build/tsan.log"; exit 1; }
ninja -C "$build/tsan" "${programs[@]}" >"$build/tsan.log" 2>&1 ||
    { grep -m 5 -E 'error|FAILED' "$build/tsan.log"; exit 1; }
for program in "${programs[@]}"; do
    TSAN_OPTIONS='halt_on_error=1 exitcode=66' "$build/tsan/$program" >"$build/tsan.log" 2>&1 || {
        head -n 60 "$build/tsan.log"
        exit 1
    }
done
echo "tsan: ${#programs[@]} program(s) without a race"
