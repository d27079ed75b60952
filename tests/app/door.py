"""What tests of the app ask its door (door.c). Arguments: the door's socket. Reads lines of a process,
seconds and an expression in Python over the state, as "PID SECONDS EXPRESSION"; waits until it is true,
at most so long, and answers each with a line: "yes VALUE", or "no" and what the state was instead."""
import json
import os
import socket
import sys
import time

SPACES = str.maketrans("\u00a0\u2009\u202f", "   ")  # that keep numbers together
CELLS = 20  # along each side of the world, as in door.c
PAUSE = 0.03  # s between the first two looks; each pause after that is longer by a fifth
LONGEST = 0.2  # s
TICKS = os.sysconf("SC_CLK_TCK")
exists = os.path.exists


class Fields(dict):
    __getattr__ = dict.__getitem__


class Door:
    def __init__(self, path):
        self.path, self.line, self.file = path, "", None

    def look(self, frame):
        """The state; None while there is no app, or it ends. With `frame` a frame is asked for, too."""
        try:
            if not self.file:
                caller = socket.socket(socket.AF_UNIX)
                caller.settimeout(120)
                caller.connect(self.path)
                self.file = caller.makefile("rw", encoding="utf-8")
            self.file.write("frame\n" if frame else "\n")
            self.file.flush()
            self.line = self.file.readline().translate(SPACES)
            if self.line:
                return json.loads(self.line, object_hook=Fields)
        except OSError:
            pass
        self.file = None
        return None


def is_gone(pid):
    try:
        with open(f"/proc/{pid}/stat", encoding="utf-8") as stat:
            return stat.read().rpartition(")")[2].split()[0] == "Z"
    except OSError:
        return True


def goes_by(widget, name):
    """Whether it is its name, id or text; a name that ends in * is the beginning of one, for what reads numbers."""
    known = (widget.name, widget.id, widget.text)
    return any(one.startswith(name[:-1]) for one in known) if name.endswith("*") else name in known


class Look:
    """What expressions can say of one state: its fields, and the functions below."""

    def __init__(self, state, pid, before):
        self.state, self.pid, self.before, self.steady = state, pid, before, {}

    def names(self):
        public = {name: getattr(self, name) for name in dir(self) if name[0] != "_" and name != "names"}
        return {**public, **self.state, "exists": exists, "message": self.text("message_text")}

    def widgets(self):
        return [widget for window in self.state.windows for widget in window.widgets]

    def find(self, name, kind=""):
        """The first that shows of this name, id or text; kind is a part of its class's name."""
        for widget in self.widgets():
            if goes_by(widget, name) and kind in widget.type:
                return widget
        return None

    def shows(self, name, kind=""):
        return self.find(name, kind) is not None

    def text(self, name):
        return (self.find(name) or {"text": ""})["text"]

    def says(self, part):
        """Whether it is a part of some text that shows."""
        return any(part in widget.text for widget in self.widgets())

    def menus(self):
        """How many stand open."""
        return sum(widget.type in ("GtkPopover", "GtkPopoverMenu") for widget in self.widgets())

    def dialog(self):
        """The title of the window over the app's; "" if there is none."""
        return self.state.windows[1].title if len(self.state.windows) > 1 else ""

    def still(self, value):
        """The value, once it stays over two frames, which are asked for."""
        frames, name = sum(window.frames for window in self.state.windows), len(self.steady)
        last, since = self.before.get(name, (None, 0))
        if last != value:
            since = frames
        self.steady[name] = value, since
        return value if frames >= since + 2 * len(self.state.windows) else None

    def focused(self):
        """Name and place of what has the focus."""
        return next((f"{one.name or one.text} {one.x} {one.y}" for one in self.widgets() if one.focus), "")

    def closed(self):
        """Whether no menu is open, and the focus is back: a key that comes before goes nowhere."""
        return self.menus() == 0 and self.focused() != ""

    def middle(self, name, kind="", x=0.5, y=0.5):
        """Window and place of what shows within its window and can be used; or of another point of it, in
        shares of its size."""
        for window in self.state.windows:
            for one in window.widgets:
                px, py = int(one.x + x * one.width), int(one.y + y * one.height)
                if (goes_by(one, name) and kind in one.type and one.sensitive and one.reached
                        and 0 <= px < window.width and 0 <= py < window.height):
                    return window.get("xid", 0), px, py
        return None

    def at(self, x, y, world=0):
        """Window and place of a point of a world, in percent from its lower left corner."""
        one = self.state.worlds[world]
        return (self.state.windows[0].get("xid", 0),
                round(one.area.x + one.camera.originX + one.camera.scale * one.width * x / 100),
                round(one.area.y + one.camera.originY - one.camera.scale * one.height * y / 100))

    def grip(self, probe=0, end=0, world=0):
        """Window and place of an end of an instrument."""
        one = self.state.worlds[world]
        x, y = one.probes[probe][f"x{end}"], one.probes[probe][f"y{end}"]
        return self.at(100 * x / one.width, 100 * y / one.height, world)

    def cells(self, of, x0, y0, x1, y1, world=0):
        """What the door says of the cells of such a part."""
        columns = range(round(x0 * CELLS / 100), round(x1 * CELLS / 100))
        rows = range(round(y0 * CELLS / 100), round(y1 * CELLS / 100))
        return [self.state.worlds[world][of][CELLS * row + column] for row in rows for column in columns]

    def water(self, x0, y0, x1, y1, world=0):
        """How many percent of a part of a world, in percent from its lower left corner, hold water."""
        cells = self.cells("water", x0, y0, x1, y1, world)
        return 100 * sum(count > 0 for count in cells) / len(cells)

    def inside(self, what, world=0):
        """Window and place of a cell well within water, wall or air."""
        one = self.state.worlds[world]
        for i in range(CELLS * CELLS):
            column, row = i % CELLS, i // CELLS
            if not (0 < column < CELLS - 1 and 0 < row < CELLS - 1):
                continue
            near = [i + dx + CELLS * dy for dx in (-1, 0, 1) for dy in (-1, 0, 1)]
            if all(("wall" if one.walls[j] else "water" if one.water[j] else "air") == what for j in near):
                return self.at((column + 0.5) * 100 / CELLS, (row + 0.5) * 100 / CELLS, world)
        return None

    def spent(self, seconds=1):
        """The share of a processor that the app takes while nobody asks it."""
        def used():
            with open(f"/proc/{self.pid}/stat", encoding="utf-8") as stat:
                return sum(map(int, stat.read().rpartition(")")[2].split()[11:13])) / TICKS
        before = used()
        time.sleep(seconds)
        return (used() - before) / seconds


def summary(line):
    """A state in one line without what is long."""
    state = json.loads(line) if line else {}
    for world in state.get("worlds", []):
        world["water"] = world["walls"] = "..."
    for window in state.get("windows", []):
        window["widgets"] = sorted({one["text"] or one["name"] for one in window["widgets"]})
    return json.dumps(state, ensure_ascii=False)


def wait(door, pid, seconds, expression):
    end, before, pause = time.monotonic() + seconds, {}, PAUSE
    while True:
        state, value, error = door.look(before), None, ""
        if state and state.windows and "worlds" in state:
            look = Look(state, pid, before)
            try:
                value = eval(expression, look.names())  # pylint: disable=eval-used
            except (LookupError, TypeError) as missing:  # not there yet
                error = f" ({missing!r})"
            before = look.steady
        if value:
            return f"yes {' '.join(map(str, value)) if isinstance(value, tuple) else value}"
        if state is None and is_gone(pid):
            return "no, the app has ended"
        if time.monotonic() >= end:
            return f"no {value}{error}: {summary(door.line) if state else 'the app does not answer'}"
        time.sleep(pause)
        pause = min(1.2 * pause, LONGEST)


def main():
    door, asked = Door(sys.argv[1]), ""
    for line in sys.stdin:
        pid, seconds, expression = line.rstrip("\n").split(" ", 2)
        if pid != asked:  # another app, whose door has replaced the last one's
            door.file, asked = None, pid
        print(wait(door, int(pid), float(seconds), expression), flush=True)


main()
