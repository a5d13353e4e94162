"""The judgement of tools/check_coverage.py."""
import pathlib
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tools"))
import check_coverage  # noqa: E402


class Judgement(unittest.TestCase):
    FLOORS = {"kernel": 82.0, "sdm": 99.1}

    def faults(self, figures, before=None):
        return check_coverage.faults(self.FLOORS, figures, before or {})

    def test_at_and_a_little_above_the_floor(self):
        self.assertEqual(self.faults({"kernel": 82.0, "sdm": 99.9}, {"kernel": 82.0, "sdm": 99.0, "gone": 50.0}), [])

    def test_below_the_floor(self):
        self.assertEqual(self.faults({"kernel": 81.9, "sdm": 99.1}), ["kernel: 81.9 % are below the floor of 82.0 %"])

    def test_a_floor_that_stayed_behind(self):
        self.assertEqual(self.faults({"kernel": 83.1, "sdm": 99.1}),
                         ["kernel: 83.1 % are well above the floor of 82.0 %: it rises"])

    def test_a_floor_that_fell(self):
        self.assertEqual(self.faults({"kernel": 82.0, "sdm": 99.1}, {"kernel": 82.1}),
                         ["kernel: the floor fell from 82.1 to 82.0 %"])

    def test_a_room_without_a_floor_and_a_floor_without_a_room(self):
        self.assertEqual(self.faults({"terms": 100.0, "sdm": 99.1}),
                         ["kernel: has a floor and was not measured", "terms: has no floor"])

    def test_what_is_written_is_read(self):
        self.assertEqual(check_coverage.read(check_coverage.written(self.FLOORS, {"kernel": 97.0})),
                         (self.FLOORS, {"kernel": 97.0}))


class Rooms(unittest.TestCase):
    def test_tests_and_other_rooms_do_not_count(self):
        self.assertEqual(check_coverage.room_of(ROOT / "src/sdm/curves.cpp"), "sdm")
        self.assertIsNone(check_coverage.room_of(ROOT / "src/sdm/curves_test.cpp"))
        self.assertIsNone(check_coverage.room_of(ROOT / "src/app/run.cpp"))
        self.assertIsNone(check_coverage.room_of("/usr/include/c++/12/array"))


class Declarations(unittest.TestCase):
    SOURCE = """\
namespace evc {
struct Value {  // {
  Speed low{1.0}, high{
      2.0};
  bool valid = true;
  Value(int n) : low{n} {
    valid = n > 0;
  }
  bool usable() const { return valid; }
  friend bool operator==(const Value&, const Value&) = default;
};
constexpr Value kNone{
    0};
int count() {
  return 1;
}
}
"""

    def test_members_and_defaulted_functions_and_no_statement(self):
        self.assertEqual(check_coverage.declarations(self.SOURCE), {1, 2, 3, 4, 5, 10, 11, 12, 13, 17})


if __name__ == "__main__":
    unittest.main()
