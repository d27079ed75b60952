#!/usr/bin/env bash
# The app as a person meets it: on a display of its own, by mouse and keys, judged by the colours on
# the screen. Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_app.sh BUILD SOURCE}")

for program in Xvfb xdotool import convert; do
    command -v "$program" >/dev/null || {
        echo "$program is missing: install xvfb xdotool imagemagick"
        exit 1
    }
done

work=$(mktemp -d)
server='' app=''
finish() {
    [[ -z $app ]] || kill "$app" 2>/dev/null || true
    [[ -z $server ]] || kill "$server" 2>/dev/null || true
    wait
    rm -rf "$work"
}
trap finish EXIT

fail() {
    echo "FAILED: $*"
    [[ ! -s $work/app.log ]] || sed 's/^/app: /' "$work/app.log"
    [[ -z ${SKVALP_KEEP:-} ]] || cp -r "$work" "$SKVALP_KEEP" # screenshots, for a look
    exit 1
}

# A display number that nobody uses: the server picks it.
mkfifo "$work/number"
Xvfb -displayfd 3 -screen 0 1280x800x24 -nolisten tcp 3>"$work/number" >/dev/null 2>&1 &
server=$!
read -r -t 20 number <"$work/number" || fail "Xvfb did not start"
export DISPLAY=:$number GDK_BACKEND=x11 LIBGL_ALWAYS_SOFTWARE=1
# No settings and no services of the machine that runs the test.
export GSETTINGS_BACKEND=memory GTK_A11Y=none HOME=$work DBUS_SESSION_BUS_ADDRESS=disabled:
unset WAYLAND_DISPLAY GTK_THEME ADW_DEBUG_COLOR_SCHEME

# Waits up to $1 seconds for the rest of the arguments to succeed.
await() {
    local end=$((SECONDS + $1))
    shift
    until "$@"; do
        ((SECONDS < end)) || return 1
        sleep 0.1
    done
}

window=''
find_window() {
    window=$(xdotool search --onlyvisible --name Skvalp 2>/dev/null | head -n 1)
    [[ -n $window ]]
}

start_app() {
    "$build/skvalp-play" "$@" >"$work/app.log" 2>&1 &
    app=$!
    await 60 find_window || fail "no window came up"
    xdotool windowfocus "$window"
    eval "$(xdotool getwindowgeometry --shell "$window")" # X Y WIDTH HEIGHT
}

running() { kill -0 "$app" 2>/dev/null; }
gone() { ! running; }
key() { xdotool key "$@"; }
# The pointer to a place in the window, in percent.
point() { xdotool mousemove $((X + WIDTH * $1 / 100)) $((Y + HEIGHT * $2 / 100)); }
shoot() { import -silent -window root "$work/$1.ppm"; }

# The share, in percent, of a part of the window (x0 y0 x1 y1 in percent) whose colour is $1 now.
share() {
    local color=$1 test
    case $color in
    fluid) test='b > 0.7 && b > g + 0.2' ;;
    white) test='r > 0.9 && g > 0.9 && b > 0.9' ;;
    red) test='r > 0.6 && g < 0.3 && b < 0.35' ;;
    esac
    shoot now
    convert "$work/now.ppm" -crop "$((WIDTH * ($4 - $2) / 100))x$((HEIGHT * ($5 - $3) / 100))+$((
        X + WIDTH * $2 / 100))+$((Y + HEIGHT * $3 / 100))" +repage -sample '60x60!' \
        -fx "$test" -format '%[fx:round(100*mean)]' info:
}
more() { (($(share "${@:2}") > $1)); } # than $1 percent
less() { (($(share "${@:2}") < $1)); }

picture_changes() {
    shoot one
    sleep 0.3
    shoot two
    ! cmp -s "$work/one.ppm" "$work/two.ppm"
}
picture_stands() { ! picture_changes; }

# Processor time in ticks (1/100 s) that the app has used.
ticks() { awk '{ print $14 + $15 }' "/proc/$app/stat"; }

# 1. A pool: fluid in the lower half, none above it.
start_app pool
await 60 more 98 fluid 15 65 85 95 || fail "no fluid in the lower half of the pool"
less 1 fluid 15 25 85 45 || fail "fluid above the pool"
point 30 85

# 2. The mouse lifts a chunk out of it, and lets it go. Fluid can't follow a hand faster than the
# machine draws, so a busy one gets a slower hand.
lift() { # SECONDS a move
    local y
    point 50 65
    xdotool mousedown 1
    for y in 60 55 50 45 42 40 38 36 35; do
        point 50 "$y"
        sleep "$1"
    done
    await 3 more 8 fluid 42 25 58 45 && return
    xdotool mouseup 1
    return 1
}
lift 0.05 || lift 0.2 || lift 0.6 || fail "the mouse did not lift any fluid"
xdotool mouseup 1
await 60 less 2 fluid 42 25 58 45 || fail "the fluid did not fall back"

# 3. Pause stands still and costs nothing; one step is a change; reset is the start.
key space
await 60 picture_stands || fail "Space did not pause"
before=$(ticks)
sleep 3
(($(ticks) - before <= 1)) || fail "paused, the app kept working"
shoot paused
key s
sleep 0.5
shoot stepped
! cmp -s "$work/paused.ppm" "$work/stepped.ppm" || fail "S did not step"
key r
await 60 less 1 fluid 15 25 85 45 || fail "R did not reset"

# 4. Tracers, while paused.
less 1 white 15 65 85 95 || fail "white before tracers were asked for"
key t
await 60 more 1 white 15 65 85 95 || fail "T shows no tracers"
key t

# 5. Gravity by the arrow keys.
key space
key Right
await 60 more 60 fluid 80 20 95 45 || fail "with gravity to the right the fluid stays left"
key Down

# 6. The open dialog: a bad file is refused and the pool goes on, a painted picture is shown.
dialog=''
find_dialog() {
    dialog=$(xdotool search --onlyvisible --name 'Open a Scene' 2>/dev/null | head -n 1)
    [[ -n $dialog ]]
}
no_dialog() { ! find_dialog; }
open_by_dialog() {
    xdotool windowfocus "$window"
    key ctrl+o
    await 60 find_dialog || fail "Ctrl+O shows no dialog"
    sleep 0.5
    xdotool windowfocus "$dialog"
    xdotool type --delay 20 "$1"
    sleep 0.5
    key Return
    await 60 no_dialog || fail "the dialog stays open"
    xdotool windowfocus "$window"
}
printf '{"fluid": {"spacing": "wide"}}' >"$work/broken.json"
open_by_dialog "$work/broken.json"
await 60 more 10 red 35 10 65 16 || fail "no message about a broken file"
await 60 picture_changes || fail "the running scene stopped at a broken file"
await 60 more 90 fluid 15 75 85 95 || fail "the running scene was lost to a broken file"
convert -size 160x90 xc:black -fill white -draw 'rectangle 0,86 160,90' \
    -fill '#0000ff' -draw 'rectangle 5,50 60,80' "PNG24:$work/painted.png"
# Paused, so that the water is still where it was painted when a busy machine comes to look.
key space
open_by_dialog "$work/painted.png"
await 60 less 5 fluid 75 20 95 60 || fail "fluid where none was painted"
await 60 more 60 fluid 8 62 30 85 || fail "no fluid where it was painted"
await 60 less 1 red 35 10 65 16 || fail "the message stayed although something was opened"

key ctrl+q
await 60 gone || fail "Ctrl+Q did not quit"
wait "$app" || fail "the app ended with status $?"
app=''
if grep -E 'CRITICAL|ERROR' "$work/app.log"; then fail "the toolkit complained"; fi

# 7. A bad file on the command line: the window says so, and the default scene runs.
start_app "$work/broken.json"
await 60 more 10 red 35 10 65 16 || fail "no message about a broken file"
await 60 more 5 fluid 2 20 98 98 || fail "no default scene beside the message"
await 60 picture_changes || fail "the default scene does not run"
key Escape
await 60 less 1 red 35 10 65 16 || fail "the message did not go away"
running || fail "the app died"
echo "app: a pool was lifted, paused, stepped, reset, tilted; broken files were refused"
