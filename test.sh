#!/usr/bin/env bash
# Installs what is missing, builds Skvalp and runs every test. The last line counts them.
set -euo pipefail

program=test.sh
cd "$(dirname "${BASH_SOURCE[0]}")"
# shellcheck source=scripts/lib.sh
source scripts/lib.sh

usage() {
    cat <<END
Usage: ./test.sh            install what is missing, build, run every test; then run the tests of
                            the library again with the address and undefined-behaviour sanitizers
       ./test.sh --quick    only the first part
       ./test.sh --help     this text

All of it is twenty to forty minutes of processor time, so ten to twenty on two processors; the
quick part is two thirds of that. Every half minute a line says how far it has come. The last line is
"N passed, N failed", where one test is one program or script under tests/ in one of the builds; the
exit status is 0 if none failed. SKV_LONG_TESTS=1 runs the long forms of some tests (250 painted
worlds instead of 25), and the whole program built by clang. SKVALP_VERBOSE=1 shows all output.
END
}

passed=0
failed=0

fail() {
    printf '%s: %s\n' "$program" "$*" >&2
    failed=$((failed + 1))
}

# run_tests PRESET [CTEST-OPTION...]: runs tests, shows what the failing ones said, counts all.
# One more at a time than there are processors, for those with a window or a browser wait much.
run_tests() {
    local preset=$1 log=$logs/test-$1.log summary bad total
    shift
    watched "test-$preset" ctest --test-dir "build/$preset" -j $(($(nproc) + 1)) --output-on-failure \
        --no-tests=error --timeout 3600 "$@" || true
    summary=$(grep -E '^[0-9]+% tests passed, ' "$log" || true)
    if [[ ! $summary =~ \ ([0-9]+)\ tests\ failed\ out\ of\ ([0-9]+) ]]; then
        fail "running the tests of build/$preset failed: $(reason "test-$preset") ($log)"
        return
    fi
    bad=${BASH_REMATCH[1]}
    total=${BASH_REMATCH[2]}
    failed=$((failed + bad))
    passed=$((passed + total - bad))
    say "build/$preset: $((total - bad)) of $total tests passed ($(elapsed))"
    if ((bad)); then
        grep -vE '^ *[0-9]+/[0-9]+ Test .* Passed|^      Start ' "$log" | sed -n '1,200p'
    fi
}

# prepare PRESET [TARGET...]: configures and builds; counts a failure and returns 1 if it can't.
prepare() {
    local preset=$1
    shift
    say "Building build/$preset"
    if ! configure "$preset" -DSKVALP_TESTS=ON; then
        fail "configuring build/$preset failed: $(reason "configure-$preset")" \
            "(all of it in $logs/configure-$preset.log)"
        return 1
    fi
    if ! build "$preset" "$@"; then
        fail "building build/$preset failed: $(reason "build-$preset")" \
            "(all of it in $logs/build-$preset.log)"
        return 1
    fi
}

# The built-in scenes give the golden hashes, whichever compiler made the program; that clang's solver
# has the same bits is seen by bits/test_bits_native.
test_scenes_of_clang() {
    if logged test-bits-clang bash tests/bits/test_bits_scenes.sh build/clang .; then
        passed=$((passed + 1))
        say "clang's program gives the same bits as gcc's ($(elapsed))"
    else
        fail "clang's program gives other bits than gcc's ($logs/test-bits-clang.log)"
    fi
}

finish() {
    local status=$?
    if ((status && !failed)); then
        failed=1
    fi
    say "Took $(elapsed)."
    say "$passed passed, $failed failed"
    ((failed == 0)) || exit 1
}

quick=0
case ${1-} in
'') ;;
-h | --help)
    usage
    exit
    ;;
--quick)
    quick=1
    ;;
*)
    die "unknown argument $1; try: ./test.sh --help"
    ;;
esac

trap finish EXIT
require_writable . build build/*
install_packages "${packages_build[@]}" "${packages_run[@]}" "${packages_test[@]}"
[[ ${SKV_LONG_TESTS:-0} != 1 ]] || install_packages "${packages_long[@]}"
install_npm
if prepare release; then
    run_tests release
fi
if ((quick)); then
    exit
fi
if [[ ${SKV_LONG_TESTS:-0} == 1 ]] && prepare clang skvalp-cli; then
    test_scenes_of_clang
fi
# These take minutes with the sanitizers, to run the same lines for longer, or on seven threads.
slow='world/test_(walls|thin_walls|determinism)'
# And these half a minute to two each: with the long tests only.
[[ ${SKV_LONG_TESTS:-0} == 1 ]] ||
    slow+='|world/test_(ceilings|flow|forces|frames|sleep|snapshot|step|worlds|footprint)|scene/test_(settle|builtin)|session/test_memory'
# The long forms are long enough without the sanitizers.
unset SKV_LONG_TESTS
if prepare asan sanitized_tests; then
    run_tests asan --label-regex '^sanitized$' --exclude-regex "$slow"
fi
