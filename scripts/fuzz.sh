#!/usr/bin/env bash
# Runs the fuzz targets of tests/fuzz under libFuzzer with the address and undefined-behaviour
# sanitizers. The last line counts the targets.
set -euo pipefail

program=fuzz.sh
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source=scripts/lib.sh
source scripts/lib.sh

usage() {
    cat <<END_OF_USAGE
Usage: scripts/fuzz.sh [SECONDS [TARGET...]]

Runs every target, or those named, for SECONDS each (default 60), as many at a time as there are
processors. Targets: ${targets[*]}.
They start from tests/fuzz/corpus; what they find on the way is kept in build/fuzz/corpus and serves
the next run. An input that breaks something is written to build/fuzz/findings; give the file to
build/fuzz/fuzz_TARGET to see it again, and to tests/fuzz/corpus/TARGET once it is mended.
END_OF_USAGE
}

targets=()
for folder in tests/fuzz/corpus/*/; do
    targets+=("$(basename "$folder")")
done
case ${1-} in
-h | --help)
    usage
    exit
    ;;
*[!0-9]*)
    die "not a number of seconds: $1; try: scripts/fuzz.sh --help"
    ;;
esac
seconds=${1:-60}
shift || true
for target in "$@"; do
    [[ -d tests/fuzz/corpus/$target ]] || die "unknown target $target; try: scripts/fuzz.sh --help"
done
(($# == 0)) || targets=("$@")

install_packages "${packages_build[@]}" "${packages_fuzz[@]}"
say "Building build/fuzz"
configure fuzz || die "configuring failed: $(reason configure-fuzz) ($logs/configure-fuzz.log)"
build fuzz "${targets[@]/#/fuzz_}" || die "building failed: $(reason build-fuzz) ($logs/build-fuzz.log)"

# An input may take ten times as long as the longest does on a quiet machine.
run_target() {
    local target=$1
    mkdir -p "build/fuzz/corpus/$target" build/fuzz/findings
    logged "fuzz-$target" "build/fuzz/fuzz_$target" "-max_total_time=$seconds" -timeout=60 \
        -rss_limit_mb=4096 "-artifact_prefix=build/fuzz/findings/$target-" \
        "build/fuzz/corpus/$target" "tests/fuzz/corpus/$target"
}

say "Running ${#targets[@]} target(s) for $seconds s each"
running=0
for target in "${targets[@]}"; do
    if ((running >= $(nproc))); then
        wait -n || true
        running=$((running - 1))
    fi
    run_target "$target" &
    running=$((running + 1))
done
wait || true

passed=0
failed=0
for target in "${targets[@]}"; do
    log=$logs/fuzz-$target.log
    if count=$(sed -nE 's/^Done ([0-9]+) runs in .*/\1/p' "$log") && [[ -n $count ]]; then
        say "fuzz: $target: $count executions, nothing found"
        passed=$((passed + 1))
    else
        say "fuzz: $target: $(grep -m1 -E 'a promise was broken|ERROR: |runtime error: ' "$log" ||
            tail -n 1 "$log") (all of it in $log)"
        # What was called, from the library's functions outwards.
        sed -nE 's|^ +#[0-9]+ 0x[0-9a-f]+ in (.*) /.*/(src/.*)|    \1 \2|p' "$log" | head -n 5
        failed=$((failed + 1))
    fi
done
say "$passed passed, $failed failed"
((failed == 0))
