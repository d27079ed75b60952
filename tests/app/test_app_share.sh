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
start_display 800x600
start_app pool

# 1. Water is poured, and the moment copied.
key 3
await 'tool == 2'
drag 40 70 55 70
await 'worlds[0].particles > 3010'
let_go
await canUndo
key space
await paused
key ctrl+shift+c
await 'says("The link was copied")'
link=$(timeout 60 xclip -selection clipboard -o)
[[ $link == skvalp:1.* ]] || fail "what was copied is no link: $link"
verdict=$("$build/skvalp" replay "$link") || fail "the link does not go as it was recorded"
[[ $verdict == 'link: '*'as recorded; hash '* ]] || fail "skvalp replay says: $verdict"

# 2. What is no link, pasted: a message.
printf 'no link' | timeout 60 xclip -selection clipboard -i
key ctrl+v
await '"no link to open" in message'
press 'Close this message'
await 'not message'

# 3. A link pasted: it plays to its end, and says so.
printf '%s' "$link" | timeout 60 xclip -selection clipboard -i
key ctrl+v
await 'worlds[0].opened == 2 and following and not paused'
await 'asRecorded and worlds[0].particles > 3010 and says("it went exactly as it was recorded")'
is 'not mismatch and not message' || fail "something is said: $answer"
quit_app

# 4. As an argument, with a piece cut off: the message, and the scene that is shown otherwise.
start_app "${link:0:100}"
await 'message and worlds[0].name == "dam-break" and moment > 0'
quit_app
echo "share: a link was copied, verified, pasted and played; others were refused"
