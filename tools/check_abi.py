#!/usr/bin/env python3
"""The binary interface of libopenevc.so is the one that src/capi/abi.txt lists: its exported symbols, and of
include/openevc/openevc.h the prototype of every function, the size of every struct, the offset of every member and every
constant. A program compiled
earlier works with the library as long as lines are only added: members at the end of a struct, functions, constants.
Usage: tools/check_abi.py LIBRARY [--write]   --write updates the list."""
import pathlib
import re
import subprocess
import tempfile

import command_line

ROOT = pathlib.Path(__file__).resolve().parent.parent
HEADER = ROOT / "include/openevc/openevc.h"
LIST = ROOT / "src/capi/abi.txt"


def symbols(library):
    """Names that the library gives to others."""
    listed = subprocess.run(["nm", "-D", "--defined-only", "--format=posix", library], check=True, capture_output=True,
                            text=True).stdout
    names = (line.split()[:2] for line in listed.splitlines())
    # The version's own name (A) is no function.
    return sorted(f"symbol {name.split('@')[0]}" for name, kind in names if kind != "A")


def layout_program(header):
    """A C program that prints sizes, places and constants of a header."""
    text = re.sub(r"/\*.*?\*/", "", header.read_text(encoding="utf-8"), flags=re.S)
    out = [f'#include "{header}"', "#include <stdio.h>", "int main(void) {"]
    for body, name in re.findall(r"typedef struct \w+ \{(.*?)\} (\w+);", text, re.S):
        out.append(f'  printf("struct {name} %zu\\n", sizeof({name}));')
        for declaration in filter(None, (d.strip() for d in body.split(";"))):
            kind, names = re.match(r"((?:const |unsigned )?\w+(?:\s*\*)*)\s*(.*)", declaration, re.S).groups()
            for member in names.split(","):
                member = re.sub(r"\[.*", "", member.strip(" *\n"))
                shown = " ".join(kind.split()).replace(" *", "*")
                out.append(f'  printf("  {name}.{member} {shown} %zu %zu\\n", offsetof({name}, {member}), '
                           f'sizeof((({name}*)0)->{member}));')
    for body, name in re.findall(r"typedef enum \w+ \{(.*?)\} (\w+);", text, re.S):
        out.append(f'  printf("enum {name}\\n");')
        for constant in re.findall(r"\b([A-Z]\w+)\b(?= =)", body):
            out.append(f'  printf("  {constant} %d\\n", (int){constant});')
    for constant in re.findall(r"^#define (OPENEVC_(?!VERSION_)\w+) \d+$", text, re.M):
        out.append(f'  printf("constant {constant} %d\\n", {constant});')
    return "\n".join(out + ["  return 0;", "}"]) + "\n"


def prototypes(header):
    """What a caller was compiled with; names of parameters do not count."""
    text = re.sub(r"/\*.*?\*/", "", header, flags=re.S)
    found = []
    for result, name, parameters in re.findall(r"OPENEVC_API\s+([\w\s*]+?)\s*\b(openevc_\w+)\((.*?)\)\s*OPENEVC_NOEXCEPT", text, re.S):
        types = [re.sub(r"(?<=[\s*])\w+$", "", " ".join(p.split())).replace(" *", "*").strip() if p.strip() != "void" else "void"
                 for p in parameters.split(",")]
        found.append(f"function {' '.join(result.split())} {name}({', '.join(types)})")
    return sorted(found)


def layout():
    with tempfile.TemporaryDirectory() as folder:
        source, program = pathlib.Path(folder) / "layout.c", pathlib.Path(folder) / "layout"
        source.write_text(layout_program(HEADER), encoding="utf-8")
        subprocess.run(["cc", "-std=c11", "-o", program, source], check=True)
        return subprocess.run([program], check=True, capture_output=True, text=True).stdout.splitlines()


def main():
    parser = command_line.Parser(__doc__)
    parser.add_argument("library", type=command_line.file)
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    found = symbols(options.library) + prototypes(HEADER.read_text(encoding="utf-8")) + layout()
    if options.write:
        LIST.write_text("\n".join(found) + "\n", encoding="utf-8")
    listed = LIST.read_text(encoding="utf-8").splitlines() if LIST.exists() else []
    faults = [f"abi: gone or changed: {line.strip()}" for line in listed if line not in found]
    faults += [f"abi: not in {LIST.relative_to(ROOT)}: {line.strip()}" for line in found if line not in listed]
    print("\n".join(faults + [f"abi: {len(found)} lines, {len(faults)} faults"]))
    return 1 if faults or not found else 0


if __name__ == "__main__":
    command_line.run(main)
