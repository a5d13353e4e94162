"""Braking curves and supervision limits of one train and one target."""
from . import _native
from ._errors import refused


class Curves(dict):
    """Arrays by name: `v_kmh`, and where each curve and limit has that speed, metres before the target.

    Not a number where a value does not exist. `by_position`: arrays of speeds (km/h) at the places asked for; `scalars`,
    `notes`, `PBD`, `LX`: as in `evc-curves-result/1`, whose text is `json`.
    """

    def __init__(self, native):
        super().__init__(native.by_speed())
        self._native = native
        self.by_position = native.by_position()
        self.scalars = native.scalars()
        self.notes = native.notes()
        self.PBD = native.PBD()
        self.LX = native.LX()

    @property
    def json(self):
        """The text that `evc curves` prints."""
        return self._native.json()

    def explain(self, v_kmh):
        """The computation of all limits for one speed, step by step: `evc curves --explain`."""
        return self._native.explain(v_kmh)

    def plot(self, ax=None):
        """Draws speed over the line as `evc curves --plot` does; returns the axes of matplotlib."""
        from ._plot import draw
        return draw(self._native.picture(), ax)


def curves(query=None, /, *, speeds_kmh=None, positions_m=None, **members):
    """Answers a query of `evc curves`.

    `query`: a dictionary or file `evc-curves/1`, or the name of a shipped one; `members` are members of it, in addition
    to those of the query or instead of them: train, national_values (also names of files), track, target, state, srs ...
    `speeds_kmh`, `positions_m`: of its member `query`.
    """
    asked = {name: value for name, value in (("speeds_kmh", speeds_kmh), ("positions_m", positions_m)) if value is not None}
    if asked:
        given = members.get("query", {})
        if not isinstance(given, dict):
            raise refused("curves", "/query", f"a value of type {type(given).__name__}", "an object")
        members["query"] = {**given, **asked}
    return Curves(_native.Curves(query, {name: value for name, value in members.items() if value is not None}))
