# Shared by the app's tests: a display of its own, the app on it, and looks at the screen. Sourced
# with `build` set. Waits are many times what is needed, so that a busy machine fails nothing.
# shellcheck shell=bash disable=SC2154

for program in Xvfb xdotool import convert; do
    command -v "$program" >/dev/null || {
        echo "$program is missing: install xvfb xdotool imagemagick"
        exit 1
    }
done

work=$(mktemp -d)
server='' app='' manager=''
# What does not end when it is asked to, is ended: a compositor was seen to spin for ever.
finish() {
    local one
    for one in $app $manager $server; do
        kill "$one" 2>/dev/null || continue
        timeout 10 tail --pid="$one" -s 0.1 -f /dev/null || kill -KILL "$one" 2>/dev/null || true
    done
    wait
    rm -rf "$work"
}
trap finish EXIT

fail() {
    echo "FAILED: $*"
    [[ ! -s $work/app.log ]] || sed 's/^/app: /' "$work/app.log"
    if [[ -n ${SKVALP_KEEP:-} ]]; then # screenshots, for a look
        shoot failed || true
        cp -r "$work" "$SKVALP_KEEP"
    fi
    exit 1
}

stop_display() {
    [[ -n $server ]] || return 0
    kill "$server" 2>/dev/null || true
    wait "$server" 2>/dev/null || true
    server=''
}

# start_display WIDTHxHEIGHT: a display number that nobody uses: the server picks it. A server that
# ends frees its number before it removes its socket, which may be the next one's by then: so a
# server that cannot be reached is left for another.
start_display() {
    local number try
    export GDK_BACKEND=x11 LIBGL_ALWAYS_SOFTWARE=1
    for try in 1 2 3 4 5; do
        stop_display
        rm -f "$work/number"
        mkfifo "$work/number"
        Xvfb -noreset -displayfd 3 -screen 0 "${1}x24" -nolisten tcp 3>"$work/number" >/dev/null 2>&1 &
        server=$!
        read -r -t 60 number <"$work/number" || fail "Xvfb did not start"
        export DISPLAY=:$number
        sleep 0.2 # what is about to be removed is gone then
        ! timeout 60 xdotool getdisplaygeometry >/dev/null 2>&1 || return 0
        echo "display $DISPLAY does not answer (try $try)"
    done
    fail "no display answers"
}
# No settings, languages and services of the machine that runs the test.
export GSETTINGS_BACKEND=memory GTK_A11Y=none HOME=$work DBUS_SESSION_BUS_ADDRESS=disabled:
export LC_ALL=C.UTF-8 LANGUAGE=en
unset WAYLAND_DISPLAY GTK_THEME ADW_DEBUG_COLOR_SCHEME ADW_DEBUG_HIGH_CONTRAST
unset XDG_CONFIG_HOME XDG_DATA_HOME XDG_CACHE_HOME

# window_size WIDTH HEIGHT: of the windows to come. Drawn by the processor, a pixel costs as much as
# anything here, so it is small where a test does not say otherwise.
window_size() {
    mkdir -p "$work/.config/skvalp"
    printf '[play]\nwidth=%d\nheight=%d\n' "$@" >"$work/.config/skvalp/play.ini"
}
window_size 840 560

# await SECONDS COMMAND...: waits until it succeeds.
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
# Nobody waits for the window of an app that has ended.
window_or_gone() { find_window || gone; }

# place: where the window and the picture in it are; the picture is what the rail (or the tools
# below), the header and the transport leave.
place() {
    eval "$(xdotool getwindowgeometry --shell "$window")" # X Y WIDTH HEIGHT
    left=$((X + 72)) top=$((Y + 54)) right=$((X + WIDTH - 6)) bottom=$((Y + HEIGHT - 64))
}

start_app() {
    "$build/skvalp-play" "$@" >"$work/app.log" 2>&1 &
    app=$!
    await 120 window_or_gone || fail "no window came up"
    running || fail "the app ended before its window came up"
    xdotool windowfocus "$window"
    place
}

running() { kill -0 "$app" 2>/dev/null; }
gone() { ! running; }
key() { xdotool key "$@"; }

# quit_app: by its key; it has to end well and to have said nothing bad.
quit_app() {
    key ctrl+q
    await 120 gone || fail "Ctrl+Q did not quit"
    wait "$app" || fail "the app ended with status $?"
    app=''
    if grep -E 'CRITICAL|WARNING|ERROR' "$work/app.log"; then fail "the toolkit complained"; fi
}

# quit_app_behind KEY: in spite of what this key opens.
quit_app_behind() {
    key "$1"
    sleep 1
    quit_app
}

# point X Y: the pointer to a place of the picture, in percent.
point() {
    xdotool mousemove $((left + (right - left) * $1 / 100)) $((top + (bottom - top) * $2 / 100))
}
shoot() { import -silent -window root "$work/$1.ppm"; }

# share_of SHOT COLOR X0 Y0 X1 Y1: how many percent of a part of the picture have that colour. Beyond
# 0 and 100 lies what is around it.
share_of() {
    local shot=$work/$1.ppm color=$2 test
    shift
    case $color in
    fluid) test='b > 0.6 && b > r + 0.25' ;;
    white) test='r > 0.97 && g > 0.97 && b > 0.97' ;;
    red) test='r > 0.6 && g < 0.3 && b < 0.35' ;;
    dark) test='r < 0.25 && g < 0.25 && b < 0.3' ;;
    wall) test='abs(r-g) < 0.12 && abs(g-b) < 0.12 && r > 0.2 && r < 0.62' ;;
    yellow) test='r > 0.75 && g > 0.6 && b < 0.5' ;;
    esac
    convert "$shot" -crop "$(((right - left) * ($4 - $2) / 100))x$(((bottom - top) * ($5 - $3) / 100))+$((
        left + (right - left) * $2 / 100))+$((top + (bottom - top) * $3 / 100))" +repage \
        -sample '60x60!' -fx "$test" -format '%[fx:round(100*mean)]' info:
}
share() { # now
    shoot now
    share_of now "$@"
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
