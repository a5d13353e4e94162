"""Many cases of one description."""
import numpy as np

from . import _native
from ._errors import end


def _array(cells):
    if all(isinstance(cell, int) for cell in cells):
        return np.array(cells, dtype=np.int64)
    if all(cell is None or isinstance(cell, (int, float)) for cell in cells):
        return np.array([np.nan if cell is None else cell for cell in cells], dtype=np.float64)
    array = np.empty(len(cells), dtype=object)
    array[:] = cells
    return array


class Sweep(dict):
    """Arrays by the names of the columns, a row a case, in the order of the numbers: numbers where all cells are numbers
    or empty (not a number), else objects; lists are texts of JSON. `cases`: how many the description has."""

    def __init__(self, result):
        super().__init__((name, _array(cells)) for name, cells in result["columns"].items())
        self.cases = result["cases"]

    @property
    def failed(self):
        """How many cases have a reason instead of results."""
        return int(np.count_nonzero(self["status"] == "failed"))


def sweep(spec, *, threads=0):
    """Computes the cases of a description `evc-sweep/1`, a dictionary or a file, with so many threads; 0: one for each
    processor. Nothing is stored: `evc sweep` writes a file of results that can be resumed."""
    result = _native.sweep(spec, threads)
    return end(result["interruption"], Sweep(result))
