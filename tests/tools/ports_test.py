"""tools/check_ports.py finds an input or output of the kernel that the C interface leaves out."""
import pathlib
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tools"))
import check_ports  # noqa: E402


class Ports(unittest.TestCase):
    def without(self, n, *lines):
        """What is found where the source of port n lacks lines."""
        struct, header, of_c, source = check_ports.PORTS[n]
        text = (ROOT / source).read_text(encoding="utf-8")
        for line in lines:
            self.assertEqual(text.count(line), 1, line)
            text = text.replace(line, "")
        with tempfile.TemporaryDirectory() as folder:
            changed = pathlib.Path(folder) / "changed.cpp"
            changed.write_text(text, encoding="utf-8")
            wrong, _ = check_ports.faults([(struct, header, of_c, changed)])
            return {sentence.rpartition(" ")[2] for sentence in wrong}

    def test_an_output(self):
        self.assertEqual(self.without(1, "to.sound_horn = o.sound_horn;", "c.phase = static_cast<std::int32_t>(condition.phase);"),
                         {"Outputs::sound_horn", "openevc_outputs::sound_horn", "ShownCondition::phase", "openevc_condition::phase"})

    def test_an_input(self):
        self.assertEqual(self.without(0, "if (in.radio_from != nullptr) message.from = of(in.radio_from[i]);",
                                      "message.infill_unit = in.radio_from != nullptr && in.radio_from[i].infill_unit == 1;"),
                         {"RadioMessage::from", "RadioMessage::infill_unit", "openevc_inputs::radio_from"})


if __name__ == "__main__":
    unittest.main()
