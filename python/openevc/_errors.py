"""Exceptions of the package."""


class InputError(ValueError):
    """Input that is not accepted, with the sentence that the command prints on standard error.

    `file`, `where`, `found`, `expected`: the parts of the sentence. Errors of telegrams, messages and packets have
    `bit`, `packet`, `variable`, `value` and `found` instead: the members of the object that `evc decode` prints.
    """

    file = where = found = expected = None
    bit = packet = variable = value = None


class Interrupted(KeyboardInterrupt):
    """Ctrl-C ended a long computation. `results` has what was computed until then, whole."""

    results = None


def refused(file, where, found, expected):
    """The error of an argument."""
    error = InputError(f"{file}: {where}: found {found}, expected {expected}")
    error.file, error.where, error.found, error.expected = file, where, found, expected
    return error


def end(interruption, results):
    """Raises what the handler of a signal raised; Ctrl-C with the results so far. None: there was no signal."""
    if interruption is None:
        return results
    if not isinstance(interruption, KeyboardInterrupt):
        raise interruption
    stopped = Interrupted("stopped by a signal; `results` has what is computed")
    stopped.results = results
    raise stopped from interruption
