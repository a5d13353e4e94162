"""The kernel, one call a cycle: equal to `evc replay`, whole snapshots, many units, errors that change nothing."""
import copy
import gc
import json
import threading

import numpy as np
import pytest

import openevc as evc

TO_1 = {"select": "start"}


def drive(cycles, until=None):
    """All cycles of a journey by steps; yields the outputs."""
    config, by_time = cycles
    unit = evc.OnBoard(config)
    for t_ms in range(0, max(by_time) + 1 if until is None else until, unit.cycle_ms):
        yield unit.step(t_ms, **by_time.get(t_ms, {}))


def test_steps_give_the_lines_of_a_run(late, cycles):
    lines = late.outputs.splitlines()
    assert len(lines) > 10000
    answers = [out.json for out in drive(cycles)]
    assert answers == lines


def test_outputs_are_a_mapping_of_the_line(cycles):
    *_, out = drive(cycles, 60000)
    line = json.loads(out.json)
    assert dict(out) == line and list(out) == list(line) and len(out) == len(line)
    assert out["mode"] == line["mode"] and out.get("no such key") is None and "V_P" in out
    assert out == line and set(out.keys()) == set(line) and dict(out.items()) == line
    with pytest.raises(KeyError):
        out["no such key"]


def test_outputs_keep_their_cycle():
    unit = evc.OnBoard()
    kept = [unit.step() for _ in range(10)]
    assert [out["t_ms"] for out in kept] == [100 * i for i in range(10)]
    looked_at = unit.step()
    assert looked_at["t_ms"] == 1000
    del looked_at
    gc.collect()
    assert unit.step()["t_ms"] == 1100 and unit.step()["t_ms"] == 1200


def test_a_snapshot_goes_on_from_its_moment(cycles):
    config, by_time = cycles
    unit, other = evc.OnBoard(config), evc.OnBoard()
    middle, end = 300000, 420000
    for t_ms in range(0, middle, 100):
        unit.step(t_ms, **by_time.get(t_ms, {}))
    kept = unit.snapshot()
    expected = [unit.step(t_ms, **by_time.get(t_ms, {})).json for t_ms in range(middle, end, 100)]
    for again in (unit, other):
        again.restore(kept)
        assert again.t_ms == middle - 100
        assert [again.step(t_ms, **by_time.get(t_ms, {})).json for t_ms in range(middle, end, 100)] == expected


def test_signals_keep_their_value_and_are_part_of_a_snapshot():
    unit = evc.OnBoard()
    unit.step(train={"desk_open": True})
    kept = unit.snapshot()
    assert unit.step()["dialogue"] is not None
    unit.step(train={"desk_open": False})
    assert unit.step()["dialogue"] is None
    unit.restore(kept)
    assert unit.step()["dialogue"] is not None


def test_several_inputs_of_a_cycle_are_a_list():
    twice, one = evc.OnBoard(), evc.OnBoard()
    a = twice.step(0, train=[{"desk_open": True}, {"radio_registered": False}])
    b = one.step(0, train={"desk_open": True, "radio_registered": False})
    assert a.json == b.json


def test_planning_is_there_when_it_is_asked_for(cycles):
    config, by_time = cycles
    unit = evc.OnBoard(config, planning=True)
    seen = [unit.step(t_ms, **by_time.get(t_ms, {}))["planning"] for t_ms in range(0, 200000, 100)]
    assert seen[0] is None and any(plan is not None and plan["mrsp"] for plan in seen)


def test_the_record_of_the_display_is_that_of_replay(late, cycles, command, tmp_path):
    config, by_time = cycles
    stream = tmp_path / "inputs.jsonl"
    last = 120000
    stream.write_text("".join(line + "\n" for line in late.inputs.splitlines() if json.loads(line).get("t_ms", 0) <= last))
    status, lines, errors = command("replay", stream, "--dmi")
    assert status == 0, errors
    unit, other = evc.OnBoard(config, dmi=True), evc.OnBoard(config, dmi=True)
    answers = []
    for number, line in enumerate(lines.splitlines()):
        t_ms = json.loads(line)["t_ms"]
        if number == 400:  # with the sounds that were heard until then
            other.restore(unit.snapshot())
            unit = other
        answers.append(unit.step(t_ms, **by_time.get(t_ms, {})).json)
    assert len(answers) > 600 and answers == lines.splitlines()
    assert any(json.loads(answer)["dmi"]["sounds"] for answer in answers)
    assert evc.OnBoard(config).step()["dmi"] is None


def test_arguments_of_a_wrong_type_are_told_in_the_words_of_the_package():
    unit = evc.OnBoard()
    unit.step()
    with pytest.raises(evc.InputError, match="restore: snapshot: found a value of type int, expected what snapshot"):
        unit.restore(5)
    assert unit.step()["t_ms"] == 100
    with pytest.raises(evc.InputError, match="OnBoard: planning: found a value of type str, expected True or False"):
        evc.OnBoard(planning="yes")
    with pytest.raises(evc.InputError, match="OnBoard: dmi: found a value of type int"):
        evc.OnBoard(dmi=1)


def test_flags_of_numpy_are_flags():
    assert evc.OnBoard(planning=np.bool_(True), dmi=np.bool_(False)).step()["dmi"] is None
    assert evc.OnBoard(dmi=np.array(True)).step()["dmi"] is not None
    assert evc.OnBoard().step(0, train={"desk_open": np.bool_(True)})["t_ms"] == 0
    for wrong in (np.int64(1), np.float64(1.0), float("nan"), None, np.array([True]), np.array([True, False])):
        with pytest.raises(evc.InputError, match="OnBoard: planning: found a value of type .*, expected True or False$"):
            evc.OnBoard(planning=wrong)
        with pytest.raises(evc.InputError, match="desk_open|train"):
            evc.OnBoard().step(0, train={"desk_open": wrong})


def test_numbers_of_numpy_are_numbers():
    odometer = {key: np.float64(0.0) for key in ("nominal_m", "min_m", "max_m", "speed_mps")}
    unit = evc.OnBoard({"cycle_ms": np.int32(50)})
    assert unit.cycle_ms == 50
    assert unit.step(t_ms=np.int64(50), odometer=odometer)["t_ms"] == 50


def test_a_train_may_be_named_and_persistent_data_goes_on():
    unit = evc.OnBoard({"train": "regional_multiple_unit"})
    unit.step()
    kept = unit.retained
    assert kept["schema"] == "evc-persistent/1"
    again = evc.OnBoard({"train": "regional_multiple_unit"}, persistent=kept)
    assert again.step()["mode"] == "SB"
    with pytest.raises(evc.InputError, match="persistent"):
        evc.OnBoard(persistent={"schema": "evc-persistent/1"})


WRONG = [
    ({"odometer": {"nominal_m": float("nan")}}, "/odometer/nominal_m", "a finite number"),
    ({"odometer": {"nominal_mm": 1}}, "/odometer/nominal_mm", "one of at_ms"),
    ({"odometer": 3}, "/odometer", "an object"),
    ({"balise": {"telegram": "XY", "at_m": 0}}, "/balise/telegram", "hexadecimal digits"),
    ({"balise": [{"telegram": "90", "at_m": 0}, {"telegram": "90"}]}, "t_ms 100 [1] /balise", "one"),
    ({"driver": {"select": "everything"}}, "/driver/select", "one of"),
    ({"train": {"cab": "C"}}, "/train/cab", "one of"),
    ({"no_such_input": {}}, "/no_such_input", "one of"),
    ({"config": {}}, "/config", "the first line"),
    ({"train": {1: True}}, "/train", "a text"),
    ({"train": {"desk_open": object()}}, "/train/desk_open", "a number"),
    ({"train": {"desk_open": "\ud800"}}, "/train/desk_open", "Unicode"),
    ({"train": {"brake_pressure_kpa": 10 ** 30}}, "/train/brake_pressure_kpa", "a smaller one"),
    ({"radio": {"message": "0" * 4000}}, "/radio/message", "at most 1023"),
]


@pytest.mark.parametrize("inputs,where,expected", WRONG)
def test_a_wrong_input_is_an_error_and_changes_nothing(inputs, where, expected):
    unit, untouched = evc.OnBoard(), evc.OnBoard()
    for one in (unit, untouched):
        one.step(train={"desk_open": True})
    with pytest.raises(evc.InputError) as error:
        unit.step(t_ms=100, **inputs)
    assert where in error.value.where and expected in error.value.expected
    assert error.value.file == "step" and str(error.value).startswith("step: t_ms 100")
    assert unit.step().json == untouched.step().json


def test_the_sentence_is_that_of_the_command(command, tmp_path):
    path = tmp_path / "inputs.jsonl"
    path.write_text('{"t_ms":0}\n{"t_ms":100,"odometer":{"nominal_m":"x"}}\n')
    status, _, error = command("replay", path)
    unit = evc.OnBoard()
    unit.step()
    with pytest.raises(evc.InputError) as raised:
        unit.step(odometer={"nominal_m": "x"})
    assert status == 2
    assert error.split(" /odometer")[1].strip() == str(raised.value).split(" /odometer")[1]


@pytest.mark.parametrize("t_ms", [-1, 0.5, "1", True, 2 ** 80, -2 ** 80, float("nan"), [1], 90_000_000_000])
def test_a_wrong_time_is_an_error(t_ms):
    unit = evc.OnBoard()
    unit.step(0)
    with pytest.raises(evc.InputError, match="t_ms"):
        unit.step(t_ms)
    assert unit.step()["t_ms"] == 100


def test_time_goes_forward():
    unit = evc.OnBoard()
    unit.step(1000)
    with pytest.raises(evc.InputError, match="a time after 1000"):
        unit.step(1000)
    assert unit.step()["t_ms"] == 1100


@pytest.mark.parametrize("config", [3, [], {"srs": "9"}, {"cycle_ms": 0}, {"unknown": 1}, "no/such/file.json",
                                    {"train": "no_such_train"}, {"train": {"brake_percentage": 1e9}}, float("inf")])
def test_a_wrong_configuration_is_an_error(config):
    with pytest.raises(evc.InputError):
        evc.OnBoard(config)


def test_only_a_snapshot_is_restored():
    unit = evc.OnBoard()
    for other in (None, b"snapshot", unit, 1):
        with pytest.raises((TypeError, ValueError)):
            unit.restore(other)
    with pytest.raises(TypeError):
        evc.Snapshot()
    with pytest.raises(TypeError):
        copy.deepcopy(unit)


def test_objects_without_a_constructor_are_errors():
    unit = evc.OnBoard.__new__(evc.OnBoard)
    for use in (unit.step, unit.snapshot, lambda: unit.retained, lambda: unit.cycle_ms,
                lambda: dict(evc.Outputs.__new__(evc.Outputs)), lambda: evc.Outputs.__new__(evc.Outputs).json):
        with pytest.raises(TypeError):
            use()
    with pytest.raises(evc.InputError):
        evc.OnBoard().restore(evc.Snapshot.__new__(evc.Snapshot))


def test_cyclic_and_deep_values_are_errors():
    cyclic = {}
    cyclic["train"] = cyclic
    with pytest.raises(evc.InputError, match="in one another"):
        evc.OnBoard().step(train=cyclic)


def test_many_units_in_many_threads(cycles):
    expected = [out.json for out in drive(cycles, 120000)]
    answers = {}

    def work(number):
        answers[number] = [out.json for out in drive(cycles, 120000)]

    threads = [threading.Thread(target=work, args=(i,)) for i in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(answers) == 4 and all(answer == expected for answer in answers.values())


def test_one_unit_in_many_threads_is_no_crash():
    unit = evc.OnBoard()
    errors = []

    class Slow:
        def tolist(self):
            threading.Event().wait(1e-5)
            return True

    def work():
        for _ in range(200):
            try:
                unit.step(train={"desk_open": Slow()})
            except evc.InputError as error:
                errors.append(error)

    threads = [threading.Thread(target=work) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert unit.step()["mode"] in ("SB", "NP")
    assert len(errors) < 800
