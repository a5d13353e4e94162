#!/usr/bin/env -S python3 -B
"""Loose ends: fields that product code (not tests) only writes or only reads, and enumerators that it only produces or
only asks for (tools/field_uses.py defines this). Each has to be in the table "Loose ends" of
CAVEATS.md, with its clause and the reason; a row that is no longer needed fails too.

A row is `room::Struct::field` or `room::Enumeration::enumerator`, or `room::Name::*` for all of one.

Usage: tools/check_ends.py [--list]   --list prints what is loose, as rows for CAVEATS.md"""
import re

import command_line
from field_uses import ROOT, loose_ends

CAVEATS = ROOT / "CAVEATS.md"


def rows(text):
    """The names of the table under the heading "Loose ends"; none is an error of the caller's."""
    section = re.search(r"^## Loose ends$(.*?)(?=^## |\Z)", text, re.M | re.S)
    return re.findall(r"^\| `([\w:*]+)` \|", section[1], re.M) if section else []


def faults(loose, named):
    """What does not fit. `loose`: {name: what is missing}; `named`: the rows."""
    sentences, used = [], set()
    for name, what in sorted(loose.items()):
        fits = [row for row in named if row == name or row == f"{name.rpartition('::')[0]}::*"]
        used.update(fits)
        if not fits:
            sentences.append(f"{name} is {what}, and CAVEATS.md does not name it")
    sentences += [f"CAVEATS.md names {row}, which is no loose end any more" for row in named if row not in used]
    sentences += [f"CAVEATS.md names {row} twice" for row in sorted({r for r in named if named.count(r) > 1})]
    return sentences


def main():
    parser = command_line.Parser(__doc__)
    parser.add_argument("--list", action="store_true")
    options = parser.parse_args()
    found, looked_at = loose_ends()
    loose = {name: what for _, name, what in found}
    if options.list:
        for name, what in sorted(loose.items()):
            print(f"| `{name}` | | {what} |")
        return 0
    named = rows(CAVEATS.read_text(encoding="utf-8"))
    wrong = faults(loose, named)
    for sentence in wrong:
        print(f"ends: {sentence}")
    print(f"ends: {looked_at} fields and enumerators, {len(loose)} loose, {len(named)} rows in CAVEATS.md, {len(wrong)} faults")
    return 1 if wrong or looked_at < 1000 else 0


if __name__ == "__main__":
    command_line.run(main)
