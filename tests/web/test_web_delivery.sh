#!/usr/bin/env bash
# The folder that `npm run build` makes: isolated by its service worker on a server that sends no headers,
# there without the server, renewed whole when a new version is, in a frame, and where nothing can be kept;
# and the single file, from a disk. No path of this machine is in it, and a first visit takes no more than
# it may. Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_web_delivery.sh BUILD SOURCE}")
cd "${2:?usage: test_web_delivery.sh BUILD SOURCE}"
# shellcheck source=tests/web/lib.sh
source tests/web/lib.sh
make_modules

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
make_page "$work/page" production single
if grep -rlE "node_modules|$PWD/(app|build|include|scenes|src|web)/|sourceMappingURL" "$work/page"; then
    complain "the built page tells where it was built"
fi
for name in index.html skvalp.html service.js manifest.webmanifest icon.svg icon-192.png icon-512.png; do
    [[ -s $work/page/$name ]] || complain "the built page has no $name"
done
in_chromium delivery.js "$work/page" "$work/other"
found_trial
((bad == 0)) || exit 1
printf 'web: the built page goes everywhere\n'
