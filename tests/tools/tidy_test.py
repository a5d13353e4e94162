"""tools/check_tidy.py: everything is looked at once, and what was found clean is not looked at again until it changes."""
import contextlib
import io
import json
import pathlib
import shutil
import sys
import tempfile
import unittest
from unittest import mock

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tools"))
import check_tidy  # noqa: E402
import included  # noqa: E402

FINE = {
    "src/track/store.h": "#pragma once\nint stored();\n",
    "src/track/store.cpp": '#include "track/store.h"\n#include "track/profile.h"\nint stored() { return profile(); }\n',
    "src/track/area.cpp": '#include "track/all.h"\nint area() { return profile(); }\n',
    "src/track/all.h": '#pragma once\n#include "track/profile.h"\n',
    "src/track/profile.h": "#pragma once\ninline int profile() {\n  int n = 0;\n  return n;\n}\n",
    "src/app/main.cpp": '#include "track/profile.h"\nint shown() { return profile(); }\n',
    "src/track/page.h": "#pragma once\ninline int page() { return 1; }\n",
    "src/track/testing.h": "#pragma once\n",
    "src/track/store_test.cpp": '#include "track/page.h"\n#include "track/testing.h"\n',
}


class Tidy(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name).resolve()
        for module, names in ((check_tidy, {"ROOT": "", "LIST": "tests/gates/tidy.txt", "BUILD": "build/tidy",
                                            "GENERATED": "build/tidy/generated"}), (included, {"ROOT": ""})):
            patch = mock.patch.multiple(module, **{name: self.root / path for name, path in names.items()})
            patch.start()
            self.addCleanup(patch.stop)
        configured = mock.patch.object(check_tidy, "configure")
        configured.start()
        self.addCleanup(configured.stop)
        for name, text in FINE.items():
            self.write(name, text)
        self.write(".clang-tidy", "Checks: '-*,cppcoreguidelines-init-variables'\n")
        self.write("tests/gates/tidy.txt", "")
        self.write("build/tidy/compile_commands.json", json.dumps(
            [{"directory": str(self.root), "file": str(self.root / name), "command": f"c++ -Isrc -std=c++20 -c {name}"}
             for name in FINE if name.endswith(".cpp")]))

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        included.text_and_includes.cache_clear()

    def owners(self):
        return check_tidy.owners(check_tidy.product_files())

    def run_gate(self, *arguments):
        with contextlib.redirect_stdout(io.StringIO()) as said:
            status = check_tidy.main(list(arguments))
        return status, said.getvalue()

    def test_every_header_of_the_product_has_one_owner(self):
        self.assertEqual(self.owners(), {
            "src/app/main.cpp": [],
            "src/track/area.cpp": ["src/track/all.h"],
            "src/track/page.h": [],  # no product source includes it
            "src/track/store.cpp": ["src/track/profile.h", "src/track/store.h"],  # of the room, and directly
        })

    def test_hash_follows_the_source_and_its_own_headers(self):
        def hashes():
            return {s: check_tidy.fingerprint(s, headers) for s, headers in self.owners().items()}
        before = hashes()
        self.write("src/track/profile.h", FINE["src/track/profile.h"] + "int more;\n")
        after = hashes()
        self.assertEqual([s for s in before if before[s] != after[s]], ["src/track/store.cpp"])

    def test_a_comment_changes_no_hash_but_NOLINT_does(self):
        self.assertEqual(check_tidy.code_of("int a;  // why\n  int b;\n"), check_tidy.code_of("int a;\nint b;\n// more\n"))
        self.assertNotEqual(check_tidy.code_of("int a;  // NOLINT\n"), check_tidy.code_of("int a;\n"))

    def test_another_tool_or_other_checks_and_nothing_is_known(self):
        now = {"clang-tidy": "14.0.6", ".clang-tidy": "abc"}
        text = check_tidy.written({"src/a.cpp": "1"}, now)
        self.assertEqual(check_tidy.known_clean(text, now), {"src/a.cpp": "1"})
        self.assertEqual(check_tidy.known_clean(text, {**now, "clang-tidy": "15.0.0"}), {})
        self.assertEqual(check_tidy.known_clean(text, {**now, ".clang-tidy": "abd"}), {})
        self.assertEqual(check_tidy.known_clean("", now), {})

    def test_a_source_that_the_build_does_not_compile(self):
        self.write("src/track/extra.cpp", "int extra() { return 1; }\n")
        with mock.patch.object(check_tidy, "look", return_value=(True, "", "mark")), \
                mock.patch.object(check_tidy, "conditions", return_value={"clang-tidy": "14", ".clang-tidy": "a"}):
            status, said = self.run_gate("--write")
        self.assertEqual(status, 1)
        self.assertIn("src/track/extra.cpp: the dev build does not compile it", said)
        self.assertNotIn("extra", (self.root / "tests/gates/tidy.txt").read_text())

    @unittest.skipUnless(shutil.which("clang-tidy"), "no clang-tidy")
    def test_a_planted_fault(self):
        status, said = self.run_gate("--write")
        self.assertEqual((status, said), (0, "tidy: 4 sources, 4 looked at, 0 with warnings\n"))
        self.assertEqual(self.run_gate(), (0, "tidy: 4 sources, 0 looked at, 0 with warnings\n"))
        for name, owner in (("src/track/profile.h", "src/track/store.cpp"), ("src/app/main.cpp", "src/app/main.cpp"),
                            ("src/track/page.h", "src/track/page.h")):
            self.write(name, FINE[name] + "inline int planted() {\n  int planted_here;\n  return 1;\n}\n")
            status, said = self.run_gate("--write")
            self.assertEqual(status, 1, name)
            self.assertIn(f"tidy: {owner}\n", said)
            self.assertIn("'planted_here' is not initialized", said)
            self.assertIn("4 sources, 1 looked at, 1 with warnings", said)
            self.assertNotIn(owner, (self.root / "tests/gates/tidy.txt").read_text())
            self.write(name, FINE[name])
            self.assertEqual(self.run_gate("--write")[0], 0)
        (self.root / "src/app/main.cpp").unlink()
        self.assertEqual(self.run_gate("--write")[0], 0)
        self.assertNotIn("src/app/main.cpp", (self.root / "tests/gates/tidy.txt").read_text())


if __name__ == "__main__":
    unittest.main()
