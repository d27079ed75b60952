#!/usr/bin/env bash
# The device's sensor, played by a folder: gravity follows it once it is switched on, as the screen is
# turned and as strong as was chosen; shaking splashes. Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_app_tilt.sh BUILD SOURCE}")
# shellcheck source=tests/app/lib.sh
source "$(dirname "$0")/lib.sh"
start_display 800x600
export SKVALP_SENSORS=$work/sensors
mkdir -p "$SKVALP_SENSORS/iio:device0"
feel() { # X Y: acceleration in units of the earth's, in thousandths
    printf '%d\n' "$1" >"$SKVALP_SENSORS/iio:device0/in_accel_x_raw"
    printf '%d\n' "$2" >"$SKVALP_SENSORS/iio:device0/in_accel_y_raw"
}
printf '0.00981\n' >"$SKVALP_SENSORS/iio:device0/in_accel_scale"
# A small pool, which is at rest soon.
printf '{"world": {"width": 0.4, "height": 0.225}, "water": [{"shape": "box", "y1": 0.11}]}' >"$work/pool.json"

# 1. Off, as long as nobody asks for it.
feel -1000 0
start_app "$work/pool.json"
await 'moment > 10 and water(0, 0, 100, 40) == 100'
is 'gravity.x == 0 and gravity.y == -1' || fail "the sensor acts though it is off: $answer"
# Switched on in the menu it acts at once: the right edge is down. What another window has kept meanwhile stays.
printf 'ball=1\n' >>"$work/.config/skvalp/play.ini"
key F10
await 'menus() == 1'
press 'Tilt by the Sensor'
await 'closed() and gravity.x > 0.9 and abs(gravity.y) < 0.1'
quit_app
grep -q '^tilt=1' "$work/.config/skvalp/play.ini" || fail "that the sensor is on was not kept"
grep -q '^ball=1' "$work/.config/skvalp/play.ini" || fail "what another window had kept is lost"

# 2. On, and the screen turned: held upright, with its left edge up, the pool stays where it is; shaken
# it splashes; tilted to the right it flows there.
printf 'tilt-up=1\n' >>"$work/.config/skvalp/play.ini"
start_app "$work/pool.json"
await 'moment > 10 and gravity.y < -0.9 and abs(gravity.x) < 0.1'
if [[ ${SKV_LONG_TESTS:-} == 1 ]]; then # it takes a while
    await atRest 300
fi
is 'water(15, 60, 85, 100) == 0' || fail "held upright, the fluid does not lie at the lower edge: $answer"
splash() {
    local i
    for ((i = 0; i < 6; i++)); do
        await moment
        feel -1000 $((i % 2 ? -4000 : 4000))
        await "moment > $answer + 4"
        ! is 'water(0, 60, 100, 100) > 0' || break # it falls back before somebody looks again
    done
    feel -1000 0
    ((i < 6))
}
repeat splash || fail "shaking does not splash"
feel 0 -1000
await 'gravity.x > 0.9 and abs(gravity.y) < 0.1 and water(80, 60, 95, 80) > 60'
quit_app
echo "tilt: off, switched on, upright, shaken, tilted"
