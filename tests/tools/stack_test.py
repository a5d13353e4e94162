"""tools/check_stack.py on small libraries, each with one property."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tools"))
import check_stack  # noqa: E402

FIRST = '#define OUT __attribute__((noinline))\nextern "C" {\n'


class Stack(unittest.TestCase):
    def worst(self, *sources, root="root", one_archive=False):
        """(bytes, names on the path) of the deepest path from `root`."""
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            members = []
            for number, source in enumerate(sources):
                text = folder / f"{number}" / "same_name.cpp"
                text.parent.mkdir()
                text.write_text(FIRST + source + "\n}\n", encoding="utf-8")
                members.append(text.with_suffix(".o"))
                subprocess.run(["g++", "-O2", "-fno-exceptions", "-fno-asynchronous-unwind-tables", "-fPIC", "-c", text,
                                "-o", members[-1]], check=True)
            archives = []
            for number, content in enumerate([members] if one_archive else [[member] for member in members]):
                archives.append(folder / f"{number}.a")
                subprocess.run(["ar", "qc", archives[-1], *content], check=True)
            program = check_stack.Program(archives)
            size, path = program.worst(program.defined[root][0], root)
            return size, [symbol for symbol, _ in path]

    def refused(self, *sources):
        with self.assertRaises(check_stack.Refused) as caught:
            self.worst(*sources)
        return str(caught.exception)

    def test_the_deeper_of_two_branches_over_two_objects(self):
        size, path = self.worst(
            "void small(int*); void large(int*);\nint root(int x) { int a[10]; if (x) small(a); else large(a); return a[x]; }",
            "OUT void small(int* p) { int volatile b[100]; b[0] = *p; }\n"
            "OUT void large(int* p) { int volatile b[1000]; b[0] = *p; }")
        self.assertEqual(path, ["root", "large"])
        self.assertGreater(size, 4000 + 40)
        self.assertLess(size, 4000 + 40 + 200)

    def test_objects_of_one_name_in_one_archive_are_all_read(self):  # as two folders of a room may have
        size, path = self.worst("void f(int*);\nint root(int x) { int a = x; f(&a); return a + 1; }",
                                "OUT void f(int* p) { int volatile b[500]; b[0] = *p; }", one_archive=True)
        self.assertEqual(path, ["root", "f"])
        self.assertGreater(size, 2000)

    def test_cases_of_a_switch_count(self):
        size, path = self.worst(
            "void f(int*); void g(int*); void h(int*);\n"
            "int root(int x) { int a[2] = {x, 1}; switch (x) { case 0: f(a); a[1] += 7; break; case 1: g(a); a[0]--; break;\n"
            "case 2: f(a); a[0] *= 3; break; case 3: h(a); break; case 4: g(a); a[1] = 9; break; case 5: return 1; }\n"
            "return a[0] + a[1]; }",
            "OUT void f(int* p) { *p += 1; }\nOUT void g(int* p) { *p += 2; }\n"
            "OUT void h(int* p) { int volatile b[500]; b[0] = *p; }")
        self.assertEqual(path, ["root", "h"])
        self.assertGreater(size, 2000)

    def test_a_call_by_pointer_takes_the_deepest_function_whose_address_is_taken(self):
        size, path = self.worst(
            "typedef void (*F)(int*);\nextern const F table[2];\nint root(int x) { int a = x; table[x](&a); return a + 1; }",
            "typedef void (*F)(int*);\nstatic void f(int* p) { *p += 1; }\n"
            "static void g(int* p) { int volatile b[500]; b[0] = *p; }\nextern const F table[2];\nconst F table[2] = {f, g};")
        self.assertEqual(path[0], "root")
        self.assertEqual(len(path), 2)
        self.assertGreater(size, 2000)

    def test_recursion_is_refused(self):
        self.assertIn("recursion: root -> f -> root",
                      self.refused("int f(int);\nOUT int root(int x) { return x > 0 ? f(x - 1) * 3 : 1; }",
                                   "int root(int);\nOUT int f(int x) { return root(x / 2) + 1; }"))

    def test_a_frame_of_unknown_size_is_refused(self):
        self.assertIn("no bound", self.refused(
            "void f(int*);\nint root(int x) { int* p = (int*)__builtin_alloca(x * 4); f(p); return p[0]; }"))

    def test_a_function_of_nobody_is_refused(self):
        self.assertIn("root calls puts", self.refused(
            "int puts(const char*);\nint root() { return 1 + puts(\"x\"); }"))

    def test_the_bound_follows_the_figure(self):
        self.assertIsNone(check_stack.judged(17500, 17520, 24576))
        self.assertIn("more than the committed 17520", check_stack.judged(17521, 17520, 24576))
        self.assertIn("2 % above 17000", check_stack.judged(17000, 17520, 24576))
        self.assertIn("more than 24576", check_stack.judged(24577, 24577, 24576))


if __name__ == "__main__":
    unittest.main()
