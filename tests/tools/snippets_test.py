"""What public headers and the page on embedding say: their code compiles, their sizes are right."""
import os
import pathlib
import re
import shutil
import subprocess
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
HEADERS = ROOT / "include/openevc"
# What the reader is expected to have: the names that a snippet does not declare.
GIVEN = {
    "evc.h": "const evc::kernel::Config& config, const evc::kernel::Inputs& inputs, evc::kernel::Outputs& outputs",
    "curves.h": "evc::Speed V, evc::Speed V_ura, evc::Acceleration A_est",
    "language.h": "void refuse(std::size_t, const std::string&), void use(const std::string&)",
    "sim.h": "std::string_view line, std::string_view train, evc::kernel::Unit* unit, evc::kernel::Outputs& outputs",
}


def snippet(header):
    """The indented lines of its first comment."""
    return "\n".join(re.findall(r"^///     (.*)$", header.read_text(encoding="utf-8"), re.M))


def errors(header, code, more=""):
    compiler = next(c for c in (os.environ.get("CXX"), "g++", "clang++-14", "c++") if c and shutil.which(c))
    program = (f"#include <openevc/{header.name}>\n{more}#include <memory>\n#include <string>\n"
               f"void reader({GIVEN[header.name]}) {{\n{code}\n}}\n")
    done = subprocess.run([compiler, "-std=c++20", "-fsyntax-only", "-Wall", "-Wextra", "-Werror", "-Wno-unused-variable",
                           "-Wno-unused-but-set-variable", "-Wno-unused-parameter", "-x", "c++", "-I", ROOT / "include", "-"], input=program, capture_output=True, text=True)
    return done.stderr


class Snippets(unittest.TestCase):
    def test_each_compiles(self):
        with_code = [h for h in sorted(HEADERS.rglob("*.h")) if snippet(h)]
        self.assertEqual({h.name for h in with_code}, set(GIVEN))
        for header in with_code:
            self.assertEqual(errors(header, snippet(header)), "", header.name)

    def test_an_argument_that_is_missing(self):
        header = HEADERS / "curves.h"
        self.assertIn("error", errors(header, snippet(header).replace("*derived, in,", "*derived,")))

    def test_names_in_the_c_header_exist(self):
        text = (HEADERS / "openevc.h").read_text(encoding="utf-8")
        code = re.sub(r"/\*.*?\*/", "", text, flags=re.S)
        comments = " ".join(re.findall(r"/\*.*?\*/", text, re.S))
        missing = {name for name in re.findall(r"\b(?:openevc|OPENEVC)_\w+", comments) if not re.search(rf"\b{name}\b", code)}
        self.assertEqual(missing, set())

    def test_sizes_in_the_page_on_embedding(self):
        page = (ROOT / "docs/embedding.md").read_text(encoding="utf-8")
        types = {"Unit": "evc::kernel::Unit", "sdm::Derived": "evc::sdm::Derived", "openevc_outputs": "openevc_outputs"}
        sizes = {name: re.search(rf"`{name}` (\d+) KiB", page)[1] for name in types}
        code = "".join(f"static_assert((sizeof({type_}) + 512) / 1024 == {sizes[name]});" for name, type_ in types.items())
        headers = "#include <openevc/curves.h>\n#include <openevc/openevc.h>\n"
        self.assertEqual(errors(HEADERS / "evc.h", code, headers), "")


if __name__ == "__main__":
    unittest.main()
