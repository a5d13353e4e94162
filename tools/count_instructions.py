#!/usr/bin/env python3
"""Instructions, counted by callgrind: a busy FS cycle, the cycle in which a balise group replaces all track data, a
balise telegram of 764 bits from bits to structs, all curves and limits of a gamma target from raw data, and the mean of
the cycles of recorded journeys. Usage: tools/count_instructions.py [INPUT.jsonl...]"""
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
PROGRAM = ROOT / "build/release/benches/instructions"


def per_cycle(*scenario):
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "callgrind.out"
        done = subprocess.run(["valgrind", "--tool=callgrind", "--collect-atstart=no", f"--callgrind-out-file={out}",
                               PROGRAM, *scenario], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            sys.exit(f"instructions: {' '.join(map(str, scenario))} failed\n{done.stdout}{done.stderr}")
        total = int(re.search(r"^(?:totals|summary): (\d+)", out.read_text(encoding="utf-8"), re.M)[1])
    return int(done.stdout), total


def main():
    scenarios = [("busy FS cycle", ("busy",)), ("all track data replaced", ("change",)),
                 ("telegram of 764 bits", ("telegram",)), ("gamma target from raw data", ("gamma",))]
    scenarios += [(f"journey {pathlib.Path(f).name}", ("journey", f)) for f in sys.argv[1:]]
    for name, scenario in scenarios:
        cycles, total = per_cycle(*scenario)
        print(f"instructions: {name:28} {total / cycles:10.0f} each, mean of {cycles}")


if __name__ == "__main__":
    main()
