"""What a source is made of: its own text and the project's headers that it includes, also through others."""
import functools
import hashlib
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDERS = ("src", "include/openevc", "include")  # where a name of a header begins
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.M)


@functools.lru_cache(maxsize=None)
def text_and_includes(path):
    data = path.read_bytes()
    found = [ROOT / folder / name for name in INCLUDE.findall(data.decode("utf-8", "replace")) for folder in FOLDERS]
    return data, tuple(p for p in found if p.exists())


def made_of(source):
    seen, work = set(), [source]
    while work:
        path = work.pop()
        if path not in seen:
            seen.add(path)
            work += text_and_includes(path)[1]
    return sorted(seen)


def fingerprint(source, *more):
    """A name that changes when anything that the source is made of, or one of the texts `more`, does."""
    digest = hashlib.sha256()
    for part in more:
        digest.update(part.encode() + b"\0")
    for path in made_of(source):
        digest.update(str(path.relative_to(ROOT)).encode() + b"\0" + text_and_includes(path)[0] + b"\0")
    return digest.hexdigest()
