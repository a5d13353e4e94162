#!/usr/bin/env python3
"""The generated pages equal the tables of the program, the declarations of packets and messages are those that
tools/generate_language.py writes from the reference data, and if the recorded line is available no test was
skipped in the last test run (build/ci/cases, if it exists).
Usage: tools/check_tables.py [--write]   --write updates the pages."""
import os
import pathlib
import shutil
import subprocess
import tempfile
import xml.etree.ElementTree

import command_line

ROOT = pathlib.Path(__file__).resolve().parent.parent
# Tests that lay a table beside the reference data, or drive the recorded line.
COMPARISONS = ("modes_test", "lang_test", "io_test", "airgap_test", "sdm_test", "track_test", "app_test",
               "balise_line_test")


def mode_page():
    with tempfile.TemporaryDirectory() as folder:
        program = pathlib.Path(folder) / "mode_table_page"
        subprocess.run(["c++", "-std=c++20", "-I", ROOT / "src", "-I", ROOT / "include",
                        "-I", ROOT / "include/openevc", ROOT / "tools/mode_table_page.cpp", "-o", program],
                       check=True)
        return subprocess.run([program], check=True, capture_output=True, text=True).stdout


def pages():
    yield ROOT / "docs/modes.md", mode_page()


def language_faults():
    """Sources of src/lang that are not what the generator writes."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        subprocess.run([ROOT / "tools/generate_language.py", ROOT / "tests/reference", folder], check=True,
                       stdout=subprocess.DEVNULL)
        shutil.copy(ROOT / ".clang-format", folder)
        written = sorted(p for p in (folder / "src/lang").rglob("*.*"))
        subprocess.run(["clang-format", "-i", *written], check=True)
        return [f"{p.relative_to(folder)} is not what tools/generate_language.py tests/reference . writes"
                for p in written if p.read_bytes() != (ROOT / p.relative_to(folder)).read_bytes()]


def skipped_comparisons():
    """Names of comparisons that did not run although what they need is at hand."""
    shared = pathlib.Path(os.environ.get("OPENEVC_SHARED", ROOT / "../shared"))
    cases = ROOT / "build/ci/cases"
    if not shared.exists() or not cases.exists():
        return []
    faults = []
    for name in COMPARISONS:
        file = cases / f"{name}.xml"
        if not file.exists():
            faults.append(f"{name} did not run")
            continue
        for case in xml.etree.ElementTree.parse(file).getroot().iter("testcase"):
            if case.get("result") == "skipped":
                faults.append(f"{case.get('classname')}.{case.get('name')} was skipped")
    return faults


def main():
    parser = command_line.Parser(__doc__)
    parser.add_argument("--write", action="store_true")
    write = parser.parse_args().write
    faults = []
    for path, text in pages():
        if write:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        elif not path.exists() or path.read_text(encoding="utf-8") != text:
            faults.append(f"{path.relative_to(ROOT)} is not what the tables print: tools/check_tables.py --write")
    faults += language_faults()
    faults += skipped_comparisons()
    for fault in faults:
        print(fault)
    print(f"tables: {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    command_line.run(main)
