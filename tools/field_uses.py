"""Which fields and enumerators product code reads, writes, produces and asks for, found with libclang in every source.
Checked are all structs and enumerations of the kernel rooms, except those of the language and the air gap (bits in,
bits out). Uses count in all rooms, including io, sim and app, but not in tests.

A field is written by an assignment, an initialiser with its name or in its place, a member function that changes; it is
read by everything else; `auto& [a, b] = x` only writes. An update of a field from the same field (`a.x |= b.x`), a
comparison that is defaulted and a default value are neither. An enumerator is asked for by a comparison, a case, a row of a constant table or a membership
question, and produced by everything else; a cast from a number produces all of an enumeration, a cast to a number asks
for all. What a source does is kept in EVC_ENDS_CACHE (default: ~/.cache/openevc-ends) while nothing that it is made of
changes. Used by tools/check_ends.py."""
import collections
import concurrent.futures
import functools
import json
import os
import pathlib
import re
import sys
import tempfile

import check_layers
from included import FOLDERS, fingerprint

try:
    import clang.cindex as cindex
except ModuleNotFoundError:  # Debian's package, another python
    sys.path.append("/usr/lib/python3/dist-packages")
    import clang.cindex as cindex

K = cindex.CursorKind
ROOT = pathlib.Path(__file__).resolve().parent.parent
CACHE = pathlib.Path(os.environ.get("EVC_ENDS_CACHE", pathlib.Path.home() / ".cache/openevc-ends"))
ROOMS = [room for room in check_layers.KERNEL_ROOMS if room not in ("lang", "airgap")]
# Enumerators that stand for the absence of the others: nobody need ask for them. And A.3.1 is constants.
NEUTRAL = {"count", "none", "nothing", "no", "unchanged", "unknown"}
CONSTANTS = {"train::FixedValues"}
NUMBERS = ("packet::", "message::")  # names of numbers of chapter 7: what is read and written is a number
MUTATORS = set("push_back insert clear emplace emplace_back reset assign set add erase erase_if pop_back resize remove "
               "append truncate try_emplace swap".split())
HANDLES = set("value front back begin end data at operator[] operator* operator-> get".split())  # what is done with the result counts
MEMBERSHIP = set("has contains has_any is one_of any_of is_one_of count find".split())
ASSIGNING = {f"operator{o}=" for o in ("", "+", "-", "*", "/", "|", "&", "^", "<<", ">>", "%")}
COMPARING = {"operator==", "operator!=", "operator<", "operator>", "operator<=", "operator>=", "operator<=>"}
R, W, T = 1, 2, 4  # read or asked for, written or produced, in a constant table


@functools.lru_cache(maxsize=None)
def contents(name):
    return pathlib.Path(name).read_bytes()


def text_of(begin, end):
    """Source text between two locations of one file, without comments."""
    if begin.file is None or end.file is None or begin.file.name != end.file.name:
        return ""
    text = contents(begin.file.name)[begin.offset:end.offset].decode("utf-8", "replace")
    return re.sub(r"//[^\n]*|/\*.*?\*/", " ", text, flags=re.S)


def is_const(type_):
    return type_.is_const_qualified()


def refers_to_changeable(type_):
    t = type_.get_canonical()
    if t.kind == cindex.TypeKind.RVALUEREFERENCE:
        return False
    if t.kind in (cindex.TypeKind.LVALUEREFERENCE, cindex.TypeKind.POINTER):
        return not is_const(t.get_pointee())
    return False


class Uses:
    """What one translation unit does with fields and enumerators: USR -> R | W bits."""
    def __init__(self):
        self.fields, self.enumerators, self.enums = {}, {}, {}
        # What a template takes from an object whose type it does not know: {"from to": R | W}. It counts for every struct
        # that has all these members.
        self.by_name = {}
        self.templates = [""]  # where the functions around begin
        self.unknown = {}  # (function, object) -> names
        self.in_table = 0
        self.assigned = []  # fields on the left of the assignments around

    def note_field(self, cursor, how):
        if cursor.get_usr() in self.assigned:
            return
        key = cursor.get_usr()
        self.fields[key] = self.fields.get(key, 0) | how

    def note_enumerator(self, cursor, how):
        key = cursor.get_usr()
        self.enumerators[key] = self.enumerators.get(key, 0) | how

    def note_enum(self, type_, how):
        declaration = type_.get_canonical().get_declaration()
        if declaration.kind == K.ENUM_DECL:
            key = declaration.get_usr()
            self.enums[key] = self.enums.get(key, 0) | how

    def all(self, cursors, how=R, asked=False):
        for c in cursors:
            self.visit(c, how, asked)

    def visit(self, c, how=R, asked=False):
        """`how`: what is done with the value of this expression; `asked`: it is part of a comparison or condition."""
        kind = c.kind
        handler = HANDLERS.get(kind)
        if kind in FUNCTIONS:
            self.templates.append(f"{c.location.file}:{c.location.offset}")
            self.all(c.get_children(), R, False) if handler is None else handler(self, c, how, asked)
            self.templates.pop()
        elif handler:
            handler(self, c, how, asked)
        elif kind in PASSING:
            self.all(c.get_children(), how, asked)
        else:
            self.all(c.get_children(), R, False)

    def close(self):
        """What was noted of objects of unknown type, by the names alone."""
        for names in self.unknown.values():
            self.by_name[" ".join(sorted(names))] = R | W
        self.unknown = {}

    def member(self, c, how, asked):
        field = c.referenced
        children = list(c.get_children())
        if field is None:
            text = text_of(c.extent.start, c.extent.end)
            name = re.search(r"(\w+)\s*$", text)
            member = c.spelling or (name[1] if name else "")
            of = re.sub(r"\s|(\.|->)\s*(template\s+)?\w*\s*$", "", text[:len(text) - len(member)])
            self.unknown.setdefault((self.templates[-1], of), set()).add(member)
        elif field.kind == K.FIELD_DECL:
            self.note_field(field, how)
        elif field.kind == K.ENUM_CONSTANT_DECL:
            self.note_enumerator(field, R if asked else W)
        for child in children:
            through_pointer = child.type.get_canonical().kind == cindex.TypeKind.POINTER
            self.visit(child, R if through_pointer else how)

    def reference(self, c, how, asked):
        target = c.referenced
        if target is None:
            return
        if target.kind == K.ENUM_CONSTANT_DECL:
            self.note_enumerator(target, R if asked else T if self.in_table else W)
        elif target.kind == K.FIELD_DECL:  # a pointer to member, or a designated initialiser
            self.note_field(target, how)

    def binary(self, c, how, asked):
        children = list(c.get_children())
        if len(children) != 2:
            return self.all(children)
        left, right = children
        operator = text_of(left.extent.end, right.extent.start).strip().strip("()").strip()
        if operator.startswith("=") and not operator.startswith("=="):
            return self.assignment(left, [right], W)
        comparing = operator.startswith(("==", "!=", "<", ">")) and not operator.startswith(("<<", ">>"))
        self.visit(left, R, comparing)
        self.visit(right, R, comparing)
        return None

    def compound(self, c, how, asked):
        children = list(c.get_children())
        self.assignment(children[0], children[1:], W)

    def assignment(self, left, rest, how):
        self.visit(left, how)
        target = left
        while target.kind in PASSING and target.kind != K.MEMBER_REF_EXPR:
            inner = list(target.get_children())
            if len(inner) != 1:
                break
            target = inner[0]
        is_field = target.kind == K.MEMBER_REF_EXPR and target.referenced and target.referenced.kind == K.FIELD_DECL
        self.assigned.append(target.referenced.get_usr() if is_field else "")
        self.all(rest)
        self.assigned.pop()

    def unary(self, c, how, asked):
        children = list(c.get_children())
        if not children:
            return
        text = text_of(c.extent.start, c.extent.end).strip()
        if text.startswith("&"):
            target = children[0]
            to_member = target.kind == K.DECL_REF_EXPR and target.referenced is not None \
                and target.referenced.kind == K.FIELD_DECL
            # A pointer to member may be what a table of members writes through.
            self.visit(target, R if not to_member and is_const(target.type) else R | W)
        elif text.startswith(("++", "--")) or text.endswith(("++", "--")):
            self.visit(children[0], W)
        else:
            self.visit(children[0], how if text.startswith("*") else R, asked)

    def call(self, c, how, asked):
        children = list(c.get_children())
        function = c.referenced
        if function is None:
            if children and children[0].kind == K.MEMBER_REF_EXPR:
                name = children[0].spelling
                self.all(children[0].get_children(), W if name in MUTATORS else R | W)
                return self.all(children[1:], R | W if name not in MEMBERSHIP else R, name in MEMBERSHIP)
            return self.all(children, R | W if children and children[0].kind != K.INIT_LIST_EXPR else R)
        name = function.spelling
        if name in ASSIGNING and len(children) >= 2 and children[0].kind != K.MEMBER_REF_EXPR or \
                name in ASSIGNING and children and children[0].referenced is not None \
                and children[0].referenced.kind == K.FIELD_DECL:
            rest = [x for x in children[1:] if x.referenced is None or x.referenced.spelling != name]
            return self.assignment(children[0], rest, W)
        if name in COMPARING:
            if re.search(r"=\s*default\s*$", text_of(function.extent.start, function.extent.end)):
                for argument in children:
                    self._note_all(argument.type, R)
            return self.all(children, R, True)
        if function.kind == K.CONSTRUCTOR:
            return self.all(children, R, asked)
        if name.startswith("operator") and not re.match(r"operator\w", name) and children and \
                function.kind == K.CXX_METHOD and not self._is_method_reference(children[0], function):
            self.visit(children[0], how if name in HANDLES else R if function.is_const_method() else R | W, asked)
            return self.all(children[1:])
        is_member = children and self._is_method_reference(children[0], function)
        rest = children
        if is_member:
            if function.is_const_method() or function.is_static_method():
                on = how if name in HANDLES else R
            elif name in MUTATORS:
                on = W
            elif name in HANDLES:
                on = how
            else:
                on = R | W
            reference = self._unwrapped(children[0])
            for x in reference.get_children():
                pointer = x.type.get_canonical().kind == cindex.TypeKind.POINTER
                self.visit(x, R if pointer else on)
            rest = children[1:]
        elif children and children[0].kind in (K.UNEXPOSED_EXPR, K.DECL_REF_EXPR) and \
                children[0].referenced is not None and children[0].referenced == function:
            rest = children[1:]
        type_ = function.type.get_canonical()
        if type_.kind in (cindex.TypeKind.POINTER, cindex.TypeKind.LVALUEREFERENCE):
            type_ = type_.get_pointee()
        parameters = list(type_.argument_types()) if type_.kind == cindex.TypeKind.FUNCTIONPROTO else []
        question = name in MEMBERSHIP or name.startswith(("is_", "has_"))
        for number, argument in enumerate(rest):
            changes = number < len(parameters) and refers_to_changeable(parameters[number])
            self.visit(argument, R | W if changes else R, question)
        return None

    def _unwrapped(self, c):
        while c.kind in (K.UNEXPOSED_EXPR, K.PAREN_EXPR):
            inner = list(c.get_children())
            if len(inner) != 1:
                return c
            c = inner[0]
        return c

    def _is_method_reference(self, c, function):
        c = self._unwrapped(c)
        return c.kind == K.MEMBER_REF_EXPR and c.referenced is not None and c.referenced.kind == function.kind and \
            c.referenced.spelling == function.spelling and function.kind in (K.CXX_METHOD, K.CONVERSION_FUNCTION, K.FUNCTION_TEMPLATE)

    def variable(self, c, how, asked):
        children = list(c.get_children())
        outer = c.semantic_parent is not None and c.semantic_parent.kind in (K.NAMESPACE, K.TRANSLATION_UNIT, K.STRUCT_DECL, K.CLASS_DECL)
        is_table = (outer or c.storage_class == cindex.StorageClass.STATIC) and (is_const(c.type) or "constexpr" in text_of(c.extent.start, c.location))
        self.in_table += is_table
        self.all(children, R | W if refers_to_changeable(c.type) else R)
        self.in_table -= is_table

    def init_list(self, c, how, asked):
        children = list(c.get_children())
        declaration = c.type.get_canonical().get_declaration()
        fields = []
        if declaration.kind in (K.STRUCT_DECL, K.CLASS_DECL):
            fields = [f for f in declaration.get_children() if f.kind == K.FIELD_DECL]
        for number, child in enumerate(children):
            inner = list(child.get_children())
            if inner and inner[0].kind == K.MEMBER_REF:  # .name = value
                for x in inner:
                    if x.kind == K.MEMBER_REF:
                        self.note_field(x.referenced, W)
                    else:
                        self.visit(x)
                continue
            if number < len(fields) and len(children) <= len(fields):
                bound = refers_to_changeable(fields[number].type)  # a reference: who has it may do both
                self.note_field(fields[number], R | W if bound else W)
                self.visit(child, R | W if bound else R)
                continue
            self.visit(child)

    def range_for(self, c, how, asked):
        children = list(c.get_children())
        variable = children[0]
        changes = variable.kind == K.VAR_DECL and refers_to_changeable(variable.type)
        if variable.kind != K.VAR_DECL:
            self.bindings(variable)
        for x in children[1:-1]:
            self.visit(x, R | W if changes else R)
        for x in (variable, children[-1]):
            self.all(x.get_children()) if x is variable else self.visit(x)

    def bindings(self, c, how=R):
        """auto [a, b] = x reads all fields of x."""
        for x in c.walk_preorder():
            self._note_all(x.type, how)

    def _note_all(self, type_, how):
        t = type_.get_canonical()
        if t.kind in (cindex.TypeKind.LVALUEREFERENCE, cindex.TypeKind.RVALUEREFERENCE):
            t = t.get_pointee()
        declaration = t.get_declaration()
        if declaration.kind == K.STRUCT_DECL:
            for f in declaration.get_children():
                if f.kind == K.FIELD_DECL:
                    self.note_field(f, how)

    def statement(self, c, how, asked):
        for x in c.get_children():
            bound = re.match(r"([\w\s]*)\bauto\b([\s&]*)\[", text_of(x.extent.start, x.extent.end))
            if x.kind in (K.UNEXPOSED_DECL, K.VAR_DECL) and bound:
                # What is bound by name to be changed is no reader: the function that resets all members.
                self.bindings(x, W if "&" in bound[2] and "const" not in bound[1] else R)
            self.visit(x)

    def case(self, c, how, asked):
        children = list(c.get_children())
        self.visit(children[0], R, True)
        self.all(children[1:])

    def cast(self, c, how, asked):
        children = list(c.get_children())
        of = next((x for x in reversed(children) if x.kind.is_expression()), None)
        if of is not None:
            to, source = c.type.get_canonical(), of.type.get_canonical()
            if to.kind == cindex.TypeKind.ENUM and source.kind != cindex.TypeKind.ENUM:
                self.note_enum(to, W)
            elif source.kind == cindex.TypeKind.ENUM and self._unwrapped(of).kind not in (K.DECL_REF_EXPR,) or \
                    source.kind == cindex.TypeKind.ENUM and self._unwrapped(of).referenced.kind != K.ENUM_CONSTANT_DECL:
                self.note_enum(source, R)
                if to.kind == cindex.TypeKind.ENUM:
                    self.note_enum(to, W)
        self.all(children, how, asked)

    def conditional(self, c, how, asked):
        children = list(c.get_children())
        self.visit(children[0])
        self.all(children[1:], how, asked)

    def constructor(self, c, how, asked):
        for x in c.get_children():
            if x.kind == K.MEMBER_REF and x.referenced.kind == K.FIELD_DECL:
                self.note_field(x.referenced, W)
            else:
                self.visit(x)

    def function(self, c, how, asked):
        text = text_of(c.extent.start, c.extent.end)
        if not re.search(r"=\s*default$", text.strip()):
            self.all(c.get_children())

    def field_declaration(self, c, how, asked):
        """A default value: what it says counts, not that it is there."""
        self.all(c.get_children())

    def nothing(self, c, how, asked):
        pass


PASSING = {K.UNEXPOSED_EXPR, K.PAREN_EXPR, K.ARRAY_SUBSCRIPT_EXPR}
FUNCTIONS = {K.FUNCTION_TEMPLATE, K.FUNCTION_DECL, K.CXX_METHOD, K.CONSTRUCTOR, K.LAMBDA_EXPR}
HANDLERS = {
    K.MEMBER_REF_EXPR: Uses.member, K.DECL_REF_EXPR: Uses.reference, K.MEMBER_REF: Uses.reference,
    K.BINARY_OPERATOR: Uses.binary, K.COMPOUND_ASSIGNMENT_OPERATOR: Uses.compound, K.UNARY_OPERATOR: Uses.unary,
    K.CALL_EXPR: Uses.call, K.VAR_DECL: Uses.variable, K.INIT_LIST_EXPR: Uses.init_list,
    K.CXX_FOR_RANGE_STMT: Uses.range_for, K.DECL_STMT: Uses.statement, K.CASE_STMT: Uses.case,
    K.CXX_STATIC_CAST_EXPR: Uses.cast, K.CXX_FUNCTIONAL_CAST_EXPR: Uses.cast, K.CSTYLE_CAST_EXPR: Uses.cast,
    K.CONDITIONAL_OPERATOR: Uses.conditional, K.CONSTRUCTOR: Uses.constructor, K.CXX_METHOD: Uses.function,
    K.FUNCTION_DECL: Uses.function, K.FIELD_DECL: Uses.field_declaration, K.ENUM_DECL: Uses.nothing,
    K.CXX_UNARY_EXPR: Uses.nothing,
}


def is_product(path):
    return not check_layers.is_test(path) and path.suffix in (".cpp", ".h")


# Rooms that know none of what is looked at but base.
LEFT_OUT = {"lang", "airgap"}
# Built on request only, with headers of their own libraries (Python, MPI) that may not be installed.
ON_REQUEST = {"python", "cluster"}


def room_of(path, folder):
    return path.relative_to(ROOT / folder).parts[0]


def headers():
    """Of all rooms but app, whose headers are not made to stand together."""
    return [p for folder in ("src", "include/openevc") for p in sorted((ROOT / folder).rglob("*/*.h"))
            if is_product(p) and room_of(p, folder) not in {"app", *ON_REQUEST} and p.parent.parent.name != "lang"]


def sources():
    return [p for p in sorted((ROOT / "src").rglob("*/*.cpp")) if is_product(p) and room_of(p, "src") not in LEFT_OUT | ON_REQUEST]


RULES = "6"  # a new number where what is found in a source changes
FLAGS = ["-std=c++20", *(f"-I{ROOT / folder}" for folder in FOLDERS),
         f"-I{CACHE / 'generated'}", "-w", "-ffp-contract=off", '-DEVC_DATA_DIR=""', '-DEVC_VERSION=""']


def parsed(source, flags=()):
    unit = cindex.Index.create().parse(str(source), args=[*FLAGS, *flags])
    errors = [d for d in unit.diagnostics if d.severity >= cindex.Diagnostic.Error]
    if errors:
        raise RuntimeError(f"{source}: {errors[0]}")
    return unit


def own_declarations(unit, files):
    """Declarations of the outer level and inside namespaces whose file is one of `files`."""
    work = list(unit.cursor.get_children())
    for c in work:
        if c.location.file is not None and c.location.file.name in files:
            yield c


def uses_of(source):
    """What a source does, by the cache where nothing that it is made of changed."""
    kept = CACHE / fingerprint(source, RULES)
    if kept.exists():
        return json.loads(kept.read_text(encoding="utf-8"))
    own = {str(source)} | ({str(h) for h in source.parent.glob("*.h")} if source.parent.name == "app" else set())
    uses = Uses()
    uses.all(own_declarations(parsed(source), own))
    uses.close()
    found = [uses.fields, uses.enumerators, uses.enums, uses.by_name]
    part = kept.with_suffix(f".{os.getpid()}")
    part.write_text(json.dumps(found), encoding="utf-8")
    part.replace(kept)
    return found


def declared(unit):
    """{USR: (kind, name, room, enumeration, header)} of the fields and enumerators that are looked at."""
    found = {}
    rooms = {str(ROOT / folder / room): room for folder in ("src", "include/openevc") for room in ROOMS}

    def room_declaring(name):
        """The room whose folder, or a folder of it, holds the header; None for others."""
        folder = os.path.dirname(name)
        return rooms.get(folder) or rooms.get(os.path.dirname(folder))

    def look(c, path):
        for x in c.get_children():
            file = x.location.file
            room = room_declaring(file.name) if file else None
            if file is None or x.kind != K.NAMESPACE and room is None:
                continue
            if x.kind in (K.NAMESPACE, K.STRUCT_DECL, K.CLASS_DECL):
                look(x, path + [x.spelling] if x.spelling not in ("", "evc") else path)
            elif x.kind == K.FIELD_DECL and c.kind == K.STRUCT_DECL and x.spelling:
                found[x.get_usr()] = ("field", "::".join(path + [x.spelling]), room, None, file.name)
            elif x.kind == K.ENUM_DECL:
                for e in x.get_children():
                    if e.kind == K.ENUM_CONSTANT_DECL:
                        found[e.get_usr()] = ("enumerator", "::".join(path + [x.spelling, e.spelling]), room, x.get_usr(),
                                              file.name)
    look(unit.cursor, [])
    return found


def families(unit):
    """{struct: sets of names of members}: its own with those of its bases, and those of each struct derived from it."""
    bases, own = {}, collections.defaultdict(set)

    def look(c, path):
        for x in c.get_children():
            if x.kind in (K.NAMESPACE, K.STRUCT_DECL, K.CLASS_DECL):
                here = path + [x.spelling] if x.spelling not in ("", "evc") else path
                look(x, here)
                own["::".join(here)] |= {m.spelling for m in x.get_children() if m.kind in (K.FIELD_DECL, K.CXX_METHOD)}
                found = [b.type.get_canonical().spelling.removeprefix("evc::") for b in x.get_children()
                         if b.kind == K.CXX_BASE_SPECIFIER]
                if found:
                    bases["::".join(here)] = found
    look(unit.cursor, [])

    def whole(struct):
        return own.get(struct, set()).union(*(whole(b) for b in bases.get(struct, ())))
    together = {struct: [whole(struct)] for struct in own}
    for derived, above in bases.items():
        work = list(above)
        for base in work:
            work += bases.get(base, [])
            if base in together:
                together[base].append(whole(derived))
    return together


def in_kernel_rooms(path):
    folder = "src" if (ROOT / "src") in path.parents else "include/openevc"
    return room_of(path, folder) in ROOMS


def by_template(name, together, uses):
    """What templates do with a field: those that take it from an object of which this struct has all other members."""
    struct, _, field = name.rpartition("::")
    how = 0
    for names, done in uses.by_name.items():
        wanted = set(names.split())
        if field in wanted and any(wanted <= members for members in together[struct]):
            how |= done
    return how


def of_field(key, name, header, inside, outside, together):
    """What is done with a field. Nobody but the kernel reads an input, and the kernel reads no output: the reader, the
    writer and the recorder of input streams count as what they are."""
    within, without = (uses.fields.get(key, 0) | by_template(name, together, uses)
                       for uses in (inside, outside))
    if header.endswith("port/inputs.h"):
        return within | without & W
    if header.endswith("port/outputs.h"):
        return within & W | without
    return within | without


def loose_ends():
    """Sorted rows (room, name, what) of all that is loose, and how many fields and enumerators were looked at."""
    # The build makes this one (src/kernel/CMakeLists.txt); its number does not matter here.
    layout = CACHE / "generated/kernel/state_layout.h"
    layout.parent.mkdir(parents=True, exist_ok=True)
    layout.write_text("#pragma once\n#define EVC_STATE_LAYOUT 0u\n", encoding="utf-8")
    with tempfile.TemporaryDirectory() as name, \
            concurrent.futures.ProcessPoolExecutor(int(os.environ.get("JOBS", os.cpu_count()))) as pool:
        files = sources()
        parts = pool.map(uses_of, files, chunksize=2)
        whole = pathlib.Path(name) / "all.h"
        lines = "".join(f'#include "{h}"\n' for h in headers())
        whole.write_text(lines, encoding="utf-8")
        unit = parsed(whole, ["-x", "c++-header"])
        known = declared(unit)
        inside, outside = Uses(), Uses()  # of the kernel rooms
        for uses, kernel in ((inside, True), (outside, False)):
            uses.all(own_declarations(unit, {str(h) for h in headers() if in_kernel_rooms(h) == kernel}))
            uses.close()
        for file, part in zip(files, parts):
            uses = inside if in_kernel_rooms(file) else outside
            for whole_map, found in zip((uses.fields, uses.enumerators, uses.enums, uses.by_name), part):
                for key, how in found.items():
                    whole_map[key] = whole_map.get(key, 0) | how
    together = families(unit)
    rows = []
    for key, (kind, name, room, enum, header) in known.items():
        if kind == "field":
            how = of_field(key, name, header, inside, outside, together)
            words = {0: "never used", R: "only read", W: "only written"}
            if name.rpartition("::")[0] in CONSTANTS:
                continue
        else:
            how = 0
            for uses in (inside, outside):
                how |= uses.enumerators.get(key, 0) | uses.enums.get(enum, 0)
            words = {0: "never used", R: "only asked for", W: "only produced"}
            if name.rpartition("::")[2] in NEUTRAL or name.startswith(NUMBERS):
                continue
        if how in words:
            rows.append((room, name, words[how]))
    return sorted(rows), len(known)
