#!/usr/bin/env bash
# Installs what is missing, builds Skvalp and starts it.
set -euo pipefail

program=run.sh
caller=$PWD
cd "$(dirname "${BASH_SOURCE[0]}")"
# shellcheck source=scripts/lib.sh
source scripts/lib.sh

default_scene=dam-break

usage() {
    cat <<END
Usage: ./run.sh [SCENE]     install what is missing, build, and start the app on a scene:
                            a built-in name, or a .json or .png file (default: $default_scene)
       ./run.sh build       install what is missing and build, no more:
                            build/release/skvalp and build/release/skvalp-play
       ./run.sh web         the page instead: install what it takes, build it, serve it on this
                            machine and open the browser; "./run.sh web build" only builds web/dist,
                            a folder for any static host, and web/dist/skvalp.html, all in one file
       ./run.sh --help      this text

Where there is no display, or none that answers, the scene is rendered instead, ten seconds of it, as a video and
pictures in out/. Packages come from Debian (apt-get, as root or through sudo); once they are
installed, nothing is fetched any more. SKVALP_VERBOSE=1 shows what apt-get, cmake and ninja say.
END
}

build_programs() {
    require_writable . build build/*
    install_packages "${packages_build[@]}" "${packages_run[@]}"
    # The tests need packages of their own; test.sh adds them to the same folder.
    fresh_options+=(-DSKVALP_TESTS=OFF)
    say "Building build/release/skvalp and build/release/skvalp-play"
    configure release -DSKVALP_APP=ON ||
        die "configuring failed: $(reason configure-release) (all of it in" \
            "$logs/configure-release.log)"
    build release skvalp-cli skvalp-play ||
        die "building failed: $(reason build-release) (all of it in $logs/build-release.log)"
}

# Pictures along the way, and the whole as a video.
render() {
    local scene=$1 name seconds
    require_writable out
    mkdir -p out
    name=$(basename "$scene")
    # Named as they are called from where the user stands.
    name=$(realpath --relative-to="$caller" "$PWD/out")/${name%.*}
    say "Rendering ten seconds of $scene to ${name%/*}/"
    cd "$caller"
    for seconds in 0.5 2; do
        "$program_folder/skvalp" run "$scene" --seconds "$seconds" --png "$name-${seconds}s.png" \
            >/dev/null || die "rendering $scene failed, see the line above"
    done
    "$program_folder/skvalp" run "$scene" --seconds 10 --png "$name-10s.png" --video "$name.mp4" ||
        die "rendering $scene failed, see the line above"
    say "Written: $name.mp4, $name-0.5s.png, $name-2s.png, $name-10s.png"
}

# web/dist, with the modules of build/web.
build_page() {
    require_writable . build build/* web web/dist
    install_packages "${packages_web[@]}"
    install_npm || exit 1
    PATH=$page_programs:$PATH
    say "Building web/dist"
    configure web || die "configuring failed: $(reason configure-web) (all of it in $logs/configure-web.log)"
    build web || die "building failed: $(reason build-web) (all of it in $logs/build-web.log)"
    logged page npm run build --prefix web ||
        die "building the page failed: $(reason page) (all of it in $logs/page.log)"
}

# Serves web/dist until it is interrupted.
serve_page() {
    local address
    coproc server { exec node web/tools/serve.js web/dist; }
    # shellcheck disable=SC2154
    read -r address <&"${server[0]}" || die "serving web/dist failed, see the line above"
    say "Skvalp is at $address  (Ctrl+C ends it)"
    if [[ -n ${DISPLAY:-} || -n ${WAYLAND_DISPLAY:-} ]] && command -v xdg-open >/dev/null; then
        xdg-open "$address" >/dev/null 2>&1 || true
    fi
    # shellcheck disable=SC2154
    wait "$server_PID"
}

case ${1-} in
-h | --help)
    usage
    exit
    ;;
web)
    [[ $# == 1 || ($# == 2 && $2 == build) ]] ||
        die "web takes nothing but build; try: ./run.sh --help"
    build_page
    say "Built in $(elapsed): web/dist, and web/dist/skvalp.html"
    [[ ${2-} == build ]] || serve_page
    exit
    ;;
-*)
    die "unknown option $1; try: ./run.sh --help"
    ;;
esac
(($# <= 1)) || die "one scene at a time, $# were given; try: ./run.sh --help"

build_programs
if [[ ${1-} == build ]]; then
    say "Built in $(elapsed)."
    exit
fi

program_folder=$PWD/build/release
scene=${1:-$default_scene}
# A file is meant relative to where the user stands.
if [[ $scene != /* && -f $caller/$scene ]]; then
    scene=$caller/$scene
fi
if [[ -n ${DISPLAY:-} || -n ${WAYLAND_DISPLAY:-} ]]; then
    status=0
    "$program_folder/skvalp-play" "$scene" || status=$?
    # Status 3: the display does not answer, as the app has said.
    ((status == 3)) || exit "$status"
else
    say "There is no display here (neither DISPLAY nor WAYLAND_DISPLAY is set)."
fi
render "$scene"
