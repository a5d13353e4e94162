#!/usr/bin/env python3
"""Stack bound: the deepest path from evc::kernel::step through the kernel rooms, read from the machine code of the
release build (frame of every function at each of its calls, and the call graph). The bound is committed in
tests/gates/stack.txt; more than that fails, and so does a bound that is more than 2 % too high: it falls with the code.
Recursion, a frame of unknown size (alloca) and a call of an unknown function are refused. A call by pointer counts as
the deepest of all functions whose address is taken.

Usage: tools/check_stack.py [--build FOLDER] [--root FUNCTION] [--write] [--top N]
  --write  writes today's figure into tests/gates/stack.txt
  --top    also prints the N largest frames on any path"""
import pathlib
import re
import subprocess
import sys

import check_layers
import command_line

ROOT = pathlib.Path(__file__).resolve().parent.parent
LIMIT = ROOT / "tests/gates/stack.txt"
# What the platform supplies (tools/check_symbols) and the stack each of them may take; glibc's take less.
PLATFORM = {"memcpy": 256, "memmove": 256, "memset": 256, "memcmp": 256, "sqrt": 256}
RED_ZONE = 128  # what the x86-64 ABI lets a function use below its stack pointer
LARGEST = 16 << 20  # a frame that grows beyond this has no bound
TOLERANCE = 1.02

INSTRUCTION = re.compile(r"^\s*([0-9a-f]+):\t(?:(?:notrack|bnd|rep|repz|data16|cs|lock) )*(\S+)\s*([^\t]*)\t?(.*)$")
RELOCATION = re.compile(r"[0-9a-f]+: R_X86_64_\w+\t(\S+)")
NUMBER = r"\$(-?0x[0-9a-f]+)"


class Refused(Exception):
    """The bound cannot be computed."""


class Object:
    """One object file: instructions by (section, offset), symbols, functions whose address is taken."""
    def __init__(self, name):
        self.name = name
        self.instructions = {}  # (section, offset) -> (mnemonic, operands, relocation target or None, next offset)
        self.functions = {}  # symbol -> (section, offset)
        self.at = {}  # (section, offset) -> symbol
        self.taken = set()  # (section or symbol, offset) of functions used as values


def target_of(relocation):
    """(section or symbol, offset) of a relocation target as objdump prints it, without the -4 of relative ones."""
    m = re.fullmatch(r"(.+?)([+-]0x[0-9a-f]+)?", relocation)
    return m[1], int(m[2] or "0", 16)


def read(archive):
    """The objects of an archive. Two members may have one name: only their order distinguishes them."""
    listing = subprocess.run(["objdump", "-drw", "--no-show-raw-insn", str(archive)], check=True, capture_output=True,
                             text=True).stdout
    objects, current, section, previous = [], None, "", None
    for line in listing.splitlines():
        if m := re.match(r"(\S+):\s+file format", line):
            current = Object(f"{archive.name}({m[1]})")
            objects.append(current)
        elif m := re.match(r"Disassembly of section (.+):$", line):
            section, previous = m[1], None
        elif m := re.match(r"([0-9a-f]+) <(.+)>:$", line):
            current.functions[m[2]] = (section, int(m[1], 16))
            current.at[section, int(m[1], 16)] = m[2]
        elif m := INSTRUCTION.match(line):
            offset = int(m[1], 16)
            if previous is not None:
                current.instructions[section, previous][3] = offset
            previous = offset
            relocation = RELOCATION.search(m[4])
            target = target_of(relocation[1]) if relocation else None
            operands = re.sub(r"\s*#.*$", "", m[3]).strip()
            current.instructions[section, offset] = [m[2], operands, target, None]
            if target and m[2] not in ("call", "jmp") and not m[2].startswith("j"):
                current.taken.add((target[0], target[1] + 4))
    relocations = subprocess.run(["objdump", "-rw", str(archive)], check=True, capture_output=True, text=True).stdout
    current, data, members = None, False, iter(objects)
    for line in relocations.splitlines():
        if m := re.match(r"(\S+):\s+file format", line):
            current = next(members)
        elif m := re.match(r"RELOCATION RECORDS FOR \[(.+)\]", line):
            data = not m[1].startswith((".text", ".debug", ".eh_frame"))
        elif current and data and (m := re.match(r"[0-9a-f]+ R_X86_64_64\s+(\S+)", line)):
            current.taken.add(target_of(m[1]))
    return objects


def base_name(symbol):
    return re.sub(r"\.cold(\.\d+)?$", "", symbol)


class Program:
    """All objects together."""
    def __init__(self, archives):
        self.objects = [o for archive in archives for o in read(archive)]
        self.defined = {}  # symbol -> objects
        for o in self.objects:
            for symbol in o.functions:
                self.defined.setdefault(symbol, []).append(o)
        self.frames = {}  # (object, symbol) -> (deepest, [(depth at the call, callee or None)])
        self.taken = self.functions_taken()

    def functions_taken(self):
        found = set()
        for o in self.objects:
            for name, offset in o.taken:
                if (name, offset) in o.at:
                    found.add((o, o.at[name, offset]))
                elif name in o.functions:
                    found.add((o, name))
                elif name in self.defined:
                    found.update((other, name) for other in self.defined[name])
        return {f for f in found if not f[1].startswith(".")}

    def resolve(self, o, symbol):
        if symbol in o.functions:
            return [(o, symbol)]
        return [(other, symbol) for other in self.defined.get(symbol, [])]

    def frame(self, o, symbol):
        key = (o, symbol)
        if key not in self.frames:
            self.frames[key] = self._frame(o, symbol)
        return self.frames[key]

    def _jump_target(self, o, section, operands, relocation):
        """(section, offset) in this object, or the symbol of another function."""
        if relocation is None:
            m = re.match(r"([0-9a-f]+)", operands)
            return section, int(m[1], 16)
        name, offset = relocation
        if (name, offset + 4) in o.instructions:
            return name, offset + 4
        if name in o.functions:
            place = o.functions[name]
            return place[0], place[1] + offset + 4
        return name

    def _frame(self, o, symbol):
        """Depth of the stack at every instruction that can be reached (bytes below the return address)."""
        depths, calls, deepest, switches = {}, [], 0, []
        work = [(o.functions[symbol], 0, 0)]
        while work:
            place, depth, base = work.pop()
            while place in o.instructions:
                if place in depths and depths[place][0] >= depth:
                    break
                depths[place] = (depth, base)
                if depth > LARGEST:
                    raise Refused(f"{symbol} in {o.name}: the frame has no bound (alloca or a variable array?)")
                deepest = max(deepest, depth)
                section = place[0]
                mnemonic, operands, relocation, following = o.instructions[place]
                ends = False
                if mnemonic.startswith(("push",)):
                    depth += 8
                elif mnemonic.startswith("pop"):
                    depth -= 8
                elif mnemonic in ("leave", "leaveq"):
                    depth = base - 8
                elif mnemonic.startswith("call"):
                    calls.append((depth, self._callee(o, section, operands, relocation)))
                    if following is None:
                        ends = True
                elif mnemonic.startswith("ret") or mnemonic in ("ud2", "hlt"):
                    ends = True
                elif mnemonic.startswith("j"):
                    if operands.startswith("*"):
                        if self._is_switch(o, place):
                            switches.append((depth, base))
                        else:
                            calls.append((depth - 8, None))
                    else:
                        target = self._jump_target(o, section, operands, relocation)
                        other = o.at.get(target) if not isinstance(target, str) else target
                        if other is not None and base_name(other) != base_name(symbol):
                            calls.append((depth - 8, other))  # a tail call: the return address is the caller's
                        else:
                            work.append((target, depth, base))
                    ends = mnemonic.startswith("jmp")
                elif re.search(r"(^|,\s*)%[re]?sp$", operands) and not mnemonic.startswith(("cmp", "test")):
                    depth = self._moved(o, symbol, mnemonic, operands, depth, base)
                elif mnemonic == "mov" and operands == "%rsp,%rbp":
                    base = depth
                deepest = max(deepest, depth)
                place = (section, following)
                if ends or following is None or self._owner(o, place) != base_name(symbol):
                    break
            if not work and switches:
                # Cases of a switch begin with the stack that it has; they are what nothing else reaches.
                depth, base = max(switches)
                inside = [p for p in o.instructions if self._owner(o, p) == base_name(symbol) and p not in depths
                          and not o.instructions[p][0].startswith(("nop", "xchg", "data16"))]
                work += [(min(inside), depth, base)] if inside else []
        return deepest, calls

    def _owner(self, o, place):
        if not hasattr(o, "owners"):
            o.owners, last = {}, None
            for p in o.instructions:  # in the order of the listing
                last = o.at.get(p, last)
                o.owners[p] = base_name(last)
        return o.owners[place]

    @staticmethod
    def _is_switch(o, place):
        """jmp *%rax through a table of distances: the register was added to the table's address just before."""
        section, offset = place
        if not re.fullmatch(r"\*%\w+", o.instructions[place][1]):
            return False
        before = [o.instructions[p] for p in ((section, x) for x in range(offset - 1, offset - 16, -1))
                  if p in o.instructions]
        return any(i[0] == "add" and i[1].endswith("," + o.instructions[place][1][1:]) for i in before)

    @staticmethod
    def _moved(o, symbol, mnemonic, operands, depth, base):
        """The depth after an instruction that writes %rsp."""
        if m := re.fullmatch(NUMBER + r",%rsp", operands):
            value = int(m[1], 16)
            if mnemonic in ("sub", "subq"):
                return depth + value
            if mnemonic in ("add", "addq"):
                return depth - value
            if mnemonic in ("and", "andq"):
                mask = value if value < 0 else value - (1 << 64)
                return depth - mask - 1
        if mnemonic == "lea" and (m := re.fullmatch(r"(-?0x[0-9a-f]+)\((%rsp|%rbp)\),%rsp", operands)):
            return (depth if m[2] == "%rsp" else base) - int(m[1], 16)
        if mnemonic == "mov" and operands == "%rbp,%rsp":
            return base
        if mnemonic == "orq" or mnemonic == "or":
            return depth
        raise Refused(f"{symbol} in {o.name}: `{mnemonic} {operands}`: the frame has no bound that is known")

    def _callee(self, o, section, operands, relocation):
        if operands.startswith("*"):
            return None
        target = self._jump_target(o, section, operands, relocation)
        if isinstance(target, str):
            return target
        if target not in o.at:
            raise Refused(f"{o.name}: a call of {target[0]}+{target[1]:#x}, where no function begins")
        return o.at[target]

    def worst(self, o, symbol):
        """(bytes, path) of the deepest path from a function; a path is a list of (function, bytes it adds)."""
        return self._worst((o, symbol), {}, [])

    def _worst(self, key, known, above):
        if key in known:
            return known[key]
        if key in above:
            names = [k[1] for k in above[above.index(key):]] + [key[1]]
            raise Refused("recursion: " + " -> ".join(demangled(names)))
        above.append(key)
        deepest, calls = self.frame(*key)
        best = (deepest + RED_ZONE, [(key[1], deepest + RED_ZONE)])
        for depth, callee in calls:
            if callee is None:
                callees = sorted(self.taken, key=lambda f: (f[0].name, f[1]))
            elif callee in PLATFORM:
                if depth + 8 + PLATFORM[callee] > best[0]:
                    best = (depth + 8 + PLATFORM[callee], [(key[1], depth + 8), (callee, PLATFORM[callee])])
                continue
            else:
                callees = self.resolve(key[0], callee)
                if not callees:
                    raise Refused(f"{key[1]} calls {callee}, which is not in the kernel rooms")
            for each in callees:
                size, path = self._worst(each, known, above)
                if depth + 8 + size > best[0]:
                    best = (depth + 8 + size, [(key[1], depth + 8), *path])
        above.pop()
        known[key] = best
        return best


def demangled(names):
    shown = subprocess.run(["c++filt"], input="\n".join(names), capture_output=True, text=True, check=True).stdout
    return [re.sub(r"\(.*", "", n.replace("(anonymous namespace)::", "")) for n in shown.splitlines()]


def limit():
    """(bytes, ceiling) as committed."""
    rows = dict(line.split() for line in LIMIT.read_text(encoding="utf-8").splitlines() if line.strip())
    return int(rows["limit"]), int(rows["ceiling"])


def judged(size, allowed, ceiling):
    """What is wrong with a bound of `size` bytes; None for nothing."""
    committed = LIMIT.relative_to(ROOT)
    if size > ceiling:
        return f"{size} bytes are more than {ceiling}, the most that {committed} allows"
    if size > allowed:
        return f"{size} bytes are more than the committed {allowed} ({committed})"
    if allowed > size * TOLERANCE:
        return f"the committed {allowed} are more than 2 % above {size}: tools/check_stack.py --write, and commit {committed}"
    return None


def main():
    parser = command_line.Parser(__doc__)
    parser.add_argument("--build", type=command_line.folder, default=ROOT / "build/release")
    parser.add_argument("--root", default="evc::kernel::step")
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--top", type=command_line.whole(0), default=0)
    options = parser.parse_args()
    archives = [a for room in check_layers.KERNEL_ROOMS
                if (a := options.build / f"src/{room}/libevc_{room}.a").exists()]
    if not archives:
        print(f"stack: no kernel archives in {options.build}: tools/build release")
        return 1
    sys.setrecursionlimit(10000)
    program = Program(archives)
    symbols = sorted(program.defined)
    roots = [s for s, name in zip(symbols, demangled(symbols)) if name == options.root and not s.endswith(".cold")]
    try:
        if not roots:
            raise Refused(f"{options.root} is in none of the archives")
        size, path = max(program.worst(o, s) for s in roots for o in program.defined[s])
    except Refused as reason:
        print(f"stack: {reason}")
        return 1
    for (_, bytes_), name in zip(path, demangled([s for s, _ in path])):
        print(f"stack: {bytes_:8} {name}")
    print(f"stack: {size:8} bytes, worst path of {options.root}; calls by pointer: {len(program.taken)} candidates")
    if options.top:
        frames = sorted(((deepest, s) for (_, s), (deepest, _) in program.frames.items()), reverse=True)[:options.top]
        for (deepest, _), name in zip(frames, demangled([s for _, s in frames])):
            print(f"stack: frame {deepest:8} {name}")
    if options.write:
        ceiling = limit()[1] if LIMIT.exists() else 24576
        LIMIT.write_text(f"limit {size}\nceiling {ceiling}\n", encoding="utf-8")
    allowed, ceiling = limit()
    if fault := judged(size, allowed, ceiling):
        print(f"stack: {fault}")
        return 1
    print(f"stack: within the committed {allowed}; at most {ceiling}")
    return 0


if __name__ == "__main__":
    command_line.run(main)
