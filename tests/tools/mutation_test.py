"""tools/mutation: a mutant that is chosen at run time does what the same mutant does that is built alone."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tools"))
import mutation.page  # noqa: E402
from mutation import schema, sources  # noqa: E402
from mutation.room import CXX, HERE, Room, rooms_in  # noqa: E402

SOURCE = """\
#include <algorithm>
#include <cstdio>
#include <span>
enum class Kind { a, b, c };
struct Row {
  int id;
  Kind kind;
  int rank = 0;
};
inline constexpr Row kRows[] = {
    {1, Kind::a},  // a comment { with a bracket
    {2, Kind::b},
};
std::span<const Row> rows() { return kRows; }
constexpr double kFactor = 2.5;
constexpr double scaled(double x) { return kFactor * x - 1.0; }
struct Scale {
  static constexpr Row kOne{3, Kind::a};
};
int at(int a, int b, int c) {
  static constexpr Row kNone{0, Kind::b};  // its default cannot be a constant any more
  int n = std::min(a, b) + kNone.id + kNone.rank + (kNone.kind != Scale::kOne.kind ? 0 : Scale::kOne.id);
  if (a < b && b < c || a == c)  // mixed on purpose
    n += c - a;
  else
    n -= 7;
  const bool last = a > 1 ||
                    b >= 2;
  if (last) n = n / 2;
  for (const Row& r : rows())
    if (r.kind != Kind::c) n += r.id * 10;
  return n;
}
int main() {
  double half = 0.1;
  for (int i = 0; i < 4 && half < 2.25; ++i) half += 0.5;
  static int room[3];
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) std::printf("%d ", at(a, b, 2));
  std::printf("%g %g %d %s\\n", half, scaled(3.0), static_cast<int>(sizeof room), true ? "yes && no" : "no");
}
"""


class Mutation(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.tree = pathlib.Path(cls.folder.name)
        cls.path = cls.tree / "source.cpp"
        cls.path.write_text(SOURCE, encoding="utf-8")
        cls.mutants = sources.mutants_of(cls.path, {"Kind": ["a", "b", "c"]})
        for number, mutant in enumerate(cls.mutants, 1):
            mutant.id = number

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def build(self, text, flags=()):
        source = self.tree / "built.cpp"
        source.write_text(text, encoding="utf-8")
        binary = self.tree / "built"
        done = subprocess.run([*CXX, "-std=c++20", "-w", "-fmax-errors=0", *flags, str(source), "-o", str(binary)],
                              capture_output=True, text=True)
        return binary if done.returncode == 0 else None, done.stderr

    @staticmethod
    def says(binary, number=0, notes=""):
        environment = {**os.environ, "EVC_MUTANT": str(number), "EVC_MUTANT_SEEN": notes}
        return subprocess.run([str(binary)], env=environment, capture_output=True, text=True).stdout

    def instrumented(self):
        dropped = set()
        while True:
            text, written = schema.instrumented(SOURCE, self.mutants, dropped, "source.cpp")
            binary, messages = self.build(text, ["-include", str(HERE / "schema.h"), str(HERE / "schema.cpp")])
            if binary:
                return binary, written
            found = schema.blamed(messages, self.tree) - dropped
            self.assertTrue(found, messages)
            dropped |= found

    def test_places(self):
        found = {}
        for m in self.mutants:
            found[m.operator] = found.get(m.operator, 0) + 1
        self.assertEqual(found["row"], 2)
        self.assertEqual(found["cell"], 5)
        self.assertEqual(found["logic"], 4)
        self.assertEqual(found["negate"], 3)
        self.assertEqual(found["delete"], 5)
        self.assertEqual(set(found), {"row", "cell", "number", "compare", "logic", "sign", "factor", "minmax", "negate",
                                      "delete", "truth"})

    def test_together_as_alone(self):
        binary, written = self.instrumented()
        # An array's size has to be a constant; everything else can be chosen.
        self.assertLessEqual({m.what for m in self.mutants if m.id not in written},
                             {"`3` -> `4` in `static int room[3];`"})
        together = {m.id: self.says(binary, m.id) for m in self.mutants if m.id in written}
        unchanged = self.says(binary)
        self.assertEqual(unchanged, self.says(self.build(SOURCE)[0]))
        for m in self.mutants[::6]:
            if m.id in written:
                alone, _ = self.build(SOURCE[:m.start] + m.new + SOURCE[m.end:])
                self.assertEqual(together[m.id], self.says(alone), str(m))
        # A dead instrument would show here: most mutants of this program change what it says.
        self.assertGreater(sum(said != unchanged for said in together.values()), len(together) * 3 // 4)

    def test_few_mutants_of_a_table(self):
        """The gate of tables asks for those of one row: the others stay."""
        row = next(m for m in self.mutants if m.operator == "row" and "Kind::b" in m.what)
        text, written = schema.instrumented(SOURCE, [row], set(), "source.cpp")
        self.assertEqual(written, {row.id})
        binary, messages = self.build(text, ["-include", str(HERE / "schema.h"), str(HERE / "schema.cpp")])
        self.assertTrue(binary, messages)
        unchanged, without_row = self.says(binary), self.says(binary, row.id)
        self.assertEqual(unchanged, self.says(self.build(SOURCE)[0]))
        self.assertEqual(without_row, self.says(self.build(SOURCE[:row.start] + SOURCE[row.end:])[0]))

    def test_what_makes_no_difference_need_not_run(self):
        binary, written = self.instrumented()
        unchanged = self.says(binary)
        with tempfile.NamedTemporaryFile() as notes:
            notes.truncate(len(self.mutants) + 1)
            self.assertEqual(self.says(binary, -1, notes.name), unchanged)
            seen = {number for number, seen in enumerate(notes.read()) if seen}
        self.assertLessEqual(seen, written)
        for m in self.mutants:
            if m.id in written and m.id not in seen:
                self.assertEqual(self.says(binary, m.id), unchanged, str(m))
        missed = {m.what for m in self.mutants if m.id in written - seen}
        self.assertIn("`<` -> `<=` in `for (int i = 0; i < 4 && half < 2.25; ++i) half += 0.5;` (2)", missed)

    def test_pages_of_the_standard(self):
        """Rows of text and of enumerators that stand without their enumeration; assertions are no product."""
        page = """\
#include <array>
#include <cstdio>
enum class Mode { NP, SB, SH };
struct Row {
  Mode mode;
  const char* cells;
};
constexpr bool good(int n) { return n < 3; }
inline constexpr auto page = [] {
  using enum Mode;
  return std::to_array<Row>({
    {NP, "D[1]  U  NR"},
    {SB, "U     U  D[1]"},
  });
}();
static_assert([] {
  for (std::size_t i = 0; i < page.size(); ++i)
    if (static_cast<std::size_t>(page[i].mode) != i) return false;
  return true;
}());
int main() {
  for (const Row& row : page) std::printf("%d %s\\n", static_cast<int>(row.mode), row.cells);
}
"""
        path = self.tree / "page.cpp"
        path.write_text(page, encoding="utf-8")
        mutants = sources.mutants_of(path, {"Mode": ["NP", "SB", "SH"]})
        for number, mutant in enumerate(mutants, 1):
            mutant.id = number
        rows = [m for m in mutants if m.row == "page"]
        self.assertEqual([m.operator for m in rows], ["row", "word", "word", "word", "cell"] * 2)
        self.assertEqual([m.what.split(" in ")[0] for m in rows if m.operator == "cell"], ["`NP` -> `SB`", "`SB` -> `SH`"])
        self.assertEqual({m.line for m in mutants} & set(range(16, 21)), set())
        text, written = schema.instrumented(page, mutants, set(), "page.cpp")
        self.assertEqual({m.id for m in rows} - written, {m.id for m in rows if m.operator == "row"})
        binary, messages = self.build(text, ["-include", str(HERE / "schema.h"), str(HERE / "schema.cpp")])
        self.assertTrue(binary, messages)
        unchanged = "0 D[1]  U  NR\n1 U     U  D[1]\n"
        self.assertEqual(self.says(binary), unchanged)
        said = {self.says(binary, m.id) for m in rows if m.operator != "row"}
        self.assertEqual(len(said - {unchanged}), 8)
        self.assertIn("0 NR  U  NR\n1 U     U  D[1]\n", said)
        self.assertIn("1 D[1]  U  NR\n1 U     U  D[1]\n", said)

    def test_the_page_keeps_its_reasons(self):
        killed = {"file": "src/modes/a.h", "line": 3, "what": "`<` -> `<=` in `a < b`", "verdict": "killed: test"}
        left = {"file": "src/modes/a.h", "line": 5, "what": "`||` -> `&&` in `a || b`", "verdict": "survived"}
        not_run = {"file": "src/modes/a.h", "verdict": "not run"}
        text = mutation.page.page("modes", "", [killed, left, not_run], 10, "")
        self.assertIn("2 of 10 mutants", text)
        self.assertIn("| a.h | 3 | 1 | 1 | 0 | 1 |\n| all | 3 | 1 | 1 | 0 | 1 |", text)
        self.assertIn("| src/modes/a.h:5 | `\\|\\|` -> `&&` in `a \\|\\| b` | **no reason yet** |", text)
        key = ("src/modes/a.h", left["what"])
        self.assertEqual(mutation.page.reasons(text)[key], mutation.page.NO_REASON)
        text = "Words of the page.\n\n" + text[text.index("## Figures"):].replace("**no reason yet**", "equal \\| same")
        again = mutation.page.page("modes", text, [{**left, "line": 7}], 10, " (a sample)")
        self.assertTrue(again.startswith("Words of the page."))
        self.assertIn("| src/modes/a.h:7 | `\\|\\|` -> `&&` in `a \\|\\| b` | equal \\| same |", again)
        self.assertIn("1 of 10 mutants (a sample)", again)
        self.assertIn("## Survivors\nNone.", mutation.page.page("modes", "", [killed], 1, ""))

    def test_of_two_enumerations_with_one_name_what_both_have(self):
        (self.tree / "one.h").write_text("enum class Mode { NP, SB, SH };\n", encoding="utf-8")
        (self.tree / "two.h").write_text("enum class Mode { NP, SB, SM, SH };\n", encoding="utf-8")
        self.assertEqual(sources.enumerators([self.tree])["Mode"], ["NP", "SB", "SH"])

    def test_the_end_of_an_expression_is_no_statement(self):
        text = "  const bool over = a ? b\n                      : f(a, b)\n                            .passed;\n"
        self.assertEqual(list(sources.places(text, {})), [])

    def test_comments_and_literals_are_left_alone(self):
        text = 'f("a && b");  // x && y\n'
        self.assertEqual(list(sources.places(text, {}))[1:], [])
        self.assertEqual(re.sub(r"\s", "", schema.instrumented(text, [], set())[0]), 'f("a&&b");')


class NestedFolders(unittest.TestCase):
    """A room whose files are in folders of stages: two of them may have one name."""
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.src = pathlib.Path(folder.name) / "src"
        self.tree = pathlib.Path(folder.name) / "instrumented"
        self.put("room/state.h", "enum class Mode { FS, OS };\n")
        self.put("room/intake/order.h", "enum class Turn { first, last };\ninline Turn turn() { return Turn::first; }\n")
        self.put("room/intake/seen.h", "inline int seen() { return 1; }\n")  # only a test includes it
        self.put("room/intake/step.cpp", '#include "room/intake/order.h"\nint a(int x) { return x + 1; }\n')
        self.put("room/report/step.cpp", "bool b(Mode m) { return m == Mode::FS; }\n")
        self.put("room/report/step_test.cpp", '#include "room/intake/seen.h"\nint c() { return 2; }\n')
        with unittest.mock.patch.object(sources, "SRC", self.src):
            self.mutants = sources.mutants_of_room(self.src / "room", [])

    def put(self, name, text):
        (self.src / name).parent.mkdir(parents=True, exist_ok=True)
        (self.src / name).write_text(text, encoding="utf-8")

    def test_mutants_of_all_folders(self):
        self.assertEqual({(m.name, m.what.split(" in ")[0]) for m in self.mutants},
                         {("src/room/intake/order.h", "`first` -> `last`"), ("src/room/intake/step.cpp", "`+` -> `-`"),
                          ("src/room/intake/step.cpp", "`1` -> `2`"), ("src/room/report/step.cpp", "`==` -> `!=`"),
                          ("src/room/report/step.cpp", "`FS` -> `OS`")})

    def test_the_instrumented_copy_has_the_same_folders(self):
        room = Room.__new__(Room)
        room.name, room.src, room.tree, room.wanted, room.scenarios = "room", self.src, self.tree, self.mutants, False
        (self.tree / "room/intake").mkdir(parents=True)
        (self.tree / "room/intake/gone.h").write_text("", encoding="utf-8")
        room.write_tree(set())
        self.assertEqual(room.in_schema, {m.id for m in self.mutants})
        for name, mutant in (("intake", "Plus<"), ("report", "Equal<")):
            self.assertIn(mutant, (self.tree / "room" / name / "step.cpp").read_text(encoding="utf-8"))
            self.assertEqual(room.instrumented(self.src / "room" / name / "step.cpp"), self.tree / "room" / name / "step.cpp")
        self.assertFalse((self.tree / "room/intake/gone.h").exists())
        objects = [room.object_name(source) for source in room.sources()]
        self.assertEqual(sorted(objects), ["room_intake_step.o", "room_report_step.o", "room_report_step_test.o"])

    def test_the_page_names_the_folder(self):
        results = [{"file": m.name, "line": m.line, "what": m.what, "verdict": "killed: test"} for m in self.mutants]
        text = mutation.page.page("room", "", results, len(results), "")
        self.assertIn("| intake/step.cpp | 2 | 2 | 0 | 0 | 0 |", text)
        self.assertIn("| report/step.cpp | 2 | 2 | 0 | 0 | 0 |", text)

    def test_rooms_that_a_target_links(self):
        text = "add_library(evc_tries STATIC a.cpp)\ntarget_link_libraries(evc_tries PUBLIC evc_private evc_io\n evc_sim)\n"
        self.assertEqual(rooms_in(text, "evc_tries"), ["io", "sim"])


class Pages(unittest.TestCase):
    """Tables that look like a page of the standard, and what of them changed."""
    TEXT = """\
inline constexpr auto page = [] {
  return std::to_array<Row>({
    {speed, "U  D[1]  NR", false, "a sentence of words", "3.14"},
    {track, "U  U  U",     true,  "another",             "3.8"},
  });
}();
int other = 1;
"""

    def mutants(self):
        with tempfile.TemporaryDirectory() as name:
            path = pathlib.Path(name) / "page.h"
            path.write_text(self.TEXT, encoding="utf-8")
            return [(m.line, m.operator, m.row) for m in sources.mutants_of(path, {})]

    def test_rows_words_and_cells(self):
        self.assertEqual(self.mutants(), [
            (3, "row", "page"), (3, "word", "page"), (3, "word", "page"), (3, "word", "page"), (3, "truth", "page"),
            (4, "row", "page"), (4, "truth", "page"), (7, "number", "")])

    def test_another_mark_of_the_row(self):
        line = '    {speed, "U  D[1]  NR", false},'
        changed = [line[:a] + new + line[b:] for a, b, new in sources.words_of_rows(line)]
        self.assertEqual(changed[1], '    {speed, "U  NR  NR", false},')

    def test_lines_of_a_difference(self):
        diff = ("--- a/src/x/a.h\n+++ b/src/x/a.h\n@@ -3 +3,2 @@ row\n-x\n+y\n+z\n@@ -9,2 +11,0 @@\n-a\n-b\n"
                "--- a/src/x/b.h\n+++ b/src/x/b.h\n@@ -1 +1 @@\n-p\n+q\n--- a/src/x/c.h\n+++ /dev/null\n@@ -1 +0,0 @@\n-r\n")
        self.assertEqual(sources.lines_of_diff(diff), {"src/x/a.h": {3, 4}, "src/x/b.h": {1}})


if __name__ == "__main__":
    unittest.main()
