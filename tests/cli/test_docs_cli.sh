#!/usr/bin/env bash
# Every example of docs/cli.md does what the page shows: the commands of its console blocks run in
# one folder, in order; their output matches, "..." standing for anything.
# Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_docs_cli.sh BUILD SOURCE}")
page=$(realpath "${2:?usage: test_docs_cli.sh BUILD SOURCE}")/docs/cli.md

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/bin" "$work/here"
ln -s "$build/skvalp" "$work/bin/skvalp"
PATH=$work/bin:$PATH
cd "$work/here"

bad=0
examples=0
command=
expected=

# Runs the command at hand and compares.
run_example() {
    [[ -n $command ]] || return 0
    local actual status=0 pattern
    actual=$(bash -c "$command" 2>&1 </dev/null) || status=$?
    pattern=$(sed 's/[][\\*?]/\\&/g; s/\.\.\./*/g' <<<"$expected")
    examples=$((examples + 1))
    # shellcheck disable=SC2053  # the right side is a pattern
    if ((status != 0)) || [[ $actual != $pattern ]]; then
        printf 'example: %s\nstatus:  %d\nshown:   %s\nprinted: %s\n' "$command" "$status" \
            "$expected" "$actual"
        bad=$((bad + 1))
    fi
    command=
}

inside=0
while IFS= read -r line; do
    if ((inside)) && [[ $line == '```' ]]; then
        run_example
        inside=0
    elif ((inside)) && [[ $line == '$ '* ]]; then
        run_example
        command=${line#'$ '}
        expected=
    elif ((inside)); then
        expected+=${expected:+$'\n'}$line
    elif [[ $line == '```console' ]]; then
        inside=1
    fi
done <"$page"

((examples > 0)) || { printf '%s has no examples\n' "$page"; exit 1; }
((bad == 0)) || exit 1
printf 'docs: %d examples of cli.md do what they show\n' "$examples"
