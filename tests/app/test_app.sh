#!/usr/bin/env bash
# The app as a person meets it: on a display of its own, by mouse and keys. Water is lifted, time is
# paused and stepped, gravity turned; at rest it costs nothing; what cannot be opened is said.
# Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_app.sh BUILD SOURCE}")
export GSK_RENDERER=gl
# shellcheck source=tests/app/lib.sh
source "$(dirname "$0")/lib.sh"
start_display 800x600
window_size 640 420 0
! grep -q SKVALP_DOOR "$build/skvalp-play" || fail "the app that people get has a door"

# 1. A pool: water in the lower half, none above it.
start_app pool
await 'water(0, 0, 100, 45) == 100 and water(0, 60, 100, 100) == 0'
await 'worlds[0].particles == 3000 and text("status").replace(" ", "") == "3000particles"'

# 2. The mouse lifts a chunk out of it, and lets it go. Water follows a hand within some frames.
drag 50 35
await 'worlds[0].hands == 1'
for y in 40 45 50 55 60 65; do
    await moment
    frames=$answer
    point 50 "$y"
    await "moment >= $frames + 4"
done
await 'water(40, 60, 60, 75) > 20'
let_go
await 'worlds[0].hands == 0'
await 'water(0, 65, 100, 100) == 0'

# 3. Pause stands still and costs nothing; one step is a change; reset is the start.
key space
await 'paused and not active and says("paused") and find("Play", "Button") and spent() < 0.03'
await 'moment, windows[0].frames, worlds[0].picture'
read -r frames drawn picture <<<"$answer"
key s
await "paused and moment == $frames + 1 and worlds[0].picture > $picture and windows[0].frames > $drawn"
key comma
await "moment == $frames and end == $frames + 1"
key r
await 'moment == 0 and worlds[0].time == 0 and paused'

# 4. Gravity by the arrow keys, also after something was chosen in a menu, which takes the focus.
key F10
await 'menus() == 1'
key Escape
await 'closed() and find("view").focus'
key space
await 'not paused and find("Pause", "Button")'
key Right
await 'gravity.x == 1 and gravity.y == 0'
await 'water(80, 50, 95, 80) > 60'
key 0
await 'gravity.x == 0 and gravity.y == 0'
key Down
await 'gravity.x == 0 and gravity.y == -1'

# 5. At rest it costs nothing, though it plays.
key r plus
await 'speed == 2 and atRest and says("at rest") and not paused and not active and spent() < 0.03'

# 6. The open dialog: a bad file is refused and the pool goes on, a painted picture is shown.
open_by_dialog() {
    key ctrl+o
    await 'dialog() == "Open a Scene or a Picture"'
    focus
    xdotool type --delay 5 "$1"
    await "shows('$1', 'Text')"
    key Return
    await 'not dialog()'
    focus
}
printf '{"fluid": {"spacing": "wide"}}' >"$work/broken.json"
printf 'no state' >"$work/broken.skv"
await 'still((worlds[0].area.y, worlds[0].area.height))'
area=$answer
open_by_dialog "$work/broken.skv"
await "'$work/broken.skv' in message and 'take a file that Skvalp has saved' in message"
await "still((worlds[0].area.y, worlds[0].area.height))"
[[ $answer == "$area" ]] || fail "a message moves the picture: $area, $answer"
open_by_dialog "$work/broken.json"
await "'$work/broken.json' in message and 'spacing' in message"
is 'worlds[0].name == "pool" and worlds[0].opened == 1' || fail "the pool was lost to a broken file: $answer"
convert -size 160x90 xc:black -fill white -draw 'rectangle 0,86 160,90' \
    -fill '#0000ff' -draw 'rectangle 5,50 60,80' "PNG24:$work/painted.png"
open_by_dialog "$work/painted.png"
await 'worlds[0].opened == 2 and not message'
key space
await paused
key r # to where it was painted
await 'moment == 0 and not seeking and water(45, 0, 100, 100) == 0 and water(10, 15, 30, 40) == 100'
# What was opened is in the menu, and opens again.
key F10
await 'menus() == 1'
press painted.png
await 'worlds[0].opened == 3 and closed()'
quit_app

# 7. A bad file on the command line: the window says so, and the default scene runs.
start_app "$work/broken.json"
await "'$work/broken.json' in message and worlds[0].name == 'dam-break' and moment > 2"
key Escape
await 'not message'
key F10
await 'menus() == 1'
quit_app # in spite of it

# 8. Before the first of 200 000 particles' frames, which takes seconds, nobody says how fast it goes; and
# the window does not wait for it.
printf '{"particles": 200000, "water": [{"shape": "box", "x1": 0.8, "y1": 0.6}]}' >"$work/many.json"
starts() { # anew, if the first frame was done before somebody came to look
    local seen
    launch "$work/many.json"
    await 'says("starting") and "starting" if moment == 0 else moment'
    seen=$answer
    focus
    [[ $seen == starting ]] && return
    quit_app
    return 1
}
repeat starts || fail "nobody says that it starts: $answer"
quit_app
echo "app: a pool was lifted, paused, stepped, reset, tilted, at rest; broken files were refused"
