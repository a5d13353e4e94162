#!/usr/bin/env python3
"""Runs the examples of README.md and of the pages under docs/ exactly as written.

Every line `$ COMMAND` of a ```console block is run by bash; the lines up to the next `$ ` line are the expected
output (standard output and error together; empty lines at the end do not count). A line `...` matches any number of lines, `[...]`
inside a line any text. The commands of one page share a scratch folder in which data/, docs/ and
examples/ of the project are available and `evc` is in the PATH.

Usage: tools/check_readme.py [--command build/dev/evc] [--update] [PAGE...]
--update writes the actual output into the pages, in examples without wildcards."""
import os
import pathlib
import re
import subprocess
import tempfile

import command_line

ROOT = pathlib.Path(__file__).resolve().parent.parent


def examples(text):
    """(line number, command, expected output lines) of every example in a page."""
    found, inside, expected = [], False, []
    lines = iter(enumerate(text.splitlines(), 1))
    for number, line in lines:
        if not inside:
            inside = line.strip() == "```console"
            expected = []
        elif line.strip() == "```":
            inside = False
        elif line.startswith("$ "):
            command = line[2:]
            while command.endswith("\\"):
                command += "\n" + next(lines)[1]
            expected = []
            found.append((number, command, expected))
        else:
            expected.append(line)
    return found


def matches(expected, printed):
    """Whether the printed text is what the page shows."""
    pattern = ""
    while expected and not expected[-1].strip():
        expected = expected[:-1]
    for line in expected:
        if line.strip() == "...":
            pattern += r"(?:.*\n)*?"
        else:
            pattern += r"[^\n]*?".join(re.escape(part.rstrip()) for part in line.split("[...]")) + r"[ \t]*\n"
    printed = printed.rstrip("\n") + "\n" if printed.strip("\n") else ""
    return re.fullmatch(pattern, printed) is not None


def run_page(page, command, update=False):
    failures, count = [], 0
    text = page.read_text(encoding="utf-8")
    with tempfile.TemporaryDirectory(prefix="evc-readme-") as scratch:
        for name in ("data", "docs", "examples"):
            if (ROOT / name).exists():
                os.symlink(ROOT / name, pathlib.Path(scratch) / name)
        environment = dict(os.environ, PATH=f"{command.parent}:{os.environ['PATH']}", LC_ALL="C.UTF-8")
        for number, line, expected in examples(text):
            count += 1
            done = subprocess.run(["bash", "-o", "pipefail", "-c", line], cwd=scratch, env=environment, text=True,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL, timeout=300)
            where = f"{page.relative_to(ROOT)}:{number}: {line}"
            if done.returncode != 0:
                failures.append(f"{where}\n  exit {done.returncode}\n{done.stdout}")
            elif not matches(expected, done.stdout):
                shown = "\n".join(expected).rstrip("\n")
                if update and shown and "..." not in shown:
                    text = text.replace(f"$ {line}\n{shown}\n", f"$ {line}\n{done.stdout.rstrip(chr(10))}\n")
                    page.write_text(text, encoding="utf-8")
                    continue
                failures.append(f"{where}\n  the page shows:\n" + "\n".join(expected) + f"\n  it prints:\n{done.stdout}")
    return count, failures


def main():
    parser = command_line.Parser(__doc__)
    parser.add_argument("--command", default=ROOT / "build/dev/evc", type=pathlib.Path)
    parser.add_argument("--update", action="store_true")
    parser.add_argument("pages", nargs="*", type=command_line.file)
    options = parser.parse_args()
    command = command_line.program(options.command)
    pages = [p.resolve() for p in options.pages] or [ROOT / "README.md", *sorted(ROOT.glob("docs/**/*.md"))]
    total, failures = 0, []
    for page in pages:
        count, failed = run_page(page, command, options.update)
        total += count
        failures += failed
    for failure in failures:
        print(failure)
    print(f"examples: {total} run, {len(failures)} failed")
    return 1 if failures else 0


if __name__ == "__main__":
    command_line.run(main)
