#!/usr/bin/env bash
# What is shown: views with their legends, overlays, zoom, a gallery, full screen, a narrow window;
# what was chosen is kept. Arguments: build folder, source folder.
set -euo pipefail
build=$(realpath "${1:?usage: test_app_views.sh BUILD SOURCE}")
export GSK_RENDERER=gl
# shellcheck source=tests/app/lib.sh
source "$(dirname "$0")/lib.sh"
start_display 1280x800
start_manager # only one makes full screens
start_app pool
key space
await paused

# 1. Views, and what lies over them.
await 'style.view == "water" and worlds[0].legend is None and not shows("legend")'
key v
await 'style.view == "pressure" and worlds[0].legend.label == "pressure" and shows("legend")'
click legend
await 'style.range == worlds[0].legend.high and style.range > 0'
press Views
await 'menus() == 1'
press Speed
await 'style.view == "speed" and style.range == 0 and closed()'
key t
await 'style.overlays == ["tracers"]'
press Views
await 'menus() == 1'
press Grid
await '"grid" in style.overlays and "tracers" in style.overlays and closed()'

# 2. Nearer, and all of it again.
key ctrl+plus ctrl+plus
await 'abs(worlds[0].camera.zoom - 1.5625) < 1e-6'
await 'worlds[0].camera.originX'
old=$answer
go 'still(at(50, 50))'
xdotool mousedown 2
point 55 50
xdotool mouseup 2
await "worlds[0].camera.originX > $old + 10"
key ctrl+minus
await 'abs(worlds[0].camera.zoom - 1.25) < 1e-6'
# 3. Gravity by its ball: as far out as twice the scene's own strength, and caught in the middle.
go 'middle("Gravity", x=0.85)'
xdotool click 1
await 'gravity.x > 1.2 and abs(gravity.y) < 0.1'
go 'middle("Gravity", y=0.1)'
xdotool click 1
await 'abs(gravity.x) < 0.1 and gravity.y > 1.2'
click Gravity
await 'gravity.x == 0 and gravity.y == 0'

# 4. Properties, and full screen, which Escape leaves.
press Properties
await 'shows("Compare with") and find("Properties", "Toggle").active'
is 'abs(worlds[0].camera.zoom - 1.25) < 1e-6' || fail "a view that is made smaller shows something else: $answer"
key Escape
await 'not shows("Compare with") and not find("Properties", "Toggle").active'
key F11
await 'windows[0].fullscreen and windows[0].width == 1280 and not shows("header") and shows("leave")'
key Escape
await 'not windows[0].fullscreen and shows("header") and not shows("leave")'

key ctrl+0
await 'worlds[0].camera.zoom == 1'

# 5. The gallery shows scenes; one is opened; Escape leaves the gallery.
key g
await 'page == "scenes" and find("scenes").active'
key Escape
await 'page == "play"'
press scenes
await 'page == "scenes"'
press Pool Button
await 'page == "play" and worlds[0].opened == 2 and gravity.y == -1 and windows[0].title.startswith("Pool")'
await 'not paused and moment > 0'
key ctrl+question
await 'len(windows) == 2 and says("What is shown")'
focus
quit_app

# 6. What was chosen is kept. 360 pixels wide, upright: picture, tools and time are all there.
sed -i -E 's/^width=.*/width=360/; s/^height=.*/height=640/' "$work/.config/skvalp/play.ini"
start_app pool
await 'style.view == "speed" and style.overlays == ["tracers", "grid"]'
await 'windows[0].width <= 380 and windows[0].height <= 660'
await 'worlds[0].area.width > 300 and worlds[0].area.height > 200'
for name in Hand Play Rewind Views Gravity; do
    [[ $name != Play ]] || name=Pause
    await "find('$name').width > 0 and find('$name').x + find('$name').width <= windows[0].width"
done
await 'find("rail").y > find("view").y' # the tools below the picture
key ctrl+question # not wider than the window, and nothing cut off
await 'dialog() == "Keyboard Shortcuts" and still(windows[1].width)' # it grows after its first frame
await 'windows[1].width <= 380 and all(one.x + one.width <= windows[1].width for one in windows[1].widgets)'
focus
key Escape
await 'not dialog()'
focus
key ctrl+o
await 'len(windows) == 2'
focus
quit_app # in spite of it
grep -q '^width=3[67]' "$work/.config/skvalp/play.ini" || fail "the window's size was not kept"

# 7. The number of particles: the scene begins anew with it, it shows, and it is kept.
start_app pool
key F10
await 'menus() == 1'
press Particles
press '1 000'
await 'worlds[0].opened == 2 and worlds[0].particles == 1000 and closed() and says("1 000 particles")'
is 'not shows("Bring Back")' || fail "what nobody has touched is offered: $answer"
# What was done meanwhile can be brought back, and with it the number that it had.
key space
await paused
key 2
await 'tool == 1'
drag 60 75 75 77
let_go
await 'canUndo and sum(cells("walls", 65, 75, 75, 80)) == 2'
key F10
await 'menus() == 1'
press Particles
press '500'
await 'worlds[0].opened == 3 and worlds[0].particles == 500 and not canUndo'
press 'Bring Back'
await 'worlds[0].opened == 4 and worlds[0].particles == 1000 and sum(cells("walls", 65, 75, 75, 80)) == 2'
quit_app
start_app pool
await 'worlds[0].opened == 1 and worlds[0].particles == 1000'
quit_app

# In a narrow window the scene's description begins below the legend; it goes after some seconds.
window_size 360 640
start_app pool
key v
await 'find("Legend") and find("Legend").height > 0'
is '(lambda one, legend: not one or legend.y + legend.height <= one.y)(find("description_text"), find("Legend"))' ||
    fail "the legend lies over the description: $answer"
quit_app

# 8. Where nothing can be remembered it goes on all the same; and it ends well though the gallery's pictures
# are being made.
rm -rf "$work/.config"
printf 'no folder' >"$work/.config"
start_app pool
await 'moment > 0'
key g
await 'page == "scenes"'
quit_app
echo "views: seen, zoomed, tilted by the ball, full screen and back, chosen from the gallery, 360 px"
