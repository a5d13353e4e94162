#!/usr/bin/env python3
"""Line coverage of the kernel rooms by unit tests and scenarios (gcov), from the run of tools/check_sanitizers in
build/asan, which is made first if missing. Each room has a floor in tests/gates/coverage.txt: a lower figure fails, and
so does a floor that is 1 % too low or lower than in CI_BASE (default: the commit before). Lines that no
test reaches are listed in build/asan/uncovered.txt.

What a class declares outside its functions (members with their defaults, defaulted operators) does not count: whether
an object has code for it depends on what was compiled together.

Usage: tools/check_coverage.py [--build FOLDER] [--write-floors]
  --write-floors  raises the floors to today's figures (none falls)"""
import json
import math
import os
import pathlib
import re
import subprocess
import sys

import check_layers
import command_line

ROOT = pathlib.Path(__file__).resolve().parent.parent
FLOORS = ROOT / "tests/gates/coverage.txt"
SLACK = 1.0  # percent that a figure may be above its floor


def room_of(path):
    """The kernel room of a source file, or None: tests and other folders do not count."""
    try:
        where = pathlib.Path(path).resolve().relative_to(ROOT)
    except ValueError:
        return None
    if where.parts[0] not in ("src", "include"):
        return None
    room = check_layers.room_of(where)
    return room if room in check_layers.KERNEL_ROOMS and not check_layers.is_test(where) else None


def counts(build):
    """{file: {line: times run}} of all kernel sources, over every object that was compiled."""
    lines = {}
    data = sorted(build.rglob("*.gcda"))
    for start in range(0, len(data), 20):
        done = subprocess.run(["gcov", "--json-format", "--stdout", *data[start:start + 20]], cwd=build, text=True,
                              capture_output=True, check=True)
        for document in done.stdout.splitlines():
            if not document.startswith("{"):
                continue
            for entry in json.loads(document)["files"]:
                if room_of(str(build / entry["file"])) is None:
                    continue
                file = lines.setdefault(os.path.relpath((build / entry["file"]).resolve(), ROOT), {})
                for line in entry["lines"]:
                    file[line["line_number"]] = file.get(line["line_number"], 0) + line["count"]
    return lines


BLANKED = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'', re.S)
SCOPE = re.compile(r"\b(struct|class|union|namespace)\b[^;{}()]*$")
BODY = re.compile(r"(\)|\bconst|\bnoexcept|\belse|\bdo|\btry|->[^;{}]*)\s*$")


def declarations(text):
    """The lines of a source in classes and namespaces that hold no part of a function's body."""
    text = BLANKED.sub(lambda found: re.sub(r"[^\n]", " ", found[0]), text)
    found, inside, line, since = set(), [], 1, 0  # inside: for each open brace, whether it is within a body
    in_body = False
    for at, sign in enumerate(text):
        if sign == "{":
            before = text[since:at]
            body = BODY.search(before) or (not before.strip() and text[since - 1:since] == "}")  # after `: a{b}`
            inside.append(bool(inside and inside[-1] or body and not SCOPE.search(before)))
            in_body = in_body or inside[-1]
        elif sign == "}" and inside:
            inside.pop()
        elif sign == "\n":
            if not in_body:
                found.add(line)
            line += 1
            in_body = bool(inside) and inside[-1]
        if sign in "{};":
            since = at + 1
    return found


def read(text):
    """{room: floor in percent} of the committed file; the line `goal ROOM PERCENT` is what a room has to reach."""
    floors, goals = {}, {}
    for line in text.splitlines():
        words = line.split()
        if words and words[0] == "goal":
            goals[words[1]] = float(words[2])
        elif words:
            floors[words[0]] = float(words[1])
    return floors, goals


def written(floors, goals):
    lines = [f"{room} {floor:.1f}\n" for room, floor in sorted(floors.items())]
    return "".join(lines + [f"goal {room} {goal:.1f}\n" for room, goal in sorted(goals.items())])


def faults(floors, figures, before):
    """What does not fit: figures below a floor or well above it, rooms without a floor, floors that fell.
    `before`: the floors of the commit that is compared with."""
    sentences = []
    for room in sorted(floors.keys() | figures.keys()):
        floor, figure = floors.get(room), figures.get(room)
        if floor is None or figure is None:
            sentences.append(f"{room}: {'has no floor' if floor is None else 'has a floor and was not measured'}")
        elif figure < floor:
            sentences.append(f"{room}: {figure:.1f} % are below the floor of {floor:.1f} %")
        elif figure > floor + SLACK:
            sentences.append(f"{room}: {figure:.1f} % are well above the floor of {floor:.1f} %: it rises")
    sentences += [f"{room}: the floor fell from {before[room]:.1f} to {floors[room]:.1f} %" for room in sorted(floors)
                  if floors[room] < before.get(room, 0.0)]
    return sentences


def floors_before():
    """The floors of the commit that CI_BASE names (default: the last one), empty where it has none."""
    done = subprocess.run(["git", "show", f"{os.environ.get('CI_BASE', 'HEAD~1')}:{FLOORS.relative_to(ROOT)}"], cwd=ROOT,
                          capture_output=True, text=True)
    return read(done.stdout)[0] if done.returncode == 0 else {}


def main():
    parser = command_line.Parser(__doc__)
    parser.add_argument("--build", type=command_line.folder, default=ROOT / "build/asan")
    parser.add_argument("--write-floors", action="store_true")
    options = parser.parse_args()
    build = options.build.resolve()
    if not any(build.rglob("*.gcda")):
        subprocess.run([ROOT / "tools/check_sanitizers"], check=True, stdout=sys.stderr)
    lines = counts(build)
    rooms = {}
    with open(build / "uncovered.txt", "w", encoding="utf-8") as uncovered:
        for name in sorted(lines):
            text = (ROOT / name).read_text(encoding="utf-8").splitlines()
            declared = declarations("\n".join(text) + "\n")
            room = rooms.setdefault(room_of(str(ROOT / name)), [0, 0])
            for number, times in sorted(lines[name].items()):
                if number in declared:
                    continue
                room[0] += 1
                room[1] += times > 0
                if not times:
                    uncovered.write(f"{name}:{number}: {text[number - 1].strip()}\n")
    floors, goals = read(FLOORS.read_text(encoding="utf-8")) if FLOORS.exists() else ({}, {})
    # Rounded down: the floor that is written is never above what was measured.
    figures = {room: math.floor(1000 * run / n) / 10 for room, (n, run) in rooms.items()}
    for room, (n, run) in sorted(rooms.items()):
        goal = f", goal {goals[room]:.1f}" if room in goals else ""
        print(f"coverage: {room:12} {run:6} of {n:6} lines  {figures[room]:5.1f} %   floor {floors.get(room, 0.0):5.1f}{goal}")
    print(f"coverage: lines that no test reaches: {os.path.relpath(build / 'uncovered.txt', ROOT)}")
    if options.write_floors:
        kept = {room: max(figure, floors.get(room, 0.0)) for room, figure in figures.items()}
        FLOORS.write_text(written(kept, goals), encoding="utf-8")
        floors = kept
    wrong = faults(floors, figures, floors_before())
    for sentence in wrong:
        print(f"coverage: {sentence}")
    if wrong:
        print(f"coverage: floors are in {FLOORS.relative_to(ROOT)}; tools/check_coverage.py --write-floors raises them")
    return 1 if wrong or not figures else 0


if __name__ == "__main__":
    command_line.run(main)
