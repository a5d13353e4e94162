"""The compiled module is for one version of Python."""
import importlib.machinery
import pathlib
import sys


def explained(error):
    """What `import _native` failed with, or, where there is no module for this interpreter, a sentence about that."""
    built = sorted(file.name for file in pathlib.Path(__file__).parent.glob("_native.*so"))
    if any(name == "_native" + end for name in built for end in importlib.machinery.EXTENSION_SUFFIXES):
        return error
    version = ".".join(map(str, sys.version_info[:2]))
    return ImportError(f"openevc: found Python {version} ({sys.executable}), expected the interpreter that the package was "
                       f"built for: {', '.join(built) or 'no module is built'}")
