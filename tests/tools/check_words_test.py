"""The check of words finds what people read, and only that."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tools"))
import check_words  # noqa: E402


class Words(unittest.TestCase):
    def found(self, name, text):
        return [fault.split(":")[1] for fault in check_words.faults_in(name, text)]

    def test_pages(self):
        page = "# A\nThe driver is told.\n`told` in code\n```\ntold in an example\n```\n    told in a picture\nWhat of it waits\n"
        self.assertEqual(self.found("docs/a.md", page), ["2", "8"])

    def test_comments_and_strings_of_cpp(self):
        source = 'int told = 1;  // a name\nint a;  // the driver is told\n/* one\n that is none */\nconst char* s = "x is gone";\nchar c = \'"\';  // fine\n'
        self.assertEqual(self.found("src/a.cpp", source), ["2", "4", "5"])

    def test_raw_strings(self):
        self.assertEqual(self.found("src/a.cpp", 'auto s = R"(one\nis told)";\nint told;\n'), ["2"])

    def test_python(self):
        source = '"""What it tells."""\ntold = 1\n# was told\nprint(f"{told} told")\n'
        self.assertEqual(self.found("tools/a.py", source), ["1", "3", "4"])

    def test_scripts_and_cmake(self):
        self.assertEqual(self.found("cmake/a.cmake", "set(told 1)\n# it tells\n"), ["2"])
        self.assertEqual(self.found("tools/a", "#!/usr/bin/env bash\ntold=1 # told\n"), ["2"])

    def test_every_phrase_can_be_found(self):
        examples = ["told", "that are none", "is no use", "has not its name", "never heard of", "goes first", "is gone", "What of it",
                    "passed over", "handed on", "held against", "go to standard error", "went wrong", "sent nonsense", "went in.", "mended",
                    "says so in its name", "at the least", "takes it that", "by lot", "has the word", "stands in the table", "as it stands",
                    "knows no packet", "at the most", "for want of room", "in the place of", "found out", "in our own words",
                    "leads somewhere", "monotonous", "handed over", "a defect of ours", "put right", "// Whatever is read",
                    "worked out", "no business", "once more", "truly"]
        for pattern, _ in check_words.COMPILED:
            self.assertTrue(any(pattern.search(e) for e in examples), pattern.pattern)

    def test_whatever_begins_no_sentence(self):
        source = "// Whatever is sent.\n// Sent in order, whatever the mode.\n/// It ends. Whatever follows\nint whatever;\n"
        self.assertEqual(self.found("src/a.cpp", source), ["1", "3"])

    def test_a_train_may_stand(self):
        source = "// The train stands at 300 m.\n// It stands in front of the EOA.\n"
        self.assertEqual(self.found("src/a.cpp", source), ["2"])

    def test_a_tree(self):
        with tempfile.TemporaryDirectory() as name:
            root = pathlib.Path(name)
            (root / "a.md").write_text("It is told.\n", encoding="utf-8")
            (root / "b.bin").write_bytes(b"\xff\xfetold")
            subprocess.run(["git", "init", "-q", root], check=True)
            subprocess.run(["git", "-C", root, "add", "."], check=True)
            faults, looked_at = check_words.check(root)
        self.assertEqual((len(faults), looked_at), (1, 1))


if __name__ == "__main__":
    unittest.main()
