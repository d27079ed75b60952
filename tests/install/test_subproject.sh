#!/usr/bin/env bash
# Taken into another project with add_subdirectory or FetchContent, the library is the core alone:
# no app, no tests, none of their packages, nothing of it installed with the host.
# Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_subproject.sh BUILD SOURCE}")
cd "${2:?usage: test_subproject.sh BUILD SOURCE}"
# shellcheck source=tests/install/lib.sh
source tests/install/lib.sh
expect_output

# No package can be found in these projects: neither pkg-config's nor libpng.
alone=(-DCMAKE_DISABLE_FIND_PACKAGE_PkgConfig=ON -DCMAKE_DISABLE_FIND_PACKAGE_PNG=ON)
project subdirectory "add_subdirectory($source_folder skvalp)"
project fetched 'set(BUILD_SHARED_LIBS ON)' 'include(FetchContent)' \
    "FetchContent_Declare(skvalp SOURCE_DIR $source_folder)" 'FetchContent_MakeAvailable(skvalp)' \
    -- 'install(TARGETS hello)'
for name in subdirectory fetched; do
    builds "$name" "${alone[@]}" || continue
    prints "$name" "$work/$name/build/hello"
    found=$(find "$work/$name/build" -type f -executable -not -path '*/CMakeFiles/*' \
        -printf '%f\n' | sort | tr '\n' ' ')
    [[ $found =~ ^hello\ (libskvalp\.so\.[0-9.]+\ )?$ ]] ||
        complain "$name: builds more than the core: $found"
done
needs "$work/fetched/build/hello" libskvalp || complain "BUILD_SHARED_LIBS is not heeded"
! needs "$work/subdirectory/build/hello" libskvalp || complain "not static by default"
if quietly "installing the host" \
    cmake --install "$work/fetched/build" --prefix "$work/installed"; then
    found=$(find "$work/installed" -type f -printf '%f ')
    [[ $found == 'hello ' ]] || complain "the host installs more than itself: $found"
fi
conclude "taken in by add_subdirectory and FetchContent, the core alone"
