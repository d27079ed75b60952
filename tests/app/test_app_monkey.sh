#!/usr/bin/env bash
# A monkey at the app: random keys, clicks, drags, menus, sizes, properties, experiments, files that
# can be opened and files that cannot; it must not crash, hang, leak or complain. A short while, or
# two minutes with SKV_LONG_TESTS=1; SKV_MONKEY_SECONDS and SKV_MONKEY_SEED choose both.
# scripts/monkey.sh runs it for longer, with the address sanitizer, and by the toolkit's dialogs of
# files, over which GTK 4.8 may fall: only a sanitizer's stack tells whose fault that is. Here files are
# opened by starting with them. Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_app_monkey.sh BUILD SOURCE}")
source=$(realpath "${2:?usage: test_app_monkey.sh BUILD SOURCE}")
# shellcheck source=tests/app/lib.sh
source "$(dirname "$0")/lib.sh"
seconds=${SKV_MONKEY_SECONDS:-15}
[[ ${SKV_LONG_TESTS:-} != 1 || -n ${SKV_MONKEY_SECONDS:-} ]] || seconds=120
seed=${SKV_MONKEY_SEED:-1}
echo "monkey: seed $seed, $seconds s"
RANDOM=$seed

# Toolkit, fonts and drivers keep memory until the end; a leak counts if a function of ours but main
# asked for it.
export LSAN_OPTIONS=exitcode=0 G_SLICE=always-malloc
our_leaks() {
    awk -v RS= '/leak of/ { whole = $0; gsub(/[^ ]*app\/main\.c/, ""); if (/\/(app|src)\/[a-z_\/]*\.c:/) print whole }' \
        "$work/app.log"
}
export TMPDIR=$work/temporary
mkdir -p "$TMPDIR" "$work/files"
for kind in json png replay snapshot; do
    cp "$source/tests/fuzz/corpus/$kind/"* "$work/files/"
done
cp "$source"/scenes/*.json "$work/files/"
head -c 5000 /dev/urandom >"$work/files/noise.skvr"
head -c 5000 /dev/urandom >"$work/files/noise.png"
printf '{"world": {"width": 1e30}' >"$work/files/broken.json"
for ending in png json skv skvr; do # cut short
    for file in "$work/files"/*."$ending"; do
        head -c $(($(wc -c <"$file") / 2)) "$file" >"$work/files/half.$ending"
        break
    done
done
: >"$work/files/empty.skv"
files=("$work/files"/*)
cd "$work" # where it saves what it names itself

start_display 1280x800
start_manager

keys=(space s r z period comma minus plus 0 t v v g p k m bracketleft bracketright Escape Escape 1 2 3
    4 5 6 7 8 Left Right Up Down Return Tab Tab Delete F10 ctrl+z ctrl+z ctrl+shift+z shift+Left
    shift+Left shift+Right ctrl+plus ctrl+minus ctrl+0 F11 shift+Tab BackSpace
    ctrl+question alt+F10 ctrl+c)
values=(0 1 -9.81 1e9 0.001 nan -1 1e-30 '12,5' true text '')

any() { # WORD...: one of them
    shift $((RANDOM % $#))
    printf '%s' "$1"
}
spot() { printf 'mousemove --window %d %d %d' "$window" $((2 + RANDOM % width)) $((2 + RANDOM % height)); }

# One thing that somebody may do, as lines of commands of xdotool: between them the app has its turn.
act() {
    local kind=$((RANDOM % 100)) button=1
    ((RANDOM % 5 != 0)) || button=$((1 + RANDOM % 3))
    if ((kind < 30)); then
        echo "key $(any "${keys[@]}")"
    elif ((kind < 50)); then
        echo "$(spot) click $button"
    elif ((kind < 75)); then
        echo "$(spot) mousedown $button"
        for _ in 1 2 3; do spot && echo; done
        ((RANDOM % 10 == 0)) || echo "mouseup $button"
    elif ((kind < 80)); then
        echo "$(spot) click $((4 + RANDOM % 2))"
    elif ((kind < 84)); then
        echo "windowsize $window $((340 + RANDOM % 940)) $((300 + RANDOM % 500))"
    elif ((kind < 88)); then
        echo "key F10"
        for ((i = RANDOM % 12; i > 0; i--)); do echo "key Down"; done
        echo "key Return"
    elif ((kind < 92)); then # a field, perhaps
        echo "$(spot) click 1"
        echo "key ctrl+a type --delay 2 \"$(any "${values[@]}")\""
        echo "key Return"
    elif [[ $kind -lt 99 && ${SKV_MONKEY_DIALOGS:-} != 1 ]]; then
        printf '%s\n' "windowfocus $window" "key Escape" "key Escape" "key ctrl+q"
    elif ((kind < 97)); then
        printf '%s\n' "key Escape" "key ctrl+o" "key ctrl+a type --delay 2 \"$(any "${files[@]}")\"" "key Return"
    elif ((kind < 99)); then
        printf '%s\n' "key Escape" "key ctrl+s" \
            "key ctrl+a type --delay 2 \"$work/saved-$((RANDOM % 3)).skv\"" "key Return"
    else
        printf '%s\n' "key g" "$(spot) click 1" "$(spot) click 1"
    fi
}

# gone_well: after the app has ended: in order, without a word of the sanitizers or the toolkit.
gone_well() {
    wait "$app" || fail "seed $seed: the app ended with status $? after $acts acts"
    app=''
    # Popovers of GTK 4.8 ask for the monitor of a window that is on none, and of what is gone; its
    # dialog of files compares a place that it has not found yet, and sorts a list that has gone.
    if grep -E 'CRITICAL|ERROR: Address|runtime error' "$work/app.log" |
        grep -vE 'gdk_monitor_get_geometry|gtk_widget_compute_bounds|g_file_equal: assertion|gtk_tree_sortable_'; then
        fail "seed $seed: the app complained after $acts acts"
    fi
    [[ -z $(our_leaks) ]] || fail "seed $seed: memory was lost after $acts acts"
}

# toolkit_fell: a fault of GTK 4.8's dialog of files when one types while it reads a folder; there is no
# function of ours in its stack but main.
falls=0
toolkit_fell() {
    grep -q '#0 .* in g_file_equal' "$work/app.log" || return 1
    falls=$((falls + 1))
}

# leave_files: the toolkit's dialogs of files are used by the acts that name a file and then closed:
# GTK 4.8 falls over its own when its list is clicked while it goes (gtk_widget_compute_bounds called
# by a timeout of the dialog's).
leave_files() {
    local one
    for one in $(xdotool search --onlyvisible --name '^(Open|Save) ' 2>/dev/null || true); do
        xdotool windowfocus "$one" key Escape 2>/dev/null || true
    done
}

# An app that answers has not hung, and has taken what went before.
answers() { ask 120 'windows[0].xid, windows[0].width, windows[0].height' && read -r window width height <<<"$answer"; }

acts=0 starts=1 caught=''
start_app pool
end=$((SECONDS + seconds))
while ((SECONDS < end)); do
    if ! answers; then # it may have found the way out
        [[ $answer == *'has ended' ]] || break
        if toolkit_fell; then
            app=''
        else
            gone_well
        fi
        starts=$((starts + 1))
        start_app "$(any "${files[@]}" pool dam-break)"
        continue
    fi
    act >"$work/script" # in this shell, whose random numbers go on
    mapfile -t script <"$work/script"
    acts=$((acts + 1))
    for line in "${script[@]}"; do
        [[ -z ${SKV_MONKEY_TRACE:-} ]] || echo "$line" >>"$SKV_MONKEY_TRACE"
        timeout 60 xdotool - <<<"$line" >/dev/null 2>&1 || true
        answers || break
    done
    leave_files
done
xdotool mouseup 1 mouseup 2 mouseup 3
if answers; then
    quits() { # GTK 4.8 complains of a dialog of files that goes while it reads a folder
        local one
        for one in $(xdotool search --onlyvisible --name '.+' 2>/dev/null || true); do
            xdotool windowfocus "$one" key Escape 2>/dev/null || true
            answers || return 0
        done
        xdotool windowfocus "$window" key ctrl+q 2>/dev/null || true
        ! answers
    }
    repeat quits || true
fi
# GTK 4.8 may be caught in a loop of its own over a key, with no function of ours in it.
if [[ $answer != *'has ended' ]]; then
    caught=', which was caught in a loop'
    kill "$app"
    wait "$app" || true
    app=''
fi
[[ -z $app ]] || toolkit_fell || gone_well
app=''
echo "monkey: seed $seed: $acts acts, $starts start(s), nothing broken but $falls dialog(s) of the toolkit's$caught"
