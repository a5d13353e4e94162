"""Telegrams, messages and packets of the ETCS language as dictionaries: `evc decode`."""
from . import _native
from ._native import Form as _Form


def _decode(form, bits, direction="to_train", sv="2.1", tolerant=False):
    if not isinstance(bits, (str, bytes, bytearray, memoryview)):
        raise TypeError(f"hexadecimal digits or bytes, not {type(bits).__name__}")
    digits = bits if isinstance(bits, str) else bits.hex()
    return _native.decode(form, digits, direction, sv, tolerant)


def _opposite(flag):
    """Of True and False; of anything else itself, which is refused."""
    return not flag if isinstance(flag, bool) or type(flag).__name__ in ("bool_", "bool") else flag


def balise(bits, *, tolerant=False):
    """The user bits of a balise telegram: hexadecimal digits, or bytes."""
    return _decode(_Form.balise, bits, tolerant=tolerant)


def loop(bits, *, tolerant=False):
    """A Euroloop message."""
    return _decode(_Form.loop, bits, tolerant=tolerant)


def airgap(bits, *, tolerant=False):
    """A balise telegram as it is coded for the air gap (SUBSET-036), with the member "airgap"."""
    return _decode(_Form.airgap, bits, tolerant=tolerant)


def radio(bits, *, direction="to_train", sv="2.1", tolerant=False):
    """A radio message. `sv`: the system version of the session."""
    return _decode(_Form.radio, bits, direction, sv, tolerant)


def packet(bits, *, direction="to_train", sv="2.1", strict=False):
    """One packet. Spare codes are shown unless it is `strict`."""
    return _decode(_Form.packet, bits, direction, sv, _opposite(strict))
