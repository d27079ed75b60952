#!/usr/bin/env bash
# The examples of docs/lab.md and docs/lab run: the commands, and the settings like `slosh.depth=1`, and
# they miss no more than the pages say. All experiments at once are test_committed's business.
# Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_docs_lab.sh BUILD SOURCE}")
docs=$(realpath "${2:?usage: test_docs_lab.sh BUILD SOURCE}")/docs
page=$docs/lab.md

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

# "experiment|quantity" of what the page's table says is missed.
sed -nE 's/^\| ([a-z-]+) \| ([^|]+) \|.*\*\*miss\*\* \|$/\1|\2/p' "$page" | sed 's/²/^2/' >misses
[[ -s misses ]] || { printf '%s says of nothing that it misses\n' "$page"; exit 1; }

bad=0
examples=0
# run_example ARGUMENT...: skvalp lab with them.
run_example() {
    local status=0
    examples=$((examples + 1))
    "$build/skvalp" lab "$@" --json --quiet --threads 1 >rows 2>said || status=$?
    if ((status > 1)); then
        printf 'example: %s\n%s\n' "$*" "$(<said)"
        bad=$((bad + 1))
    fi
    sed -nE 's/.*"experiment": "([^"]*)", "quantity": "([^"]*)".*"pass": false.*/\1|\2/p' rows |
        sort >missed
    while read -r row; do
        printf 'example: %s\nmisses what the page does not say: %s\n' "$*" "$row"
        bad=$((bad + 1))
    done < <(sort misses | comm -13 - missed)
}

# A remark stands two blanks behind a command of the page's first block.
# shellcheck disable=SC2016  # the backquotes are the page's
mapfile -t commands < <({
    sed -nE 's/^skvalp lab ([^ ]+( [^ ]+)*).*/\1/p' "$page"
    grep -hoE '`skvalp lab [^`]+ [^`]+`' "$page" "$docs"/lab/*.md | sed -E 's/^`skvalp lab (.*)`$/\1/'
    grep -hoE '`[a-z-]+\.[a-z_]+=[0-9.]+`' "$page" "$docs"/lab/*.md | tr -d '`' | grep -v '^fluid\.' |
        sed -E 's/^([a-z-]+)\./\1 --set &/'
} | sort -u)
for command in "${commands[@]}"; do
    [[ $command != --* ]] || continue
    # shellcheck disable=SC2086  # words of a command line
    run_example $command
done

((examples >= 5)) || { printf '%s has only %d examples\n' "$page" "$examples"; exit 1; }
((bad == 0)) || exit 1
printf 'docs: %d examples of lab.md run as the page says\n' "$examples"
