"""What the tests share: the sources, and the command whose answers are compared with those of the package."""
import json
import os
import pathlib
import subprocess

import pytest

import openevc as evc


@pytest.fixture(scope="session")
def source():
    return pathlib.Path(os.environ["EVC_SOURCE"])


@pytest.fixture(scope="session")
def command():
    """Runs `evc`; returns the exit status, standard output and standard error."""
    def run(*arguments, cwd=None):
        done = subprocess.run([os.environ["EVC_COMMAND"], *map(str, arguments)], capture_output=True, text=True, cwd=cwd,
                              check=False)
        return done.returncode, done.stdout, done.stderr
    return run


@pytest.fixture(scope="session")
def late():
    """A journey that is used by several tests."""
    return evc.run("brunnental", driver="late", seed=3)


@pytest.fixture(scope="session")
def cycles(late):
    """Its configuration, and for each cycle the time and the inputs, as arguments of `step`."""
    lines = [json.loads(line) for line in late.inputs.splitlines()]
    config = lines[0]["config"]
    by_time = {}
    for line in lines[1:]:
        t_ms = line.pop("t_ms")
        inputs = by_time.setdefault(t_ms, {})
        for key, value in line.items():
            inputs.setdefault(key, []).append(value)
    return config, by_time
