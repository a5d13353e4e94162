#!/usr/bin/env python3
"""Writes src/paint/font_table.cpp: the outlines of characters of two TrueType fonts.
Usage: tools/make_font.py REGULAR.ttf BOLD.ttf >src/paint/font_table.cpp

The table in the tree was made from LiberationSans-Regular.ttf and LiberationSans-Bold.ttf of Debian's package
fonts-liberation2 2.1.5 (SIL Open Font License 1.1, licenses/OFL-1.1.txt). Needs fontTools (python3-fonttools)."""
import re
import sys

import command_line

try:
    from fontTools.pens.basePen import BasePen
    from fontTools.ttLib import TTFont, TTLibError
except ImportError:
    print("make_font.py: found no fontTools, expected the package python3-fonttools", file=sys.stderr)
    sys.exit(2)

# The printable characters of ISO 8859-1 and of Latin Extended-A, Cyrillic letters, and the dash of the status texts:
# kRanges of font.cpp.
CHARACTERS = [*range(0x20, 0x7F), *range(0xA0, 0x180), *range(0x410, 0x450), 0x2013]
COLUMNS = 116


class Outline(BasePen):
    """Writes M, L, Q (one control point) and Z with whole numbers; y upwards."""

    def __init__(self, glyphs):
        super().__init__(glyphs)
        self.text = ""

    def add(self, letter, *points):
        self.text += letter + " ".join(f"{round(x)} {round(y)}" for x, y in points)

    def _moveTo(self, point):
        self.add("M", point)

    def _lineTo(self, point):
        self.add("L", point)

    def _qCurveToOne(self, control, point):
        self.add("Q", control, point)

    def _closePath(self):
        self.text += "Z"


def table(name, file):
    try:
        font = TTFont(file)
    except TTLibError as wrong:
        raise command_line.Refused(f"{file}: found {wrong}, expected a TrueType font") from None
    names, glyphs = font.getBestCmap(), font.getGlyphSet()
    if font["head"].unitsPerEm != 2048:
        sys.exit(f"{file}: found {font['head'].unitsPerEm} units in an em, expected 2048")
    print(f"const Glyph {name}[kGlyphs] = {{")
    for character in CHARACTERS:
        if character not in names:
            sys.exit(f"{file}: found no character U+{character:04X}, expected it")
        glyph = glyphs[names[character]]
        pen = Outline(glyphs)
        glyph.draw(pen)
        pieces = [""]
        for step in re.findall("[MLQZ][^MLQZ]*", pen.text):
            if len(pieces[-1]) + len(step) > COLUMNS:
                pieces.append("")
            pieces[-1] += step
        print(f"    {{{round(glyph.width)}, // U+{character:04X}")
        print("\n".join(f'     "{piece}"' for piece in pieces) + "},")
    print("};")


def main():
    parser = command_line.Parser(__doc__)
    parser.add_argument("regular", type=command_line.file)
    parser.add_argument("bold", type=command_line.file)
    options = parser.parse_args()
    print('''// Written by tools/make_font.py: outlines of LiberationSans-Regular.ttf and LiberationSans-Bold.ttf 2.1.5.
// Digitized data copyright (c) 2010 Google Corporation with Reserved Font Arimo, Tinos and Cousine.
// Copyright (c) 2012 Red Hat, Inc. with Reserved Font Name Liberation.
// SIL Open Font License 1.1: licenses/OFL-1.1.txt.
#include "paint/font.h"

namespace evc::paint {

// clang-format off''')
    table("kRegular", options.regular)
    print()
    table("kBold", options.bold)
    print('''// clang-format on

}  // namespace evc::paint''')


if __name__ == "__main__":
    command_line.run(main)
