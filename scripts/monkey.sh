#!/usr/bin/env bash
# Lets a monkey at the app, built with the address and undefined-behaviour sanitizers: random keys,
# clicks, drags, files. The last line counts what it did; a seed repeats it.
set -euo pipefail

program=monkey.sh
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source=scripts/lib.sh
source scripts/lib.sh

usage() {
    cat <<END_OF_USAGE
Usage: scripts/monkey.sh [MINUTES [SEED]]

Plays for MINUTES (default 10) on a display of its own. SEED is that of an earlier run, which it
printed; a busy machine may go another way all the same. The build is kept in build/monkey.
END_OF_USAGE
}

case ${1-} in
-h | --help)
    usage
    exit
    ;;
*[!0-9]*)
    die "not a number of minutes: $1; try: scripts/monkey.sh --help"
    ;;
esac
[[ ${2-0} != *[!0-9]* ]] || die "not a seed: $2; try: scripts/monkey.sh --help"

install_packages "${packages_build[@]}" "${packages_run[@]}" "${packages_core[@]}" "${packages_app[@]}"
say "Building build/monkey"
configure monkey || die "configuring failed: $(reason configure-monkey) ($logs/configure-monkey.log)"
build monkey skvalp-play-tested || die "building failed: $(reason build-monkey) ($logs/build-monkey.log)"
SKV_MONKEY_SECONDS=$((${1:-10} * 60)) SKV_MONKEY_SEED=${2-$((SRANDOM % 1000000))} SKV_MONKEY_DIALOGS=1 \
    bash tests/app/test_app_monkey.sh build/monkey .
