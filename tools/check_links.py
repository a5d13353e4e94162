#!/usr/bin/env python3
"""Every relative link, image and anchor in the Markdown pages has a target, and every page under docs/
is reached from README.md. Usage: tools/check_links.py [ROOT]."""
import pathlib
import re
import urllib.parse

import command_line

LINK = re.compile(r"!?\[(?:[^\]\[]|\[[^\]]*\])*\]\(([^)\s]+)(?:\s+\"[^\"]*\")?\)")


def anchors(page):
    """The anchors of a page as GitHub makes them of its headings."""
    found, fenced = set(), False
    for line in page.read_text(encoding="utf-8").splitlines():
        if line.startswith("```"):
            fenced = not fenced
        heading = re.match(r"#{1,6}\s+(.*?)\s*#*$", line)
        if heading and not fenced:
            text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading[1]).replace("`", "").lower()
            slug = re.sub(r"[^\w\- ]", "", text).replace(" ", "-")
            name, n = slug, 0
            while name in found:
                n += 1
                name = f"{slug}-{n}"
            found.add(name)
    return found


def links(page):
    """(line, target) of every link outside code."""
    fenced = False
    for number, line in enumerate(page.read_text(encoding="utf-8").splitlines(), 1):
        if line.lstrip().startswith("```"):
            fenced = not fenced
        elif not fenced:
            for target in LINK.findall(re.sub(r"`[^`]*`", "", line)):
                yield number, target


def check(root):
    root = pathlib.Path(root).resolve()
    pages = [p for p in (*root.glob("*.md"), *root.glob("docs/**/*.md")) if p.is_file()]
    broken, reached = [], {}
    for page in pages:
        reached[page] = set()
        for number, target in links(page):
            if re.match(r"[a-z]+:", target):
                continue
            path, _, anchor = target.partition("#")
            other = (page.parent / urllib.parse.unquote(path)).resolve() if path else page
            where = f"{page.relative_to(root)}:{number}"
            if not other.exists():
                broken.append(f"{where}: {target} does not exist")
                continue
            reached[page].add(other)
            if anchor and other.suffix == ".md" and anchor not in anchors(other):
                broken.append(f"{where}: no heading #{anchor} in {other.name}")
    seen, todo = set(), [root / "README.md"]
    while todo:
        page = todo.pop()
        if page not in seen:
            seen.add(page)
            if page.is_dir():
                todo += [p for p in pages if p.parent == page]
            todo += [p for p in reached.get(page, ())]
    if (root / "README.md").exists():
        broken += [f"{p.relative_to(root)}: not reached from README.md" for p in pages if p not in seen]
    return broken


def main():
    parser = command_line.Parser(__doc__)
    parser.add_argument("root", nargs="?", type=command_line.folder, default=pathlib.Path(__file__).resolve().parent.parent)
    root = parser.parse_args().root
    broken = check(root)
    for line in broken:
        print(line)
    print(f"links: {len(broken)} broken")
    return 1 if broken else 0


if __name__ == "__main__":
    command_line.run(main)
