"""tools/check_requirements.py finds what it is for: each fault planted in a small tree that is sound without it."""
import contextlib
import io
import pathlib
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tools"))
import check_requirements as check  # noqa: E402

HEAD = "clause,requirement,status,method,where,test,note\n"
GOOD = ('3.4.1.1,Groups have balises,done,test,balise/group.h:Group,Balise.Counts,\n'
        '"3.4.1.2, 3.4.1.3",Two clauses,done,test,balise/group.cpp:count,Balise.*,\n'
        '3.5.1 a,A bullet,done,inspection,balise/group.cpp:count,-,read: nothing else counts\n'
        '3.6.4.2.5 (3.x 3.6.4.3),Moved,part,test,balise/group.h:Group.size,scenario:radio.first_message,half of it\n'
        '4.6.3 [12],A condition,missing,inspection,-,-,not implemented\n')


class Requirements(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.root = pathlib.Path(self.folder.name)
        self.write("src/balise/inner/group.h", "// 3.4.1.1.7, SUBSET-036 4.3.2.5\nstruct Group { int size; };\n")
        self.write("src/balise/group.cpp", 'int count(const Group& g) {\n  return refuse("3.5.1 a"), g.size;\n}\n')
        self.write("src/balise/group_test.cpp", "TEST(Balise, Counts) {\n")
        self.write("tests/scenarios/radio.scenario", "scenario first message\n")
        self.write("CAVEATS.md", "Half of 3.6.4.2.5 is missing, and 4.6.3.\n")
        self.write(".ci/run", "gate layers tools/check_layers.py\n")
        self.write("requirements/clauses.csv", HEAD + GOOD)
        self.write("requirements/seeds.csv", HEAD + "S-001,All,done,test,balise/,gate:layers,\n")
        self.write("requirements/chapter_9.csv", "clause,on-board\n3.4.1.1,x\n3.4.1.3,x\n3.5.1,x\n3.9.9,x\n")
        self.assertEqual(check.write(self.root), 0)

    def tearDown(self):
        self.folder.cleanup()

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def faults(self):
        return check.check(self.root)[0]

    def with_row(self, old, new):
        """Faults of the register with one cell changed; generated files follow it."""
        self.assertIn(old, GOOD)
        self.write("requirements/clauses.csv", HEAD + GOOD.replace(old, new, 1))
        with contextlib.redirect_stdout(io.StringIO()):
            check.write(self.root)
        return self.faults()

    def test_sound(self):
        self.assertEqual(self.faults(), [])
        self.assertEqual(check.check(self.root)[3], ["3.9.9"])

    def test_what_is_not_done_is_in_the_caveats(self):
        self.write("CAVEATS.md", "Half of 3.6.4.2.5 is missing, and 4.6.31.\n")
        self.assertEqual(self.faults(), ["requirements/clauses.csv: 4.6.3 [12] is missing, and CAVEATS.md does not name it"])

    def test_what_4_0_0_has_and_the_unit_has_not_is_told_at_power_up(self):
        only = ('"3.5.9.1, 3.5.9.2",A choice,4.0.0 only,inspection,-,-,not there\n'
                '3.6.9,A place,deliberately otherwise,inspection,-,-,as before 4.0.0\n'
                '3.7.9,Another,deliberately otherwise,inspection,-,-,in each edition\n')
        self.write("requirements/clauses.csv", HEAD + GOOD + only)
        self.write("CAVEATS.md", "Half of 3.6.4.2.5 is missing, and 4.6.3, 3.5.9.1, 3.6.9; 3.7.9.\n")
        row = '    {EditionGap::gap, "%s"_srs, "words"},\n'
        told = "".join(row % n for n in ("3.5.9.1", "3.5.9.2", "3.6.9"))
        self.write(check.EDITION, told)
        self.assertEqual(check.write(self.root), 0)
        self.assertEqual(self.faults(), [])
        self.write(check.EDITION, told.replace("3.5.9.2", "3.7.9") + row % "3.6.9")
        self.assertEqual(self.faults(), [
            "include/openevc/terms/edition_gap.h: 3.6.9 stands twice",
            "include/openevc/terms/edition_gap.h: 3.5.9.2 is not there, and requirements/clauses.csv says that 4.0.0 has it "
            "and the unit has not",
            "include/openevc/terms/edition_gap.h: 3.7.9 is there, and requirements/clauses.csv does not say that 4.0.0 has it "
            "and the unit has not"])
        self.write("CAVEATS.md", "Half of 3.6.4.2.5 is missing, and 4.6.3, 3.6.9.\n")
        self.write(check.EDITION, told)
        self.assertEqual(self.faults(), [
            "requirements/clauses.csv: 3.5.9.1, 3.5.9.2 is 4.0.0 only, and CAVEATS.md does not name it",
            "requirements/clauses.csv: 3.7.9 is deliberately otherwise, and CAVEATS.md does not name it"])

    def test_unknown_test(self):
        self.assertEqual(self.with_row("Balise.Counts", "Balise.Count"),
                         ["requirements/clauses.csv:2: 3.4.1.1: no test Balise.Count"])

    def test_a_disabled_test_is_none(self):
        self.write("src/balise/group_test.cpp", "TEST(Balise, DISABLED_Counts) {\nTEST(Balise, Other) {\n")
        self.assertEqual(self.faults(), ["requirements/clauses.csv:2: 3.4.1.1: no test Balise.Counts"])

    def test_unknown_scenario_and_gate(self):
        self.assertEqual(self.with_row("radio.first_message", "radio.second_message"),
                         ["requirements/clauses.csv:5: 3.6.4.2.5 (3.x 3.6.4.3): no test scenario:radio.second_message"])
        self.write("CAVEATS.md", "Half of 3.6.4.2.5 is missing, and 4.6.3.\n")
        self.write(".ci/run", "gate format tools/check_format\n")
        self.assertIn("requirements/seeds.csv:2: S-001: no test gate:layers", self.faults())
        self.write(".ci/run", "beside layers tools/check_layers.py\n")
        self.assertNotIn("requirements/seeds.csv:2: S-001: no test gate:layers", self.faults())

    def test_an_open_scenario_of_a_clause_that_is_done(self):
        text = 'scenario first message\n  then mode FS [{}]\n\nscenario second\n  open "A1"\n  then mode SH [{}]\n'
        self.write("tests/scenarios/radio.scenario", text.format("3.5.1", "3.4.1.2"))
        self.assertEqual(self.faults(), ['tests/scenarios/radio.scenario:6: "second" is open, and requirements/clauses.csv '
                                         "says done of 3.4.1.2"])
        for sound in ("3.6.4.2.5", "4.6.3(12)", "5.4.4"):
            self.write("tests/scenarios/radio.scenario", text.format("3.5.1", sound))
            self.assertNotIn("requirements/seeds.csv:2: S-001: no test gate:layers", self.faults())

    def test_an_open_scenario_is_no_test(self):
        self.write("tests/scenarios/radio.scenario", 'scenario first message\n  open "A1"\n  then mode FS [4.6.3(12)]\n')
        self.assertEqual(self.faults(),
                         ["requirements/clauses.csv:5: 3.6.4.2.5 (3.x 3.6.4.3): no test scenario:radio.first_message"])

    def test_scenarios_are_added_to_the_rows_of_their_clauses(self):
        self.write("tests/scenarios/radio.scenario", "scenario first message\n  then mode FS [3.5.1]\n  and V_P is 40 [3.4.1.1]\n"
                   "scenario second\n  open\n  then mode SH [3.4.1.1]\n  and mode SB [4.6.3(12)]\n")
        with contextlib.redirect_stdout(io.StringIO()):
            check.add_scenarios(self.root)
            rows = {row["clause"]: row["test"] for row in check.read(self.root, "requirements/clauses.csv")}
        self.assertEqual(rows["3.4.1.1"], "Balise.Counts; scenario:radio.first_message")
        self.assertEqual(rows["3.4.1.2, 3.4.1.3"], "Balise.*")
        self.assertEqual(rows["4.6.3 [12]"], "-")

    def test_missing_code_place(self):
        self.assertEqual(self.with_row("group.h:Group,", "groups.h:Group,"),
                         ["requirements/clauses.csv:2: 3.4.1.1: no file balise/groups.h in the room balise"])
        self.assertEqual(self.with_row("group.h:Group.size", "group.h:Group.weight"),
                         ["requirements/clauses.csv:5: 3.6.4.2.5 (3.x 3.6.4.3): no Group.weight in balise/group.h"])

    def test_places_follow_a_function_that_moved(self):
        self.write("src/balise/counting/counter.cpp", "int count(const Group& g) {\n  return g.size;\n}\n")
        self.write("src/balise/group.cpp", "\n")
        self.assertEqual(len(self.faults()), 2)
        with contextlib.redirect_stdout(io.StringIO()) as said:
            check.fix_places(self.root)
        self.assertIn("2 places followed", said.getvalue())
        self.assertIn(",balise/counting/counter.cpp:count,", (self.root / "requirements/clauses.csv").read_text())
        check.write(self.root)
        self.assertEqual(self.faults(), [])

    def test_a_public_header_belongs_to_its_room(self):
        self.write("include/openevc/balise/group.h", "// 3.4.2.1\nstruct Group { int size; };\n")
        (self.root / "src/balise/inner/group.h").unlink()
        self.assertEqual(self.faults(), ["include/openevc/balise/group.h:1: 3.4.2.1 has no row in requirements/clauses.csv, "
                                         "and no clause above it has"])

    def test_unknown_status_and_method(self):
        found = self.with_row("part,test", "nearly,by eye")
        self.assertEqual([f.split(": ", 2)[2].split(",")[0] for f in found], ["status 'nearly'", "method 'by eye'"])

    def test_a_row_twice(self):
        self.write("requirements/clauses.csv", HEAD + GOOD + GOOD.splitlines(True)[0])
        check.write(self.root)
        self.assertEqual(self.faults(), ["requirements/clauses.csv:7: 3.4.1.1: stands twice"])

    def test_done_needs_a_test_or_what_was_inspected(self):
        self.assertEqual(self.with_row("Balise.Counts", "-"),
                         ["requirements/clauses.csv:2: 3.4.1.1: method test, and no test is named"])
        found = self.with_row("inspection,balise/group.cpp:count,-,read: nothing else counts", "inspection,balise/group.cpp,-,")
        self.assertEqual(len(found), 2)
        self.assertTrue(found[0].endswith("nothing is named that was inspected (file:function)"))
        self.assertTrue(found[1].endswith("the note does not say what was found"))

    def test_part_says_what_lacks(self):
        self.assertEqual(self.with_row("half of it", ""),
                         ["requirements/clauses.csv:5: 3.6.4.2.5 (3.x 3.6.4.3): part, and the note does not say what lacks"])

    def test_a_clause_in_a_text_needs_a_row(self):
        self.write("src/balise/group.cpp", 'int count(const Group& g) {\n  return refuse("3.5.2"), g.size;\n}\n')
        self.assertEqual(self.faults(), ['src/balise/group.cpp:2: "3.5.2" has no row in requirements/clauses.csv'])

    def test_a_clause_in_a_comment_needs_a_row_or_one_above_it(self):
        self.write("src/balise/inner/group.h", "// 3.4.1.1.7, 3.4.2.1, 3.6.0, SUBSET-036 4.3.2.5\nstruct Group { int size; };\n")
        self.assertEqual(self.faults(), ["src/balise/inner/group.h:1: 3.4.2.1 has no row in requirements/clauses.csv, "
                                         "and no clause above it has"])

    def test_more_clauses_without_a_row(self):
        self.write("requirements/chapter_9.csv", "clause,on-board\n3.4.1.1,x\n3.9.8,x\n3.9.9,x\n")
        self.assertIn("requirements/without_row.txt: 2 on-board clauses without a row, 1 before; the number can only fall",
                      self.faults())
        with contextlib.redirect_stdout(io.StringIO()):
            self.assertEqual(check.write(self.root), 1)
        self.assertEqual((self.root / "requirements/without_row.txt").read_text(), "1\n")

    def test_fewer_are_written_down(self):
        self.write("requirements/chapter_9.csv", "clause,on-board\n3.4.1.1,x\n")
        self.assertIn("requirements/without_row.txt: 1, but only 0 on-board clauses are without a row: --write",
                      self.faults())

    def test_a_section_that_is_missing_covers_what_is_below_it(self):
        self.write("requirements/chapter_9.csv", "clause,on-board\n3.4.1.1,x\n3.9.9.1,x\n3.9.9.2,x\n")
        self.assertEqual(len(check.without_row(self.root, self.register(""))), 2)
        self.assertEqual(check.without_row(self.root, self.register("3.9.9,All,missing,inspection,-,-,not implemented\n")), [])
        self.assertEqual(len(check.without_row(self.root, self.register("3.9.9 a,All,missing,inspection,-,-,x\n"))), 2)
        self.assertEqual(len(check.without_row(self.root, self.register("3.9.9,All,part,inspection,-,-,x\n"))), 2)

    def register(self, more):
        self.write("requirements/clauses.csv", HEAD + GOOD + more)
        return check.Register(check.read(self.root, "requirements/clauses.csv"))

    def test_a_clause_is_done_only_with_all_of_its_rows(self):
        rows = "3.9.9 a,A,{},inspection,-,-,x\n3.9.9 b,B,{},inspection,-,-,x\n"
        for first, second, status in (("done", "done", "done"), ("done", "missing", "part"), ("done", "wrong", "wrong"),
                                      ("done", "not applicable", "done"), ("missing", "missing", "missing")):
            self.assertEqual(self.register(rows.format(first, second)).status("3.9.9"), status)
        self.assertIsNone(self.register("").status("3.9.9"))

    def test_generated_files_that_are_old(self):
        self.write("include/openevc/terms/clauses.inc", '"3.4",\n')
        self.write("docs/requirements/clauses_3_4.md", "# 3.4\n")
        self.assertEqual([f.split(":")[0] for f in self.faults()],
                         ["docs/requirements/clauses_3_4.md", "include/openevc/terms/clauses.inc"])

    def test_the_list_for_the_compiler_is_sorted_and_holds_sections(self):
        lines = (self.root / "include/openevc/terms/clauses.inc").read_text().splitlines()[2:]
        self.assertEqual(lines, sorted(lines))
        self.assertEqual(len(lines), len(set(lines)))
        self.assertIn('"3.4.1",', lines)
        self.assertIn('"3.6.4.3",', lines)
        self.assertIn('"4.6.3",', lines)

    def test_columns(self):
        self.write("requirements/seeds.csv", "clause,status\nS-001,done\n")
        with self.assertRaises(SystemExit):
            self.faults()


if __name__ == "__main__":
    unittest.main()
