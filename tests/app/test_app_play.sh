#!/usr/bin/env bash
# What one finds out without reading: water is poured and taken back, a wall is drawn, a pressure is
# measured, time is turned back, a scene is opened from the gallery; full screen is left by Escape; a
# narrow window holds it all. Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_app_play.sh BUILD SOURCE}")
# shellcheck source=tests/app/lib.sh
source "$(dirname "$0")/lib.sh"
command -v openbox >/dev/null || {
    echo "openbox is missing: install openbox"
    exit 1
}
start_display 1280x800
start_app pool
await 60 more 98 fluid 15 65 85 95 || fail "no fluid in the lower half of the pool"

# 1. The tool of key 3 pours water in the air; undo takes it back; so does going back in time.
key minus minus minus # a tenth of real time: it is still falling when a busy machine looks
key 3
point 40 30
xdotool mousedown 1
for x in 45 50 55 60; do
    point $x 30
    sleep 0.3
done
await 60 more 8 fluid 38 24 62 60 || fail "no water was poured"
xdotool mouseup 1
key ctrl+z
await 60 less 2 fluid 38 24 62 45 || fail "Ctrl+Z did not take the water back"
key ctrl+shift+z
await 60 more 3 fluid 38 24 62 60 || fail "Shift+Ctrl+Z did not bring it again"
for _ in 1 2 3 4 5 6 7 8 9 10; do key shift+Left; done
await 60 less 2 fluid 38 24 62 45 || fail "Shift+Left did not go back in time"
key space

# 2. The tool of key 2 draws a wall, which stays.
key 2
point 60 20
shoot before
xdotool mousedown 1
for x in 65 70 75 80; do
    point $x 20
    sleep 0.3
done
xdotool mouseup 1
point 50 5
wall_stands() {
    shoot after
    convert "$work/before.ppm" "$work/after.ppm" -compose difference -composite -crop \
        "$(((right - left) / 10))x6+$((left + (right - left) * 65 / 100))+$((top + (bottom - top) * 20 / 100 - 3))" \
        +repage -format '%[fx:mean>0.03]' info: | grep -q 1
}
await 60 wall_stands || fail "no wall was drawn"
key 1

# 3. A pressure probe: its grip is on the picture, its chip below.
less 1 yellow 5 5 95 95 || fail "yellow before anything was measured"
key m
await 60 more 0 yellow 30 58 40 72 || fail "no probe on the picture"
key ctrl+question
sleep 1
key ctrl+q
await 120 gone || fail "Ctrl+Q did not quit"
wait "$app" || fail "the app ended with status $?"
app=''

# 4. The gallery shows scenes; one is opened; Escape leaves the gallery, and full screen.
start_app pool
await 60 more 98 fluid 15 65 85 95 || fail "no fluid in the lower half of the pool"
key space
key g
await 60 less 60 fluid 15 65 85 95 || fail "G shows no gallery"
key Escape
await 60 more 98 fluid 15 65 85 95 || fail "Escape did not leave the gallery"
openbox --config-file /dev/null >/dev/null 2>&1 & # only a window manager makes full screens
manager=$!
await 60 xprop -root _NET_SUPPORTING_WM_CHECK >/dev/null || fail "no window manager came up"
sleep 1
xdotool windowfocus "$window"
key F11
is_full() {
    place
    ((WIDTH == 1280 && HEIGHT == 800))
}
is_not_full() { ! is_full; }
await 60 is_full || fail "F11 gives no full screen"
key Escape
await 60 is_not_full || fail "Escape did not leave full screen"
kill "$manager"
wait "$manager" || true
manager=''
key g
await 60 less 60 fluid 15 65 85 95 || fail "G shows no gallery"
title() { xdotool getwindowname "$window"; }
opened() { [[ $(title) == 'Dam break'* ]]; }
# A manager that is ended on the way out of full screen leaves the window with another size, and so another
# scene at the place of the second: it gets its own again. It moves, too, and a gallery that is still
# coming up takes no click: so where it is is asked anew, and one clicks until the scene comes up.
open_second() {
    xdotool windowsize "$window" 840 560
    sleep 0.5
    less 60 fluid 15 65 85 95 || key g
    place
    xdotool mousemove $((X + WIDTH * 30 / 100)) $((Y + HEIGHT * 75 / 100))
    sleep 0.5
    xdotool click 1
    await 10 opened
}
await 120 open_second || fail "the gallery's second scene was not opened: $(title)"
quit_app_behind F10

# 5. 360 pixels wide, upright: picture, tools and time are all there, and the settings are kept.
window_size 360 640
start_app pool
((WIDTH <= 380)) || fail "a window of 360 pixels is $WIDTH wide"
((HEIGHT <= 660)) || fail "a window of 640 pixels is $HEIGHT high"
left=$((X + 6)) right=$((X + WIDTH - 6)) bottom=$((Y + HEIGHT - 150))
await 60 more 20 fluid 5 5 95 95 || fail "no water in a narrow window"
quit_app_behind ctrl+o
grep -q '^width=36' "$work/.config/skvalp/play.ini" || fail "the window's size was not kept"

# 6. Where nothing can be remembered it goes on all the same.
rm -rf "$work/.config"
printf 'no folder' >"$work/.config"
start_app pool
await 60 more 98 fluid 15 65 85 95 || fail "no picture with a home that cannot be written"
quit_app
echo "app: poured, undone, gone back, walled, measured, chosen from the gallery, full screen and back, 360 px"
