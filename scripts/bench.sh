#!/usr/bin/env bash
# Measures on this machine, all of it, and writes the results: bench/results/<processor>.csv and .md,
# docs/pictures/bench.svg and the short table of docs/performance.md.
set -euo pipefail

program=bench.sh
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source=scripts/lib.sh
source scripts/lib.sh

page=docs/performance.md

usage() {
    cat <<END
Usage: scripts/bench.sh [BUILD] [OPTION...]

Runs BUILD/skvalp bench (default: build/release) with the options given, and refreshes the table
of $page, the plot beside it and this processor's files in bench/results. Takes minutes; leave the
machine alone.
END
}

choose_build "$@"
shift "$chosen"

cpu=$(sed -nE 's/^(model name|Hardware)[[:space:]]*: *//p' /proc/cpuinfo | head -n 1)
name=$(tr '[:upper:]' '[:lower:]' <<<"${cpu:-unknown}" | sed -E 's/\((r|tm)\)//g; s/[^a-z0-9]+/-/g; s/^-|-$//g')
csv=bench/results/$name.csv

tables=$(mktemp)
trap 'rm -f "$tables"' EXIT
"$build/skvalp" bench "$@" --csv "$csv" --plot docs/pictures/bench.svg --markdown >"$tables" ||
    die "measuring failed, see the line above"
cp "$tables" "${csv%.csv}.md"
scripts/bench-digest.sh "$csv" >"$tables"

replace_in_page "$page" bench "$tables"
say "Refreshed $page, docs/pictures/bench.svg, $csv and ${csv%.csv}.md."
