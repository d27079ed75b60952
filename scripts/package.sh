#!/usr/bin/env bash
# Makes the Debian packages in a folder: libskvalp0, libskvalp-dev, skvalp-tools, skvalp-play.
set -euo pipefail

program=package.sh
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source=scripts/lib.sh
source scripts/lib.sh

case ${1-} in
-h | --help | -*)
    say "Usage: scripts/package.sh [FOLDER]    builds the Debian packages in FOLDER (default:" \
        "build/package) and puts them there"
    [[ ${1-} == -h || ${1-} == --help ]] || die "unknown argument $1"
    exit
    ;;
esac
folder=${1:-build/package}

# cpack finds the libraries that programs need with `file`.
install_packages "${packages_build[@]}" file
# Their place below /usr follows from the prefix.
logged package-configure cmake -S . -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_INSTALL_PREFIX=/usr -DSKVALP_TESTS=OFF ||
    die "configuring failed: $(reason package-configure)"
logged package-build ninja -C "$folder" || die "building failed: $(reason package-build)"
rm -f "$folder"/*.deb
logged package-make cpack -G DEB --config "$folder/CPackConfig.cmake" -B "$folder" ||
    die "making the packages failed: $(reason package-make)"
for file in "$folder"/*.deb; do
    say "$file"
done
