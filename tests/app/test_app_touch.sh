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
repeat listens || fail "the compositor did not start: $(tail -n 3 "$work/mutter.log")"
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
# place EXPRESSION: sets x and y; the window fills the screen.
place() {
    await "$1"
    read -r _ x y <<<"$answer"
}
# touch SLOT X Y: a finger comes down at a point of the world.
touch() {
    place "at($2, $3)"
    drive down "$1" "$x" "$y"
}
# glide SLOT X0 Y0 X1 Y1...: fingers on straight ways, at the same time, in percent of the world.
glide() {
    local step i line ways=()
    while (($# > 0)); do
        ways+=("$1")
        for i in 2 4; do
            place "at(${*:i:1}, ${*:i+1:1})"
            ways+=("$x" "$y")
        done
        shift 5
    done
    for step in 1 2 3 4 5 6 7 8 9 10; do
        line=''
        for ((i = 0; i < ${#ways[@]}; i += 5)); do
            x=$((ways[i + 1] + (ways[i + 3] - ways[i + 1]) * step / 10))
            y=$((ways[i + 2] + (ways[i + 4] - ways[i + 2]) * step / 10))
            line+="${line:+; }move ${ways[i]} $x $y"
        done
        drive "$line"
        [[ -z ${follows:-} ]] || await_frames 6
    done
}
# await_frames COUNT: of the world's time.
await_frames() {
    await moment
    await "moment >= $answer + $1"
}

"$build/skvalp-play-tested" pool >"$work/app.log" 2>&1 &
app=$!
await 'worlds[0].opened and windows[0].frames'
# Without a keyboard and a touch screen the app asks for none: the first press only makes it do so.
awake() {
    key F11
    ask 20 'windows[0].fullscreen and windows[0].width == 640 and windows[0].height == 480'
}
repeat awake || fail "F11 gives no full screen: $answer"
touched() {
    drive down 0 639 479
    drive up 0
    touch 0 50 25
    local felt=0
    ask 20 'worlds[0].hands == 1' || felt=1
    drive up 0
    return $felt
}
repeat touched || fail "the app feels no finger: $answer"
await 'worlds[0].hands == 0 and not paused'

# 1. Two hands lift water, each its own.
touch 0 25 30
await 'worlds[0].hands == 1'
touch 1 75 30
await 'worlds[0].hands == 2'
follows=1 glide 0 25 30 25 70 1 75 30 75 70
await 'water(15, 60, 35, 80) > 20 and water(65, 60, 85, 80) > 20 and water(45, 60, 55, 80) == 0'
drive "up 0; up 1"
await 'worlds[0].hands == 0'
key space
await 'paused and worlds[0].camera.zoom == 1'

# 2. Two together zoom; no wall is drawn.
key 2
await 'tool == 1'
# zooms: whether they did; to a compositor that is held up between the two they come one after the other.
zooms() {
    place 'at(45, 70)'
    line="down 0 $x $y"
    place 'at(55, 70)'
    drive "$line; down 1 $x $y"
    glide 0 45 70 25 70 1 55 70 75 70
    drive "up 0; up 1"
    ask 20 'worlds[0].camera.zoom > 1.5 or canUndo'
    is canUndo || return 0
    key ctrl+z
    await 'not canUndo'
    return 1
}
repeat zooms || fail "two fingers draw: $answer"
await 'worlds[0].camera.zoom > 1.5'
key ctrl+0
await 'worlds[0].camera.zoom == 1 and not any(worlds[0].walls) and not canUndo'

# 3. One draws a wall, though nothing moves; a tap of three takes it back.
touch 0 42 77
glide 0 42 77 58 77
drive up 0
await "sum(cells('walls', 40, 75, 60, 80)) > 1"
undoes() { # again, if a compositor that is held up makes a long touch of the tap
    local line='' finger
    for finger in 0 1 2; do
        place "at($((30 + 20 * finger)), 30)"
        line+="down $finger $x $y; "
    done
    drive "${line}up 0; up 1; up 2"
    ask 20 'not any(worlds[0].walls)'
}
repeat undoes || fail "three fingers undo nothing: $answer"

quit_app
echo "touch: two hands lifted water, two fingers zoomed, one drew, three undid"
