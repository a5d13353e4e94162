"""All mutants of a room in one build: an instrumented copy of its sources asks at run time which mutant is on.

    5.0           ->  pick(7, 5.0, 5.5)              a + b   ->  a + Plus<7>{} + b
    if (a)        ->  if ((on(7) != bool(a)))        a();    ->  if (on(7)) {} else a();
    a && b || c   ->  (on(7) ? bool(a || b || c) : on(8) ? bool(a && b && c) : bool(a && b || c))
    std::min(a)   ->  Min{7}(a)                      constexpr Row k[] = {{..}}  ->  const Table<Row> k = {{7, {..}}}
    "A  R  NR"    ->  text("A  R  NR", {{7, "R  R  NR"}, {8, "A  A  NR"}, ...})

constexpr is removed, so that nothing is computed before the mutant is known, and static_assert checks nothing (schema.h).
Where a constant has to be one (array sizes, case labels), or where the changed operator does not exist, the copy does not
compile; every change is in a line of its own with its mark, so that the compiler's message shows which. It is taken
back and its mutants are built alone. So are rows that a page loses, for its size is a type."""
import re

from mutation.sources import TABLE, closing, masked, without_comments

NAMES = {"+": "Plus", "-": "Minus", "*": "Times", "/": "Over", "+=": "PlusAssign", "-=": "MinusAssign", "<": "Less",
         "<=": "LessEqual", ">": "Greater", ">=": "GreaterEqual", "==": "Equal", "!=": "NotEqual"}
MARK = re.compile(r"/\*@([^*]+)\*/")


class Edit:
    """One change of text[start:end]. `write` gets a function that gives the (changed) text of a part of it."""
    def __init__(self, start, end, ids, write):
        self.start, self.end, self.ids, self.write = start, end, ids, write


def own_line(mark, text):
    return f"\n/*@{mark}*/{text}\n"


def operand_ends(code, at):
    """The whole expression of && and || around the one at `at`: up to what binds weaker, or the bracket around."""
    left = at
    depth = 0
    while left > 0:
        c = code[left - 1]
        if c in ")]}":
            depth += 1
        elif c in "([{":
            depth -= 1
            if depth < 0:
                break
        elif depth == 0:
            if c in ";,?" or (c == ":" and code[left - 2] != ":" and code[left] != ":"):
                break
            if c == "=" and code[left] in " \n" and code[left - 2] not in "=!<>":
                break
            if re.search(r"\breturn$", code[max(0, left - 7):left]):
                break
        left -= 1
    right = at
    depth = 0
    while right < len(code):
        c = code[right]
        if c in "([{":
            depth += 1
        elif c in ")]}":
            depth -= 1
            if depth < 0:
                break
        elif depth == 0 and (c in ";,?" or (c == ":" and code[right - 1] != ":" and code[right + 1] != ":")):
            break
        right += 1
    return left, right


def logic_edits(code, mutants):
    """One edit for each expression: the alternatives side by side."""
    groups = {}
    for m in mutants:
        groups.setdefault(operand_ends(code, m.start), []).append(m)

    def edit(start, end, group):
        def write(inner):
            def alternative(changed):
                parts, at = [], start
                for m in group:
                    parts += [inner(at, m.start), m.new if m is changed else code[m.start:m.end]]
                    at = m.end
                return "bool(" + "".join(parts) + inner(at, end) + ")"
            chosen = "".join(own_line(m.id, f"evc_mutant::on({m.id}) ?") + alternative(m) + "\n:" for m in group)
            return f" ({chosen} {alternative(None)})"
        return Edit(start, end, [m.id for m in group], write)

    return [edit(start, end, group) for (start, end), group in groups.items()]


def simple_edit(code, m):
    old = code[m.start:m.end]
    call = f"evc_mutant::on({m.id})"
    if m.operator == "delete":
        return Edit(m.start, m.end, [m.id],
                    lambda inner: own_line(m.id, f"if ({call}) {{}} else") + inner(m.start, m.end))
    if m.operator == "negate":
        return Edit(m.start, m.end, [m.id],
                    lambda inner: "(" + own_line(m.id, f"{call} != bool(") + inner(m.start + 1, m.end - 1) + "))")
    start, text = m.start, None
    if m.operator == "minmax":
        start -= len("std::")
        text = f"evc_mutant::{old.capitalize()}{{{m.id}}}"
    elif m.operator == "cell":
        scope = re.search(r"(?:\w+::)*$", code[:start]).group()
        start -= len(scope)
        text = f"evc_mutant::pick({m.id}, {scope}{old}, {scope}{m.new})"
    elif m.operator in ("number", "truth"):
        text = f"evc_mutant::pick({m.id}, {old}, {m.new})"
    else:
        text = f"{old} evc_mutant::{NAMES[old]}<{m.id}>{{}} {old}"
    return Edit(start, m.end, [m.id], lambda inner: own_line(m.id, text))


def text_edits(code, mutants):
    """One edit for each row of text: the texts side by side."""
    groups = {}
    for m in mutants:
        begin = code.rindex('"', 0, m.start)
        groups.setdefault((begin, code.index('"', m.end) + 1), []).append(m)

    def edit(begin, end, group):
        others = ", ".join(f"{{{m.id}, {code[begin:m.start]}{m.new}{code[m.end:end]}}}" for m in group)
        text = own_line(group[0].id, f"evc_mutant::text({code[begin:end]}, {{{others}}})")
        return Edit(begin, end, [m.id for m in group], lambda inner: text)

    return [edit(begin, end, group) for (begin, end), group in groups.items()]


def table_edits(code, name, mutants, dropped):
    """Arrays become tables whose rows can be left out; all of one table or nothing."""
    edits = []
    for head in TABLE.finditer(code):
        mark = f"{name}:table {head.group(2)}"
        end = closing(code, head.end() - 1)
        rows = [m for m in mutants if m.operator == "row" and head.end() <= m.start < end]
        if mark in dropped or not rows:
            continue
        text = own_line(mark, f"const evc_mutant::Table<{head.group(1)}> {head.group(2)} =")
        edits.append(Edit(head.start(), head.end() - 1, [], lambda inner, text=text: text))
        wanted = {code.index("{", m.start): m.id for m in rows}
        begin = code.find("{", head.end(), end)
        while begin > 0:
            last = closing(code, begin) + 1
            number = wanted.get(begin, -1)  # -1: a row that stays
            edits.append(Edit(begin, last, [number] * (number > 0), lambda inner, begin=begin, last=last, number=number,
                              mark=mark: own_line(mark, f"{{{number},") + inner(begin, last) + "}"))
            begin = code.find("{", last, end)
    return edits


def in_function(code, at):
    """Whether the innermost brackets around `at` are those of a block of statements, not of a class or namespace."""
    depth = 0
    while at > 0:
        at -= 1
        depth += (code[at] == "}") - (code[at] == "{")
        if depth < 0:
            head = re.split(r"[;{}]", code[:at])[-1]
            return re.search(r"\b(?:class|struct|namespace|enum|union)\b", head) is None
    return False


def runtime_edits(code, name, dropped):
    """constexpr -> const for what is a value, inline for what is a function."""
    for m in re.finditer(r"\b(static |inline |friend )?constexpr (?!\()", code):
        if re.search(r"\bif $", code[:m.start()]):
            continue
        declared = code[m.end():m.end() + re.search(r"[;{]|$", code[m.end():]).start() + 1]
        mark = f"{name}:constexpr " + re.sub(r"\W+", " ", declared).strip()
        before = m.group(1) or ""
        function = "operator" in declared or re.match(r"[^={;\[]*\(", declared)
        size = re.match(r"(std::size_t|int|unsigned|std::u?int\d+_t) \w+ =", declared)  # may be that of an array
        if mark in dropped or (function and "= default" in declared) or size:
            continue
        if function:
            text = before or "inline "
        elif before == "static ":
            text = "static const " if in_function(code, m.start()) else "static inline const "
        else:
            text = before + "const "
        yield Edit(m.start(), m.end(), [], lambda inner, mark=mark, text=text: own_line(mark, text))


def instrumented(text, mutants, dropped, name="file"):
    """The instrumented text, and the numbers of the mutants in it. `dropped`: marks of changes that do not compile."""
    code = without_comments(text)
    mutants = [m for m in mutants if str(m.id) not in dropped and (m.operator, m.row) != ("row", "page")]
    edits = logic_edits(masked(text), [m for m in mutants if m.operator == "logic"])
    edits += text_edits(code, [m for m in mutants if m.operator == "word"])
    edits += [simple_edit(code, m) for m in mutants if m.operator not in ("logic", "row", "word")]
    edits += table_edits(code, name, mutants, dropped)
    heads = {e.start for e in edits}
    edits += [e for e in runtime_edits(code, name, dropped)
              if not any(e.start <= s < e.end for s in heads)]
    edits.sort(key=lambda e: (e.start, -e.end))
    written = set()

    def render(start, end, edits):
        parts, at = [], start
        for e in edits:
            if e.start < at or e.end > end:
                continue  # inside of the one before
            inside = [x for x in edits if x is not e and e.start <= x.start and x.end <= e.end]
            parts.append(code[at:e.start])
            parts.append(e.write(lambda s, t: render(s, t, [x for x in inside if s <= x.start and x.end <= t])))
            written.update(e.ids)
            at = e.end
        return "".join(parts) + code[at:end]

    return render(0, len(code), edits), written


CONSTANT = re.compile(r"constant|constexpr|literal type|array bound|bit-field|variable length|case label|type/value|"
                      r"variable-size")


def blamed(messages, tree):
    """Marks of the changes that the compiler complains about. Constants first: what they break breaks more."""
    files = {}

    def marks(name, number, before, after):
        lines = files.setdefault(name, (tree / name).read_text().split("\n"))
        near = lines[max(0, number - 1 - before):number + after]
        return {mark for line in near for mark in MARK.findall(line)}

    named = re.compile(re.escape(str(tree)) + r"/([\w./]+):(\d+):(?:\d+:)? *(.*)")
    constant, other = [], []  # of every error the places that it names, the notes after it apart
    places = []
    for line in messages.splitlines():
        m = named.match(line)
        if m is None:
            if "error:" in line:
                (constant if CONSTANT.search(line) else other).append((places, notes := []))
                places = []
            continue
        place = (m.group(1), int(m.group(2)))
        if m.group(3).startswith("note:"):
            if constant or other:
                notes.append(place)
        elif m.group(3).startswith("error:"):
            places.append(place)
            (constant if CONSTANT.search(m.group(3)) else other).append((places, notes := []))
            places = []
        elif "required from" in m.group(3) or "in " in m.group(3):
            places.append(place)
    for errors in (constant, other):
        for around in ((0, 0), (0, 1), (2, 2)):
            found = set()
            for at, notes in errors:
                here = {mark for p in at for mark in marks(*p, *around)}
                found |= here or {mark for p in notes for mark in marks(*p, *around)}
            if found:
                return found
    return set()
