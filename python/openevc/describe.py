"""The tables of the ETCS language as text: `evc describe`."""
from . import _native


def packet(number, *, direction=None, markdown=False):
    """All layouts of a packet, of both directions unless one is given."""
    return _native.describe_packets(str(number), direction, markdown)


def message(number, *, markdown=False):
    """A radio message."""
    return _native.describe_messages(str(number), None, markdown)


def variable(name, *, markdown=False):
    """A variable: "V_STATIC"."""
    return _native.describe_variables(name, None, markdown)


def packets():
    """The list of packets, one a line."""
    return _native.describe_packets("", None, False)


def messages():
    """The list of messages, one a line."""
    return _native.describe_messages("", None, False)


def variables():
    """The list of variables, one a line."""
    return _native.describe_variables("", None, False)


def schema():
    """The JSON schema of what `openevc.decode` returns."""
    return _native.describe_schema()
