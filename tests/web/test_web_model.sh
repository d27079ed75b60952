#!/usr/bin/env bash
# The simulation behind the page, in node: vitest over web/page/simulation.
# Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_web_model.sh BUILD SOURCE}")
cd "${2:?usage: test_web_model.sh BUILD SOURCE}"
# shellcheck source=tests/web/lib.sh
source tests/web/lib.sh
make_modules

log=$(mktemp)
trap 'rm -f "$log"' EXIT
export SKV_MODULES=$modules SKV_NATIVE=$build
if ! (cd web && "${newer[@]}" vitest run --reporter=dot) >"$log" 2>&1; then
    cat "$log" >&2
    exit 1
fi
grep -E 'Tests' "$log"
