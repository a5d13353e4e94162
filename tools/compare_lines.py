#!/usr/bin/env python3
"""Compares the behaviour of two builds. Both drive random lines (tools/random_line.py), and every field that the
earlier one prints has to be printed by the later one, with the same bytes and in the same order. New fields are allowed.

For every seed: the line is made; a perfect and a reckless driver drive it with one of the shipped trains; the recorded
inputs are replayed in the two other editions of the SRS, and again with disturbances: lost and repeated telegrams, damaged
radio messages, a lost session, a driver with random actions, a national system, a safety fault.

The first difference of every comparison is printed; exit status 1 when there is one, or when the lines exercised too
little to prove anything.
Usage: tools/compare_lines.py --before EVC --after EVC [--lines 100] [--seed 1] [--keep DIR]"""
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

DRIVERS = ("perfect", "reckless")
EDITIONS = ("3.4.0", "3.6.0", "4.0.0")
DRIVEN = "3.6.0"  # the edition of `evc run`
REPLAYED_LINES = 12000  # of the recorded inputs; a train that waits until the end of a run adds nothing
# Of the wall clock and of the sources: no behaviour.
NOT_COMPARED = {"cycle_us", "real_time_factor", "state_bytes", "output_hash"}

# What 100 lines have to show. Fewer than 100: half of the same share of the counts, and no names.
NAMES_NEEDED = {  # of seeds 1 to 100
    "modes": set("FS LS OS SR SH UN SN SB TR PT SL SF IS".split()),
    "levels": set("0 NTC 1 2".split()),
    "packets accepted": {str(n) for n in (3, 5, 12, 15, 21, 27, 39, 40, 41, 42, 51, 52, 57, 58, 65, 66, 67, 68, 69, 70, 71, 72, 76, 79, 88, 138, 139, 141)},
    "brake reasons": {"T_NVCONTACT", "balise group consistency", "overspeed: EBI", "overspeed: SBI", "overspeed: warning", "roll away",
                      "standstill", "trip"},
    "messages accepted": {str(n) for n in (3, 6, 9, 15, 16, 18, 24, 33)},
}
COUNTS_NEEDED = {"cycles": 2_000_000, "brake commands": 2000, "mode changes": 1500, "level changes": 500, "events": 50_000,
                 "packets refused": 2000, "texts": 50, "messages sent": 5000}


class Difference(Exception):
    pass


# Comparison of JSON texts, by their bytes.
def members(text, where):
    """[(key, raw text of the value)] of a JSON object."""
    decoder = json.JSONDecoder()
    found, at = [], 1
    if not text.startswith("{"):
        raise Difference(f"{where}: not an object: {text[:60]}")
    while text[at] != "}":
        while text[at] in ", \n":
            at += 1
        key, at = decoder.raw_decode(text, at)
        while text[at] in ": \n":
            at += 1
        _, end = decoder.raw_decode(text, at)
        found.append((key, text[at:end]))
        at = end
        while text[at] in " \n":
            at += 1
    return found


def compare_objects(before, after, where):
    """Every member of `before` is in `after`, with the same bytes, in the same order."""
    old, new = members(before, where), members(after, where)
    values = dict(new)
    names = {key for key, _ in old}
    if [key for key, _ in new if key in names] != [key for key, _ in old]:
        raise Difference(f"{where}: fields were {[k for k, _ in old]}\n  and are {[k for k, _ in new]}")
    for key, value in old:
        if key in NOT_COMPARED or values[key] == value:
            continue
        if value.startswith("{") and values[key].startswith("{"):
            compare_objects(value, values[key], f"{where}, {key}")
        else:
            raise Difference(f"{where}: {key}\n  was {shortened(value, values[key])}\n  is  {shortened(values[key], value)}")


def shortened(value, other, room=300):
    """A long value from a little before the first difference on."""
    same = len(os.path.commonprefix([value, other]))
    begin = max(0, same - room // 3)
    text = value[begin:begin + room]
    return ("..." if begin else "") + text + ("..." if begin + room < len(value) else "")


def compare_lines(before, after, what):
    """JSON Lines, byte for byte where they are equal, field by field where they are not."""
    if before == after:
        return
    old, new = before.decode().splitlines(), after.decode().splitlines()
    for number, (a, b) in enumerate(zip(old, new), 1):
        if a != b:
            compare_objects(a, b, f"{what}, line {number}, {a[:30]}")
    if len(old) != len(new):
        raise Difference(f"{what}: {len(old)} lines before, {len(new)} after")


def compare_tables(before, after, what):
    """CSV: the columns that were there, by their names."""
    import csv
    if before == after:
        return
    old, new = (list(csv.reader(t.decode().splitlines())) for t in (before, after))
    try:
        columns = [new[0].index(name) for name in old[0]]
    except ValueError as missing:
        raise Difference(f"{what}: column {missing}") from None
    for number, (a, b) in enumerate(zip(old, new), 1):
        for name, value, column in zip(old[0], a, columns):
            if b[column] != value:
                raise Difference(f"{what}, line {number}: {name} was {value!r}, is {b[column]!r}")
    if len(old) != len(new):
        raise Difference(f"{what}: {len(old)} rows before, {len(new)} after")


# What happened.
class Seen:
    """Counts and names found in outputs."""

    def __init__(self):
        self.counts = collections.Counter()
        self.names = collections.defaultdict(collections.Counter)

    def add(self, other):
        self.counts += other.counts
        for kind, names in other.names.items():
            self.names[kind] += names

    def look_at(self, outputs):
        """`outputs` as JSON Lines."""
        self.counts["cycles"] += outputs.count(b"\n")
        for key, kind in ((b"mode", "modes"), (b"level", "levels"), (b"monitoring", "monitoring")):
            for name in set(re.findall(b'"%s":"(\\w+)"' % key, outputs)):
                self.names[kind][name.decode()] += 1
        last = (b"false",) * 3
        for line in outputs.splitlines():
            brakes = re.search(b'"tco":(\\w+),"sb":(\\w+),"eb":(\\w+),"brake_reasons":\\[([^\\]]*)\\]', line)
            now = brakes.group(1, 2, 3)
            if now != last:
                self.counts["brake commands"] += sum(n == b"true" and was != n for n, was in zip(now, last))
                for reason in re.findall(b'"([^"]*)"', brakes.group(4)):
                    self.names["brake reasons"][reason.decode()] += 1
                last = now
            if b'"events":[]' not in line:
                for event in json.loads(line)["events"]:
                    self.look_at_event(event)
            if b'"radio_out":[]' not in line:
                for number in re.findall(b'"([0-9A-F]{2})[0-9A-F]*"', line[line.index(b'"radio_out":'):].split(b"]")[0]):
                    self.counts["messages sent"] += 1
                    self.names["messages sent"][str(int(number, 16))] += 1
        for text in set(re.findall(b'"texts":\\[([^\\]]+)\\]', outputs)):
            self.names["texts"][text.decode()] += 1
            self.counts["texts"] += 1

    def look_at_event(self, event):
        self.counts["events"] += 1
        self.names["kinds of event"][re.sub(r"\d+", "#", event)] += 1
        words = event.split()
        if words[0] in ("mode", "level"):
            self.counts[f"{words[0]} changes"] += 1
        if words[0] in ("packet", "message") and len(words) > 2 and words[1].isdigit():
            verdict = words[2].rstrip(":")
            if verdict in ("accepted", "refused", "buffered", "rejected"):
                self.counts[f"{words[0]}s {verdict}"] += 1
                self.names[f"{words[0]}s {verdict}"][words[1]] += 1

    def faults(self, lines):
        """What was not exercised enough."""
        share = 1.0 if lines >= 100 else 0.5 * lines / 100
        floors = {name: int(floor * share) for name, floor in COUNTS_NEEDED.items() if floor * share >= 1}
        found = [f"{self.counts[name]} {name}, fewer than {floor}" for name, floor in floors.items() if self.counts[name] < floor]
        if lines >= 100:
            for kind, needed in NAMES_NEEDED.items():
                missing = sorted(needed - set(self.names[kind]), key=lambda n: (len(n), n))
                if missing:
                    found.append(f"no {', '.join(missing)} among {kind}")
        return found

    def print(self):
        for name in sorted(self.counts):
            print(f"compare: {self.counts[name]:9} {name}")
        for kind in ("modes", "levels", "monitoring", "brake reasons", "packets accepted", "packets refused", "messages accepted",
                     "messages refused", "messages sent"):
            names = self.names[kind]
            shown = sorted(names, key=lambda n: (len(n), n) if n.isdigit() else (0, n))
            print(f"compare: {kind}: " + ", ".join(f"{n} ({names[n]})" for n in shown))
        print(f"compare: {len(self.names['kinds of event'])} kinds of event, {len(self.names['texts'])} different lists of texts")


# Inputs that no simulated driver or line gives.
def in_edition(inputs, edition):
    first, rest = inputs.split("\n", 1)
    return first.replace(f'"srs":"{DRIVEN}"', f'"srs":"{edition}"') + "\n" + rest


def disturbed(inputs, dice):
    """The same journey with faults and unusual entries, in about one line of a hundred."""
    selections = ("start", "override", "shunting", "exit_shunting", "non_leading", "maintain_shunting", "train_data", "slippery_rail",
                  "adhesion_normal", "track_ahead_free")
    signals = (("desk_open", False), ("desk_open", True), ("sleeping", True), ("sleeping", False), ("non_leading", True),
               ("non_leading", False), ("passive_shunting", True), ("passive_shunting", False), ("direction_controller", "neutral"),
               ("direction_controller", "forward"), ("direction_controller", "backward"), ("brake_pressure_kpa", 300),
               ("regenerative_brake_active", False), ("eddy_current_brake_active", False), ("ep_brake_active", False),
               ("powered", False), ("powered", True))
    lines = inputs.splitlines()
    out = [lines[0]]
    for number, text in enumerate(lines[1:], 1):
        line = None
        if '"balise"' in text and dice.chance(0.04):
            if dice.chance(0.5):
                continue  # the balise is lost
            out.append(text)  # or read twice
        if '"radio"' in text and "message" in text and dice.chance(0.03):
            line = json.loads(text)
            digits = line["radio"]["message"]
            at = dice.whole(0, len(digits) - 1)
            line["radio"]["message"] = digits[:at] + dice.one_of("0123456789ABCDEF") + digits[at + 1:]
        if number > 60 and '"odometer"' in text and dice.chance(0.012):
            line = json.loads(text)
            kind = dice.whole(0, 11)
            driver = line.setdefault("driver", {})
            if kind < 4:
                driver["select"] = dice.one_of(selections)
            elif kind < 7:
                key, value = dice.one_of(signals)
                line.setdefault("train", {})[key] = value
            elif kind == 7:
                driver.setdefault("enter", {}).update({"level": dice.one_of(("0", "1", "2"))})
            elif kind == 8:
                driver["ack"] = dice.some_of(ACKS, 0.7)
            elif kind == 9:
                driver.setdefault("enter", {}).update({"V_sr_kmh": 30, "D_sr_m": dice.tens(100, 900)})
            elif kind == 10 and dice.chance(0.3):
                line["radio"] = {"session": "lost"}
            elif kind == 11:
                driver.setdefault("enter", {}).update({"train_running_number": dice.whole(1, 9999999)})
            if not driver:
                del line["driver"]
        out.append(text if line is None else json.dumps(line, separators=(",", ":")))
    odometer = next(json.loads(text)["odometer"] for text in reversed(out) if '"odometer"' in text)
    return "\n".join(out + played_on(json.loads(out[-1])["t_ms"], odometer, dice)) + "\n"


ACKS = ("OS", "LS", "SH", "SR", "UN", "SN", "RV", "trip", "level", "text", "brake", "train_data")


def played_on(t, odometer, dice):
    """Lines after the journey: desks, missions, shunting, sleeping, reversing, short movements; a fault at the end."""
    lines = []

    def line(after_ms, **what):
        nonlocal t
        t += after_ms
        lines.append(json.dumps({"t_ms": t, **what}, separators=(",", ":")))

    def move(metres, speed):
        for _ in range(5):
            for counter in ("nominal_m", "min_m", "max_m"):
                odometer[counter] = round(odometer[counter] + metres / 5, 3)
            line(1000, odometer={**odometer, "speed_mps": speed, "speed_min_mps": speed, "speed_max_mps": speed, "accel_mps2": 0})
        line(500, odometer={**odometer, "speed_mps": 0, "speed_min_mps": 0, "speed_max_mps": 0, "accel_mps2": 0})
        line(1500, driver={"ack": list(ACKS)})

    def mission(level):
        line(300, train={"desk_open": True, "direction_controller": "forward"})
        line(300, driver={"enter": {"driver_id": 4711}})
        line(300, driver={"enter": {"level": level}})
        line(300, driver={"select": "train_data"})
        line(300, driver={"enter": {"train_data": {"schema": "etcs-train/1"}}})
        line(300, driver={"enter": {"train_running_number": 4711}})
        line(300, driver={"select": "start"})
        line(300, driver={"ack": list(ACKS)})

    def shunt():
        line(300, driver={"select": "shunting"})
        line(300, driver={"ack": ["SH"]})
        move(8, 2)
        if dice.chance(0.5):
            line(300, train={"passive_shunting": True}, driver={"select": "maintain_shunting"})
            line(300, train={"desk_open": False})
            move(6, 2)
            line(300, train={"desk_open": True})
        line(300, train={"passive_shunting": False}, driver={"select": "exit_shunting"})

    def lead_no_longer():
        line(300, train={"non_leading": True})
        line(300, driver={"select": "non_leading"})
        move(10, 2)
        line(300, train={"non_leading": False})

    def sleep():
        line(300, train={"desk_open": False, "sleeping": True})
        move(10, 2)
        line(300, train={"sleeping": False})

    def reverse():
        line(300, driver={"ack": ["RV"]}, train={"direction_controller": "backward"})
        move(-10, 2)
        line(300, driver={"ack": ["brake", "trip"]}, train={"direction_controller": "forward"})

    def overridden():
        line(300, driver={"select": "override"})
        line(300, driver={"ack": list(ACKS)})
        move(12, 2)

    line(1000, odometer={**odometer, "speed_mps": 0, "speed_min_mps": 0, "speed_max_mps": 0, "accel_mps2": 0})
    line(1000, driver={"ack": list(ACKS)})
    for _ in range(dice.whole(4, 9)):
        scene = dice.whole(0, 7)
        if scene < 2:
            mission(dice.one_of(("0", "1", "1", "2")))
        else:
            (shunt, lead_no_longer, sleep, reverse, overridden, lambda: move(-3, 1))[scene - 2]()
        if dice.chance(0.3):
            line(300, train={"desk_open": False})
            line(300, train={"desk_open": True})
    end = dice.whole(0, 3)
    if end == 0:
        line(1000, fault={"safety": True})
    elif end == 1:
        line(1000, train={"isolated": True})
    elif end == 2:
        line(1000, train={"powered": False})
        line(1000, train={"powered": True})
    line(3000, train={"desk_open": True})
    return lines


# One seed.
def run(command, accepted=(0,), **kwargs):
    done = subprocess.run([str(c) for c in command], capture_output=True, **kwargs)
    if done.returncode not in accepted:
        raise Difference(f"{' '.join(map(str, command))}: exit status {done.returncode}: {done.stderr.decode().strip()[:400]}")
    return done.stdout


def drive_both(line, train, driver, seed, folder, options, seen):
    for side in ("before", "after"):
        # 1: the train never moved; the files are written.
        run([getattr(options, side), "run", line, "--train", train, "--driver", driver, "--seed", seed, "-o", folder / side],
            accepted=(0, 1))
    text = {(side, name): (folder / side / name).read_bytes() for side in ("before", "after")
            for name in ("inputs.jsonl", "outputs.jsonl", "trace.csv", "summary.json")}
    seen.look_at(text["after", "outputs.jsonl"])
    compare_lines(text["before", "outputs.jsonl"], text["after", "outputs.jsonl"], "outputs.jsonl")
    compare_lines(text["before", "inputs.jsonl"], text["after", "inputs.jsonl"], "inputs.jsonl")
    compare_tables(text["before", "trace.csv"], text["after", "trace.csv"], "trace.csv")
    compare_objects(text["before", "summary.json"].decode(), text["after", "summary.json"].decode(), "summary.json")
    return text["before", "inputs.jsonl"].decode()


def replay_both(inputs, folder, options, seen):
    stream = folder / "replayed.inputs.jsonl"
    stream.write_text(inputs, encoding="utf-8")
    outputs = {side: run([getattr(options, side), "replay", stream]) for side in ("before", "after")}
    seen.look_at(outputs["after"])
    compare_lines(outputs["before"], outputs["after"], "outputs of the replay")


def compare_seed(seed, options, folder):
    """(differences, what was seen)"""
    seen, differences = Seen(), []
    trains = sorted((ROOT / "data/trains").glob("*.json"))
    dice = Dice(1_000_000 + seed)
    description, line = folder / "description.json", folder / "line.json"
    description.write_text(json.dumps(RandomLine(seed).description(), indent=1), encoding="utf-8")
    run([options.after, "make-line", description, "-o", line])
    for driver in DRIVERS:
        train = trains[(seed + DRIVERS.index(driver)) % len(trains)]
        inputs = None
        what = f"{driver} driver, {train.stem}"
        try:
            inputs = drive_both(line, train, driver, seed, folder, options, seen)
        except Difference as difference:
            differences.append(f"seed {seed}, {what}: {difference}")
            inputs = (folder / "before/inputs.jsonl").read_text(encoding="utf-8")
        inputs = "".join(inputs.splitlines(keepends=True)[:REPLAYED_LINES])
        others = [e for e in EDITIONS if e != DRIVEN]
        replays = [(f"replayed, SRS {e}", in_edition(inputs, e)) for e in others]
        edition = dice.one_of(EDITIONS)
        replays.append((f"disturbed, SRS {edition}", in_edition(disturbed(inputs, dice), edition)))
        for name, stream in replays:
            try:
                replay_both(stream, folder, options, seen)
            except Difference as difference:
                differences.append(f"seed {seed}, {what}, {name}: {difference}")
                if options.keep:
                    kept = pathlib.Path(options.keep)
                    kept.mkdir(parents=True, exist_ok=True)
                    (kept / f"{seed}.{driver}.{name.split(',')[0]}.inputs.jsonl").write_text(stream, encoding="utf-8")
    return differences, seen


def main():
    parser = command_line.Parser(__doc__)
    parser.add_argument("--before", required=True, type=command_line.program)
    parser.add_argument("--after", required=True, type=command_line.program)
    parser.add_argument("--lines", type=command_line.whole(1), default=100)
    parser.add_argument("--seed", type=command_line.whole(0), default=1, help="the first one")
    parser.add_argument("--keep", help="folder for the inputs of replays that differ")
    options = parser.parse_args()
    seen, differences = Seen(), []

    def one(seed):
        with tempfile.TemporaryDirectory(prefix="evc-compare-") as folder:
            return compare_seed(seed, options, pathlib.Path(folder))

    with concurrent.futures.ThreadPoolExecutor(max_workers=command_line.jobs()) as pool:
        for found, what in pool.map(one, range(options.seed, options.seed + options.lines)):
            seen.add(what)
            for difference in found:
                print(f"compare: {difference}", flush=True)
            differences += found
    seen.print()
    faults = seen.faults(options.lines)
    for fault in faults:
        print(f"compare: the lines prove too little: {fault}")
    print(f"compare: {options.lines} lines, {len(differences)} differences")
    return 1 if differences or faults else 0


if __name__ == "__main__":
    command_line.run(main)
