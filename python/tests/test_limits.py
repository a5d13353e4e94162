"""Limits of many trains, speeds and targets: the doubles of `curves`, broadcasting, errors, threads."""
import threading

import numpy as np
import pytest

import openevc as evc
from openevc import _native

TRAINS = ["standard", "regional_multiple_unit", "freight_P_loaded", {"brake_percentage": 90}]
TARGETS = [{"type": "EOA_SvL", "location_m": 3000},
           {"type": "EOA_SvL", "location_m": 3000, "svl_location_m": 3200},
           {"type": "LOA", "location_m": 2500, "speed_kmh": 60},
           {"type": "MRSP", "location_m": 2000, "speed_kmh": 40},
           {"type": "SR", "location_m": 1000}]
TRACK = {"gradient": [[-1000, -4], [500, 8], [2200, -12]]}
SPEEDS = [10.0, 55.5, 99.9]
ALL = _native.limit_names


@pytest.mark.parametrize("srs", ["3.6.0", "4.0.0", "3.4.0"])
@pytest.mark.parametrize("state", [None, {"A_est": 0.3, "V_ura_kmh": 2.0}])
def test_every_limit_is_that_of_curves(srs, state):
    some = evc.limits(np.array(TRAINS, dtype=object)[:, None, None], np.array(SPEEDS)[:, None], TARGETS, columns=ALL,
                      track=TRACK, srs=srs, state=state)
    assert all(array.shape == (4, 3, 5) for array in some.values()) and tuple(some) == ALL
    compared = 0
    for i, train in enumerate(TRAINS):
        for k, target in enumerate(TARGETS):
            one = evc.curves(train=train, target=target, track=TRACK, srs=srs, state=state, speeds_kmh=SPEEDS)
            for name in ("EBD", "SBD", "GUI", "EBI", "SBI1", "SBI2", "FLOI", "W", "P", "I"):
                if srs == "3.4.0" and name in ("EBI", "P", "I"):
                    continue  # `evc curves` draws these as the official tool of that issue does
                assert np.array_equal(some[name][i, :, k], one[name], equal_nan=True), (name, train, target)
                compared += np.isfinite(one[name]).sum()
    assert compared > 250


def test_shapes_are_broadcast():
    target = TARGETS[0]
    assert evc.limits("standard", 100.0, target)["EBI"].shape == ()
    assert evc.limits("standard", [100.0, 50.0], target)["EBI"].shape == (2,)
    assert evc.limits(TRAINS, 100, TARGETS[:4])["P"].shape == (4,)
    assert evc.limits(TRAINS, np.zeros((7, 1)), TARGETS[0])["P"].shape == (7, 4)
    assert evc.limits([], 100.0, target)["EBI"].shape == (0,)
    assert evc.limits("standard", np.zeros((0, 3)), target)["EBI"].shape == (0, 3)
    assert tuple(evc.limits("standard", 100.0, target, columns="EBI")) == ("EBI",)


def test_an_array_of_any_layout_is_read_as_it_is():
    speeds = np.arange(240.0).reshape(12, 20) / 2
    straight = evc.limits("standard", speeds, TARGETS[0])["EBI"]
    for other in (np.asfortranarray(speeds), speeds.astype(np.float32), np.repeat(speeds, 2, axis=1)[:, ::2],
                  speeds[::-1][::-1], speeds.astype(">f8")):
        assert np.array_equal(evc.limits("standard", other, TARGETS[0])["EBI"], straight)
    assert np.array_equal(evc.limits("standard", speeds.T, TARGETS[0])["EBI"], straight.T)
    whole = np.arange(120)
    assert np.array_equal(evc.limits("standard", whole, TARGETS[0])["P"],
                          evc.limits("standard", whole.astype(float), TARGETS[0])["P"])


def test_a_large_array_is_that_of_its_parts():
    random = np.random.default_rng(1)
    speeds = random.uniform(0.0, 160.0, 50_000)
    trains = np.array(TRAINS, dtype=object)[random.integers(0, len(TRAINS), speeds.size)]
    targets = np.array(TARGETS, dtype=object)[random.integers(0, len(TARGETS), speeds.size)]
    whole = evc.limits(trains, speeds, targets, track=TRACK)
    for i in random.integers(0, speeds.size, 50):
        one = evc.limits(trains[i], speeds[i], targets[i], track=TRACK)
        assert all(np.array_equal(whole[name][i], one[name], equal_nan=True) for name in whole)


def test_many_different_objects_and_any_layout_keep_their_places():
    random = np.random.default_rng(2)
    trains = np.array([{"brake_percentage": 60 + i % 90} for i in range(3000)], dtype=object)[random.permutation(3000)]
    speeds = random.uniform(10.0, 140.0, (2, 3, 3000))
    targets = np.array(TARGETS, dtype=object)[:3, None]
    whole = evc.limits(trains, speeds[::-1], targets)
    turned = evc.limits(trains[::-1][:, None, None], speeds.transpose(2, 0, 1)[::-1, ::-1], targets[:, 0])
    for name in whole:
        assert np.array_equal(turned[name].transpose(1, 2, 0)[:, :, ::-1], whole[name], equal_nan=True)
    for i in random.integers(0, 3000, 30):
        one = evc.limits(trains[i], speeds[::-1, :, i], targets[:, 0])
        assert all(np.array_equal(whole[name][:, :, i], one[name], equal_nan=True) for name in whole)


MASKED = np.ma.array([10.0, 20.0, 30.0], mask=[False, True, False])


def masked(value):
    return np.ma.array(np.array([value, value], dtype=object), mask=[False, True])


@pytest.mark.parametrize(("arguments", "sentence"), [
    (("standard", MASKED, TARGETS[0]), "limits: speeds[1]: found a masked value, expected a number from 0.0 to 600.0"),
    (("standard", [MASKED, MASKED], TARGETS[0]),
     "limits: speeds[0, 1]: found a masked value, expected a number from 0.0 to 600.0"),
    (("standard", [1.0, np.ma.masked], TARGETS[0]),
     "limits: speeds[1]: found a masked value, expected a number from 0.0 to 600.0"),
    (("standard", np.ma.masked, TARGETS[0]), "limits: speeds: found a masked value, expected a number from 0.0 to 600.0"),
    ((masked("standard"), 10.0, TARGETS[0]), "limits: trains[1]: found a masked value, expected one of the trains"),
    (("standard", 10.0, masked(TARGETS[0])), "limits: targets[1]: found a masked value, expected one of the targets"),
    (("standard", [10**30], TARGETS[0]), "limits: speeds: found an array of object, expected numbers, km/h"),
    (("standard", np.array([1], "datetime64[s]"), TARGETS[0]),
     "limits: speeds: found an array of datetime64[s], expected numbers, km/h"),
    (("standard", np.array([(1.0, 2)], [("a", "f8"), ("b", "i4")]), TARGETS[0]),
     "limits: speeds: found an array of [('a', '<f8'), ('b', '<i4')], expected numbers, km/h"),
])
def test_what_is_masked_or_no_number_is_refused(arguments, sentence):
    with pytest.raises(evc.InputError) as error:
        evc.limits(*arguments)
    assert str(error.value) == sentence


def test_an_array_without_anything_masked_is_an_array():
    plain = evc.limits("standard", SPEEDS, TARGETS[0])["EBI"]
    read_only = np.array(SPEEDS)
    read_only.setflags(write=False)
    for same in (np.ma.array(SPEEDS), np.ma.array(SPEEDS, mask=[False] * 3), read_only, np.longdouble(SPEEDS),
                 np.array(SPEEDS, ">f8")):
        assert np.array_equal(evc.limits("standard", same, TARGETS[0])["EBI"], plain)
    nothing = np.array("standard", dtype=object), np.array(10.0), np.array(TARGETS[0], dtype=object)
    assert evc.limits(*nothing)["EBI"].shape == ()


def test_results_do_not_meet_one_another_or_the_speeds():
    with pytest.raises(evc.InputError) as error:
        evc.limits("standard", SPEEDS, TARGETS[0], columns="EBI", out={"EBI": np.ma.zeros(3)})
    assert str(error.value) == "limits: out['EBI']: found an array with a mask, expected an array without one"
    one = np.zeros(3)
    with pytest.raises(evc.InputError) as error:
        evc.limits("standard", SPEEDS, TARGETS[0], columns=("EBI", "P"), out={"EBI": one, "P": one})
    assert str(error.value) == "limits: out['P']: found the memory of out['EBI'], expected an array of its own"
    speeds = np.linspace(0.0, 160.0, 100_000)
    expected = evc.limits("standard", speeds[::-1], TARGETS[0], columns="EBI")["EBI"]
    evc.limits("standard", speeds[::-1], TARGETS[0], columns="EBI", out={"EBI": speeds})
    assert np.array_equal(speeds, expected)


def test_arrays_of_the_caller_are_filled():
    out = {"EBI": np.full(3, -1.0), "P": None}
    result = evc.limits("standard", SPEEDS, TARGETS[0], columns=("EBI", "P"), out=out)
    assert result["EBI"] is out["EBI"] and np.all(out["EBI"] > 0) and result["P"].shape == (3,)
    for wrong in (np.zeros(2), np.zeros(3, np.float32), np.zeros(6)[::2], [0.0] * 3, np.broadcast_to(0.0, 3)):
        with pytest.raises(evc.InputError, match="out"):
            evc.limits("standard", SPEEDS, TARGETS[0], columns="EBI", out={"EBI": wrong})


@pytest.mark.parametrize("key", ["EBl", "W", 3])
def test_an_array_that_would_not_be_filled_is_an_error(key):
    with pytest.raises(evc.InputError) as error:
        evc.limits("standard", SPEEDS, TARGETS[0], columns=("EBI", "P"), out={"EBI": np.zeros(3), key: np.zeros(3)})
    assert str(error.value) == f"limits: out: found the key {key!r}, expected one of the columns: EBI, P"


WRONG = [
    (("standard", [1.0, float("nan")], TARGETS[0]), {}, "speeds[1]", "600"),
    (("standard", [[1.0, 2.0], [3.0, -0.1]], TARGETS[0]), {}, "speeds[1, 1]", "600"),
    (("standard", np.inf, TARGETS[0]), {}, "speeds", "600"),
    (("standard", ["fast"], TARGETS[0]), {}, "speeds", "numbers"),
    (("standard", [1j], TARGETS[0]), {}, "speeds", "numbers"),
    (("standard", None, TARGETS[0]), {}, "speeds", "numbers"),
    (("standard", [[1.0], [1.0, 2.0]], TARGETS[0]), {}, "speeds", "numbers"),
    ((["standard"] * 3, [1.0, 2.0], TARGETS[0]), {}, "shapes", "broadcasts"),
    (("standard", 1.0, [TARGETS[0], {"type": "EOA"}]), {}, "/target/type", "one of"),
    (("standard", 1.0, [TARGETS[0], None]), {}, "/target", "an object"),
    (("standard", 1.0, {"type": "EOA_SvL", "location_m": float("inf")}), {}, "location_m", "finite"),
    ((["standard", "no_such_train"], 1.0, TARGETS[0]), {}, "/train", "a shipped one"),
    ((["standard", 7], 1.0, TARGETS[0]), {}, "/train", "an object"),
    (([["a"], ["b", "c"]], 1.0, TARGETS[0]), {}, "", ""),
    (("standard", 1.0, TARGETS[0]), {"columns": ("EBI", "XYZ")}, "columns", "one of EBD"),
    (("standard", 1.0, TARGETS[0]), {"track": {"gradients": []}}, "/track/gradients", "one of"),
    (("standard", 1.0, TARGETS[0]), {"srs": "9"}, "/srs", "one of"),
    (("standard", 1.0, TARGETS[0]), {"state": {"A_est": float("nan")}}, "/state/A_est", "finite"),
]


@pytest.mark.parametrize("arguments,members,where,expected", WRONG)
def test_a_wrong_argument_is_an_error(arguments, members, where, expected):
    with pytest.raises(evc.InputError) as error:
        evc.limits(*arguments, **members)
    assert where in error.value.where and expected in error.value.expected


def test_an_error_names_the_element():
    with pytest.raises(evc.InputError, match=r"targets\[1\]"):
        evc.limits("standard", 1.0, [TARGETS[0], {"type": "EOA"}])


def test_the_module_behind_refuses_arrays_of_different_sizes():
    def call(trains=8, speeds=8, targets=8, out=None):
        _native.limits(["standard"], np.zeros(trains, np.uint32), np.ones(speeds), TARGETS[:1], np.zeros(targets, np.uint32), {},
                       {"EBI": np.zeros(8)} if out is None else {"EBI": out}, 1.0)

    call()
    for wrong in ({"trains": 2}, {"targets": 2}, {"trains": (2, 4)}, {"speeds": (8, 8)}, {"out": np.zeros(7)}):
        with pytest.raises(ValueError):
            call(**wrong)
    for wrong in (np.zeros(8, np.float32), np.zeros(16)[::2], [0.0] * 8):
        with pytest.raises(TypeError):
            call(out=wrong)


def test_threads_compute_at_the_same_time():
    speeds = np.linspace(0.0, 160.0, 20_000)
    expected = evc.limits(TRAINS, speeds[:, None], TARGETS[2])
    results = [None] * 4

    def work(i):
        results[i] = evc.limits(TRAINS, speeds[:, None], TARGETS[2])

    threads = [threading.Thread(target=work, args=(i,)) for i in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all(np.array_equal(result[name], expected[name], equal_nan=True) for result in results for name in expected)


def test_the_lock_is_released():
    counted = 0
    done = threading.Event()

    def work():
        # One case at a time: build-up times of 4.0.0 that may be reduced.
        evc.limits("standard", np.linspace(1.0, 60.0, 50_000), TARGETS[2], srs="4.0.0", state={"est_front_m": 0})
        done.set()

    thread = threading.Thread(target=work)
    thread.start()
    while not done.is_set():
        counted += 1
    thread.join()
    assert counted > 1000
