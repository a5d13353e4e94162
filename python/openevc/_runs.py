"""Journeys of a simulated train, supervised by the on-board."""
import csv
import io

import numpy as np

from . import _native
from ._errors import end

# Columns of a trace that are no numbers.
_FLAGS = {"tco", "sb", "eb", "mrdt_changed", "level_valid"}
_NAMES = {"mode", "level", "monitoring", "status", "memo_status", "trip_reason", "version", "radio_register", "language",
          "radio_connect.NID_RADIO", "radio_disconnect.NID_RADIO"}
_LISTS = {"brake_reasons", "driver.requests", "driver.texts", "driver.symbols", "radio_out", "events"}


def _column(name, cells):
    if name in _FLAGS:
        return np.array([cell == "true" for cell in cells], dtype=bool)
    if name in _NAMES:
        return np.array(cells, dtype=str)
    if name in _LISTS:
        return np.array(cells, dtype=object)
    if name == "t_ms":
        return np.array(cells, dtype=np.int64)
    return np.array([cell if cell else "nan" for cell in cells], dtype=np.float64)


def structured(text):
    """The text of a trace.csv as a structured array."""
    rows = list(csv.reader(io.StringIO(text)))
    names, rows = rows[0], rows[1:]
    columns = [_column(name, cells) for name, cells in zip(names, zip(*rows) if rows else [()] * len(names))]
    trace = np.empty(len(rows), dtype=[(name, column.dtype) for name, column in zip(names, columns)])
    for name, column in zip(names, columns):
        trace[name] = column
    return trace


class Run:
    """A journey.

    `summary`: the dictionary `evc-summary/1`; `inputs`, `outputs`: the texts of inputs.jsonl and outputs.jsonl; `fault`:
    why the journey did not take place, None for one that did.
    """

    def __init__(self, result):
        self.summary = result["summary"]
        self.inputs = result["inputs"]
        self.outputs = result["outputs"]
        self.fault = result["fault"]
        self._text = result["trace"]
        self._trace = None

    @property
    def trace(self):
        """The columns of trace.csv, a row a cycle, as a structured array; not a number where there is no value."""
        if self._trace is None:
            self._trace = structured(self._text)
        return self._trace

    def __repr__(self):
        return f"<openevc.Run {self.summary['line']!r}, {self.summary['distance_m']} m in {self.summary['duration_s']} s>"


def run(line=None, *, train=None, driver=None, odometer=None, seed=None, cycle_ms=None, last_ma=None,
        national_values=None, srs=None, utc=None, output=None):
    """Drives a train along a line, as `evc run`.

    `line`, `train`, `national_values`: a dictionary, a file or the name of a shipped one; `driver`: "perfect", "late" or
    "reckless"; `odometer`: "random", "over", "under" or {"error": share}; `utc`: the on-board's clock at the begin, as
    "2026-01-01T08:00:00Z"; `output`: a folder for the files of `evc run -o`.
    """
    result = _native.run({"line": line, "train": train, "driver": driver, "odometer": odometer, "seed": seed,
                          "cycle_ms": cycle_ms, "last_ma": last_ma, "national_values": national_values, "srs": srs,
                          "utc": utc, "output": output})
    return end(result["interruption"], Run(result))
