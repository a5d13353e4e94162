"""The judgement of tools/count_instructions.py: more and less than committed fail, and so does what cannot be compared."""
import pathlib
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tools"))
import count_instructions  # noqa: E402


class Judgement(unittest.TestCase):
    COMMITTED = ("g++ 12", {"busy": 10000, "change": 140000})

    def faults(self, **figures):
        return count_instructions.faults(self.COMMITTED, ("g++ 12", figures))

    def test_within_two_percent(self):
        self.assertEqual(self.faults(busy=10200, change=137200), [])

    def test_more_and_less(self):
        self.assertEqual(self.faults(busy=10201, change=137199),
                         ["busy: 10201, committed 10000 (+2.0 %)", "change: 137199, committed 140000 (-2.0 %)"])

    def test_a_figure_without_its_other_half(self):
        self.assertEqual(self.faults(busy=10000, late=1), ["change: was not measured", "late: is not committed"])

    def test_a_limit_that_no_committed_figure_lifts(self):
        slow = ("g++ 12", {"slowest cycle found": 2_000_001})
        self.assertEqual(count_instructions.faults(slow, slow),
                         ["slowest cycle found: 2000001, at most 2000000 are allowed"])

    def test_another_compiler(self):
        found = count_instructions.faults(self.COMMITTED, ("g++ 13", self.COMMITTED[1]))
        self.assertEqual(len(found), 1)
        self.assertIn("cannot be compared", found[0])

    def test_what_is_written_is_read(self):
        self.assertEqual(count_instructions.read(count_instructions.written(*self.COMMITTED)), self.COMMITTED)


if __name__ == "__main__":
    unittest.main()
