import os
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np
import numpy.typing as npt
from matplotlib.axes import Axes

from . import decode as decode
from . import describe as describe
from . import encode as encode

__version__: str
__all__: list[str]

Document = Mapping[str, Any]
Named = str | os.PathLike[str] | Document
Array = npt.NDArray[np.float64]

class InputError(ValueError):
    file: str | None
    where: str | None
    found: str | None
    expected: str | None
    bit: int | None
    packet: int | None
    variable: str | None
    value: int | None

class Interrupted(KeyboardInterrupt):
    results: Any

class Outputs(Mapping[str, Any]):
    def __getitem__(self, key: str) -> Any: ...
    def __iter__(self) -> Iterator[str]: ...
    def __len__(self) -> int: ...
    @property
    def json(self) -> str: ...

class Snapshot: ...

class OnBoard:
    def __init__(
        self, config: Named | None = ..., persistent: Document | None = ..., planning: bool = ..., dmi: bool = ...
    ) -> None: ...
    def step(self, t_ms: int | None = ..., **inputs: Document | Sequence[Document]) -> Outputs: ...
    def snapshot(self) -> Snapshot: ...
    def restore(self, snapshot: Snapshot) -> None: ...
    @property
    def retained(self) -> dict[str, Any]: ...
    @property
    def cycle_ms(self) -> int: ...
    @property
    def t_ms(self) -> int | None: ...

class Curves(dict[str, Array]):
    by_position: dict[str, Array]
    scalars: dict[str, float | None]
    notes: list[str]
    PBD: list[dict[str, float | None]]
    LX: list[dict[str, float | None]]
    @property
    def json(self) -> str: ...
    def explain(self, v_kmh: float) -> str: ...
    def plot(self, ax: Axes | None = ...) -> Axes: ...

class Run:
    summary: dict[str, Any]
    inputs: str
    outputs: str
    fault: str | None
    @property
    def trace(self) -> npt.NDArray[np.void]: ...

class Sweep(dict[str, npt.NDArray[Any]]):
    cases: int
    @property
    def failed(self) -> int: ...

def curves(
    query: Named | None = ...,
    /,
    *,
    speeds_kmh: npt.ArrayLike | Document | None = ...,
    positions_m: npt.ArrayLike | Document | None = ...,
    **members: Any,
) -> Curves: ...
def limits(
    trains: Named | npt.ArrayLike | Sequence[Named],
    speeds: npt.ArrayLike,
    targets: Document | npt.ArrayLike | Sequence[Document],
    *,
    columns: str | Sequence[str] = ...,
    track: Document | None = ...,
    national_values: Named | None = ...,
    fixed_values: Document | None = ...,
    state: Document | None = ...,
    srs: str | None = ...,
    out: dict[str, Array] | None = ...,
) -> dict[str, Array]: ...
def run(
    line: Named | None = ...,
    *,
    train: Named | None = ...,
    driver: str | None = ...,
    odometer: str | Document | None = ...,
    seed: int | None = ...,
    cycle_ms: int | None = ...,
    last_ma: int | None = ...,
    national_values: Named | None = ...,
    srs: str | None = ...,
    utc: str | None = ...,
    output: str | os.PathLike[str] | None = ...,
) -> Run: ...
def sweep(spec: Named, *, threads: int = ...) -> Sweep: ...
