#!/usr/bin/env python3
"""`make run` on the shipped line, the same with every shipped train, and `evc run` on the recorded line (where
OPENEVC_SHARED, default ../shared, has it), checked by summary.json: everything read, nothing refused, no intervention,
no allocation in a step, the train always inside the confidence interval, and the replay of inputs.jsonl equal to
outputs.jsonl. Usage: tools/check_run.py"""
import hashlib
import json
import os
import pathlib
import subprocess

import command_line

ROOT = pathlib.Path(__file__).resolve().parent.parent
EVC = ROOT / "build/release/evc"
LARGEST_STATE = 65536

# What holds on every line with the perfect driver ...
ALWAYS = {
    "telegrams.rejected": 0,
    "balise_groups.missed": 0,
    "balise_groups.rejected": 0,
    "interventions.tco": 0,
    "interventions.sb": 0,
    "interventions.eb": 0,
    "interventions.trip": 0,
    "confidence_interval_violations": 0,
    "svl_overrun_m": None,
    "allocations_in_step": 0,
}
# ... and on the recorded passage.
RECORDED = {
    **ALWAYS,
    "balise_groups.on_line": 103,
    "balise_groups.read": 103,
    "telegrams.decoded": 206,
    "radio_messages.received": 57,
    "radio_messages.accepted": 18,
    "radio_messages.refused": 39,
    "movement_authorities.received": 16,
    "movement_authorities.accepted": 16,
    "modes": ["SB", "SN", "FS", "SN"],
    "levels": ["NTC", "2", "NTC"],
}


def value(summary, path):
    for key in path.split("."):
        summary = summary[key]
    return summary


def sha256(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


def judge(name, folder, expected):
    """The sentences about what does not hold in a run's folder."""
    summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    faults = []
    for path, wanted in expected.items():
        found = value(summary, path)
        if found != wanted:
            faults.append(f"{path} is {found}, not {wanted}")
    if summary["movement_authorities"]["accepted"] != summary["movement_authorities"]["received"]:
        faults.append("not every movement authority was accepted")
    if summary["balise_groups"]["read"] != summary["balise_groups"]["on_line"]:
        faults.append("not every balise group was read")
    if summary["state_bytes"] > LARGEST_STATE:
        faults.append(f"state_bytes is {summary['state_bytes']}, more than {LARGEST_STATE}")
    if not summary["min_margin_to_EBI_kmh"] > 0:
        faults.append(f"min_margin_to_EBI_kmh is {summary['min_margin_to_EBI_kmh']}")
    if summary["output_hash"] != sha256(folder / "outputs.jsonl"):
        faults.append("output_hash is not the SHA-256 of outputs.jsonl")
    again = folder / "replayed.jsonl"
    subprocess.run([EVC, "replay", folder / "inputs.jsonl", "-o", again], check=True)
    if sha256(again) != summary["output_hash"]:
        faults.append("evc replay of inputs.jsonl gives other outputs")
    again.unlink()
    for page in ("trace.csv", "report.html"):
        if not (folder / page).stat().st_size:
            faults.append(f"{page} is empty")
    cost = summary["cycle_us"]
    print(f"run: {name:24} {summary['distance_m'] / 1000:5.1f} km {summary['duration_s']:6.0f} s, modes "
          f"{' '.join(summary['modes'])}, levels {' '.join(summary['levels'])}, cycle us median {cost['median']:.1f} "
          f"99.9 % {cost['p99_9']:.1f} max {cost['max']:.1f}, state {summary['state_bytes']} bytes, "
          f"{summary['real_time_factor']:.0f} times real time")
    for fault in faults:
        print(f"run: {name}: {fault}")
    return faults


def main():
    command_line.Parser(__doc__).parse_args()
    subprocess.run(["make", "--no-print-directory", "run"], check=True, cwd=ROOT, stdout=subprocess.DEVNULL)
    faults = judge("shipped line", ROOT / "out/run", ALWAYS)
    for train in sorted((ROOT / "data/trains").glob("*.json")):
        folder = ROOT / "out" / f"train-{train.stem}"
        subprocess.run([EVC, "run", "--train", train, "-o", folder], check=True, stdout=subprocess.DEVNULL)
        faults += judge(train.stem, folder, ALWAYS)
    line = pathlib.Path(os.environ.get("OPENEVC_SHARED", ROOT / "../shared")) / "lines/amsterdam_utrecht.json"
    if line.exists():
        folder = ROOT / "out/recorded"
        subprocess.run([EVC, "run", line, "-o", folder], check=True, stdout=subprocess.DEVNULL)
        faults += judge("recorded line", folder, RECORDED)
    else:
        print(f"run: no recorded line at {line}; left out")
    return 1 if faults else 0


if __name__ == "__main__":
    command_line.run(main)
