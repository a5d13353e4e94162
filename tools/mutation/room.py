"""A room and its tests: built, run with a mutant, judged. Nothing is written outside build/mutants/ROOM."""
import concurrent.futures
import json
import math
import os
import pathlib
import re
import resource
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import threading

from mutation import schema
from mutation.sources import PUBLIC, ROOT, SRC, mutants_of_room

HERE = pathlib.Path(__file__).resolve().parent
SHARED = ROOT / "build" / "mutants" / "shared"  # what no mutant changes: other rooms, the test library
CXX = shlex.split(os.environ.get("CXX", "g++"))
FLAGS = ["-std=c++20", "-w", "-Wno-narrowing", "-ffp-contract=off", f'-DEVC_SOURCE_DIR="{ROOT}"',
         f'-DEVC_DATA_DIR="{ROOT}/data"', '-DEVC_VERSION=""']
ROOM_FLAGS = ["-O1"]
KERNEL_FLAGS = ["-fno-exceptions", "-fno-rtti"]
HOST_FLAGS = ["-O2", "-DNDEBUG"]  # a scenario is mostly reading and writing of JSON
SCENARIOS = ROOT / "tests/scenarios"
WITH_SCENARIOS = {"kernel"}  # rooms whose tests are the scenarios too
SLOW_TEST = 0.25  # seconds
FEW = 60  # mutants that are sooner judged by all tests than each test has run by itself to see what it reaches
NEAREST = 10  # scenarios that are tried before the others
TIME_FACTOR, TIME_MORE = 4, 1  # a mutant has this many times the processor time of the unchanged room, and seconds more
WAITED = 20  # times that: a mutant that sleeps


def is_test(source):
    return source.name.endswith("_test.cpp")


def rooms_in(text, target):
    """The rooms that a target of a CMakeLists.txt links."""
    linked = re.findall(rf"target_link_libraries\({target} ([^)]*)\)|TEST_LIBRARIES ([^)]*)\)", text)
    return [room for words in map(" ".join, linked) for room in re.findall(r"\bevc_(\w+)", words) if room != "private"]


def verdict_of(result):
    return "killed: " + ("time" if result == "time" else "crash" if result < 0 else "test")


def write(path, text):
    """Only where it changes: what is made of it stays as new as it is."""
    if not (path.exists() and path.read_text() == text):
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)


def includes(out):
    """What an object was made of; None where it has to be made (again)."""
    depends = pathlib.Path(str(out) + ".d")
    if not out.exists() or not depends.exists():
        return None
    words = {pathlib.Path(w) for w in depends.read_text().replace("\\\n", " ").split()[1:]}
    newer = any(not w.exists() or w.stat().st_mtime > out.stat().st_mtime for w in words)
    return None if newer else words


def finish(part, out):
    """What was compiled gets its name when it is complete: another run may want it too."""
    os.replace(f"{part}.d", f"{out}.d")
    os.replace(part, out)


class Build:
    """One way to compile everything: folders that are searched first, flags, and a folder for what is made. `kernel`:
    rooms that need neither exceptions nor run-time types."""
    def __init__(self, out, trees, kernel, test_flags, include):
        self.out, self.trees, self.kernel, self.test_flags = out, trees, kernel, test_flags
        self.common = SHARED / out.name / "common.h"  # what every test includes, compiled once
        self.include = include
        out.mkdir(parents=True, exist_ok=True)

    def flags(self, source, trees):
        if is_test(source):
            return self.test_flags
        room = next((source.relative_to(t).parts[0] for t in trees if source.is_relative_to(t)), None)
        return ROOM_FLAGS + (KERNEL_FLAGS if room in self.kernel else HOST_FLAGS)

    def command(self, source, trees=()):
        flags = CXX + FLAGS + self.flags(source, (*trees, *self.trees))
        first = [self.common] if is_test(source) else self.include
        flags += [word for header in first for word in ("-include", str(header))]
        return flags + [f"-I{tree}" for tree in (*trees, *self.trees)]

    def compile(self, source, out, trees=()):
        command = self.command(source, trees) + ["-MMD", "-MF", f"{out}.d", "-c", str(source), "-o", str(out)]
        return subprocess.run(command, capture_output=True, text=True)

    def made(self, source, name):
        """The object, compiled where something is newer."""
        out = self.out / name
        if includes(out) is None:
            part = self.out / f"{os.getpid()}_{name}"
            done = self.compile(source, part)
            if done.returncode:
                sys.exit(f"{source}: does not compile\n{done.stderr}")
            finish(part, out)
        return out

    def errors(self, source):
        command = self.command(source) + ["-fsyntax-only", "-fmax-errors=0", "-Werror=vla", str(source)]
        done = subprocess.run(command, capture_output=True, text=True, env={**os.environ, "LC_ALL": "C"})
        return done.stderr if done.returncode else ""

    def prepare_common(self):
        lines = "".join(f'#include "{header}"\n' for header in self.include) + "#include <gtest/gtest.h>\n"
        write(self.common, lines)
        compiled = pathlib.Path(f"{self.common}.gch")
        if includes(compiled) is None:
            part = self.common.parent / str(os.getpid())
            command = CXX + FLAGS + self.test_flags + ["-MMD", "-MF", f"{part}.d"]
            subprocess.run(command + ["-x", "c++-header", str(self.common), "-o", str(part)], check=True)
            finish(part, compiled)


class Room:
    def __init__(self, name, jobs=1, build=None):
        self.name, self.jobs = name, jobs
        self.rooms, self.kernel = [], set()
        self.scenarios = name in WITH_SCENARIOS
        others = rooms_in((SRC / name / "CMakeLists.txt").read_text(), f"{name}_test")
        if self.scenarios:
            others += rooms_in((SCENARIOS / "CMakeLists.txt").read_text(), "evc_scenarios")
        for other in (name, *others):
            self._depend(other)
        if self.scenarios:  # they can go through the C interface
            self._depend("embed")
            self.rooms.append("capi")
        self.out = ROOT / "build" / "mutants" / (build or name)
        self.src = self.out / "src"  # the copy that everything is compiled from, whatever is edited meanwhile
        self.copy()
        self.mutants = mutants_of_room(self.src / name, [SHARED / "src" / room for room in self.rooms[1:]])
        self.wanted = self.mutants  # those that the one build is made for
        self.tree = self.out / "instrumented"
        self.all = Build(self.out / "all", [self.tree, self.src, SHARED / "src"], self.kernel, ["-O1"], [HERE / "schema.h"])
        self.plain = Build(self.out / "plain", [self.src, SHARED / "src"], self.kernel, ["-O0"], [])
        self.other = Build(SHARED / "objects", [SHARED / "src", self.src], self.kernel, [], [])
        self.others = self.out / "others.a"
        self.in_schema = set()  # numbers of the mutants that the one build holds
        self.objects = None  # of the plain build: source -> (object, what it was made of)
        self.steps = []  # names of tests beside the code, quick ones first
        self.tests_of = {}  # test source -> names
        self.seconds = {}  # test -> seconds
        self.reached = {}  # test -> numbers of the mutants that make a difference in it
        self.lock = threading.Lock()

    def _depend(self, name):
        if name in self.rooms:
            return
        self.rooms.append(name)
        words = re.search(r"evc_room\((.*?)\)", (SRC / name / "CMakeLists.txt").read_text(), re.S).group(1).split()
        if "KERNEL" in words:
            self.kernel.add(name)
        if "DEPENDS" in words:
            for word in words[words.index("DEPENDS") + 1:]:
                if word in ("LIBRARIES", "TEST_LIBRARIES"):
                    break
                self._depend(word)

    def object_name(self, source):
        """Of a source in one of the trees: folders too, for files of two folders may have one name."""
        tree = next(t for t in (self.tree, self.src, SHARED / "src") if source.is_relative_to(t))
        return "_".join(source.relative_to(tree).with_suffix(".o").parts)

    def each(self, work, items):
        with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
            return list(pool.map(work, items))

    # ---- Once ----------------------------------------------------------------------------------

    def prepare(self):
        """The build with all mutants, and what the unchanged room needs of time."""
        self.all.prepare_common()
        others = self.each(lambda s: self.other.made(s, self.object_name(s)),
                           [s for room in self.rooms[1:] for s in sorted((SHARED / "src" / room).rglob("*.cpp"))
                            if not is_test(s)])
        # The linker takes of other rooms what it needs.
        self.others.unlink(missing_ok=True)
        subprocess.run(["ar", "rcs", str(self.others)] + [str(o) for o in others], check=True)
        self.instrument()
        sources = [self.instrumented(s) for s in self.sources()]
        objects = self.each(lambda s: self.all.made(s, self.object_name(s)), sources)
        self.binary = self.out / "all_test"
        objects.append(self.all.made(HERE / "schema.cpp", "schema.o"))
        beside = [o for o in objects if not o.name.startswith(f"{SCENARIOS.name}_")]
        self.beside_binary = self.out / "beside_test" if self.scenarios else self.binary
        for binary, of in {self.beside_binary: beside, self.binary: objects}.items():
            if errors := self.link(binary, of):
                sys.exit(f"mutate: the test of {self.name} cannot be linked\n{errors}")
        self.time_tests()
        names = list(self.seconds)
        if len(self.wanted) <= FEW:
            numbers = {m.id for m in self.wanted}
            self.reached = {name: numbers for name in names}
        else:
            self.reached = dict(zip(names, self.each(self.reached_by, names)))

    def copy(self):
        for room in self.rooms:
            copy = self.src if room == self.name else SHARED / "src"
            for old in (copy / room).rglob("*.*"):
                if not any((root / old.relative_to(copy)).exists() for root in (SRC, PUBLIC)):
                    old.unlink()
            for root in (SRC, PUBLIC):
                for file in (root / room).rglob("*.*"):
                    if file.suffix in (".cpp", ".h", ".inc"):
                        write(copy / file.relative_to(root), file.read_text())
        if self.scenarios:
            for file in SCENARIOS.iterdir():
                if file.suffix in (".cpp", ".h"):
                    write(self.src / SCENARIOS.name / file.name, file.read_text())
        # "openevc/ROOM/x.h" is ROOM/x.h in a copy; headers above the public rooms are the same in every copy.
        for header in PUBLIC.glob("*.h"):
            write(SHARED / "src" / header.name, header.read_text())
        # What the build makes: no snapshot is exchanged here.
        write(SHARED / "src/kernel/state_layout.h", "#pragma once\n#define EVC_STATE_LAYOUT 0u\n")
        for tree in (self.src, SHARED / "src", self.out / "instrumented"):
            tree.mkdir(parents=True, exist_ok=True)
            if not (tree / "openevc").is_symlink():
                (tree / "openevc").symlink_to(".")

    def sources(self):
        """Of the room and its tests; with the scenarios these and what runs them."""
        folders = [self.src / self.name] + [self.src / SCENARIOS.name] * self.scenarios
        return sorted((s for f in folders for s in f.rglob("*.cpp")), key=lambda s: (not is_test(s), s.name))

    def instrumented(self, source):
        changed = self.tree / source.relative_to(self.src)
        return changed if changed.exists() else source

    def write_tree(self, dropped):
        # Files without a mutant too: what uses a table as a constant must not any more.
        files = {path: [] for path in (self.src / self.name).rglob("*.*")
                 if path.suffix in (".cpp", ".h") and not is_test(path) and not path.stem.startswith("test_")}
        for m in self.wanted:
            files.setdefault(m.path, []).append(m)
        for old in (self.tree / self.name).rglob("*.*"):
            if self.src / old.relative_to(self.tree) not in files:
                old.unlink()
        self.in_schema = set()
        for path, mutants in files.items():
            text, written = schema.instrumented(path.read_text(), mutants, dropped, path.name)
            write(self.tree / path.relative_to(self.src), text)
            self.in_schema |= written

    def instrument(self):
        """The instrumented tree, without the changes that do not compile. These are remembered by what they are, so
        that a run after a change of the sources begins where the last one ended."""
        keys = {str(m.id): m.key() for m in self.mutants}
        memory = SHARED / f"{self.name}.json"
        known = set(json.loads(memory.read_text())) if memory.exists() else set()
        dropped = {mark for mark in keys if keys[mark] in known} | known
        self.write_tree(dropped)
        stale = [s for s in self.sources() if includes(self.all.out / self.object_name(s)) is None]
        failing = [s for s in stale if not is_test(s)] or stale  # the room shows most, and sooner than its tests
        while failing:
            messages = self.each(lambda s: self.all.errors(self.instrumented(s)), failing)
            if not any(messages):
                failing = stale if failing != stale else []
                continue
            failing = [s for s, message in zip(failing, messages) if message]
            found = set().union(*(schema.blamed(message, self.tree) for message in messages)) - dropped
            if not found:
                sys.exit("mutate: the instrumented copy does not compile\n" + "".join(messages))
            print(f"mutate: {len(found)} changes taken back that do not compile, {len(failing)} sources", file=sys.stderr,
                  flush=True)
            dropped |= found
            self.write_tree(dropped)
        memory.write_text(json.dumps(sorted(known | {keys.get(mark, mark) for mark in dropped})))

    def time_tests(self):
        report = self.out / "unchanged.json"
        done = self.run(self.binary, 0, None, 600, [f"--gtest_output=json:{report}"])
        if done != 0:
            sys.exit(f"mutate: the unchanged test of {self.name} fails ({done}); nothing to learn from mutants")
        self.seconds = seconds = {}
        self.tests_of = {}
        for suite in json.loads(report.read_text())["testsuites"]:
            for test in suite["testsuite"]:
                name = suite["name"] + "." + test["name"]
                seconds[name] = float(test["time"].rstrip("s"))
                source = pathlib.Path(test["file"])
                if source.suffix == ".scenario":
                    source = SCENARIOS / "scenarios_test.cpp"  # it reads them
                self.tests_of.setdefault(source.name, set()).add(name)
        beside = [name for name in seconds if not self.is_scenario(name)]
        slow = sorted((name for name in beside if seconds[name] >= SLOW_TEST), key=seconds.get)
        self.steps = [[name for name in beside if seconds[name] < SLOW_TEST]] + [[name] for name in slow]

    def is_scenario(self, name):
        return self.scenarios and name in self.tests_of.get("scenarios_test.cpp", ())

    def reached_by(self, name):
        """What a test that runs by itself notes."""
        with tempfile.NamedTemporaryFile(dir=self.out) as notes:
            notes.truncate(len(self.mutants) + 1)
            done = self.run(self.binary, -1, [name], 600, more={"EVC_MUTANT_SEEN": notes.name})
            if done != 0:
                sys.exit(f"mutate: the unchanged test {name} fails by itself ({done})")
            return {number for number, seen in enumerate(notes.read()) if seen}

    def link(self, binary, objects):
        """What the linker says where it fails; empty: it is linked."""
        command = CXX + ["-fuse-ld=lld" if shutil.which("ld.lld") else "-O1", "-o", str(binary)]
        done = subprocess.run(command + [str(o) for o in objects] + [str(self.others), "-lgtest", "-lgtest_main", "-lpthread"],
                              capture_output=True, text=True)
        return done.stderr or "without a reason" if done.returncode else ""

    # ---- For every mutant ----------------------------------------------------------------------

    def run(self, binary, number, names, seconds, arguments=(), more=None):
        """The exit status of the tests with a mutant; "time" where they do not end."""
        environment = {**os.environ, "EVC_MUTANT": str(number), **(more or {})}
        with tempfile.NamedTemporaryFile("w", dir=self.out) as flags:
            # In a file: the names of all scenarios are too long for an argument.
            flags.write("--gtest_filter=" + (":".join(names or ()) or "*") + "\n")
            flags.flush()
            command = [str(binary), f"--gtest_flagfile={flags.name}", "--gtest_fail_fast", *arguments]
            with subprocess.Popen(command, env=environment, cwd=self.out, stdout=subprocess.DEVNULL,
                                  stderr=subprocess.DEVNULL) as tests:
                # Time of the processor: what else the machine does is no fault of the mutant.
                resource.prlimit(tests.pid, resource.RLIMIT_CPU, (math.ceil(seconds), math.ceil(seconds) + 1))
                try:
                    status = tests.wait(WAITED * math.ceil(seconds))
                except subprocess.TimeoutExpired:
                    tests.kill()
                    return "time"
                return "time" if status in (-signal.SIGXCPU, -signal.SIGKILL) else status

    def tests(self, binary, number, without=frozenset()):
        """The verdict of the tests: those beside the code, the quick ones first, in a program without the scenarios,
        which takes long to begin; then the scenarios that reach few mutants, then the other scenarios. Without those in
        which the mutant makes no difference."""
        def of(names):
            return [name for name in names if name not in without and number in self.reached[name]]

        scenarios = sorted(filter(self.is_scenario, of(self.seconds)),
                           key=lambda name: len(self.reached[name]) * self.seconds[name])
        steps = [(self.beside_binary, of(names)) for names in self.steps]
        steps += [(binary, scenarios[:NEAREST]), (binary, scenarios[NEAREST:])]
        for binary, names in steps:
            if not names:
                continue
            seconds = sum(self.seconds[name] for name in names)
            result = self.run(binary, number, names, seconds * TIME_FACTOR + TIME_MORE)
            if result != 0:
                return verdict_of(result)
        return "survived"

    def judge(self, mutant, behaviour_only=False):
        """`behaviour_only`: without the tests that include the changed header themselves."""
        without = set()
        if behaviour_only and mutant.path.suffix == ".h":
            for source in filter(is_test, self.sources()):
                if f'#include "{mutant.file}"' in source.read_text():
                    without |= self.tests_of.get(source.name, set())
        if mutant.id in self.in_schema:
            verdict = self.tests(self.binary, mutant.id, without)
            # Of a table an assertion may see what no test does.
            refused = verdict == "survived" and mutant.row and not self.compiles(mutant)
            return "does not compile" if refused else verdict
        return self.judge_alone(mutant, without)

    def compiles(self, mutant):
        """Whether the mutated file, as it is, is accepted by the compiler."""
        text = mutant.path.read_text()
        with tempfile.TemporaryDirectory(dir=self.out) as folder:
            tree = pathlib.Path(folder)
            (tree / "openevc").symlink_to(".")
            changed = tree / mutant.path.relative_to(self.src)
            write(changed, text[:mutant.start] + mutant.new + text[mutant.end:])
            command = self.plain.command(changed, [tree]) + ["-fsyntax-only", "-x", "c++", str(changed)]
            return subprocess.run(command, capture_output=True).returncode == 0

    def plain_objects(self):
        """Of the unchanged room; made when the first mutant has to be built alone."""
        with self.lock:
            if self.objects is None:
                self.plain.prepare_common()
                sources = self.sources()
                made = self.each(lambda s: self.plain.made(s, self.object_name(s)), sources)
                self.objects = {s: (o, includes(o)) for s, o in zip(sources, made)}
        return self.objects

    def judge_alone(self, mutant, without=frozenset()):
        """The mutated file lies in a folder of its own that is searched first. What includes it is compiled again:
        the room, then one source of tests after the other until a test fails. Tests that do not include it are one
        program, which runs first."""
        objects = self.plain_objects()
        original = mutant.path
        text = original.read_text()
        with tempfile.TemporaryDirectory(dir=self.out) as folder:
            tree = pathlib.Path(folder)
            (tree / "openevc").symlink_to(".")
            changed = tree / mutant.path.relative_to(self.src)
            write(changed, text[:mutant.start] + mutant.new + text[mutant.end:])

            def as_before(source):
                return source != original and original not in objects[source][1]

            def made(source):
                out = objects[source][0]
                if as_before(source):
                    return out
                out = tree / out.name
                failed = self.plain.compile(changed if source == original else source, out, [tree]).returncode
                return None if failed else out

            room = [made(s) for s in objects if not is_test(s)]
            if None in room:
                return "does not compile"
            named = re.compile(rf'#include "(openevc/)?{re.escape(str(original.relative_to(self.src)))}"')
            tests = [s for s in objects if is_test(s)]
            changed_tests = sorted((s for s in tests if not as_before(s)), key=lambda s: not named.search(s.read_text()))
            for sources in [[s for s in tests if as_before(s)], *([s] for s in changed_tests)]:
                names = set().union(*(self.tests_of.get(s.name, set()) for s in sources)) - without
                if not names:
                    continue
                made_tests = [made(s) for s in sources]
                binary = tree / "mutant_test"
                if None in made_tests or self.link(binary, [*room, *made_tests]):
                    return "does not compile"
                seconds = sum(self.seconds[name] for name in names)
                result = self.run(binary, 0, names if without else None, seconds * TIME_FACTOR + TIME_MORE)
                if result != 0:
                    return verdict_of(result)
        return "survived"
