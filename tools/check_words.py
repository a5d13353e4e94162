#!/usr/bin/env python3
"""Phrases not allowed in pages, comments and messages: plain technical English, one name for one thing
(docs/glossary.md). Checked are the files that git tracks: in pages the text outside of examples, in C++ and Python the
comments and strings, in scripts and CMake the comments. Usage: tools/check_words.py [ROOT]"""
import io
import pathlib
import re
import subprocess
import tokenize

import command_line

# Pattern and replacement. Every row is a phrase that readers did not understand at once.
PHRASES = [
    (r"\b(?:tells?|told|telling)\b", "log, return, show, report, give; tell apart: distinguish"),
    (r"\b(?:that|which|who) (?:is|are) none\b", "say what it is not, or leave it out"),
    (r"\bis no use\b|\bof no use\b|\bno matter (?:to|for)\b", "not used, not valid, does not depend on"),
    (r"\bha(?:s|ve) not (?:its|their|his|a|an|the)\b", "does not have"),
    (r"\bnever heard of\b", "unknown"),
    (r"\bgoes (?:behind|first|when|with (?:its|the)|too)\b", "is queued, deleted, released"),
    (r"\b(?:is|are|was|were) gone\b", "is deleted, has ended, does not exist any more"),
    (r"(?:^|[.;:] )What of\b", "name the things"),
    (r"\bpassed over\b", "ignored"),
    (r"\bhand(?:s|ed)? on\b", "returns, passes"),
    (r"\bheld against\b", "compared with"),
    (r"\bgo(?:es)? (?:to|into) (?:standard|the file)\b", "is written to"),
    (r"\bgo(?:es)? wrong\b|\bwent wrong\b", "fails, has errors"),
    (r"\bsends? nonsense\b|\bsent nonsense\b", "wrong input"),
    (r"\bwent in(?: |\.|$)", "was added"),
    (r"\bmended\b", "corrected, fixed"),
    (r"\b(?:says|spoke|speaks) so in its\b", "reports it"),
    (r"\bat the least\b", "at least, minimum"),
    (r"\btakes it that\b|\btaking it that\b", "assumes"),
    (r"\bby lot\b", "at random"),
    (r"\bhas the word\b", "decides"),
    (r"\b(?:stands?|stood) (?:in|beside|behind|there|above|before|under|after|between)\b|\bas (?:it|they) stands?\b",
     "is in, is next to, follows; unchanged, as in"),
    (r"\bknows? (?:no|nothing|of|neither)\b", "has no, is independent of"),
    (r"\bat the most\b", "at most"),
    (r"\bfor want of\b", "because there is no"),
    (r"\bin the place of\b", "instead of"),
    (r"\bfound out\b", "determined, deduced"),
    (r"\bin our (?:own )?words\b", "reworded, a short description"),
    (r"\bleads? somewhere\b", "has a target"),
    (r"\bmonotonous\b", "monotonic"),
    (r"\bhand(?:s|ed)? (?:over|out)\b", "passes, returns"),
    (r"\bof ours\b|\bof yours\b", "name the owner"),
    (r"\bput right\b|\bmakes? (?:it|that) good\b", "corrected, resolved"),
    (r"(?:^|[.;:#/*\"] ?)Whatever\b", "any"),
    (r"\bworked out\b", "computed"),
    (r"\bno business\b", "not used, not the task"),
    (r"\bonce more\b", "again"),
    (r"\btruly\b", "true, really"),
]
COMPILED = [(re.compile(pattern, re.IGNORECASE), instead) for pattern, instead in PHRASES]
C_LIKE = {".h", ".cpp", ".c", ".js", ".css"}
HASHED = {".cmake", ".txt", ".sh", ""}
# The list itself and its test, and pages with texts of others.
LEFT_OUT = ("tools/check_words.py", "tests/tools/check_words_test.py", "docs/packets/", "LICENSE")
C_TOKENS = re.compile(r"//[^\n]*|/\*.*?\*/|R\"(?P<mark>\w*)\(.*?\)(?P=mark)\"|\"(?:\\.|[^\"\\\n])*\"|'(?:\\.|[^'\\\n])+'", re.S)


def text_of_page(text):
    """Lines with examples and code spans blanked."""
    lines, inside = [], False
    for line in text.splitlines():
        if line.lstrip().startswith("```"):
            inside = not inside
            lines.append("")
        else:
            lines.append("" if inside or line.startswith("    ") else re.sub(r"`[^`]*`", "`x`", line))
    return lines


def spread(pieces, count):
    """`(line, text)` pieces laid into `count` lines."""
    lines = [""] * count
    for first, text in pieces:
        for i, part in enumerate(text.splitlines()):
            lines[first + i] += " " + part
    return lines


def text_of_c(text):
    pieces = [(text.count("\n", 0, m.start()), m.group()) for m in C_TOKENS.finditer(text) if not m.group().startswith("'")]
    return spread(pieces, text.count("\n") + 1)


def text_of_python(text):
    pieces = []
    try:
        for token in tokenize.generate_tokens(io.StringIO(text).readline):
            if token.type in (tokenize.COMMENT, tokenize.STRING) or tokenize.tok_name[token.type].startswith("FSTRING"):
                pieces.append((token.start[0] - 1, token.string))
    except (tokenize.TokenError, IndentationError, SyntaxError):
        return text.splitlines()
    return spread(pieces, text.count("\n") + 2)


def text_of_hashed(text):
    return [m.group() if (m := re.search(r"(?:^|\s)#.*", line)) else "" for line in text.splitlines()]


def words_of(name, text):
    """The lines of a file with what people read in them; None for a file without such text."""
    suffix = pathlib.PurePath(name).suffix
    if suffix == ".md":
        return text_of_page(text)
    if suffix in C_LIKE:
        return text_of_c(text)
    if suffix == ".py" or text.startswith("#!/usr/bin/env python"):
        return text_of_python(text)
    if suffix == ".html":
        return text.splitlines()
    if suffix in HASHED:
        return text_of_hashed(text)
    return None


def faults_in(name, text):
    lines = words_of(name, text)
    found = []
    for number, line in enumerate(lines or [], 1):
        for pattern, instead in COMPILED:
            match = pattern.search(line)
            if match:
                found.append(f'{name}:{number}: "{match.group().strip()}": {instead}')
    return found


def check(root):
    root = pathlib.Path(root).resolve()
    names = subprocess.run(["git", "-C", root, "ls-files", "-z"], capture_output=True, text=True, check=True).stdout
    faults, looked_at = [], 0
    for name in filter(None, names.split("\0")):
        path = root / name
        if name.startswith(LEFT_OUT) or not path.is_file():
            continue
        try:
            text = path.read_text(encoding="utf-8")
        except UnicodeDecodeError:
            continue
        if words_of(name, text) is not None:
            looked_at += 1
            faults += faults_in(name, text)
    return faults, looked_at


def main():
    parser = command_line.Parser(__doc__)
    parser.add_argument("root", nargs="?", type=command_line.folder, default=pathlib.Path(__file__).resolve().parent.parent)
    root = parser.parse_args().root
    faults, looked_at = check(root)
    for fault in faults:
        print(fault)
    print(f"words: {len(faults)} faults in {looked_at} files")
    return 1 if faults or looked_at < 1 else 0


if __name__ == "__main__":
    command_line.run(main)
