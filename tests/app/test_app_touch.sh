#!/usr/bin/env bash
# Fingers on a touch screen, under a headless compositor: two that come down one after the other lift
# water, each its own; two that come down together zoom, and no tool draws; one draws, and a tap of
# three takes that back. Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_app_touch.sh BUILD SOURCE}")
if [[ ${2-} != --inside ]]; then
    for program in dbus-run-session busctl mutter pipewire; do
        command -v "$program" >/dev/null || {
            echo "$program is missing: install dbus systemd mutter pipewire"
            exit 1
        }
    done
    exec env -u DBUS_SESSION_BUS_ADDRESS dbus-run-session -- bash "$0" "$build" --inside
fi
bus=$DBUS_SESSION_BUS_ADDRESS
# shellcheck source=tests/app/lib.sh
source "$(dirname "$0")/lib.sh"
cd "$work" # where the app saves what it names itself
driver=''
leave() {
    [[ -z $driver ]] || kill "$driver" 2>/dev/null || true
    finish
}
trap leave EXIT

# The compositor; its remote control streams the screen, to nobody.
export XDG_RUNTIME_DIR=$work LIBGL_ALWAYS_SOFTWARE=1 WAYLAND_DISPLAY=skvalp-touch GDK_BACKEND=wayland
unset DISPLAY
pipewire >"$work/pipewire.log" 2>&1 &
manager=$!
DBUS_SESSION_BUS_ADDRESS=$bus mutter --headless --wayland --no-x11 --virtual-monitor 640x480 \
    --wayland-display "$WAYLAND_DISPLAY" >"$work/mutter.log" 2>&1 &
server=$!
listens() {
    local name
    for name in RemoteDesktop ScreenCast; do
        busctl --address="$bus" call "org.gnome.Mutter.$name" / org.freedesktop.DBus.Peer Ping >/dev/null 2>&1
    done && [[ -S $work/$WAYLAND_DISPLAY && -S $work/pipewire-0 ]]
}
await 60 listens || fail "the compositor did not start: $(tail -n 3 "$work/mutter.log")"
coproc fingers { DBUS_SESSION_BUS_ADDRESS=$bus exec "$build/fingers" 2>"$work/fingers.log"; }
# shellcheck disable=SC2154
driver=$fingers_PID
exec 3<&"${fingers[0]}" 4>&"${fingers[1]}"
answered() { read -r -t 60 -u 3 || fail "no fingers: $(cat "$work/fingers.log")"; }
answered

# drive COMMAND: as tests/app/fingers.c reads them.
drive() {
    echo "$*" >&4
    answered
}
declare -A keyval=([ctrl]=0xffe3 [F11]=0xffc8 [Escape]=0xff1b [Return]=0xff0d [space]=0x20)
key() { # as xdotool names it
    local name command=key
    for name in ${1//+/ }; do command+=" ${keyval[$name]:-$(printf '%d' "'$name")}"; done
    drive "$command"
}
# The picture, as the app saves it; so the whole of it is what lib.sh looks at.
shoot() {
    local asked=0
    saved() {
        # A key that comes while a dialog still closes is lost: after half a minute it is asked again.
        ((++asked % 40)) || key ctrl+p
        key Return
        sleep 0.5
        convert pool.png "$1.ppm" 2>/dev/null
    }
    key ctrl+p
    sleep 1
    await 120 saved "$1" || { # fail() looks, too
        [[ $1 == failed ]] || fail "Ctrl+P saved no picture"
        return 1
    }
    rm pool.png
    read -r right bottom < <(identify -format '%w %h\n' "$1.ppm")
    left=0 top=0
}
# differ A B X0 Y0 X1 Y1: whether two pictures do in a part, in percent of it.
differ() {
    convert "$work/$1.ppm" "$work/$2.ppm" -compose difference -composite -crop \
        "$((right * ($5 - $3) / 100))x$((bottom * ($6 - $4) / 100))+$((right * $3 / 100))+$((bottom * $4 / 100))" \
        +repage -format '%[fx:mean>0.002]' info: | grep -q 1
}
# glide SLOT X0 Y0 X1 Y1...: fingers on straight ways, at the same time.
glide() {
    local step way
    for step in 1 2 3 4 5 6 7 8 9 10; do
        way=("$@")
        while ((${#way[@]})); do
            drive "move ${way[0]} $((way[1] + (way[3] - way[1]) * step / 10)) $((way[2] + (way[4] - way[2]) * step / 10))"
            way=("${way[@]:5}")
        done
        sleep 0.03
    done
}

"$build/skvalp-play" pool >"$work/app.log" 2>&1 &
app=$!
# Without a keyboard and a touch screen the app asks for none: the first press only makes it do so. It is
# there when it saves a picture.
key ctrl
there() {
    key ctrl+p
    sleep 1
    key Return
    sleep 1
    [[ -s pool.png ]]
}
await 120 there || fail "the app takes no keys"
sleep 2
key Escape # of the last two times it was asked the second may still stand open, and take all keys
sleep 1
rm pool.png
drive down 0 639 479
drive up 0
sleep 1
key space
fills_screen() {
    shoot first
    ((right > 500 && bottom > 400))
}
# A question that only now comes up takes the key; Escape ends it, and a full screen that is late.
full_screen() {
    key F11
    await 30 fills_screen && return
    key Escape
    sleep 2
    return 1
}
await 180 full_screen || fail "F11 gives no full screen: $right x $bottom"
rail=$((640 - right)) # the picture's left border on the screen
(($(share_of first fluid 15 60 80 78) > 90)) || fail "no water in the pool"

# 1. Two hands lift water, each its own.
key space
drive down 0 $((rail + 150)) 260
sleep 0.4
drive down 1 $((rail + 430)) 260
sleep 0.4
glide 0 $((rail + 150)) 260 $((rail + 150)) 130 1 $((rail + 430)) 260 $((rail + 430)) 130
sleep 1.5 # in slow motion the water follows slowly
key space
drive up 0
drive up 1
shoot lifted
(($(share_of lifted fluid 22 25 30 36) > 20)) || fail "the first finger lifted no water"
(($(share_of lifted fluid 70 25 79 36) > 20)) || fail "the second finger lifted no water"

# 2. Two together zoom about the air between the two lumps, so that no water shows; no wall is drawn.
key 2
drive "down 0 $((rail + 270)) 130; down 1 $((rail + 310)) 130"
glide 0 $((rail + 270)) 130 $((rail + 90)) 130 1 $((rail + 310)) 130 $((rail + 490)) 130
drive up 0
drive up 1
shoot near
(($(share_of near fluid 5 22 80 78) < 2)) || fail "two fingers did not zoom"
key ctrl+0
shoot again
! differ lifted again 2 22 80 78 || fail "the tool drew while two fingers zoomed"

# 3. One draws a wall, though nothing moves; a tap of three takes it back.
drive down 0 $((rail + 250)) 115
glide 0 $((rail + 250)) 115 $((rail + 340)) 115
drive up 0
shoot walled
differ again walled 45 24 57 30 || fail "a finger drew no wall"
tap=''
for finger in 0 1 2; do tap+="down $finger $((rail + 200 + 80 * finger)) 300; "; done
drive "${tap}up 0; up 1; up 2"
shoot undone
! differ again undone 2 22 80 78 || fail "a tap of three fingers did not undo"

key ctrl+q
await 60 gone || fail "Ctrl+Q did not quit"
wait "$app" || fail "the app ended with status $?"
app=''
if grep -E 'CRITICAL|WARNING|ERROR' "$work/app.log"; then fail "the toolkit complained"; fi
echo "touch: two hands lifted water, two fingers zoomed, one drew, three undid"
