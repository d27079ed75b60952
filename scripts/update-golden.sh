#!/usr/bin/env bash
# Writes the golden hashes of tests/bits anew, after the physics was changed on purpose, from the
# present state of the sources as gcc compiles them. The tests then tell whether every other
# compiler, processor and number of threads agrees.
set -euo pipefail

program=update-golden.sh
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source=scripts/lib.sh
source scripts/lib.sh

case ${1-} in
'') ;;
-h | --help)
    say "Usage: scripts/update-golden.sh    after a change of the physics on purpose: writes" \
        "tests/bits/golden.txt and tests/bits/golden-scenes.txt anew"
    exit
    ;;
*)
    die "unknown argument $1; try: scripts/update-golden.sh --help"
    ;;
esac

build=$PWD/build/release
# shellcheck source=tests/bits/lib.sh
source tests/bits/lib.sh
install_packages "${packages_build[@]}"
configure release || die "configuring failed: $(reason configure-release)"
build release skvalp-cli || die "building failed: $(reason build-release)"
folder=$(core gcc-Release -DCMAKE_C_COMPILER=gcc -DCMAKE_BUILD_TYPE=Release)
{
    "$folder/bits_hashes" best 1 "$long_run"
    "$folder/bits_hashes" best 1 "$short_run"
} >"$golden.new"
! grep -q ' 0000000000000000$' "$golden.new" || die "a world failed; see $golden.new"
mv "$golden.new" "$golden"
bash tests/bits/test_bits_scenes.sh --print "$build" . >"$golden_scenes.new"
mv "$golden_scenes.new" "$golden_scenes"
say "Written: $golden and $golden_scenes; now run: ctest --test-dir build/release -L bits"
