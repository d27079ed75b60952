#!/usr/bin/env bash
# Where a scene has several fluids a row of chips chooses what is poured, as a key does; elsewhere there is
# none. Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_app_fluids.sh BUILD SOURCE}")
# shellcheck source=tests/app/lib.sh
source "$(dirname "$0")/lib.sh"
start_display 800x700
window_size 640 640
start_app oil
await 'len(worlds[0].fluids) == 2 and worlds[0].fluids[1] > 0'
await 'find("water", "Toggle").active and find("oil", "Toggle").active is False'
await 'worlds[0].fluids'
before=$answer

# A chip chooses the fluid, and the tool that pours.
press oil
await 'fluid == 1 and tool == 2 and find("oil", "Toggle").active'
drag 40 80 60 80
await "worlds[0].fluids[1] > ${before}[1] and worlds[0].fluids[0] == ${before}[0]"
let_go
await canUndo
key ctrl+z
await "worlds[0].fluids == $before"

# A key chooses the next, with the tool that pours.
key n
await 'fluid == 0 and tool == 2 and find("water", "Toggle").active'
key n
await 'fluid == 1'

# The keyboard's hand pours it, too.
key k
key Return
await "worlds[0].fluids[1] > ${before}[1] and worlds[0].fluids[0] == ${before}[0]"
key Return
key k
quit_app

start_app pool
await 'len(worlds[0].fluids) == 1 and fluid == 0'
is 'not shows("oil", "Toggle")' || fail "a choice of one fluid: $answer"
