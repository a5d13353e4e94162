"""docs/ROOM-mutants.md: figures by file, and what survived with its reason. Reasons are written by hand into the page and
kept as long as their mutant is the same; a survivor without one is shown as such."""
import collections
import datetime
import re

from mutation.sources import ROOT

HEAD = """\
# Mutants of {room}

`make campaign-mutants ROOM={room}` changes `src/{room}` in one place at a time and runs the room's tests with it: [how, and what
the verdicts mean](sdm-mutants.md). What no test notices is listed below with the reason; a survivor without one fails the run.
"""
NO_REASON = "**no reason yet**"


def reasons(page):
    """{(file, what): why} of a page's table of survivors, line numbers left out."""
    found = {}
    for line in page.splitlines():
        cells = [c.strip() for c in line.replace("\\|", "\0").strip("|").split("|")]
        if line.startswith("| ") and len(cells) == 3:
            found[cells[0].split(":")[0], cells[1].replace("\0", "|")] = cells[2].replace("\0", "|")
    return found


def table(rows):
    return "".join("| " + " | ".join(str(c).replace("|", "\\|") for c in row) + " |\n" for row in rows)


def page(room, before, results, number, how):
    """The page from what it was before and the results of a run over `number` possible mutants; `how` they were chosen."""
    known = reasons(before)
    head = before.split("## Figures")[0] if "## Figures" in before else HEAD.format(room=room) + "\n"
    counts = collections.defaultdict(collections.Counter)
    for r in results:
        verdict = r["verdict"].split(":")[0]
        counts[r["file"].split(f"{room}/", 1)[1]][verdict] += 1
    verdicts = ["killed", "survived", "does not compile", "not run"]
    lines = [(name, c.total(), *(c[v] for v in verdicts)) for name, c in sorted(counts.items())]
    lines.append(("all", *(sum(line[i] for line in lines) for i in range(1, 6))))
    survived = sorted((r["file"], r["line"], r["what"]) for r in results if r["verdict"] == "survived")
    run = f"{sum(r['verdict'] != 'not run' for r in results)} of {number} mutants{how}, g++ 12, {datetime.date.today():%Y-%m}."
    text = head + f"## Figures\n{run} What does not compile is refused by a type or an assertion.\n\n"
    text += table([("file", "mutants", "killed", "survived", "do not compile", "not run"), ("---",) * 6, *lines])
    text += "\n## Survivors\n"
    text += table([("where", "mutation", "why"), ("---",) * 3,
                   *((f"{file}:{line}", what, known.get((file, what), NO_REASON)) for file, line, what in survived)])
    return text if survived else text.rsplit("| where", 1)[0] + "None.\n"


def write_page(room, results, number, how):
    path = ROOT / "docs" / f"{room}-mutants.md"
    before = path.read_text(encoding="utf-8") if path.exists() else ""
    path.write_text(page(room, before, results, number, how), encoding="utf-8")
    return path
