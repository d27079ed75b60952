#!/usr/bin/env bash
# The installed library is found by fresh projects, static and shared, with find_package and with
# pkg-config, from wherever its folder is moved; the shared one exports what the headers declare and
# nothing else. Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_installed.sh BUILD SOURCE}")
cd "${2:?usage: test_installed.sh BUILD SOURCE}"
# shellcheck source=tests/install/lib.sh
source tests/install/lib.sh
install_build
expect_output

# find_package.
project static 'find_package(skvalp 0.1 CONFIG REQUIRED)'
project shared 'find_package(skvalp 0.1 CONFIG REQUIRED COMPONENTS shared)'
project whole 'find_package(skvalp CONFIG REQUIRED COMPONENTS render experiments)' -- \
    'add_executable(all_parts all_parts.c)' \
    'target_link_libraries(all_parts PRIVATE skvalp::render skvalp::experiments)'
cat >"$work/whole/all_parts.c" <<'END'
#include <skvalp/experiments.h>
#include <skvalp/render.h>
#include <skvalp/scene.h>

int main(void)
{
    return !skv_builtin_scene(0) || !skv_experiment_info(0) || !skv_style_choice_at(SKV_STYLE_VIEW, 0);
}
END
for name in static shared whole; do
    builds "$name" -DCMAKE_PREFIX_PATH="$prefix" || continue
    prints "find_package, $name" "$work/$name/build/hello"
done
needs "$work/shared/build/hello" 'libskvalp\.so\.0\]' || complain "shared is not shared"
! needs "$work/static/build/hello" libskvalp || complain "static is not static"
! needs "$work/whole/build/hello" libskvalp || complain "components come with two cores"
! needs "$work/static/build/hello" 'libjansson|libpng|libEGL|libGL' ||
    complain "the core needs more than the C library"
"$work/whole/build/all_parts" || complain "a program of all components fails"
if builds static -DBUILD_SHARED_LIBS=ON; then
    needs "$work/static/build/hello" libskvalp || complain "BUILD_SHARED_LIBS is not heeded"
fi
project missing 'find_package(skvalp CONFIG REQUIRED COMPONENTS gravy)'
if cmake -S "$work/missing" -B "$work/missing/build" -DCMAKE_PREFIX_PATH="$prefix" \
    >"$work/log" 2>&1 || ! grep -q gravy "$work/log"; then
    complain "a component that does not exist is not refused by its name"
fi

# pkg-config.
flags() {
    pkg-config "$@" || complain "pkg-config $* fails"
}
# shellcheck disable=SC2046
"$compiler" examples/hello.c $(flags --cflags --libs skvalp) -o "$work/by-pkg-config"
prints "pkg-config, shared" "$work/by-pkg-config"
needs "$work/by-pkg-config" libskvalp || complain "pkg-config without --static is not shared"
# shellcheck disable=SC2046
"$compiler" -static examples/hello.c $(flags --cflags --libs --static skvalp) \
    -o "$work/by-pkg-config-static"
prints "pkg-config, static" "$work/by-pkg-config-static"
# shellcheck disable=SC2046
"$compiler" "$work/whole/all_parts.c" $(flags --cflags --libs skvalp-render skvalp-experiments) \
    -o "$work/all_parts"
"$work/all_parts" || complain "pkg-config: a program of all components fails"
! needs "$work/all_parts" libskvalp || complain "pkg-config: components come with two cores"
[[ $(pkg-config --modversion skvalp) == "$(cut -d " " -f 2 <<<"${expected%%:*}")" ]] ||
    complain "pkg-config names another version than the library"

# What the shared library exports is what the core's headers declare.
headers_declare "$prefix/include" >"$work/declared"
nm -D --defined-only "$prefix/lib/libskvalp.so" | awk '{ print $3 }' | sort -u >"$work/exported"
while read -r line; do
    complain "exported and declared (<: not exported, >: not declared): $line"
done < <(diff "$work/declared" "$work/exported" | grep '^[<>]')
(($(wc -l <"$work/exported") > 20)) || complain "hardly anything is exported"

conclude "found by find_package and pkg-config, static and shared;" \
    "$(wc -l <"$work/exported") functions exported"
