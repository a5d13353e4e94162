"""tools/check_ends.py: what the uses of a small program are found to be, and the judgement."""
import pathlib
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tools"))
import check_ends  # noqa: E402
import field_uses  # noqa: E402

R, W = field_uses.R, field_uses.W


class Uses(unittest.TestCase):
    HEADER = """
struct Set { int bits; void add(int); bool has(int) const; Set& operator|=(const Set&); };
enum class Cause { a, b, c };
struct Facts { int x = 1; bool y = false; Set set; Cause cause; };
void use(const Set&); void change(Set&); void ask(Cause); int sink(int);
"""

    def uses(self, body):
        with tempfile.TemporaryDirectory() as name:
            source = pathlib.Path(name) / "s.cpp"
            source.write_text(self.HEADER + body, encoding="utf-8")
            unit = field_uses.parsed(source)
            uses = field_uses.Uses()
            uses.all(field_uses.own_declarations(unit, {str(source)}))
        short = lambda usr: usr.split("@")[-1]
        return ({short(k): v for k, v in uses.fields.items()}, {short(k): v for k, v in uses.enumerators.items()},
                {short(k): v for k, v in uses.enums.items()})

    def fields(self, body):
        return self.uses(body)[0]

    def test_assigned_and_read(self):
        self.assertEqual(self.fields("void f(Facts& f) { f.x = 1; }"), {"x": W})
        self.assertEqual(self.fields("int f(Facts& f) { return f.x; }"), {"x": R})
        self.assertEqual(self.fields("void f(Facts& f) { f.x += 2; }"), {"x": W})
        self.assertEqual(self.fields("void f(Facts& f, const Facts& g) { f.y = f.x > 1 || g.y; }"), {"x": R, "y": W})

    def test_what_is_carried_on_to_itself_is_not_read(self):
        self.assertEqual(self.fields("void f(Facts& f, const Facts& g) { f.set |= g.set; f.y = f.y || g.y; }"),
                         {"set": W, "y": W})

    def test_members_and_references(self):
        self.assertEqual(self.fields("void f(Facts& f) { f.set.add(1); }"), {"set": W})
        self.assertEqual(self.fields("bool f(Facts& f) { return f.set.has(1); }"), {"set": R})
        self.assertEqual(self.fields("void f(Facts& f) { use(f.set); }"), {"set": R})
        self.assertEqual(self.fields("void f(Facts& f) { change(f.set); }"), {"set": R | W})
        self.assertEqual(self.fields("void f(Facts& f) { Set& s = f.set; s.add(1); }")["set"], R | W)

    def test_initialisers(self):
        self.assertEqual(self.fields("Facts f() { return {.x = 1}; }"), {"x": W})
        self.assertEqual(self.fields("Facts f() { return Facts{3, true}; }"), {"x": W, "y": W})

    def test_bindings(self):
        for how, body in ((R, "int f(const Facts& g) { const auto& [x, y, s, c] = g; return x; }"),
                          (R, "int f(const Facts& g) { auto [x, y, s, c] = g; return x; }"),
                          (W, "void f(Facts& g) { auto& [x, y, s, c] = g; x = 0; }")):
            found = self.fields(body)
            self.assertEqual({name: found[name] for name in ("x", "y", "set", "cause")},
                             {name: how for name in ("x", "y", "set", "cause")})

    def test_enumerators(self):
        self.assertEqual(self.uses("bool f(Cause c) { return c == Cause::b; }")[1], {"b": R})
        self.assertEqual(self.uses("int f(Cause c) { switch (c) { case Cause::c: return 1; default: return 0; } }")[1],
                         {"c": R})
        self.assertEqual(self.uses("void f() { ask(Cause::b); }")[1], {"b": W})
        self.assertEqual(self.uses("constexpr Cause kTable[] = {Cause::a, Cause::c};")[1], {"a": field_uses.T, "c": field_uses.T})
        self.assertEqual(self.uses("Cause f(int n) { return static_cast<Cause>(n); }")[2], {"Cause": W})
        self.assertEqual(self.uses("int f(Cause c) { return static_cast<int>(c); }")[2], {"Cause": R})


class Judgement(unittest.TestCase):
    LOOSE = {"Facts::x": "only written", "Cause::a": "only asked for"}

    def faults(self, *named):
        return check_ends.faults(self.LOOSE, list(named))

    def test_each_has_a_row(self):
        self.assertEqual(self.faults("Facts::x", "Cause::a"), [])
        self.assertEqual(self.faults("Facts::*", "Cause::a"), [])

    def test_one_without_a_row(self):
        self.assertEqual(self.faults("Facts::x"), ["Cause::a is only asked for, and CAVEATS.md does not name it"])

    def test_a_row_that_is_tied_now(self):
        self.assertEqual(self.faults("Facts::x", "Cause::a", "Facts::y"),
                         ["CAVEATS.md names Facts::y, which is no loose end any more"])

    def test_a_struct_that_was_renamed(self):
        self.assertEqual(len(self.faults("OldFacts::x", "Cause::a")), 2)

    def test_rows_are_found_under_their_heading_only(self):
        text = "| `A::b` | | |\n## Loose ends\n| name | clause | why |\n|---|---|---|\n| `C::d` | 3.1 | x |\n## Next\n| `E::f` | | |\n"
        self.assertEqual(check_ends.rows(text), ["C::d"])


if __name__ == "__main__":
    unittest.main()
