#!/usr/bin/env bash
# Draws the README's pictures of the app and of the page, by the program itself: docs/pictures/app.png
# and docs/pictures/page.png.
set -euo pipefail

program=pictures.sh
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source=scripts/lib.sh
source scripts/lib.sh

usage() {
    cat <<END
Usage: scripts/pictures.sh [BUILD]

Takes docs/pictures/app.png of the app of BUILD (default: build/release) on a display of its own, and
docs/pictures/page.png of web/dist in Chromium ("./run.sh web build" makes it). Look at them.
END
}

choose_build "$@"
build=$(realpath "$build")
[[ -f web/dist/index.html ]] || die "web/dist is not there; build it with: ./run.sh web build"

# smaller FILE: as few colours as the eye does not miss.
smaller() {
    convert "$1" -strip -dither None -colors 255 -define png:compression-level=9 "PNG8:$1.new"
    mv "$1.new" "$1"
}

# The dam's wave closes around a tube of air after 1.25 s. The app opens that state, is paused, and put
# back to it.
take_app() {
    # shellcheck source=tests/app/lib.sh
    source tests/app/lib.sh
    start_display 1200x800
    window_size 1000 640
    "$build/skvalp" run dam-break --particles 8000 --seconds 1.25 --snapshot "$work/dam-break.skv" --quiet
    start_app "$work/dam-break.skv"
    key space
    await 'paused and not active'
    key r
    await 'paused and moment == 0 and not active and windows[0].frames'
    sleep 2 # headers and buttons fade from one look to another
    import -window "$(xdotool search --onlyvisible --name Skvalp | head -n 1)" docs/pictures/app.png
    smaller docs/pictures/app.png
    quit_app
}

(take_app)
PATH=$page_programs:$PATH node scripts/page-picture.js web/dist docs/pictures/page.png \
    "$("$build/skvalp" share fountain --particles 4000 | sed 's/^skvalp://')"
smaller docs/pictures/page.png
say "Written: docs/pictures/app.png and docs/pictures/page.png"
