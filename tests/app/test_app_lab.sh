#!/usr/bin/env bash
# An experiment's card: found in the gallery, measured, its result beside what theory says, its scene in
# two worlds. Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_app_lab.sh BUILD SOURCE}")
# shellcheck source=tests/app/lib.sh
source "$(dirname "$0")/lib.sh"
start_display 800x700
window_size 640 640
start_app pool
key space g
await 'paused and page == "scenes"'

# scroll_to NAME: turns the wheel until it shows, and what is close below it: at the window's edge a click resizes that.
scroll_to() {
    local before
    go 'middle("pages")'
    until is "middle('$1', y=1.5)"; do
        await "find('$1').y"
        before=$answer
        xdotool click 5
        await "find('$1').y < $before"
    done
}
card='A column of water collapses on a dry floor: where its front is, and when.'
scroll_to "$card"
press "$card"
await 'page == "experiment" and shows("1. Question") and not says("theory")'
await 'says("It is measured with 1 000 particles.")'
press Measure Button
await 'shows("Stop", "Button") or says(", theory ")'
await 'says(", theory ") and shows("4. Compare") and shows("Measure", "Button")' 600 # it takes a while
await 'says("Measured with 1")'
scroll_to 'See Two Worlds Side by Side'
press 'See Two Worlds Side by Side'
await 'menus() == 1'
press Oil
await 'page == "play" and len(worlds) == 2 and worlds[1].parameters["fluid.material"] == "oil"'
await 'worlds[0].name == "dam-break" and not paused'
press scenes
await 'page == "scenes"'
quit_app
echo "lab: an experiment was found, measured, compared"
