#!/usr/bin/env bash
# A game goes from one window to another as a link: copied, pasted, given as an argument; what is no
# link is said. Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_app_share.sh BUILD SOURCE}")
# shellcheck source=tests/app/lib.sh
source "$(dirname "$0")/lib.sh"
command -v xclip >/dev/null || {
    echo "xclip is missing: install xclip"
    exit 1
}
copied() { timeout 60 xclip -selection clipboard -o; }
holds() { [[ $(copied) == "$1" ]]; }
copy() { # TEXT; who holds it goes on in the background
    printf '%s' "$1" | timeout 60 xclip -selection clipboard -i
    repeat holds "$1" || fail "the clipboard does not hold $1"
}
start_display 800x600
start_app pool

# 1. Water is poured while a probe reads and pressures are seen, and the moment copied.
key v
await 'style.view == "pressure"'
key m
await 'worlds[0].probes'
key 3
await 'tool == 2'
drag 40 70 55 70
await 'worlds[0].particles > 1003'
let_go
await 'canUndo and moment > 240' # long enough to be stopped on the way, slowly as it is played below
key space
await paused
await 'end if not active else 0'
frames=$answer
key ctrl+shift+c
await 'says("The link was copied")'
link=$(copied)
[[ $link == skvalp:1.* ]] || fail "what was copied is no link: $link"
verdict=$("$build/skvalp" replay "$link") || fail "the link does not go as it was recorded"
[[ $verdict == 'link: '*'as recorded; hash '* ]] || fail "skvalp replay says: $verdict"

# 2. What is no link, pasted: a message.
copy 'no link'
key ctrl+v
await '"no link to open" in message'
press 'Close this message'
await 'not message'

# 3. A link pasted: the view and the probe are there that were seen; a touch does nothing while it is
# watched. Skipped to its end it says how it went, and waits, as it did when it was copied.
copy "$link"
key minus minus minus
await 'speed == 0.1'
key v
await 'style.view == "speed"'
key ctrl+v
await 'worlds[0].opened == 2 and watching and not paused and shows("Take Over")'
await 'style.view == "pressure" and len(worlds[0].probes) == 1'
hold 'at(40, 70)'
await 'withheld == 1 and says("This is a replay") and watching'
let_go
key space
await 'paused and watching'
press 'Skip to the End'
await 'asRecorded and worlds[0].particles > 1003 and says("it went exactly as it was recorded")'
await 'not watching and paused and not mismatch and not message and not shows("Take Over")'

# 4. Opened again and taken over: what was to come is cut off, and redo brings it back.
key ctrl+v
await 'worlds[0].opened == 3 and watching and moment > 0'
key space
await 'paused and watching'
press 'Take Over'
await "not watching and not paused and canRedo and end < $frames"
key ctrl+shift+z
await "end >= $frames and worlds[0].particles > 1003"
quit_app

# 5. As an argument, with a piece cut off: the message, and the scene that is shown otherwise.
start_app "${link:0:100}"
await 'message and worlds[0].name == "dam-break" and moment > 0'
quit_app
echo "share: a link was copied, verified, pasted and played; others were refused"
