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

    def test_a_member_that_is_not_there_is_no_null(self):
        self.assertEqual(check_replays.member({"a": [{"b": 1}]}, "a/0/b"), 1)
        self.assertIsNone(check_replays.member({"a": None}, "a"))
        for absent in ("a/0/b", "a/b", "b", "a/0"):
            self.assertIs(check_replays.member({"a": []}, absent), check_replays.ABSENT, absent)
        self.assertFalse(check_replays.same("a", check_replays.ABSENT, None))


class Judged(unittest.TestCase):
    OUTPUTS = [{"t_ms": t, "mode": "SB", "eb": t == 200, "EOA_m": None, "events": ["a"] if t == 100 else []} for t in (0, 100, 200)]

    def faults(self, **expected):
        return check_replays.judge_stream(self.OUTPUTS, {"modes": "SB 0", **expected})

    def test_never_and_always_are_judged_within_their_limits(self):
        self.assertEqual(self.faults(never=[{"events": ["b"]}, {"from": 101, "events": ["a"]}, {"to": 100, "eb": True}]), [])
        self.assertEqual(self.faults(always=[{"to": 100, "eb": False}, {"EOA_m": None}]), [])
        self.assertEqual(len(self.faults(never=[{"events": ["a"]}, {"from": 100, "eb": True}])), 2)
        self.assertEqual(len(self.faults(never=[{"events": ["b", "a"]}])), 1, "one of several is enough")
        self.assertEqual(len(self.faults(always=[{"eb": False}])), 1)

    def test_neither_holds_of_no_cycle_or_of_no_output(self):
        for word in ("never", "always"):
            self.assertEqual(len(self.faults(**{word: [{"from": 300, "eb": True}]})), 1, word)
            self.assertEqual(len(self.faults(**{word: [{"from": 0}]})), 1, word)
            self.assertEqual(len(self.faults(**{word: [{"ebb": None}]})), 1, word)
            self.assertEqual(len(self.faults(**{word: [{"EOA_m/0": 5}]})), 1, word)

    def test_a_fact_of_a_cycle_names_an_output_that_is_there(self):
        self.assertEqual(self.faults(then=[{"t_ms": 0, "EOA_m": None}]), [])
        self.assertEqual(len(self.faults(then=[{"t_ms": 0, "EOA": None}])), 1)
        self.assertEqual(len(self.faults(then=[{"t_ms": 0}])), 1)

    def test_an_event_that_never_occurs_has_to_be_one_that_the_unit_has(self):
        expected = {"one": {"never": [{"events": ["a", "b"]}]}, "two": {"modes": "SB 0"}}
        self.assertEqual(check_replays.never_seen(expected, {"a", "b"}), [])
        self.assertEqual(len(check_replays.never_seen(expected, {"a"})), 1)


if __name__ == "__main__":
    unittest.main()
