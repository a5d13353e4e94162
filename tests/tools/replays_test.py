"""Tests of tools/check_replays.py."""
import json
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent.parent / "tools"))
import check_replays  # noqa: E402


def reading(t_ms, at_m, speed_mps):
    return json.dumps({"t_ms": t_ms, "odometer": {"nominal_m": at_m, "min_m": at_m - 1, "max_m": at_m + 1, "speed_mps": speed_mps}})


class Filled(unittest.TestCase):
    def counters(self, lines):
        read = [json.loads(line) for line in check_replays.filled(lines)]
        return [(i["t_ms"], i["odometer"]["nominal_m"]) for i in read if "odometer" in i]

    def test_a_gap_of_a_train_that_runs_is_filled_in_proportion_to_the_time(self):
        lines = ['{"config":{"cycle_ms":500}}', reading(1000, 10, 8), '{"t_ms":1700,"driver":{}}', reading(3000, 18, 0)]
        self.assertEqual(self.counters(lines), [(1000, 10), (1500, 12), (2000, 14), (2500, 16), (3000, 18)])

    def test_after_the_last_reading_the_speed_counts(self):
        lines = ['{"config":{"cycle_ms":1000}}', reading(1000, 10, 8), '{"t_ms":3000}']
        self.assertEqual(self.counters(lines), [(1000, 10), (2000, 18), (3000, 26)])

    def test_a_train_that_stands_and_a_short_gap_are_left_alone(self):
        lines = [reading(1000, 10, 0), reading(9000, 10, 8), reading(10000, 18, 8)]
        self.assertEqual(check_replays.filled(lines), lines)

    def test_lines_stay_in_time_order_and_as_they_were(self):
        lines = [reading(1000, 10, 8), '{"t_ms":1250,"train":{}}', reading(3000, 26, 8)]
        filled = check_replays.filled(lines)
        times = [json.loads(line)["t_ms"] for line in filled]
        self.assertEqual(times, sorted(times))
        self.assertTrue(set(lines) <= set(filled))


class Same(unittest.TestCase):
    def test_events_hold_at_least_those_named_and_other_lists_are_equal(self):
        self.assertTrue(check_replays.same("events", ["a", "b"], ["b"]))
        self.assertFalse(check_replays.same("events", ["a"], ["b"]))
        self.assertFalse(check_replays.same("brake_reasons", ["trip", "b"], ["trip"]))

    def test_a_number_is_compared_to_a_decimal_and_null_is_no_number(self):
        self.assertTrue(check_replays.same("V_P", 40.452532, 40.45))
        self.assertFalse(check_replays.same("V_P", 40.6, 40.5))
        self.assertFalse(check_replays.same("V_P", None, 40.5))

    def test_a_member_that_is_not_there_is_none(self):
        self.assertEqual(check_replays.member({"a": [{"b": 1}]}, "a/0/b"), 1)
        self.assertIsNone(check_replays.member({"a": []}, "a/0/b"))


if __name__ == "__main__":
    unittest.main()
