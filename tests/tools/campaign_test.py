"""The judgement of tools/campaign_lines: a run in which nothing happened is no proof."""
import csv
import importlib.machinery
import importlib.util
import json
import pathlib
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent


def load():
    loader = importlib.machinery.SourceFileLoader("campaign_lines", str(ROOT / "tools/campaign_lines"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("campaign_lines", loader))
    loader.exec_module(module)
    return module


COLUMNS = ("t_ms", "mode", "v_kmh", "est_front_m", "min_safe_front_m", "EOA_m", "SvL_m", "V_release", "sb", "eb")


class Judgement(unittest.TestCase):
    def faults(self, rows, violations=0, overrun=None):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            summary = {"confidence_interval_violations": violations, "allocations_in_step": 0, "svl_overrun_m": overrun}
            (folder / "summary.json").write_text(json.dumps(summary), encoding="utf-8")
            with open(folder / "trace.csv", "w", encoding="utf-8", newline="") as file:
                writer = csv.writer(file)
                writer.writerow(COLUMNS)
                writer.writerows(rows)
            return load().judge(folder)[0]

    @staticmethod
    def row(t, mode, v, x, eoa="", sb="false", eb="false", release=""):
        return (t, mode, v, x, x - 5, eoa, eoa, release, sb, eb)

    def test_a_run_that_stops_in_front_of_the_end(self):
        rows = [self.row(0, "FS", 50, 0, 1000), self.row(100, "FS", 60, 500, 1000, sb="true"),
                self.row(200, "FS", 0, 990, 1000)]
        self.assertEqual(self.faults(rows), [])

    def test_a_unit_that_never_leaves_stand_by_proves_nothing(self):
        self.assertEqual(self.faults([self.row(0, "SB", 0, 0), self.row(100, "SF", 0, 0, eb="true")]),
                         ["no authority was supervised", "the train never ran"])

    def test_a_reckless_driver_has_to_be_braked(self):
        self.assertEqual(self.faults([self.row(0, "FS", 50, 0, 1000), self.row(100, "FS", 0, 900, 1000)]),
                         ["the reckless driver was never braked"])

    def test_past_the_end_without_a_trip(self):
        rows = [self.row(0, "FS", 50, 0, 1000, sb="true"), self.row(100, "FS", 10, 1010, 1000, release=15),
                self.row(5000, "FS", 0, 1020, 1000)]
        self.assertTrue(any("passed the end of authority" in f for f in self.faults(rows)))

    def test_past_the_supervised_location_too_fast(self):
        rows = [self.row(0, "FS", 50, 0, 1000, sb="true"), self.row(100, "TR", 40, 1010), self.row(200, "TR", 0, 1030)]
        self.assertTrue(any("supervised location" in f for f in self.faults(rows)))


if __name__ == "__main__":
    unittest.main()
