"""tools/measure_ranks: the chart, and the place of the figures in the page. What it measures needs MPI."""
import importlib.machinery
import importlib.util
import pathlib
import sys
import unittest
import xml.etree.ElementTree

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tools"))


def loaded():
    loader = importlib.machinery.SourceFileLoader("measure_ranks", str(ROOT / "tools/measure_ranks"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("measure_ranks", loader))
    loader.exec_module(module)
    return module


class MeasureRanks(unittest.TestCase):
    def setUp(self):
        self.tool = loaded()

    def test_the_chart_has_a_point_a_number_of_ranks(self):
        rates = {1: 100.0, 2: 190.0, 4: 300.0}
        root = xml.etree.ElementTree.fromstring(self.tool.chart(rates, "10 cases, A & B"))
        circles = [child for child in root if child.tag.endswith("circle")]
        x, y = ([float(circle.get(key)) for circle in circles] for key in ("cx", "cy"))
        self.assertEqual(len(circles), 3)
        self.assertEqual(x, sorted(x))
        self.assertEqual(y, sorted(y, reverse=True))
        self.assertIn("10 cases, A & B", [child.text for child in root])

    def test_the_page_has_one_place_for_the_figures(self):
        page = self.tool.PAGE.read_text("utf-8")
        part = self.tool.figures(1000, {1: 20.0, 2: 10.5}, {1: 0.25, 2: 0.3}, "a machine, 2 cores")
        self.assertIn("| 2 | 10.50 s | 0.30 s | 95 | 1.90 |", part)
        once = self.tool.into_page(page, part)
        self.assertIn(part, once)
        # Measured again, the figures are replaced, and nothing else.
        self.assertEqual(self.tool.into_page(once, part), once)
        self.assertEqual(self.tool.into_page(once, ""), self.tool.into_page(page, ""))

    def test_a_page_without_the_place_is_refused(self):
        for text in ("", self.tool.BEGIN, self.tool.END + self.tool.BEGIN, 2 * (self.tool.BEGIN + self.tool.END)):
            with self.assertRaises(SystemExit):
                self.tool.into_page(text, "")


if __name__ == "__main__":
    unittest.main()
