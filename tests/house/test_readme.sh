#!/usr/bin/env bash
# The README keeps its word: its C example compiles without a warning, runs and prints numbers; its
# commands work; and its pictures are today's.
# Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_readme.sh BUILD SOURCE}")
cd "${2:?usage: test_readme.sh BUILD SOURCE}"

bad=0
complain() {
    printf '%s\n' "$*"
    bad=$((bad + 1))
}

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

awk '/^```c$/ { inside = 1; next } /^```$/ { if (inside) exit } inside' README.md >"$work/example.c"
lines=$(grep -c '[^[:space:]]' "$work/example.c" || true)
if ((lines == 0)); then
    complain "README.md has no C example"
elif ((lines > 16)); then
    complain "the C example of README.md has $lines lines, that is no short example"
else
    # A sanitized library needs its run-time in the program, too.
    flags=()
    if grep -q '^CMAKE_C_FLAGS:.*-fsanitize=address' "$build/CMakeCache.txt"; then
        flags=(-fsanitize=address -fsanitize=undefined)
    fi
    compiler=$(sed -n 's/^CMAKE_C_COMPILER:[A-Z]*=//p' "$build/CMakeCache.txt")
    if "$compiler" -std=c17 -Wall -Wextra -Werror "${flags[@]}" -Iinclude "$work/example.c" \
        "$build/src/libskvalp.a" -lm -lpthread -o "$work/example"; then
        "$work/example" >"$work/output" || complain "the C example of README.md fails"
        grep -q '[0-9]' "$work/output" || complain "the C example of README.md prints no number"
        ! grep -qi 'nan' "$work/output" || complain "the C example of README.md prints NaN"
    else
        complain "the C example of README.md does not compile"
    fi
fi

# The commands, in a folder of their own in which the build and the scenes are where they should be.
# They take seconds, so what has failed already and the first that fails end it.
mkdir -p "$work/here/build"
ln -s "$build" "$work/here/build/release"
ln -s "$PWD/scenes" "$work/here/scenes"
commands=0
while IFS= read -r command; do
    ((bad == 0)) || break
    commands=$((commands + 1))
    (cd "$work/here" && bash -c "$command") >"$work/said" 2>&1 </dev/null ||
        complain "README.md: '$command' fails: $(tail -n 1 "$work/said")"
done < <(grep '^build/release/skvalp ' README.md)
((commands > 0 || bad > 0)) || complain "README.md shows no command"

# Its pictures are what the commands beside them draw today. Other drivers draw them with 45 dB, water of
# another version with less than 20.
mkdir -p "$work/here/docs/pictures"
pictures=0
while IFS= read -r command; do
    ((bad == 0)) || break
    pictures=$((pictures + 1))
    shown=${command##* }
    (cd "$work/here" && bash -c "build/release/$command --quiet" </dev/null) || complain "README.md: '$command' fails"
    decibels=$(compare -metric PSNR "$shown" "$work/here/$shown" null: 2>&1) || true
    [[ $decibels =~ ^inf ]] || awk -v d="$decibels" 'BEGIN { exit !(d > 35) }' ||
        complain "$shown is not what '$command' draws ($decibels dB); draw it again"
done < <(grep -oE 'skvalp run [^`]* --png docs/pictures/[a-z-]+\.png' README.md)
# Those of the app and the page are taken by scripts/pictures.sh and looked at by people.
((pictures == $(grep -oE '\(docs/pictures/[a-z-]+\.png\)' README.md | grep -cvE '/(app|page)\.png') || bad > 0)) ||
    complain "README.md has pictures without the commands that draw them"

((bad == 0)) || exit 1
printf 'readme: the example prints "%s"; %d commands work; %d pictures are as drawn today\n' \
    "$(head -n 1 "$work/output")" "$commands" "$pictures"
