#!/usr/bin/env bash
# docs/hosts.md keeps its word: every C example compiles without a warning, runs, and ends well.
# Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_hosts_page.sh BUILD SOURCE}")
cd "${2:?usage: test_hosts_page.sh BUILD SOURCE}"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

awk -v folder="$work" '
    /^```c$/ { file = sprintf("%s/example-%d.c", folder, ++count); next }
    /^```$/ { file = "" }
    file { print > file }' docs/hosts.md

# A sanitized library needs its run-time in the program, too.
flags=()
if grep -q '^CMAKE_C_FLAGS:.*-fsanitize=address' "$build/CMakeCache.txt"; then
    flags=(-fsanitize=address -fsanitize=undefined)
fi
compiler=$(sed -n 's/^CMAKE_C_COMPILER:[A-Z]*=//p' "$build/CMakeCache.txt")

bad=0
examples=0
for source in "$work"/example-*.c; do
    name=$(basename "$source" .c)
    examples=$((examples + 1))
    if ! "$compiler" -std=c17 -Wall -Wextra -Werror "${flags[@]}" -Iinclude "$source" \
        "$build/src/libskvalp.a" -lm -lpthread -o "$work/$name"; then
        printf '%s of docs/hosts.md does not compile\n' "$name"
        bad=$((bad + 1))
    elif ! "$work/$name" >"$work/output"; then
        printf '%s of docs/hosts.md fails\n' "$name"
        bad=$((bad + 1))
    fi
done

((examples >= 5)) || { printf 'docs/hosts.md has %d examples\n' "$examples" && exit 1; }
((bad == 0)) || exit 1
printf 'hosts page: %d examples compile and run\n' "$examples"
