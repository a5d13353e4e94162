#!/usr/bin/env python3
"""Layering: which room may include which (docs/architecture.md), and what a kernel room may use of the
standard library. Usage: tools/check_layers.py [SOURCE_ROOT]; prints FILE:LINE: reason, exit 1."""
import pathlib
import re

import command_line

KERNEL_ROOMS = ("base terms lang airgap train position modes port brakes balise track radio sdm protection procedures "
                "driver kernel").split()
BELOW_KERNEL = set(KERNEL_ROOMS) - {"kernel"}
# Code under the rules of a kernel room that is not part of the kernel, and may contain text.
PURE_ROOMS = ["dmi"]

MAY_INCLUDE = {
    "base": set(),
    # The vocabulary: every room above may include it.
    "terms": {"base"},
    **{room: {"base", "terms"} for room in ("lang", "airgap", "train", "position", "modes", "brakes")},
    **{room: {"base", "terms", "lang"} for room in ("balise", "track", "radio")},
    "sdm": {"base", "terms", "train"},
    "protection": {"base", "terms", "lang", "track", "position"},
    "procedures": {"base", "terms", "modes"},
    "driver": {"base", "terms", "modes"},
    # The inputs and outputs of the kernel: clients of the kernel need only this.
    "port": {"base", "terms", "train", "modes"},
    "kernel": BELOW_KERNEL,
    # The driver-machine interface: what the on-board gives its display, drawn; what the driver does, for the on-board.
    "dmi": {"base", "terms", "train", "port"},
    # Their texts: no kernel room may include them.
    "texts": {"base", "terms", "train", "modes", "driver", "port"},
    "sim": BELOW_KERNEL | {"texts"},
    # A line and a train file are values of the simulated world (docs/decisions): io reads them into sim's types.
    "io": BELOW_KERNEL | {"kernel", "texts", "sim"},
    # Curves and limits of many trains at once, vectorised.
    "batch": {"base", "terms", "train", "sdm"},
    "curves": {"base", "terms", "train", "track", "position", "sdm", "texts", "io", "batch"},
    # Cycles by the clock and hand-over between threads, of values of any type.
    "realtime": set(),
    "run": BELOW_KERNEL | {"kernel", "texts", "sim", "io", "realtime", "dmi", "paint"},
    "serve": BELOW_KERNEL | {"kernel", "texts", "sim", "io", "realtime", "run"},
    "language": {"base", "terms", "lang", "airgap", "texts", "io"},
    "check": BELOW_KERNEL | {"kernel", "texts", "sim", "io", "run"},
    "matrix": BELOW_KERNEL | {"kernel", "texts", "sim", "io", "run"},
    "explain": BELOW_KERNEL | {"kernel", "texts", "sim", "io", "run"},
    # Pictures of the display list.
    "paint": {"base", "terms", "port", "dmi", "io"},
    # The screen of a replay: the unit with its display.
    "screen": BELOW_KERNEL | {"kernel", "texts", "sim", "io", "run", "dmi", "paint"},
    # A journey driven from outside: the page of `evc cab`.
    "ride": BELOW_KERNEL | {"kernel", "texts", "sim", "io", "dmi", "paint", "screen"},
    "cab": {"base", "run", "io", "ride"},
    # Random numbers: functions of a counter, without state.
    "random": set(),
    # Many cases of one description: threads that compute, one that writes.
    "sweep": BELOW_KERNEL | {"kernel", "texts", "sim", "io", "run", "curves", "random"},
    # The commands as functions of Python.
    "python": BELOW_KERNEL | {"kernel", "texts", "sim", "io", "run", "curves", "language", "sweep", "batch"},
    # The sweep by the ranks of a cluster: the program evc-mpi.
    "cluster": {"app", "sweep", "run", "io"},
    # The guaranteed deceleration of a train by the Monte Carlo method: its charts are drawn as those of curves.
    "deceleration": {"base", "terms", "train", "io", "curves", "random"},
    "app": {"cab", "sweep", "deceleration", "screen", "check", "curves", "explain", "matrix", "run", "serve", "language", "io"},
    # Interfaces for hosts in C++ and C in addition to the kernel and the curves.
    "embed": BELOW_KERNEL | {"kernel", "texts", "sim", "io"},
    "capi": BELOW_KERNEL | {"kernel", "texts", "sim", "io", "embed"},
}

# The stages of a cycle, in their order, folders of src/kernel: a stage sees its own headers, what the kernel's stages
# share, and of the stages before it the result alone. What they share sees no stage; step.cpp joins them.
STAGES = {"intake": "received.h", "decide": "decided.h", "supervise": "supervised.h", "report": None}

# Public headers (docs/embedding.md): those of a room are in include/openevc/ROOM; these in the folder above belong to a room too.
PUBLIC = pathlib.PurePath("include/openevc")
PUBLIC_ROOM = {"evc.h": "kernel", "curves.h": "sdm", "language.h": "embed", "sim.h": "embed", "openevc.h": "capi"}

# What a kernel room may take from the standard library: headers that need no heap, no clock, no file,
# no thread and no locale. What they could still pull in is caught by tools/check_symbols.
KERNEL_STANDARD = set("algorithm array bit climits cmath compare concepts cstddef cstdint cstring initializer_list "
                      "iterator limits new numeric optional span string_view tuple type_traits utility version".split())

INCLUDE = re.compile(r'\s*#\s*include\s*(?:"([^"]+)"|<([^>]+)>)')
FORBIDDEN = [
    (re.compile(r"\bthread_local\b"), "state outside State"),
    (re.compile(r"\b(?:dynamic_cast|typeid)\b"), "run-time types"),
    (re.compile(r"\b(?:throw|try|catch)\b(?=[\s({;])"), "exceptions"),
    (re.compile(r"\bstd::(?:a?(?:sin|cos|tan)h?|exp2?|log(?:10|2|1p)?|pow|cbrt|hypot|fma|atan2|fmod|l?l?round|rint|erf)\("),
     "libm: only + - * / sqrt give the same bits everywhere"),
]


def is_test(path):
    """Tests and the headers that only tests include."""
    return path.stem.endswith(("_test", "testing")) or path.stem.startswith("test_")


def without_comments(text):
    """The text with comments and string literals blanked, line breaks kept."""
    pattern = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', re.S)
    return pattern.sub(lambda m: re.sub(r"[^\n]", " ", m[0]), text)


def room_of(where):
    """The room of a source file or header, named from the root: src/sdm/rebuild.cpp, include/openevc/sdm/inputs.h."""
    parts = where.parts[len(PUBLIC.parts) if where.is_relative_to(PUBLIC) else 1:]
    return PUBLIC_ROOM.get(parts[0], parts[0])


def stage_breach(where, own):
    """Why this file of src/kernel may not include that header of a stage, or None."""
    include = own.split("/")
    if where.parts[:2] != ("src", "kernel") or len(include) != 3 or include[0] != "kernel":
        return None
    stages = list(STAGES)
    stage, header = include[1:]
    if stage not in STAGES:
        return f"{stage} is not in the table of stages"
    if len(where.parts) == 3:
        return None if where.name == "step.cpp" or is_test(where) else f"only step.cpp may include stage {stage}"
    mine = where.parts[2]
    if mine == stage:
        return None
    if mine not in STAGES or stages.index(mine) < stages.index(stage):
        return f"stage {mine} may not include stage {stage}"
    return None if header == STAGES[stage] else f"stage {mine} may include of stage {stage} its result alone"


def check(root):
    """All breaches below root/src and in the public headers, as 'file:line: reason'."""
    breaches = []
    for path in sorted([*(pathlib.Path(root) / "src").rglob("*"), *(root / PUBLIC).rglob("*")]):
        if path.suffix not in (".h", ".cpp", ".hpp", ".cc", ".inc"):
            continue
        where = path.relative_to(root)
        room = room_of(where)
        public = where.is_relative_to(PUBLIC)
        if room not in MAY_INCLUDE:
            breaches.append(f"{where}:1: room '{room}' is not in the table of rooms")
            continue
        kernel_code = room in KERNEL_ROOMS + PURE_ROOMS and not is_test(path)
        text = path.read_text(encoding="utf-8")
        for number, line in enumerate(text.splitlines(), 1):
            found = INCLUDE.match(line)
            if not found:
                continue
            own, system = found.groups()
            if own:
                if public and not (root / "include" / own).is_file():
                    breaches.append(f'{where}:{number}: "{own}" is no public header: "openevc/..." is, in include/')
                own = own.removeprefix("openevc/")
                other = PUBLIC_ROOM.get(own, own.split("/")[0])
                if "/" not in own and own not in PUBLIC_ROOM:
                    breaches.append(f'{where}:{number}: "{own}" is not named with its room')
                elif other == "texts" and is_test(path):
                    continue  # tests say in words what they found
                elif other != room and other not in MAY_INCLUDE[room]:
                    breaches.append(f"{where}:{number}: {room} may not include {other}")
                elif why := stage_breach(where, own):
                    breaches.append(f"{where}:{number}: {why}")
            elif kernel_code and system not in KERNEL_STANDARD:
                breaches.append(f"{where}:{number}: <{system}> has no place in a kernel room")
        if kernel_code:
            for number, line in enumerate(without_comments(text).splitlines(), 1):
                for pattern, why in FORBIDDEN:
                    if pattern.search(line):
                        breaches.append(f"{where}:{number}: {why}: {line.strip()}")
    return breaches


def main():
    parser = command_line.Parser(__doc__)
    parser.add_argument("root", nargs="?", type=command_line.folder, default=pathlib.Path(__file__).resolve().parent.parent)
    root = parser.parse_args().root.resolve()
    breaches = check(root)
    for breach in breaches:
        print(breach)
    print(f"layers: {len(breaches)} breaches")
    return 1 if breaches else 0


if __name__ == "__main__":
    command_line.run(main)
