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
start_display 1280x800
start_app pool
await 60 more 98 fluid 15 65 85 95 || fail "no fluid in the lower half of the pool"

# 1. Water is poured, and the moment copied.
key 3
point 40 30
xdotool mousedown 1
for x in 45 50 55; do
    point $x 30
    sleep 0.3
done
xdotool mouseup 1
key space
key ctrl+shift+c
link=''
copied() {
    link=$(timeout 5 xclip -selection clipboard -o 2>/dev/null) && [[ $link == skvalp:1.* ]]
}
await 60 copied || fail "Ctrl+Shift+C copied no link"
verdict=$("$build/skvalp" replay "$link") || fail "the link does not go as it was recorded"
[[ $verdict == 'link: '*'as recorded; hash '* ]] || fail "skvalp replay says: $verdict"

# 2. What is no link, pasted: a message.
printf 'no link' | timeout 5 xclip -selection clipboard -i
key ctrl+v
await 60 more 10 red 10 0 60 4 || fail "no message about a clipboard without a link"
key Escape

# 3. A link pasted: it plays to its end, and says so, once what was said before is gone.
said() { more 5 dark 25 89 75 97; }
silent() { ! said; }
await 60 silent || fail "the toast does not go"
printf '%s' "$link" | timeout 5 xclip -selection clipboard -i
key ctrl+v
await 120 said || fail "the end of the link was not said"
quit_app

# 4. As an argument, with a piece cut off: the message, and the scene that is shown otherwise.
start_app "${link:0:100}"
await 60 more 10 red 10 0 60 4 || fail "no message about a damaged link"
await 60 more 10 fluid 0 30 100 100 || fail "no scene beside the message"
key ctrl+q
await 120 gone || fail "Ctrl+Q did not quit"
wait "$app" || fail "the app ended with status $?"
app=''
echo "share: a link was copied, verified, pasted and played; others were refused"
