#!/usr/bin/env python3
"""Rows and cells of tables that changed since CI_BASE (default: the commit before) are changed one at a time; a test of
their room has to notice each (tools/mutate.py). A survivor that docs/ROOM-mutants.md does not list fails. Where more
changed than LARGEST, that many are taken at random, so that the time is bounded.
Usage: tools/check_table_mutants.py"""
import os
import subprocess
import sys

import check_layers
from mutation.sources import ROOT, SRC, changed_lines, mutants_of_room

LARGEST = 60  # mutants of a room


def changed_rows(lines):
    """{room: number of mutants in changed rows} of the kernel rooms."""
    found = {}
    rooms = [room for room in check_layers.KERNEL_ROOMS if (SRC / room).is_dir()]
    for room in rooms:
        if not any(name.startswith(f"src/{room}/") for name in lines):
            continue
        rows = [m for m in mutants_of_room(SRC / room, [SRC / other for other in rooms if other != room])
                if m.row and m.line in lines.get(f"src/{room}/{m.path.name}", ())]
        if rows:
            found[room] = len(rows)
    return found


def main():
    base = os.environ.get("CI_BASE", "HEAD~1")
    rooms = changed_rows(changed_lines(base))
    failed = []
    for room, number in rooms.items():
        words = ["--sample", str(LARGEST)] if number > LARGEST else []
        print(f"table mutants: {room}: {number} in rows that changed since {base}", flush=True)
        done = subprocess.run([ROOT / "tools/mutate.py", room, "--rows", "--changed", base, *words])
        if done.returncode:
            failed.append(room)
    print(f"table mutants: {len(rooms)} rooms with changed tables, {len(failed)} with survivors {' '.join(failed)}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
