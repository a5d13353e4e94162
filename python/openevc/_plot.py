"""The chart of braking curves, with matplotlib."""
import matplotlib.pyplot as plt
import numpy as np

GROUND, GRID, INK = "#031122", "#21314A", "#C3C3C3"


def draw(picture, ax=None):
    """Draws what `evc curves --plot` draws: the most restrictive of all targets over the line."""
    if ax is None:
        ax = plt.subplots(figsize=(10, 5.5), layout="constrained")[1]
    ax.set_facecolor(GROUND)
    x = picture["x_m"]
    for curve in picture["curves"]:
        dash = [float(part) for part in curve["dash"].split()]
        style = (0, tuple(part / curve["width"] for part in dash)) if dash else "-"
        ax.plot(x, curve["v_kmh"], color=curve["colour"], linewidth=curve["width"], linestyle=style, label=curve["name"])
    for place, name in picture["marks"]:
        ax.axvline(place, color=INK, linewidth=0.8, linestyle=":")
        ax.annotate(name, (place, 1.0), xycoords=("data", "axes fraction"), xytext=(-3, -4), textcoords="offset points",
                    rotation=90, ha="right", va="top", color=INK, fontsize=8, zorder=5,
                    bbox={"facecolor": GROUND, "edgecolor": "none", "pad": 1.0})
    release, start = picture["V_release_kmh"], picture["start_of_RSM_m"]
    if release is not None and start is not None:
        end = max(place for place, _ in picture["marks"])
        ax.plot([start, end], [release, release], color="#FFFFFF", linewidth=1.5, linestyle=(0, (1, 1)),
                label=f"release speed {release:g} km/h")
    ax.set_xlim(picture["from_m"], picture["to_m"])
    ax.set_ylim(0.0, picture["top_kmh"])
    ax.set_yticks(np.arange(0.0, picture["top_kmh"] + 1.0, 20.0))
    ax.set_xlabel("place on the line, m")
    ax.set_ylabel("speed, km/h")
    ax.grid(color=GRID, linewidth=0.6)
    ax.legend(loc="lower left", fontsize=8, facecolor=GROUND, edgecolor=GRID, labelcolor=INK)
    return ax
