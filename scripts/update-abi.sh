#!/usr/bin/env bash
# Writes the shared library's interface anew, after it was changed on purpose:
# packaging/skvalp.abi, which tests/install/test_abi.sh compares.
set -euo pipefail

program=update-abi.sh
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source=scripts/lib.sh
source scripts/lib.sh

case ${1-} in
'') ;;
-h | --help)
    say "Usage: scripts/update-abi.sh    after a change of the interface on purpose: writes" \
        "packaging/skvalp.abi anew"
    exit
    ;;
*)
    die "unknown argument $1; try: scripts/update-abi.sh --help"
    ;;
esac

install_packages "${packages_build[@]}" abigail-tools
mkdir -p build/release
bash tests/install/test_abi.sh --print build/release . >packaging/skvalp.abi.new ||
    die "the interface cannot be read, see the line above"
mv packaging/skvalp.abi.new packaging/skvalp.abi
say "Written: packaging/skvalp.abi; what may break programs belongs into CHANGELOG.md"
