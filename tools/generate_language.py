#!/usr/bin/env python3
"""Writes the C++ declarations of the ETCS language from reference data.

    tools/generate_language.py REFERENCE_DIR [CHECKOUT]

REFERENCE_DIR holds variables.json, packets_to_train.json, packets_to_track.json, messages_to_train.json and
messages_to_track.json. The files written (src/lang/variables.h, variable_table.cpp, message_table.cpp, packets.h,
messages.h, packets/*, messages/*) are committed: they are the source, and src/lang/layout_test.cpp compares them with
the reference data field by field. Run clang-format afterwards.
"""
import json
import os
import re

import command_line

VERSIONS = ["1.0", "1.1", "2.0", "2.1", "2.2", "2.3", "3.0"]
# The forms of this version have names without a suffix: the others are translated into them.
WORKING = "2.1"
HEAD = "#pragma once\n"


def quoted(text):
    return json.dumps(text or "", ensure_ascii=True)


def version_set(sv):
    return " | ".join("v" + v.replace(".", "_") for v in sv)


def media_set(media):
    return " | ".join("media::" + m for m in media)


# ---------------------------------------------------------------- variables


def variable_type(key, v):
    bits = v["bits"]
    full = (1 << bits) - 1
    top = v["max"] & full if not v["signed"] else full
    if v["kind"] in ("enum", "table", "bitset") or v["spare"] and top == full:
        top = full
    args = []
    decimal = key in ("NID_MN", "NID_OPERATIONAL", "NID_OPERATIONAL_V1")
    if top != full or v["spare"] or decimal:
        args.append("all_ones(%d)" % bits if top == full else str(top))
    args += ["Range{%d%s, %d%s}" % (a, "u" if a > 2**31 else "", b, "u" if b > 2**31 else "") for a, b in v["spare"]]
    if decimal:
        args.append("decimal_digits")
    return 'Variable<"%s", %d%s>' % (key, bits, "".join(", " + a for a in args))


def write_variables(variables, out):
    lines = [HEAD, '#include "lang/schema.h"\n', "\n// SUBSET-026-7 7.5: every variable of the language, name, width, greatest ordinary code, spare codes.\n"
             "// A name with _V1 is the form of system versions 1.Y where it differs (SUBSET-026-6 6.5.1).\n",
             "namespace evc::lang::var {\n\n"]
    for key, v in variables.items():
        about = v.get("comment", "")
        lines.append("using %s = %s;  ///< %s (%s)\n" % (key, variable_type(key, v), about, v["ref"]))
    lines.append("\n}  // namespace evc::lang::var\n")
    out("src/lang/variables.h", "".join(lines))


def code_rows(table):
    return ", ".join("{%su, %s}" % (code, quoted(text)) for code, text in table.items())


KINDS = {"acceleration": "acceleration", "distance": "distance", "gradient": "gradient", "number": "number", "table": "table",
         "length": "length", "enum": "enumeration", "mass": "mass", "current": "current", "bitset": "bitset",
         "factor": "factor", "version": "version", "id": "identity", "composite": "identity", "bcd": "bcd", "time": "time",
         "speed": "speed", "char": "character"}


def write_variable_table(variables, out):
    lines = ['#include "lang/variable_table.h"\n\n#include <array>\n\n#include "lang/variables.h"\n\n',
             "// The meaning of every code (SUBSET-026-7 7.5), reworded.\nnamespace evc::lang {\nnamespace {\n\n",
             "template <std::size_t N>\nusing Meanings = std::array<Meaning, N>;\n",
             "template <std::size_t N>\nusing Numbers = std::array<CodeNumber, N>;\n\n"]
    rows = []
    shared = {}
    for key, v in variables.items():
        def emit(kind, table, row, typ):
            if not table:
                return "{}"
            if table not in shared:
                name = "%s_%s" % (key, kind)
                lines.append("constexpr %s<%d> %s{{%s}};\n" % (typ, row[1], name, row[0]))
                shared[table] = name
            return shared[table]
        def meanings(kind):
            t = v.get(kind) or {}
            if kind == "enum" and v.get("table") and v.get("unit"):
                t = {}
            r = code_rows(t)
            return emit({"enum": "codes", "special": "special", "bits_meaning": "bits"}[kind], r, (r, len(t)), "Meanings")
        numbers = v.get("table") or {}
        nr = ", ".join("{%su, %s}" % (c, n) for c, n in numbers.items())
        number_name = emit("numbers", nr, (nr, len(numbers)), "Numbers")
        res = v.get("resolution")
        rows.append((key, v, res, meanings("special"), meanings("enum"), meanings("bits_meaning"), number_name))
    body = []
    for key, v, res, special, enum, bits, numbers in rows:
        by_scale = res == "Q_SCALE"
        r = "0" if res is None or by_scale else repr(res)
        unit = v.get("unit") or ""
        body.append('row<var::%s>(%s, Kind::%s, %s, %s, %s, %s, %s, %s, %s, %s, %s, %s, %s, %s),\n' % (
            key, quoted(v["name"]), KINDS[v["kind"]], quoted(unit), r, "true" if by_scale else "false",
            "true" if v["signed"] else "false", special, enum, bits, numbers, version_set(v["sv"]), quoted(v.get("comment")),
            quoted(v["ref"]), quoted(v.get("note"))))
    lines.append("""
template <Name N, unsigned B, std::uint64_t Max, Range... Spare>
constexpr std::array<Range, sizeof...(Spare)> spare_ranges(Variable<N, B, Max, Spare...>*) {
  return {Spare...};
}
template <class V>
inline constexpr auto spare_of = spare_ranges(static_cast<V*>(nullptr));

template <class V>
constexpr VariableInfo row(const char* name, Kind kind, const char* unit, double resolution, bool by_scale, bool is_signed,
                           std::span<const Meaning> special, std::span<const Meaning> codes,
                           std::span<const Meaning> bit_meanings, std::span<const CodeNumber> numbers, Versions versions,
                           const char* about, const char* ref, const char* note) {
  return {V::name, name, V::bits,      is_signed,         kind,  unit,         resolution, by_scale, V::max,
          special, codes, bit_meanings, numbers, spare_of<V>, versions,     about,      ref,      note};
}

""")
    lines.append("constexpr std::array<VariableInfo, %d> all_variables{{\n" % len(rows) + "".join(body) + "}};\n\n")
    lines.append("}  // namespace\n\nstd::span<const VariableInfo> variables() { return all_variables; }\n\n}  // namespace evc::lang\n")
    out("src/lang/variable_table.cpp", "".join(lines))


# ---------------------------------------------------------------- structures


def member_name(e):
    return e.get("as", e["var"])


def condition(expr):
    parts = [p.strip() for p in expr.split("||")]
    names, ops, values = [], [], []
    for p in parts:
        m = re.fullmatch(r"(\w+) (==|!=) (\d+)", p)
        names.append(m[1]), ops.append(m[2]), values.append(m[3])
    assert len(set(names)) == 1 and (set(ops) == {"=="} or (ops == ["!="]))
    return names[0], ("is(%s)" if ops[0] == "==" else "is_not(%s)") % ", ".join(values)


class Struct:
    def __init__(self, name):
        self.name = name
        self.members = []   # (type, name, comment)
        self.items = []     # layout lines
        self.first = []     # (element struct, repeat name)


class Builder:
    """Turns the elements of one packet into structs, inner ones first."""

    def __init__(self, packet_name, by_body):
        self.packet_name = packet_name
        self.done = []          # finished structs, in order of definition
        self.by_body = by_body  # repeat name + body -> struct, shared by the forms of one packet

    def build(self, struct, elements, outer, skip):
        self.fields(struct, [e for e in elements if e.get("var") not in skip], outer, None, struct.items)
        names = [m[1] for m in struct.members]
        for typ, name, _ in struct.members:
            m = re.fullmatch(r"InplaceVector<(\w+), \d+>", typ)
            if m:
                element = next(s for s in self.by_body.values() if s.name == m[1])
                if all(x[1] in names for x in element.members):
                    struct.first.append((element, name))
        self.done.append(struct)

    def add_member(self, struct, typ, name, comment):
        for m in struct.members:
            if m[1] == name:
                assert m[0] == typ
                return
        struct.members.append((typ, name, comment))

    def fields(self, struct, elements, outer, present_if, items):
        pending = None
        for e in elements:
            if "var" in e:
                name = member_name(e)
                counted = any(x.get("repeat") == name for x in elements)
                if counted:
                    pending = e
                    continue
                self.add_member(struct, "var::" + e["var"], name, present_if)
                if name == e["var"]:
                    items.append("&%s::%s" % (struct.name, name))
                else:
                    items.append('named("%s", &%s::%s)' % (name, struct.name, name))
            elif "if" in e:
                name, test = condition(e["if"])
                here = any(m[1] == name for m in struct.members)
                if not here:
                    around = next(m[0] for s in outer for m in s.members if m[1] == name)
                inner = []
                text = e["if"] if present_if is None else present_if + " && " + e["if"]
                self.fields(struct, e["then"], outer, text, inner)
                if here:
                    items.append("when(&%s::%s, %s, %s)" % (struct.name, name, test, ", ".join(inner)))
                else:
                    items.append("when_around<%s>(%s, %s)" % (around, test, ", ".join(inner)))
            elif "repeat" in e:
                assert pending is not None and member_name(pending) == e["repeat"], (struct.name, e["repeat"])
                key = (e["name"], json.dumps(e["body"]))
                if key not in self.by_body:
                    inner_name = self.packet_name + "_" + e["name"]
                    if any(s.name == inner_name for s in self.done):
                        inner_name = struct.name + "_" + e["name"]
                    inner = Struct(inner_name)
                    self.build(inner, e["body"], [struct] + outer, ())
                    self.by_body[key] = inner
                inner = self.by_body[key]
                capacity = 255 if pending["var"] == "L_TEXT" else 31
                self.add_member(struct, "InplaceVector<%s, %d>" % (inner.name, capacity), e["name"], present_if)
                counter = '"%s", ' % member_name(pending) if "as" in pending else ""
                items.append('repeat<var::%s>(%s"%s", &%s::%s)' % (pending["var"], counter, e["name"], struct.name, e["name"]))
                pending = None
            elif e.get("rest_of_packet"):
                self.add_member(struct, "Opaque", e["as"], present_if)
                items.append('rest_of_packet("%s", &%s::%s)' % (e["as"], struct.name, e["as"]))
            elif "packet" in e or "packet_one_of" in e:
                pass
            else:
                raise ValueError(e)


def present(text):
    return "" if text is None else "  ///< only if " + text


def struct_text(s, head, forward):
    t = [head, "struct %s {\n" % s.name]
    if forward:
        t.append(forward)
    for typ, name, cond in s.members:
        t.append("  %s %s;%s\n" % (typ, name, present(cond)))
    for element, name in s.first:
        t.append("  /// The element before the counter, in the form of the others.\n")
        t.append("  constexpr %s first_%s() const { return {%s}; }\n" % (element.name, name, ", ".join(m[1] for m in element.members)))
    t.append("  friend constexpr bool operator==(const %s&, const %s&) = default;\n};\n" % (s.name, s.name))
    return "".join(t)


def layout_text(s):
    return "template <>\ninline constexpr auto layout_of<%s> =\n    layout(%s);\n" % (s.name, ",\n           ".join(s.items))


def lowest(sv):
    return "v" + sv[0].replace(".", "_")


def plain_form(versions):
    """Of the forms of one number, the newest first: the index of the one whose name has no suffix."""
    return next((i for i, sv in enumerate(versions) if WORKING in sv), 0)


def write_packets(data, prefix, direction, out):
    ids = {}
    for p in data["packets"]:
        ids.setdefault(p["id"], []).append(p)
    names, families = [], {}
    for pid, forms in sorted(ids.items()):
        forms.sort(key=lambda p: VERSIONS.index(p["sv"][-1]), reverse=True)
        body = []
        # 203 and 207 are 3 and 70 of version 1.1, 73 is 72 of 2.2: the groups they repeat are the same (6.5.1.5,
        # 6.5.2.3). Packet 12 of the train has a group of packet 11.
        family = ({203: 3, 207: 70, 73: 72} if direction == "to_train" else {12: 11}).get(pid, pid)
        by_body = families.setdefault(family, {})
        plain = plain_form([p["sv"] for p in forms])
        # The plain form is first in the file: the groups that forms have in common have its name.
        forms.insert(0, forms.pop(plain))
        for i, p in enumerate(forms):
            name = "%s%d" % (prefix, pid)
            if i > 0:
                name += "_" + lowest(p["sv"])
            builder = Builder(name, by_body)
            top = Struct(name)
            builder.build(top, p["elements"], [], ("NID_PACKET", "L_PACKET"))
            info = '  static constexpr PacketInfo info{%d, %s, Direction::%s, %s, %s, %s, %s};\n' % (
                pid, quoted(p["name"]), direction, version_set(p["sv"]), media_set(p["media"]), quoted(p["ref"]), quoted(p.get("note")))
            for s in builder.done:
                head = ""
                if s is top:
                    head = "/// Packet %d, %s (%s), system version %s.\n" % (pid, p["name"], p["ref"], ", ".join(p["sv"]))
                body.append(struct_text(s, head, info if s is top else ""))
            for s in builder.done:
                body.append(layout_text(s))
            names.append(name)
        file = "src/lang/packets/%s_%d.h" % ("packet" if prefix == "Packet" else "train_packet", pid)
        include = "lang/packets/%s_%d.h" % ("packet" if prefix == "Packet" else "train_packet", family) if family != pid else "lang/variables.h"
        out(file, HEAD + '#include "' + include + '"\n\nnamespace evc::lang {\n\n' + "\n".join(body) + "\n}  // namespace evc::lang\n")
    return names


def message_set(values):
    return "{}" if not values else "{" + ", ".join(str(v) for v in values) + "}"


def write_messages(data, prefix, direction, out):
    ids = {}
    for m in data["messages"]:
        ids.setdefault(m["id"], []).append(m)
    skip = ("NID_MESSAGE", "L_MESSAGE")
    names, body, rows = [], [], []
    for mid, forms in sorted(ids.items()):
        forms.sort(key=lambda p: VERSIONS.index(p["sv"][-1]), reverse=True)
        kinds = []  # (fields, [forms])
        for m in forms:
            fields = [e for e in m["elements"] if "var" in e or "if" in e]
            for k in kinds:
                if k[0] == fields:
                    k[1].append(m)
                    break
            else:
                kinds.append((fields, [m]))
        plain = plain_form([[v for m in group for v in m["sv"]] for _, group in kinds])
        for i, (fields, group) in enumerate(kinds):
            sv = sorted({v for m in group for v in m["sv"]}, key=VERSIONS.index)
            name = "%s%d" % (prefix, mid) + ("_" + lowest(sv) if i != plain else "")
            builder = Builder(name, {})
            top = Struct(name)
            builder.build(top, fields, [], skip)
            m = group[0]
            info = '  static constexpr MessageInfo info{%d, %s, Direction::%s, %s, %s};\n' % (
                mid, quoted(m["name"]), direction, version_set(sv), quoted(m["ref"]))
            head = "/// Message %d, %s (%s), system version %s: the part before its packets.\n" % (mid, m["name"], m["ref"], ", ".join(sv))
            body.append(struct_text(top, head, info))
            body.append(layout_text(top))
            names.append(name)
            for g in group:
                rows.append((name, g))
    out("src/lang/messages/%s.h" % ("to_train" if direction == "to_train" else "to_track"),
        HEAD + '#include "lang/variables.h"\n\n// SUBSET-026-8 %s.\nnamespace evc::lang {\n\n' % ("8.7" if direction == "to_train" else "8.6")
        + "\n".join(body) + "\n}  // namespace evc::lang\n")
    return names, rows


def write_message_table(rows, out):
    t = ['#include "lang/message_table.h"\n\n#include <array>\n\n',
         "// SUBSET-026-8 8.6, 8.7: which packets a message must and may carry, per system version and sender.\nnamespace evc::lang {\nnamespace {\n\n"]
    body, shared = [], {}
    def ids(values):
        if not values:
            return "{}"
        key = tuple(values)
        if key not in shared:
            shared[key] = "ids_%d" % len(shared)
            t.append("constexpr std::array<std::uint8_t, %d> %s{%s};\n" % (len(values), shared[key], ", ".join(map(str, values))))
        return shared[key]
    for name, m in rows:
        required = []
        for e in m["elements"]:
            if "packet" in e:
                required.append([e["packet"]])
            elif "packet_one_of" in e:
                required.append(e["packet_one_of"])
        assert len(required) <= 3
        req = "{{" + ", ".join(ids(r) for r in required) + "}}" if required else "{}"
        by = m.get("optional_packets_by_sender", {})
        rbc = by.get("RBC", m["optional_packets"] if "RBC" in m["media"] else [])
        riu = by.get("RIU", m["optional_packets"] if "RIU" in m["media"] else [])
        body.append("{%d, %s, Direction::%s, %s, %s, %s, %s, %s, %s, %s, %s, %s, %s},\n" % (
            m["id"], quoted(m["name"]), "to_train" if m["direction"] == "track_to_train" else "to_track", version_set(m["sv"]),
            media_set(m["media"]), quoted(m["priority"]), "true" if m["version_invariant"] else "false", req,
            ids(m["optional_packets"]), ids(rbc), ids(riu), quoted(m["ref"]), quoted(m.get("note"))))
    t.append("\nconstexpr std::array<MessageRules, %d> all_rules{{\n%s}};\n\n" % (len(rows), "".join(body)))
    t.append("}  // namespace\n\nstd::span<const MessageRules> message_rules() { return all_rules; }\n\n}  // namespace evc::lang\n")
    out("src/lang/message_table.cpp", "".join(t))


def main():
    parser = command_line.Parser(__doc__)
    parser.add_argument("reference", type=command_line.folder)
    parser.add_argument("root", nargs="?", type=command_line.folder, default=os.path.join(os.path.dirname(__file__), ".."))
    options = parser.parse_args()
    root = options.root

    def load(name):
        return command_line.json_of(options.reference / (name + ".json"))

    def out(path, text):
        path = os.path.join(root, path)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as f:
            f.write(text)

    variables = load("variables")["variables"]
    write_variables(variables, out)
    write_variable_table(variables, out)
    lists = []
    for file, prefix, direction in (("packets_to_train", "Packet", "to_train"), ("packets_to_track", "TrainPacket", "to_track")):
        lists.append((prefix, write_packets(load(file), prefix, direction, out)))
    m1, r1 = write_messages(load("messages_to_train"), "Message", "to_train", out)
    m2, r2 = write_messages(load("messages_to_track"), "TrainMessage", "to_track", out)
    write_message_table(r1 + r2, out)
    includes = []
    for prefix, names in lists:
        stem = "packet" if prefix == "Packet" else "train_packet"
        seen = []
        for n in names:
            pid = re.match(r"\D+(\d+)", n)[1]
            if pid not in seen:
                seen.append(pid)
                includes.append('#include "lang/packets/%s_%s.h"\n' % (stem, pid))
    def macro(name, entries):
        return "#define %s(X) \\\n" % name + " \\\n".join("  X(%s)" % e for e in entries) + "\n"
    text = HEAD + "// Every packet, and the lists from which readers, writers and tables are made.\n" + "".join(includes) + "\n"
    text += "// Track to train (7.4.2), the layout of 2.1 first where there are several, in three parts: the\n// readers of each are made in a file of their own.\n"
    names = lists[0][1]
    cuts = [0, next(i for i, n in enumerate(names) if n == "Packet39"), next(i for i, n in enumerate(names) if n == "Packet80"), len(names)]
    parts = ["EVC_PACKETS_TO_TRAIN_%d" % (k + 1) for k in range(3)]
    for k, part in enumerate(parts):
        text += macro(part, names[cuts[k]:cuts[k + 1]]) + "\n"
    text += "#define EVC_PACKETS_TO_TRAIN(X) " + " ".join(p + "(X)" for p in parts) + "\n"
    text += "\n// Train to track (7.4.3).\n" + macro("EVC_PACKETS_TO_TRACK", lists[1][1])
    out("src/lang/packets.h", text)
    text = HEAD + "// Every message, and the lists from which readers, writers and tables are made.\n"
    text += '#include "lang/messages/to_track.h"\n#include "lang/messages/to_train.h"\n\n'
    text += macro("EVC_MESSAGES_TO_TRAIN", m1) + "\n" + macro("EVC_MESSAGES_TO_TRACK", m2)
    out("src/lang/messages.h", text)


if __name__ == "__main__":
    command_line.run(main)
