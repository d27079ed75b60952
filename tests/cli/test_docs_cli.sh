#!/usr/bin/env bash
# Every example of docs/cli.md, docs/share.md and docs/studies.md does what the page shows: the
# commands of their console blocks run in one folder, in order; their output matches, "..." standing
# for anything. The pages of docs/lab show the experiments' cards. Without SKV_LONG_TESTS=1 nothing of
# docs/studies.md is run, no experiment and no bench.
# Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_docs_cli.sh BUILD SOURCE}")
docs=$(realpath "${2:?usage: test_docs_cli.sh BUILD SOURCE}")/docs

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/bin" "$work/here"
# The lab's worlds are small, and figures are the same on any number of threads: on one they cost least.
cat >"$work/bin/skvalp" <<END
#!/bin/bash
[ "\$1" != lab ] || [ "\$2" = --cards ] || set -- "\$@" --threads 1
exec -a skvalp "$build/skvalp" "\$@"
END
chmod +x "$work/bin/skvalp"
PATH=$work/bin:$PATH
cd "$work/here"

bad=0
examples=0
short=1
[[ ${SKV_LONG_TESTS:-0} != 1 ]] || short=0
pages=("$docs/cli.md" "$docs/share.md")
((short)) || pages+=("$docs/studies.md")
command=
expected=

# Runs the command at hand and compares. In the short form the first that measures is left out,
# with those that follow it in its block: they look at what it has written.
left_out=0
run_example() {
    ((!short)) || [[ $command != 'skvalp lab '* && $command != 'skvalp bench '* ]] || left_out=1
    ((!left_out)) || command=
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
        inside=1 left_out=0
    fi
done < <(cat "${pages[@]}")

((examples > 0)) || { printf '%s has no examples\n' "$docs"; exit 1; }
# The cards stand in the program; each experiment's page shows its own as it is printed.
cards=0
# shellcheck disable=SC2016  # the backquotes are the page's
while read -r name; do
    page=$docs/lab/$name.md
    cards=$((cards + 1))
    if ! diff <(skvalp lab "$name" --cards | sed '1s/^## /# /' | grep .) \
        <(sed '/^<!-- card: end -->$/q' "$page" | grep -v '^<!-- card: ' | grep .) >differences; then
        printf '%s does not show the card of skvalp lab %s --cards:\n%s\n' "$page" "$name" "$(<differences)"
        bad=$((bad + 1))
    fi
done < <(skvalp lab --cards | sed -nE 's/^`skvalp lab ([a-z-]+)`$/\1/p')
if ((cards == 0 || cards != $(find "$docs/lab" -name '*.md' | wc -l))); then
    printf '%d experiments have cards, docs/lab has other pages\n' "$cards"
    bad=$((bad + 1))
fi
((bad == 0)) || exit 1
printf 'docs: %d examples of %s do what they show, %d cards are the program'\''s\n' \
    "$examples" "${pages[*]##*/}" "$cards"
