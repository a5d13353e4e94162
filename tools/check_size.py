#!/usr/bin/env python3
"""Size of functions and files in the kernel rooms: no function over 60 lines or 25 branches, no file of src/kernel over
300 lines. Larger ones are in tools/sizes.txt with their current figure: it may fall (then the figure is updated, or
the line deleted), never rise. Tables are listed with the word `table`: they may grow by rows. A branch is an if, for,
while, case, ?, && or ||; lambdas count with the function around them.
Usage: tools/check_size.py [--root FOLDER] [--list]; prints FILE:LINE: reason, exit 1."""
import pathlib
import re

import check_layers
import command_line

ROOT = pathlib.Path(__file__).resolve().parent.parent
LINES, BRANCHES, FILE_LINES = 60, 25, 300
FILE_ROOM = "kernel"

BRANCH = re.compile(r"\b(?:if|for|while|case)\b|&&|\|\||\?")
# What is not code: comments, strings, characters; digit separators stay.
NOT_CODE = re.compile(r"//[^\n]*|/\*.*?\*/|\"(?:\\.|[^\"\\\n])*\"|(?<![0-9A-Za-z_])'(?:\\.|[^'\\\n])+'", re.S)
PREPROCESSOR = re.compile(r"^[ \t]*#(?:[^\n\\]|\\\n|\\.)*", re.M)
# The text between the last `;`, `{` or `}` and a `{` that opens the body of a function.
HEAD = re.compile(r"([\w:~]+|operator\s*\S+?|operator\s*\(\s*\))\s*\((?:[^()]|\((?:[^()]|\([^()]*\))*\))*\)"
                  r"\s*(?:const|noexcept|override|final|\s|&)*(?:->[\w:<>,\s*&]+)?(?::[^:].*)?$", re.S)
SCOPE = re.compile(r"^\s*(?:inline\s+)?(?:namespace|extern)\b|\b(?:class|struct|union|enum)\b[^()=]*$", re.S)
TEMPLATE = re.compile(r"\btemplate\s*<(?:[^<>]|<[^<>]*>)*>")
INITIALISER = re.compile(r"\)\s*(?:noexcept\s*)?:[^:].*\w\s*$", re.S)
CONTROL = {"if", "for", "while", "switch", "catch", "return", "sizeof", "alignas", "decltype", "requires"}


def code_only(text):
    """The text with comments, literals and preprocessor lines blanked, line breaks kept."""
    blank = lambda m: re.sub(r"[^\n]", " ", m[0])
    return PREPROCESSOR.sub(blank, NOT_CODE.sub(blank, text))


def functions(text):
    """(name, first line, lines, branches) of every function with a body, outermost only."""
    code = code_only(text)
    found = []
    stack = []  # of True where a scope of functions was opened
    mark = 0
    function = None
    for at, c in enumerate(code):
        if c == "{":
            head = TEMPLATE.sub(lambda m: " " * len(m[0]), code[mark:at])
            if function is None and INITIALISER.search(head):
                stack.append("member")  # b{1} of a constructor: its body comes later
                continue
            if function is None:
                match = HEAD.search(head)
                if match and match[1] not in CONTROL and not SCOPE.search(head[:match.start()] or " "):
                    start = mark + len(head) - len(head.lstrip())
                    function = (re.sub(r"\s+", "", match[1]), start, len(stack))
            stack.append(c)
            mark = at + 1
        elif c == "}":
            if stack and stack.pop() == "member":
                continue
            if function is not None and len(stack) == function[2]:
                name, start, _ = function
                body = code[start:at + 1]
                found.append((name, code.count("\n", 0, start) + 1, body.count("\n") + 1, len(BRANCH.findall(body))))
                function = None
            mark = at + 1
        elif c == ";":
            mark = at + 1
    return found


def measure(root):
    """{(kind, path, name): (figures, line)} of what is over the limits."""
    over = {}
    for room in check_layers.KERNEL_ROOMS + check_layers.PURE_ROOMS:
        folders = (root / "src" / room, root / "include/openevc" / room)
        for path in sorted(path for folder in folders for path in folder.rglob("*")):
            if path.suffix not in (".h", ".cpp") or check_layers.is_test(path):
                continue
            name = path.relative_to(root).as_posix()
            text = path.read_text(encoding="utf-8")
            if room == FILE_ROOM and text.count("\n") > FILE_LINES:
                over["file", name, "-"] = ((text.count("\n"), 0), 1)
            for function, line, lines, branches in functions(text):
                if lines > LINES or branches > BRANCHES:
                    key = ("function", name, function)
                    lines, branches = max((lines, branches), over.get(key, ((0, 0), 0))[0])
                    over[key] = ((lines, branches), line)
    return over


def allowed(root):
    """{(kind, path, name): (lines, branches, is a table)} of tools/sizes.txt."""
    rows = {}
    for line in (root / "tools/sizes.txt").read_text(encoding="utf-8").splitlines():
        words = line.split("#")[0].split()
        if words:
            kind, path, name, lines, branches = words[:5]
            rows[kind, path, name] = (int(lines), int(branches), words[5:] == ["table"])
    return rows


def check(root):
    """All breaches, as 'file:line: reason'."""
    over, rows = measure(root), allowed(root)
    breaches = []
    for key, ((lines, branches), at) in sorted(over.items()):
        what = f"{key[1]}:{at}: {key[2] if key[0] == 'function' else 'file'} has {lines} lines"
        what += f", {branches} branches" if key[0] == "function" else ""
        limit = f"{LINES} lines or {BRANCHES} branches" if key[0] == "function" else f"{FILE_LINES} lines"
        if key not in rows:
            breaches.append(f"{what}, expected at most {limit}")
        elif rows[key][2]:
            continue
        elif lines > rows[key][0] or branches > rows[key][1]:
            breaches.append(f"{what}, was {rows[key][0]}, {rows[key][1]}: it may shrink only")
        elif (lines, branches) != rows[key][:2]:
            breaches.append(f"{what}, tools/sizes.txt says {rows[key][0]}, {rows[key][1]}: write the smaller figure")
    for key in sorted(set(rows) - set(over)):
        breaches.append(f"tools/sizes.txt: {key[1]} {key[2]} is not over the limits: the line goes")
    return breaches


def main():
    parser = command_line.Parser(__doc__)
    parser.add_argument("--root", type=command_line.folder, default=ROOT)
    parser.add_argument("--list", action="store_true", help="print what is over the limits, as tools/sizes.txt has it")
    args = parser.parse_args()
    if args.list:
        for (kind, path, name), ((lines, branches), _) in sorted(measure(args.root).items()):
            print(kind, path, name, lines, branches)
        return 0
    breaches = check(args.root)
    for breach in breaches:
        print(breach)
    print(f"size: {len(allowed(args.root))} larger than the rule, {len(breaches)} breaches")
    return 1 if breaches else 0


if __name__ == "__main__":
    command_line.run(main)
