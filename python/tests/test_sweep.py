"""Sweeps: the table of `evc sweep`, errors."""
import csv
import io
import json

import numpy as np
import pytest

import openevc as evc

CURVES = {"schema": "evc-sweep/1", "kind": "curves", "base": {"query": "passenger_eoa"},
          "vary": [{"at": "/train/brake_percentage", "list": [90, 120, 1e9, 150]}, {"at": "/query/speeds_kmh", "list": [[140]]}],
          "measure": ["by_speed.0.EBI", "scalars.T_be_s", "by_speed.EBI"]}


@pytest.mark.parametrize("threads", [0, 1, 3])
def test_the_table_is_that_of_the_command(threads, command, tmp_path):
    path = tmp_path / "spec.json"
    path.write_text(json.dumps(CURVES))
    rows = list(csv.reader(io.StringIO(command("sweep", path, "--format", "csv")[1])))
    for spec in (CURVES, path, str(path)):
        table = evc.sweep(spec, threads=threads)
        assert list(table) == rows[0] and table.cases == 4 and table.failed == 1
        for row in range(4):
            for name, cell in zip(rows[0], rows[1 + row]):
                value = table[name][row]
                if cell == "":
                    assert value is None or np.isnan(value)
                elif isinstance(value, (float, np.floating)):
                    assert value == float(cell)
                else:
                    assert str(value) == cell
    assert table["by_speed.0.EBI"].dtype == np.float64 and table["number"].tolist() == [0, 1, 2, 3]


def test_journeys_are_those_of_run():
    table = evc.sweep({"schema": "evc-sweep/1", "kind": "run", "base": {"driver": "late"},
                       "vary": [{"at": "/seed", "list": [3]}], "measure": ["output_hash", "duration_s"]})
    run = evc.run(driver="late", seed=3)
    assert table["output_hash"][0] == run.summary["output_hash"] and table["duration_s"][0] == run.summary["duration_s"]


@pytest.mark.parametrize("spec", [{}, {"schema": "evc-sweep/1"}, CURVES | {"kind": "none"}, CURVES | {"vary": []}, 3, None, [],
                                  "no/such/file.json", CURVES | {"measure": ["none"]},
                                  CURVES | {"vary": [{"at": "/nowhere/at/all", "list": [1]}]},
                                  CURVES | {"vary": [{"at": "/train/brake_percentage", "list": []}]},
                                  CURVES | {"vary": [{"at": "/train/brake_percentage", "uniform": [float("nan"), 1]}]}])
def test_a_wrong_description_is_an_error(spec):
    with pytest.raises(evc.InputError):
        evc.sweep(spec)


@pytest.mark.parametrize("threads", [np.int64(1), np.uint8(2), np.array(1)])
def test_numbers_of_numpy_are_numbers_of_threads(threads):
    assert evc.sweep(CURVES, threads=threads).cases == evc.sweep(CURVES).cases


@pytest.mark.parametrize("threads", [1.0, 2.5, float("nan"), "x", None, True, np.bool_(True), np.array([1, 2]), 2**70])
def test_threads_of_another_type_are_an_error_of_one_line(threads):
    with pytest.raises(evc.InputError, match="^sweep: /threads.*: found .*, expected .*$") as error:
        evc.sweep(CURVES, threads=threads)
    assert "\n" not in str(error.value)


@pytest.mark.parametrize("threads", [-1, 5000])
def test_a_wrong_number_of_threads_is_an_error(threads):
    with pytest.raises(evc.InputError, match="threads"):
        evc.sweep(CURVES, threads=threads)


def test_the_sentence_is_that_of_the_command(command, tmp_path):
    path = tmp_path / "spec.json"
    path.write_text(json.dumps(CURVES | {"measure": ["none"]}))
    with pytest.raises(evc.InputError) as raised:
        evc.sweep(path)
    assert str(raised.value) == command("sweep", path)[2].strip()
