#!/usr/bin/env python3
"""Instructions, counted by callgrind: a busy FS cycle, the cycle in which a balise group replaces all track data, the
slowest cycle that bench/worst_cycle.cpp found (which has a limit), whole journeys alone and as cases of a sweep, a balise telegram of 764 bits from bits to structs,
all curves and limits of a gamma target from raw data, and the mean of the cycles of the committed journeys
(tests/data/*.inputs.jsonl.xz) and of those named.

Usage: tools/count_instructions.py [--check | --write] [INPUT.jsonl...]
  --check  compares with tests/gates/instructions.txt: 2 % more fails, and so does 2 % less: the new figure is committed
           with the change that made it. Figures of another compiler are not compared: that fails too
  --write  writes today's figures there"""
import lzma
import pathlib
import re
import subprocess
import sys
import tempfile

import command_line

ROOT = pathlib.Path(__file__).resolve().parent.parent
PROGRAM = ROOT / "build/release/benches/instructions"
FIGURES = ROOT / "tests/gates/instructions.txt"
TOLERANCE = 0.02
SCENARIOS = {"busy FS cycle": "busy", "all track data replaced": "change", "telegram of 764 bits": "telegram",
             "gamma target from raw data": "gamma", "slowest cycle found": "worst",
             "journey in a plain loop": "plain", "journey of a sweep": "swept"}
# What may not be exceeded whatever is committed (docs/decisions/0017).
MOST = {"slowest cycle found": 2_000_000}
# A sweep costs at most so many times what the simulation of its journeys costs.
MOST_TIMES = {("journey of a sweep", "journey in a plain loop"): 1.03}


def per_cycle(*scenario):
    """(how often, instructions of all) of one scenario."""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "callgrind.out"
        done = subprocess.run(["valgrind", "--tool=callgrind", "--collect-atstart=no", f"--callgrind-out-file={out}",
                               PROGRAM, *scenario], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            sys.exit(f"instructions: {' '.join(map(str, scenario))} failed\n{done.stdout}{done.stderr}")
        total = int(re.search(r"^(?:totals|summary): (\d+)", out.read_text(encoding="utf-8"), re.M)[1])
    return int(done.stdout), total


def measured(journeys):
    """Yields (name, instructions each, how often)."""
    for name, scenario in SCENARIOS.items():
        cycles, total = per_cycle(scenario)
        yield name, round(total / cycles), cycles
    for packed in sorted((ROOT / "tests/data").glob("*.inputs.jsonl.xz")):
        with tempfile.NamedTemporaryFile(suffix=".jsonl") as file:
            file.write(lzma.decompress(packed.read_bytes()))
            file.flush()
            cycles, total = per_cycle("journey", file.name)
        yield f"journey {packed.name.split('.')[0]}", round(total / cycles), cycles
    for journey in journeys:
        cycles, total = per_cycle("journey", journey)
        yield f"journey {journey}", round(total / cycles), cycles


def compiler():
    """What the counted program says that it was compiled by."""
    done = subprocess.run(["readelf", "-p", ".comment", PROGRAM], check=True, capture_output=True, text=True)
    return ", ".join(sorted(set(re.findall(r"\]\s+(.+)$", done.stdout, re.M))))


def read(text):
    """(compiler, {name: figure}) of the committed file."""
    first, *rows = (line.split("\t") for line in text.splitlines() if line)
    return first[1], {name: int(figure) for name, figure in rows}


def written(by, figures):
    return "".join(f"{name}\t{value}\n" for name, value in [("compiler", by), *figures.items()])


def faults(committed, found):
    """What does not fit; both are (compiler, {name: figure})."""
    if committed[0] != found[0]:
        return [f"the figures are of {committed[0]}, this program is of {found[0]}: they cannot be compared"]
    sentences = []
    for name, most in MOST.items():
        if found[1].get(name, 0) > most:
            sentences.append(f"{name}: {found[1][name]}, at most {most} are allowed")
    for (name, other), most in MOST_TIMES.items():
        if found[1].get(name, 0) > most * found[1].get(other, 0):
            sentences.append(f"{name}: {found[1][name]}, at most {most} times {other} is allowed")
    for name in sorted(committed[1].keys() | found[1].keys()):
        old, new = committed[1].get(name), found[1].get(name)
        if old is None or new is None:
            sentences.append(f"{name}: {'is not committed' if old is None else 'was not measured'}")
        elif abs(new - old) > TOLERANCE * old:
            sentences.append(f"{name}: {new}, committed {old} ({100 * (new - old) / old:+.1f} %)")
    return sentences


def main():
    parser = command_line.Parser(__doc__)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--write", action="store_true")
    parser.add_argument("journeys", nargs="*", type=command_line.file, metavar="INPUT.jsonl")
    options = parser.parse_args()
    if options.check or options.write:
        subprocess.run([ROOT / "tools/build", "release", "instructions"], check=True, stdout=sys.stderr)
    figures = {}
    for name, value, cycles in measured(options.journeys):
        figures[name] = value
        print(f"instructions: {name:28} {value:10} each, mean of {cycles}")
    found = (compiler(), figures)
    print(f"instructions: compiled by {found[0]}")
    if options.write:
        FIGURES.write_text(written(*found), encoding="utf-8")
    if not options.check:
        return 0
    committed = read(FIGURES.read_text(encoding="utf-8"))
    print(f"instructions: committed figures of {committed[0]}")
    wrong = faults(committed, found)
    for sentence in wrong:
        print(f"instructions: {sentence}")
    if wrong:
        print(f"instructions: what is meant is written by tools/count_instructions.py --write; commit "
              f"{FIGURES.relative_to(ROOT)} with the change and say why in the message")
    return 1 if wrong else 0


if __name__ == "__main__":
    command_line.run(main)
