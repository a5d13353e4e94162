#!/usr/bin/env python3
"""Line coverage of the kernel rooms by all tests (gcov), as the run of tools/check_sanitizers left it in build/asan;
without one that is made first. Prints a table per room; the lines that no test reaches are in
build/asan/uncovered.txt. Usage: tools/check_coverage.py [--floor PERCENT]"""
import argparse
import json
import os
import pathlib
import subprocess
import sys

import check_layers

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = ROOT / "build/asan"


def room_of(path):
    """The kernel room of a source file, or None: tests and other folders do not count."""
    try:
        parts = pathlib.Path(path).resolve().relative_to(ROOT / "src").parts
    except ValueError:
        return None
    kernel = parts[0] in check_layers.KERNEL_ROOMS and not check_layers.is_test(pathlib.Path(path))
    return parts[0] if kernel else None


def counts():
    """{file: {line: times run}} of all kernel sources, over every object that was compiled."""
    lines = {}
    data = sorted(BUILD.rglob("*.gcda"))
    for start in range(0, len(data), 20):
        done = subprocess.run(["gcov", "--json-format", "--stdout", *data[start:start + 20]], cwd=BUILD, text=True,
                              capture_output=True, check=True)
        for document in done.stdout.splitlines():
            if not document.startswith("{"):
                continue
            for entry in json.loads(document)["files"]:
                if room_of(str(BUILD / entry["file"])) is None:
                    continue
                file = lines.setdefault(os.path.relpath((BUILD / entry["file"]).resolve(), ROOT), {})
                for line in entry["lines"]:
                    file[line["line_number"]] = file.get(line["line_number"], 0) + line["count"]
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--floor", type=float, default=0, help="fail below this percentage over all rooms")
    floor = parser.parse_args().floor
    if not any(BUILD.rglob("*.gcda")):
        subprocess.run([ROOT / "tools/check_sanitizers"], check=True, stdout=sys.stderr)
    lines = counts()
    rooms = {}
    with open(BUILD / "uncovered.txt", "w", encoding="utf-8") as uncovered:
        for name in sorted(lines):
            text = (ROOT / name).read_text(encoding="utf-8").splitlines()
            room = rooms.setdefault(name.split("/")[1], [0, 0])
            for number, times in sorted(lines[name].items()):
                room[0] += 1
                room[1] += times > 0
                if not times:
                    uncovered.write(f"{name}:{number}: {text[number - 1].strip()}\n")
    total, covered = (sum(r[i] for r in rooms.values()) for i in (0, 1))
    for room, (n, run) in sorted(rooms.items()):
        print(f"coverage: {room:12} {run:6} of {n:6} lines  {100 * run / n:5.1f} %")
    percent = 100 * covered / total if total else 0
    print(f"coverage: {'all':12} {covered:6} of {total:6} lines  {percent:5.1f} %   (build/asan/uncovered.txt)")
    return 0 if total and percent >= floor else 1


if __name__ == "__main__":
    sys.exit(main())
