#!/usr/bin/env python3
"""Journeys on random lines (tools/random_line.py, `calm`): perfect, late and reckless drivers, odometers at the limits
that they declare, lines with balises missing. Checked for every journey:
  - the true front end is in the confidence interval in every cycle;
  - no false reaction: a perfect driver is not braked on a whole line, nobody but for overspeed; on a line with balises
    missing only the groups that they belong to are reported as missed or inconsistent;
  - nobody passes the supervised location, unless a release speed given by trackside let him;
  - no allocation in a step, every journey ends, and the replay of its inputs gives its outputs, byte for byte.
Usage: tools/campaign_journeys.py [--journeys 3000] [--seed 1] [--keep DIR]"""
import collections
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tools"))
import command_line
from random_line import Dice, RandomLine  # noqa: E402

EVC = pathlib.Path(os.environ.get("EVC", ROOT / "build/release/evc"))
DRIVERS = ("perfect", "late", "reckless")
ODOMETERS = ("random", "over", "under")
OVERSPEED = {"overspeed: warning", "overspeed: SBI", "overspeed: EBI"}
# What else may follow from balises that are missing: an authority or a level transition that never came.
AFTER_A_LOSS = OVERSPEED | {"trip", "linking", "two balise groups missed", "balise group consistency"}
REPORTED = re.compile(r'"BG (\d+) (?:not found|message inconsistent|[^"]*not decoded)[^"]*"')


def kinds(seed):
    """(driver, odometer, balises missing) of a journey: 18 kinds in turn."""
    return DRIVERS[seed % 3], ODOMETERS[seed // 3 % 3], seed // 9 % 2 == 1


def take_balises(line, seed):
    """Removes about every eighth group, or one balise of it, behind the first one; returns the numbers of these groups."""
    dice = Dice(seed)
    taken = set()
    for group in line["balise_groups"][1:]:
        if not dice.chance(0.12):
            continue
        lost = group["balises"] if dice.chance(0.5) else [dice.one_of(group["balises"])]
        for balise in lost:
            digits = balise.pop("telegram_hex", None)
            if digits is not None:
                taken.add(identity(digits))
    return taken


def identity(telegram_hex):
    """NID_BG of a telegram: the 14 bits behind Q_UPDOWN, M_VERSION, Q_MEDIA, N_PIG, N_TOTAL, M_DUP, M_MCOUNT and NID_C."""
    bits = bin(int(telegram_hex[:16], 16))[2:].zfill(64)
    return int(bits[35:49], 2)


def judge(summary, outputs, driver, taken):
    """(sentences about what does not hold, the groups that the on-board reported)."""
    faults = []
    if summary["confidence_interval_violations"]:
        faults.append(f"{summary['confidence_interval_violations']} cycles outside the confidence interval")
    if summary["allocations_in_step"]:
        faults.append(f"{summary['allocations_in_step']} allocations in steps")
    if summary["distance_m"] < 1000:
        faults.append(f"ran {summary['distance_m']} m only")
    reasons, reported, release = set(), set(), False
    for line in outputs:
        found = re.search(r'"brake_reasons":\[([^\]]+)\]', line)
        if found:
            reasons |= set(re.findall(r'"([^"]*)"', found.group(1)))
        reported |= {int(n) for n in REPORTED.findall(line)}
        release = release or '"V_release":null' not in line
    allowed = set() if driver == "perfect" else OVERSPEED
    if driver == "reckless":
        allowed = allowed | {"trip"}
    if taken:
        allowed = allowed | AFTER_A_LOSS
    if reasons - allowed:
        faults.append(f"braked because of {', '.join(sorted(reasons - allowed))}")
    if reported - taken:
        faults.append(f"groups {sorted(reported - taken)} are reported, {sorted(taken)} were incomplete")
    if summary["svl_overrun_m"] is not None and not (driver == "reckless" and release):
        faults.append(f"the true front passed the supervised location by {summary['svl_overrun_m']} m")
    return faults, reported


def call(*command):
    return subprocess.run(command, capture_output=True, text=True, timeout=900)


def travel(seed, kept):
    driver, odometer, missing = kinds(seed)
    with tempfile.TemporaryDirectory(prefix="evc-journey-") as name:
        folder = pathlib.Path(name) if kept is None else kept / str(seed)
        folder.mkdir(parents=True, exist_ok=True)
        description, line = folder / "description.json", folder / "line.json"
        description.write_text(json.dumps(RandomLine(seed, calm=True).description()), encoding="utf-8")
        made = call(EVC, "make-line", description, "-o", line)
        if made.returncode:
            return seed, [f"make-line: {made.stderr.strip()}"], None
        taken = set()
        if missing:
            document = json.loads(line.read_text(encoding="utf-8"))
            taken = take_balises(document, seed)
            line.write_text(json.dumps(document), encoding="utf-8")
        run = call(EVC, "run", line, "--driver", driver, "--odometer", odometer, "--seed", str(seed), "-o", folder / "run")
        if not (folder / "run/summary.json").exists():
            return seed, [f"evc run: exit {run.returncode}: {run.stderr.strip()}"], None
        summary = json.loads((folder / "run/summary.json").read_text(encoding="utf-8"))
        with open(folder / "run/outputs.jsonl", encoding="utf-8") as outputs:
            faults, reported = judge(summary, outputs, driver, taken)
        if run.returncode:
            faults.append(f"evc run: exit {run.returncode}: {run.stderr.strip()}")
        call(EVC, "replay", folder / "run/inputs.jsonl", "-o", folder / "replayed.jsonl")
        if (folder / "replayed.jsonl").read_bytes() != (folder / "run/outputs.jsonl").read_bytes():
            faults.append("the replay gives other outputs")
        summary["reported"] = len(reported)
        return seed, faults, summary


def too_little(seen, journeys):
    """1 if the journeys exercised too little to prove anything."""
    floors = {"km": 9 * journeys, "sb": journeys, "reported": journeys // 4}
    missing = [f"{seen[what]:.0f} {what}, expected {floor}" for what, floor in floors.items() if seen[what] < floor]
    if missing:
        print(f"journeys: too little to prove anything: {'; '.join(missing)}")
    return 1 if missing else 0


def main():
    parser = command_line.Parser(__doc__)
    parser.add_argument("--journeys", type=command_line.whole(1), default=3000)
    parser.add_argument("--seed", type=command_line.whole(0), default=1)
    parser.add_argument("--keep", type=pathlib.Path, help="folder for the files of every journey")
    options = parser.parse_args()
    failed, seen = 0, collections.Counter()
    with concurrent.futures.ThreadPoolExecutor(max_workers=command_line.jobs()) as pool:
        jobs = [pool.submit(travel, seed, options.keep) for seed in range(options.seed, options.seed + options.journeys)]
        for job in concurrent.futures.as_completed(jobs):
            seed, faults, summary = job.result()
            for fault in faults:
                print(f"journeys: --seed {seed} ({', '.join(map(str, kinds(seed)))}): {fault}", flush=True)
            failed += bool(faults)
            if summary is None:
                continue
            seen["km"] += summary["distance_m"] / 1000
            seen["cycles"] += summary["cycles"]
            seen["reported"] += summary["reported"]
            for kind, count in summary["interventions"].items():
                seen[kind] += count
    print(f"journeys: {seen['km']:.0f} km, {seen['cycles']} cycles, {seen['tco']} traction cut-offs, {seen['sb']} service brakes, "
          f"{seen['eb']} emergency brakes, {seen['trip']} trips, {seen['reported']} incomplete groups reported")
    failed += too_little(seen, options.journeys)
    print(f"journeys: {options.journeys} journeys, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    command_line.run(main)
