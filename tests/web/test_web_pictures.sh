#!/usr/bin/env bash
# The pictures that are drawn by WebGL 2 in Chromium are those that are drawn natively, in each view and
# palette and with overlays, also in the context after a lost one, and without WebGL there is a clear
# line. With SKV_LONG_TESTS=1 in all combinations of view, overlays, palette and detail.
# Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_web_pictures.sh BUILD SOURCE}")
cd "${2:?usage: test_web_pictures.sh BUILD SOURCE}"
# shellcheck source=tests/web/lib.sh
source tests/web/lib.sh
make_modules

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# Scene, view, overlays, palette, detail; ink has dyes, pipes has walls.
styles=(
    dam-break.water.none.dark.full
    'dam-break.water.tracers,arrows.light.full'
    dam-break.water.none.contrast.plain
    'dam-break.pressure.legend,grid,ruler.dark.full'
    dam-break.speed.streamlines.light.full
    dam-break.density.legend.contrast.full
    dam-break.particles.none.dark.full
    dam-break.fluid.arrows.light.plain
    ink.water.none.dark.full
    pipes.water.none.light.full
)
if [[ ${SKV_LONG_TESTS:-0} == 1 ]]; then
    # The scenes take turns, so that each meets each pair of a view and another choice.
    scenes=(dam-break ink pipes fountain) details=(full plain) palettes=(dark light contrast)
    overlays=(none 'tracers,arrows,streamlines,grid,ruler,legend')
    views=(water pressure speed density particles fluid)
    styles=()
    for ((i = 0; i < 72; i++)); do
        d=$((i % 2)) p=$((i / 2 % 3)) o=$((i / 6 % 2)) v=$((i / 12))
        styles+=("${scenes[(v + 2 * o + p + d) % 4]}.${views[v]}.${overlays[o]}.${palettes[p]}.${details[d]}")
    done
fi
files=()
for style in "${styles[@]}"; do
    IFS=. read -r scene view overlays palette detail <<<"$style"
    files+=("$work/$style.png")
    state=$work/$scene.skv
    [[ -e $state ]] || "$build/skvalp" run "$scene" --seconds 1 --particles 1000 --threads 1 --quiet --snapshot "$state"
    "$build/skvalp" run "$state" --seconds 0 --threads 1 --size 480x270 --quiet \
        --view "$view" --overlay "$overlays" --palette "$palette" --detail "$detail" --png "${files[-1]}"
done
bundle "$work/bundle" painter.worker.js
in_chromium pictures.js "$work/bundle" "$modules" 1000 "${files[@]}"
