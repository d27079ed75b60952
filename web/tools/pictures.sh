#!/usr/bin/env bash
# Makes the gallery's pictures anew, web/page/pictures/SCENE.webp: each built-in scene a moment after its
# start, when it shows what it is about. Needs ImageMagick. Argument: the build folder.
set -euo pipefail
build=$(realpath "${1:?usage: pictures.sh BUILD}")
cd "$(dirname "$0")/../page/pictures"

declare -A moments=([boat]=0.8 [breaking-wave]=0.6 [communicating]=0.4 [dam-break]=0.5 [duck]=0.5 [floating]=0.6
    [fountain]=3 [funnel]=0.4 [goo]=2 [ink]=0.6 [jelly]=0.9 [lock]=1 [mercury]=0.7 [oil]=0.5 [pipes]=2 [splash]=0.5
    [three-liquids]=1.5 [tsunami]=0.5 [u-tube]=0.6 [water-wheel]=3.5 [waves]=0.8)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
while read -r scene _; do
    "$build/skvalp" run "$scene" --seconds "${moments[$scene]:-1}" --png "$work/$scene.png" --size 640x360 --quiet
    convert "$work/$scene.png" -resize 320x180 -quality 70 "$scene.webp"
done < <("$build/skvalp" scenes)
