#!/usr/bin/env bash
# What is saved: a replay that opens again, a picture, the last seconds as a video; what cannot be
# written is said, and the app goes on. Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_app_files.sh BUILD SOURCE}")
# shellcheck source=tests/app/lib.sh
source "$(dirname "$0")/lib.sh"
export TMPDIR=$work/temporary
mkdir "$TMPDIR"
start_display 1000x700
start_app pool
await 'moment > 5'
key space
await paused

# save_as KEY TITLE PATH: by the dialog that the key opens.
save_as() {
    key "$1"
    await "dialog() == '$2'"
    focus
    await 'any(one.focus and "Text" in one.type for one in windows[1].widgets)'
    key ctrl+a
    xdotool type --delay 5 "$3"
    await "shows('$3', 'Text')"
    key Return
    await 'not dialog()'
    focus
}
nothing_left() { [[ -z $(ls -A "$TMPDIR") ]]; }

save_as ctrl+s 'Save What Happened' "$work/kept" # its ending comes by itself
repeat test -s "$work/kept.skvr" || fail "Ctrl+S saved nothing"
save_as ctrl+s 'Save What Happened' "$work/kept.skv"
repeat test -s "$work/kept.skv" || fail "Ctrl+S saved no state"

# The picture is that of the world: as blue where water is, and as little where there is none.
save_as ctrl+p 'Save a Picture' "$work/kept.png"
await 'says("The picture was saved")'
blue() { # EXPRESSION: how much more blue than red there is at its place
    await "tuple(int(a - b) for a, b in zip($1[1:], (worlds[0].area.x, worlds[0].area.y)))"
    convert "$work/kept.png" -format "%[fx:round(100*(p{${answer/ /,}}.b-p{${answer/ /,}}.r))]" info:
}
(($(blue 'inside("water")') > 25)) || fail "no water where it is"
(($(blue 'inside("air")') < 25)) || fail "water where none is"
if command -v ffmpeg >/dev/null; then
    save_as ctrl+r 'Save the Last 10 Seconds' "$work/kept.mp4"
    await 'says("The video was saved")'
    [[ -s $work/kept.mp4 ]] || fail "Ctrl+R saved no video"
    repeat nothing_left || fail "the video left something in the temporary folder"
    save_as ctrl+r 'Save the Last 10 Seconds' "/proc/kept.mp4"
    await 'message'
    repeat nothing_left || fail "a video that failed left something in the temporary folder"
    press 'Close this message'
    await 'not message'
fi
save_as ctrl+p 'Save a Picture' "/proc/kept.png"
await 'message.startswith("/proc/kept.png cannot be written")'
quit_app

start_app "$work/kept.skvr"
await 'worlds[0].name == "pool" and asRecorded and says("it went exactly as it was recorded")'
quit_app
# A state goes on from its moment.
start_app "$work/kept.skv"
await 'worlds[0].particles == 3000 and not following'
quit_app
# One that goes another way than when it was recorded says so.
"$build/write_replays" "$work"
start_app "$work/skewed.skvr"
await 'mismatch and "goes another way" in message'
# Closed while a video is made, it goes, and nothing is left behind.
if command -v ffmpeg >/dev/null; then
    save_as ctrl+r 'Save the Last 10 Seconds' "$work/closed.mp4"
fi
quit_app
nothing_left || fail "a video that was stopped left something in the temporary folder"
[[ ! -e $work/closed.mp4.part ]] || fail "half a video was left"
echo "files: a replay, a state, a picture and a video were saved; they open"
