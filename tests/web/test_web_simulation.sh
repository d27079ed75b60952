#!/usr/bin/env bash
# The simulation behind the page in Chromium: in a worker, isolated and not, and on the page.
# Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_web_simulation.sh BUILD SOURCE}")
cd "${2:?usage: test_web_simulation.sh BUILD SOURCE}"
# shellcheck source=tests/web/lib.sh
source tests/web/lib.sh
make_modules

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
SKV_MODULES=$modules bundle "$work" "$PWD/tests/web/browser/simulation.page.ts"
in_chromium simulation.js "$work"
found_trial
printf 'web: the simulation plays wherever it lives\n'
