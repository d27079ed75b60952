#!/usr/bin/env bash
# The host's readers (jsonc-parser, fast-png) and the native ones (jansson, libpng) accept and refuse
# the same files, with the same code, and build the same worlds: the project's scenes and pictures,
# what the fuzz targets have kept, and 100 mutations, 1000 with SKV_LONG_TESTS=1. Why a text is no
# JSON or a PNG damaged each says in its own words, and hosts hear of options without a command line's
# dashes. Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_web_files.sh BUILD SOURCE}")
cd "${2:?usage: test_web_files.sh BUILD SOURCE}"
# shellcheck source=tests/web/lib.sh
source tests/web/lib.sh
make_modules

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
count=100
[[ ${SKV_LONG_TESTS:-0} != 1 ]] || count=1000

outcomes() {
    "$@" | sed -E 's/^3 .*/3/; s/^([0-9]+ )--(set )?/\1/'
}

node tests/web/cases.js "$count" "$work/cases"
outcomes "$build/web_reference" files "$work/cases" >"$work/native"
for code in 0 3 4; do
    grep -q "^$code" "$work/native" || complain "no file has the outcome $code: too little is compared"
done
same "files" "$work/native" outcomes in_wasm 1 files "$work/cases"
verdict
