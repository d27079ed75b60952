#!/usr/bin/env bash
# Checks the form of the sources: clang-format, clang-tidy, shellcheck, doxygen, and that clang reads all
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
# verdict NAME LOG STATUS: prints what a check came to, and what it found.
verdict() {
    local name=$1 log=$logs/$2.log
    if (($3 == 0)); then
        say "lint: $name: fine ($(elapsed))"
        return
    fi
    [[ ${SKVALP_VERBOSE:-0} == 1 ]] ||
        grep -E -m 20 -A 3 '(error|FAILED|CMake Error)' "$log" || head -n 60 "$log"
    printf '%s: %s failed (%s)\n' "$program" "$name" "$log" >&2
    status=1
}

# check NAME COMMAND...
check() {
    local name=$1 outcome=0
    shift
    logged "lint-$name" "$@" || outcome=$?
    verdict "$name" "lint-$name" "$outcome"
}

# What clang warns of it knows before it makes code, which takes most of the time. What a build generates is
# not there, and not ours. Called by name, through check.
# shellcheck disable=SC2317
read_all() {
    python3 -c '
import json, os, shlex
for one in json.load(open("build/clang/compile_commands.json", encoding="utf-8")):
    if os.path.exists(one["file"]):
        print("cd", shlex.quote(one["directory"]), "&&", one["command"], "-fsyntax-only", end="\0")' |
        xargs -0 -n 1 -P "$(nproc)" sh -c 2>&1
}

# One process a file, two minutes a file at most. Called by name, through check.
# shellcheck disable=SC2317
tidy() {
    printf '%s\0' "$@" | xargs -0 -n 1 -P "$(nproc)" \
        timeout 120 clang-tidy-19 --quiet --warnings-as-errors='*' -p build/clang 2>&1 |
        { grep -vE '^[0-9]+ warnings? generated' || true; }
}

install_packages "${packages_build[@]}" "${packages_lint[@]}" libcmocka-dev
mapfile -t all_c < <(find . \( -path ./build -o -name node_modules \) -prune -o -name '*.[ch]' -print | sort)
# src/base/wasm and windows are not part of a native build, so clang-tidy has no flags for them.
mapfile -t product_c < <(printf '%s\n' "${all_c[@]}" |
    grep -E '^\./(src|bench|cli|app)/.*\.c$' | grep -vE '^\./src/base/(wasm|windows)/')
mapfile -t shell < <(find scripts tests web/tools -name '*.sh' | sort)

check shellcheck shellcheck -x run.sh test.sh .ci/run "${shell[@]}"
check clang-format clang-format-19 --dry-run -Werror "${all_c[@]}"
check manual scripts/manual.sh
SKVALP_WERROR=ON
outcome=0
configure clang -DSKVALP_TESTS=ON || outcome=$?
verdict "configuring for clang" configure-clang "$outcome"
check clang-warnings read_all
check clang-tidy tidy "${product_c[@]}"
exit "$status"
