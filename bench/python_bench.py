#!/usr/bin/env python3
"""Costs of the package: `OnBoard.step` in an idle cycle, and `limits` over a million triples, beside the batch in C++.
Usage: PYTHONPATH=build/python/python bench/python_bench.py [build/release/benches/batch_bench]"""
import json
import os
import subprocess
import sys
import time

import numpy as np

import openevc as evc

TRIPLES = 1_000_000
TRACK = {"gradient": [[100 * i, (i * 7) % 25 - 12] for i in range(20)], "mrsp": [[-5000, 160]]}
# 8 bands of speed with those of the train: as in bench/batch_bench.cpp.
VALUES = {"Kv_int_passenger": [[0, 0.7, 0.7], [40, 0.68, 0.68], [70, 0.665, 0.665]]}


def seconds(call, times):
    """The shortest of some measurements of CPU time, of one thread: others use the machine too."""
    best = float("inf")
    for _ in range(times):
        begin = time.process_time()
        call()
        best = min(best, time.process_time() - begin)
    return best


def idle_steps():
    """Seconds of a million cycles in which nothing happens; nobody looks at the outputs."""
    unit = evc.OnBoard()
    unit.step(0)
    block = 50_000

    def steps():
        first = unit.t_ms + 100
        for t_ms in range(first, first + 100 * block, 100):
            out = unit.step(t_ms=t_ms)
        del out

    return seconds(steps, 12) * 1_000_000 / block


def trains(count):
    return [{"brake_percentage": 180 + i % 41, "length_m": 20, "max_speed_kmh": 200} for i in range(count)]


def targets(count):
    return [{"type": "EOA_SvL", "location_m": 2000 + i} for i in range(count)]


def limits():
    """Seconds of limits over 100 trains, 200 speeds and 50 targets by broadcasting, and of as many single triples."""
    speeds = np.linspace(20.0, 195.0, 200)
    of_trains, of_targets = np.array(trains(100), dtype=object), np.array(targets(50), dtype=object)
    numbers = np.arange(TRIPLES)
    single = of_trains[numbers * 7 % 100], 20.0 + 175.0 * (numbers * 37 % 1000) / 1000.0, of_targets[numbers % 50]
    out = {name: np.empty((100, 200, 50)) for name in ("EBI", "SBI1", "SBI2", "FLOI", "W", "P", "I")}
    out_single = {name: np.empty(TRIPLES) for name in out}

    def of(triples, arrays):
        return seconds(lambda: evc.limits(*triples, track=TRACK, national_values=VALUES, out=arrays), 7)

    return of((of_trains[:, None, None], speeds[:, None], of_targets), out), of(single, out_single)


def batch(program):
    """Seconds of a million cases of the batch in C++, with 100 trains and the widest instructions."""
    done = subprocess.run([program, "--benchmark_filter=limits/.*/trains:100", "--benchmark_format=json",
                           "--benchmark_repetitions=3"], capture_output=True, text=True, check=True)
    runs = [run for run in json.loads(done.stdout)["benchmarks"] if run["run_type"] == "iteration"]
    return min(run["case"] for run in runs) * TRIPLES


def main():
    if sys.argv[2:] or not all(os.access(name, os.X_OK) for name in sys.argv[1:]):
        print("python_bench.py: found", *sys.argv[1:], "- expected the program batch_bench, or nothing", file=sys.stderr)
        return 2
    print(f"1 000 000 idle steps          {idle_steps():6.2f} s")
    broadcast, single = limits()
    print(f"limits, 100 x 200 x 50 cases  {1e3 * broadcast:6.1f} ms")
    print(f"limits, 1 000 000 triples     {1e3 * single:6.1f} ms")
    if len(sys.argv) > 1:
        alone = batch(sys.argv[1])
        print(f"batch in C++, as many cases   {1e3 * alone:6.1f} ms; {broadcast / alone:.2f} and {single / alone:.2f} times"
              " as long")
    return 0


if __name__ == "__main__":
    sys.exit(main())
