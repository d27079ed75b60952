/* Keys: what each does in every front end. Invariant: an action is one of the app's; a front end
 * that lacks it leaves the key out. */
#include "skvalp/controls.h"

#define PLAYBACK "Playback"
#define TOOLS    "Tools"
#define FINGERS  "Fingers"
#define GRAVITY  "Gravity"
#define VIEW     "View"
#define GENERAL  "General"

static const skv_key keys[] = {
    {PLAYBACK, "Play or pause", "Space", "pause", NULL, false},
    {PLAYBACK, "One step of 1/60 s", ".", "step", NULL, true},
    {PLAYBACK, "One step of 1/60 s", "s", "step", NULL, true},
    {PLAYBACK, "One step back", ",", "go", "-1", true},
    {PLAYBACK, "A second back, a second on", "Shift+Left", NULL, NULL, true},
    {PLAYBACK, "A second back, a second on", "Shift+Right", NULL, NULL, true},
    {PLAYBACK, "Back to the start of the scene", "r", "reset", NULL, false},
    {PLAYBACK, "Slower and faster", "-", "change-speed", "-1", true},
    {PLAYBACK, "Slower and faster", "+", "change-speed", "1", true},
    {PLAYBACK, NULL, "=", "change-speed", "1", true},
    {PLAYBACK, "Undo and redo", "Ctrl+z", "undo", NULL, true},
    {PLAYBACK, "Undo and redo", "Ctrl+Shift+z", "redo", NULL, true},
    {PLAYBACK, NULL, "Ctrl+y", "redo", NULL, true},
    {PLAYBACK, "Stopwatch: start and stop, lap", "w", "stopwatch", "false", false},
    {PLAYBACK, "Stopwatch: start and stop, lap", "l", "stopwatch", "true", false},
    {TOOLS, "Smaller and larger", "[", "brush", "0.8", true},
    {TOOLS, "Smaller and larger", "]", "brush", "1.25", true},
    {TOOLS, "Pour the next fluid", "n", "next-fluid", NULL, false},
    {TOOLS, "A pressure probe", "m", "measure", "0", false},
    {TOOLS, "A hand for the keyboard: arrow keys move it", "k", "keyboard-hand", NULL, false},
    {TOOLS, "Close that hand, and open it", "Return", NULL, NULL, false},
    {FINGERS, "Use the tool, each as a hand", "One finger, and more beside it", NULL, NULL, false},
    {FINGERS, "Move the picture, and zoom it", "Two fingers that come down together", NULL, NULL,
     false},
    {FINGERS, "Undo", "A tap of three fingers", NULL, NULL, false},
    {GRAVITY, "Point it that way, until another key is pressed", "Left", NULL, NULL, false},
    {GRAVITY, "Point it that way, until another key is pressed", "Right", NULL, NULL, false},
    {GRAVITY, "Point it that way, until another key is pressed", "Up", NULL, NULL, false},
    {GRAVITY, "Point it that way, until another key is pressed", "Down", NULL, NULL, false},
    {GRAVITY, "Switch it off", "0", "weightless", NULL, false},
    {VIEW, "What is shown", "v", "next-view", NULL, false},
    {VIEW, "White tracers", "t", "overlay-tracers", NULL, false},
    {VIEW, "Zoom in and out", "Ctrl++", "zoom", "1.0", false},
    {VIEW, "Zoom in and out", "Ctrl+-", "zoom", "-1.0", false},
    {VIEW, "Zoom in and out", "Wheel with Ctrl", NULL, NULL, false},
    {VIEW, NULL, "Ctrl+=", "zoom", "1.0", false},
    {VIEW, "All of it", "Ctrl+0", "zoom", "0.0", false},
    {VIEW, "Full screen", "F11", "fullscreen", NULL, false},
    {VIEW, "Full screen", "f", "fullscreen", NULL, false},
    {VIEW, "Scenes and experiments", "g", "gallery", NULL, false},
    {VIEW, "Properties", "p", "properties", NULL, false},
    {GENERAL, "Open a scene or a picture", "Ctrl+o", "open", NULL, false},
    {GENERAL, "Save a state or a replay", "Ctrl+s", "save", NULL, false},
    {GENERAL, "Save a picture", "Ctrl+p", "screenshot", NULL, false},
    {GENERAL, "Save the last 10 seconds as a video", "Ctrl+r", "record", NULL, false},
    {GENERAL, "Compare two worlds, or close the second", "c", "toggle-compare", NULL, false},
    {GENERAL, "Copy a link to share", "Ctrl+Shift+c", "share", NULL, false},
    {GENERAL, "Open a link from the clipboard", "Ctrl+v", "paste", NULL, false},
    {GENERAL, "Leave what was entered last", "Escape", "dismiss", NULL, false},
    {GENERAL, "Keyboard shortcuts", "?", "show-help-overlay", NULL, false},
    {GENERAL, "Keyboard shortcuts", "Ctrl+?", "show-help-overlay", NULL, false},
    {GENERAL, NULL, "Ctrl+w", "window.close", NULL, false},
    {GENERAL, "Quit", "Ctrl+q", "window.close", NULL, false},
};

const skv_key *skv_key_at(int i)
{
    return i >= 0 && i < (int)(sizeof keys / sizeof *keys) ? &keys[i] : NULL;
}
