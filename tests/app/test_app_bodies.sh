#!/usr/bin/env bash
# The tool that drops bodies, by key and mouse, and the hand that picks them up. Arguments: build folder,
# source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_app_bodies.sh BUILD SOURCE}")
# shellcheck source=tests/app/lib.sh
source "$(dirname "$0")/lib.sh"
start_display 800x700
window_size 640 640
start_app pool
await 'worlds[0].bodies == []'

# Its button and its key choose it; again, the next shape, which it says.
press 'Body: duck'
await 'tool == 8 and find("Body: duck", "Toggle").active'
key 9
await 'find("Body: ball", "Toggle").active'
key space # each stays where it was dropped
await paused
drag 25 80 25 80
let_go
await 'len(worlds[0].bodies) == 1 and worlds[0].bodies[0].x < 0.5 and canUndo'
key 9
await 'find("Body: crate", "Toggle").active'
drag 75 80 75 80
let_go
await 'len(worlds[0].bodies) == 2 and worlds[0].bodies[1].x > 1'
key ctrl+z
await 'len(worlds[0].bodies) == 1'
key ctrl+y
await 'len(worlds[0].bodies) == 2'

# where BODY: sets x and y to its place in percent, at which it stays while time is paused.
where() {
    await "(100 * worlds[0].bodies[$1].x / worlds[0].width, 100 * worlds[0].bodies[$1].y / worlds[0].height)"
    read -r x y <<<"$answer"
}

# They float, and the hand lifts one out of the water.
await 'worlds[0].time'
key space
await "not paused and worlds[0].time > $answer + 4"
await '0.05 < worlds[0].bodies[1].y < 0.6'
key space 1
await 'paused and not active and tool == 0'
where 1
drag "$x" "$y"
key space
await 'not paused and worlds[0].hands == 1'
point "$x" 85
await 'worlds[0].hands == 1 and worlds[0].bodies[1].y > 0.7'
[[ -z ${SKV_SHOT:-} ]] || { shoot body; convert "$work/body.ppm" "$SKV_SHOT"; }
let_go
await 'worlds[0].hands == 0 and worlds[0].bodies[1].y < 0.6'
quit_app

# A scene's own, which the eraser takes.
start_app "$2/examples/duck.json"
await 'len(worlds[0].bodies) == 4'
key space 4
await 'paused and not active and tool == 3'
where 3
drag "$x" "$y" "$x" "$y"
let_go
await "len(worlds[0].bodies) == 3 and min(abs(100 * one.x / worlds[0].width - $x) for one in worlds[0].bodies) > 5"
