"""Curves as arrays: the values, texts and errors of `evc curves`; plots."""
import json
import pathlib

import matplotlib.pyplot as plt
import numpy as np
import pytest

import openevc as evc

EOA = {"type": "EOA_SvL", "location_m": 6000, "release_speed_kmh": 30}
SHIPPED = ["freight_G", "freight_P", "freight_downhill", "high_speed_stop", "passenger_eoa", "push_pull_loa",
           "regional_restriction", "workbook"]


@pytest.mark.parametrize("name", SHIPPED)
def test_the_answer_is_that_of_the_command(name, source, command):
    path = source / "data" / "curves" / f"{name}.json"
    for query in (name, path, str(path)):
        curves = evc.curves(query)
        assert curves.json == command("curves", path)[1]
    result = json.loads(curves.json)
    assert list(curves) == list(result["by_speed"][0])
    for row, expected in enumerate(result["by_speed"]):
        for key, value in expected.items():
            assert (value is None and np.isnan(curves[key][row])) or curves[key][row] == value
    for row, expected in enumerate(result["by_position"]):
        assert all(curves.by_position[key][row] == value for key, value in expected.items() if value is not None)
    assert curves.scalars == result["scalars"] and curves.notes == result.get("notes", [])
    assert curves.PBD == result.get("PBD", []) and curves.LX == result.get("LX", [])


def test_members_make_a_query():
    curves = evc.curves(train="regional_multiple_unit", target=EOA, speeds_kmh=np.arange(0.0, 150.0, 50.0),
                        positions_m=[4000, 5000])
    assert curves["v_kmh"].tolist() == [0.0, 50.0, 100.0] and curves.scalars["V_release_kmh"] == 30.0
    assert np.all(np.diff(curves["EBI"]) > 0) and np.all(curves["I"][1:] > curves["P"][1:])
    assert len(curves.by_position["EBI"]) == 2 and isinstance(curves, dict)
    assert all(array.dtype == np.float64 and array.flags.writeable for array in curves.values())


def test_members_replace_those_of_a_query():
    plain = evc.curves("passenger_eoa", speeds_kmh=[100])
    weaker = evc.curves("passenger_eoa", speeds_kmh=[100], train={"brake_percentage": 90})
    assert weaker["EBI"][0] > plain["EBI"][0]
    document = {"schema": "evc-curves/1", "train": {"brake_percentage": 90}, "target": EOA}
    assert evc.curves(document, speeds_kmh=[100]).json == evc.curves(speeds_kmh=[100], **document).json


def test_explain_is_the_page_of_the_command(source, command):
    path = source / "data" / "curves" / "passenger_eoa.json"
    assert evc.curves("passenger_eoa").explain(100) == command("curves", path, "--explain", "100")[1]


WRONG = [
    ({}, "/", "one"),
    ({"train": {}, "target": {"type": "EOA"}}, "/target/type", "one of"),
    ({"train": {}, "target": EOA | {"location_m": float("nan")}}, "/target/location_m", "finite"),
    ({"train": {}, "target": EOA | {"location_m": "far"}}, "/target/location_m", "a number"),
    ({"train": "no_such_train", "target": EOA}, "/train", "a shipped one"),
    ({"train": {"brake_percentage": 1e9}, "target": EOA}, "/train/brake_percentage", ""),
    ({"train": {}, "target": EOA, "speeds_kmh": [[1, 2]]}, "/query/speeds_kmh/0", "a number"),
    ({"train": {}, "target": EOA, "speeds_kmh": np.array([1.0, np.nan])}, "/query/speeds_kmh/1", "finite"),
    ({"train": {}, "target": EOA, "speeds_kmh": np.array(["a"])}, "/query/speeds_kmh/0", "a number"),
    ({"train": {}, "target": EOA, "speeds_kmh": np.zeros((2, 2))}, "/query/speeds_kmh/0", "a number"),
    ({"train": {}, "target": EOA, "speeds_kmh": 1}, "/query/speeds_kmh", "an object"),
    ({"train": {}, "target": EOA, "speeds_kmh": np.zeros(200001)}, "/query/speeds_kmh", "at most"),
    ({"train": {}, "target": EOA, "wrong": 1}, "/wrong", "one of"),
    ({"train": {}, "target": EOA, "query": 1, "speeds_kmh": [1]}, "/query", "an object"),
]


@pytest.mark.parametrize("members,where,expected", WRONG)
def test_a_wrong_member_is_an_error(members, where, expected):
    with pytest.raises(evc.InputError) as error:
        evc.curves(**members)
    assert where in error.value.where and expected in error.value.expected


def test_a_wrong_query_is_the_sentence_of_the_command(command, tmp_path):
    path = tmp_path / "query.json"
    path.write_text('{"schema":"evc-curves/1",\n "train": {},\n "target": }')
    status, _, error = command("curves", path)
    with pytest.raises(evc.InputError) as raised:
        evc.curves(path)
    assert status == 2 and str(raised.value) == error.strip()
    with pytest.raises(evc.InputError, match="a shipped one"):
        evc.curves("no_such_query")
    with pytest.raises(evc.InputError):
        evc.curves(3)


@pytest.mark.parametrize("v_kmh", [float("nan"), -1.0, 601.0, 1e300, "a", None, [100]])
def test_a_wrong_speed_is_not_explained(v_kmh):
    with pytest.raises(evc.InputError, match="v_kmh"):
        evc.curves("passenger_eoa").explain(v_kmh)


@pytest.mark.parametrize("name", ["passenger_eoa", "regional_restriction", "push_pull_loa"])
def test_a_plot_has_the_curves(name):
    axes = evc.curves(name).plot()
    labels = [line.get_label() for line in axes.get_lines()]
    for curve in ("MRSP", "EBD", "EBI", "SBI", "W ", "P ", "I "):
        assert any(label.startswith(curve) for label in labels), (curve, labels)
    assert axes.get_xlabel() == "place on the line, m" and axes.get_ylabel() == "speed, km/h"
    assert axes.get_ylim()[0] == 0.0
    plt.close(axes.figure)


def test_a_plot_is_drawn_where_it_is_asked_for():
    figure, axes = plt.subplots()
    assert evc.curves("passenger_eoa").plot(ax=axes) is axes
    figure.canvas.draw()
    plt.close(figure)


def test_matplotlib_is_imported_by_a_plot_alone():
    package = pathlib.Path(evc.__file__).parent
    importing = [path.name for path in package.glob("*.py") if "import matplotlib" in path.read_text()]
    assert importing == ["_plot.py"]
    assert "from ._plot import draw" in (package / "_curves.py").read_text()
    assert not any("_plot" in path.read_text() for path in package.glob("*.py") if path.name != "_curves.py")


MASKED = np.ma.array([10.0, 20.0], mask=[False, True])


@pytest.mark.parametrize("call", [
    lambda: evc.curves("passenger_eoa", speeds_kmh=MASKED),
    lambda: evc.curves("passenger_eoa", positions_m=MASKED),
    lambda: evc.curves("passenger_eoa", speeds_kmh=[10.0, np.ma.masked]),
    lambda: evc.curves("passenger_eoa", track={"gradient": np.ma.array([[0, 1], [9, 2]], mask=[[0, 0], [0, 1]])}),
    lambda: evc.curves("passenger_eoa", speeds_kmh=np.ma.array([(1.0, 2)], [("a", "f8"), ("b", "i4")], mask=[(0, 1)])),
    lambda: evc.run("brunnental", seed=np.ma.masked),
    lambda: evc.OnBoard({"train": "regional_multiple_unit"}).step(t_ms=np.ma.masked),
    lambda: evc.sweep({"schema": "evc-sweep/1", "kind": "run", "base": {}, "vary": [{"at": "/seed", "list": MASKED}]}),
    lambda: evc.encode.packet({"NID_PACKET": np.ma.masked}),
])
def test_what_is_masked_is_never_none_nor_a_number(call):
    with pytest.raises(evc.InputError, match="found masked values, expected values without a mask"):
        call()


def test_an_array_of_numbers_of_any_kind_is_read():
    speeds = [50.0, 60.5]
    expected = evc.curves("passenger_eoa", speeds_kmh=speeds)["EBI"]
    read_only = np.array(speeds)
    read_only.setflags(write=False)
    for same in (np.array(speeds), np.array(speeds, ">f8"), np.array(speeds, np.longdouble), np.array(speeds, object),
                 [np.longdouble(50), np.float32(60.5)], np.ma.array(speeds), read_only, np.array([speeds, speeds])[:, ::-1][0][::-1]):
        assert np.array_equal(evc.curves("passenger_eoa", speeds_kmh=same)["EBI"], expected)


@pytest.mark.parametrize("kind", ["datetime64[ns]", "timedelta64[ns]", "datetime64[D]"])
def test_times_are_no_speeds(kind):
    with pytest.raises(evc.InputError, match="numpy.ndarray with times, expected numbers"):
        evc.curves("passenger_eoa", speeds_kmh=np.array([50], kind))
