#!/usr/bin/env python3
"""Mutation testing of one room. Every rule of src/ROOM is changed in one place at a
time (a mutant), and the room's tests are run with it. A mutant that no test notices is a survivor: a test is
missing, or the mutant is equivalent (then docs/ROOM-mutants.md lists it with the reason).

Operators: row (drops a row of a table), cell (another enumerator), word (of a row of text another one), compare (< <= and so on), logic (&& ||), negate
(a condition), sign (+ -), factor (* /), minmax, number (a constant), truth (true false), delete (a statement).
All mutants are in one build, an instrumented copy of the room in which an environment variable selects the active one
(tools/mutation/schema.py); the few that cannot be in it are built alone. Only tests in which the mutant makes a
difference run (a comparison that never meets its boundary makes none), quick ones first; the first one that fails is
enough, and a mutant that takes four times the time is killed by that. Lines with EVC_REQUIRE
are not changed. Nothing is written outside build/mutants.

Usage: tools/mutate.py ROOM [--rows | --rest] [--sample N] [--alone N] [--seed S] [--files PATTERNS] [--survivors] [--behaviour]
                            [--changed COMMIT] [--resume] [--jobs N] [--build NAME] [--check] [--list] [--page]
  --rows       all rows of the constexpr tables and nothing else (operators row, cell, word, number, truth there);  --rest: all but these
  --behaviour  without the tests that include the changed header themselves
  --sample N   N random mutants;  --alone N: N random ones of those that have to be built alone, the others are not run;  --files: only files whose name matches one of PATTERNS (a,b*), in this order
  --changed    only in lines that changed since COMMIT
  --survivors  those of the last run again;  --resume: goes on where the last run was stopped. The other results stay
  --build      builds and results in build/mutants/NAME instead of build/mutants/ROOM, for two runs at a time
  --page       writes docs/ROOM-mutants.md from this run; the reasons that are in it are kept
  --check      builds each mutant alone as well and prints where the verdicts differ
Exit status 1 where a mutant survives that the document does not list."""
import collections
import concurrent.futures
import json
import os
import random
import resource
import sys
import time

import command_line
from mutation.page import NO_REASON, reasons, write_page
from mutation.room import Room
from mutation.sources import ROOT, changed_lines, in_order

MEMORY = 2 << 30


def listed(room):
    """What docs/ROOM-mutants.md accounts for: keys without line numbers."""
    document = ROOT / "docs" / f"{room}-mutants.md"
    known = reasons(document.read_text(encoding="utf-8")) if document.exists() else {}
    return {key for key, why in known.items() if why != NO_REASON}


def results_file(room, options):
    return room.out / ("results-rows.jsonl" if options.rows else "results.jsonl")


def read_results(room, options):
    return [json.loads(line) for line in results_file(room, options).read_text().splitlines()]


def choose(room, options):
    mutants = [m for m in room.mutants if (m.row if options.rows else not (m.row and options.rest))]
    if options.files:
        mutants = in_order(mutants, options.files.split(","))
    if options.changed:
        lines = changed_lines(options.changed)
        mutants = [m for m in mutants if m.line in lines.get(f"src/{m.file}", ())]
    if options.survivors:
        last = {r["key"] for r in read_results(room, options) if r["verdict"] == "survived"}
        mutants = [m for m in mutants if m.key() in last]
    if options.sample and options.sample < len(mutants):
        mutants = random.Random(options.seed).sample(mutants, options.sample)
    return mutants


def check(room, mutants):
    """Both ways for every mutant that both can take."""
    mutants = [m for m in mutants if m.id in room.in_schema]
    with concurrent.futures.ThreadPoolExecutor(room.jobs) as pool:
        pairs = zip(mutants, pool.map(room.judge, mutants), pool.map(room.judge_alone, mutants))
        different = 0
        for m, together, alone in pairs:
            if together.split(":")[0] != alone.split(":")[0]:
                different += 1
                print(f"different: {m}: {together}; built alone: {alone}", flush=True)
    print(f"mutate {room.name}: {len(mutants)} mutants both ways, {different} differ")
    return 1 if different else 0


def still_to_judge(room, mutants, options):
    """The mutants that have no verdict yet, and the results of the last run that stay (--resume, --survivors)."""
    if not (options.resume or options.survivors):
        return mutants, []
    last = read_results(room, options)
    if options.survivors:
        again = {m.key() for m in mutants}
        return mutants, [r for r in last if r["key"] not in again]
    # What has the same words in the file as many times as then has its verdict, whatever its line is now.
    before, there = collections.defaultdict(dict), collections.defaultdict(list)
    for r in last:
        before[r["key"]][r["line"]] = r
    for m in room.mutants:
        there[m.key()].append(m)
    kept = []
    for key, same in there.items():
        results = [r for _, r in sorted(before[key].items())]
        if len(results) == len(same):
            kept += [r | {"line": m.line} for r, m in zip(results, sorted(same, key=lambda m: m.line))]
    done = {(r["key"], r["line"]) for r in kept}
    return [m for m in mutants if (m.key(), m.line) not in done], kept


def judge_all(room, mutants, options):
    known = listed(room.name)
    counts = {}
    unknown = 0
    begin = time.monotonic()
    mutants, kept = still_to_judge(room, mutants, options)
    with open(results_file(room, options), "w", encoding="utf-8") as results, \
            concurrent.futures.ThreadPoolExecutor(room.jobs) as pool:
        results.writelines(json.dumps(r) + "\n" for r in kept)
        verdicts = pool.map(lambda m: room.judge(m, options.behaviour), mutants)
        for number, (m, verdict) in enumerate(zip(mutants, verdicts), 1):
            counts[verdict] = counts.get(verdict, 0) + 1
            results.write(json.dumps({"key": m.key(), "file": m.name, "line": m.line, "operator": m.operator,
                                      "what": m.what, "verdict": verdict}) + "\n")
            results.flush()
            if verdict == "survived":
                accounted = (m.name, m.what) in known
                counts["survived, listed"] = counts.get("survived, listed", 0) + accounted
                unknown += not accounted
                if not accounted:
                    print(f"survived: {m}", flush=True)
            if number % 100 == 0:
                print(f"mutate: {number} of {len(mutants)}, {time.monotonic() - begin:.0f} s", file=sys.stderr, flush=True)
    unknown += sum(r["verdict"] == "survived" and (r["file"], r["what"]) not in known for r in kept)
    counts.update(collections.Counter(counts) + collections.Counter(r["verdict"] for r in kept))
    killed = sum(n for verdict, n in counts.items() if verdict.startswith("killed"))
    print(f"mutate {room.name}: {len(mutants) + len(kept)} mutants, {counts.get('does not compile', 0)} do not compile, "
          f"{killed} killed, {counts.get('survived', 0)} survived, {unknown} of them not accounted for, "
          f"{time.monotonic() - begin:.0f} s")
    for verdict in sorted(counts):
        print(f"  {counts[verdict]:5} {verdict}")
    return 1 if unknown else 0


def main():
    parser = command_line.Parser(__doc__)
    parser.add_argument("room")
    parser.add_argument("--rows", action="store_true")
    parser.add_argument("--rest", action="store_true")
    parser.add_argument("--sample", type=command_line.whole(0), default=0)
    parser.add_argument("--seed", type=command_line.whole(0), default=1)
    parser.add_argument("--alone", type=command_line.whole(0))
    parser.add_argument("--files")
    parser.add_argument("--changed", metavar="COMMIT")
    parser.add_argument("--behaviour", action="store_true")
    parser.add_argument("--survivors", action="store_true")
    parser.add_argument("--resume", action="store_true")
    parser.add_argument("--jobs", type=command_line.whole(1), default=os.cpu_count())
    parser.add_argument("--build")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--page", action="store_true")
    options = parser.parse_args()
    room = Room(options.room, options.jobs, options.build)
    mutants = choose(room, options)
    if options.list:
        for m in mutants:
            print(m)
        print(f"mutate: {len(mutants)} mutants")
        return 0
    # A mutant may ask for memory without end, and it may crash often.
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    if options.changed:
        room.wanted = mutants  # few: what else could be changed need not be in the build
    room.prepare()
    mutants.sort(key=lambda m: m.id not in room.in_schema)  # those that take long come last
    alone = sum(m.id not in room.in_schema for m in mutants)
    left_out = []
    if options.alone is not None and alone > options.alone:
        together = mutants[:len(mutants) - alone]
        taken = random.Random(options.seed).sample(mutants[len(together):], options.alone)
        left_out = [m for m in mutants[len(together):] if m not in taken]
        mutants, alone = together + taken, len(taken)
    slow = ", ".join(f"{names[0]} {room.seconds[names[0]]:.1f} s" for names in room.steps[1:])
    print(f"mutate {room.name}: {len(mutants)} mutants, {alone} of them built alone; {len(room.steps[0])} quick tests "
          f"{sum(map(room.seconds.get, room.steps[0])):.1f} s; {slow}", file=sys.stderr, flush=True)
    if options.check:
        return check(room, mutants)
    status = judge_all(room, mutants, options)
    if options.page:
        results = read_results(room, options)
        done = {(r["key"], r["line"]) for r in results}  # by the run that this one resumed
        left_out = [m for m in left_out if (m.key(), m.line) not in done]
        results += [{"file": m.name, "verdict": "not run"} for m in left_out]
        how = f" (a sample: --sample {options.sample} --seed {options.seed})" if options.sample else ""
        if left_out:
            how += f"; of {alone + len(left_out)} that have to be built alone a sample (--alone {alone} --seed {options.seed})"
        print(f"mutate: {write_page(room.name, results, len(room.mutants), how).relative_to(ROOT)}")
    return status


if __name__ == "__main__":
    command_line.run(main)
