#!/usr/bin/env bash
# The device's sensor, played by a folder: gravity follows it once it is switched on, as the screen is
# turned and as strong as was chosen; shaking splashes. Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_app_tilt.sh BUILD SOURCE}")
# shellcheck source=tests/app/lib.sh
source "$(dirname "$0")/lib.sh"
start_display 1280x800
export SKVALP_SENSORS=$work/sensors
mkdir -p "$SKVALP_SENSORS/iio:device0" "$work/.config/skvalp"
feel() { # X Y: acceleration in units of the earth's, in thousandths
    printf '%d\n' "$1" >"$SKVALP_SENSORS/iio:device0/in_accel_x_raw"
    printf '%d\n' "$2" >"$SKVALP_SENSORS/iio:device0/in_accel_y_raw"
}
printf '0.00981\n' >"$SKVALP_SENSORS/iio:device0/in_accel_scale"

settings() { printf '%s\n' '[play]' width=640 height=420 "$@" >"$work/.config/skvalp/play.ini"; } # small: drawn sooner
# A small pool, which is at rest soon.
printf '{"world": {"width": 0.4, "height": 0.225}, "water": [{"shape": "box", "y1": 0.11}]}' >"$work/pool.json"

# 1. Off, as long as nobody asks for it.
settings
feel -1000 0
start_app "$work/pool.json"
await 60 more 98 fluid 15 65 85 90 || fail "no fluid in the lower half of the pool"
sleep 1
less 10 fluid 80 20 95 40 || fail "the sensor acts though it is off"
quit_app

# 2. On, and the screen turned: held upright, with its left edge up, the pool stays where it is; shaken
# it splashes; tilted to the right it flows there.
settings tilt=1 tilt-up=1
start_app "$work/pool.json"
await 60 more 98 fluid 15 65 85 90 || fail "no fluid in the lower half of the pool"
if [[ ${SKV_LONG_TESTS:-} == 1 ]]; then # it takes a while
    still() {
        local before
        before=$(ticks)
        sleep 2
        (($(ticks) - before <= 6))
    }
    await 240 still || fail "a pool that is held still does not come to rest"
fi
less 1 fluid 15 25 85 40 || fail "held upright, the fluid does not lie at the lower edge"
splash() {
    for _ in 1 2 3 4 5 6; do
        feel -1000 4000
        sleep 0.1
        feel -1000 -4000
        sleep 0.1
    done
    feel -1000 0
    more 0 fluid 2 20 98 40
}
await 120 splash || fail "shaking does not splash"
feel 0 -1000
await 120 more 60 fluid 80 20 95 40 || fail "tilted to the right, the fluid does not flow there"
quit_app
echo "tilt: off, upright, shaken, tilted"
