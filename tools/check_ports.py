#!/usr/bin/env -S python3 -B
"""The C interface has a place for every input and output of the kernel: each field of the structs that port::Inputs and
port::Outputs are made of (include/openevc/port/) is used by src/capi/inputs.cpp or src/capi/outputs.cpp. A field of C that
nothing uses is found too: every member of openevc_inputs and openevc_outputs is mentioned there. The record of the
display (port::Display) is openevc_display, taken there by src/capi/display.cpp; what a host configures of it is not, and
src/io/display_json_test.cpp holds that all of it is in `evc replay --dmi`.
Usage: tools/check_ports.py"""

import command_line
import field_uses
from field_uses import ROOT, K

TypeKind = field_uses.cindex.TypeKind

PORT = "include/openevc/port/"
HEADER = "include/openevc/openevc.h"
# The struct of the kernel, that of C, and the source that takes one to the other.
PORTS = [("Inputs", PORT + "inputs.h", "openevc_inputs", "src/capi/inputs.cpp"),
         ("Outputs", PORT + "outputs.h", "openevc_outputs", "src/capi/outputs.cpp"),
         ("Planning", PORT + "planning.h", "openevc_planning", "src/capi/outputs.cpp")]
# Structs that have another place in C than one member for each field.
WHOLE = {"Event": "openevc_event.text is its line (texts::line_of)"}
# Fields that C does not have: openevc_display has what is made of them.
OF_THE_DISPLAY = {"PlannedCondition::end", "PlannedCondition::phase"}
UNUSED = {"size", "reserved", "reserved_2", "reserved_3", "reserved_4"}  # members of C alone


def struct_of(type_):
    """The structs that a type is made of: X, X*, X[n], `std::optional<X>`, `InplaceVector<X, n>`, `std::span<const X>`."""
    whole = type_.get_canonical()
    if whole.kind == TypeKind.POINTER:
        return struct_of(whole.get_pointee())
    if whole.kind == TypeKind.CONSTANTARRAY:
        return struct_of(whole.get_array_element_type())
    found = [whole.get_declaration()]
    for n in range(max(whole.get_num_template_arguments(), 0)):
        argument = whole.get_template_argument_type(n)
        if argument.spelling:
            found += struct_of(argument)
    return found


def fields(struct, seen):
    """{USR: "Struct::field"} of a struct and the structs in it."""
    named = {}
    for field in struct.get_children():
        if field.kind != K.FIELD_DECL:
            continue
        named[field.get_usr()] = f"{struct.spelling}::{field.spelling}"
        for inner in struct_of(field.type):
            where = inner.location.file
            if where is None or not (PORT in where.name or where.name.endswith(HEADER)) or inner.kind != K.STRUCT_DECL:
                continue
            if inner.get_usr() in seen:
                continue
            seen.add(inner.get_usr())
            if inner.spelling not in WHOLE:
                named.update(fields(inner, seen))
    return named


def mentioned(cursor, found):
    """USRs of the fields that a file's functions mention."""
    for c in cursor.walk_preorder():
        if c.kind == K.MEMBER_REF_EXPR and c.referenced is not None and c.referenced.kind == K.FIELD_DECL:
            found.add(c.referenced.get_usr())
        if c.kind == K.MEMBER_REF and c.referenced is not None:  # .name = in an initialiser
            found.add(c.referenced.get_usr())


def declared(unit, header, name):
    """The definition of a struct, by its name."""
    for own in field_uses.own_declarations(unit, {str(ROOT / header)}):
        for c in own.walk_preorder():
            if c.kind == K.STRUCT_DECL and c.spelling == name and c.is_definition():
                return c
    raise SystemExit(f"ports: no struct {name} in {header}")


def faults(ports=PORTS):
    wrong, looked_at = [], 0
    for struct, header, of_c, source in ports:
        unit = field_uses.parsed(ROOT / source)
        used = set()
        for own in field_uses.own_declarations(unit, {str(ROOT / source)}):
            mentioned(own, used)
        ours = fields(declared(unit, header, struct), set())
        theirs = {usr: name for usr, name in fields(declared(unit, HEADER, of_c), set()).items()
                  if name.partition("::")[2] not in UNUSED}
        looked_at += len(ours) + len(theirs)
        wrong += [f"{source} does not use {name}" for usr, name in {**ours, **theirs}.items()
                  if usr not in used and name not in OF_THE_DISPLAY]
    return wrong, looked_at


def main():
    command_line.Parser(__doc__).parse_args()
    wrong, looked_at = faults()
    for sentence in wrong:
        print(f"ports: {sentence}")
    print(f"ports: {looked_at} fields, {len(wrong)} faults")
    return 1 if wrong or looked_at < 200 else 0


if __name__ == "__main__":
    command_line.run(main)
