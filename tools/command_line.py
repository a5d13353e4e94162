"""What the command lines of the tools have in common: for what is wrong one sentence on standard error, exit status 2.

    parser = command_line.Parser(__doc__)
    parser.add_argument("--runs", type=command_line.whole(1))
    ...
    command_line.run(main)"""
import argparse
import contextlib
import json
import os
import pathlib
import re
import subprocess
import sys


class Refused(Exception):
    """What is wrong, as a sentence without the name of the tool."""


class Parser(argparse.ArgumentParser):
    """Says what is wrong in one line, without the usage; options are not abbreviated."""

    def __init__(self, description=None, **more):
        super().__init__(description=description, formatter_class=argparse.RawDescriptionHelpFormatter, allow_abbrev=False, **more)

    def error(self, message):
        self.exit(2, f"{self.prog}: {' '.join(message.split())}\n")


def _wrong(found, expected):
    return argparse.ArgumentTypeError(f"found {found}, expected {expected}")


def whole(least, most=None):
    """A whole number in this range."""
    def read(text):
        expected = f"a whole number from {least} {'on' if most is None else f'to {most}'}"
        # int() also takes 1_000, spaces around and the digits of other scripts; and refuses very long numbers.
        if not re.fullmatch(r"[+-]?[0-9]{1,30}", text):
            raise _wrong(repr(text), expected)
        number = int(text)
        if number < least or most is not None and number > most:
            raise _wrong(repr(text), expected)
        return number
    return read


def file(text):
    """The path of a file that is there."""
    if not pathlib.Path(text).is_file():
        raise _wrong(f"no file {text}", "one")
    return pathlib.Path(text)


def folder(text):
    """The path of a folder that is there."""
    if not pathlib.Path(text).is_dir():
        raise _wrong(f"no folder {text}", "one")
    return pathlib.Path(text)


def program(text):
    """The whole path of a program that is there."""
    path = pathlib.Path(text).resolve()
    if not path.is_file() or not os.access(path, os.X_OK):
        raise _wrong(f"no program {text}", "one")
    return path


def jobs(default=None):
    """How many things are done at a time: JOBS of the environment, or one for each processor."""
    try:
        return whole(1)(os.environ.get("JOBS") or str(default or os.cpu_count()))
    except argparse.ArgumentTypeError as wrong:
        raise Refused(f"JOBS: {wrong}") from None


@contextlib.contextmanager
def reading(path, expected):
    """What is wrong with the contents of a file is one sentence."""
    try:
        yield
    except RecursionError:
        raise Refused(f"{path}: found values within values, too many of them, expected {expected}") from None
    except (ValueError, LookupError, TypeError, AttributeError) as wrong:
        what = f"no {wrong}" if isinstance(wrong, KeyError) else str(wrong)
        raise Refused(f"{path}: found {what}, expected {expected}") from None


def json_of(path):
    """The document that a file has."""
    with reading(path, "JSON"):
        return json.loads(pathlib.Path(path).read_text(encoding="utf-8"))


def run(main):
    """Runs a tool and ends with its exit status; a file that is not there or cannot be written ends it with a sentence."""
    name = pathlib.Path(sys.argv[0]).name
    try:
        status = main()
        sys.stdout.flush()
    except BrokenPipeError:  # who reads has enough
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        sys.exit(1)
    except KeyboardInterrupt:
        sys.exit(130)
    except SystemExit as end:
        if not isinstance(end.code, str):
            raise
        print(end.code, file=sys.stderr)
        sys.exit(2)
    except (Refused, argparse.ArgumentTypeError) as wrong:
        sentence = str(wrong)
    except OSError as wrong:
        sentence = ": ".join(str(part) for part in (wrong.filename, wrong.strerror or wrong) if part)
    except subprocess.CalledProcessError as wrong:
        command = wrong.cmd if isinstance(wrong.cmd, str) else " ".join(map(str, wrong.cmd[:3]))
        said = wrong.stderr.strip() if isinstance(wrong.stderr, str) else ""
        sentence = f"{command} ended with {wrong.returncode}" + (f": {said.splitlines()[-1]}" if said else "")
    except subprocess.TimeoutExpired as wrong:
        command = wrong.cmd if isinstance(wrong.cmd, str) else " ".join(map(str, wrong.cmd[:3]))
        sentence = f"{command} did not end within {round(wrong.timeout, 2):g} s"
    else:
        sys.exit(status)
    print(f"{name}: {sentence}", file=sys.stderr)
    sys.exit(2)
