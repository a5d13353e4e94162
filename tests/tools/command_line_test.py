"""Every tool and example in Python ends with one sentence and exit status 2 for options and files that are wrong."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
# Modules for others, not programs.
MODULES = {"command_line.py", "field_uses.py", "included.py"}


def programs():
    """The Python programs of the tools, by their first lines."""
    for path in sorted((ROOT / "tools").iterdir()):
        if path.is_file() and path.name not in MODULES and path.read_bytes().startswith((b"#!/usr/bin/env python3", b"#!/usr/bin/env -S python3")):
            yield path


class CommandLine(unittest.TestCase):
    def refused(self, path, *arguments, says="", environment=None):
        done = subprocess.run([sys.executable, "-B", ROOT / path, *map(str, arguments)], capture_output=True, text=True, check=False,
                              cwd=tempfile.gettempdir(), env={**os.environ, **(environment or {})}, stdin=subprocess.DEVNULL)
        with self.subTest(path=str(path), arguments=arguments):
            self.assertEqual(done.returncode, 2, done.stderr + done.stdout)
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
            self.assertIn(says, done.stderr)

    def test_every_program_refuses_an_option_that_it_does_not_have(self):
        found = list(programs())
        self.assertGreater(len(found), 25)
        for path in [*found, ROOT / "examples/bridge/bridge.py"]:
            self.refused(path, "--nonsense")

    def test_numbers(self):
        for arguments in (["--seed", "x"], ["--seed", "-1"], ["--seed", "1.5"], ["--seed", ""], []):
            self.refused("tools/random_line.py", *arguments, says="--seed")
        for number in ("1_000", "\uff11\uff12", "\u0661", " 1", "1 ", "0x1", "1" * 5000):
            self.refused("tools/random_line.py", "--seed", number, says="expected a whole number")
        self.refused("tools/campaign_journeys.py", "--journeys", "0", says="found '0', expected a whole number from 1 on")
        self.refused("tools/campaign_lines", "--runs", "many", says="--runs")
        self.refused("tools/compare_lines.py", "--before", sys.executable, "--after", sys.executable, "--lines", "0", says="--lines")
        for ranks in ("1,x", "", "0", "1,,2", "-2", "99999"):
            self.refused("tools/measure_ranks", "--ranks=" + ranks, says="expected a whole number from 1 to 1024")
        self.refused("tools/measure_ranks", "--rounds", "0", says="--rounds")
        self.refused("tools/check_stack.py", "--top", "x", says="--top")
        self.refused("tools/mutate.py", "sdm", "--jobs", "0", says="--jobs")
        self.refused("tools/check_must_not_compile.py", "c++", says="JOBS: found 'x'", environment={"JOBS": "x"})
        self.refused("examples/bridge/bridge.py", ROOT / "data/lines/brunnental.json", "--port", "x", says="--port")
        self.refused("examples/bridge/bridge.py", ROOT / "data/lines/brunnental.json", "--port", "1", says="--port 1: found")

    def test_files_and_folders_that_are_not_there(self):
        for path in ("tools/check_links.py", "tools/check_tree.py", "tools/check_words.py", "tools/check_layers.py", "tools/check_texts.py"):
            self.refused(path, "/no/such", says="found no folder /no/such, expected one")
        self.refused("tools/check_size.py", "--root", "/no/such", says="/no/such")
        self.refused("tools/check_requirements.py", "--root", "/no/such", says="/no/such")
        self.refused("tools/check_must_not_compile.py", "--folder", "/no/such", "c++", says="/no/such")
        self.refused("tools/check_coverage.py", "--build", "/no/such", says="/no/such")
        self.refused("tools/check_abi.py", "/no/such.so", says="found no file /no/such.so, expected one")
        self.refused("tools/check_replays.py", "--command", "/no/such", says="found no program /no/such, expected one")
        self.refused("tools/check_replays.py", "--command", ROOT / "README.md", says="README.md")
        self.refused("tools/check_replays.py", "--filled", "/no/such", says="/no/such")
        self.refused("tools/check_replays.py", says="--command")
        self.refused("tools/check_readme.py", "--command", "/no/such", says="/no/such")
        self.refused("tools/compare_lines.py", "--before", "/no/such", "--after", "/no/such", says="/no/such")
        self.refused("tools/count_instructions.py", "/no/such.jsonl", says="/no/such.jsonl")
        self.refused("tools/campaign_lines", "/no/such.json", says="/no/such.json")
        self.refused("tools/generate_language.py", "/no/such", says="/no/such")
        self.refused("tools/measure_ranks", "--spec", "/no/such", says="/no/such")
        self.refused("tools/measure_ranks", "--build", "/no/such", says="/no/such/evc-mpi")
        self.refused("tools/plot_growth", "/no/such", "-o", "x.svg", says="/no/such")
        self.refused("examples/bridge/bridge.py", "/no/such", says="/no/such: No such file")
        self.refused("examples/bridge/bridge.py", ROOT / "data/lines/brunnental.json", "--start", "/no/such", says="/no/such: No such file")

    def test_files_with_other_contents(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, contents in (("words", b"no JSON"), ("list", b"[1]"), ("object", b"{}"), ("bytes", b"\xff\xfe{"), ("empty", b""),
                                   ("zipped.gz", b"no gzip")):
                path = pathlib.Path(folder) / name
                path.write_bytes(contents)
                if name != "empty":
                    self.refused("tools/campaign_lines", path, says=str(path))
                self.refused("tools/plot_growth", path, "-o", path.with_suffix(".svg"), says=str(path))
                if name not in ("object", "list"):
                    self.refused("tools/check_replays.py", "--filled", path, says="check_replays.py: ")
                self.refused("examples/bridge/bridge.py", path, says=str(path))
            path = pathlib.Path(folder) / "deep.json"
            path.write_text("[" * 200000, encoding="ascii")
            for program in ("tools/campaign_lines", "examples/bridge/bridge.py"):
                self.refused(program, path, says=str(path))
            self.refused("tools/plot_growth", path, "-o", path.with_suffix(".svg"), says=str(path))
            self.refused("tools/generate_language.py", folder, says="variables.json")

    def test_a_program_that_does_not_end(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "waits.py"
            path.write_text(f"import subprocess, sys\nsys.path.insert(0, {str(ROOT / 'tools')!r})\nimport command_line\n"
                            "command_line.run(lambda: subprocess.run(['sleep', '9'], timeout=0.1))\n", encoding="utf-8")
            self.refused(path, says="waits.py: sleep 9 did not end within 0.1 s")


if __name__ == "__main__":
    unittest.main()
