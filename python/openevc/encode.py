"""Dictionaries as telegrams, messages and packets of the ETCS language, in hexadecimal digits: `evc encode`."""
from . import _native
from ._native import Form as _Form


def balise(telegram):
    """The user bits of a balise telegram."""
    return _native.encode(_Form.balise, telegram, None, None)


def loop(message):
    """A Euroloop message."""
    return _native.encode(_Form.loop, message, None, None)


def airgap(telegram):
    """The coded period of a balise telegram."""
    return _native.encode(_Form.airgap, telegram, None, None)


def radio(message, *, direction=None, sv=None):
    """A radio message. What is None is deduced from its members."""
    return _native.encode(_Form.radio, message, direction, sv)


def packet(members, *, direction=None, sv=None):
    """One packet. What is None is deduced from its members."""
    return _native.encode(_Form.packet, members, direction, sv)
