"""The comparison of two programs over random lines: a difference is found and shown, new fields are none."""
import hashlib
import json
import pathlib
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tools"))
import compare_lines  # noqa: E402
import random_line  # noqa: E402

BEFORE = b'{"t_ms":0,"mode":"SB","driver":{"requests":[],"symbols":["LE01"]},"V_P":80.0,"events":["mode NP->SB [4]"]}\n'


class Comparison(unittest.TestCase):
    def difference(self, after, before=BEFORE):
        try:
            compare_lines.compare_lines(before, after, "outputs")
        except compare_lines.Difference as difference:
            return str(difference)
        return None

    def test_equal(self):
        self.assertIsNone(self.difference(BEFORE))

    def test_new_fields_at_any_depth(self):
        after = BEFORE.replace(b'["LE01"]', b'["LE01"],"texts":[]').replace(b'"events"', b'"messages":[],"events"')
        self.assertIsNone(self.difference(after))

    def test_another_value(self):
        found = self.difference(BEFORE.replace(b"[4]", b"[5]"))
        self.assertIn('line 1, {"t_ms":0', found)
        self.assertIn("events", found)
        self.assertIn('was ["mode NP->SB [4]"]', found)
        self.assertIn('is  ["mode NP->SB [5]"]', found)

    def test_the_same_number_with_other_bytes(self):
        self.assertIn("V_P", self.difference(BEFORE.replace(b"80.0", b"80")))

    def test_a_field_inside_an_object(self):
        self.assertIn("driver: symbols", self.difference(BEFORE.replace(b"LE01", b"LE02")))

    def test_a_missing_field(self):
        self.assertIn("fields were", self.difference(BEFORE.replace(b'"V_P":80.0,', b"")))

    def test_another_order(self):
        self.assertIn("fields were", self.difference(BEFORE.replace(b'"t_ms":0,"mode":"SB"', b'"mode":"SB","t_ms":0')))

    def test_fewer_lines(self):
        self.assertIn("2 lines before, 1 after", self.difference(BEFORE, BEFORE * 2))

    def test_columns(self):
        compare_lines.compare_tables(b"a,b\n1,2\n", b"a,new,b\n1,9,2\n", "trace")
        with self.assertRaisesRegex(compare_lines.Difference, "line 2: b was '2', is '3'"):
            compare_lines.compare_tables(b"a,b\n1,2\n", b"a,b\n1,3\n", "trace")

    def test_nothing_seen_is_no_proof(self):
        self.assertTrue(compare_lines.Seen().faults(1))
        self.assertTrue(any("modes" in fault for fault in compare_lines.Seen().faults(100)))


class Generator(unittest.TestCase):
    def test_the_same_seed_gives_the_same_line(self):
        text = "".join(json.dumps(random_line.RandomLine(seed).description()) for seed in range(20))
        self.assertEqual(hashlib.sha256(text.encode()).hexdigest()[:16], "bc28fb9e7308f92e", "another line from the same seed: recorded campaigns mean others now")

    def test_the_kinds_of_line(self):
        levels, orders, messages = set(), set(), set()
        for seed in range(100):
            line = random_line.RandomLine(seed).description()
            levels |= set(line["about"].split()[1:]) - {">"}
            for place in line["groups"] + line["radio"]:
                orders |= {key for order in place.get("orders", []) for key in order}
                messages |= {place["message"]["NID_MESSAGE"]} if "message" in place else set()
        self.assertEqual(levels, {"0", "1", "2", "NTC"})
        self.assertEqual(messages, {2, 6, 9, 15, 16, 18, 33, 34})
        self.assertLessEqual({"authority", "infill", "mode_profile", "temporary_speed_restriction", "text", "packet", "session"}, orders)


if __name__ == "__main__":
    unittest.main()
