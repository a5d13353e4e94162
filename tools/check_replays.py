#!/usr/bin/env python3
"""Streams of inputs that once showed a fault of the on-board are replayed, and what they have to show is compared.

tests/replays/expected.json names each file, why its outcome is right (`why`, with the paragraph) and the outcome:
  modes   of a stream: every mode with the time from which it holds, "SB 0, SR 2900, FS 11000"
  then    facts of single cycles: `t_ms`, and outputs of `evc replay` by their JSON pointer. A list of events holds at
          least those that are named; of another list every element counts
  never   outputs that have the value in no cycle, events that occur in none; `from` and `to` limit the cycles. An event has
          to occur in a stream of the folder, so that one that the unit calls otherwise is noticed
  always  outputs that have the same value in all cycles; `from` and `to` limit them
          An output that is named has to be there; `null` is a value. Either needs a cycle, and an output
  command of another file: what reads it, and `result`, members of its output by JSON pointer, or `error`, its message
Every file of the folder has to be named.

Some streams leave out the cycles in which nothing happened but that the train ran on, up to 35 s. `evc replay` takes the
odometer for failed after 1 s without a reading, so such a gap is filled: in each cycle the counters have gone on in
proportion to the time, from the reading before the gap to the one after it, or, after the last one, by its speeds; the
speeds are those of the reading before. A train that stands needs no readings (docs/replay.md).
Usage: tools/check_replays.py --command EVC [--filled FILE]; --filled prints a stream as it is replayed."""
import concurrent.futures
import gzip
import json
import os
import pathlib
import subprocess

import command_line

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "tests" / "replays"
LONGEST_MS = 1000  # a reading of the odometer that is older counts as failed
COUNTERS = {"nominal_m": "speed_mps", "min_m": "speed_min_mps", "max_m": "speed_max_mps"}


def lines_of(path):
    text = gzip.decompress(path.read_bytes()).decode() if path.suffix == ".gz" else path.read_text(encoding="utf-8")
    return [line for line in text.splitlines() if line.strip()]


def between(before, after, t_ms):
    """The reading at t_ms; `after` is None after the last one."""
    reading = dict(before[1])
    elapsed = t_ms - before[0]
    for counter, speed in COUNTERS.items():
        if after is None:
            rate = before[1].get(speed, before[1]["speed_mps"]) / 1000
        else:
            rate = (after[1][counter] - before[1][counter]) / (after[0] - before[0])
        reading[counter] = round(before[1][counter] + rate * elapsed, 6)
    return reading


def filled(lines):
    """The lines of a stream with the readings that its gaps leave out. Lines that are kept are kept as they are."""
    inputs = [json.loads(line) for line in lines]
    cycle_ms = next((i["config"].get("cycle_ms", 100) for i in inputs if "config" in i), 100)
    readings = [(i["t_ms"], i["odometer"]) for i in inputs if "odometer" in i]
    ends = [*readings[1:], None]
    last_ms = inputs[-1].get("t_ms", 0)
    added = []
    for before, after in zip(readings, ends):
        until = after[0] if after else last_ms + 1
        if before[1]["speed_mps"] == 0 or until - before[0] <= LONGEST_MS:
            continue
        added += [(t, json.dumps({"t_ms": t, "odometer": between(before, after, t)}))
                  for t in range(before[0] + cycle_ms, until, cycle_ms)]
    kept = [(i.get("t_ms", 0), line) for i, line in zip(inputs, lines)]
    return [line for _, line in sorted(kept + added, key=lambda pair: pair[0])]


ABSENT = object()


def member(value, pointer):
    """Of a JSON pointer; ABSENT where there is no such member, which is another one than a null."""
    for key in pointer.strip("/").split("/"):
        if isinstance(value, list):
            value = value[int(key)] if key.isdecimal() and int(key) < len(value) else ABSENT
        else:
            value = value.get(key, ABSENT) if isinstance(value, dict) else ABSENT
    return value


def shown(value):
    return "nothing" if value is ABSENT else json.dumps(value)


def same(pointer, found, expected):
    if found is ABSENT:
        return False
    if pointer == "events":
        return all(event in found for event in expected)
    if isinstance(expected, float):
        return isinstance(found, (int, float)) and abs(found - expected) <= 0.05 + 1e-9
    return found == expected


def within(outputs, fact):
    return [o for o in outputs if fact.get("from", 0) <= o["t_ms"] <= fact.get("to", o["t_ms"])]


def facts_of(fact):
    return {key: value for key, value in fact.items() if key not in ("t_ms", "from", "to")}


def limits_of(fact):
    return f"from {fact.get('from', 'the beginning')} to {fact.get('to', 'the end')}"


def judge(outputs, fact, word, is_wrong):
    """`never` and `always`: the first cycle within the limits that is wrong, of each output."""
    cycles, facts, faults = within(outputs, fact), facts_of(fact), []
    if not cycles:
        faults.append(f"{word}: no cycle {limits_of(fact)}")
    if not facts:
        faults.append(f"{word}: no output is named {limits_of(fact)}")
    for pointer, value in facts.items():
        for o in cycles:
            found = member(o, pointer)
            if found is ABSENT or is_wrong(pointer, found, value):
                faults.append(f"{o['t_ms']}: {pointer}: found {shown(found)}, expected {word} {json.dumps(value)}")
                break
    return faults


def occurs(pointer, found, value):
    """What `never` forbids: one of several events, or the value."""
    return any(event in found for event in value) if pointer == "events" else same(pointer, found, value)


def differs(pointer, found, value):
    return not same(pointer, found, value)


def judge_stream(outputs, expected):
    faults, modes = [], []
    for output in outputs:
        if not modes or modes[-1].split()[0] != output["mode"]:
            modes.append(f"{output['mode']} {output['t_ms']}")
    if ", ".join(modes) != expected["modes"]:
        faults.append(f"modes: found {', '.join(modes)}, expected {expected['modes']}")
    at = {output["t_ms"]: output for output in outputs}
    for fact in expected.get("then", []):
        if fact["t_ms"] not in at:
            faults.append(f"no cycle at {fact['t_ms']}")
            continue
        if not facts_of(fact):
            faults.append(f"{fact['t_ms']}: no output is named")
        for pointer, value in facts_of(fact).items():
            found = member(at[fact["t_ms"]], pointer)
            if not same(pointer, found, value):
                faults.append(f"{fact['t_ms']}: {pointer}: found {shown(found)}, expected {json.dumps(value)}")
    for fact in expected.get("never", []):
        faults += judge(outputs, fact, "never", occurs)
    for fact in expected.get("always", []):
        faults += judge(outputs, fact, "always", differs)
    return faults


def check_stream(evc, path, expected):
    """The faults, and the events that occurred."""
    lines = filled(lines_of(path))
    ran = subprocess.run([evc, "replay", "-"], input="\n".join(lines) + "\n", capture_output=True, text=True, check=False)
    if ran.returncode:
        return [f"evc replay ends with {ran.returncode}: {ran.stderr.strip()}"], set()
    outputs = [json.loads(line) for line in ran.stdout.splitlines()]
    return judge_stream(outputs, expected), {event for output in outputs for event in output["events"]}


def check_command(evc, path, expected):
    return faults_of_command(evc, path, expected), set()


def faults_of_command(evc, path, expected):
    ran = subprocess.run([evc, expected["command"], path.name], cwd=path.parent, capture_output=True, text=True, check=False)
    if "error" in expected:
        if ran.returncode != 2 or expected["error"] not in ran.stderr:
            return [f"found exit status {ran.returncode}, {ran.stderr.strip()[:200]!r}, expected 2, {expected['error']!r}"]
        return []
    if ran.returncode:
        return [f"evc {expected['command']} ends with {ran.returncode}: {ran.stderr.strip()}"]
    result = json.loads(ran.stdout)
    return [f"{pointer}: found {shown(member(result, pointer))}, expected {json.dumps(value)}"
            for pointer, value in expected["result"].items() if not same(pointer, member(result, pointer), value)]


def check_file(evc, name, expected):
    path = FOLDER / name
    if not path.is_file():
        return [f"{name}: is not there"], set()
    check_it = check_command if "command" in expected else check_stream
    faults, events = check_it(evc, path, expected)
    return [f"{name}: {fault}" for fault in faults], events


def never_seen(expected, seen):
    """Events that `never` names and that no stream has: the unit has no such event, or calls it otherwise now."""
    return [f"{name}: never {event}: it occurs in no stream of the folder" for name, one in expected.items()
            for fact in one.get("never", []) for event in fact.get("events", []) if event not in seen]


def check(evc):
    expected = json.loads((FOLDER / "expected.json").read_text(encoding="utf-8"))
    files = {p.relative_to(FOLDER).as_posix() for p in FOLDER.rglob("*") if p.is_file()} - {"expected.json", "README.md"}
    faults = [f"{name}: expected.json does not name it" for name in sorted(files - set(expected))]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        checked = list(pool.map(lambda item: check_file(evc, *item), expected.items()))
    for found, _ in checked:
        faults += found
    faults += never_seen(expected, set().union(*(events for _, events in checked)))
    return faults, len(expected)


def main():
    parser = command_line.Parser(__doc__.splitlines()[0])
    parser.add_argument("--command", type=command_line.program)
    parser.add_argument("--filled", type=command_line.file)
    args = parser.parse_args()
    if args.filled:
        with command_line.reading(args.filled, "a stream of inputs"):
            lines = filled(lines_of(args.filled))
        print("\n".join(lines))
        return 0
    if not args.command:
        parser.error("--command names the program evc")
    faults, count = check(args.command)
    for fault in faults:
        print(fault)
    print(f"replays: {count} files, {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    command_line.run(main)
