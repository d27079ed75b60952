#!/usr/bin/env bash
# Two worlds side by side: what is done in one is done in both, or in one alone; time is both's; a
# measurement shows in both; closing the second keeps the first; upright one lies above the other.
# Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_app_compare.sh BUILD SOURCE}")
# shellcheck source=tests/app/lib.sh
source "$(dirname "$0")/lib.sh"
start_display 1280x800
start_app pool
await 60 more 98 fluid 15 65 85 95 || fail "no fluid in the lower half of the pool"

# 1. C lays a second world beside the first. The badges are what is yellow.
less 1 yellow 0 0 100 100 || fail "yellow before anything was compared"
key c
await 60 more 0 yellow 70 90 75 100 || fail "C shows no second world"
await 60 more 98 fluid 5 55 45 65 || fail "no water in world A"
await 60 more 98 fluid 55 55 95 65 || fail "no water in world B"
# Both show the same part of their worlds.
less 5 fluid 2 82 12 92 || fail "water below world A"
key ctrl+plus ctrl+plus ctrl+plus ctrl+plus
await 60 more 90 fluid 2 82 12 92 || fail "Ctrl++ did not zoom world A"
await 60 more 90 fluid 88 82 98 92 || fail "Ctrl++ did not zoom world B"
key ctrl+0
await 60 less 5 fluid 88 82 98 92 || fail "Ctrl+0 does not show all of world B"

# 2. What is poured into one is poured into both; undo takes it from both.
key space # nothing falls while a busy machine looks
key 3
pour() { # FROM TO, percent
    point "$1" 40
    xdotool mousedown 1
    for x in $((($1 * 2 + $2) / 3)) $((($1 + $2 * 2) / 3)) $2; do
        point "$x" 40
        sleep 0.3
    done
    xdotool mouseup 1
}
pour 15 30
await 60 more 5 fluid 12 36 33 46 || fail "what was poured into A is not in A"
await 60 more 5 fluid 62 36 83 46 || fail "what was poured into A is not in B"
key ctrl+z
await 60 less 1 fluid 12 36 33 46 || fail "Ctrl+Z did not take the water from A"
await 60 less 1 fluid 62 36 83 46 || fail "Ctrl+Z did not take the water from B"

# 3. Unlinked, into B alone.
xdotool mousemove $((right - 72)) $((top + 26))
sleep 0.5
xdotool click 1
sleep 0.5
pour 65 80
await 60 more 5 fluid 62 36 83 46 || fail "no water was poured into B"
less 1 fluid 12 36 33 46 || fail "what was poured into B was poured into A, too"
key ctrl+z
await 60 less 1 fluid 62 36 83 46 || fail "Ctrl+Z did not take the water from B alone"

key space

# 4. A probe is in both; its plot, with a curve of each.
key m
await 60 more 0 yellow 13 51 22 62 || fail "no probe in world A"
await 60 more 0 yellow 63 51 73 62 || fail "no probe in world B"

# 5. The second is closed: the first has all the room again, and its probe.
key c
await 60 less 1 yellow 65 50 90 75 || fail "C did not close the second world"
await 60 more 98 fluid 15 65 85 85 || fail "world A did not take its room again"

# 6. The window closes with two of them.
key c # the probe lies in a row below
await 60 more 0 yellow 70 80 75 100 || fail "C shows no second world again"
key ctrl+q
await 120 gone || fail "Ctrl+Q did not quit with two worlds"
wait "$app" || fail "the app ended with status $?"
app=''
if grep -E 'CRITICAL|WARNING|ERROR' "$work/app.log"; then fail "the toolkit complained"; fi

# 7. Upright: A above B.
window_size 360 640
start_app pool
((WIDTH <= 380)) || fail "a window of 360 pixels is $WIDTH wide"
left=$((X + 6)) right=$((X + WIDTH - 6)) bottom=$((Y + HEIGHT - 162))
await 60 more 20 fluid 5 5 95 95 || fail "no water in a narrow window"
key c
await 60 more 0 yellow 36 90 48 100 || fail "no second world below the first"
await 60 more 20 fluid 5 55 95 95 || fail "no water in the lower world"
await 60 more 20 fluid 5 5 95 45 || fail "no water in the upper world"
((WIDTH <= 380)) || fail "with two worlds the window is $WIDTH wide"
quit_app
echo "compare: two worlds, poured into both and one, undone, measured, closed, upright"
