#!/usr/bin/env bash
# The page in Chromium, as people use it: fingers, mouse, keyboard, links, languages, an embedding page,
# every screen by axe-core; what the device says, how it is held; links, also of native programs. With
# SKV_LONG_TESTS=1 also wide screens, what the device takes away, a tab that is hidden, files, the bench.
# SKV_TRIAL=words runs those trials alone whose names have these words. Arguments: build folder, source
# folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_web_page.sh BUILD SOURCE}")
cd "${2:?usage: test_web_page.sh BUILD SOURCE}"
# shellcheck source=tests/web/lib.sh
source tests/web/lib.sh
make_modules

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
make_page "$work/page" production
in_chromium page.js "$work/page"
in_chromium fingers.js "$work/page"
in_chromium layout.js "$work/page"
in_chromium framed.js "$work/page"
in_chromium device.js "$work/page"
[[ ${SKV_LONG_TESTS:-0}${SKV_TRIAL:-} == 0 ]] ||
    ffmpeg -v error -f lavfi -i testsrc=size=8000x6000 -frames:v 1 "$work/photo.jpg"
"$build/write_replays" "$work"
link=$("$build/skvalp" share "$work/game.skvr")
in_chromium files.js "$work/page" "$work/photo.jpg" "$link"
found_trial
