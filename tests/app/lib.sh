# Shared by the app's tests: a display of its own, the app on it, and looks through its door. Sourced
# with `build` set. A test waits for what the app says of itself (door.py), and so long that a busy
# machine fails nothing; what it presses it finds by its name, and a point of a world by the camera.
# shellcheck shell=bash disable=SC2154

for program in Xvfb xdotool import convert python3; do
    command -v "$program" >/dev/null || {
        echo "$program is missing: install xvfb xdotool imagemagick python3"
        exit 1
    }
done

work=$(mktemp -d)
server='' app='' manager='' asker=''
# What does not end when it is asked to, is ended: a compositor was seen to spin for ever.
finish() {
    local one
    for one in $app $manager $server $asker; do
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
    if [[ -n ${SKVALP_KEEP:-} ]]; then # for a look
        shoot failed || true
        cp -r "$work" "$SKVALP_KEEP"
    fi
    exit 1
}

# The door, and who asks it.
export SKVALP_DOOR=$work/door GTK_A11Y=test
mkfifo "$work/asked" "$work/told"
python3 "$(dirname "${BASH_SOURCE[0]}")/door.py" "$SKVALP_DOOR" <"$work/asked" >"$work/told" 2>"$work/door.log" &
asker=$!
exec 7>"$work/asked" 8<"$work/told"

# ask SECONDS EXPRESSION: sets `answer`.
ask() {
    printf '%s %s %s\n' "${app:-0}" "$1" "$2" >&7
    read -r answer <&8 || fail "nobody asks the door: $(cat "$work/door.log")"
    [[ $answer == yes* ]] && answer=${answer#yes }
}
# await EXPRESSION [SECONDS]: a state of the app, in Python over what the door tells.
patience=${SKV_PATIENCE:-120}
await() {
    ask "${2:-$patience}" "$1" || fail "it did not come to $1 but is $answer"
}
# is EXPRESSION: at this moment.
is() { ask 0 "$1"; }

# start_display WIDTHxHEIGHT: of a number of this process's own, so that tests may run side by side. A key that a
# busy machine lets go late does not repeat.
start_display() {
    local number=$((100 + $$ % 50000)) told
    export GDK_BACKEND=x11 LIBGL_ALWAYS_SOFTWARE=1
    mkfifo "$work/number"
    Xvfb ":$number" -noreset -r -displayfd 3 -screen 0 "${1}x24" -nolisten tcp 3>"$work/number" >/dev/null 2>&1 &
    server=$!
    read -r -t 120 told <"$work/number" || told=''
    [[ $told == "$number" ]] || fail "Xvfb did not start on display $number"
    export DISPLAY=:$number
}
# A window manager without keys and buttons of its own.
start_manager() {
    command -v openbox >/dev/null || fail "openbox is missing: install openbox"
    printf '<openbox_config xmlns="http://openbox.org/3.4/rc"/>' >"$work/rc.xml"
    openbox --config-file "$work/rc.xml" >/dev/null 2>&1 &
    manager=$!
    repeat is_managed || fail "no window manager came up"
}
is_managed() { [[ $(xprop -root _NET_SUPPORTING_WM_CHECK) == *'window id'* ]]; }
# No settings, languages and services of the machine that runs the test.
export GSETTINGS_BACKEND=memory HOME=$work DBUS_SESSION_BUS_ADDRESS=disabled:
export LC_ALL=C.UTF-8 LANGUAGE=en
# The toolkit draws its own widgets without OpenGL, which a processor does with half the work. Water is drawn
# as ever, and test_app and test_app_views take the renderer that people have.
export GSK_RENDERER=${GSK_RENDERER-cairo}
unset WAYLAND_DISPLAY GTK_THEME ADW_DEBUG_COLOR_SCHEME ADW_DEBUG_HIGH_CONTRAST
unset XDG_CONFIG_HOME XDG_DATA_HOME XDG_CACHE_HOME XDG_STATE_HOME

# window_size WIDTH HEIGHT [PARTICLES]: of the windows to come, and with how many particles scenes begin in
# them. Drawn by the processor, pixels and particles cost more than anything else here, so they are few where
# a test does not say otherwise; 0 particles are the number that people get.
window_size() {
    mkdir -p "$work/.config/skvalp"
    printf '[play]\nwidth=%d\nheight=%d\nparticles=%d\n' "$1" "$2" "${3-1000}" >"$work/.config/skvalp/play.ini"
}
window_size 640 420

# repeat COMMAND...: until it succeeds, of what no door tells.
repeat() {
    local end=$((SECONDS + 120))
    until "$@"; do
        ((SECONDS < end)) || return 1
        sleep 0.05
    done
}

running() { kill -0 "$app" 2>/dev/null; }
key() { xdotool key "$@"; }
# gives_input XID: whether the server has given the window its input. It refuses one that does not show yet, as
# one that a window manager is just taking in.
gives_input() { xdotool windowfocus "$1" 2>/dev/null && [[ $(xdotool getwindowfocus -f) == "$1" ]]; }
# focus: input goes to the app's window, or to the one that is over it, and the app and the window manager say
# so, who gives it to a new window, too, sooner or later, which would close a menu.
focus() { repeat has_focus || fail "the window on top gets no input: $answer"; }
has_focus() {
    local xid
    await 'windows[-1].xid'
    xid=$answer
    gives_input "$xid" && ask 2 "windows[-1].xid == $xid and windows[-1].focus" || return 1
    [[ -z $manager ]] || is_active "$xid"
}
is_active() { [[ $(xprop -root _NET_ACTIVE_WINDOW) == *"# $(printf '0x%x' "$1")" ]]; }

# launch ARGUMENT...: asks for nothing; start_app: until a picture of its world is drawn, and keys come in.
launch() {
    "$build/skvalp-play-tested" "$@" >"$work/app.log" 2>&1 &
    app=$!
}
start_app() {
    launch "$@"
    await 'worlds[0].opened and windows[0].frames'
    focus
}

# compare: a second world beside the first. Both start again, and what comes before they are where the first was
# lies in their past.
compare() {
    key c
    await 'len(worlds) == 2 and not seeking and moment == end and worlds[0].time == worlds[1].time'
}

# ended: waits for the app, which has to end well; and, unless loudly, to have said nothing bad.
ended_loudly() {
    local status=0
    timeout 120 tail --pid="$app" -s 0.05 -f /dev/null || fail "the app does not end"
    wait "$app" || status=$?
    app=''
    ((status == 0)) || fail "the app ended with status $status"
}
ended() {
    ended_loudly
    ! grep -E 'CRITICAL|WARNING|ERROR' "$work/app.log" || fail "the toolkit complained"
}
quit_app() {
    key ctrl+q
    ended
}

# go EXPRESSION: the pointer to a place that find, middle or at tells; click: and clicks there; press: on a button.
go() {
    local xid x y
    spend_press
    await "$1"
    read -r xid x y <<<"$answer"
    xdotool mousemove --window "$xid" "$x" "$y"
}
# On X11 GTK 4.8 may lose the first press after something was chosen in a menu, on a busy machine in three of four
# times: the ground of the header gets it.
chosen=''
spend_press() {
    local xid x y
    [[ -n $chosen ]] && is 'len(windows) == 1 and menus() == 0 and middle("header", x=0.3)' || return 0
    chosen=''
    await 'middle("header", x=0.3)'
    read -r xid x y <<<"$answer"
    xdotool mousemove --window "$xid" "$x" "$y" click 1
}
point() { go "at($1, $2, ${3:-0})"; }
# A button's press may be lost without a menu before it, too, seldom: it comes again where the app has read it from
# the server, has had two frames since, and no button has clicked. What is chosen in a menu closes it by then.
press() {
    local clicks presses menu=1
    is 'menus()' || menu=''
    go "still(middle('$1', '${2:-}'))"
    await '(clicks, presses)'
    read -r clicks presses <<<"$answer"
    xdotool click 1
    if [[ -n $menu ]]; then
        await "still(presses) > $presses"
        chosen=1
    else
        await "clicks != $clicks or still(presses) > $presses"
        is "clicks != $clicks" || xdotool click 1
    fi
}
click() {
    go "still(middle('$1', '${2:-}'))"
    xdotool click 1
}
# hold EXPRESSION: the mouse with its button down, at a place that stays.
hold() {
    go "still($1)"
    xdotool mousedown 1
}
# drag X0 Y0 X1 Y1...: and along points of the first world.
drag() {
    hold "at($1, $2)"
    shift 2
    while (($# > 0)); do
        point "$1" "$2"
        shift 2
    done
}
# tab_to NAME: moves the focus until it is on what begins with this name.
tab_to() {
    local before
    await 'focused()'
    until is "focused().startswith('$1')"; do
        await 'focused()'
        before=$answer
        key Tab
        await "focused() != '$before'"
    done
}
let_go() { xdotool mouseup 1; }

shoot() { import -silent -window root "$work/$1.ppm"; }
