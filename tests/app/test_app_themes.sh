#!/usr/bin/env bash
# Light, dark and high contrast: water, walls and text are told apart, also in grey. Arguments: build
# folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_app_themes.sh BUILD SOURCE}")
# shellcheck source=tests/app/lib.sh
source "$(dirname "$0")/lib.sh"
start_display 1280x800

# luminance X0 Y0 X1 Y1: of a part of the picture, in thousandths (Rec. 709, linear).
luminance() {
    convert "$work/now.ppm" -crop "$(((right - left) * ($3 - $1) / 100))x$(((bottom - top) * ($4 - $2) / 100))+$((
        left + (right - left) * $1 / 100))+$((top + (bottom - top) * $2 / 100))" +repage \
        -colorspace RGB -fx '0.2126*r+0.7152*g+0.0722*b' -format '%[fx:round(1000*mean)]' info:
}
# contrast A B LEAST: (lighter + 0.05) / (darker + 0.05), in hundredths.
contrast() {
    local light=$(($1 > $2 ? $1 : $2)) dark=$(($1 > $2 ? $2 : $1)) ratio
    ratio=$(((light + 50) * 100 / (dark + 50)))
    ((ratio >= $3)) || fail "$theme: a contrast of $ratio hundredths is below $3: $4"
}

for theme in light dark contrast; do
    case $theme in
    light) export ADW_DEBUG_COLOR_SCHEME=prefer-light ADW_DEBUG_HIGH_CONTRAST=0 ;;
    dark) export ADW_DEBUG_COLOR_SCHEME=prefer-dark ADW_DEBUG_HIGH_CONTRAST=0 ;;
    contrast) export ADW_DEBUG_COLOR_SCHEME=prefer-light ADW_DEBUG_HIGH_CONTRAST=1 ;;
    esac
    start_app u-tube
    await 60 more 3 fluid 5 30 95 95 || fail "$theme: no water"
    sleep 1
    key space
    await 60 picture_stands || fail "$theme: Space did not pause"
    shoot now
    wall=$(luminance 1 50 8 90)
    water=$(luminance 47 78 53 84)
    contrast "$wall" "$water" 300 "water and wall"
    # The header's ground follows the theme.
    header=$(convert "$work/now.ppm" -crop "100x20+$((X + WIDTH / 2 - 220))+$((Y + 16))" -colorspace gray \
        -format '%[fx:round(100*mean)]' info:)
    case $theme in
    dark) ((header < 40)) || fail "the header is light ($header) in the dark" ;;
    *) ((header > 60)) || fail "the header is dark ($header) in the light" ;;
    esac
    quit_app
done
echo "themes: light, dark and high contrast can be read"
