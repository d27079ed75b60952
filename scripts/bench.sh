#!/usr/bin/env bash
# Measures on this machine, all of it, and puts the results where docs/performance.md shows them:
# bench/results/<processor>.csv, docs/pictures/bench.svg and the tables of the page.
set -euo pipefail

program=bench.sh
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source=scripts/lib.sh
source scripts/lib.sh

page=docs/performance.md

usage() {
    cat <<END
Usage: scripts/bench.sh [BUILD] [OPTION...]

Runs BUILD/skvalp bench (default: build/release) with the options given, and refreshes the tables
of $page, the plot beside it and this processor's CSV. Takes minutes; leave the machine alone.
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

replace_in_page "$page" bench "$tables"
say "Refreshed $page, docs/pictures/bench.svg and $csv."
