"""What a mutant can change: the places are found in the text, line by line, as the house style writes it."""
import dataclasses
import fnmatch
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
SRC = ROOT / "src"
PUBLIC = ROOT / "include/openevc"  # public headers: PUBLIC/ROOM beside SRC/ROOM, one folder in a copy

SWAPS = {
    "compare": {"<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "=="},
    "logic": {"&&": "||", "||": "&&"},
    "sign": {"+": "-", "-": "+", "+=": "-=", "-=": "+="},
    "factor": {"*": "/", "/": "*"},
}
OPERATOR = {old: (name, new) for name, swaps in SWAPS.items() for old, new in swaps.items()}
TABLE = re.compile(r"constexpr (\w+) (k\w+)\[\] = \{(?= *$)", re.M)
TO_ARRAY = re.compile(r"\bto_array<.+>\(\{$")  # tables that look like a page of the standard
MARK = r"(?:[A-Z]{1,4}|-)(?:\[\d+\])*"  # a cell of such a page: D, NR, A[3][14]
LITERALS = r'"(?:\\.|[^"\\\n])*"|(?<![0-9a-fA-F])\'(?:\\.|[^\'\\\n])+\''
COMMENTS = r"//[^\n]*|/\*.*?\*/"


def without_comments(text):
    """The text with comments of the same length made blank."""
    blank = lambda m: m.group() if m.group()[0] in "\"'" else re.sub(r"[^\n]", " ", m.group())
    return re.sub(COMMENTS + "|" + LITERALS, blank, text, flags=re.S)


def masked(text):
    """The text with comments and literals of the same length made blank."""
    return re.sub(COMMENTS + "|" + LITERALS, lambda m: re.sub(r"[^\n]", " ", m.group()), text, flags=re.S)


def without_assertions(code):
    """The (masked) text with what static_assert checks made blank: a check, not what is checked."""
    for m in re.finditer(r"\bstatic_assert\(", code):
        end = closing(code, m.end() - 1)
        code = code[:m.end()] + re.sub(r"[^\n]", " ", code[m.end():end]) + code[end:]
    return code


def closing(text, at):
    """Where the bracket that opens at `at` is closed; -1: nowhere."""
    pairs = {"(": ")", "[": "]", "{": "}"}
    open_, close = text[at], pairs[text[at]]
    depth = 0
    for i in range(at, len(text)):
        depth += (text[i] == open_) - (text[i] == close)
        if depth == 0:
            return i
    return -1


@dataclasses.dataclass
class Mutant:
    path: pathlib.Path
    line: int
    start: int
    end: int
    new: str
    operator: str
    row: str  # "array" or "page": in a row of such a table; "" elsewhere
    what: str
    file: str  # room, folders in it and name: kernel/intake/routes.h
    id: int = 0

    @property
    def name(self):
        return f"include/openevc/{self.file}" if (PUBLIC / self.file).exists() else f"src/{self.file}"

    def key(self):
        return self.name + " " + self.operator + " " + self.what

    def __str__(self):
        return f"{self.name}:{self.line}: {self.operator}: {self.what}"


def described(text, start, end, new, operator):
    """What is changed, in words that stay when lines are added above."""
    old = text[start:end]
    if operator in ("row", "delete"):
        return re.sub(r"\s+", " ", f"`{old.strip()}` gone")
    first = text.rfind("\n", 0, start) + 1
    last = text.find("\n", end)
    line = text[first:last if last > 0 else len(text)].strip()
    same = text[first:start].count(old)
    return re.sub(r"\s+", " ", f"`{old}` -> `{new}` in `{line}`" + (f" ({same + 1})" if same else ""))


def enumerators(folders):
    """Enum name -> its values, of all headers in these folders. Of two with one name (modes of two editions of the SRS)
    only what both have: the text does not show which of them is meant."""
    found = {}
    for folder in folders:
        for header in folder.rglob("*.h"):
            for name, body in re.findall(r"enum class (\w+)[^{;]*\{([^}]*)\}", masked(header.read_text())):
                values = [v.split("=")[0].strip() for v in body.split(",")]
                values = [v for v in values if v and v != "count"]
                found[name] = [v for v in found.get(name, values) if v in values]
    return found


def changed_number(literal):
    if re.fullmatch(r"\d+[uU]?", literal):
        return re.sub(r"\d+", lambda m: str(int(m.group()) + 1), literal)
    value = float(literal)
    return "1.0" if value == 0.0 else repr(value * 1.1)


def named_alone(line, names, enums):
    """(start, end, replacement) of the enumerators of a row that are there without their enumeration (`using enum`)."""
    for m in re.finditer(r"(?<![\w.:])[A-Za-z_]\w*\b(?!\s*[:(])", line):
        for name in names:
            values = enums.get(name, [])
            if m.group() in values and len(values) > 1:
                yield m.start(), m.end(), values[(values.index(m.group()) + 1) % len(values)]
                break


def inside_line(line, enums):
    """(start, end, replacement, operator) of what one line of code holds."""
    for m in re.finditer(r"\b(\w+)::(\w+)\b", line):
        values = enums.get(m.group(1), [])
        if m.group(2) in values and len(values) > 1:
            yield m.start(2), m.end(2), values[(values.index(m.group(2)) + 1) % len(values)], "cell"
    for m in re.finditer(r"(?<= )(<=|>=|==|!=|<|>|&&|\|\||\+=|-=|[-+*/])(?= |$)", line):
        name, new = OPERATOR[m.group()]
        yield m.start(), m.end(), new, name
    for m in re.finditer(r"\bstd::(min|max)\(", line):
        yield m.start(1), m.end(1), {"min": "max", "max": "min"}[m.group(1)], "minmax"
    for m in re.finditer(r"\b(true|false)\b", line):
        yield m.start(), m.end(), {"true": "false", "false": "true"}[m.group()], "truth"
    for m in re.finditer(r"(?<![\w.])(\d+\.\d*(?:[eE][-+]?\d+)?|\d+[eE][-+]?\d+|\d+[uU]?)(?![\w.])", line):
        yield m.start(), m.end(), changed_number(m.group()), "number"


def words_of_rows(line):
    """(start, end, another word of the row) of every word of a row of text, "U  D  NR"."""
    for literal in re.finditer(r'"([^"\\]*)"', line):
        words = list(re.finditer(r"\S+", literal.group(1)))
        values = sorted({w.group() for w in words})
        if len(words) < 3 or len(values) < 2 or not all(re.fullmatch(MARK, v) for v in values):
            continue
        for w in words:
            new = values[(values.index(w.group()) + 1) % len(values)]
            yield literal.start(1) + w.start(), literal.start(1) + w.end(), new


def deleted_statement(line, previous):
    """Where in the line a statement stands whose loss leaves something that compiles: an assignment, a call, a
    jump; or one of them after `if (a)` or `else`. `previous`: how the code in front ends."""
    stripped = line.strip()
    if previous not in ";{}:)e" or not stripped.endswith(";") or stripped.count(";") != 1:
        return None
    if stripped.startswith("return") or line.count("(") != line.count(")"):
        return None
    begin = len(line) - len(line.lstrip())
    head = re.match(r"(?:else )?(?:if|for|while) \(", stripped)
    if head:
        end = closing(line, begin + head.end() - 1)
        return end + 2 if end > 0 and line[end + 1:].strip() not in ("", ";") else None
    if stripped.startswith("else "):
        return begin + 5
    acts = re.match(r"(?:\+\+|--)?\w[\w.:>\[\]-]*(?:\(| [-+*/|&]?= |;|\+\+|--)", stripped)
    return begin if acts else None


def places(text, enums):
    """(start, end, replacement, operator, the kind of table of its row) of every mutant of a file:
    "array", "page" (made at compile time, checked by assertions) or "" (none)."""
    code = without_assertions(masked(text))
    in_table = ""
    used = []  # enumerations whose values the table names alone
    previous = ";"
    start = 0
    for line in code.split("\n"):
        stripped = line.strip()
        if stripped.endswith("= [] {"):
            used = []
        elif m := re.match(r"using enum (?:\w+::)*(\w+);$", stripped):
            used.append(m.group(1))
        if TABLE.search(stripped):
            in_table, previous = "array", "{"
        elif TO_ARRAY.search(stripped):
            in_table, previous = "page", "{"
        elif in_table and stripped in ("};", "});"):
            in_table, previous = "", ";"
        elif stripped.startswith(("#", "EVC_REQUIRE", "static_assert", "template", "using", "namespace", "enum ")):
            previous = stripped[-1]
        elif stripped:
            row = in_table if in_table and stripped.startswith("{") else ""
            if row:
                yield start, start + len(line), "", "row", row
                for first, last, new in words_of_rows(text[start:start + len(line)]):
                    yield start + first, start + last, new, "word", row
                for first, last, new in named_alone(line, used, enums):
                    yield start + first, start + last, new, "cell", row
            for first, last, new, operator in inside_line(line, enums):
                yield start + first, start + last, new, operator, row
            for m in re.finditer(r"\b(?:if|while) \(", line):
                begin = start + m.end() - 1
                end = closing(code, begin)
                if end > 0 and ";" not in code[begin:end] and "const " not in code[begin:end]:
                    yield begin, end + 1, "(!" + text[begin:end + 1] + ")", "negate", ""
            statement = deleted_statement(line, previous)
            if statement is not None:
                yield start + statement, start + len(line), ";", "delete", ""
            previous = "e" if stripped.endswith("else") else stripped[-1]
        start += len(line) + 1


def mutants_of(path, enums, root=None):
    """`root`: the folder of the rooms; by default that of the room's folder."""
    text = path.read_text()
    file = str(path.relative_to(root or path.parent.parent))
    return [Mutant(path, text.count("\n", 0, start) + 1, start, end, new, operator, row,
                   described(text, start, end, new, operator), file)
            for start, end, new, operator, row in places(text, enums)]


def is_test(path):
    """Tests and the headers that are named as theirs."""
    return path.stem.endswith(("_test", "testing")) or path.stem.startswith("test_")


def mutants_of_room(folder, others):
    """All mutants of the room in `folder`, numbered from 1. Headers that only tests include are tests. `others`:
    the folders of the rooms that it uses."""
    name = folder.name
    included = set()
    for source in [*SRC.rglob("*"), *PUBLIC.rglob("*")]:
        if source.suffix in (".cpp", ".h") and not is_test(source):
            included.update(re.findall(rf'^#include "(?:openevc/)?{name}/([\w/]+\.h)"', source.read_text(), re.M))
    tests_only = {str(h.relative_to(folder)) for h in folder.rglob("*.h")} - included
    enums = enumerators([folder, *others])
    found = []
    for path in sorted(folder.rglob("*")):
        if path.suffix in (".cpp", ".h") and not is_test(path) and str(path.relative_to(folder)) not in tests_only:
            found += mutants_of(path, enums, folder.parent)
    for number, mutant in enumerate(found, 1):
        mutant.id = number
    return found


def lines_of_diff(diff):
    """{file: numbers of its new lines} of a `git diff -U0`."""
    lines, name = {}, None
    for line in diff.splitlines():
        if line.startswith("+++ "):
            name = line[6:] if line.startswith("+++ b/") else None
        elif name and (m := re.match(r"@@ -\S+ \+(\d+)(?:,(\d+))? @@", line)):
            first, number = int(m[1]), int(m[2] or 1)
            lines.setdefault(name, set()).update(range(first, first + number))
    return lines


def changed_lines(commit):
    """What differs in src between a commit and the files as they are now."""
    done = subprocess.run(["git", "diff", "-U0", commit, "--", "src"], cwd=ROOT, capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"mutate: git diff {commit}: {done.stderr.strip()}")
    return lines_of_diff(done.stdout)


def in_order(mutants, patterns):
    """Those whose file name matches one of the patterns, those of the first pattern first."""
    def rank(m):
        return next((i for i, p in enumerate(patterns) if fnmatch.fnmatch(m.path.name, p)), None)
    return sorted((m for m in mutants if rank(m) is not None), key=rank)
