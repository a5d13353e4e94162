"""The checks find what they are for, each shown by a small tree with that one fault."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tools"))
import check_abi  # noqa: E402
import check_layers  # noqa: E402
import check_links  # noqa: E402
import check_readme  # noqa: E402
import check_size  # noqa: E402
import check_tree  # noqa: E402


class Tree(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.root = pathlib.Path(self.folder.name)

    def tearDown(self):
        self.folder.cleanup()

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        return path


class Layers(Tree):
    def breaches(self, name, text):
        self.write(name, text)
        return check_layers.check(self.root)

    def test_allowed(self):
        text = '#include "sdm/curves.h"\n#include <array>\n#include "base/units.h"\n#include "train/brake_model.h"\n'
        self.assertEqual(self.breaches("src/sdm/curves.cpp", text), [])

    def test_arrow_turns_back(self):
        self.assertEqual(self.breaches("src/modes/table.h", '#include "base/units.h"\n#include "kernel/evc.h"\n'),
                         ["src/modes/table.h:2: modes may not include kernel"])

    def test_kernel_room_takes_a_string(self):
        self.assertEqual(self.breaches("src/lang/json.h", "#include <string>\n"),
                         ["src/lang/json.h:1: <string> has no place in a kernel room"])

    def test_a_test_in_a_kernel_room_may_use_strings_but_keeps_the_layers(self):
        text = '#include <string>\n#include "sim/line.h"\n'
        self.assertEqual(self.breaches("src/lang/json_test.cpp", text),
                         ["src/lang/json_test.cpp:2: lang may not include sim"])

    def test_libm_and_exceptions(self):
        text = "// throw nothing\ndouble f(double x) { return std::pow(x, 2); }\nvoid g() { throw 1; }\n"
        found = self.breaches("src/base/f.h", text)
        self.assertEqual([b.split(":")[1] for b in found], ["2", "3"])

    def test_unknown_room(self):
        self.assertEqual(len(self.breaches("src/utils/x.h", "")), 1)

    def test_file_without_room(self):
        self.assertEqual(len(self.breaches("src/base/x.h", '#include "units.h"\n')), 1)

    def test_public_headers_name_public_headers_alone(self):
        self.write("include/openevc/base/units.h", "")
        self.write("src/sdm/tables.h", "")
        text = '#include "openevc/base/units.h"\n#include "sdm/tables.h"\n'
        self.assertEqual(self.breaches("include/openevc/sdm/inputs.h", text),
                         ['include/openevc/sdm/inputs.h:2: "sdm/tables.h" is no public header: "openevc/..." is, in include/'])

    def test_public_headers_belong_to_their_room(self):
        self.write("include/openevc/sdm/inputs.h", "")
        text = '#include "openevc/sdm/inputs.h"\n#include "openevc/evc.h"\n'
        self.assertEqual(self.breaches("src/modes/table.cpp", text),
                         ["src/modes/table.cpp:1: modes may not include sdm",
                          "src/modes/table.cpp:2: modes may not include kernel"])



class Size(Tree):
    def breaches(self, lines, branches=0, listed="", name="src/track/a.cpp"):
        body = "".join(f"  if (a == {i}) return '{{';  // }}\n" for i in range(branches))
        body += "  ++a;\n" * (lines - 2 - branches)
        self.write(name, "namespace x {\n\nint longest(int a) noexcept {\n" + body + "}\n}  // namespace x\n")
        self.write("tools/sizes.txt", listed)
        return check_size.check(self.root)

    def test_function_within_the_rule(self):
        self.assertEqual(self.breaches(60, 25), [])

    def test_function_of_61_lines(self):
        self.assertEqual(self.breaches(61), [
            "src/track/a.cpp:3: longest has 61 lines, 0 branches, expected at most 60 lines or 25 branches"])

    def test_function_of_26_branches(self):
        self.assertEqual(len(self.breaches(30, 26)), 1)

    def test_listed_may_shrink_only(self):
        row = "function src/track/a.cpp longest 70 0"
        self.assertEqual(self.breaches(70, 0, row), [])
        self.assertIn("may shrink only", self.breaches(71, 0, row)[0])
        self.assertIn("write the smaller figure", self.breaches(69, 0, row)[0])
        self.assertIn("the line goes", self.breaches(60, 0, row)[0])

    def test_table_may_grow(self):
        self.assertEqual(self.breaches(90, 0, "function src/track/a.cpp longest 70 0 table"), [])

    def test_file_of_the_kernel(self):
        self.write("tools/sizes.txt", "")
        self.write("src/kernel/a.cpp", "int a;\n" * 301)
        self.write("src/track/b.cpp", "int a;\n" * 301)
        self.assertEqual(check_size.check(self.root), ["src/kernel/a.cpp:1: file has 301 lines, expected at most 300 lines"])

    def test_what_is_a_function(self):
        text = """
struct A : B {
  A() : b{1}, c(2) { if (b) c = 1; }
  bool operator()(int x) const noexcept { return x ? true : false; }
};
template <class T> auto f(T t) -> std::optional<int> { for (;;) { auto g = [&] { while (t) {} }; } }
enum class E { a, b };
const int table[] = {1, 2};
"""
        self.assertEqual([(f[0], f[3]) for f in check_size.functions(text)], [("A", 1), ("operator()", 1), ("f", 2)])


class Prototypes(unittest.TestCase):
    HEADER = "/* OPENEVC_API int openevc_gone(void) OPENEVC_NOEXCEPT; */\nOPENEVC_API const char* openevc_name(void) OPENEVC_NOEXCEPT;\n" \
             "OPENEVC_API openevc_result openevc_read(const uint8_t* bytes, size_t n,\n    char** why) OPENEVC_NOEXCEPT;\n"

    def test_types_of_parameters_without_their_names(self):
        self.assertEqual(check_abi.prototypes(self.HEADER),
                         ["function const char* openevc_name(void)",
                          "function openevc_result openevc_read(const uint8_t*, size_t, char**)"])

    def test_every_function_of_the_header_and_the_list(self):
        header = check_abi.HEADER.read_text(encoding="utf-8")
        found = check_abi.prototypes(header)
        self.assertEqual(len(found), header.count("OPENEVC_API ") - header.count("define OPENEVC_API "))
        listed = check_abi.LIST.read_text(encoding="utf-8").splitlines()
        self.assertEqual([line for line in listed if line.startswith("function ")], found)


class Links(Tree):
    def test_good(self):
        self.write("README.md", "[a](docs/a.md#two-words) [web](https://example.org)\n")
        self.write("docs/a.md", "# A\n## Two words\n[back](../README.md)\n`[code](nowhere)`\n")
        self.assertEqual(check_links.check(self.root), [])

    def test_missing_file_anchor_and_unreached_page(self):
        self.write("README.md", "[a](docs/a.md#three) ![b](docs/b.png)\n")
        self.write("docs/a.md", "# A\n")
        self.write("docs/lost.md", "# Lost\n")
        broken = check_links.check(self.root)
        self.assertEqual(len(broken), 3, broken)


class Readme(unittest.TestCase):
    PAGE = "text\n```console\n$ echo one\none\n$ printf 'a\\nb\\nc\\n' | \\\n  cat\na\n...\n```\n```sh\n$ false\n```\n"

    def test_examples(self):
        found = check_readme.examples(self.PAGE)
        self.assertEqual([(n, e) for n, _, e in found], [(3, ["one"]), (5, ["a", "..."])])
        self.assertEqual(found[1][1], "printf 'a\\nb\\nc\\n' | \\\n  cat")

    def test_matches(self):
        self.assertTrue(check_readme.matches(["one"], "one\n"))
        self.assertTrue(check_readme.matches(["a", "..."], "a\nb\nc\n"))
        self.assertTrue(check_readme.matches(["...", "c [...] e"], "a\nb\nc ddd e\n"))
        self.assertTrue(check_readme.matches([], ""))
        self.assertFalse(check_readme.matches(["one"], "two\n"))
        self.assertFalse(check_readme.matches(["one"], "one\ntwo\n"))
        self.assertFalse(check_readme.matches([], "noise\n"))


class Tracked(Tree):
    def test_faults(self):
        self.write("a.py", "# see /wo" + "rk/main\n# TO" + "DO later\n")
        self.write("b.sh", "#!/bin/sh\n")
        self.write("c.md", "docs/wo" + "rk/x is a relative path, and so is ./ho" + "me/\n")
        subprocess.run(["git", "init", "-q", self.root], check=True)
        subprocess.run(["git", "-C", self.root, "add", "-A"], check=True)
        faults = check_tree.check(self.root)
        self.assertEqual(len(faults), 3, faults)


if __name__ == "__main__":
    unittest.main()
