#!/usr/bin/env bash
# The lines of docs/install.md do what the page says: run in order on a copy of the sources, with a
# folder of its own for /usr/local, without any package but a compiler, CMake and Ninja; each program
# that they make then prints what it must, without ldconfig. Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_install_page.sh BUILD SOURCE}")
cd "${2:?usage: test_install_page.sh BUILD SOURCE}"
# shellcheck source=tests/install/lib.sh
source tests/install/lib.sh
# shellcheck source=tests/support/sources.sh
source tests/support/sources.sh
expect_output

prefix=$work/local
copy=$work/skvalp
copy_sources . "$copy"
cp examples/hello.c "$copy/program.c"
# No package of this machine is found, so that none is needed; what gets installed is.
export PKG_CONFIG_LIBDIR=$prefix/lib/pkgconfig CMAKE_PREFIX_PATH=$prefix
export CMAKE_DISABLE_FIND_PACKAGE_PNG=TRUE

# The page's shell lines, one after the other; a program is run as soon as it is there.
lines=0
while IFS= read -r line; do
    lines=$((lines + 1))
    rm -f "$copy/program"
    [[ $line != *-Itwo-files* ]] || sed -i 's|<skvalp/skvalp.h>|"skvalp.h"|' "$copy/program.c"
    quietly "docs/install.md: '$line'" bash -c "cd '$copy' && ${line//\/usr\/local/$prefix}" || break
    [[ ! -x $copy/program ]] || prints "docs/install.md: '$line'" "$copy/program"
done < <(awk '/^```sh$/ { inside = 1; next } /^```$/ { inside = 0 } inside' docs/install.md)
((lines >= 8)) || complain "docs/install.md shows $lines lines"
prints "an example of docs/install.md" "$copy/build/examples/hello"

# Its lines for CMake, in a fresh project.
mapfile -t lines_for_cmake < <(awk '/^```cmake$/ { inside = 1; next } /^```$/ { inside = 0 } inside' docs/install.md)
project fresh "${lines_for_cmake[0]}" -- 'add_executable(program hello.c)' "${lines_for_cmake[@]:1}"
for shared in OFF ON; do
    ! builds fresh -DBUILD_SHARED_LIBS=$shared || prints "find_package, shared: $shared" "$work/fresh/build/program"
done
# The page's words for the app's and the tests' packages are right: the preset of the programs has neither.
if (cd "$copy" && PKG_CONFIG_LIBDIR='' cmake --preset programs) >"$work/log" 2>&1; then
    complain "docs/install.md: --preset programs says that it wants jansson, and does not"
fi
grep -q jansson "$work/log" || complain "docs/install.md: --preset programs does not ask for jansson first"

conclude "$lines lines of docs/install.md do what they say"
