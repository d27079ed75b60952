#!/usr/bin/env bash
# Every line of the table of keys (src/session/keys.c), pressed: what it says happens. Gestures of
# fingers are in test_app_touch.sh. Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_app_keys.sh BUILD SOURCE}")
source=$(realpath "${2:?usage: test_app_keys.sh BUILD SOURCE}")
# shellcheck source=tests/app/lib.sh
source "$(dirname "$0")/lib.sh"
start_display 1000x800
start_manager
window_size 640 640
start_app pool
await 'moment > 5'

# does KEY EXPRESSION: the key as the table writes it.
declare -A pressed=()
does() {
    local sign=${1##*+}
    local -A signs=(['.']=period [',']=comma ['-']=minus ['=']=equal ['[']=bracketleft [']']=bracketright
        ['?']=question [_]=plus [Space]=space)
    local before=${1%"${sign:-+}"}
    before=${before%+}
    before=${before//Ctrl/ctrl}
    before=${before//Shift/shift}
    key "${before:+$before+}${signs[${sign:-_}]-$sign}"
    await "$2"
    pressed[$1]=1
}
dialog_of() { # KEY TITLE
    does "$1" "dialog() == '$2'"
    focus
    key Escape
    await 'not dialog()'
    focus
}

# Playback.
does Space paused
does Space 'not paused'
does Space paused
await moment
at=$answer
does . "moment == $at + 1"
does s "moment == $at + 2"
does , "moment == $at + 1 and end == $at + 2"
does Shift+Left "moment == max(0, $at + 1 - 60)" # a second; a busy machine came farther before it paused
does Shift+Right "moment == min(end, max(0, $at + 1 - 60) + 60)"
does r 'moment == 0'
does - 'speed == 0.5'
does + 'speed == 1'
does '=' 'speed == 2'
key minus
await 'speed == 1'
key 2
await 'tool == 1'
drag 62 77 78 77
let_go
await canUndo
does Ctrl+z canRedo
does Ctrl+Shift+z 'not canRedo'
key ctrl+z
await canRedo
does Ctrl+y 'not canRedo'
does w 'shows("Lap")'
does l 'says("(1: ")'
key w
await 'not shows("Lap")'

# Tools.
await brush
old=$answer
does '[' "brush < 0.9 * $old"
does ']' "brush > 0.95 * $old"
does n 'fluid == 0 and not shows("oil")' # test_app_fluids.sh has more of it
does m 'len(worlds[0].probes) == 1'
for one in 8 7 6 5 4 3 2 1; do
    key "$one"
    await "tool == $one - 1"
done
does k 'says("Arrow keys move the hand")'
key space
await 'not paused'
does Return 'worlds[0].hands == 1'
key Return
await 'worlds[0].hands == 0'
key k

# Gravity.
does Left 'gravity.x == -1 and gravity.y == 0'
does Right 'gravity.x == 1 and gravity.y == 0'
does Up 'gravity.x == 0 and gravity.y == 1'
does Down 'gravity.x == 0 and gravity.y == -1'
does 0 'gravity.x == 0 and gravity.y == 0'

# The view. Ctrl and the wheel zoom about the pointer: what lies under it stays there.
does v 'style.view == "pressure"'
does t '"tracers" in style.overlays'
does Ctrl++ 'abs(worlds[0].camera.zoom - 1.25) < 1e-6'
does Ctrl+- 'worlds[0].camera.zoom == 1'
does Ctrl+= 'abs(worlds[0].camera.zoom - 1.25) < 1e-6'
does Ctrl+0 'worlds[0].camera.zoom == 1'
go 'still(at(30, 40))'
await 'at(30, 40)[1]' # there is room above: only across the picture is longer than the view
under=$answer
xdotool keydown ctrl click 4 click 4 keyup ctrl
await 'worlds[0].camera.zoom > 1.3'
is "abs(at(30, 40)[1] - $under) <= 1" || fail "the zoom is about another point: $answer, $under"
xdotool keydown ctrl click 5 click 5 keyup ctrl
await 'worlds[0].camera.zoom == 1'
pressed['Wheel with Ctrl']=1
does F11 'windows[0].fullscreen'
key F11
await 'not windows[0].fullscreen'
does f 'windows[0].fullscreen'
key f
await 'not windows[0].fullscreen'
does g 'page == "scenes"'
does Escape 'page == "play"'
does p 'find("Properties", "Toggle").active'
key p
await 'not find("Properties", "Toggle").active'

# Files, links, worlds.
dialog_of Ctrl+o 'Open a Scene or a Picture'
dialog_of Ctrl+s 'Save What Happened'
dialog_of Ctrl+p 'Save a Picture'
if command -v ffmpeg >/dev/null; then
    dialog_of Ctrl+r 'Save the Last 10 Seconds'
else
    does Ctrl+r '"ffmpeg" in message'
fi
does Ctrl+Shift+c 'says("The link was copied")'
does Ctrl+v 'worlds[0].opened == 2'
does c 'len(worlds) == 2'
key c
await 'len(worlds) == 1'

# The table itself: every line of it.
titles=$(grep -oP '^    \{[A-Z]+, \K"[^"]*"' "$source/src/session/keys.c" | sort -u | paste -sd,)
for one in '?' 'Ctrl+?'; do
    does "$one" 'dialog() == "Keyboard Shortcuts"'
    await "[] == [one for one in ($titles) if not shows(one)]" # no line is missing
    focus
    key Escape
    await 'len(windows) == 1'
    focus
done
key ctrl+w
ended
start_app pool
quit_app
pressed[Ctrl+w]=1 pressed[Ctrl+q]=1

missing=0
while IFS= read -r one; do
    [[ -n ${pressed[$one]-} ]] && continue
    echo "no test presses $one"
    missing=1
done < <(grep -oP '^    \{[A-Z]+, (NULL|"[^"]*"), "\K[^"]+' "$source/src/session/keys.c" |
    grep -vE 'finger|One|Two')
((missing == 0)) || exit 1
echo "keys: all of the table do what it says"
