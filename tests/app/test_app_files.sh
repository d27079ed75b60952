#!/usr/bin/env bash
# What is saved: a replay that opens again, a picture, the last seconds as a video; what cannot be
# written is said, and the app goes on. Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_app_files.sh BUILD SOURCE}")
# shellcheck source=tests/app/lib.sh
source "$(dirname "$0")/lib.sh"
export TMPDIR=$work/temporary
mkdir "$TMPDIR"
start_display 1280x800
start_app pool
await 60 more 98 fluid 15 65 85 95 || fail "no fluid in the lower half of the pool"
key space

dialog=''
find_dialog() {
    dialog=$(xdotool search --onlyvisible --name "$1" 2>/dev/null | head -n 1)
    [[ -n $dialog ]]
}
no_dialog() { ! find_dialog "$1"; }
# save_as KEY TITLE PATH: by the dialog that the key opens.
save_as() {
    xdotool windowfocus "$window"
    key "$1"
    await 60 find_dialog "$2" || fail "$1 shows no dialog"
    sleep 1
    xdotool windowfocus "$dialog"
    key ctrl+a
    xdotool type --delay 20 "$3"
    sleep 1
    key Return
    await 60 no_dialog "$2" || fail "the dialog of $1 stays open"
    xdotool windowfocus "$window"
}

save_as ctrl+s 'Save What' "$work/kept.skvr"
await 60 test -s "$work/kept.skvr" || fail "Ctrl+S saved nothing"
save_as ctrl+p 'Save a Picture' "$work/kept.png"
await 60 test -s "$work/kept.png" || fail "Ctrl+P saved no picture"
convert "$work/kept.png" -gravity south -crop '40%x20%+0+40' +repage -format '%[fx:mean.b>mean.r+0.2]' info: |
    grep -q 1 || fail "the picture shows no water"
nothing_left() { [[ -z $(ls -A "$TMPDIR") ]]; }
if command -v ffmpeg >/dev/null; then
    save_as ctrl+r 'Save the Last' "$work/kept.mp4"
    await 240 test -s "$work/kept.mp4" || fail "Ctrl+R saved no video"
    await 60 nothing_left || fail "the video left something in the temporary folder"
    save_as ctrl+r 'Save the Last' "/proc/kept.mp4"
    await 240 more 10 red 10 0 60 4 || fail "no message about a video that cannot be written"
    await 60 nothing_left || fail "a video that failed left something in the temporary folder"
    dismissed() { # the first Escape may take a toast away
        key Escape
        less 1 red 10 0 60 4
    }
    await 60 dismissed || fail "the message did not go away"
fi
save_as ctrl+p 'Save a Picture' "/proc/kept.png"
await 60 more 10 red 10 0 60 4 || fail "no message about a picture that cannot be written"
running || fail "the app died"
key ctrl+q
await 120 gone || fail "Ctrl+Q did not quit"
wait "$app" || fail "the app ended with status $?"
app=''

start_app "$work/kept.skvr"
await 120 more 98 fluid 15 65 85 90 || fail "the replay shows no pool"
# One that goes another way than when it was recorded says so.
"$build/write_replays" "$work"
quit_app
start_app "$work/skewed.skvr"
await 60 more 10 red 10 0 60 4 || fail "no message about a replay that goes another way"
# Closed while a video is made, it goes, and nothing is left behind.
if command -v ffmpeg >/dev/null; then
    save_as ctrl+r 'Save the Last' "$work/closed.mp4"
fi
quit_app
nothing_left || fail "a video that was stopped left something in the temporary folder"
[[ ! -e $work/closed.mp4.part ]] || fail "half a video was left"
echo "files: a replay, a picture and a video were saved; the replay opens"
