"""Telegrams, messages and packets: what `evc decode`, `evc encode` and `evc describe` print."""
import json

import numpy as np
import pytest

import openevc as evc

BALISE = "A1027F802015505023A0E0D480C8087F8"


def test_a_telegram_there_and_back(command):
    telegram = evc.decode.balise(BALISE)
    assert telegram == json.loads(command("decode", "balise", BALISE)[1])
    assert evc.encode.balise(telegram) == BALISE
    assert evc.decode.balise(bytes.fromhex(BALISE + "0")) == evc.decode.balise(BALISE + "0")
    assert telegram["packets"][0]["NID_PACKET"] == 65


def test_the_air_gap_there_and_back():
    telegram = evc.decode.balise(BALISE)
    coded = evc.encode.airgap(telegram)
    again = evc.decode.airgap(coded)
    assert again["packets"] == telegram["packets"] and "airgap" in again
    assert evc.encode.airgap(again) == coded


def test_every_message_and_packet_of_a_run_there_and_back(late, command):
    lines = [json.loads(line) for line in late.inputs.splitlines()]
    messages = [line["radio"]["message"] for line in lines if "message" in line.get("radio", {})]
    telegrams = [line["balise"]["telegram"] for line in lines if "balise" in line]
    assert len(messages) > 5 and len(telegrams) > 20
    for message in messages:
        members = evc.decode.radio(message)
        assert evc.encode.radio(members, direction="to_train", sv="2.1") == message
    for telegram in telegrams:
        assert evc.encode.balise(evc.decode.balise(telegram)).startswith(telegram.rstrip("F")[:20])
    reports = [json.loads(line)["radio_out"] for line in late.outputs.splitlines()]
    sent = [message for report in reports for message in report if isinstance(message, str)]
    assert sent
    decoded = evc.decode.radio(sent[0], direction="to_track")
    assert decoded == json.loads(command("decode", "radio", "--to-track", sent[0])[1])
    assert evc.encode.radio(decoded, direction="to_track") == sent[0]


def test_packets_and_loops():
    packet = evc.decode.balise(BALISE)["packets"][0]
    bits = evc.encode.packet(packet)
    assert evc.encode.packet(evc.decode.packet(bits)) == bits
    loop = {"header": {"Q_UPDOWN": 1, "M_VERSION": 33, "Q_MEDIA": 1, "NID_C": 1, "NID_LOOP": 3}, "packets": [packet]}
    assert evc.decode.loop(evc.encode.loop(loop))["packets"] == [packet]


WRONG_BITS = [BALISE[:20], "", "XYZ", "FFFF", "00" * 1000, BALISE.replace("7F", "00")]


@pytest.mark.parametrize("bits", WRONG_BITS)
def test_wrong_bits_are_the_object_of_the_command(bits, command):
    with pytest.raises(evc.InputError) as error:
        evc.decode.balise(bits)
    if bits:
        assert str(error.value) == command("decode", "balise", bits)[1].strip()
        members = json.loads(str(error.value))["error"]
        assert error.value.bit == members["bit"] and error.value.found == members["why"]
        assert error.value.packet == members.get("packet") and error.value.value == members.get("value")


@pytest.mark.parametrize("wrong", [{}, {"NID_C": 1}, [], 3, None, "text", {"packets": [{"NID_PACKET": 5}]},
                                   {"packets": float("nan")}, {"packets": {1: 2}}])
def test_what_is_no_telegram_is_an_error(wrong):
    for encode in (evc.encode.balise, evc.encode.loop, evc.encode.airgap, evc.encode.radio, evc.encode.packet):
        with pytest.raises(evc.InputError):
            encode(wrong)


def test_wrong_arguments_are_errors():
    for arguments in ({"direction": "sideways"}, {"sv": "9.9"}, {"sv": ""}, {"sv": "2.1.0"}):
        with pytest.raises(evc.InputError):
            evc.decode.radio("00", **arguments)
        with pytest.raises(evc.InputError):
            evc.encode.radio({}, **arguments)
    for wrong in (3.5, None, object()):
        with pytest.raises(TypeError):
            evc.decode.balise(wrong)
    with pytest.raises((TypeError, UnicodeEncodeError)):
        evc.decode.balise("\ud800")


def test_tables_are_those_of_the_command(command):
    assert evc.describe.packet(5) == command("describe", "packets", "5")[1]
    assert evc.describe.packet(5, markdown=True) == command("describe", "packets", "5", "--markdown")[1]
    assert evc.describe.packet(0, direction="to_track") == command("describe", "packets", "0", "--to-track")[1]
    assert evc.describe.message(24) == command("describe", "messages", "24")[1]
    assert evc.describe.variable("V_STATIC") == command("describe", "variables", "V_STATIC")[1]
    assert evc.describe.packets() == command("describe", "packets")[1]
    assert evc.describe.messages() == command("describe", "messages")[1]
    assert evc.describe.variables() == command("describe", "variables")[1]
    assert evc.describe.schema() == json.loads(command("describe", "schema")[1])


def test_what_does_not_exist_is_the_sentence_of_the_command(command):
    for call, kind, name in ((evc.describe.packet, "packets", 199), (evc.describe.message, "messages", 256),
                             (evc.describe.variable, "variables", "V_NONE")):
        with pytest.raises(evc.InputError) as error:
            call(name)
        assert str(error.value) == command("describe", kind, name)[2].strip()


def test_arguments_of_another_type_are_errors_of_one_line():
    radio = {"direction": ["x", 5, None, float("nan")], "sv": ["9", 2.1, None], "tolerant": ["x", 1, None]}
    for name, values in radio.items():
        for value in values:
            with pytest.raises(evc.InputError, match=f"^arguments: /{name}: found ") as error:
                evc.decode.radio("00", **{name: value})
            assert "\n" not in str(error.value)
    for call in (lambda: evc.decode.packet("00", strict="x"), lambda: evc.describe.variable(None), lambda: evc.describe.variable(5),
                 lambda: evc.describe.packet(5, direction=5), lambda: evc.describe.packet(5, markdown="x"),
                 lambda: evc.encode.radio({}, sv=2.1), lambda: evc.encode.packet({}, direction=5)):
        with pytest.raises(evc.InputError, match="^arguments: /") as error:
            call()
        assert "\n" not in str(error.value)
    assert evc.describe.packet(np.int64(5), markdown=np.bool_(False)) == evc.describe.packet(5)


def test_digits_that_are_none_are_named_as_far_as_they_can_be():
    for digits in ("zz", "\u00e9", "\u65e5\u672c", "A1\x00"):
        with pytest.raises(evc.InputError) as error:
            evc.decode.balise(digits)
        assert "\n" not in str(error.value) and error.value.found
