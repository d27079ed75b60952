#!/usr/bin/env bash
# What is saved: a replay that opens again, a picture, readings, the last seconds as a video; what
# became of each is said, also of those on a full disk, and the app goes on. Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_app_files.sh BUILD SOURCE}")
# shellcheck source=tests/app/lib.sh
source "$(dirname "$0")/lib.sh"
export TMPDIR=$work/temporary
mkdir "$TMPDIR"
start_display 1000x700
window_size 640 640 # a card fits
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
await 'says("kept.skvr was saved")'
save_as ctrl+s 'Save What Happened' "$work/kept.skv"
repeat test -s "$work/kept.skv" || fail "Ctrl+S saved no state"
await 'says("kept.skv was saved")'

# The picture is that of the world: as blue where water is, and as little where there is none.
save_as ctrl+p 'Save a Picture' "$work/kept.png"
await 'says("kept.png was saved")'
blue() { # EXPRESSION: how much more blue than red there is at its place
    await "tuple(int(a - b) for a, b in zip($1[1:], (worlds[0].area.x, worlds[0].area.y)))"
    convert "$work/kept.png" -format "%[fx:round(100*(p{${answer/ /,}}.b-p{${answer/ /,}}.r))]" info:
}
(($(blue 'inside("water")') > 25)) || fail "no water where it is"
(($(blue 'inside("air")') < 25)) || fail "water where none is"
if command -v ffmpeg >/dev/null; then
    save_as ctrl+r 'Save the Last 10 Seconds' "$work/kept.mp4"
    await 'says("kept.mp4 was saved")'
    [[ -s $work/kept.mp4 ]] || fail "Ctrl+R saved no video"
    repeat nothing_left || fail "the video left something in the temporary folder"
    save_as ctrl+r 'Save the Last 10 Seconds' "/proc/kept.mp4"
    await 'message'
    repeat nothing_left || fail "a video that failed left something in the temporary folder"
    press 'Close this message'
    await 'not message'
fi
# A folder without rights: /sys has none, whoever asks.
for one in 'ctrl+s:Save What Happened:kept.skvr' 'ctrl+p:Save a Picture:kept.png'; do
    IFS=: read -r shortcut title name <<<"$one"
    save_as "$shortcut" "$title" "/sys/$name"
    await "message.startswith('$name was not saved: ') and 'Choose another place' in message"
    press 'Close this message'
    await 'not message'
done
# Readings, as CSV.
save_readings() {
    press 'Save as CSV…'
    await 'dialog() == "Save the Readings"' # over the card, which keeps what the toolkit calls focus
    await 'windows[1].xid'
    repeat gives_input "$answer"
    await 'any("Text" in one.type and one.text.endswith(".csv") for one in windows[1].widgets)'
    key ctrl+a
    xdotool type --delay 5 "$1"
    await "shows('$1', 'Text')"
    key Return
    await 'not dialog()'
}
go 'still(at(40, 25))'
key m
await 'says("1  Pressure") and says("cm of water")'
press '1  Pressure*' Toggle
await 'menus() == 1'
save_readings "$work/kept.csv"
await 'says("kept.csv was saved")'
[[ -s $work/kept.csv ]] || fail "no readings were saved"
save_readings /sys/kept.csv
await 'message.startswith("kept.csv was not saved: ")'
close_card() {
    await 'windows[0].xid'
    repeat gives_input "$answer"
    key Escape
    await 'closed()'
    focus
}
close_card
# Of two worlds: a table of three columns, though what theory says of B has a comma in its name.
compare
key space s
await 'paused and not active'
press '1  Pressure  A*' Toggle
await 'menus() == 1 and all(world.probes[0].samples > 0 for world in worlds)'
save_readings "$work/both.csv"
await 'says("both.csv was saved")'
close_card
python3 - "$work/both.csv" <<'END' || fail "what was saved is no table of both worlds: $(head -n 5 "$work/both.csv")"
import csv, sys
head, *rows = csv.reader(open(sys.argv[1], newline=""), strict=True)
assert head[:2] == ["series", "time (s)"] and all(len(row) == 3 for row in [head, *rows])
assert {row[0] for row in rows} == {"World A", "World B", "theory: density g depth", "theory, B"}
END
key c
await 'len(worlds) == 1'
# What was asked for just before the window closes is written nevertheless.
save_as ctrl+s 'Save What Happened' "$work/last.skv"
quit_app
[[ -s $work/last.skv ]] || fail "the window closed without what was to be saved"

start_app "$work/kept.skvr"
await 'worlds[0].name == "pool" and asRecorded and says("it went exactly as it was recorded")'
quit_app
# A state goes on from its moment.
start_app "$work/kept.skv"
await 'worlds[0].particles == 1000 and not following'
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
if command -v ffmpeg >/dev/null; then
    start_app pool
    await 'moment > 5'
    save_as ctrl+r 'Save the Last 10 Seconds' "$work/closed.mp4"
    kill -TERM "$app" # as the system does when it goes down
    ended
fi
nothing_left || fail "a video that was stopped left something in the temporary folder"
[[ ! -e $work/closed.mp4.part ]] || fail "half a video was left"
# A full disk, as a limit on what a file may hold: enough for a short replay, and for nothing else.
trap '' XFSZ
(
    ulimit -f 8 # KiB
    exec "$build/skvalp-play-tested" pool >/dev/null 2>&1
) &
app=$!
await 'worlds[0].opened and windows[0].frames and moment > 5'
focus
key space
await paused
refused() { # KEY TITLE NAME
    save_as "$1" "$2" "$work/$3"
    await "message.startswith('$3 was not saved: ')"
    [[ ! -e $work/$3 && ! -e $work/$3.part ]] || fail "half of $3 was left"
    press 'Close this message'
    await 'not message'
}
refused ctrl+s 'Save What Happened' full.skv
refused ctrl+p 'Save a Picture' full.png
if command -v ffmpeg >/dev/null; then
    refused ctrl+r 'Save the Last 10 Seconds' full.mp4
    repeat nothing_left || fail "a video on a full disk left something in the temporary folder"
fi
quit_app
echo "files: a replay, a state, a picture and a video were saved; they open"
