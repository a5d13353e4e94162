#!/usr/bin/env python3
"""A random line description for `evc make-line`, on standard output. The same seed gives the same description with
every version of Python.

A line starts in level 0, 1 or NTC and changes its level up to four times; level 1 has signals with infill, level 2 a
radio block centre that extends, shortens and withdraws authorities. It has gradients, speed profiles, temporary speed
restrictions, mode profiles (OS, LS, SH), track conditions, texts, emergency messages and rarer packets, some of which
the on-board has to reject. Usage: tools/random_line.py --seed N"""
import dataclasses
import json
import random
import sys

import command_line

NID_C = 1000
RBC = {"NID_RBC": 1, "NID_RADIO": "0041790000000001"}
SPEEDS = (40, 60, 80, 100, 120, 140, 160)
STOPPING = {46, 51, 52, 70, 88, 132, 137}  # packets that stop a train, or may
CALM_AHEAD = 2800  # m, more than the way from the Indication limit to standstill from any speed of the line
BEYOND = 3000  # profiles reach so far beyond the last group


@dataclasses.dataclass(frozen=True)
class Sizes:
    """In what an ordinary line and a calm one differ. Places in m, ranges (least, most)."""
    length: tuple
    more_per_step: tuple  # of gradient and speed
    beyond: int  # profiles reach so far beyond the end
    sections: int  # at most, of one level each
    level_2_again: bool
    between_groups: tuple
    between_signals: tuple  # in groups
    ahead: int  # what restricts the train lies so far ahead of where it is sent; 0: anywhere
    last_authority: int  # beyond the end of the line, at most
    before_border: tuple  # where a level is announced
    all_announce: bool
    V_NVUNFIT: tuple  # one of them
    consents: tuple  # Q_TEXTCONFIRM, one of them
    stops: bool  # signals at danger, shunting, orders that take something back, packets that stop the train or are refused
    balises: int  # of a group with orders; 0: as they need


ORDINARY = Sizes(length=(6000, 15000), more_per_step=(0, 0), beyond=BEYOND, sections=4, level_2_again=True,
                 between_groups=(400, 1000), between_signals=(2, 4), ahead=0, last_authority=1500, before_border=(1700, 300),
                 all_announce=False, V_NVUNFIT=(80, 100), consents=(1, 2, 3), stops=True, balises=0)
# Long authorities have to fit into telegrams; level 2 is announced before its first authority, and entered once: the
# session ends after the next call.
CALM = Sizes(length=(12000, 20000), more_per_step=(1400, 2400), beyond=BEYOND + 2 * CALM_AHEAD, sections=3,
             level_2_again=False, between_groups=(800, 1400), between_signals=(2, 2), ahead=CALM_AHEAD,
             last_authority=CALM_AHEAD, before_border=(2400, 900), all_announce=True, V_NVUNFIT=(60,), consents=(1,),
             stops=False, balises=8)


class Dice:
    """Only Random.random() is the same in every version of Python."""

    def __init__(self, seed):
        self._random = random.Random(seed).random

    def chance(self, share):
        return self._random() < share

    def whole(self, least, most):
        return least + int(self._random() * (most - least + 1))

    def tens(self, least, most):
        return 10 * self.whole(least // 10, most // 10)

    def one_of(self, items):
        """One item needs no throw."""
        return items[0] if len(items) == 1 else items[self.whole(0, len(items) - 1)]

    def some_of(self, items, share):
        return [item for item in items if self.chance(share)]


class RandomLine:
    """`calm`: nothing on it stops or brakes a train whose driver follows the permitted speed: what restricts the
    train lies at least CALM_AHEAD ahead of the place where it is sent, and the speed is the same around each border of levels."""

    def __init__(self, seed, calm=False):
        self.dice = Dice(seed)
        self.sizes = CALM if calm else ORDINARY
        self.seed = seed
        self.length = self.dice.tens(*self.sizes.length)
        self.gradient = self.profile(500, 1800, lambda: self.dice.whole(-18, 18))
        self.ssp = self.profile(600, 3500, lambda: self.dice.one_of(SPEEDS))
        self.groups = []
        self.radio = []
        self.next_TSR = 1
        self.place_levels()
        if self.sizes.ahead:
            self.keep_speed_at_borders()
        self.place_groups()
        self.first_group()
        for section in self.sections:
            self.equip(section)
        self.announce_levels()
        self.decorate()

    # What the line is like.
    def profile(self, least, most, value):
        steps, at = [], -500
        least, most = least + self.sizes.more_per_step[0], most + self.sizes.more_per_step[1]
        last = self.length + self.sizes.beyond
        while at < last:
            end = min(at + self.dice.tens(least, most), last)
            steps.append([at, end, value()])
            at = end
        return steps

    def place_levels(self):
        """[{level, from_m, to_m}]; no two neighbours have the same level."""
        count = self.dice.whole(1, self.sizes.sections)
        levels = [self.dice.one_of(("0", "1", "1", "NTC"))]
        if count == 1:
            levels = ["1"]
        while len(levels) < count:
            ahead = self.dice.one_of(("0", "1", "1", "2", "2", "2", "NTC"))
            if not self.sizes.level_2_again and "2" in levels and ahead == "2":
                continue
            if ahead != levels[-1]:
                levels.append(ahead)
        if count > 1 and not set(levels) & {"1", "2"}:
            levels[-1] = self.dice.one_of(("1", "2"))
        # A level 2 section needs way to be announced and entered.
        borders = [0]
        for i in range(1, count):
            share = self.length * i // count
            borders.append(share + self.dice.tens(-200, 200))
        borders.append(self.length)
        self.sections = [{"level": level, "from_m": borders[i], "to_m": borders[i + 1]} for i, level in enumerate(levels)]

    def keep_speed_at_borders(self):
        """A train that enters an authority finds no lower speed within CALM_AHEAD."""
        for border in [0] + [section["from_m"] for section in self.sections[1:]]:
            unfitted = any(s["level"] == "0" and border in (s["from_m"], s["to_m"]) for s in self.sections)
            kept = next(v for a, b, v in self.ssp if a <= border - 1500 < b or a == -500 and border < 1500)
            kept = 60 if unfitted else max(80, kept)
            begin, end = border - 1500, border + CALM_AHEAD
            cut = [[a, min(b, begin), v] for a, b, v in self.ssp if a < begin]
            cut += [[begin, end, kept]] if begin > -500 else [[-500, end, kept]]
            cut += [[max(a, end), b, v] for a, b, v in self.ssp if b > end]
            self.ssp = cut

    def place_groups(self):
        """Groups at irregular distances, and one at each border of levels."""
        places = {60}
        at = 60
        while at < self.length:
            at += self.dice.tens(*self.sizes.between_groups)
            places.add(at)
        borders = [section["from_m"] for section in self.sections[1:]]
        places = {p for p in places if all(abs(p - b) > 60 for b in borders)} | set(borders)
        first = self.dice.whole(1, 9000)
        self.groups = [{"NID_BG": first + i, "at_m": at, "orders": []} for i, at in enumerate(sorted(places))]

    def ahead(self, at):
        """The first group at or beyond a place, None behind the last one."""
        return next((g for g in self.groups if g["at_m"] >= at), None)

    def behind(self, at):
        """The last group that a train whose front is at the place has read."""
        return next((g for g in reversed(self.groups) if g["at_m"] + 60 <= at), None)

    # What is sent by which section.
    def first_group(self):
        dice = self.dice
        values = {
            "V_NVREL": dice.one_of((15, 20, 30)),
            "V_NVONSIGHT": dice.one_of((30, 40)),
            "V_NVSTFF": dice.one_of((40, 60)),
            "V_NVLIMSUPERV": dice.one_of((60, 100)),
            "V_NVUNFIT": dice.one_of(self.sizes.V_NVUNFIT),
            "D_NVROLL": dice.one_of((2, 5)),
            "M_NVCONTACT": dice.one_of((0, 1, 2)),
            "T_NVCONTACT": dice.one_of((25, 40)),
            "Q_NVEMRRLS": dice.chance(0.5),
            "Q_NVSBTSMPERM": dice.chance(0.7),
            "Q_NVGUIPERM": dice.chance(0.3),
            "Q_NVINHSMICPERM": dice.chance(0.3),
            "Q_NVDRIVER_ADHES": dice.chance(0.5),
            "D_NVPOTRP": 100,
            "D_NVSTFF": dice.one_of((1000, 5000)),
            "Q_NVLOCACC": 12,
        }
        self.groups[0]["orders"].append({"national_values": values})

    def equip(self, section):
        {"1": self.equip_level_1, "2": self.equip_level_2}.get(section["level"], lambda _: None)(section)

    def authority(self, to, release_share=0.7):
        authority = {"to_m": to}
        if self.dice.chance(0.8):
            authority["danger_point_m"] = to + self.dice.tens(20, 150)
            if self.dice.chance(release_share):
                authority["release_kmh"] = self.dice.one_of((10, 15, 20, 25))
        return {"authority": authority}

    def equip_level_1(self, section):
        """A signal every second to fourth group: an authority to the second signal ahead, with infill in between."""
        groups = [g for g in self.groups if section["from_m"] <= g["at_m"] < section["to_m"]]
        signals = []
        while groups:
            signals.append(groups[0])
            groups = groups[self.dice.whole(*self.sizes.between_signals):]
        for i, signal in enumerate(signals):
            target = signals[min(i + 2, len(signals) - 1)]["at_m"] + self.dice.tens(60, 200)
            if i + 2 >= len(signals):
                target = min(section["to_m"], self.length) + self.dice.tens(400, 900)
            if self.dice.chance(0.15) and i + 1 < len(signals) and self.sizes.stops:  # the next signal is at danger
                target = signals[i + 1]["at_m"] + 40
            target = min(target, signal["at_m"] + 3000)
            if self.sizes.ahead:
                target = (signals[i + 1]["at_m"] if i + 1 < len(signals) else section["to_m"]) + self.sizes.ahead
            signal["orders"].append(self.authority(target))
            self.mode_profile(signal["orders"], signal["at_m"], target)
            between = [g for g in self.groups if i + 1 < len(signals) and signal["at_m"] < g["at_m"] < signals[i + 1]["at_m"]]
            if between and i + 1 < len(signals) and self.dice.chance(0.4):
                main = signals[i + 1]
                further = min(main["at_m"] + self.dice.tens(900, 2200), self.length + 1200)
                if self.sizes.ahead:
                    further = main["at_m"] + self.sizes.ahead + self.dice.tens(0, 900)
                between[-1]["orders"] += [{"infill": main["NID_BG"]}, self.authority(further)]

    def mode_profile(self, orders, begin, to, share=0.25):
        dice = self.dice
        if not dice.chance(share) or to - begin < 900:
            return
        start = begin + dice.tens(300, (to - begin) // 2)
        if self.sizes.ahead:
            start = begin + self.sizes.ahead + 300
            if start + 200 > to:
                return
        shunting = start > 0.6 * self.length and self.sizes.stops
        mode = dice.one_of(("OS", "OS", "LS", "LS", "SH") if shunting else ("OS", "OS", "LS"))
        profile = {"mode": mode, "from_m": start, "to_m": min(to, start + dice.tens(200, 1500)), "acknowledge_m": dice.tens(100, 300)}
        if dice.chance(0.5):
            profile["kmh"] = dice.one_of((20, 30, 40, 60))
        orders.append({"mode_profile": profile})

    def send(self, at, orders=None, message=None, delay=None):
        lrbg = self.behind(at)
        if lrbg is None:
            return
        entry = {"at_m": at, "lrbg": lrbg["NID_BG"]}
        if delay is not None:
            entry["delay_s"] = delay
        entry.update({"orders": orders} if message is None else {"message": message})
        self.radio.append(entry)

    def equip_level_2(self, section):
        dice = self.dice
        begin, end = section["from_m"], section["to_m"]
        call = self.behind(begin - dice.tens(1200, 1600)) or self.groups[0]
        call["orders"].append({"session": {"establish": True, **RBC}})
        first = max(call["at_m"] + 700, begin - 600)
        self.send(first - 100, [
            {"ma_requests": {"before_perturbation_s": dice.whole(10, 30), "before_timeout_s": dice.whole(20, 60),
                             "every_s": dice.whole(20, 60)}},
            {"position_reports": {"every_s": dice.whole(5, 20), "at_groups": dice.chance(0.5)}}])
        at, to = first, begin
        while to < min(end + 800, self.length + 1500):
            far = max(to, at) + dice.tens(1500 + self.sizes.ahead, 3500 + self.sizes.ahead)
            to = min(far, self.length + self.sizes.last_authority)
            orders = [self.authority(to)]
            self.mode_profile(orders, max(at, begin), to, 0.3)
            for _ in range(dice.whole(0, 2)):
                orders.append(self.restriction(max(at, begin) + 200, to))
            self.send(at, orders)
            for _ in range(dice.whole(0, 2)):
                place = at + dice.tens(0, 300)
                if self.sizes.ahead and place < begin:  # the transition buffer keeps the authority and two more
                    continue
                self.send(place, [self.rare(self.behind(place)["at_m"], by_radio=True)])
            self.trouble(max(at, begin), to)
            at = max(at + 400, to - dice.tens(900, 1600) - self.sizes.ahead)
        if end < self.length and (last := self.ahead(end + 300)) is not None:
            last["orders"].append({"session": {"establish": False, **RBC}})

    def trouble(self, at, to):
        """Now and then the radio block centre takes something back on the way, and lifts it when the train has stood."""
        dice = self.dice
        if not self.sizes.stops or not dice.chance(0.6) or to - at < 1200:
            return
        at += dice.tens(100, 400)
        stop = at + dice.tens(700, 1000)
        lrbg = self.behind(at)
        if lrbg is None or stop > to:
            return
        kind = dice.one_of(("nearer", "shortening", "conditional stop", "emergency stop", "shifted", "SR", "track ahead free"))
        wait = dice.whole(20, 90)
        emergency = dice.whole(0, 15)
        if kind == "nearer":
            self.send(at, [self.authority(stop)])
            self.send(at, [self.authority(to)], delay=wait)
        elif kind == "shortening":
            self.send(at, message={"NID_MESSAGE": 9, "packets": [self.packet_15(stop - lrbg["at_m"])]})
            self.send(at, [self.authority(to)], delay=wait)
        elif kind == "conditional stop":
            self.send(at, message={"NID_MESSAGE": 15, "NID_EM": emergency, "Q_SCALE": 1, "D_REF": 0, "Q_DIR": 1,
                                   "D_EMERGENCYSTOP": stop - lrbg["at_m"]})
            self.send(at, message={"NID_MESSAGE": 18, "NID_EM": emergency}, delay=wait)
            self.send(at, [self.authority(to)], delay=wait + 3)
        elif kind == "emergency stop" and at > 0.5 * self.length:
            self.send(at, message={"NID_MESSAGE": 16, "NID_EM": emergency})
            self.send(at, message={"NID_MESSAGE": 18, "NID_EM": emergency}, delay=wait)
            self.send(at, message={"NID_MESSAGE": 6}, delay=wait + 2)
            self.send(at, [self.authority(to)], delay=wait + 5)
        elif kind == "shifted":
            self.send(at, message=self.shifted_authority(lrbg["at_m"], at - lrbg["at_m"], to))
        elif kind == "SR":
            self.send(at, message={"NID_MESSAGE": 2, "Q_SCALE": 1, "D_SR": dice.tens(500, 3000)})
        elif kind == "track ahead free":
            self.send(at, message={"NID_MESSAGE": 34, "Q_SCALE": 1, "D_REF": 0, "Q_DIR": 1,
                                   "D_TAFDISPLAY": at - lrbg["at_m"], "L_TAFDISPLAY": dice.tens(200, 900)})

    @staticmethod
    def packet_15(length):
        return {"NID_PACKET": 15, "Q_DIR": 1, "Q_SCALE": 1, "V_EMA": 0, "T_EMA": 1023, "sections": [], "L_ENDSECTION": length,
                "Q_SECTIONTIMER": 0, "Q_ENDTIMER": 0, "Q_DANGERPOINT": 0, "Q_OVERLAP": 0}

    def shifted_authority(self, lrbg_m, D_REF, to):
        """Message 33: everything counts from a place that lies D_REF beyond the LRBG."""
        begin, far = lrbg_m + D_REF, to + 200
        gradients = [[max(a, begin) - begin, v] for a, b, v in self.gradient if b > begin and a < far]
        speeds = [[max(a, begin) - begin, v // 5] for a, b, v in self.ssp if b > begin and a < far]

        def chain(steps, last, write):
            """Distances from step to step; the last one ends the profile."""
            steps = steps + [[far - begin, last]]
            before = [0] + [step[0] for step in steps]
            return [write(place - before[i], value) for i, (place, value) in enumerate(steps)]

        G = chain(gradients, None, lambda d, v: {"D_GRADIENT": d, "Q_GDIR": 0 if v is None or v < 0 else 1, "G_A": 255 if v is None else abs(v)})
        V = chain(speeds, 127, lambda d, v: {"D_STATIC": d, "V_STATIC": v, "Q_FRONT": 0, "diffs": []})
        return {"NID_MESSAGE": 33, "M_ACK": 1, "Q_SCALE": 1, "D_REF": D_REF, "packets": [
            self.packet_15(to - begin),
            {"NID_PACKET": 21, "Q_DIR": 1, "Q_SCALE": 1, **G[0], "steps": G[1:]},
            {"NID_PACKET": 27, "Q_DIR": 1, "Q_SCALE": 1, **V[0], "steps": V[1:]}]}

    def restriction(self, begin, end):
        dice = self.dice
        if self.sizes.ahead:
            begin += self.sizes.ahead
            end = max(end, begin + 500)
        start = begin + dice.tens(0, max(0, end - begin - 100))
        restriction = {"NID_TSR": self.next_TSR, "from_m": start, "to_m": start + dice.tens(100, 900),
                       "kmh": dice.one_of((20, 40, 60, 80, 100))}
        self.next_TSR = self.next_TSR % 254 + 1
        return {"temporary_speed_restriction": restriction}

    def announce_levels(self):
        for section in self.sections[1:]:
            border = section["from_m"]
            order = {"at_m": border, "level": section["level"]}
            if section["level"] == "NTC":
                order["nid_ntc"] = 1
            for group in self.groups:
                first, last = self.sizes.before_border
                by_chance = border - 1700 <= group["at_m"] < border - 300 and self.dice.chance(0.8)
                announces = (by_chance or self.sizes.all_announce) and border - first <= group["at_m"] < border - last
                if announces:
                    acknowledge = self.dice.tens(100, 300)
                    group["orders"].insert(0, {"level_transition": {**order, "acknowledge_m": acknowledge}})
            if section["level"] == "1":
                # Without an authority the train would trip at the border: it waits for it in the transition buffer.
                last = self.behind(border - 300)
                if self.sizes.stops or not any("level_transition" in o for o in last["orders"]):  # two make the group inconsistent
                    last["orders"].insert(0, {"level_transition": {**order, "acknowledge_m": 200}})
                last["orders"].append(self.authority(border + (self.sizes.ahead or self.dice.tens(300, 600))))
            at_border = next(g for g in self.groups if g["at_m"] == border)
            at_border["orders"].insert(0, {"level_transition": {**order, "acknowledge_m": 0}})

    # What lies on the line without regard to level.
    def decorate(self):
        for group in self.groups:
            if len(group["orders"]) > 2 or not self.dice.chance(0.55):
                continue
            if any("infill" in order for order in group["orders"]):
                continue
            group["orders"].append(self.rare(group["at_m"]))
        self.radio.sort(key=lambda entry: (entry["at_m"], entry.get("delay_s", 0)))

    def rare(self, at, by_radio=False):
        """One order that any section may send."""
        dice = self.dice
        start, length = dice.tens(200, 1500), dice.tens(100, 800)
        profile = {"Q_DIR": 1, "Q_SCALE": 1}
        track = {**profile, "Q_TRACKINIT": 0}
        text = {**profile, "Q_TEXTCLASS": dice.whole(0, 1), "Q_TEXTDISPLAY": dice.whole(0, 1), "D_TEXTDISPLAY": dice.tens(0, 500),
                "M_MODETEXTDISPLAY_START": 15, "M_LEVELTEXTDISPLAY_START": 5, "L_TEXTDISPLAY": dice.tens(100, 1500),
                "T_TEXTDISPLAY": dice.whole(5, 60), "M_MODETEXTDISPLAY_END": 15, "M_LEVELTEXTDISPLAY_END": 5}
        confirm = {"Q_TEXTCONFIRM": dice.one_of(self.sizes.consents), "Q_CONFTEXTDISPLAY": dice.whole(0, 1), "Q_TEXTREPORT": 0}
        choices = [
            lambda: self.restriction(at + 200, at + 2500),
            lambda: self.restriction(at + 100, at + 1500),
            lambda: {"revoke_temporary_speed_restriction": dice.whole(1, max(1, self.next_TSR - 1))},
            lambda: {"text": {"text": dice.one_of(("Mind the works", "Platform 3", "Call the signaller")), "for_s": dice.whole(5, 60)}},
            lambda: {"packet": {"NID_PACKET": 72, **text, **confirm, "text": [{"X_TEXT": ord(c)} for c in "Confirm"]}},
            lambda: {"packet": {"NID_PACKET": 76, **text, **confirm, "Q_TEXT": dice.whole(0, 1)}},
            lambda: {"packet": {"NID_PACKET": 68, **track, "D_TRACKCOND": start, "L_TRACKCOND": length, "M_TRACKCOND": dice.whole(0, 9),
                                "conditions": [{"D_TRACKCOND": length, "L_TRACKCOND": 200, "M_TRACKCOND": dice.whole(0, 9)}]}},
            lambda: {"packet": {"NID_PACKET": 69, **track, "D_TRACKCOND": start, "L_TRACKCOND": length, "M_PLATFORM": dice.whole(0, 13),
                                "Q_PLATFORM": dice.whole(0, 2), "platforms": []}},
            lambda: {"packet": {"NID_PACKET": 70, **track, "D_SUITABILITY": start + 1500, "Q_SUITABILITY": 1,
                                "M_AXLELOADCAT": dice.whole(0, 12), "points": []}},
            lambda: {"packet": {"NID_PACKET": 71, **profile, "D_ADHESION": start, "L_ADHESION": length, "M_ADHESION": dice.whole(0, 1)}},
            lambda: {"packet": {"NID_PACKET": 51, **track, "D_AXLELOAD": start, "L_AXLELOAD": length, "Q_FRONT": dice.whole(0, 1),
                                "categories": [{"M_AXLELOADCAT": dice.whole(0, 12), "V_AXLELOAD": dice.whole(8, 20)}], "restrictions": []}},
            lambda: {"packet": {"NID_PACKET": 52, **track, "D_PBD": dice.tens(500, 900), "Q_GDIR": dice.whole(0, 1), "G_PBDSR": dice.whole(0, 10),
                                "Q_PBDSR": dice.whole(0, 1), "D_PBDSR": start, "L_PBDSR": length, "restrictions": []}},
            lambda: {"packet": {"NID_PACKET": 88, **profile, "NID_LX": dice.whole(0, 255), "D_LX": start + 400, "L_LX": 20,
                                "Q_LXSTATUS": 1, "V_LX": dice.whole(4, 12), "Q_STOPLX": 0}},
            lambda: {"packet": {"NID_PACKET": 39, **profile, "D_TRACTION": start, "M_VOLTAGE": 1, "NID_CTRACTION": dice.whole(1, 30)}},
            lambda: {"packet": {"NID_PACKET": 40, **profile, "D_CURRENT": start, "M_CURRENT": dice.whole(0, 100)}},
            lambda: {"packet": {"NID_PACKET": 79, **profile, "Q_NEWCOUNTRY": 0, "NID_BG": self.ahead(at)["NID_BG"], "D_POSOFF": 10,
                                "Q_MPOSITION": 1, "M_POSITION": 100000 + at, "references": []}},
            lambda: {"packet": {"NID_PACKET": 138, **profile, "D_STARTREVERSE": start, "L_REVERSEAREA": length}},
            lambda: {"packet": {"NID_PACKET": 139, **profile, "D_REVERSE": 500, "V_REVERSE": 6}},
            lambda: {"packet": {"NID_PACKET": 141, "Q_DIR": 1, "Q_GDIR": dice.whole(0, 1), "G_TSR": dice.whole(0, 20)}},
            lambda: {"packet": {"NID_PACKET": 140, "Q_DIR": 1, "NID_OPERATIONAL": 0x4712FFFF}},
            lambda: {"packet": {"NID_PACKET": 45, "Q_DIR": 1, "NID_MN": 0xFFFFFF}},
        ]
        in_groups_only = [
            lambda: {"packet": {"NID_PACKET": 67, **profile, "D_TRACKCOND": start, "L_TRACKCOND": length, "areas": []}},
            lambda: {"packet": {"NID_PACKET": 132, "Q_DIR": 1, "Q_ASPECT": dice.whole(0, 1)}},
            lambda: {"packet": {"NID_PACKET": 137, "Q_DIR": 1, "Q_SRSTOP": 0 if at < 200 else dice.whole(0, 1)}},
            lambda: {"packet": {"NID_PACKET": 46, "Q_DIR": 1, "M_LEVELTR": 2, "levels": [{"M_LEVELTR": 3}, {"M_LEVELTR": 0}]}},
            lambda: {"packet": {"NID_PACKET": 145, "Q_DIR": 1}},
            lambda: {"packet": {"NID_PACKET": 180, "Q_DIR": 1, "Q_LSSMA": 1, "T_LSSMA": dice.whole(5, 60)}},
            lambda: {"packet": {"NID_PACKET": 181, "Q_DIR": 1}},
            lambda: {"packet": {"NID_PACKET": 254, "Q_DIR": 1}},
        ]
        by_radio_only = [lambda: {"packet": {"NID_PACKET": 64, "Q_DIR": 1}}]
        order = dice.one_of(choices + (by_radio_only if by_radio else in_groups_only))()
        number = order.get("packet", {}).get("NID_PACKET")
        misplaced = number == 141 if by_radio else number == 140  # the message is inconsistent
        if not self.sizes.stops and (number in STOPPING or misplaced):
            return {"text": {"text": "Nothing here", "for_s": 10}}
        return order

    def description(self):
        first = self.sections[0]["level"]
        start = {"front_m": -40, "level": first}
        if first == "NTC":
            start["nid_ntc"] = 1
        levels = " > ".join(section["level"] for section in self.sections)
        for group in self.groups:
            if group["orders"] and self.sizes.balises:
                group["balises"] = self.sizes.balises
            elif len(group["orders"]) > 2:
                group["balises"] = 5
            elif not group["orders"] and self.sizes.stops and self.dice.chance(0.15):  # of one balise: without an orientation
                group["balises"] = 1
        return {"schema": "evc-line-description/1", "name": f"random line {self.seed}", "about": f"levels {levels}", "NID_C": NID_C,
                "length_m": self.length, "start": start, "gradient": self.gradient, "ssp": self.ssp,
                "groups": [g if g["orders"] else {k: v for k, v in g.items() if k != "orders"} for g in self.groups], "radio": self.radio}


def main():
    parser = command_line.Parser(__doc__)
    parser.add_argument("--seed", type=command_line.whole(0), required=True)
    options = parser.parse_args()
    json.dump(RandomLine(options.seed).description(), sys.stdout, indent=1)
    print()


if __name__ == "__main__":
    command_line.run(main)
