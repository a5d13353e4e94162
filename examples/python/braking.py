#!/usr/bin/env python3
# %% [markdown]
# Braking with openevc: curves of a train, limits of many trains, a journey, the unit by hand. Editors that know cells
# ("# %%") run it step by step; as a program it writes its pictures into a folder: braking.py [FOLDER]
import pathlib
import sys

import matplotlib.pyplot as plt
import numpy as np

import openevc as evc

folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "plots")
if len(sys.argv) > 2 or str(folder).startswith("-"):
    print("braking.py: found", *sys.argv[1:], "- expected the name of a folder", file=sys.stderr)
    sys.exit(2)
try:
    folder.mkdir(parents=True, exist_ok=True)
except OSError as wrong:
    print(f"braking.py: {folder}: {wrong.strerror}, expected a folder", file=sys.stderr)
    sys.exit(2)


def save(figure, name):
    figure.savefig(folder / name, dpi=110)
    plt.close(figure)


# %% One train before an end of authority: the chart of `evc curves --plot`, and where the limits are at 140 km/h.
eoa = {"type": "EOA_SvL", "location_m": 6000, "release_speed_kmh": 30}
curves = evc.curves(train="regional_multiple_unit", target=eoa, speeds_kmh=[100, 140])
places = {name: round(float(curves[name][1])) for name in ("EBI", "SBI1", "W", "P", "I")}
print("at 140 km/h, metres before the stop:", places)
save(curves.plot().figure, "curves.png")

# %% Many trains: 9 brake percentages, 80 speeds, 3 gradients, all by broadcasting.
percentages = np.arange(70, 151, 10)
trains = [{"brake_percentage": int(percentage), "length_m": 200} for percentage in percentages]
speeds = np.linspace(1.0, 160.0, 80)
figure, axes = plt.subplots(1, 3, figsize=(11, 4.2), sharey=True, layout="constrained")
for ax, gradient in zip(axes, (-15, 0, 15)):
    limits = evc.limits(trains, speeds[:, None], eoa, track={"gradient": [[-20000, gradient]]}, columns=("EBI", "P"))
    lines = ax.plot(speeds, limits["P"])
    for line, percentage, colour in zip(lines, percentages, plt.cm.viridis(np.linspace(0, 0.9, len(percentages)))):
        line.set(color=colour, label=f"{percentage} %")
    ax.set(title=f"gradient {gradient} per mille", xlabel="speed, km/h")
    ax.grid(alpha=0.3)
axes[0].set_ylabel("permitted speed limit, m before the stop")
axes[0].legend(title="brake percentage", fontsize=8, ncols=2)
save(figure, "limits.png")

# %% A journey under supervision: the driver ignores the permitted speed, and the on-board brakes.
run = evc.run("brunnental", driver="reckless", seed=7)
trace = run.trace
print(run, "- service brake", run.summary["interventions"]["sb"], "times, smallest margin to the EBI",
      run.summary["min_margin_to_EBI_kmh"], "km/h")
figure, ax = plt.subplots(figsize=(11, 4.2), layout="constrained")
place = trace["est_front_m"] / 1000.0
for name, label, colour in (("V_EBI", "EBI", "#BF0002"), ("V_SBI", "SBI", "#EA9100"), ("V_P", "permitted", "#B8A800"),
                            ("v_kmh", "speed", "#0B1B2E")):
    ax.plot(place, trace[name], color=colour, linewidth=1.2, label=label)
for name, label, colour in (("sb", "service brake", "#EA9100"), ("eb", "emergency brake", "#BF0002")):
    begins = np.flatnonzero(np.diff(trace[name].astype(int)) == 1) + 1
    ax.plot(place[begins], trace["v_kmh"][begins], "v", color=colour, markersize=6, label=label, zorder=3)
ax.set(xlabel="estimated front end, km", ylabel="speed, km/h", ylim=(0, 200))
ax.grid(alpha=0.3)
ax.legend(ncols=6, fontsize=8, loc="upper center")
save(figure, "journey.png")

# %% The unit by hand: from power-up to the dialogue of the start of mission; a snapshot goes on from its moment.
unit = evc.OnBoard({"train": "regional_multiple_unit"})
unit.step(train={"desk_open": True})
before = unit.snapshot()
out = unit.step(driver={"enter": {"driver_id": "1234"}})
print("mode", out["mode"], "- dialogue", out["dialogue"]["step"], "waits for", out["dialogue"]["waits_for"])
unit.restore(before)
assert unit.t_ms == 0

# %% The language: a telegram as a dictionary, changed, and encoded again.
telegram = evc.decode.balise("A1027F802015505023A0E0D480C8087F8")
telegram["packets"][0]["V_TSR"] = 12
print("restriction to 60 km/h:", evc.encode.balise(telegram))

# %% An error has the sentence of the command, and its parts.
try:
    evc.curves(train={"brake_percentage": -5}, target=eoa)
except evc.InputError as error:
    print(error)
    assert error.where == "/train/brake_percentage"
