#!/usr/bin/env python3
"""The register of requirements (requirements/README.md) against the tree, without a build.

Usage: tools/check_requirements.py [--write | --fix-places | --add-scenarios | --missing] [--root ROOT]
  (nothing)      every fault of the register, one per line; exit 1 if there is one
  --write        docs/requirements/, include/openevc/terms/clauses.inc and requirements/without_row.txt, generated again
  --fix-places   updates the places of functions that moved to another file
  --add-scenarios  adds to the rows `done` and `part` exactly the scenarios that name their clause
  --missing      the on-board clauses of SUBSET-026-9 without a row, one a line
"""
import collections
import csv
import fnmatch
import io
import pathlib
import re

import command_line

COLUMNS = ["clause", "requirement", "status", "method", "where", "test", "note"]
STATUSES = ["done", "part", "wrong", "missing", "4.0.0 only", "deliberately otherwise", "not applicable"]
UNDONE = ("missing", "4.0.0 only", "not applicable")
METHODS = ["test", "inspection", "analysis"]
CLAUSES, SEEDS = "requirements/clauses.csv", "requirements/seeds.csv"
CHAPTER_9, WITHOUT_ROW = "requirements/chapter_9.csv", "requirements/without_row.txt"
HEADER, PAGES = "include/openevc/terms/clauses.inc", "docs/requirements"
EDITION = "include/openevc/terms/edition_gap.h"
# A place "train/train_data.h" is a file of the room train in one of these.
ROOTS = ("src", "include/openevc")
FILES_WITHOUT_NAME = ("docs/", "tools/", "bench/", "CAVEATS.md", "README.md")

NUMBER = r"(?:A(?:\.\d+)+|[3-8](?:\.\d+)+)"
# A row of the table in EDITION.
GAP = re.compile(rf'\{{EditionGap::\w+, "({NUMBER})"_srs,')
# Numbers of an issue look like clauses; they are none.
ISSUES = re.compile(r"(?:3\.[0-69]|4\.0)\.0|[34]\.[0-9]")
# Clauses of another document than SUBSET-026: the coding of telegrams (SUBSET-036), the display (ERA_ERTMS_015560).
OTHER_ROOMS = ("airgap", "dmi", "paint", "screen", "ride", "cab")
OTHER_DOCUMENT = re.compile(r"(?:SUBSET-0(?!26)\d\d|015560).*")
# The language names the page of each variable, packet and message, of the trackside's older ones too: data, tested as such.
LANGUAGE, PAGES_OF_LANGUAGE = "lang", ("6.5.", "7.", "8.")
# A clause in a text of the program: a whole literal, perhaps with the bullet or exception behind it.
LITERAL = re.compile(rf'"({NUMBER})(?: ?[a-z]\)?| \[\d+\])?(?:: [^"]*)?"')
# A clause in a comment has three parts or more: 3.6 may be anything.
COMMENT = re.compile(r"(?<![\w.,/-])((?:A|[3-8])(?:\.\d+){2,})(?![\w]|\.\d)")
TEST = re.compile(r"^[ \t]*(?:TYPED_)?TEST(?:_F|_P)?\(\s*(\w+),\s*(\w+)\s*\)", re.M)
# A text scenario: its name, "open" where it is expected to fail, and the clauses of what it expects: "then ... [3.8.5.2]".
SCENARIO = re.compile(r"^scenario[ \t]+(.+?)[ \t]*$")
OPEN = re.compile(r"^[ \t]+open\b")
EXPECTED = re.compile(rf"\[({NUMBER})(?: [a-z])?(?:\((\d+)\))?\][ \t]*$")
# "(3.x 3.6.4.3)" in a row is the number that the paragraph has in issues 3.4.0 and 3.6.0.
ROW_NUMBERS = re.compile(rf"(?:^|, |\(3\.x )({NUMBER})")


def order(number):
    """Sorts 3.4.10 behind 3.4.9, the annexes of a chapter behind the chapter."""
    parts = number.split(".")
    if parts[0] == "A":
        parts = [parts[1], "99999", *parts[2:]]
    return [int(p) for p in parts]


def ancestors(number):
    """3.4.1.2 -> 3.4.1, 3.4."""
    parts = number.split(".")
    return [".".join(parts[:n]) for n in range(len(parts) - 1, 1, -1)]


def numbers_of(clause):
    """The clauses that a row is about: "5.7.4.1, 5.7.4.2", "4.6.3 [12]", "7.4.3.1 packet 0"."""
    return ROW_NUMBERS.findall(clause)


class Scenario:
    def __init__(self, file, name, title):
        self.file, self.name, self.title, self.open, self.clauses = file, name, title, False, []


class Tree:
    """What the register is compared with: sources, tests, scenarios, gates."""

    def __init__(self, root):
        self.root = pathlib.Path(root)
        self.sources, self.tests, self.scenarios = {}, set(), []
        self.path = {}
        for root in ROOTS:
            self.read_sources(root)
        for path in sorted((self.root / "tests").rglob("*_test.cpp")):
            self.tests |= self.tests_of(path.read_text(encoding="utf-8"))
        for path in sorted((self.root / "tests").rglob("*.scenario")):
            if "corpus" not in path.parts:
                self.read_scenarios(path)
        ci = self.root / ".ci" / "run"
        self.gates = set(re.findall(r"^(?:\S+=\S+ )*(?:gate|beside) (\w[\w-]*)", ci.read_text(), re.M)) if ci.exists() else set()
        self.words = {name: set(re.findall(r"[A-Za-z_]\w*", text)) for name, text in self.sources.items()}
        self.by_name = collections.defaultdict(list)
        for name in self.sources:
            self.by_name[(name.split("/")[0], name.rsplit("/", 1)[-1])].append(name)

    def read_sources(self, root):
        folder = self.root / root
        for path in sorted(p for p in folder.rglob("*") if p.suffix in (".h", ".cpp")):
            name = str(path.relative_to(folder))
            text = path.read_text(encoding="utf-8")
            if path.name.endswith("_test.cpp"):
                self.tests |= self.tests_of(text)
            elif not path.name.startswith("test_"):
                self.sources[name] = text
                self.path[name] = f"{root}/{name}"

    def read_scenarios(self, path):
        file = str(path.relative_to(self.root))
        self.scenarios.append(Scenario(file, "", ""))  # what stands ahead of the first: blocks that others use
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            if found := SCENARIO.match(line):
                self.scenarios.append(Scenario(file, path.stem + "." + re.sub(r"\W+", "_", found[1]), found[1]))
            elif OPEN.match(line):
                self.scenarios[-1].open = True
            elif found := EXPECTED.search(line):
                self.scenarios[-1].clauses.append((number, found[1], found[2]))

    @staticmethod
    def tests_of(text):
        return {f"{suite}.{name}" for suite, name in TEST.findall(text)
                if not suite.startswith("DISABLED_") and not name.startswith("DISABLED_")}

    def has_test(self, pattern):
        kind, colon, rest = pattern.partition(":")
        if not colon:
            return any(fnmatch.fnmatchcase(t, pattern) for t in self.tests)
        if kind == "gate":
            return rest in self.gates
        if kind == "scenario":
            wanted = re.sub(r"[^\w.*?]+", "_", rest)
            return any(fnmatch.fnmatchcase(s.name, wanted) or fnmatch.fnmatchcase(s.name.split(".", 1)[1], wanted)
                       for s in self.scenarios if s.name and not s.open)
        return False

    def files(self, path):
        """The source files meant by "kernel/orders.cpp": that one, or any of that name in the room."""
        if path in self.sources:
            return [path]
        return self.by_name.get((path.split("/")[0], path.rsplit("/", 1)[-1]), [])

    def names_in(self, file, name):
        return all(part in self.words[file] for part in name.split("."))

    def defines(self, file, name):
        """Whether the last part of the name is defined there, not only used."""
        last = re.escape(name.split(".")[-1])
        return re.search(rf"(?:struct|class|enum class|constexpr[^;\n]*?|inline[^;\n]*?)\s{last}\b|"
                         rf"^(?!\s*(?:return|case|if|for|while)\b)[\w:<>,&*\[\] ]*\b{last}\([^;{{}}]*\)[^;{{}}]*\{{",
                         self.sources[file], re.M) is not None

    def find(self, name, room, file):
        """Where a name went, the likeliest first: where it is defined, in its room, in a file of that name. A use in
        another room is no place for it."""
        scope = name.split(".")[0]
        found = [f for f in self.sources if self.names_in(f, name)]
        defined = {f for f in found if self.defines(f, scope if scope != name else name)}
        found = [f for f in found if f in defined or f.split("/")[0] == room]
        return sorted(found, key=lambda f: (f not in defined, f.split("/")[0] != room,
                                            f.rsplit("/", 1)[-1] != file, not f.endswith(".cpp"), f))


def split_places(where):
    """"a/b.cpp:f, g; docs/c.md" -> [("a/b.cpp", ["f", "g"]), ("docs/c.md", [])]."""
    if where == "-":
        return []
    places = []
    for item in where.split("; "):
        path, _, names = item.partition(":")
        places.append((path, names.split(", ") if names else []))
    return places


def join_places(places):
    return "; ".join(path + (":" + ", ".join(names) if names else "") for path, names in places) or "-"


def read(root, name):
    path = pathlib.Path(root) / name
    with path.open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    if rows and list(rows[0]) != COLUMNS:
        raise SystemExit(f"{name}: columns are {','.join(map(str, rows[0]))}, expected {','.join(COLUMNS)}")
    return rows


def written(rows):
    out = io.StringIO()
    writer = csv.DictWriter(out, COLUMNS, lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    return out.getvalue()


def place_faults(tree, row):
    faults = []
    for path, names in split_places(row["where"]):
        if path.startswith(FILES_WITHOUT_NAME):
            if not (tree.root / path).exists():
                faults.append(f"{path} does not exist")
            continue
        if path.endswith("/"):
            if not any((tree.root / root / path).is_dir() for root in ROOTS):
                faults.append(f"no folder {path} in {' or '.join(ROOTS)}")
            continue
        files = tree.files(path)
        if not files:
            faults.append(f"no file {path} in the room {path.split('/')[0]}")
        for name in names if files else []:
            if not any(tree.names_in(f, name) for f in files):
                where = tree.find(name, path.split("/")[0], path.rsplit("/", 1)[-1])
                faults.append(f"no {name} in {path}" + (f" (it is in {where[0]}: --fix-places)" if where else ""))
    return faults


def row_faults(tree, row):
    faults = []
    for column in ("clause", "requirement", "where", "test"):
        if not row[column]:
            faults.append(f"no {column}")
    if row["status"] not in STATUSES:
        faults.append(f"status '{row['status']}', expected one of: {', '.join(STATUSES)}")
    if row["method"] not in METHODS:
        faults.append(f"method '{row['method']}', expected one of: {', '.join(METHODS)}")
    tests = [] if row["test"] == "-" else row["test"].split("; ")
    faults += [f"no test {t}" for t in tests if not tree.has_test(t)]
    faults += place_faults(tree, row)
    if row["method"] == "test" and not tests:
        faults.append("method test, and no test is named")
    if row["status"] == "done" and row["method"] == "inspection":
        if not any(names or path.startswith(FILES_WITHOUT_NAME) for path, names in split_places(row["where"])):
            faults.append("done by inspection, and nothing is named that was inspected (file:function)")
        if not row["note"]:
            faults.append("done by inspection, and the note does not say what was found")
    if row["status"] in ("part", "wrong") and not row["note"]:
        faults.append(f"{row['status']}, and the note does not say what lacks")
    return faults


def check_rows(tree, name, rows):
    faults, seen = [], set()
    for number, row in enumerate(rows, 2):
        where = f"{name}:{number}: {row['clause']}"
        if None in row or None in row.values():
            faults.append(f"{where}: not {len(COLUMNS)} columns")
            continue
        if row["clause"] in seen:
            faults.append(f"{where}: stands twice")
        seen.add(row["clause"])
        if name == CLAUSES and not numbers_of(row["clause"]):
            faults.append(f"{where}: no number of a clause")
        faults += [f"{where}: {f}" for f in row_faults(tree, row)]
    return faults


class Register:
    """The numbers that have a row, and the sections above them."""

    def __init__(self, rows):
        self.rows = collections.defaultdict(list)
        for row in rows:
            for n in numbers_of(row["clause"]):
                self.rows[n].append(row)
        self.known = set(self.rows) | {a for n in self.rows for a in ancestors(n)}
        # Of a section that is missing as a whole nothing below it has to be said.
        self.undone = {n for row in rows for n in numbers_of(row["clause"])
                       if row["status"] in UNDONE and ", ".join(numbers_of(row["clause"])) == row["clause"]}

    def status(self, number):
        """Of a clause with all its rows, or of the section that is missing as a whole; None without a row."""
        rows = self.rows.get(number) or [row for a in ancestors(number) if a in self.undone for row in self.rows[a]]
        if not rows:
            return None
        found = {row["status"] for row in rows} - {"not applicable"} or {"not applicable"}
        if "wrong" in found or len(found) == 1:
            return "wrong" if "wrong" in found else found.pop()
        return "part"

    def all_done(self, number, condition=None):
        """Of a clause with the paragraphs below it, or of one condition of it: "4.6.3 [12]"."""
        rows = [row for n, rows in self.rows.items() if n == number or n.startswith(number + ".") for row in rows
                if condition is None or f"[{condition}]" in row["clause"]]
        return bool(rows) and all(row["status"] == "done" for row in rows)

    def has(self, number):
        """Itself or a section with rows, or a paragraph of a clause that has one."""
        return number in self.known or any(a in self.rows for a in ancestors(number))


def clauses_in(text):
    """(line, number, whether it is a literal) of each clause that a source names."""
    for number, line in enumerate(text.splitlines(), 1):
        line = OTHER_DOCUMENT.sub("", line)
        literals = set(LITERAL.findall(line))
        for clause in literals:
            if not ISSUES.fullmatch(clause):
                yield number, clause, True
        for clause in set(COMMENT.findall(line)) - literals:
            if not ISSUES.fullmatch(clause):
                yield number, clause, False


def check_sources(tree, register):
    faults = []
    for name, text in tree.sources.items():
        if name.split("/")[0] in OTHER_ROOMS:
            continue
        for line, clause, literal in clauses_in(text):
            if name.split("/")[0] == LANGUAGE and clause.startswith(PAGES_OF_LANGUAGE):
                continue
            if literal and clause not in register.known:
                faults.append(f"{tree.path[name]}:{line}: \"{clause}\" has no row in {CLAUSES}")
            elif not register.has(clause):
                faults.append(f"{tree.path[name]}:{line}: {clause} has no row in {CLAUSES}, and no clause above it has")
    return faults


def check_caveats(root, rows):
    """CAVEATS.md names each clause that is not done, done in part, or done otherwise."""
    named = set(re.findall(NUMBER, (pathlib.Path(root) / "CAVEATS.md").read_text()))
    return [f"{CLAUSES}: {row['clause']} is {row['status']}, and CAVEATS.md does not name it" for row in rows
            if row["status"] in ("part", "missing", "4.0.0 only", "deliberately otherwise") and not named & set(numbers_of(row["clause"]))]


def lacks_in_4_0_0(row):
    """A row that the event of 4.0.0 at power-up has to name: not done there, or otherwise than 4.0.0 says."""
    return row["status"] == "4.0.0 only" or (row["status"] == "deliberately otherwise" and
                                             "4.0.0" in row["clause"] + row["requirement"] + row["note"])


def check_edition(root, rows):
    """The events at power-up name what 4.0.0 has and the unit has not: neither more nor less than the register."""
    path = pathlib.Path(root) / EDITION
    named = GAP.findall(path.read_text(encoding="utf-8")) if path.exists() else []
    lacking = {n for row in rows if lacks_in_4_0_0(row) for n in numbers_of(row["clause"])}
    faults = [f"{EDITION}: {n} stands twice" for n in sorted(set(named), key=order) if named.count(n) > 1]
    faults += [f"{EDITION}: {n} is not there, and {CLAUSES} says that 4.0.0 has it and the unit has not"
               for n in sorted(lacking - set(named), key=order)]
    return faults + [f"{EDITION}: {n} is there, and {CLAUSES} does not say that 4.0.0 has it and the unit has not"
                     for n in sorted(set(named) - lacking, key=order)]


def check_scenarios(tree, register):
    """Of a scenario that is expected to fail some clause is not called done in the register."""
    faults = []
    for scenario in tree.scenarios:
        named = {number: line for line, number, _ in reversed(scenario.clauses)}
        done = [register.all_done(number, condition) for _, number, condition in scenario.clauses]
        if scenario.open and named and all(done):
            faults.append(f"{scenario.file}:{min(named.values())}: \"{scenario.title}\" is open, and {CLAUSES} says done of "
                          + ", ".join(sorted(named, key=order)))
    return faults


def chapter_9(root):
    lines = (pathlib.Path(root) / CHAPTER_9).read_text(encoding="utf-8").splitlines()[1:]
    return [line.split(",")[0] for line in lines]


def without_row(root, register):
    return [c for c in chapter_9(root) if register.status(c) is None]


def header(register):
    """Sorted as text, for a binary search."""
    lines = ["// Made by tools/check_requirements.py --write from requirements/clauses.csv: the clauses that have a row, and",
             "// the sections above them, in the order of the characters."]
    lines += [f'"{n}",' for n in sorted(register.known)]
    return "\n".join(lines) + "\n"


TITLES = {
    "3.4": "Balise groups and linking", "3.5": "Radio communication", "3.6": "Location, position, reports",
    "3.7": "Completeness of data", "3.8": "Movement authority", "3.9": "Infill", "3.10": "Emergency messages",
    "3.11": "Speed restrictions and gradients", "3.12": "Other profiles", "3.13": "Speed and distance monitoring",
    "3.14": "Brakes and undesirable movement", "3.15": "Special functions", "3.16": "Data consistency",
    "3.17": "System versions", "3.18": "System data", "3.20": "Juridical data", "A.3": "Appendix to chapter 3",
    "4": "Modes and transitions", "5": "Procedures", "6": "Older system versions", "7": "ETCS language",
    "8": "Messages",
}


def page_of(number):
    parts = number.split(".")
    return ".".join(parts[:2]) if parts[0] in ("3", "A") else parts[0]


def file_of(page):
    return "clauses_" + page.replace(".", "_") + ".md"


def cell(text):
    text = text.replace("|", "\\|").replace("<", "&lt;").replace("*", "\\*").replace("_", "\\_")
    return text.replace("[", "\\[").replace("]", "\\]")


def table(rows):
    lines = ["| clause | requirement | status | shown by | where | note |", "|---|---|---|---|---|---|"]
    for row in rows:
        shown = row["test"] if row["method"] == "test" else row["method"]
        lines.append("| " + " | ".join(cell(x if x != "-" else "") for x in
                     (row["clause"], row["requirement"], row["status"], shown, row["where"], row["note"])) + " |")
    return lines


def pages(root, clauses, seeds):
    """Name and text of each page of docs/requirements/."""
    register = Register(clauses)
    missing = without_row(root, register)
    on_board = chapter_9(root)
    chapters = collections.defaultdict(list)
    for row in clauses:
        chapters[page_of(numbers_of(row["clause"])[0])].append(row)
    by_page = collections.defaultdict(list)
    for clause in missing:
        by_page[page_of(clause)].append(clause)
    of_clause = {clause: register.status(clause) for clause in on_board}
    statuses = [s for s in STATUSES if s in of_clause.values()]
    out = {}
    lines = ["# Requirements", "",
             "Made by `tools/check_requirements.py --write` from [the register](../../requirements/README.md), which explains",
             "the columns. The counts are of the clauses that chapter 9 of SUBSET-026 4.0.0 classifies as requirements on the",
             "on-board, each with all of its rows: `part` where they differ, `wrong` where one is. The unit implements 3.6.0; clauses",
             "that 4.0.0 added and that are not done are marked `4.0.0 only`.", "",
             "| page | on-board clauses | " + " | ".join(statuses) + " | without a row | rows |",
             "|---|--:|" + "--:|" * len(statuses) + "--:|--:|"]

    def line(title, clauses_of_page, rows):
        count = collections.Counter(of_clause[c] for c in clauses_of_page)
        cells = [str(count[s] or "") for s in [*statuses, None]]
        lines.append(f"| {title} | {len(clauses_of_page)} | " + " | ".join(cells) + f" | {rows} |")

    for page in sorted(set(chapters) | set(by_page), key=lambda p: order(p + ".0")):
        title = TITLES.get(page, "")
        rows = chapters[page]
        line(f"[{page} {title}]({file_of(page)})", [c for c in on_board if page_of(c) == page], len(rows))
        text = [f"# {page} {title}", "", "Made by `tools/check_requirements.py --write`; [overview](README.md).", ""]
        text += table(rows)
        if by_page[page]:
            text += ["", "## On-board clauses without a row", "", ", ".join(by_page[page])]
        out[file_of(page)] = "\n".join(text) + "\n"
    line("all", on_board, len(clauses))
    lines += ["", f"[Requirements of the design memo and of the interface document](seeds.md): {len(seeds)} rows.", "",
              "[What each gate shows](../evidence.md)"]
    out["README.md"] = "\n".join(lines) + "\n"
    out["seeds.md"] = "\n".join(["# Requirements of the design memo and of the interface document", "",
                                 "Made by `tools/check_requirements.py --write`; [overview](README.md).", "", *table(seeds)]) + "\n"
    return out


def generated(root, clauses, seeds):
    """Every file that --write makes."""
    register = Register(clauses)
    files = {f"{PAGES}/{name}": text for name, text in pages(root, clauses, seeds).items()}
    files[HEADER] = header(register)
    return files


def committed_without_row(root):
    path = pathlib.Path(root) / WITHOUT_ROW
    return int(path.read_text(encoding="utf-8").split()[0]) if path.exists() else None


def check(root):
    tree = Tree(root)
    clauses, seeds = read(root, CLAUSES), read(root, SEEDS)
    register = Register(clauses)
    faults = check_rows(tree, CLAUSES, clauses) + check_rows(tree, SEEDS, seeds)
    faults += check_sources(tree, register)
    faults += check_scenarios(tree, register)
    faults += check_caveats(root, clauses)
    faults += check_edition(root, clauses)
    missing = without_row(root, register)
    limit = committed_without_row(root)
    if limit is None or len(missing) > limit:
        faults.append(f"{WITHOUT_ROW}: {len(missing)} on-board clauses without a row, {limit} before; the number can only fall")
    elif len(missing) < limit:
        faults.append(f"{WITHOUT_ROW}: {limit}, but only {len(missing)} on-board clauses are without a row: --write")
    files = generated(root, clauses, seeds)
    for name, text in files.items():
        path = pathlib.Path(root) / name
        if not path.exists() or path.read_text(encoding="utf-8") != text:
            faults.append(f"{name}: not up to date: tools/check_requirements.py --write")
    for path in sorted((pathlib.Path(root) / PAGES).glob("*.md")):
        if f"{PAGES}/{path.name}" not in files:
            faults.append(f"{PAGES}/{path.name}: belongs to no chapter: delete it")
    return faults, clauses, seeds, missing


def fix_places(root):
    tree = Tree(root)
    for name in (CLAUSES, SEEDS):
        rows, moved = read(root, name), 0
        for row in rows:
            places = []
            for path, names in split_places(row["where"]):
                files = tree.files(path)
                outside = path.startswith(FILES_WITHOUT_NAME) or path.endswith("/")
                if outside or (files and all(any(tree.names_in(f, n) for f in files) for n in names)):
                    places.append((path, names))
                    continue
                room, file = path.split("/")[0], path.rsplit("/", 1)[-1]
                stay = [n for n in names if any(tree.names_in(f, n) for f in files)]
                if stay:
                    places.append((path, stay))
                for n in names:
                    found = [] if n in stay else tree.find(n, room, file)
                    if found:
                        places.append((found[0], [n]))
                        moved += 1
                    elif n not in stay:
                        print(f"{name}: {row['clause']}: {n} is nowhere; it was in {path}")
                        places.append((path, [n]))
                if not names:
                    same = [f for f in tree.sources if f.rsplit("/", 1)[-1] == file]
                    if len(same) == 1:
                        places.append((same[0], []))
                        moved += 1
                    else:
                        print(f"{name}: {row['clause']}: no file {path}" + (f"; {' or '.join(same)}?" if same else ""))
                        places.append((path, []))
            row["where"] = join_places(list(dict((p, (p, n)) for p, n in merged(places)).values()))
        (pathlib.Path(root) / name).write_text(written(rows), encoding="utf-8")
        print(f"{name}: {moved} places followed what moved")


def add_scenarios(root):
    """What a scenario expects "[4.6.3(12)]" is shown of the row "4.6.3 [12]". An open scenario shows nothing."""
    tree, rows, added = Tree(root), read(root, CLAUSES), 0
    shown = collections.defaultdict(list)
    for scenario in tree.scenarios:
        for _, number, condition in scenario.clauses if scenario.name and not scenario.open else []:
            shown[number + (f" [{condition}]" if condition else "")].append("scenario:" + scenario.name)
    for row in rows:
        found = sorted(set(shown[row["clause"]])) if row["status"] in ("done", "part") else []
        tests = [t for t in row["test"].split("; ") if t != "-" and not t.startswith("scenario:")] + found
        added += len(found)
        if tests and row["status"] == "done":
            row["method"] = "test"
        row["test"] = "; ".join(tests) or "-"
    (pathlib.Path(root) / CLAUSES).write_text(written(rows), encoding="utf-8")
    print(f"{CLAUSES}: {added} scenarios added to rows")


def merged(places):
    """One entry a file, names in the order of the row."""
    out = {}
    for path, names in places:
        have = out.setdefault(path, [])
        have += [n for n in names if n not in have]
    return list(out.items())


def write(root):
    clauses, seeds = read(root, CLAUSES), read(root, SEEDS)
    missing = len(without_row(root, Register(clauses)))
    limit = committed_without_row(root)
    if limit is not None and missing > limit:
        print(f"{WITHOUT_ROW}: {missing} on-board clauses without a row, {limit} before; the number can only fall")
        return 1
    (pathlib.Path(root) / WITHOUT_ROW).write_text(f"{missing}\n", encoding="utf-8")
    for name, text in generated(root, clauses, seeds).items():
        path = pathlib.Path(root) / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return 0


def main():
    parser = command_line.Parser(__doc__.splitlines()[0])
    parser.add_argument("--root", type=command_line.folder, default=pathlib.Path(__file__).resolve().parent.parent)
    what = parser.add_mutually_exclusive_group()
    what.add_argument("--write", action="store_true")
    what.add_argument("--fix-places", action="store_true")
    what.add_argument("--add-scenarios", action="store_true")
    what.add_argument("--missing", action="store_true")
    args = parser.parse_args()
    if args.write:
        return write(args.root)
    if args.fix_places:
        return fix_places(args.root)
    if args.add_scenarios:
        return add_scenarios(args.root)
    if args.missing:
        print("\n".join(without_row(args.root, Register(read(args.root, CLAUSES)))))
        return 0
    faults, clauses, seeds, missing = check(args.root)
    for fault in faults:
        print(fault)
    count = collections.Counter(r["status"] for r in clauses)
    print("missing (without a row): " + ", ".join(missing))
    print(f"requirements: {len(clauses)} clauses ({', '.join(f'{count[s]} {s}' for s in STATUSES if count[s])}), "
          f"{len(seeds)} of the design documents, {len(missing)} on-board clauses without a row, {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    command_line.run(main)
