"""openevc: an ETCS on-board unit, its braking curves, journeys and language (docs/python.md).

    import openevc as evc
    evc.curves("passenger_eoa").plot()

Names, units and errors are those of the command `evc`. Every function may be called from any thread; of an OnBoard one
thread at a time computes.
"""
import collections.abc as _abc

try:
    from . import _native
except ImportError as _error:
    from ._interpreter import explained as _explained

    raise _explained(_error) from None

from . import decode, describe, encode
from ._curves import Curves, curves
from ._errors import InputError, Interrupted
from ._limits import limits
from ._native import OnBoard, Outputs, Snapshot
from ._runs import Run, run
from ._sweeps import Sweep, sweep

__version__ = _native.version
__all__ = ["Curves", "InputError", "Interrupted", "OnBoard", "Outputs", "Run", "Snapshot", "Sweep", "curves", "decode",
           "describe", "encode", "limits", "run", "sweep"]

for _public in (Curves, InputError, Interrupted, OnBoard, Outputs, Run, Snapshot, Sweep):
    _public.__module__ = __name__

# The rest of a mapping: keys, items, values, get, ==.
for _name in ("keys", "items", "values", "get", "__eq__"):
    setattr(Outputs, _name, getattr(_abc.Mapping, _name))
Outputs.__hash__ = None
_abc.Mapping.register(Outputs)
del _name, _public
