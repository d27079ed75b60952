#!/usr/bin/env bash
# The app as a person meets it: on a display of its own, by mouse and keys, judged by the colours on
# the screen. Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_app.sh BUILD SOURCE}")
# shellcheck source=tests/app/lib.sh
source "$(dirname "$0")/lib.sh"
start_display 1280x800

# 1. A pool: fluid in the lower half, none above it.
start_app pool
await 60 more 98 fluid 15 65 85 95 || fail "no fluid in the lower half of the pool"
less 1 fluid 15 25 85 45 || fail "fluid above the pool"

# 2. The mouse lifts a chunk out of it, and lets it go. Fluid can't follow a hand faster than the
# machine draws, so a busy one gets a slower hand.
lift() { # SECONDS a move
    local y
    point 50 65
    xdotool mousedown 1
    for y in 60 55 50 45 42 40 38 36 35; do
        point 50 "$y"
        sleep "$1"
    done
    await 3 more 8 fluid 42 25 58 45 && return
    xdotool mouseup 1
    return 1
}
lift 0.05 || lift 0.2 || lift 0.6 || lift 2 || fail "the mouse did not lift any fluid"
xdotool mouseup 1
await 120 less 2 fluid 42 25 58 45 || fail "the fluid did not fall back"

# 3. Pause stands still and costs nothing; one step is a change; reset is the start.
key space
await 60 picture_stands || fail "Space did not pause"
# On a busy machine what was begun before takes a while to end.
stands_idle() {
    local before
    before=$(ticks)
    sleep 3
    (($(ticks) - before <= 2))
}
await 60 stands_idle || fail "paused, the app kept working"
shoot paused
key s
stepped() {
    shoot stepped
    ! cmp -s "$work/paused.ppm" "$work/stepped.ppm"
}
await 60 stepped || fail "S did not step"
key r
await 60 less 1 fluid 15 25 85 45 || fail "R did not reset"

# 4. Gravity by the arrow keys, also after something was chosen in a menu, which takes the focus.
key F10
sleep 1
key Escape
key space
key Right
await 120 more 60 fluid 80 20 95 45 || fail "with gravity to the right the fluid stays left"
key Down

# 5. At rest it costs nothing, though it plays; at twice the speed, to be there sooner.
key r plus
at_rest() {
    local before
    before=$(ticks)
    sleep 3
    (($(ticks) - before <= 3))
}
await 240 at_rest || fail "a pool at rest keeps the processor busy"

# 6. The open dialog: a bad file is refused and the pool goes on, a painted picture is shown.
dialog=''
find_dialog() {
    dialog=$(xdotool search --onlyvisible --name 'Open a Scene' 2>/dev/null | head -n 1)
    [[ -n $dialog ]]
}
no_dialog() { ! find_dialog; }
open_by_dialog() {
    xdotool windowfocus "$window"
    key ctrl+o
    await 60 find_dialog || fail "Ctrl+O shows no dialog"
    sleep 0.5
    xdotool windowfocus "$dialog"
    xdotool type --delay 20 "$1"
    sleep 0.5
    key Return
    await 60 no_dialog || fail "the dialog stays open"
    xdotool windowfocus "$window"
}
printf '{"fluid": {"spacing": "wide"}}' >"$work/broken.json"
open_by_dialog "$work/broken.json"
await 60 more 10 red 10 0 60 4 || fail "no message about a broken file"
await 60 more 90 fluid 15 75 85 90 || fail "the running scene was lost to a broken file"
convert -size 160x90 xc:black -fill white -draw 'rectangle 0,86 160,90' \
    -fill '#0000ff' -draw 'rectangle 5,50 60,80' "PNG24:$work/painted.png"
# Slowly, so that the water is still where it was painted when a busy machine comes to look.
for _ in 1 2 3; do key minus; done
open_by_dialog "$work/painted.png"
await 60 less 5 fluid 75 20 95 60 || fail "fluid where none was painted"
await 60 more 60 fluid 8 62 30 85 || fail "no fluid where it was painted"
await 60 less 1 red 10 0 60 4 || fail "the message stayed although something was opened"
quit_app

# 7. A bad file on the command line: the window says so, and the default scene runs.
start_app "$work/broken.json"
await 60 more 10 red 10 0 60 4 || fail "no message about a broken file"
await 60 more 5 fluid 2 20 98 98 || fail "no default scene beside the message"
await 60 picture_changes || fail "the default scene does not run"
key Escape
await 60 less 1 red 10 0 60 4 || fail "the message did not go away"
quit_app
echo "app: a pool was lifted, paused, stepped, reset, tilted, at rest; broken files were refused"
