#!/usr/bin/env bash
# Assistive technology finds the app while it plays without a pause, and every button has a name;
# what worlds are compared with is what they were compared with last.
# Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_app_access.sh BUILD SOURCE}")
if [[ ${2-} != --inside ]]; then
    for program in dbus-run-session busctl; do
        command -v "$program" >/dev/null || {
            echo "$program is missing: install dbus and systemd"
            exit 1
        }
    done
    runtime=$(mktemp -d) # where the accessibility bus is made: one of our own
    trap 'rm -rf "$runtime"' EXIT
    env -u DBUS_SESSION_BUS_ADDRESS XDG_RUNTIME_DIR="$runtime" dbus-run-session -- \
        bash "$0" "$build" --inside
    exit
fi
bus=$DBUS_SESSION_BUS_ADDRESS
# shellcheck source=tests/app/lib.sh
source "$(dirname "$0")/lib.sh"
export DBUS_SESSION_BUS_ADDRESS=$bus
unset GTK_A11Y
start_display 1280x800

address=$(busctl --user --address="$bus" call org.a11y.Bus /org/a11y/bus org.a11y.Bus GetAddress |
    sed 's/^s "\(.*\)"$/\1/')
[[ -n $address ]] || fail "no accessibility bus"
busctl --address="$bus" set-property org.a11y.Bus /org/a11y/bus org.a11y.Status IsEnabled b true || true

at_spi() { busctl --address="$address" "$@" 2>/dev/null; }
printf 'compare=oil\n' >>"$work/.config/skvalp/play.ini"
start_app dam-break
registered() {
    service=$(at_spi call org.a11y.atspi.Registry /org/a11y/atspi/accessible/root \
        org.a11y.atspi.Accessible GetChildren | grep -oE '":[0-9.]+"' | head -n 1 | tr -d '"')
    [[ -n $service ]]
}
repeat registered || fail "the app did not register while it plays"

compare
key space
await 'paused and moment == end'
key w
await 'shows("Lap")'
python3 "$(dirname "$0")/objects.py" "$address" "$service" >"$work/tree"
(($(wc -l <"$work/tree") > 30)) || fail "only $(wc -l <"$work/tree") objects were found"
for name in 'World A' 'World B' Oil 'Hands and gravity in both worlds' Hand Play Rewind Scenes Properties 'Main menu' Gravity Measure Undo Stopwatch Lap; do
    grep -q "	$name\$" "$work/tree" || fail "nothing is named $name: $(cut -f 2 "$work/tree" | sort -u | tr '\n' ',')"
done
nameless=$(grep -cE '^(toggle button|button)	$' "$work/tree" || true)
((nameless == 0)) || fail "$nameless buttons have no name: $(sort "$work/tree" | uniq -c | head -n 40)"
if grep -E '^(toggle button|button|slider|list item)	(Gtk|Adw)' "$work/tree"; then
    fail "what can be pressed is named after its class"
fi
key ctrl+q
ended_loudly # the toolkit of the bus that goes first
echo "access: registered while it plays; $(wc -l <"$work/tree") objects, all buttons have names"
