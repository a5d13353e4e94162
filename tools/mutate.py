#!/usr/bin/env python3
"""Mutation testing of one room: are its tests able to fail? Every rule of src/ROOM is changed in one place at a
time (a mutant), the room's test is built with it and run. A mutant that no test notices is a survivor: a test is
missing, or the mutant means the same (then it is listed, with the reason, in docs/ROOM-mutants.md).

Operators: row (drops a row of a table), cell (another enumerator), compare (< <= and so on), logic (&& ||), negate
(a condition), sign (+ -), factor (* /), minmax, number (a constant), truth (true false), delete (a statement).
Nothing is written outside build/mutants/ROOM: a copy of the sources is taken there, the mutated file lies in a folder
of its own that is searched first, and only what includes it is compiled again. Tests that look at a changed header by
themselves come first, then all tests, the quick ones first. Lines that trap the impossible (EVC_REQUIRE) are left alone.

Usage: tools/mutate.py ROOM [--rows | --rest] [--sample N [--seed S]] [--files PATTERN] [--survivors] [--behaviour] [--list]
  --rows       all rows of the constexpr tables and nothing else (operators row, cell, number, truth there);  --rest: all but these
  --behaviour  without the tests that include the changed header themselves
  --sample N   N mutants by lot;  --files: only files whose name matches;  --survivors: those of the last run again
Exit status 1 where a mutant survives that the document does not list."""
import argparse
import fnmatch
import json
import os
import pathlib
import random
import re
import resource
import shlex
import shutil
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
SRC = ROOT / "src"
TEST_SECONDS = 60
MEMORY = 2 << 30
CXX = shlex.split(os.environ.get("CXX", "g++"))
FLAGS = ["-std=c++20", "-w", "-ffp-contract=off"]
TEST_FLAGS = ["-O0"]
ROOM_FLAGS = ["-O1", "-fno-exceptions", "-fno-rtti"]


# ---- Where mutants come from ----------------------------------------------------------------------

def masked(text):
    """The text with comments and literals of the same length made blank."""
    pattern = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|(?<![0-9a-fA-F])\'(?:\\.|[^\'\\\n])+\'', re.S)
    return pattern.sub(lambda m: re.sub(r"[^\n]", " ", m.group()), text)


def enumerators(room):
    """Enum name -> its values, of all headers of the room and of what it includes."""
    found = {}
    for header in SRC.glob("*/*.h"):
        if header.parent.name not in room.rooms:
            continue
        for name, body in re.findall(r"enum class (\w+)[^{;]*\{([^}]*)\}", masked(header.read_text())):
            values = [v.split("=")[0].strip() for v in body.split(",")]
            found[name] = [v for v in values if v and v != "count"]
    return found


SWAPS = {
    "compare": {"<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "=="},
    "logic": {"&&": "||", "||": "&&"},
    "sign": {"+": "-", "-": "+", "+=": "-=", "-=": "+="},
    "factor": {"*": "/", "/": "*"},
}
OPERATOR = {old: (name, new) for name, swaps in SWAPS.items() for old, new in swaps.items()}


def closing(text, at):
    depth = 0
    for i in range(at, len(text)):
        depth += (text[i] == "(") - (text[i] == ")")
        if depth == 0:
            return i
    return -1


def changed_number(literal):
    if re.fullmatch(r"\d+[uU]?", literal):
        return re.sub(r"\d+", lambda m: str(int(m.group()) + 1), literal)
    value = float(literal)
    return "1.0" if value == 0.0 else repr(value * 1.1)


def mutants_of(path, enums):
    """Yields (start, end, replacement, operator, in a table row)."""
    text = path.read_text()
    code = masked(text)
    lines, at = [], 0
    for line in code.split("\n"):
        lines.append((at, line))
        at += len(line) + 1
    in_table = False
    previous = ";"
    for start, line in lines:
        stripped = line.strip()
        if re.search(r"constexpr \w+ k\w+\[\] = \{$", stripped):
            in_table = True
            previous = "{"
            continue
        if in_table and stripped == "};":
            in_table = False
        row = in_table and stripped.startswith("{")
        skip = stripped.startswith(("#", "EVC_REQUIRE", "static_assert", "template", "using", "namespace", "enum "))
        if not stripped or skip:
            if stripped:
                previous = stripped[-1]
            continue
        if row:
            yield start, start + len(line), "", "row", True
        for m in re.finditer(r"\b(\w+)::(\w+)\b", line):
            values = enums.get(m.group(1))
            if values and m.group(2) in values and len(values) > 1:
                other = values[(values.index(m.group(2)) + 1) % len(values)]
                yield start + m.start(2), start + m.end(2), other, "cell", row
        for m in re.finditer(r"(?<= )(<=|>=|==|!=|<|>|&&|\|\||\+=|-=|[-+*/])(?= )", line):
            name, new = OPERATOR[m.group()]
            yield start + m.start(), start + m.end(), new, name, row
        for m in re.finditer(r"\bstd::(min|max)\(", line):
            yield start + m.start(1), start + m.end(1), {"min": "max", "max": "min"}[m.group(1)], "minmax", row
        for m in re.finditer(r"\b(true|false)\b", line):
            yield start + m.start(), start + m.end(), {"true": "false", "false": "true"}[m.group()], "truth", row
        for m in re.finditer(r"(?<![\w.])(\d+\.\d*(?:[eE][-+]?\d+)?|\d+[eE][-+]?\d+|\d+[uU]?)(?![\w.])", line):
            yield start + m.start(), start + m.end(), changed_number(m.group()), "number", row
        for m in re.finditer(r"\b(?:if|while) \(", line):
            begin = start + m.end() - 1
            end = closing(code, begin)
            if end > 0 and ";" not in code[begin:end] and "const " not in code[begin:end]:
                yield begin, end + 1, "(!" + text[begin:end + 1] + ")", "negate", False
        whole = previous in ";{}:)" or previous == "e"
        # An assignment, a call, a jump; or one of them after `if (a)` or `else`: these lose what they do.
        head = re.match(r"(?:else )?(?:if|for|while) \(", stripped)
        acts = re.match(r"(?:\+\+|--)?[\w.:>\[\]-]+(?:\(| [-+*/|&]?= |;|\+\+|--)", stripped)
        if whole and stripped.endswith(";") and stripped.count(";") == 1 and (acts or head or stripped[:5] == "else "):
            if not stripped.startswith("return") and line.count("(") == line.count(")"):
                offset = len(line) - len(line.lstrip())
                if head:
                    end = closing(line, offset + head.end() - 1)
                    if end > 0 and line[end + 1:].strip() not in ("", ";"):
                        yield start + end + 2, start + len(line), ";", "delete", False
                elif stripped.startswith("else "):
                    yield start + offset + 5, start + len(line), ";", "delete", False
                else:
                    yield start + offset, start + len(line), ";", "delete", False
        previous = "e" if stripped.endswith("else") else stripped[-1]


class Mutant:
    def __init__(self, path, text, start, end, new, operator, row):
        self.path, self.operator, self.row = path, operator, row
        self.mutated = text[:start] + new + text[end:]
        self.line = text.count("\n", 0, start) + 1
        first = text.rfind("\n", 0, start) + 1
        last = text.find("\n", end)
        before = text[first:last if last > 0 else len(text)].strip()
        old = text[start:end]
        self.what = f"`{old.strip()}` gone" if operator in ("row", "delete") else f"`{old}` -> `{new}`"
        if operator not in ("row", "delete"):
            self.what += f" in `{before}`"
            same = text[first:start].count(old)
            if same:
                self.what += f" ({same + 1})"
        self.what = re.sub(r"\s+", " ", self.what)
        self.name = path.relative_to(ROOT).as_posix()

    def key(self):
        return self.name + " " + self.operator + " " + self.what


# ---- Building -------------------------------------------------------------------------------------

class Room:
    def __init__(self, name):
        self.name = name
        self.rooms = []
        self._depend(name)
        self.out = ROOT / "build" / "mutants" / name
        self.src = self.out / "src"  # the copy that everything is compiled from
        self.objects = {}  # source -> (object, includes)
        self.others = self.out / "others.a"
        self.test_suites = []

    def _depend(self, name):
        if name in self.rooms:
            return
        self.rooms.append(name)
        m = re.search(r"evc_room\((.*?)\)", (SRC / name / "CMakeLists.txt").read_text(), re.S)
        words = m.group(1).split()
        if "DEPENDS" in words:
            for word in words[words.index("DEPENDS") + 1:]:
                if word == "LIBRARIES":
                    break
                self._depend(word)

    def compile(self, source, out, tree=None):
        test = source.name.endswith("_test.cpp")
        command = CXX + FLAGS + (TEST_FLAGS if test else ROOM_FLAGS)
        if test:
            command += ["-include", str(self.out / "common.h")]
        command += [f"-I{tree}"] if tree else []
        command += [f"-I{self.src}", f'-DEVC_SOURCE_DIR="{ROOT}"', "-MMD", "-MF", str(out) + ".d"]
        command += ["-c", str(source), "-o", str(out)]
        return subprocess.run(command, capture_output=True, text=True)

    def copy(self):
        for name in self.rooms:
            for old in (self.src / name).rglob("*.*"):
                if not (SRC / old.relative_to(self.src)).exists():
                    old.unlink()
            for file in (SRC / name).rglob("*.*"):
                copy = self.src / file.relative_to(SRC)
                if file.suffix in (".cpp", ".h") and not (copy.exists() and copy.read_bytes() == file.read_bytes()):
                    copy.parent.mkdir(parents=True, exist_ok=True)
                    shutil.copyfile(file, copy)

    @staticmethod
    def includes(out):
        """What an object was made of; None where it has to be made (again)."""
        depends = pathlib.Path(str(out) + ".d")
        if not out.exists() or not depends.exists():
            return None
        words = {pathlib.Path(w) for w in depends.read_text().replace("\\\n", " ").split()[1:]}
        newer = any(not w.exists() or w.stat().st_mtime > out.stat().st_mtime for w in words)
        return None if newer else words

    def prepare(self):
        """Everything once, unchanged."""
        self.copy()
        # What every test includes, compiled once.
        common = self.out / "common.h"
        if not common.exists():
            common.write_text("#include <gtest/gtest.h>\n")
            command = CXX + FLAGS + TEST_FLAGS + ["-x", "c++-header", str(common), "-o", str(common) + ".gch"]
            subprocess.run(command, check=True)
        others = []
        for name in self.rooms:
            for source in sorted((self.src / name).glob("*.cpp")):
                if name != self.name and source.name.endswith("_test.cpp"):
                    continue
                out = self.out / (name + "_" + source.stem + ".o")
                if self.includes(out) is None:
                    done = self.compile(source, out)
                    if done.returncode:
                        sys.exit(f"{source}: does not compile\n{done.stderr}")
                if name == self.name:
                    self.objects[source] = (out, self.includes(out))
                else:
                    others.append(out)
        # The linker takes of other rooms what it needs.
        self.others.unlink(missing_ok=True)
        subprocess.run(["ar", "rcs", str(self.others)] + [str(o) for o in others], check=True)
        binary = self.out / "base_test"
        self.link(binary, [o for o, _ in self.objects.values()])
        report = self.out / "base.json"
        done = self.run(binary, [f"--gtest_output=json:{report}"])
        if done != 0:
            sys.exit(f"mutate: the unchanged test of {self.name} fails ({done}); nothing to learn from mutants")
        suites = json.loads(report.read_text())["testsuites"]
        self.test_suites = sorted(((float(s["time"].rstrip("s")), s["name"]) for s in suites))

    def link(self, binary, objects):
        command = CXX + ["-fuse-ld=lld" if shutil.which("ld.lld") else "-O1", "-o", str(binary)]
        done = subprocess.run(command + [str(o) for o in objects] + [str(self.others), "-lgtest", "-lgtest_main", "-lpthread"],
                              capture_output=True, text=True)
        return done.returncode == 0

    def run(self, binary, arguments):
        def limit():
            resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        try:
            return subprocess.run([str(binary)] + arguments, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                  timeout=TEST_SECONDS, preexec_fn=limit, cwd=self.out).returncode
        except subprocess.TimeoutExpired:
            return "time"

    def helpers(self):
        """Test objects without tests of their own."""
        return [out for source, (out, _) in self.objects.items() if source.name.endswith("_test.cpp")
                and not re.search(r"^TEST|^INSTANTIATE", source.read_text(), re.M)]

    def tests_notice(self, binary):
        """The suites that take no time first, then the rest; None where all pass."""
        quick = [name for seconds, name in self.test_suites if seconds < 0.1]
        for names in (quick, [name for _, name in self.test_suites if name not in quick]):
            if not names:
                continue
            chosen = ":".join(name + ".*" for name in names)
            result = self.run(binary, ["--gtest_fail_fast", "--gtest_filter=" + chosen])
            if result != 0:
                return "time" if result == "time" else "crash" if result < 0 else "test"
        return None

    def judge(self, mutant, behaviour_only):
        tree = self.out / "tree"
        shutil.rmtree(tree, ignore_errors=True)
        changed = tree / self.name / mutant.path.name
        changed.parent.mkdir(parents=True)
        changed.write_text(mutant.mutated)
        original = self.src / self.name / mutant.path.name
        keep, keep_tests, again, again_tests = [], [], [], []
        for source, (out, includes) in self.objects.items():
            test = source.name.endswith("_test.cpp")
            if source != original and original not in includes:
                (keep_tests if test else keep).append(out)
            else:
                (again_tests if test else again).append((changed if source == original else source, out))
        if behaviour_only:
            again_tests = []

        def compile_all(sources):
            made = []
            for source, out in sources:
                new = self.out / ("mutant_" + out.name)
                if self.compile(source, new, tree).returncode:
                    return None
                made.append(new)
            return made

        binary = self.out / "mutant_test"
        new_tests = compile_all(again_tests)
        if new_tests is None:
            return "does not compile"
        # Tests that need nothing but the header.
        own = f"{self.name}_{mutant.path.stem}_test.o"
        first = [o for o in new_tests if o.name == "mutant_" + own]
        if first and self.link(binary, first + self.helpers() + keep):
            if self.run(binary, ["--gtest_fail_fast"]) != 0:
                return "killed: test of the header"
        new = compile_all(again)
        if new is None or not self.link(binary, keep + new + keep_tests + new_tests):
            return "does not compile"
        how = self.tests_notice(binary)
        return "survived" if how is None else "killed: " + ("behaviour" if how == "test" else how)


# ---- A run ----------------------------------------------------------------------------------------

def listed(room):
    """What docs/ROOM-mutants.md accounts for: keys without line numbers."""
    document = ROOT / "docs" / f"{room}-mutants.md"
    known = set()
    if document.exists():
        for line in document.read_text().splitlines():
            cells = [c.strip() for c in line.replace("\\|", "\0").strip("|").split("|")]
            if line.startswith("|") and len(cells) >= 3:
                known.add((cells[0].split(":")[0], cells[1].replace("\0", "|")))
    return known


def results_file(room, options):
    return room.out / ("results-rows.jsonl" if options.rows else "results.jsonl")


def choose(room, options):
    enums = enumerators(room)
    included = set()
    for source in SRC.glob("*/*"):
        if source.suffix in (".cpp", ".h") and not source.name.endswith("_test.cpp"):
            included.update(re.findall(rf'^#include "{room.name}/(\w+\.h)"', source.read_text(), re.M))
    tests_only = {h.name for h in (SRC / room.name).glob("*.h")} - included
    mutants = []
    for path in sorted((SRC / room.name).iterdir()):
        if path.suffix not in (".cpp", ".h") or path.name.endswith("_test.cpp") or path.name in tests_only:
            continue
        if options.files and not fnmatch.fnmatch(path.name, options.files):
            continue
        text = path.read_text()
        for found in mutants_of(path, enums):
            mutant = Mutant(path, text, *found)
            if mutant.row if options.rows else not (mutant.row and options.rest):
                mutants.append(mutant)
    if options.survivors:
        last = {r["key"] for r in map(json.loads, results_file(room, options).read_text().splitlines())
                if r["verdict"] == "survived"}
        mutants = [m for m in mutants if m.key() in last]
    mutants.sort(key=lambda m: m.operator != "row")
    if options.sample and options.sample < len(mutants):
        mutants = random.Random(options.seed).sample(mutants, options.sample)
    return mutants


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("room")
    parser.add_argument("--rows", action="store_true")
    parser.add_argument("--rest", action="store_true")
    parser.add_argument("--sample", type=int, default=0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--files")
    parser.add_argument("--behaviour", action="store_true")
    parser.add_argument("--survivors", action="store_true")
    parser.add_argument("--list", action="store_true")
    options = parser.parse_args()
    room = Room(options.room)
    mutants = choose(room, options)
    if options.list:
        for m in mutants:
            print(f"{m.name}:{m.line}: {m.operator}: {m.what}")
        print(f"mutate: {len(mutants)} mutants")
        return 0
    room.prepare()
    known = listed(options.room)
    counts = {}
    unknown = 0
    begin = time.monotonic()
    with open(results_file(room, options), "w") as results:
        for number, m in enumerate(mutants, 1):
            verdict = room.judge(m, options.behaviour)
            counts[verdict] = counts.get(verdict, 0) + 1
            results.write(json.dumps({"key": m.key(), "file": m.name, "line": m.line, "operator": m.operator,
                                      "what": m.what, "verdict": verdict}) + "\n")
            results.flush()
            if verdict == "survived":
                accounted = (m.name, m.what) in known
                counts["survived, listed"] = counts.get("survived, listed", 0) + accounted
                unknown += not accounted
                if not accounted:
                    print(f"survived: {m.name}:{m.line}: {m.operator}: {m.what}", flush=True)
            if number % 100 == 0:
                print(f"mutate: {number} of {len(mutants)}, {time.monotonic() - begin:.0f} s", file=sys.stderr)
    killed = sum(n for verdict, n in counts.items() if verdict.startswith("killed"))
    print(f"mutate {options.room}: {len(mutants)} mutants, {counts.get('does not compile', 0)} do not compile, "
          f"{killed} killed, {counts.get('survived', 0)} survived, {unknown} of them not accounted for, "
          f"{time.monotonic() - begin:.0f} s")
    for verdict in sorted(counts):
        print(f"  {counts[verdict]:5} {verdict}")
    return 1 if unknown else 0


if __name__ == "__main__":
    sys.exit(main())
