#!/usr/bin/env python3
"""The kernel contains no text: names and texts of its inputs and outputs are in `terms` rows and in `texts`, which
io, app and sim use. Reads the string literals out of the compiled kernel rooms. The tables of the language (lang) name
packets and variables, airgap names the faults of a telegram. Usage: tools/check_texts.py [BUILD_FOLDER...]; prints ARCHIVE(OBJECT): "text", exit 1."""
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import check_layers  # noqa: E402
import command_line

HAVE_TEXTS = {"lang", "airgap"}


def literals(archive):
    """(object, text) of every literal of two characters or more in the archive's string sections."""
    listing = subprocess.run(["readelf", "--wide", "--sections", archive], capture_output=True, text=True, check=True)
    sections = {part for line in listing.stdout.splitlines() for part in line.split() if part.startswith(".rodata") and
                ".str" in part}
    found = []
    for section in sorted(sections):
        dump = subprocess.run(["readelf", "--wide", "-p", section, archive], capture_output=True, text=True, check=False)
        member = "?"
        for line in dump.stdout.splitlines():
            if line.startswith("File: "):
                member = line[6:].strip().split("(")[-1].rstrip(")")
            elif line.startswith("  ["):
                text = line.split("]", 1)[1].strip()
                if len(text) > 1:
                    found.append((member, text))
    return found


def main():
    root = pathlib.Path(__file__).resolve().parent.parent
    parser = command_line.Parser(__doc__)
    parser.add_argument("builds", nargs="*", type=command_line.folder, default=[root / "build/release"])
    builds = parser.parse_args().builds
    texts = archives = 0
    for build in builds:
        for room in check_layers.KERNEL_ROOMS:
            archive = pathlib.Path(build) / f"src/{room}/libevc_{room}.a"
            if room in HAVE_TEXTS or not any(p for p in (root / "src" / room).rglob("*.cpp")
                                             if not check_layers.is_test(p)):
                continue
            if not archive.exists():
                print(f"texts: {archive} is not built")
                return 1
            archives += 1
            for member, text in literals(archive):
                print(f'{archive.name}({member}): "{text}"')
                texts += 1
    print(f"texts: {texts} in {archives} archives")
    return 1 if texts or not archives else 0


if __name__ == "__main__":
    command_line.run(main)
