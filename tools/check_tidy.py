#!/usr/bin/env -S python3 -B
"""clang-tidy (.clang-tidy) on every product source that is not known to be clean, to its end; every warning is an error.

A source is known to be clean when tests/gates/tidy.txt holds it with the hash of its own code and of its own headers:
those beside it (x.h of x.cpp, in src/ROOM and in include/openevc/ROOM), and headers without a source beside them,
each of which belongs to the one source through which it is looked at (see `owners`). A header that no product source
includes is in the list by itself. Findings count where they are in the source or in one of its own headers: every
header of the product is thus looked at once. The first lines of the list name the tool's version and the hash of
.clang-tidy: with others of them nothing is known.

Usage: tools/check_tidy.py [--write] [--all] [--list] [FILE...]
  --write  records what was found clean, after each source, so that a run that was stopped goes on where it ended;
           sources that do not exist any more leave the list
  --all    also what is known to be clean;  FILE: these sources, or the owners of these headers, known or not
  --list   prints each source with its headers, and looks at nothing"""
import concurrent.futures
import hashlib
import json
import pathlib
import re
import subprocess
import sys

import command_line
from included import made_of, text_and_includes

ROOT = pathlib.Path(__file__).resolve().parent.parent
LIST = ROOT / "tests/gates/tidy.txt"
BUILD = ROOT / "build/tidy"  # configured, not built
GENERATED = BUILD / "generated"
HEAD = """\
# Product sources in which clang-tidy finds nothing, each with the hash of its text and of its own headers.
# Written by tools/check_tidy.py --write.
"""


def product_files():
    """Names of all sources and headers, those of tests too."""
    return sorted(str(path.relative_to(ROOT)) for folder in ("src", "include") for path in (ROOT / folder).rglob("*.*")
                  if path.suffix in (".cpp", ".h"))


def is_source(name):
    return name.endswith(".cpp") and not re.search(r"(^|/)test_[^/]*$|_test\.cpp$", name)


def is_helper_of_tests(name):
    return bool(re.search(r"(^|/)test_[^/]*$|(_test|(^|[_/])testing)\.h$", name))


def within(name):
    """ROOM/FILE of a name in src or include/openevc: what has the same is beside each other."""
    return re.sub(r"^(src|include/openevc|include)/", "", name)


def owners(names):
    """{source: its own headers}. A header without a source beside it belongs to the first of those that include it, in
    this order: of its own room, by themselves and not through another header, by name. Without any it is its own."""
    sources = [n for n in names if is_source(n)]
    beside = {within(s).removesuffix(".cpp"): s for s in sources}
    reach = {s: {str(p.relative_to(ROOT)) for p in made_of(ROOT / s)} for s in sources}
    direct = {s: {str(p.relative_to(ROOT)) for p in text_and_includes(ROOT / s)[1]} for s in sources}
    own = {s: [] for s in sources}
    for header in (n for n in names if n.endswith(".h")):
        source = beside.get(within(header).removesuffix(".h"))
        if source is None or header not in reach[source]:
            room = within(header).split("/")[0]
            rank = [(within(s).split("/")[0] != room, header not in direct[s], s) for s in sources if header in reach[s]]
            source = min(rank)[2] if rank else None
        if source is not None:
            own[source].append(header)
        elif not is_helper_of_tests(header):
            own[header] = []
    return own


def code_of(text):
    """The text as it counts: a changed comment or indentation leaves a clean source clean, one with NOLINT does not."""
    text = re.sub(r"//(?!.*NOLINT)[^\n]*", "", text)
    return re.sub(r"[ \t]+", " ", re.sub(r"\s*\n\s*", "\n", text)).strip()


def fingerprint(source, headers):
    digest = hashlib.sha256()
    for name in (source, *headers):
        code = code_of((ROOT / name).read_text(encoding="utf-8"))
        digest.update(name.encode() + b"\0" + code.encode() + b"\0")
    return digest.hexdigest()[:16]


def conditions():
    """What the whole list was made with: the tool and its checks."""
    said = subprocess.run(["clang-tidy", "--version"], capture_output=True, text=True, check=True).stdout
    version = re.search(r"version (\S+)", said)[1]
    checks = hashlib.sha256((ROOT / ".clang-tidy").read_bytes()).hexdigest()[:16]
    return {"clang-tidy": version, ".clang-tidy": checks}


def known_clean(text, now):
    """{source: hash} of the list; nothing where it was made with another tool or other checks."""
    rows = dict(line.split() for line in text.splitlines() if line and not line.startswith("#"))
    return {} if any(rows.pop(key, None) != value for key, value in now.items()) else rows


def written(clean, now):
    return HEAD + "".join(f"{key} {value}\n" for key, value in [*now.items(), *sorted(clean.items())])


def configure():
    """The commands of the dev build with evc-mpi and the Python package, but clang-tidy cannot read the precompiled headers of g++."""
    subprocess.run(["cmake", "--preset", "dev", "-B", str(BUILD), "-DEVC_PRECOMPILE=OFF", "-DEVC_MPI=ON",
                    "-DEVC_PYTHON=ON"], cwd=ROOT, check=True, stdout=subprocess.DEVNULL)


def commands():
    """Sources that the dev build compiles."""
    entries = json.loads((BUILD / "compile_commands.json").read_text(encoding="utf-8"))
    return {entry["file"] for entry in entries}


def look(source, headers):
    """(nothing found, what was found, the hash of what was looked at). Own headers only: the others are looked at
    through their own sources."""
    mark = fingerprint(source, headers)
    narrow = "(^|/)(" + "|".join(map(re.escape, headers)) + ")$" if headers else "^$"
    done = subprocess.run(["clang-tidy", "-p", str(BUILD), "--quiet", "--warnings-as-errors=*", f"--header-filter={narrow}",
                           "--extra-arg=-Wno-unknown-warning-option", "--extra-arg=-Wno-pragma-once-outside-header",
                           f"--extra-arg=-I{GENERATED}", str(ROOT / source)],
                          cwd=ROOT, capture_output=True, text=True)
    return done.returncode == 0, done.stdout or done.stderr, mark


def main(arguments=None):
    parser = command_line.Parser(__doc__)
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("files", nargs="*")
    options = parser.parse_args(arguments)
    own = owners(product_files())
    if options.list:
        print("\n".join(" ".join([s, *headers]) for s, headers in own.items()))
        return 0
    configure()
    compiled = commands()
    unbuilt = [s for s in own if is_source(s) and str(ROOT / s) not in compiled]
    for source in unbuilt:
        print(f"tidy: {source}: the dev build does not compile it")
    asked = {str(pathlib.Path(f).resolve().relative_to(ROOT)) for f in options.files}
    unknown = asked - set(own).union(*own.values())
    if unknown:
        sys.exit(f"tidy: {', '.join(sorted(unknown))}: not in the product")

    now = conditions()
    hashes = {s: fingerprint(s, headers) for s, headers in own.items()}
    clean = known_clean(LIST.read_text(encoding="utf-8") if LIST.exists() else "", now)
    clean = {s: h for s, h in clean.items() if hashes.get(s) == h}
    if asked:
        open_ = [s for s in own if asked & {s, *own[s]}]
    else:
        open_ = [s for s in own if options.all or s not in clean]
    open_ = [s for s in open_ if s not in unbuilt]
    # What takes longest begins first.
    open_.sort(key=lambda s: -sum(len(text_and_includes(p)[0]) for p in made_of(ROOT / s)))
    # The build makes this one (src/kernel/CMakeLists.txt); its number does not matter here.
    layout = GENERATED / "kernel/state_layout.h"
    layout.parent.mkdir(parents=True, exist_ok=True)
    layout.write_text("#pragma once\n#define EVC_STATE_LAYOUT 0u\n", encoding="utf-8")

    failed = 0
    with concurrent.futures.ThreadPoolExecutor(command_line.jobs()) as pool:
        ways = {pool.submit(look, s, own[s]): s for s in open_}
        for way in concurrent.futures.as_completed(ways):
            source, (good, said, mark) = ways[way], way.result()
            if good:
                clean[source] = mark
            else:
                clean.pop(source, None)
                failed += 1
                print(f"tidy: {source}\n{said}", flush=True)
            if options.write:
                LIST.write_text(written(clean, now), encoding="utf-8")
    if options.write:
        LIST.write_text(written(clean, now), encoding="utf-8")
    print(f"tidy: {len(own)} sources, {len(open_)} looked at, {failed} with warnings")
    if open_ and not failed and not options.write and not options.all and not asked:
        print("tidy: tools/check_tidy.py --write records them, so that they are not looked at again")
    return 1 if failed or unbuilt else 0


if __name__ == "__main__":
    command_line.run(main)
