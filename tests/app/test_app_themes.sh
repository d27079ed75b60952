#!/usr/bin/env bash
# Light, dark and high contrast: water, walls and the header are told apart on the screen, also in
# grey. Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_app_themes.sh BUILD SOURCE}")
# shellcheck source=tests/app/lib.sh
source "$(dirname "$0")/lib.sh"
start_display 800x600

# luminance EXPRESSION: about a place of the window, in thousandths (Rec. 709, linear).
luminance() {
    local xid x y
    await "still($1)" # what the door tells has been drawn, too
    read -r xid x y <<<"$answer"
    import -silent -window "$xid" -crop "4x4+$((x - 2))+$((y - 2))" +repage "$work/part.ppm"
    luminance=$(convert "$work/part.ppm" -colorspace RGB -fx '0.2126*r+0.7152*g+0.0722*b' \
        -format '%[fx:round(1000*mean)]' info:)
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
    await 'moment > 5'
    key space
    await 'paused and not active'
    luminance 'inside("wall")' && wall=$luminance
    luminance 'inside("water")' && water=$luminance
    contrast "$wall" "$water" 300 "water and wall"
    # The header's ground follows the theme; its left edge has nothing on it.
    luminance 'middle("header", x=0.3)' && header=$luminance
    case $theme in
    dark) ((header < 150)) || fail "the header is light ($header) in the dark" ;;
    *) ((header > 400)) || fail "the header is dark ($header) in the light" ;;
    esac
    quit_app
done
echo "themes: light, dark and high contrast can be read"
