# Shared by the tests of the WebAssembly module: building it, and running it in node beside what it is
# compared with. Sourced, never run; the caller stands in the source folder and has set `build`.
# shellcheck shell=bash disable=SC2034,SC2154

modules=$build/web
# The newer node that npm brings, and the programs beside it: before a command.
newer=(env "PATH=$PWD/web/node/node_modules/.bin:$PWD/web/node_modules/.bin:$PATH")
# shellcheck source=tests/support/comparing.sh
source tests/support/comparing.sh

# make_modules: builds them in a folder below the build folder, for one test after the other. Ends the
# test if that fails.
make_modules() {
    local tool log=$build/web.log
    for tool in clang-19 wasm-ld-19 wasm-opt node; do
        command -v "$tool" >/dev/null || complain "$tool is missing; ./test.sh installs it"
    done
    for tool in /usr/include/wasm32-wasi web/node_modules; do
        [[ -d $tool ]] || complain "$tool is missing; ./test.sh installs it"
    done
    ((bad == 0)) || exit 1
    if ! flock "$build" bash -c "cmake --preset web -B '$modules' && ninja -C '$modules'" >"$log" 2>&1; then
        grep -E 'error|FAILED' "$log" | head -n 20 >&2
        printf 'building the WebAssembly modules failed, see %s\n' "$log" >&2
        exit 1
    fi
}

# in_wasm THREADS JOB ARGUMENT...: what the module makes of it.
in_wasm() {
    timeout 1200 node tests/web/reference.js "$modules" "$@"
}

# played FILE...: what comes of replays natively: frames, hash, and whether they went as recorded.
played() {
    local file
    for file in "$@"; do
        "$build/skvalp" replay "$file" --json 2>/dev/null || true
    done | sed -E 's/.*"frames": ([0-9]+), "hash": "([0-9a-f]+)", "same": (true|false).*/\1 \2 \3/
        s/true/same/; s/false/another/' | sed '/^$/d'
}

# bundle FOLDER SCRIPT...: makes scripts of tests/web/browser whole, for a browser.
bundle() {
    local folder=$1
    shift
    "${newer[@]}" node tests/web/browser/bundle.js "$folder" "$@"
}

# in_chromium SCRIPT ARGUMENT...: a program of tests/web/browser; one browser at a time. Ends the test if
# it fails. Trials have limits of their own (trials.js), so the hour is for what hangs beside them. One that
# has no trial of the name that SKV_TRIAL says gives 64: see found_trial.
programs=0 without=0
in_chromium() {
    local script=tests/web/browser/$1
    shift
    local status=0
    flock -o "$build/browser.lock" timeout 3600 "${newer[@]}" node "$script" "$@" || status=$?
    ((status != 124)) || printf '%s was not over after an hour\n' "$script" >&2
    ((status == 0 || status == 64)) || exit 1
    programs=$((programs + 1)) without=$((without + (status == 64)))
}

# found_trial: ends the test if none of its programs had a trial of the name that SKV_TRIAL says.
found_trial() {
    ((without < programs)) && return
    printf 'SKV_TRIAL: no trial here has "%s" in its name\n' "${SKV_TRIAL:-}" >&2
    exit 1
}

# verdict: the last line of a test.
verdict() {
    ((bad == 0 && compared > 0)) || exit 1
    printf 'web: %d runs gave what they give natively\n' "$compared"
}

# make_page FOLDER MODE...: what `npm run build` makes, of the modules of make_modules: the page
# (production), and all of it in one file (single). Without SKV_LONG_TESTS=1 it is made smaller by what
# vite brings, in a tenth of terser's time. Ends the test if that fails.
make_page() {
    local mode smaller=(--minify oxc)
    [[ ${SKV_LONG_TESTS:-0} != 1 ]] || smaller=()
    for mode in "${@:2}"; do
        if ! (cd web && SKV_MODULES=$modules "${newer[@]}" node node_modules/vite/bin/vite.js build --mode "$mode" \
            --outDir "$1" --logLevel warn "${smaller[@]}") >"$build/page.log" 2>&1; then
            grep -iE 'error' "$build/page.log" | head -n 5 >&2
            printf 'building the page failed, see %s\n' "$build/page.log" >&2
            exit 1
        fi
    done
}

# unpack_package FOLDER: the npm package, packed, as npm would lay it out in the project FOLDER/project, which
# asks no network. The sources may belong to somebody else: it is packed in FOLDER. Ends the test if that fails.
unpack_package() {
    local work=$1 package
    mkdir -p "$work/web" "$work/project/node_modules/skvalp"
    cp -r web/src web/tools web/package.json web/tsconfig.json web/README.md "$work/web"
    cp LICENSE "$work"
    ln -s "$PWD/web/node_modules" "$work/web/node_modules"
    (
        cd "$work/web"
        SKV_MODULES=$modules "${newer[@]}" npm pack --silent --pack-destination "$work"
    ) >"$build/package.log" 2>&1 || {
        tail -n 5 "$build/package.log" >&2
        exit 1
    }
    tar xzf "$work"/skvalp-*.tgz --strip-components=1 -C "$work/project/node_modules/skvalp"
    for package in jsonc-parser fast-png pako fflate iobuffer; do
        ln -s "$PWD/web/node_modules/$package" "$work/project/node_modules/$package"
    done
}
