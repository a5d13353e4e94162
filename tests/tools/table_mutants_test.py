"""tools/check_table_mutants.py: new and changed rows are looked at, once; a mutant that no test notices fails."""
import contextlib
import io
import pathlib
import sys
import tempfile
import unittest
from unittest import mock

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tools"))
import check_layers  # noqa: E402
import check_table_mutants as gate  # noqa: E402

TABLES = """\
constexpr Row kFirst[] = {
    {1, Kind::a},  // a comment
    {2, Kind::b},
};
constexpr Row kSecond[] = {
    {1, Kind::a},
};
int number = 3;
"""


class TableMutants(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name).resolve()
        for name in ("src/track/tables.cpp", "src/track/track_test.cpp", "src/brakes/brakes_test.cpp"):
            (self.root / name).parent.mkdir(parents=True, exist_ok=True)
            (self.root / name).write_text("", encoding="utf-8")
        self.list = self.root / "table_rows.txt"
        self.looked_at = []
        self.left = []
        for target, name, value in ((gate, "SRC", self.root / "src"), (gate, "ROOT", self.root), (gate, "LIST", self.list),
                                    (gate, "survivors", self.survivors), (check_layers, "KERNEL_ROOMS", ["track", "brakes"])):
            patch = mock.patch.object(target, name, value)
            patch.start()
            self.addCleanup(patch.stop)

    def survivors(self, room, wanted, jobs, largest):
        self.looked_at.append((room, len(wanted), largest))
        return [m for m in gate.mutants_of_room(self.root / "src" / room, []) if m.row and self.left and self.left[0] in m.what]

    def run_gate(self, text, *arguments):
        (self.root / "src/track/tables.cpp").write_text(text, encoding="utf-8")
        self.looked_at = []
        with contextlib.redirect_stdout(io.StringIO()) as said:
            status = gate.main(list(arguments))
        return status, said.getvalue().splitlines()[0]

    def rows(self):
        return sum(len(hashes) for hashes in gate.read(self.list.read_text(encoding="utf-8")).values())

    def test_rows_are_looked_at_once(self):
        self.assertEqual(self.run_gate(TABLES), (0, "table mutants: 3 rows, 3 of them new or changed, 0 mutants survived"))
        self.assertEqual(self.looked_at, [("track", 3, gate.LARGEST)])
        self.assertFalse(self.list.exists())
        self.assertEqual(self.run_gate(TABLES, "--write")[0], 0)
        self.assertEqual(self.looked_at, [("track", 3, None)])
        self.assertEqual(self.rows(), 3)  # the same text in two tables is two rows
        self.assertEqual(self.run_gate(TABLES)[1], "table mutants: 3 rows, 0 of them new or changed, 0 mutants survived")
        self.assertEqual(self.looked_at, [])
        # Blanks, comments and what is no table do not matter; a cell does.
        self.run_gate(TABLES.replace("a comment", "another").replace("{2, ", "{2,  ").replace("= 3", "= 4"))
        self.assertEqual(self.looked_at, [])
        self.run_gate(TABLES.replace("Kind::b", "Kind::a"))
        self.assertEqual(self.looked_at, [("track", 1, gate.LARGEST)])

    def test_a_survivor_fails_and_its_row_is_not_recorded(self):
        self.left = ["{2, Kind::b}"]
        status, said = self.run_gate(TABLES, "--write")
        self.assertEqual(status, 1)
        self.assertEqual(self.rows(), 2)
        self.assertEqual(self.run_gate(TABLES)[0], 1)
        self.assertEqual(self.looked_at, [("track", 1, gate.LARGEST)])

    def test_rows_that_were_there_before_the_gate(self):
        self.assertEqual(self.run_gate(TABLES, "--write", "--unseen")[0], 0)
        self.assertEqual((self.looked_at, self.rows()), ([], 3))

    def test_rows_that_do_not_exist_any_more_leave_the_list(self):
        self.run_gate(TABLES, "--write")
        self.run_gate(TABLES.replace("    {2, Kind::b},\n", ""), "--write")
        self.assertEqual(self.rows(), 2)


if __name__ == "__main__":
    unittest.main()
