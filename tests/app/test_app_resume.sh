#!/usr/bin/env bash
# Going on where one was: what was done is kept when the window closes, and now and then before; the
# next start offers it and opens it only if asked; what is damaged is said and set aside. Arguments:
# build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_app_resume.sh BUILD SOURCE}")
# shellcheck source=tests/app/lib.sh
source "$(dirname "$0")/lib.sh"
start_display 800x600
window_size 640 560
kept=$work/.local/state/skvalp
offered='shows("Go On There")'

pour() {
    key space
    await paused
    key 3
    await 'tool == 2'
    drag 70 70 85 70
    await 'worlds[0].particles > 3010'
    let_go
    key 1 # comes after what let go, which has then been seen
    await 'tool == 0 and canUndo and not active'
    await 'still(worlds[0].particles)'
    poured=$answer
}

# 1. Who only looked leaves nothing behind; who poured does.
start_app
await 'moment > 5'
quit_app
[[ ! -e $kept ]] || fail "what nobody did was kept"
start_app
await 'moment > 5'
is "not $offered" || fail "something is offered before anything was kept"
pour
quit_app
[[ -s $kept/kept.skv ]] || fail "the window closed without keeping the world"

# 2. It is offered, and not forced on anybody; asked for, it is what it was.
start_app
await "$offered and says('Dam break') and worlds[0].name == 'dam-break' and moment > 5"
is 'worlds[0].particles < 3010' || fail "it was opened unasked: $answer"
press 'Go On There'
await "worlds[0].opened == 2 and worlds[0].particles == $poured and worlds[0].title == 'Dam break'"
await "not $offered and not paused and moment > 0"
quit_app

# 3. Who opens something else is not asked, and finds it in the menu. It is kept while one plays, too.
start_app pool
await 'moment > 5'
is "not $offered" || fail "who opens a scene is asked about another: $answer"
key F10
await 'menus() == 1'
press 'Go On Where You Were'
await "worlds[0].opened == 2 and worlds[0].particles == $poured"
await 'menus() == 0 and find("view").focus'
rm -f "$kept/kept.skv"
pour
await "exists('$kept/kept.skv')"
kill -KILL "$app"
wait "$app" 2>/dev/null || true
start_app
await "$offered"

# 4. A damaged file.
printf 'no state' >"$kept/offered.skv"
press 'Go On There'
await "'damaged.skv' in message and worlds[0].name == 'dam-break' and moment > 5"
[[ -e $kept/damaged.skv && ! -e $kept/offered.skv ]] || fail "what is damaged was not set aside"
quit_app
echo "resume: kept, offered, gone on with, set aside"
