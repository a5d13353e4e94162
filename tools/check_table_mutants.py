#!/usr/bin/env python3
"""Tables of the kernel rooms: each row is dropped and each cell of it changed, one at a time, and a test of the room has
to notice (tools/mutate.py). tests/gates/table_rows.txt holds, as hashes, the rows of which that has been seen, and those
that were there before this gate (what was seen of them is in docs/ROOM-mutants.md). Rows that are not in it are new
or changed, and are looked at. Where these are more than LARGEST mutants of a room, that many are taken at random, so
that the time is bounded. A survivor that docs/ROOM-mutants.md does not give the reason of fails.

Usage: tools/check_table_mutants.py [--write [--unseen]] [ROOM...]
  --write  looks at all mutants of the new rows, and records the rows that have no survivor without a reason;
           rows that do not exist any more leave the list
  --unseen records all rows without a look"""
import concurrent.futures
import hashlib
import random
import re
import resource
import sys

import check_layers
import command_line
from mutate import MEMORY, listed
from mutation.room import Room
from mutation.sources import ROOT, SRC, mutants_of_room

LARGEST = 60  # mutants of a room
TABLE_HEAD = re.compile(r"\bconstexpr [\w:<>, ]+ (\w+)(?:\[\])? = ")
LIST = ROOT / "tests/gates/table_rows.txt"
HEAD = """\
# Rows of tables that need no look: a test notices when they are dropped and when one of their cells is changed, or they
# were there before the gate. File, hashes of rows. Written by tools/check_table_mutants.py --write.
"""


def hashes_of_rows(mutants):
    """{id of a mutant: (file, hash of the row that it changes)}: the table's name and what is in the line, its blanks
    and comment apart."""
    rows = {}  # of a file: line -> hash
    found = {}
    for m in mutants:
        if m.path not in rows:
            table, rows[m.path] = "", {}
            for number, line in enumerate(m.path.read_text(encoding="utf-8").split("\n"), 1):
                head = TABLE_HEAD.search(line)
                table = head[1] if head else table
                row = " ".join([table, *re.sub(r"//.*", "", line).split()])
                rows[m.path][number] = hashlib.sha256(row.encode()).hexdigest()[:8]
        found[m.id] = (m.name, rows[m.path][m.line])
    return found


def read(text):
    """{file: set of hashes} of the list."""
    rows = {}
    for line in text.splitlines():
        if line and not line.startswith("#"):
            name, *hashes = line.split()
            rows.setdefault(name, set()).update(hashes)
    return rows


def written(rows):
    text = HEAD
    for name, hashes in sorted(rows.items()):
        hashes = sorted(hashes)
        for i in range(0, len(hashes), 10):
            text += " ".join([name, *hashes[i:i + 10]]) + "\n"
    return text


def rooms_with_tests():
    return [room for room in check_layers.KERNEL_ROOMS if any((SRC / room).glob("*_test.cpp"))]


def survivors(name, wanted, jobs, largest=None):
    """The mutants of these rows that no test notices and the document does not account for; at most of `largest`."""
    room = Room(name, jobs)
    known = listed(name)
    of = hashes_of_rows(m for m in room.mutants if m.row)
    mutants = [m for m in room.mutants if m.row and of[m.id] in wanted]
    if largest and len(mutants) > largest:
        print(f"table mutants: {name}: {largest} of {len(mutants)}, at random", flush=True)
        mutants = random.Random(1).sample(mutants, largest)
    # A mutant may ask for memory without end, and it may crash often.
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    room.wanted = mutants  # few: what else could be changed need not be in the build
    room.prepare()
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        verdicts = list(zip(mutants, pool.map(room.judge, mutants)))
    left = [m for m, verdict in verdicts if verdict == "survived" and (m.name, m.what) not in known]
    print(f"table mutants: {name}: {len(verdicts)} mutants in {len(wanted)} new rows, {len(left)} survived", flush=True)
    for m in left:
        print(f"survived: {m}", flush=True)
    return left


def main(arguments=None):
    parser = command_line.Parser(__doc__)
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--unseen", action="store_true")
    parser.add_argument("rooms", nargs="*")
    options = parser.parse_args(arguments)
    rooms = rooms_with_tests()
    unknown = set(options.rooms) - set(rooms)
    if unknown:
        sys.exit(f"table mutants: no room with tests: {' '.join(sorted(unknown))}")
    jobs = command_line.jobs()
    seen = read(LIST.read_text(encoding="utf-8")) if LIST.exists() else {}
    there = {}
    total = new = failed = 0
    for name in rooms:
        mutants = mutants_of_room(SRC / name, [SRC / other for other in rooms if other != name])
        of = hashes_of_rows(m for m in mutants if m.row)
        rows = set(of.values())
        total += len(rows)
        for file, row in rows:
            there.setdefault(file, set()).add(row)
        wanted = {(file, row) for file, row in rows if row not in seen.get(file, ())}
        if not wanted or options.rooms and name not in options.rooms:
            continue
        new += len(wanted)
        left = [] if options.unseen else survivors(name, wanted, jobs, None if options.write else LARGEST)
        failed += len(left)
        bad = {hashes_of_rows([m])[m.id] for m in left}
        if options.write:
            for file, row in wanted - bad:
                seen.setdefault(file, set()).add(row)
            LIST.write_text(written(seen), encoding="utf-8")
    if options.write:
        kept = {file: hashes & there.get(file, set()) for file, hashes in seen.items()}
        LIST.write_text(written({file: hashes for file, hashes in kept.items() if hashes}), encoding="utf-8")
    print(f"table mutants: {total} rows, {new} of them new or changed, {failed} mutants survived")
    if new and not failed and not options.write:
        print("table mutants: tools/check_table_mutants.py --write records the rows, so that they are not looked at again")
    return 1 if failed else 0


if __name__ == "__main__":
    command_line.run(main)
