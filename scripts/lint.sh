#!/usr/bin/env bash
# Checks the form of the sources: clang-format, clang-tidy, shellcheck, and that clang compiles all
# of it without a warning. Prints one line per check; the exit status is 1 if one failed.
set -euo pipefail

program=lint.sh
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source=scripts/lib.sh
source scripts/lib.sh

case ${1-} in
'') ;;
-h | --help)
    say "Usage: scripts/lint.sh    installs what is missing and checks the form of all sources"
    exit
    ;;
*)
    die "unknown argument $1; try: scripts/lint.sh --help"
    ;;
esac

status=0
# check NAME COMMAND...: runs one check, shows what it found.
check() {
    local name=$1
    shift
    if logged "lint-$name" "$@"; then
        say "lint: $name: fine ($(elapsed))"
    else
        [[ ${SKVALP_VERBOSE:-0} == 1 ]] || head -n 60 "$logs/lint-$name.log"
        printf '%s: %s failed (%s)\n' "$program" "$name" "$logs/lint-$name.log" >&2
        status=1
    fi
}

# One process a file, two minutes a file at most. Called by name, through check.
# shellcheck disable=SC2317
tidy() {
    printf '%s\0' "$@" | xargs -0 -n 1 -P "$(nproc)" \
        timeout 120 clang-tidy-19 --quiet --warnings-as-errors='*' -p build/clang
}

install_packages "${packages_build[@]}" "${packages_lint[@]}" libcmocka-dev
mapfile -t all_c < <(find . -path ./build -prune -o -name '*.[ch]' -print | sort)
mapfile -t product_c < <(printf '%s\n' "${all_c[@]}" | grep -E '^\./(src|cli|app)/.*\.c$')
mapfile -t shell < <(find scripts tests -name '*.sh' | sort)

check shellcheck shellcheck -x run.sh test.sh .ci/run "${shell[@]}"
check clang-format clang-format-19 --dry-run -Werror "${all_c[@]}"
SKVALP_WERROR=ON
check clang-configure configure clang
check clang-build build clang
check clang-tidy tidy "${product_c[@]}"
exit "$status"
