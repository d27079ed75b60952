#!/usr/bin/env bash
# The npm package in projects of other people: vite (built, and served while developing), webpack and esbuild, opened
# in Chromium, on the page and in a worker with threads. With SKV_LONG_TESTS=1 alone, which the bundlers are
# installed for. Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_web_bundlers.sh BUILD SOURCE}")
cd "${2:?usage: test_web_bundlers.sh BUILD SOURCE}"
if [[ ${SKV_LONG_TESTS:-0} != 1 ]]; then
    printf 'web: bundlers are left to SKV_LONG_TESTS=1\n'
    exit 0
fi
# shellcheck source=tests/web/lib.sh
source tests/web/lib.sh
[[ -d tests/web/bundlers/node_modules ]] || complain "tests/web/bundlers/node_modules is missing; ./test.sh installs it"
make_modules

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
unpack_package "$work"
hash=$("$build/skvalp" run dam-break --particles 1000 --law clavet --seconds 1 --json |
    sed -n 's/.*"hash": *"\([0-9a-f]*\)".*/\1/p')
cp tests/web/bundlers/project/* "$work/project"
in_chromium bundled.js "$work/project" "$PWD/tests/web/bundlers" "$hash"
printf 'web: vite, webpack and esbuild take the package\n'
