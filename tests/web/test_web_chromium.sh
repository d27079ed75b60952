#!/usr/bin/env bash
# The same bits in Chromium as natively: golden worlds, replays and rows of an experiment, with 1, 2
# and 3 threads where the page is isolated, and with the module without threads where it is not, where
# workers or memory to share are not to be had, and on the page itself. With SKV_LONG_TESTS=1 for longer,
# and built-in scenes; test_web_lab has all experiments. Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_web_chromium.sh BUILD SOURCE}")
cd "${2:?usage: test_web_chromium.sh BUILD SOURCE}"
# shellcheck source=tests/bits/lib.sh
source tests/bits/lib.sh
# shellcheck source=tests/web/lib.sh
source tests/web/lib.sh
make_modules

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
frames=6
runs=16
if [[ ${SKV_LONG_TESTS:-0} == 1 ]]; then
    frames=60
    runs=20
fi
"$build/write_replays" "$work"
replays=("$work"/{game,skewed,wind}.skvr)

# The reference solver's worlds are test_web_bits', in the same modules.
golden_worlds "$frames" fast >"$work/bits"
played "${replays[@]}" >"$work/replay"
"$build/web_reference" lab 400 | grep '^slosh:' >"$work/lab"

mkdir "$work/got"
bundle "$work/bundle" probe.js
jobs=("bits $frames fast" "replay ${replays[*]}" "lab 400 slosh")
if ((runs > 16)); then
    cp tests/bits/golden-scenes.txt "$work/scenes"
    jobs+=('scenes .*')
fi
in_chromium bits.js "$work/bundle" "$modules" "$work/got" "${jobs[@]}"
for got in "$work"/got/*; do
    name=${got##*/}
    same "$name" "$work/${name%%.*}" cat "$got"
done
((compared == runs)) || complain "$compared runs were compared, not $runs"
verdict
