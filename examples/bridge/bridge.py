#!/usr/bin/env python3
"""Drives a train over `evc serve`: a small simulator of the world outside, which another simulator would replace.

The on-board is behind a TCP port. Each cycle the bridge sends what happened as lines of JSON, ends the cycle, and reads
one line: what the on-board shows, asks for and orders. Nothing but the standard library is needed.

Usage: bridge.py LINE.json [--port P | --start COMMAND] [--stop-at METRES]"""
import argparse
import json
import math
import socket
import subprocess
import sys

CYCLE_S = 0.1
ANTENNA_M = 5.0  # from the front end back to the balise antenna, as in the standard train
LONGEST_S = 3600.0

# What the driver does when the on-board asks for it (`driver.requests`).
ANSWERS = {
    "enter driver_id": {"enter": {"driver_id": "4711"}},
    "enter level": {"enter": {"level": "1"}},
    "enter train_data": {"enter": {"train_data": {"schema": "etcs-train/1"}}},
    "enter train_running_number": {"enter": {"train_running_number": "4711"}},
    "start": {"select": "start"},
}
ACKNOWLEDGED = {"SR", "OS", "LS", "SH", "level", "text", "brake", "trip"}


class Unit:
    """The on-board behind the port: one connection is one unit."""

    def __init__(self, port, configuration):
        try:
            self.connection = socket.create_connection(("127.0.0.1", port))
        except (OSError, OverflowError) as wrong:
            reason = getattr(wrong, "strerror", None) or wrong
            raise SystemExit(f"bridge: --port {port}: found {reason}, expected evc serve there") from None
        self.lines = self.connection.makefile("r", encoding="utf-8")
        self.unsent = [{"config": configuration}]

    def tell(self, t_ms, **inputs):
        """An input: what is sent until the cycle ends counts for it."""
        self.unsent.append({"t_ms": t_ms, **inputs})

    def cycle(self, t_ms):
        """Ends a cycle. What the on-board answers; SystemExit with its words if something that was sent is wrong."""
        self.tell(t_ms, end=True)
        self.connection.sendall("".join(json.dumps(line) + "\n" for line in self.unsent).encode())
        self.unsent = []
        line = self.lines.readline()
        answer = json.loads(line) if line else {"error": "the on-board has gone"}
        if "error" in answer:
            raise SystemExit(f"bridge: {answer['error']}")
        return answer


class Train:
    """A point with a speed, and an odometer that is wrong by at most 2 %."""

    def __init__(self, front_m):
        self.start_m = self.front_m = front_m
        self.speed = self.acceleration = 0.0  # m/s, m/s2

    def move(self, wanted):
        self.acceleration = max(wanted, -self.speed / CYCLE_S)
        self.front_m += (self.speed + self.acceleration * CYCLE_S / 2) * CYCLE_S
        self.speed += self.acceleration * CYCLE_S

    def counter(self, place_m):
        """The odometer's counter when the front end was there: counters begin with 0 at power-up."""
        return place_m - self.start_m

    def odometer(self):
        run = self.counter(self.front_m)
        return {"nominal_m": run, "min_m": 0.98 * run, "max_m": 1.02 * run, "speed_mps": self.speed,
                "speed_min_mps": 0.98 * self.speed, "speed_max_mps": 1.02 * self.speed, "accel_mps2": self.acceleration}


def driver_answers(state):
    """What the driver does about the last state: acknowledgements are one input, anything else one each."""
    requests = state["driver"]["requests"]
    acknowledged = [name for name in requests if name in ACKNOWLEDGED]
    return [ANSWERS[name] for name in requests if name in ANSWERS] + ([{"ack": acknowledged}] if acknowledged else [])


def wanted_acceleration(state, train, stop_at_m):
    """The brakes that the on-board commands come first; else the driver keeps below the permitted speed and stops at
    the place, with 0.5 m/s2."""
    if state["eb"]:
        return -1.2
    if state["sb"]:
        return -0.8
    if state["mode"] == "SB" or state["V_P"] is None:
        return -0.5
    permitted = max(0.0, (state["V_P"] - 5.0) / 3.6)
    left_m = stop_at_m - train.front_m
    speed = min(permitted, math.sqrt(2 * 0.5 * left_m) if left_m > 0.5 else 0.0)
    return min(0.0 if state["tco"] else 0.5, max(-0.7, (speed - train.speed) / CYCLE_S))


def drive(unit, line, stop_at_m):
    """From power-up to the standstill at the place. Returns the modes, and the cycles with a brake command on the way."""
    train = Train(line["start"]["front_m"])
    balises = sorted((balise["position_m"], balise["telegram_hex"])
                     for group in line["balise_groups"] for balise in group["balises"])
    unit.tell(0, train={"desk_open": True})
    modes, braked, t_ms, state = [], 0, 0, None
    while t_ms < 1000 * LONGEST_S:
        if state is not None:
            for action in driver_answers(state):
                unit.tell(t_ms, driver=action)
            if state["radio_connect"]:  # there is no RBC here
                unit.tell(t_ms, radio={"session": "refused"})
            train.move(wanted_acceleration(state, train, stop_at_m))
        while balises and balises[0][0] + ANTENNA_M <= train.front_m:
            place_m, telegram = balises.pop(0)
            unit.tell(t_ms, balise={"telegram": telegram, "at_m": train.counter(place_m + ANTENNA_M)})
        unit.tell(t_ms, odometer=train.odometer())
        state = unit.cycle(t_ms)
        if state["mode"] not in modes[-1:]:
            modes.append(state["mode"])
            print(f"{t_ms / 1000:7.1f} s  {train.front_m:8.1f} m  {3.6 * train.speed:5.1f} km/h  {state['mode']}, level {state['level']}")
        braked += train.speed > 0 and (state["sb"] or state["eb"])
        if train.speed == 0.0 and train.front_m > stop_at_m - 5.0:
            print(f"{t_ms / 1000:7.1f} s  {train.front_m:8.1f} m  stands")
            return modes, braked
        t_ms += round(1000 * CYCLE_S)
    raise SystemExit(f"bridge: found the train at {train.front_m:.1f} m after an hour, expected it at {stop_at_m:.1f} m")


def read_line(name):
    """A line file; SystemExit with what is wrong."""
    try:
        with open(name, encoding="utf-8") as file:
            line = json.load(file)
    except (ValueError, RecursionError) as wrong:
        raise SystemExit(f"bridge: {name}: found {wrong}, expected JSON") from None
    if not isinstance(line, dict) or line.get("schema") != "etcs-line/1":
        raise SystemExit(f"bridge: {name}: /schema: found another document, expected \"etcs-line/1\"")
    return line


class Parser(argparse.ArgumentParser):
    """Says what is wrong in one line."""

    def error(self, message):
        self.exit(2, f"bridge: {message}\n")


def main():
    parser = Parser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("line", help="line file (etcs-line/1)")
    where = parser.add_mutually_exclusive_group()
    where.add_argument("--port", type=int, default=8026, help="port of a server that runs")
    where.add_argument("--start", metavar="COMMAND", help="starts this evc with a port of its own, and ends it")
    parser.add_argument("--stop-at", type=float, default=3500.0, help="place of the front end, m along the line")
    given = parser.parse_args()
    line = read_line(given.line)
    server = None
    if given.start:
        server = subprocess.Popen([given.start, "serve", "--port", "0"], stdout=subprocess.PIPE, text=True)
        port = server.stdout.readline().rstrip("/\n").rpartition(":")[2]
        if not port.isdigit():  # it has said why
            server.wait()
            return 2
        given.port = int(port)
    try:
        modes, braked = drive(Unit(given.port, {"cycle_ms": round(1000 * CYCLE_S)}), line, given.stop_at)
    finally:
        if server:
            server.terminate()
            ended = server.wait()
    print(f"modes {' > '.join(modes)}, {braked} cycles with a brake command")
    if server and ended != 0:
        raise SystemExit(f"bridge: found the exit status {ended} of evc serve, expected 0")
    return 0 if "FS" in modes and braked == 0 else 1


def ended():
    """The exit status: 2 for what is wrong with the command line, a file, or the connection, with a sentence."""
    try:
        return main()
    except OSError as wrong:
        print("bridge:", ": ".join(str(part) for part in (wrong.filename, wrong.strerror or wrong) if part), file=sys.stderr)
    except SystemExit as wrong:
        if not isinstance(wrong.code, str):
            raise
        print(wrong.code, file=sys.stderr)
    return 2


if __name__ == "__main__":
    sys.exit(ended())
