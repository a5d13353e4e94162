"""The package as a whole: stubs that agree with it, and random values of any type, which must be exceptions or answers."""
import ast
import inspect
import pathlib
import random
import subprocess
import sys

import numpy as np
import pytest

import openevc as evc

PACKAGE = pathlib.Path(evc.__file__).parent


def stub(name):
    return ast.parse((PACKAGE / f"{name}.pyi").read_text())


def names_of(function):
    a = function.args
    return [arg.arg for arg in a.posonlyargs + a.args], [arg.arg for arg in a.kwonlyargs]


@pytest.mark.parametrize("module", ["__init__", "decode", "encode", "describe"])
def test_stubs_have_the_functions_with_their_arguments(module):
    actual = evc if module == "__init__" else getattr(evc, module)
    functions = [node for node in stub(module).body if isinstance(node, ast.FunctionDef)]
    assert functions
    for node in functions:
        parameters = inspect.signature(getattr(actual, node.name)).parameters.values()
        positional = [p.name for p in parameters if p.kind in (p.POSITIONAL_ONLY, p.POSITIONAL_OR_KEYWORD)]
        keywords = [p.name for p in parameters if p.kind == p.KEYWORD_ONLY]
        assert names_of(node) == (positional, keywords), node.name
    public = {n for n in dir(actual) if not n.startswith("_") and inspect.isfunction(getattr(actual, n))}
    assert public == {node.name for node in functions}


def test_stubs_have_the_classes_with_their_members():
    classes = {node.name: node for node in stub("__init__").body if isinstance(node, ast.ClassDef)}
    assert set(classes) == {name for name in evc.__all__ if inspect.isclass(getattr(evc, name))}
    for name, node in classes.items():
        for member in node.body:
            if isinstance(member, ast.FunctionDef) and member.name != "__init__":
                assert hasattr(getattr(evc, name), member.name), (name, member.name)
    unit = {member.name for member in classes["OnBoard"].body if isinstance(member, ast.FunctionDef)}
    assert unit >= {n for n in dir(evc.OnBoard) if not n.startswith("_")}
    assert (PACKAGE / "py.typed").exists()


def test_a_module_for_another_interpreter_is_named(tmp_path):
    package = tmp_path / "openevc"
    package.mkdir()
    for file in PACKAGE.glob("*.py"):
        (package / file.name).write_text(file.read_text())
    for built, named in (("_native.cpython-27-x86_64-linux-gnu.so", "_native.cpython-27-x86_64-linux-gnu.so"),
                         (None, "no module is built")):
        for file in package.glob("_native.*"):
            file.unlink()
        if built:
            (package / built).touch()
        run = subprocess.run([sys.executable, "-B", "-c", "import openevc"], cwd=tmp_path, env={"PYTHONPATH": str(tmp_path)},
                             capture_output=True, text=True)
        assert run.returncode == 1
        assert run.stderr.splitlines()[-1] == (
            f"ImportError: openevc: found Python {sys.version_info[0]}.{sys.version_info[1]} ({sys.executable}), expected "
            f"the interpreter that the package was built for: {named}")


def test_everything_public_is_documented():
    for name in evc.__all__:
        assert getattr(evc, name).__doc__, name
    for module in (evc.decode, evc.encode, evc.describe):
        for name, function in inspect.getmembers(module, inspect.isfunction):
            assert name.startswith("_") or function.__doc__, name


def anything(source, depth=0):
    """A random value: what readers want, nearly that, and what they do not."""
    keys = ("type", "location_m", "speed_kmh", "train", "target", "track", "gradient", "schema", "brake_percentage", "x",
            "odometer", "nominal_m", "balise", "telegram", "at_m", "driver", "enter", "level", "kind", "base", "vary", "query")
    leaf = (lambda: None, lambda: source.choice([True, False]), lambda: source.randint(-10, 10 ** source.randint(1, 25)),
            lambda: source.choice([0.0, -1.5, 1e308, float("nan"), float("inf"), 100.0]),
            lambda: source.choice(["", "EOA_SvL", "standard", "passenger_eoa", "A102", "evc-curves/1", "evc-sweep/1", "\0", "\ud800", "é"]),
            lambda: np.float32(2.5), lambda: np.array([1.0, np.nan]), lambda: np.zeros((2, 0)), lambda: np.array("a"),
            lambda: b"\x00\xff", object, lambda: 1j, lambda: np.datetime64("2026-01-01"), lambda: {1, 2}, lambda: range(3))
    kind = source.randint(0, 9)
    if depth < 4 and kind < 4:
        return {source.choice(keys): anything(source, depth + 1) for _ in range(source.randint(0, 5))}
    if depth < 4 and kind < 6:
        return [anything(source, depth + 1) for _ in range(source.randint(0, 4))]
    return source.choice(leaf)()


def test_anything_is_an_exception_or_an_answer():
    source = random.Random(12)
    unit = evc.OnBoard()
    calls = [
        lambda: unit.step(anything(source)) if source.random() < 0.1 else unit.step(**{source.choice(
            ["odometer", "balise", "radio", "driver", "train", "loop", "power", "clock"]): anything(source)}),
        lambda: evc.OnBoard(anything(source)),
        lambda: evc.curves(anything(source), **{source.choice(["train", "target", "track", "state"]): anything(source)}),
        lambda: evc.limits(anything(source), anything(source), anything(source)),
        lambda: evc.limits("standard", anything(source), {"type": "EOA_SvL", "location_m": 1000}),
        lambda: evc.limits("standard", 10.0, anything(source), columns=anything(source), out=anything(source)),
        lambda: evc.decode.balise(anything(source)),
        lambda: evc.encode.balise(anything(source)),
        lambda: evc.encode.packet(anything(source)),
        lambda: evc.describe.packet(anything(source)),
        lambda: evc.sweep({"schema": "evc-sweep/1", "kind": "curves", "base": anything(source), "vary": anything(source)}),
        lambda: evc.run(line=anything(source), driver="x"),
        lambda: unit.restore(anything(source)),
    ]
    refused = 0
    for _ in range(4000):
        try:
            source.choice(calls)()
        except (ValueError, TypeError, AttributeError, MemoryError):
            refused += 1
    assert refused > 2000
    assert unit.step()["mode"]


def test_it_may_be_imported_and_left_at_any_time():
    spec = {"schema": "evc-sweep/1", "kind": "run", "base": {}, "vary": [{"at": "/seed", "count": 1000}]}
    script = ("import threading, time, openevc as evc\n"
              "for call in (lambda: evc.run(cycle_ms=1), lambda: evc.run(),\n"
              f"             lambda: evc.sweep({spec!r}, threads=1)):\n"
              "    threading.Thread(target=call, daemon=True).start()\n"
              "unit = evc.OnBoard(); out = unit.step(); time.sleep(%s)\n")
    # An exit waits for no thread that is a daemon; they ask for the lock then.
    for seconds in (0.0, 0.15, 0.3):
        done = subprocess.run([sys.executable, "-c", script % seconds], capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
