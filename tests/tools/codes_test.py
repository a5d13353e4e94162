"""src/capi/codes.h: every enumerator of the C header is compared with the kernel's. A header in which each of them has another
number fails to compile once for each."""
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
HEADER = (ROOT / "include/openevc/openevc.h").read_text(encoding="utf-8")
# Enumerators that nothing in the kernel has.
OF_C_ALONE = {"openevc_result": None,  # all
              "openevc_movement": None,
              "openevc_entry": {"OPENEVC_ENTRY_SR_SPEED", "OPENEVC_ENTRY_SR_DISTANCE", "OPENEVC_ENTRY_VBC",
                                "OPENEVC_ENTRY_NETWORK", "OPENEVC_ENTRY_SET_SPEED", "OPENEVC_ENTRY_LANGUAGE"}}
NUMBERED = re.compile(r"\b(OPENEVC_\w+) = (\d+)")


def enumerations(header):
    """{name: enumerators}"""
    text = re.sub(r"/\*.*?\*/", "", header, flags=re.S)
    return {name: re.findall(r"\b(OPENEVC_\w+)\b", body)
            for body, name in re.findall(r"typedef enum \w+ \{(.*?)\} (\w+);", text, re.S)}


def compared():
    """The enumerators that have to be compared."""
    every = {e for all_of in enumerations(HEADER).values() for e in all_of}
    return every - {e for name, some in OF_C_ALONE.items() for e in (some or enumerations(HEADER)[name])}


def refused(header):
    """What the compiler says of codes.h with this header: the enumerators whose row is wrong, and all it said."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "openevc").mkdir()
        (folder / "openevc/openevc.h").write_text(header, encoding="utf-8")
        compiler = next(c for c in (os.environ.get("CXX"), "g++", "clang++-14", "c++") if c and shutil.which(c))
        all_errors = ["-ferror-limit=0"] if "clang" in compiler else []
        done = subprocess.run([compiler, "-std=c++20", "-fsyntax-only", *all_errors, "-x", "c++", "-I", folder, "-I", ROOT / "src",
                               "-I", ROOT / "include", "-"], input='#include "capi/codes.h"\n', capture_output=True, text=True,
                              env={**os.environ, "LC_ALL": "C"})
        rows = (ROOT / "src/capi/codes.h").read_text(encoding="utf-8").splitlines()
        wrong = {int(line) for line in re.findall(r"codes\.h:(\d+):\d+: error: static.assert", done.stderr)}
        return {found[1] for line in wrong if (found := re.search(r"same\((\w+),", rows[line - 1]))}, done.stderr


class Codes(unittest.TestCase):
    def test_the_header_as_it_is(self):
        self.assertEqual(refused(HEADER), (set(), ""))

    def test_every_enumerator_is_compared(self):
        self.assertGreater(len(compared()), 70)
        moved = NUMBERED.sub(lambda e: f"{e[1]} = {int(e[2]) + 100}" if e[1] in compared() else e[0], HEADER)
        self.assertEqual(refused(moved)[0], compared())

    def test_two_that_are_swapped(self):
        swapped = HEADER.replace("OPENEVC_SHUNTING = 2", "OPENEVC_SHUNTING = 3").replace("EXIT_SHUNTING = 3", "EXIT_SHUNTING = 2")
        self.assertEqual(refused(swapped)[0], {"OPENEVC_SHUNTING", "OPENEVC_EXIT_SHUNTING"})

    def test_every_enumerator_has_its_number(self):
        for name, all_of in enumerations(HEADER).items():
            self.assertGreater(len(all_of), 1, name)
            for enumerator in all_of:
                self.assertRegex(HEADER, rf"\b{enumerator} = \d")


if __name__ == "__main__":
    unittest.main()
