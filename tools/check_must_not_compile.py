#!/usr/bin/env python3
"""Code that the types must reject: every tests/must_not_compile/*.cpp compiles unchanged and does not with -DMISTAKE; then
the error has to be in the file's own part behind `#ifdef MISTAKE`, or contain the text of its line `// expected: TEXT`.
Usage: tools/check_must_not_compile.py [--folder FOLDER] COMPILER..."""
import concurrent.futures
import os
import pathlib
import re
import subprocess

import command_line

ROOT = pathlib.Path(__file__).resolve().parent.parent
INCLUDES = ("src", "include/openevc", "include")
FEWEST = 12  # cases; a folder that was not found is no proof


def compiled(compiler, file, *flags):
    """(whether it compiled, what the compiler said)."""
    done = subprocess.run([compiler, "-std=c++20", *(f"-I{ROOT / d}" for d in INCLUDES), "-fsyntax-only", "-Wall", "-Wextra", "-Werror",
                           "-Wno-unused-variable", "-Wno-unused-const-variable", *flags, str(file)], capture_output=True, text=True,
                          env={**os.environ, "LC_ALL": "C"})
    return done.returncode == 0, done.stderr


def mistake_lines(text):
    """Numbers of the lines between `#ifdef MISTAKE` and its end or `#else`."""
    lines, inside = set(), False
    for number, line in enumerate(text.splitlines(), 1):
        if re.match(r"#\s*ifdef MISTAKE\b", line):
            inside = True
        elif re.match(r"#\s*(else|endif)", line):
            inside = False
        elif inside:
            lines.add(number)
    return lines


def faults_of(compiler, file):
    text = file.read_text(encoding="utf-8")
    name = f"{file.name} with {os.path.basename(compiler)}"
    expected = re.search(r"// expected: (.+)", text)
    right, said = compiled(compiler, file)
    if not right:
        return [f"{name}: does not compile without its mistake\n{said}"]
    wrong, said = compiled(compiler, file, "-DMISTAKE")
    if wrong:
        return [f"{name}: compiles with its mistake"]
    if expected:
        if expected[1].strip() not in said:
            return [f"{name}: the error is not \"{expected[1].strip()}\"\n{said}"]
        return []
    at = {int(n) for n in re.findall(rf"{re.escape(str(file))}:(\d+):", said)}
    return [] if at & mistake_lines(text) else [f"{name}: the error is not at the mistake\n{said}"]


def main():
    parser = command_line.Parser(__doc__)
    parser.add_argument("--folder", type=command_line.folder, default=ROOT / "tests/must_not_compile")
    parser.add_argument("--fewest", type=command_line.whole(0), default=FEWEST)
    parser.add_argument("compilers", nargs="+")
    options = parser.parse_args()
    files = sorted(options.folder.glob("*.cpp"))
    jobs = [(compiler, file) for file in files for compiler in options.compilers]
    with concurrent.futures.ThreadPoolExecutor(command_line.jobs(2)) as pool:
        found = [fault for faults in pool.map(lambda job: faults_of(*job), jobs) for fault in faults]
    for fault in found:
        print(f"must not compile: {fault}")
    print(f"must not compile: {len(files)} mistakes, {len(options.compilers)} compilers, {len(found)} faults")
    if len(files) < options.fewest:
        print(f"must not compile: fewer than {options.fewest} mistakes")
        return 1
    return 1 if found else 0


if __name__ == "__main__":
    command_line.run(main)
