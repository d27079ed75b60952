#!/usr/bin/env bash
# The examples are built as a stranger would build them, over the installed library, and do what they
# say; in C, C++ and Python the first of them prints the same. Each is short.
# Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_examples.sh BUILD SOURCE}")
cd "${2:?usage: test_examples.sh BUILD SOURCE}"
# shellcheck source=tests/install/lib.sh
source tests/install/lib.sh
install_build
expect_output

for file in examples/*.{c,cpp,py}; do
    (($(wc -l <"$file") < 150)) || complain "$file has 150 lines or more"
done

cp -r examples "$work/examples"
builds examples -DCMAKE_PREFIX_PATH="$prefix" || exit 1
prints hello.c "$work/examples/build/hello"

c++ -std=c++17 -Wall -Wextra -Wpedantic -Werror examples/hello.cpp \
    "-I$prefix/include" "-L$prefix/lib" -lskvalp -o "$work/hello_cpp"
prints hello.cpp env LD_LIBRARY_PATH="$prefix/lib" "$work/hello_cpp"
prints hello.py env SKVALP_LIBRARY="$prefix/lib/libskvalp.so.0" python3 examples/hello.py

quietly own_threads "$work/examples/build/own_threads"
grep -q '^4 members: hash' "$work/log" || complain "own_threads lends no threads"
quietly instruments "$work/examples/build/instruments"
(($(grep -c 'Pa m under' "$work/log") == 8)) || complain "instruments prints no table"
# Without a display SDL draws into memory.
quietly own_renderer env SDL_VIDEODRIVER=dummy SDL_RENDER_DRIVER=software \
    "$work/examples/build/own_renderer" 5
grep -q '[1-9][0-9]* points of the surface drawn, done' "$work/log" || complain "own_renderer: $(cat "$work/log")"
quietly own_engine "$work/examples/build/own_engine"
# Half as heavy as water: its middle lies in the surface, to a particle's half; and the joint is right.
grep -qE '^box .* middle +[-+][0-9] mm .* [0-9]\.. mm/s$' "$work/log" || complain "own_engine: $(cat "$work/log")"
grep -qE '^the rope holds (0\.9[5-9]|1\.0[0-5]) ' "$work/log" || complain "own_engine: $(cat "$work/log")"

conclude "the examples run; $expected"
