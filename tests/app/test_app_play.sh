#!/usr/bin/env bash
# What one finds out without reading: water is poured and taken back, a wall is drawn and erased, a
# pressure is measured and dragged, time is turned back and stopped. Arguments: build folder, source
# folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_app_play.sh BUILD SOURCE}")
# shellcheck source=tests/app/lib.sh
source "$(dirname "$0")/lib.sh"
start_display 800x760
window_size 640 700 # all tools show
start_app pool

# 1. The tool of key 3 pours water in the air; undo takes it back; so does going back in time.
key minus minus minus # a tenth of real time: it is still falling when a busy machine looks
await 'speed == 0.1'
key 3
await 'tool == 2 and find("Water", "Toggle").active'
drag 40 70 60 70
await 'worlds[0].particles > 1003 and water(35, 55, 65, 80) > 0'
let_go
await canUndo
key ctrl+z
await 'worlds[0].particles == 1000 and canRedo and water(0, 55, 100, 100) == 0'
key ctrl+shift+z
await 'worlds[0].particles > 1003 and not canRedo'
for _ in {1..12}; do # keys are taken as soon as there is something to do for them
    key ctrl+z
    await canRedo
    key ctrl+shift+z
    await 'not canRedo'
done
key shift+Left
await 'paused and not seeking and moment < end'
until is 'worlds[0].particles == 1000'; do # beside much else it was poured more than a second ago
    await moment
    before=$answer
    key shift+Left
    await "not seeking and moment < $before"
done
until is 'moment == end'; do
    await '(moment,)'
    before=$answer
    key shift+Right
    await "not seeking and moment > $before"
done
await 'paused and worlds[0].particles > 1003'

# The bar: while a finger is on it, the picture follows; then it plays on from there.
key space
await 'not paused and moment > 20'
hold 'middle("Rewind")'
await 'paused and not seeking and moment == max(0, round(end + 60 * find("Rewind").value)) < end and find("Rewind").value < -5'
let_go
await 'not paused and find("Rewind").value == 0'
key space
await paused

# 2. The tool of key 2 draws a wall, which stays; the right button erases it.
press Wall
await 'tool == 1'
drag 62 77 78 77
let_go
await 'sum(cells("walls", 65, 75, 75, 80)) == 2'
point 62 77
xdotool mousedown 3
point 78 77
xdotool mouseup 3
await 'sum(cells("walls", 60, 70, 80, 85)) == 0'
key ctrl+z
await 'sum(cells("walls", 65, 75, 75, 80)) == 2'
point 50 90
await brush
old=$answer
xdotool click 4
await "brush > 1.1 * $old"
key bracketleft
await "brush < 0.95 * $old"
key bracketright
await "brush > 1.1 * $old"
press 'Size of the tool'
await 'menus() == 1'
go 'still(middle("Size of the tool", "Scale", x=0.9))'
xdotool click 1
await 'brush > 0.15'
key Escape
await 'closed()'
key 1
await 'tool == 0'

# Dye: the tool that is chosen again takes its next colour.
await dye
old=$answer
key 7
await "tool == 6 and dye == $old"
key 7
await "dye == $old + 1 and not shows('Dye: rose')"
until is "dye == $old"; do # and round to the first
    await '[dye]'
    before=$answer
    key 7
    await "[dye] != $before"
done
await "shows('Dye: rose')"

# 3. A pressure probe under the pointer, while paused: its grip is dragged, its chip has a plot and moves
# it by keys.
is 'not worlds[0].probes and not says("Pressure")' || fail "measured before anything was: $answer"
point 60 15
key m
await 'worlds[0].probes[0].kind == 0 and says("1  Pressure  ") and paused'
await 'abs(worlds[0].probes[0].x0 - 0.96) < 0.01 and abs(worlds[0].probes[0].y0 - 0.135) < 0.01'
await 'worlds[0].probes[0].value > 100 and not says("1  Pressure  –")'
hold 'grip()'
point 30 80
await 'abs(worlds[0].probes[0].x0 - 0.48) < 0.01 and abs(worlds[0].probes[0].y0 - 0.72) < 0.01'
await 'worlds[0].probes[0].value is None and says("1  Pressure  no water here")'
await 'shows("1  no water here")' # beside it, too: white on a plate, to the right of the grip
is_written() {
    local xid x y
    is 'grip()' && read -r xid x y <<<"$answer"
    import -silent -window "$xid" -crop "60x14+$((x + 22))+$((y - 7))" +repage "$work/beside.ppm"
    (($(convert "$work/beside.ppm" -fill black +opaque white -format '%[fx:round(mean*w*h)]' info:) > 20))
}
repeat is_written || fail "the reading is not beside its probe"
let_go
press '1  Pressure  no water here' Toggle
await 'menus() == 1 and shows("Save as CSV…")'
key Escape
await 'closed() and find("view").focus'
tab_to '1  Pressure'
await 'worlds[0].probes[0].x0, worlds[0].probes[0].y0'
read -r x y <<<"$answer"
key Right
await "abs(worlds[0].probes[0].x0 - $x - 0.01) < 1e-6"
key shift+Down
await "abs(worlds[0].probes[0].y0 - $y + 0.001) < 1e-6"
key Delete
await 'not worlds[0].probes and not says("Pressure") '
# One that is dragged out of the picture stays at its edge; a line's end moves alone.
press Measure
await 'menus() == 1'
press 'Ruler'
await 'len(worlds[0].probes) == 1 and says("  Ruler  ") and closed()'
await 'worlds[0].probes[0].x0, worlds[0].probes[0].y0'
read -r x y <<<"$answer"
hold 'grip(0, 1)'
point 90 20
let_go
await "abs(worlds[0].probes[0].x1 - 1.44) < 0.01 and worlds[0].probes[0].x0 == $x"
hold 'grip()'
point 20 40
await 'abs(worlds[0].probes[0].x0 - 0.32) < 0.01 and abs(worlds[0].probes[0].y0 - 0.36) < 0.01'
let_go
await "abs(worlds[0].probes[0].x1 - worlds[0].probes[0].x0 - 1.44 + $x) < 0.02"
await "abs(worlds[0].probes[0].y1 - worlds[0].probes[0].y0 - 0.18 + $y) < 0.02"
hold 'grip()'
go 'middle("Rewind")'
let_go
await 'len(worlds[0].probes) == 1 and worlds[0].probes[0].y0 == 0'
hold 'grip()'
go 'middle("Hand")'
let_go
await 'len(worlds[0].probes) == 1 and worlds[0].probes[0].x0 == 0'
tab_to '2  Ruler'
key Delete
await 'not worlds[0].probes'

# Ten of them: apart from each other and from walls, and the new one's chip is in sight.
for i in {1..10}; do
    point 60 15
    key m
    await "len(worlds[0].probes) == $i"
    await 'still(middle([one.name for one in windows[0].widgets if "  Pressure  " in one.name][-1]))'
done
apart='for one in worlds[0].probes for two in worlds[0].probes if one.id < two.id'
await "min(abs(complex(one.x0 - two.x0, one.y0 - two.y0)) $apart) > 0.03"
# The row of chips takes room from the picture, whose walls keep their margin.
lid='worlds[0].camera.originY - worlds[0].camera.scale * worlds[0].height'
await "abs(min(worlds[0].camera.originX, $lid) - 6) < 0.1"

# 4. A stopwatch runs by the water's time.
key w
await 'shows("Lap") and says("0.00 s")'
key s
await 'says("0.02 s")'
key l
await 'says("0.02 s (1: 0.02 s)")'
key w
await 'not shows("Lap") and says("0.02 s")'

# 5. A hand for the keyboard.
key 1 k
await 'says("Arrow keys move the hand")'
key space Return
await 'not paused and worlds[0].hands == 1'
key Return
await 'worlds[0].hands == 0'
key k Right
await 'gravity.x == 1'
quit_app
echo "play: poured, undone, gone back, walled, erased, dyed, measured, timed, held by keys"
