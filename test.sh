#!/usr/bin/env bash
# Installs what is missing, builds Skvalp and runs its tests. The last line counts them.
set -euo pipefail

program=test.sh
cd "$(dirname "${BASH_SOURCE[0]}")"
# shellcheck source=scripts/lib.sh
source scripts/lib.sh

usage() {
    cat <<END
Usage: ./test.sh            install what is missing, build, run every test; then run the parsers,
                            the terrain and the session again with the address and
                            undefined-behaviour sanitizers
       ./test.sh core       what needs no npm, browser, window, GTK or clang: all labels but the
                            last three
       ./test.sh LABEL...   only the tests of these labels, and only what they need:
           solver     tests/base, model, camera, terrain, solver, bits
           world      tests/world, measure
           scene      tests/scene, experiments, fuzz (the inputs that broke something once)
           session    tests/session, link
           render     tests/render
           cli        tests/cli
           house      tests/house, install: layers, style, the public interface, packaging
           app        tests/app: the window, on a display of its own
           web        tests/web: the WebAssembly module and the page, in node and Chromium
           sanitized  the second build alone
       ./test.sh --help     this text

Most labels take one or two minutes on two processors, app and web several, the whole a quarter of an
hour. Every half minute a line says how far it has come; in the end lines say what each label took,
which ten tests took longest, and how much processor time all of it took. The last line is "N passed,
N failed" or "N passed, N failed, N skipped", where one test is one program or script under tests/ in
one of the builds; the exit status is 0 if none failed. Skipped are tests of the page where its npm packages cannot be had. SKV_LONG_TESTS=1
runs the long forms and the tests that have no other (CONTRIBUTING.md). SKVALP_VERBOSE=1 shows all
output.
END
}

core_labels=(solver world scene session render cli house)
passed=0
failed=0
skipped=0

fail() {
    printf '%s: %s\n' "$program" "$*" >&2
    failed=$((failed + 1))
}

# one_of LABEL...: the expression by which ctest knows these labels.
one_of() {
    local IFS='|'
    printf '^(%s)$' "$*"
}

# tell_costs LOG: what ctest says that each label took and which ten tests took longest, in seconds.
tell_costs() {
    say "  by labels: $(sed -nE 's/^([a-z_]+) += +([0-9]+)\.[0-9]+ sec\*proc.*/\1 \2 s/p' "$1" |
        paste -sd , | sed 's/,/, /g')"
    say "  slowest: $(sed -nE 's|^ *[0-9]+/[0-9]+ Test +#[0-9]+: ([^ ]+) .* ([0-9]+)\.[0-9]+ sec.*|\2 \1|p' "$1" |
        sort -rn | head -n 10 | sed -E 's/(.*) (.*)/\2 \1 s/' | paste -sd , | sed 's/,/, /g')"
}

# processor_time FILE: of all that has ended, in whole seconds, by what `times` wrote; a pipe would hide it.
processor_time() {
    awk 'NR == 2 { split($1 $2, part, /[ms]/); print int(60 * (part[1] + part[3]) + part[2] + part[4]) }' "$1"
}

# run_tests PRESET LABEL...: runs their tests, one more at a time than there are processors, for those with
# a window or a browser wait much.
# Called by name, through watched and logged.
# shellcheck disable=SC2317
run_tests() {
    local preset=$1
    shift
    ctest --test-dir "build/$preset" -j $(($(nproc) + 1)) --output-on-failure --no-tests=error \
        --label-regex "$(one_of "$@")" "${left_out[@]}"
}

# count_tests PRESET: counts all that ran, and shows what the failing ones said.
count_tests() {
    local preset=$1 log=$logs/test-$1.log summary bad total
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
    tell_costs "$log"
    if ((bad)); then
        grep -vE '^ *[0-9]+/[0-9]+ Test .* Passed|^      Start ' "$log" | sed -n '1,200p'
    fi
}

# skip_page PRESET LABEL...: counts the page's tests of these labels as skipped, and leaves them out.
left_out=()
skip_page() {
    local preset=$1 number
    shift
    number=$(ctest --test-dir "build/$preset" --show-only --label-regex "$(one_of "$@")" \
        --tests-regex '^web/' | sed -n 's/^Total Tests: //p')
    skipped=$((skipped + number))
    left_out=(--exclude-regex '^web/')
}

# prepare PRESET CMAKE-OPTION... [-- TARGET...]: configures and builds; counts a failure and returns 1
# if it can't.
prepare() {
    local preset=$1 options=()
    shift
    while (($#)) && [[ $1 != -- ]]; do
        options+=("$1")
        shift
    done
    say "Building build/$preset"
    if ! configure "$preset" -DSKVALP_TESTS=ON "${options[@]}"; then
        fail "configuring build/$preset failed: $(reason "configure-$preset")" \
            "(all of it in $logs/configure-$preset.log)"
        return 1
    fi
    if ! build "$preset" "${@:2}"; then
        fail "building build/$preset failed: $(reason "build-$preset")" \
            "(all of it in $logs/build-$preset.log)"
        return 1
    fi
}

# sanitize: builds build/asan and runs its tests, without a word and behind all others, which leave processors
# idle while windows and browsers wait.
sanitize() {
    renice -n 10 "$BASHPID" >/dev/null
    rm -f "$logs/test-asan.log"
    configure asan -DSKVALP_TESTS=ON &&
        logged build-asan ninja -C build/asan "${sanitized[@]/%/_tests}" &&
        logged test-asan run_tests asan "${sanitized[@]}"
}

finish() {
    local status=$?
    if ((status && !failed)); then
        failed=1
    fi
    mkdir -p "$logs"
    times >"$logs/times"
    say "Took $(elapsed), and $(processor_time "$logs/times") s of processor time."
    say "$passed passed, $failed failed$( ((!skipped)) || printf ', %d skipped' "$skipped")"
    ((failed == 0)) || exit 1
}

# The labels that are asked for.
labels=()
whole=0
case ${1-} in
'')
    whole=1
    labels=("${core_labels[@]}" app web sanitized)
    ;;
-h | --help)
    usage
    exit
    ;;
esac
for word; do
    case $word in
    core) labels+=("${core_labels[@]}") ;;
    solver | world | scene | session | render | cli | house | app | web | sanitized)
        labels+=("$word")
        ;;
    *) die "unknown argument $word; try: ./test.sh --help" ;;
    esac
done
long=0
((!whole)) || [[ ${SKV_LONG_TESTS:-0} != 1 ]] || long=1
asked() { [[ " ${labels[*]} " == *" $1 "* ]]; }

trap finish EXIT
require_writable . build build/*
packages=("${packages_library[@]}" "${packages_core[@]}")
if asked app; then
    packages+=("${packages_build[@]}" "${packages_run[@]}" "${packages_app[@]}")
fi
if asked web; then
    packages+=("${packages_web[@]}" "${packages_browser[@]}")
fi
if ((long)); then
    packages+=("${packages_long[@]}")
fi
install_packages "${packages[@]}"

# The app is built where it is tested, or where its packages are.
app=ON
asked app || [[ -z $(missing_packages "${packages_build[@]}") ]] || app=OFF
released=() targets=()
for label in "${labels[@]}"; do
    [[ $label != sanitized ]] || continue
    released+=("$label")
    targets+=("tests_$label")
done
# The house's rules read everything that is built.
! asked house || targets=()
# The network is slow where the compiler is busy, so the page's packages come while the rest is built.
packages_of_page() {
    install_npm && { ((!long)) || install_npm_folder tests/web/bundlers; }
}
npm= # the process that installs them
if asked web; then
    packages_of_page &
    npm=$!
fi
sanitized=(sanitized)
((!long)) || sanitized+=(sanitized_long)
beside= # the process that builds and tests build/asan
if ((${#released[@]})) && prepare release "-DSKVALP_APP=$app" -- "${targets[@]}"; then
    ((!long)) || released+=(long)
    if [[ -n $npm ]] && ! wait "$npm"; then
        ((whole)) || die "without npm packages the page cannot be tested"
        say "The tests of the page are skipped: its npm packages cannot be had."
        skip_page release "${released[@]}"
    fi
    if asked sanitized; then
        (unset SKV_LONG_TESTS && sanitize) &
        beside=$!
    fi
    watched test-release run_tests release "${released[@]}" || true
    count_tests release
fi
if asked sanitized; then
    unset SKV_LONG_TESTS # under sanitizers all is long enough without it
    # Where it was built beside, there is nothing left to do but to say what failed.
    [[ -z $beside ]] || wait "$beside" || true
    if prepare asan -- "${sanitized[@]/%/_tests}"; then
        [[ -n $beside ]] || watched test-asan run_tests asan "${sanitized[@]}" || true
        count_tests asan
    fi
fi
