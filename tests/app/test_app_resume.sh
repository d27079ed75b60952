#!/usr/bin/env bash
# Going on where one was: what was done is kept when the window closes, and now and then before, by each
# window for itself; the next starts offer it and open it only if asked; what is damaged is said and set
# aside. Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_app_resume.sh BUILD SOURCE}")
# shellcheck source=tests/app/lib.sh
source "$(dirname "$0")/lib.sh"
start_display 800x600
window_size 640 560
kept=$work/.local/state/skvalp/kept
offered='shows("Go On There")'

pour() {
    until # what was poured before has fallen, and no wave is there: there is no room in water
        await 'water(65, 65, 90, 75) == 0'
        key space
        await paused
        is 'water(65, 65, 90, 75) == 0'
    do
        key space
        await 'not paused'
    done
    await 'worlds[0].particles'
    local before=$answer
    key 3
    await 'tool == 2'
    drag 70 70 85 70
    await "worlds[0].particles > $before"
    let_go
    key 1
    # A step comes after all that was poured before; and the window keeps nothing when it closes while steps seem
    # to take long, as they do on a busy machine.
    until
        await '(moment,)'
        key s
        await "moment == $answer + 1 and tool == 0 and canUndo and not active"
        is 'worlds[0].stepMs < 100'
    do :; done
    await 'worlds[0].particles'
    poured=$answer
}

# done_by FILE: all that was poured; what is kept after this file was made, for a step came after it, has all.
done_by() {
    touch "$1"
    await '(moment,)'
    key s
    await "moment == $answer + 1"
}

# 1. Who only looked leaves nothing behind; who poured does.
start_app
await 'moment > 5'
quit_app
[[ ! -e $kept-1.skv ]] || fail "what nobody did was kept"
start_app
await 'moment > 5'
is "not $offered" || fail "something is offered before anything was kept"
pour
quit_app
[[ -s $kept-1.skv ]] || fail "the window closed without keeping the world"

# 2. It is offered, and not forced on anybody; asked for, it is what it was.
start_app
await "$offered and says('Dam break') and worlds[0].name == 'dam-break' and moment > 5"
is 'worlds[0].particles < 1003' || fail "it was opened unasked: $answer"
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
await "worlds[0].opened == 2 and worlds[0].particles == $poured and closed()"
first=$app
pour
there=$poured
done_by "$work/first"

# 4. Two windows keep a world each, as they go on; the windows after them go on in one each.
rm "$SKVALP_DOOR"
start_app pool
pour
done_by "$work/second"
repeat test "$kept-2.skv" -nt "$work/second" || fail "the second window keeps nothing"
repeat test "$kept-1.skv" -nt "$work/first" || fail "the first window keeps nothing more"
kill -KILL "$first" "$app"
wait "$first" "$app" 2>/dev/null || true
touch "$kept-2.skv" # the newest
start_app
await "$offered and says('Kept: Pool')"
press 'Go On There'
await "worlds[0].opened == 2 and worlds[0].particles == $poured and worlds[0].title == 'Pool'"
first=$app
rm "$SKVALP_DOOR"
start_app
await "$offered and says('Kept: Dam break')"
press 'Go On There'
await "worlds[0].opened == 2 and worlds[0].particles == $there and worlds[0].title == 'Dam break'"
key F10
await 'menus() == 1 and not shows("Go On Where You Were")'
kill -KILL "$first"
wait "$first" 2>/dev/null || true
key Escape
await 'closed()'
quit_app

# 5. A damaged file. What else is kept is still to be had.
printf 'no state' >"$kept-1.skv"
start_app
await "$offered"
press 'Go On There'
await "'damaged.skv' in message and worlds[0].name == 'dam-break' and moment > 5"
[[ -e $(dirname "$kept")/damaged.skv && ! -e $kept-1.skv ]] || fail "what is damaged was not set aside"
key F10
await 'menus() == 1'
press 'Go On Where You Were'
await "worlds[0].opened == 2 and worlds[0].particles == $poured and closed()"
quit_app

# 6. Eight are kept, the newest.
for one in {3..12}; do
    touch -d "$one days ago" "$kept-$one.skv"
done
start_app
await 'moment > 5'
quit_app
[[ -e $kept-2.skv && -e $kept-9.skv && ! -e $kept-10.skv ]] || fail "not the eight newest: $(ls "$kept"*)"
echo "resume: kept, offered, gone on with, set aside, tidied"
