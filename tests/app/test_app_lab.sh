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
click "$card"
await 'page == "experiment" and shows("1. Question") and not says("theory")'
await 'says("It is measured with 1 000 particles.")'
press Measure Button
await 'shows("Stop", "Button") or says(", theory ")'
await 'says(", theory ") and shows("4. Compare") and shows("Measure", "Button")' 600 # it takes a while
await 'says("Measured with 1")'
# However soon it was over, the last picture is of its end, with water where the floor was dry.
scroll_to 'The experiment as it runs'
await "still(middle('The experiment as it runs', x=0.5, y=0.97))"
read -r xid x y <<<"$answer"
blue() {
    import -silent -window "$xid" -crop "9x3+$((x - 4))+$((y - 2))" +repage "$work/floor.ppm"
    [[ $(convert "$work/floor.ppm" -format '%[fx:mean.b > 2 * mean.r]' info:) == 1 ]]
}
repeat blue || fail "the picture is not of the end: $(convert "$work/floor.ppm" -scale 1x1 txt:)"
scroll_to 'See Two Worlds Side by Side'
press 'See Two Worlds Side by Side'
await 'menus() == 1'
press Oil
await 'page == "play" and len(worlds) == 2 and worlds[1].parameters["fluid.material"] == "oil"'
await 'worlds[0].name == "dam-break" and not paused'
press scenes
await 'page == "scenes"'
# The window closes while one is measured: the program ends with it, and not before the thread that draws.
scroll_to "$card"
click "$card"
await 'page == "experiment" and shows("Measure", "Button")'
press Measure Button
await 'shows("Stop", "Button") or says(", theory ")'
quit_app
echo "lab: an experiment was found, measured, compared"
