"""The judgements of tools/campaign_lines and tools/campaign_journeys.py: a run in which nothing happened is no proof."""
import csv
import importlib.machinery
import importlib.util
import json
import pathlib
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent


def load(name="campaign_lines"):
    loader = importlib.machinery.SourceFileLoader(name.removesuffix(".py"), str(ROOT / "tools" / name))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(loader.name, loader))
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


class Journeys(unittest.TestCase):
    SUMMARY = {"confidence_interval_violations": 0, "allocations_in_step": 0, "svl_overrun_m": None, "distance_m": 9000}

    def faults(self, *lines, driver="perfect", taken=frozenset(), **summary):
        return load("campaign_journeys.py").judge({**self.SUMMARY, **summary}, lines, driver, taken)[0]

    @staticmethod
    def line(reasons="", events="", release="null"):
        return f'{{"V_release":{release},"brake_reasons":[{reasons}],"events":[{events}]}}'

    def test_a_journey_without_reactions(self):
        self.assertEqual(self.faults(self.line()), [])

    def test_any_brake_is_a_false_reaction_with_a_perfect_driver(self):
        self.assertEqual(self.faults(self.line('"overspeed: warning"')), ["braked because of overspeed: warning"])
        self.assertEqual(self.faults(self.line('"overspeed: warning"'), driver="late"), [])

    def test_linking_reacts_only_where_balises_are_missing(self):
        braked = self.line('"linking"', '"BG 7 not found in its window [3.16.2.3.1 b]"')
        self.assertEqual(self.faults(braked, driver="late"),
                         ["braked because of linking", "groups [7] are reported, [] were incomplete"])
        self.assertEqual(self.faults(braked, taken={7}), [])
        self.assertEqual(self.faults(braked, taken={8}), ["groups [7] are reported, [8] were incomplete"])

    def test_a_reckless_driver_may_pass_the_supervised_location_only_with_a_release_speed(self):
        passed = ["the true front passed the supervised location by 3 m"]
        self.assertEqual(self.faults(self.line(), driver="late", svl_overrun_m=3), passed)
        self.assertEqual(self.faults(self.line(), driver="reckless", svl_overrun_m=3), passed)
        self.assertEqual(self.faults(self.line(release="15"), driver="reckless", svl_overrun_m=3), [])

    def test_the_front_end_outside_its_interval(self):
        self.assertEqual(self.faults(confidence_interval_violations=2), ["2 cycles outside the confidence interval"])

    def test_identity_of_a_telegram(self):
        module = load("campaign_journeys.py")
        bits = "1" + "0100001" + "0" + "000" + "001" + "00" + "11111111" + "1111101000" + format(2997, "014b") + "1"
        self.assertEqual(module.identity(f"{int(bits.ljust(64, '0'), 2):016X}"), 2997)

    def test_journeys_in_which_nothing_happened(self):
        self.assertEqual(load("campaign_journeys.py").too_little({"km": 1000, "sb": 5, "reported": 50}, 100), 1)


if __name__ == "__main__":
    unittest.main()
