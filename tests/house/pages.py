"""What the documentation names exists: see test_pages.sh. Arguments: the build and the source folder.

A page of docs/notebook is frozen: its links must lead somewhere, but what it names may be gone.
"""
import glob
import os
import re
import subprocess
import sys

build, source = sys.argv[1:]
os.chdir(source)
complaints = []


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def complain(page, text):
    complaints.append(f"{page}: {text}")


def anchors(text):
    """The anchors of a page's headings, as GitHub makes them."""
    found = {}
    for heading in re.findall(r"^#+ (.*)$", re.sub(r"```.*?```", "", text, flags=re.S), re.M):
        heading = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading)
        name = re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")
        found[name + (f"-{found[name]}" if name in found else "")] = 1
    return found


pages = [page for page in glob.glob("*.md") + glob.glob("docs/**/*.md", recursive=True)
         + glob.glob("web/*.md") + glob.glob("scenes/**/*.md", recursive=True)
         + glob.glob("examples/**/*.md", recursive=True) if "node_modules" not in page]
texts = {page: read(page) for page in pages}
living = {page: text for page, text in texts.items()
          if "docs/notebook/2" not in page and page != "CHANGELOG.md"}

links = 0
for page, text in texts.items():
    prose = re.sub(r"```.*?```", "", text, flags=re.S)
    for link in re.findall(r"\]\(([^) ]+)\)", prose):
        if re.match(r"[a-z]+:", link):
            continue
        links += 1
        path, _, anchor = link.partition("#")
        target = os.path.normpath(os.path.join(os.path.dirname(page), path)) if path else page
        if not os.path.exists(target):
            complain(page, f"the link to {link} leads nowhere")
        elif anchor and target.endswith(".md") and anchor not in anchors(read(target)):
            complain(page, f"{target} has no heading for #{anchor}")

# Files and folders in backquotes. What a build makes is not there yet.
folders = "src|tests|scripts|include|app|cli|web|bench|docs|scenes|examples|cmake|packaging|po"
files = 0
for page, text in living.items():
    for name in re.findall(rf"`((?:{folders})/[\w./*-]+)`", text):
        if re.match(r"web/(dist|lib)\b", name):
            continue
        files += 1
        # A test goes by its name in ctest: web/test_web_page.
        if not glob.glob(name) and not glob.glob(f"tests/{name}.*"):
            complain(page, f"there is no {name}")

# Functions, types and constants of the library, and variables of the build and the scripts.
known = set(re.findall(r"\b(?:skv|SKV|SKVALP)_\w+", "".join(
    read(path) for pattern in ("include/**/*.h", "src/**/*.[ch]", "app/*.[ch]", "web/**/*.[ch]", "web/src/*.js", "tests/**/*.sh", "tests/**/*.c",
                               "*.sh", "scripts/*.sh", "CMakeLists.txt", "cmake/*", "**/CMakeLists.txt")
    for path in glob.glob(pattern, recursive=True)
    if not path.startswith("build") and "test_rules_bite" not in path)))
names = 0
for page, text in living.items():
    for name in set(re.findall(r"\b(?:skv_[a-z0-9_]+|SKV_[A-Z0-9_]+|SKVALP_[A-Z0-9_]+)\b(?![*-])", text)):
        names += 1
        if name not in known and not name.endswith("_"):
            complain(page, f"the sources know no {name}")

# Flags of the program, its scenes and experiments, and the parameters that are set.
program = "".join(read(path) for path in glob.glob("cli/*.[ch]"))
scenes = {os.path.basename(path).split(".")[0] for path in glob.glob("scenes/*.json")}
experiments = {os.path.basename(path)[4:-2].replace("_", "-")
               for path in glob.glob("src/experiments/exp_*.c")}
parameters = set(re.findall(r"^\| `([\w.-]+)` \|", texts["docs/scenes.md"], re.M))
help_text = subprocess.run([build + "/skvalp", "lab", "--help"], capture_output=True, text=True,
                           check=True).stdout
parameters |= set(re.findall(r"[\w-]+\.\w+|^ +(\w+)", help_text, re.M)) | set(
    re.findall(r"[\w-]+\.\w+", help_text))
parameters |= {"particles", "scale", "gravity"}
commands = 0
for page, text in living.items():
    for command in re.findall(r"\bskvalp ((?:run|share|check|lab|bench|replay|scenes)\b[^`\n]*)", text):
        commands += 1
        if 'echo "status' in command:  # shows what happens to a wrong one
            continue
        command = re.split(r"  | #", command)[0]
        for flag in re.findall(r"(?<!\S)--[a-z-]+", command):
            if not re.search(rf'"(--)?{flag[2:]}\b', program):
                complain(page, f"skvalp has no {flag}: skvalp {command}")
        words = command.split()
        word = words[1] if len(words) > 1 else ""
        if re.fullmatch(r"[a-z][a-z-]+", word):
            if words[0] in ("run", "share") and word not in scenes:
                complain(page, f"there is no scene {word}: skvalp {command}")
            if words[0] == "lab" and word not in experiments:
                complain(page, f"there is no experiment {word}: skvalp {command}")
    own = "|".join(experiments | {"fluid"})
    for path in re.findall(rf"(?:--set |`)([a-z][\w-]*\.[a-z_]+)=|`((?:{own})\.[a-z_]+)`", text):
        path = path[0] or path[1]
        if path not in parameters:
            complain(page, f"there is no parameter {path}")

# Comments that cite a page, and a section of it: docs/model.md, "The lattice".
cited = 0
patterns = ["CMakeLists.txt", "*.sh", "scripts/*", ".ci/run", "CHANGELOG.md"] + [
    f"{folder}/**/*.{kind}" for folder in ("src", "include", "app", "cli", "bench", "tests", "web", "cmake")
    for kind in ("c", "h", "sh", "py", "ts", "tsx", "js", "txt", "cmake", "glsl")]
for pattern in patterns:
    for path in glob.glob(pattern, recursive=True):
        if not os.path.isfile(path) or re.search(r"node_modules|web/(dist|lib)/|test_rules_bite", path):
            continue
        text = re.sub(r"\n\s*(\*|//|#)? *", " ", read(path))
        for page, section in re.findall(r'(?<![\w/])(docs/[a-z0-9/-]+\.md)(?:,? "([^"]+)")?', text):
            cited += 1
            if not os.path.exists(page):
                complain(path, f"cites {page}, which is not there")
            elif section and section not in re.findall(r"^#+ (.*)$", read(page), re.M):
                complain(path, f'cites "{section}" of {page}, which has no such heading')

# The constants that the model's page lists.
constants = read("src/model/constants.c") + read("src/calm/load.c")
listed = re.findall(r"^\| `([A-Z_]+)` \| ([\d.]+) \|", texts["docs/model.md"], re.M)
for name, value in listed:
    at = re.search(rf"^#define {name}\s+([\d.]+)f?\b", constants, re.M)
    if not at or float(at[1]) != float(value):
        complain("docs/model.md", f"{name} is {at[1] if at else 'not defined'}, not {value}")
if not listed:
    complain("docs/model.md", "lists no constants")

# The glossary's names in the code are there.
sources = "".join(read(path) for path in glob.glob("src/**/*.[ch]", recursive=True))
glossary = re.search(r"^## Glossary$(.*?)^## ", texts["docs/model.md"], re.S | re.M)[1]
for cell in re.findall(r"^\|.*\| ([^|]*) \|$", glossary, re.M):
    for name in re.findall(r"`(\w+)`", cell):
        if not re.search(rf"\b{name}", sources):
            complain("docs/model.md", f"its glossary has {name}, which is nowhere in src")

# Each experiment has a page, which the lab's index names.
for name in experiments:
    if f"](lab/{name}.md) | `{name}` |" not in texts["docs/lab.md"]:
        complain("docs/lab.md", f"the experiment {name} is not listed with its page")

# The lab's table has the rows and bounds of the committed figures, and its verdicts are right. A bound of a
# ratio IN_SPACINGS is that of 1500 particles in the one, and of 4000 in the other.
spaced = re.findall(r'\{"([^"]+)", "[^"]*", [^,]+, IN_SPACINGS', sources)
committed = [line.split(",") for line in read("tests/experiments/committed.csv").splitlines()[1:]]
table = re.search(r"<!-- lab: begin -->\n\n(.*?)\n\n<!-- lab: end -->", texts["docs/lab.md"], re.S)[1]
rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in table.splitlines()]
if [row[:2] for row in rows[2:]] != [[line[0], line[1].replace(";", ",")] for line in committed]:
    complain("docs/lab.md", "its table has other rows than tests/experiments/committed.csv")
for row, line in zip(rows[2:], committed):
    ratio, power = re.fullmatch(r"±([\d.]+) %", row[2]), 0.5 if row[1] in spaced else 0
    bound = float(line[3]) * (1500 / 4000) ** power
    if ratio and abs(float(ratio[1]) / 100 - bound) > (0.01 * bound if power else 1e-9):
        complain("docs/lab.md", f"{row[0]}, {row[1]}: the bound is {bound}, not {row[2]}")
    for head, cell in zip(rows[0][3:], row[3:]) if ratio else []:
        value, particles = float(cell.strip("*").split(" ")[0]), float(head.split(", ")[1])
        if (abs(value - 1) > bound * (4000 / particles) ** power) != cell.startswith("**") and "±" not in cell:
            complain("docs/lab.md", f"{row[0]}, {row[1]}: {cell} is marked wrongly")

# The notebook's table has every page: it ends with the first line that is no row.
rows = texts["docs/notebook/README.md"].partition("\n|---|---|\n")[2].partition("\n\n")[0]
for page in glob.glob("docs/notebook/2*.md"):
    if f"({os.path.basename(page)}) |" not in rows:
        complain("docs/notebook/README.md", f"{page} is not in the table")

# The short table of the performance page is that of the committed results.
shown = re.search(r"<!-- bench: begin -->\n\n(.*?)\n\n<!-- bench: end -->",
                  texts["docs/performance.md"], re.S)
results = re.search(r"bench/results/([\w-]+)\.md", texts["docs/performance.md"])
digest = subprocess.run(["bash", "scripts/bench-digest.sh", f"bench/results/{results[1]}.csv"],
                        capture_output=True, text=True, check=True).stdout
if not shown or shown[1].strip() != digest.strip():
    complain("docs/performance.md", "its table is not that of bench/results; run scripts/bench.sh")

for text in complaints:
    print(text)
if complaints:
    sys.exit(1)
print(f"pages: {len(pages)} pages; {links} links, {files} files, {names} names, {commands} commands "
      f"and {cited} citations are right")
