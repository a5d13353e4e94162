"""Journeys: the files of `evc run`, traces as arrays, errors, Ctrl-C."""
import hashlib
import json
import os
import signal
import threading
import time

import numpy as np
import pytest

import openevc as evc
from openevc import _runs


@pytest.fixture(name="recorded", scope="module")
def fixture_recorded(command, tmp_path_factory):
    folder = tmp_path_factory.mktemp("late")
    status, _, error = command("run", "--driver", "late", "--seed", "3", "-o", folder)
    assert status == 0, error
    return folder


def without_times(summary):
    return {key: value for key, value in summary.items() if key not in ("cycle_us", "real_time_factor")}


def test_a_run_is_that_of_the_command(late, recorded):
    assert late.inputs == (recorded / "inputs.jsonl").read_text()
    assert late.outputs == (recorded / "outputs.jsonl").read_text()
    assert without_times(late.summary) == without_times(json.loads((recorded / "summary.json").read_text()))
    assert late.summary["output_hash"] == hashlib.sha256(late.outputs.encode()).hexdigest()
    assert late.fault is None


def test_the_trace_has_the_values_of_the_lines(late, recorded):
    trace = late.trace
    assert len(trace) == late.summary["cycles"]
    assert trace.dtype.names == tuple((recorded / "trace.csv").read_text().splitlines()[0].split(","))
    for row, line in zip(trace[::997], map(json.loads, late.outputs.splitlines()[::997])):
        assert row["t_ms"] == line["t_ms"] and row["mode"] == line["mode"] and row["level"] == line["level"]
        assert bool(row["eb"]) is line["eb"]
        for name in ("est_front_m", "v_kmh", "V_P", "V_EBI", "d_target_m", "V_release"):
            assert (line[name] is None and np.isnan(row[name])) or row[name] == line[name]
        assert row["events"] == ";".join(line["events"])


def test_types_of_the_trace_do_not_depend_on_the_journey(late):
    reckless = evc.run(driver="reckless", seed=7, train="regional_multiple_unit").trace
    assert reckless["eb"].any() and not late.trace["eb"].any()
    kinds = [[trace.dtype[name].kind for name in trace.dtype.names] for trace in (late.trace, reckless)]
    assert kinds[0] == kinds[1] and late.trace.dtype["V_P"] == np.float64 and late.trace.dtype["t_ms"] == np.int64
    # A text in a column that is not listed as one would be an error: all names are those of the trace.
    assert _runs._FLAGS | _runs._NAMES | _runs._LISTS <= set(late.trace.dtype.names)


def test_the_files_are_those_of_the_command(recorded, tmp_path):
    evc.run(driver="late", seed=3, output=tmp_path)
    assert {path.name for path in tmp_path.iterdir()} == {path.name for path in recorded.iterdir()}
    for name in ("inputs.jsonl", "outputs.jsonl", "trace.csv"):
        assert (tmp_path / name).read_bytes() == (recorded / name).read_bytes()


def test_arguments_have_an_effect(late):
    assert evc.run(driver="late", seed=4).outputs != late.outputs
    assert evc.run(odometer="under").summary["max_position_error_m"] > 1.0
    assert evc.run(odometer={"error": 0.02}).summary["confidence_interval_violations"] == 0
    assert evc.run(last_ma=1).summary["distance_m"] < late.summary["distance_m"]
    assert evc.run(train={"brake_percentage": 100}, srs="4.0.0").summary["modes"]
    assert '"clock":{"utc":"2026-01-01T08:00:00Z"}' in evc.run(utc="2026-01-01T08:00:00Z").inputs


WRONG = [
    ({"line": "no_such_line"}, "/line", "a shipped one"),
    ({"line": {"schema": "etcs-line/1"}}, "", ""),
    ({"line": 3}, "/line", "an object"),
    ({"line": "a\0b"}, "/line", ""),
    ({"train": "x/y.json"}, "/train", "a shipped one"),
    ({"train": {"brake_percentage": float("nan")}}, "/train/brake_percentage", "finite"),
    ({"driver": "sleepy"}, "/driver", 'one of "perfect", "late", "reckless"'),
    ({"seed": -1}, "/seed", "an integer"),
    ({"seed": 1.5}, "/seed", "an integer"),
    ({"cycle_ms": 0}, "/cycle_ms", "an integer"),
    ({"odometer": "none"}, "/odometer", "one of"),
    ({"odometer": {"error": 0.5}}, "/odometer/error", "-0.3"),
    ({"output": "/proc/no/folder"}, "", "can be written"),
]


@pytest.mark.parametrize("arguments,where,expected", WRONG)
def test_a_wrong_argument_is_an_error(arguments, where, expected):
    with pytest.raises(evc.InputError) as error:
        evc.run(**arguments)
    assert where in error.value.where and expected in error.value.expected


def test_a_wrong_file_is_the_sentence_of_the_command(command, tmp_path):
    path = tmp_path / "train.json"
    path.write_text('{"schema":"etcs-train/1","brake_percentage":-1}')
    status, _, error = command("run", "--train", path)
    with pytest.raises(evc.InputError) as raised:
        evc.run(train=path)
    assert status == 2 and str(raised.value) == error.strip()


def test_an_unknown_argument_is_a_type_error():
    with pytest.raises(TypeError):
        evc.run(speed=3)


def interrupted(call):
    """The exception of Ctrl-C during a call, and how long it took to come."""
    pressed = []

    def press():
        pressed.append(time.monotonic())
        os.kill(os.getpid(), signal.SIGINT)

    # A process in the background begins without the handler of Ctrl-C.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    timer = threading.Timer(0.3, press)
    timer.start()
    try:
        call()
    except KeyboardInterrupt as error:
        return error, time.monotonic() - pressed[0]
    finally:
        timer.cancel()
        signal.signal(signal.SIGINT, before)
    return None, 0.0


def test_ctrl_c_ends_a_run_within_a_second(late):
    # With cycles of a millisecond it takes a hundred times as long.
    error, seconds = interrupted(lambda: evc.run(driver="late", seed=3, cycle_ms=1))
    assert isinstance(error, evc.Interrupted) and seconds < 1.0
    run = error.results
    assert 0 < run.summary["cycles"] == len(run.trace) == run.outputs.count("\n")
    assert run.summary["output_hash"] == hashlib.sha256(run.outputs.encode()).hexdigest()
    assert run.outputs.endswith("}\n") and json.loads(run.outputs.splitlines()[-1])


def test_ctrl_c_ends_limits_within_a_second():
    # Build-up times of 4.0.0 that may be reduced are computed one case at a time: below the target speed.
    speeds = np.linspace(1.0, 140.0, 10_000_000)
    arguments = {"srs": "4.0.0", "state": {"est_front_m": 0}, "columns": ("EBI", "P")}
    target = {"type": "LOA", "location_m": 3000, "speed_kmh": 140}
    error, seconds = interrupted(lambda: evc.limits("standard", speeds, target, **arguments))
    assert isinstance(error, evc.Interrupted) and seconds < 1.0
    count = error.results["EBI"].size
    assert 0 < count < speeds.size and np.isfinite(error.results["EBI"]).all()
    whole = evc.limits("standard", speeds[:count:max(1, count // 50)], target, **arguments)
    assert np.array_equal(error.results["P"][:count:max(1, count // 50)], whole["P"])


def test_ctrl_c_ends_limits_of_large_arrays_within_a_second():
    # 8 GB of results, of which a part is ever used.
    speeds = np.linspace(1.0, 140.0, 1000)
    trains = np.full((1, 200_000, 1), {"brake_percentage": 90}, dtype=object)
    target = {"type": "EOA_SvL", "location_m": 3000}
    error, seconds = interrupted(lambda: evc.limits(trains, speeds, target, columns=("EBD", "EBI", "SBI1", "P", "I")))
    assert isinstance(error, evc.Interrupted) and seconds < 1.0
    some = error.results["P"]
    done = np.isfinite(some).reshape(-1)
    assert some.shape[0] == 1 and 0 < some.shape[1] < 200_000 and some.shape[2] == speeds.size
    assert done[:done.sum()].all() and done.size - done.sum() < speeds.size
    assert np.array_equal(some[0, 0], evc.limits(trains[0, 0, 0], speeds, target)["P"])


def test_ctrl_c_leaves_arrays_of_the_caller_with_nan_behind_the_last_case():
    speeds = np.linspace(1.0, 140.0, 20_000_000)
    out = {"EBI": np.full(speeds.size, -1.0)}
    target = {"type": "LOA", "location_m": 3000, "speed_kmh": 140}
    error, seconds = interrupted(lambda: evc.limits("standard", speeds, target, columns=("EBI", "P"), srs="4.0.0", out=out))
    assert isinstance(error, evc.Interrupted) and seconds < 1.0
    done = np.isfinite(out["EBI"])
    assert error.results["EBI"] is out["EBI"] and error.results["P"].size == done.sum() > 0
    assert done[:done.sum()].all() and not done[-1]


def test_ctrl_c_ends_a_sweep_within_a_second():
    spec = {"schema": "evc-sweep/1", "kind": "run", "base": {"line": "brunnental", "driver": "late"},
            "vary": [{"at": "/seed", "count": 10000}], "measure": ["duration_s"]}
    error, seconds = interrupted(lambda: evc.sweep(spec, threads=2))
    assert isinstance(error, evc.Interrupted) and seconds < 1.0
    results = error.results
    assert results.cases == 10000 and len(results["number"]) == len(results["duration_s"]) < 10000


def test_another_handler_raises_its_own_exception():
    class Mine(Exception):
        pass

    def handler(*_):
        raise Mine

    before = signal.signal(signal.SIGINT, handler)
    try:
        with pytest.raises(Mine):
            timer = threading.Timer(0.2, lambda: os.kill(os.getpid(), signal.SIGINT))
            timer.start()
            evc.run(cycle_ms=1)
    finally:
        signal.signal(signal.SIGINT, before)
