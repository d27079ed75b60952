#!/usr/bin/env python3
"""Writes the core library as two files, skvalp.c and skvalp.h, into a folder.

Usage: scripts/amalgamate.py FOLDER

skvalp.c holds the platforms, the model, the terrain, both solvers, the world and the measuring, and compiles
alone: cc -O2 -c skvalp.c; programs are linked with -lm -pthread. Invariant: the code is that of
src/. What is file-local there and bears the same name in two files gets its file's name in front.
The rows' kernels stand there once per instruction set, each with its own names, as the build
compiles them once per instruction set.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
LAYERS = ["base", "model", "camera", "terrain", "solver", "calm", "world", "measure"]
PUBLIC = ROOT / "include/skvalp/skvalp.h"
KERNELS = ROOT / "src/solver/rows/kernels.c"
SIMD = ROOT / "src/base/simd.h"
PLATFORMS = {
    "windows": "defined(_WIN32)",
    "posix": "!defined(_WIN32)",
}

# Name, condition, macros that select it in simd.h and those that would select another, and GCC's and
# clang's target; the widest last.
SETS = [
    ("scalar", None, ["SKV_SIMD_SCALAR"], [], None),
    ("base", None, [], [], None),
    ("avx2", "defined(SKV_HAVE_AVX2)", ["__AVX2__"], ["__AVX512DQ__"], "avx2"),
    ("avx512", "defined(SKV_HAVE_AVX512)", ["__AVX2__", "__AVX512DQ__"], [],
     "avx512f,avx512dq,avx512vl"),
]

HEAD = """/* Skvalp's core in one file; see skvalp.h. Written by scripts/amalgamate.py from the sources.
 *
 *   cc -O2 -c skvalp.c
 *
 * Link programs with -lm -pthread. All instruction sets are inside; the one that suits the processor
 * is chosen at run time, and all give the same bits. That needs IEEE arithmetic: -ffast-math is
 * refused, and contraction into fused operations is switched off here.
 */
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off")
#endif
#if !defined(_POSIX_C_SOURCE) && !defined(_WIN32)
#define _POSIX_C_SOURCE 200809L
#endif
#define SKV_HAVE_SCALAR
#if defined(__x86_64__) && !defined(_WIN32)
#define SKV_HAVE_AVX2
#define SKV_HAVE_AVX512
#endif
#include "skvalp.h"

"""

INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)[>"].*\n', re.M)
GUARD = re.compile(r"^#ifndef (\w+_H)\n#define \1\n(.*)^#endif\n?\Z", re.M | re.S)
# Comments, texts and characters: in them no name is replaced.
OPAQUE = r'/\*.*?\*/|//[^\n]*|"(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])*\''


def resolve(name, folder):
    """The file that an include names; None for a system header."""
    for base in (ROOT / "src", ROOT / "include", folder):
        if (base / name).is_file():
            return (base / name).resolve()
    return None


def text_of(path):
    """A file without its include guard."""
    text = path.read_text()
    guard = GUARD.search(text)
    return text[: guard.start()] + guard.group(2) if guard else text


def is_table(path):
    """Whether a file is meant to be included many times: it has no guard."""
    return not GUARD.search(path.read_text())


def included(match, folder):
    """What stands in place of an include."""
    target = resolve(match.group(2), folder)
    if not target:
        return match.group(0)
    return target.read_text() if is_table(target) else ""


def includes(path):
    found = []
    for match in INCLUDE.finditer(path.read_text()):
        target = resolve(match.group(2), path.parent)
        if target and not is_table(target):
            found.append(target)
    return found


def file_local_names(text):
    """The names of its own that a file defines at its outermost level, macros included; those with
    the project's prefix are the same thing everywhere."""
    bare = re.sub(OPAQUE, " ", text, flags=re.S)
    names = set(re.findall(r"^[ \t]*#[ \t]*define[ \t]+(\w+)", bare, re.M))
    names |= set(re.findall(r"^(?:static|V8_INLINE|VARIANT|RARE)\b[^=;({]*?\b(\w+)(?:\[[^=;]*\])?\s*(?:\(|=|;)",
                            re.sub(r"__attribute__\(\(\w+\)\)", "", bare), re.M))
    names |= set(re.findall(r"^(?:typedef )?(?:struct|union|enum) (\w+) \{", bare, re.M))
    names |= set(re.findall(r"^typedef [^{};]*?\b(\w+)(?:\([^;]*\)|\[[^;]*\])?;", bare, re.M))
    names |= set(re.findall(r"^\} (\w+);", bare, re.M))
    for body in re.findall(r"^(?:typedef )?enum[^{;]*\{([^}]*)\}", bare, re.M):
        names |= set(re.findall(r"(?:^|,)\s*(\w+)", body))
    return {name for name in names if not name.lower().startswith("skv_")}


def rename(text, names, new, header_tags=()):
    """Replaces names, but not in comments and texts, and not where they are a member's, or a
    structure's that a header of the file names."""
    masked = re.sub(OPAQUE, lambda m: " " * len(m.group(0)), text, flags=re.S)
    bodies = [m.span(1) for m in re.finditer(r"^(?:typedef )?(?:struct|union)[^{;]*\{(.*?)^\}",
                                             masked, re.M | re.S)]
    out, done = [], 0
    for match in re.finditer(r"(?P<access>\.\s*|->\s*)?\b(?P<name>[A-Za-z_]\w*)"
                             r"(?=(?P<declarator>(?:\[[^\]]*\])*\s*[,;])?)", masked):
        start, end = match.span("name")
        member = match.group("access") or masked[:start].endswith("struct ") and \
            match.group("name") in header_tags or (
            match.group("declarator") and any(a <= start < b for a, b in bodies))
        if match.group("name") in names and not member:
            out += [text[done:start], new(text[start:end])]
            done = end
    return "".join(out) + text[done:]


class Amalgamation:
    def __init__(self):
        self.out = []
        self.seen = set()

    def emit(self, path, text):
        self.out.append(f"\n/* ---- {path.relative_to(ROOT)} ---- */\n\n{text.strip()}\n")

    def header(self, path):
        """A header and, before it, those that it includes, each once."""
        if path in self.seen:
            return
        self.seen.add(path)
        if ROOT / "include" in path.parents:
            return
        for needed in includes(path):
            self.header(needed)
        self.emit(path, self.without_own_includes(path, text_of(path)))

    def without_own_includes(self, path, text):
        return INCLUDE.sub(lambda m: included(m, path.parent), text)

    def source(self, path, clashing, condition=None):
        for needed in includes(path):
            self.header(needed)
        text = self.without_own_includes(path, path.read_text())
        place = f"{path.parent.name}_{path.stem}"
        text = rename(text, file_local_names(text) & clashing, lambda name: f"{place}_{name}",
                      {tag for header in includes(path)
                       for tag in re.findall(r"\bstruct (\w+)", header.read_text())})
        macros = re.findall(r"^#[ \t]*define[ \t]+(\w+)", text, re.M)
        text += "".join(f"#undef {name}\n" for name in dict.fromkeys(macros))
        if condition:
            text = f"#if {condition}\n\n{text.strip()}\n\n#endif\n"
        self.emit(path, text)

    def kernels(self):
        """One source, once per instruction set, as are the headers that stand on simd.h."""
        many = []

        def visit(path):
            """Whether simd.h stands below; those above it come after it."""
            below = [visit(needed) for needed in includes(path)]
            repeated = path == SIMD or any(below)
            if repeated and path not in many:
                many.append(path)
            elif not repeated and path.suffix == ".h":
                self.header(path)
            return repeated

        visit(KERNELS)
        self.out.append("\n#if defined(__x86_64__)\n#include <immintrin.h>\n#endif\n")
        names = set()
        for path in many:
            names |= file_local_names(text_of(path))
        for set_name, condition, chosen, others, target in SETS:
            self.out.append(f"\n/* ==== the rows' kernels: {set_name} ==== */\n")
            if condition:
                self.out.append(f"#if {condition}\n")
            if target:
                self.out.append(
                    "#if defined(__clang__)\n"
                    f'#pragma clang attribute push(__attribute__((target("{target}"))), '
                    "apply_to = function)\n#else\n#pragma GCC push_options\n"
                    f'#pragma GCC target("{target}")\n#endif\n')
            for path in many:
                text = self.without_own_includes(path, text_of(path))
                text = re.sub(r"\bSKV_ROW_KERNELS\b", f"skv_row_kernels_{set_name}", text)
                text = rename(text, names, lambda name: f"{name}_{set_name}")
                for macro in chosen + others:
                    yes, no = ("1", "0") if macro in chosen else ("0", "1")
                    text = re.sub(rf"!defined\({macro}\)", no, text)
                    text = re.sub(rf"defined\({macro}\)", yes, text)
                self.emit(path, text)
            if target:
                self.out.append("\n#if defined(__clang__)\n#pragma clang attribute pop\n#else\n"
                                "#pragma GCC pop_options\n#endif\n")
            if condition:
                self.out.append("#endif\n")


def public_header():
    seen, out = set(), []

    def visit(path):
        if path in seen:
            return
        seen.add(path)
        for needed in includes(path):
            visit(needed)
        out.append(INCLUDE.sub(
            lambda m: m.group(0) if resolve(m.group(2), path.parent) is None else "",
            text_of(path)).strip())

    visit(PUBLIC)
    return ("/* Skvalp's core interface in one file, for skvalp.c. Written by scripts/amalgamate.py "
            "from the\n * headers. */\n#ifndef SKVALP_SKVALP_H\n#define SKVALP_SKVALP_H\n\n"
            + "\n\n".join(out) + "\n\n#endif\n")


def main():
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    sources = []
    for layer in LAYERS:
        sources += sorted(p for p in (ROOT / "src" / layer).rglob("*.c")
                          if p != KERNELS and "wasm" not in p.parts)
    times = {}
    for path in sources:
        for name in file_local_names(path.read_text()):
            times[name] = times.get(name, 0) + 1
    headers = set()
    for layer in LAYERS:
        for path in (ROOT / "src" / layer).rglob("*.h"):
            headers |= file_local_names(text_of(path))
    clashing = {name for name, count in times.items() if count > 1} | (headers & set(times))

    whole = Amalgamation()
    for path in sources:
        if path.parent.name not in PLATFORMS:
            whole.source(path, clashing)
    whole.kernels()
    # Last, for windows.h takes common words away.
    for path in sources:
        if path.parent.name in PLATFORMS:
            whole.source(path, clashing, PLATFORMS[path.parent.name])
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    license_text = "/* " + (ROOT / "LICENSE").read_text().strip().replace("\n", "\n * ") + "\n */\n"
    license_text = re.sub(r" +\n", "\n", license_text)
    (folder / "skvalp.h").write_text(license_text + public_header())
    (folder / "skvalp.c").write_text(license_text + HEAD + "".join(whole.out))


if __name__ == "__main__":
    main()
