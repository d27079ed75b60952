#!/usr/bin/env bash
# Measures what the solver costs in WebAssembly, in node, beside what it costs natively on this machine;
# and what a first visit to the page costs.
set -euo pipefail

program=bench-web.sh
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source=scripts/lib.sh
source scripts/lib.sh

usage() {
    cat <<END
Usage: scripts/bench-web.sh [BUILD] [--frames N] [--against MODULES]

Takes N frames (default: 150) of the dam break in turn: with SSE2, with AVX2 and in WebAssembly; then
there on one thread and on two. Prints a Markdown table of ns a particle and substep, the least and in
brackets the median (processor time, for two threads time passed), and the medians of the frames' ratios.
BUILD (default: build/release) has web_reference, which comes with the tests; the modules are those of
build/web. --against: modules to compare with, too. The node is the one that npm brings for the page's
build: its engine is about as new as browsers'.

If web/dist is built and there is a Chromium, a first visit follows: seconds until the simulation is there
and until water is, how far the first second keeps up with real time, and the bytes of each file.
       scripts/bench-web.sh --visit   measures the visit alone.
END
}

export PATH=$page_programs:$PATH

measure_visit() {
    node tests/web/browser/visit.js web/dist
}

if [[ ${1-} == --visit ]]; then
    measure_visit
    exit
fi
choose_build "$@"
shift "$chosen"
[[ -x $build/web_reference && -e build/web/skvalp.wasm ]] ||
    die "$build/web_reference or build/web is missing; build them with: ninja -C $build web_reference; ./run.sh web build"
node web/tools/bench.js "$build" build/web "$@"
if [[ -e web/dist/index.html ]] && command -v "${SKV_CHROMIUM:-chromium}" >/dev/null; then
    echo
    measure_visit
fi
