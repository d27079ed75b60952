#!/usr/bin/env bash
# Two worlds side by side: what is done in one is done in both, or in one alone; time is both's; a
# measurement shows in both; closing the second keeps the first; upright one lies above the other.
# Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_app_compare.sh BUILD SOURCE}")
# shellcheck source=tests/app/lib.sh
source "$(dirname "$0")/lib.sh"
start_display 800x700
start_app pool

# 1. C lays a second world beside the first, with honey in it. Both show the same part.
await 'moment > 3'
compare
await 'worlds[1].parameters["fluid.material"] == "honey" and worlds[0].parameters["fluid.material"] == "water"'
await 'shows("World A") and shows("World B") and shows("Honey") and shows("As it is")'
await 'worlds[1].particles == 1000 and worlds[1].time == worlds[0].time > 0'
await 'worlds[1].area.x > worlds[0].area.x + worlds[0].area.width - 1'
await 'abs(worlds[1].area.width - worlds[0].area.width) < 2'
key ctrl+plus ctrl+plus
await 'worlds[0].camera.zoom > 1.5 and worlds[1].camera.zoom == worlds[0].camera.zoom'
key ctrl+0
await 'worlds[0].camera.zoom == 1 and worlds[1].camera.zoom == 1'

# 2. What is poured into one is poured into both; undo takes it from both. Time is both's.
key space
await 'paused and worlds[0].time == worlds[1].time'
key s
await 'paused and worlds[0].time == worlds[1].time'
press Water
await 'tool == 2'
drag 20 80 40 80
let_go
await 'worlds[0].particles > 1000 and worlds[1].particles == worlds[0].particles'
await 'water(15, 75, 45, 85) > 0 and water(15, 75, 45, 85, 1) > 0'
key ctrl+z
await 'worlds[0].particles == 1000 and worlds[1].particles == 1000'

# 3. Unlinked, into B alone; and gravity in A alone, which gives B a ball of its own.
press 'Hands and gravity in both worlds'
await 'not linked and sum(widget.name == "Gravity" for widget in widgets()) == 2'
hold 'at(60, 80, 1)'
point 80 80 1
let_go
await 'worlds[1].particles > 1000'
is 'worlds[0].particles == 1000' || fail "what was poured into B was poured into A, too: $answer"
key ctrl+z
await 'worlds[1].particles == 1000'
go 'still(at(50, 50))'
xdotool click 1 # the focus, and water, which goes with the undo
await 'worlds[0].particles > 1000'
key ctrl+z
await 'worlds[0].particles == 1000'
key Left
await 'worlds[0].gravity.x == -1 and worlds[1].gravity.x == 0'
await 'sum(widget.name == "Gravity" for widget in widgets()) == 2'
key Down
press 'Hands and gravity in both worlds'
await linked
await 'sum(widget.name == "Gravity" for widget in widgets()) == 1'
key Right
await 'worlds[0].gravity.x == 1 and worlds[1].gravity.x == 1'
key Down
await 'worlds[1].gravity.y == -1'

# 4. A probe is in both, its readings in one chip.
key m s
await 'worlds[0].probes == worlds[1].probes or worlds[1].probes[0].id == worlds[0].probes[0].id'
await 'says("  A: ") and says("  B: ")'
is 'worlds[0].probes[0].x0 == worlds[1].probes[0].x0' || fail "it is elsewhere in B: $answer"
hold 'grip(0, 0, 1)'
point 30 30 1
let_go
await 'abs(worlds[0].probes[0].x0 - 0.48) < 0.02 and abs(worlds[1].probes[0].x0 - 0.48) < 0.02'

# One legend is enough for two worlds that have the same.
key v v
await 'style.view == "speed" and sum(widget.name == "Legend" for widget in widgets()) == 1'

# 5. The second is closed: the first has all the room again, and its probe.
key c
await 'len(worlds) == 1 and len(worlds[0].probes) == 1 and not shows("World B")'
await 'worlds[0].area.width > 500 and find("view").name == "Water"'

# 6. The window closes with two of them; another choice was made in the panel.
key p
press 'Compare with' Menu
await 'menus() == 1'
press Oil
await 'len(worlds) == 2 and worlds[1].parameters["fluid.material"] == "oil"'
# The panel is of the world that is chosen in it.
press 'World B' Toggle
await 'find("World B", "Toggle").active'
press Moon Button
await 'worlds[1].parameters["gravity.y"] == "-1.62" and worlds[0].parameters["gravity.y"] == "-9.81"'
press 'World A' Toggle
press Mars Button
await 'worlds[0].parameters["gravity.y"] == "-3.71" and worlds[1].parameters["gravity.y"] == "-1.62"'
quit_app
grep -q '^compare=oil' "$work/.config/skvalp/play.ini" || fail "what was compared with was not kept"

# 7. Upright: A above B.
window_size 360 640
start_app pool
key c
await 'len(worlds) == 2 and worlds[1].area.y > worlds[0].area.y + worlds[0].area.height - 1'
await 'abs(worlds[1].area.height - worlds[0].area.height) < 2 and windows[0].width <= 380'
# What is opened instead ends it.
press scenes
press 'Dam break' Button
await 'page == "play" and len(worlds) == 1 and worlds[0].name == "dam-break"'
quit_app
echo "compare: two worlds, poured into both and one, undone, measured, closed, upright"
