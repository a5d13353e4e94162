#!/usr/bin/env python3
"""What must not be in the tree: paths of somebody's machine, notes to self, large files, and executables
that lost their mode bit. Usage: tools/check_tree.py [ROOT]; looks at the files git tracks."""
import os
import pathlib
import re
import subprocess

import command_line

LARGEST = 1_500_000
# Written in pieces so that this file does not find itself.
PATTERNS = [
    (re.compile(r"(?<![\w.$}])/(?:wo" r"rk|ro" r"ot|ho" r"me|Us" r"ers)/"), "a path of one machine"),
    (re.compile(r"\b(?:TO" r"DO|FIX" r"ME|XX" r"X|HA" r"CK)\b"), "a note to self: do it, or say it in CAVEATS.md"),
]
TEXT = {".h", ".cpp", ".py", ".md", ".txt", ".cmake", ".json", ".yml", ".sh", ".html", ".js", ".css", ""}


def check(root):
    root = pathlib.Path(root).resolve()
    names = subprocess.run(["git", "-C", root, "ls-files", "-z"], capture_output=True, text=True, check=True)
    faults = []
    for name in filter(None, names.stdout.split("\0")):
        path = root / name
        if not path.is_file():
            continue
        size = path.stat().st_size
        if size > LARGEST:
            faults.append(f"{name}: {size} bytes, more than {LARGEST}")
        if path.suffix not in TEXT or "/corpus/" in name:
            continue
        try:
            text = path.read_text(encoding="utf-8")
        except UnicodeDecodeError:
            faults.append(f"{name}: is not UTF-8")
            continue
        if text.startswith("#!") and not os.access(path, os.X_OK):
            faults.append(f"{name}: has a #! line but is not executable")
        if "\r\n" in text:
            faults.append(f"{name}: CR LF line ends")
        for number, line in enumerate(text.splitlines(), 1):
            for pattern, why in PATTERNS:
                if pattern.search(line):
                    faults.append(f"{name}:{number}: {why}: {line.strip()[:100]}")
    return faults


def main():
    parser = command_line.Parser(__doc__)
    parser.add_argument("root", nargs="?", type=command_line.folder, default=pathlib.Path(__file__).resolve().parent.parent)
    root = parser.parse_args().root
    faults = check(root)
    for fault in faults:
        print(fault)
    print(f"tree: {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    command_line.run(main)
