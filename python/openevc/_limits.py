"""Limits of many trains, speeds and targets."""
import os

import numpy as np

from . import _native
from ._errors import end, refused

DEFAULT = ("EBI", "SBI1", "SBI2", "FLOI", "W", "P", "I")


def _refuse_masked(values, what, expected, place=()):
    """NumPy forgets the mask where it makes a plain array of a masked one: what is masked would count as a value."""
    if isinstance(values, np.ma.MaskedArray):
        mask = np.ma.getmaskarray(values)
        if mask.dtype == bool and mask.any():
            place += tuple(int(i) for i in np.argwhere(mask)[0])
            raise refused("limits", f"{what}{list(place) if place else ''}", "a masked value", expected)
    elif isinstance(values, (list, tuple)):
        for i, value in enumerate(values):
            if isinstance(value, (np.ma.MaskedArray, list, tuple)):
                _refuse_masked(value, what, expected, (*place, i))


def _table(values, what):
    """The different trains or targets, and an array of their numbers."""
    _refuse_masked(values, what, f"one of the {what}")
    if isinstance(values, (str, dict, os.PathLike)) or not hasattr(values, "__len__"):
        return [values], np.zeros((), np.uint32)
    try:
        objects = np.asarray(values, dtype=object, order="C")
    except ValueError:  # lists of different lengths
        raise refused("limits", what, "lists of different lengths", "an array of one shape") from None
    different, numbers = _native.table(objects)
    return different, numbers.reshape(objects.shape)


def _speeds(speeds):
    _refuse_masked(speeds, "speeds", "a number from 0.0 to 600.0")
    try:
        array = np.asarray(speeds)
    except (ValueError, TypeError):  # lists of different lengths
        raise refused("limits", "speeds", f"an array of {type(speeds).__name__}", "numbers, km/h") from None
    if array.dtype.kind not in "fiu":
        raise refused("limits", "speeds", f"an array of {array.dtype}", "numbers, km/h")
    array = array.astype(np.float64, copy=False)
    wrong = ~((array >= 0.0) & (array <= 600.0))
    if wrong.any():
        place = tuple(int(i) for i in np.argwhere(wrong)[0])
        where = f"speeds[{', '.join(map(str, place))}]" if place else "speeds"
        raise refused("limits", where, array[place], "a number from 0.0 to 600.0")
    return array


def _arrays(columns, shape, out):
    """The arrays for the results."""
    columns = (columns,) if isinstance(columns, str) else tuple(columns)
    for name in columns:
        if not isinstance(name, str) or name not in _native.limit_names:
            raise refused("limits", "columns", repr(name), f"one of {', '.join(_native.limit_names)}")
    if not (out is None or isinstance(out, dict)):
        raise refused("limits", "out", f"a value of type {type(out).__name__}", "a dictionary of arrays")
    for name in out or ():
        if name not in columns:
            raise refused("limits", "out", f"the key {name!r}", f"one of the columns: {', '.join(columns)}")
    arrays = {}
    for name in columns:
        array = None if out is None else out.get(name)
        if array is None:
            array = np.empty(shape)
        elif isinstance(array, np.ma.MaskedArray):
            raise refused("limits", f"out[{name!r}]", "an array with a mask", "an array without one")
        elif not (isinstance(array, np.ndarray) and array.dtype == np.float64 and array.shape == shape
                  and array.flags.c_contiguous and array.flags.writeable):
            raise refused("limits", f"out[{name!r}]", f"{array.dtype if hasattr(array, 'dtype') else type(array).__name__}"
                          f" {getattr(array, 'shape', '')}", f"a contiguous, writable array of float64 {shape}")
        for other, filled in arrays.items():
            if np.may_share_memory(array, filled):
                raise refused("limits", f"out[{name!r}]", f"the memory of out[{other!r}]", "an array of its own")
        arrays[name] = array
    return arrays


def _as_far_as(done, arrays, out):
    """The arrays when Ctrl-C ended it: memory that was never used is not touched, as that would take seconds."""
    cut = {}
    for name, values in arrays.items():
        if not (out and out.get(name) is not None):
            axis = next((i for i, length in enumerate(values.shape) if length > 1), None)
            if axis is not None:
                entries = -(-done * values.shape[axis] // values.size)
                values = values[(slice(None),) * axis + (slice(entries),)]
        values.reshape(-1)[done:] = np.nan
        cut[name] = values
    return cut


def limits(trains, speeds, targets, *, columns=DEFAULT, track=None, national_values=None, fixed_values=None, state=None,
           srs=None, out=None):
    """Places of the supervision limits of trains that run at speeds (km/h) and approach targets, by broadcasting.

    `trains`: a train (a dictionary, a file, or the name of a shipped one), or an array of them; `targets`: a target as in
    `evc curves`, or an array of them; `track`, `national_values`, `fixed_values`, `state`, `srs`: as there, of all trains.
    Returns an array for each name of `columns`: metres before the target, negative beyond it, not a number where there is
    no such limit. `out`: arrays to be filled, by name. The lock of the interpreter is released meanwhile.
    """
    train_table, train_numbers = _table(trains, "trains")
    target_table, target_numbers = _table(targets, "targets")
    array = _speeds(speeds)
    highest = float(array.max()) if array.size else 0.0  # before it is repeated
    try:
        train_numbers, array, target_numbers = np.broadcast_arrays(train_numbers, array, target_numbers)
    except ValueError:
        raise refused("limits", "shapes", f"trains {train_numbers.shape}, speeds {array.shape}, targets "
                      f"{target_numbers.shape}", "shapes that NumPy broadcasts together") from None
    arrays = _arrays(columns, array.shape, out)
    if out and any(np.may_share_memory(array, filled) for filled in arrays.values()):
        array = array.copy()  # results take the place of speeds that are not read yet
    members = {"track": track, "national_values": national_values, "fixed_values": fixed_values, "state": state,
               "srs": srs}
    common = {name: value for name, value in members.items() if value is not None}
    done, interruption = _native.limits(train_table, train_numbers, array, target_table, target_numbers, common, arrays,
                                        highest)
    if done < array.size:
        arrays = _as_far_as(done, arrays, out)
    return end(interruption, arrays)
