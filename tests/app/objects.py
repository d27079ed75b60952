"""Prints role and name of every object that assistive technology is told of, a line each. Arguments:
the accessibility bus, the app's name on it. The app tells of all objects at once (GetItems), but
knows of one only after its parent has been asked for its children. Roles are numbers of
org.a11y.atspi, but for those that can be pressed."""
import json
import subprocess
import sys

ROLES = {32: "list item", 43: "button", 51: "slider", 62: "toggle button"}


def ask(path, interface, method):
    address, service = sys.argv[1:]
    command = ["busctl", "--json=short", "--address=" + address, "call", service, path, interface, method]
    answer = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=False).stdout
    return json.loads(answer)["data"][0] if answer else []


asked = set()
new = ["/org/a11y/atspi/accessible/root"]
while new:
    for path in new:
        ask(path, "org.a11y.atspi.Accessible", "GetChildren")
    asked.update(new)
    items = ask("/org/a11y/atspi/cache", "org.a11y.atspi.Cache", "GetItems")
    new = [item[0][1] for item in items if item[4] > 0 and item[0][1] not in asked]
for item in items:
    print(ROLES.get(item[7], item[7]), item[6], sep="\t")
