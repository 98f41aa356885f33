# SPDX-License-Identifier: LGPL-2.1-or-later
"""The figures of wear_loop.py: profile.svg, depth.svg, conicity.svg, rate.svg."""
import matplotlib

matplotlib.use("Agg")
matplotlib.rcParams.update({"svg.fonttype": "none", "svg.hashsalt": "rollfem", "path.simplify_threshold": 0.5,
                            "axes.spines.top": False, "axes.spines.right": False, "axes.grid": True, "grid.color": "#dddddd",
                            "axes.axisbelow": True, "legend.frameon": False})
import matplotlib.pyplot as plt
import numpy as np

COLOURS = plt.get_cmap("viridis")


def depth_over(new, worn):
    """(y, depth along the normal, mm) of a worn profile below a new one, by the tangent of the new one at the same y."""
    order = np.concatenate([[True], np.diff(np.maximum.accumulate(worn.y)) > 0.0])
    slope = np.gradient(new.z, new.along) / np.maximum(np.gradient(new.y, new.along), 1e-6)
    return new.y, (new.z - np.interp(new.y, worn.y[order], worn.z[order])) / np.sqrt(1.0 + slope**2)


def shown(profiles):
    """Every fourth of 20 profiles, and the last; with their colours."""
    steps = sorted({*range(0, len(profiles), max(1, (len(profiles) - 1) // 5)), len(profiles) - 1})
    return [(k, COLOURS(0.9 * k / max(1, len(profiles) - 1))) for k in steps]


def save(figure, folder, name):
    figure.tight_layout()
    figure.savefig(folder / f"{name}.svg", metadata={"Date": None})
    figure.savefig(folder / f"{name}.png", dpi=110)
    plt.close(figure)


def draw(folder, profiles, history, distance):
    new, along = profiles[0], np.array([row["distance"] for row in history]) / 1e3
    names = {k: f"{k * distance:,.0f} km".replace(",", " ") for k in range(len(profiles))}
    figure, axes = plt.subplots(figsize=(7.5, 3.4))
    for k, colour in shown(profiles):
        axes.plot(profiles[k].y, profiles[k].z, color=colour, linewidth=1.1, label=names[k])
    axes.set(xlabel="y of the profile, to the field side [mm]", ylabel="z of the tread, enlarged [mm]", xlim=(-35, 40), ylim=(5, -1.5))
    axes.legend(fontsize="small")
    save(figure, folder, "profile")

    figure, axes = plt.subplots(figsize=(7.5, 3.2))
    for k, colour in shown(profiles)[1:]:
        axes.plot(*depth_over(new, profiles[k]), color=colour, label=names[k])
    axes.set(xlabel="y of the profile, to the field side [mm]", ylabel="depth [mm]", xlim=(-45, 40))
    axes.invert_yaxis()
    axes.legend(fontsize="small")
    save(figure, folder, "depth")

    figure, (left, right) = plt.subplots(1, 2, figsize=(9.0, 3.2))
    left.plot(along, [row["conicity"] for row in history], "o-", color="black", markersize=3)
    left.set(xlabel="distance [1000 km]", ylabel="equivalent conicity at 3 mm [-]", ylim=(0, None))
    for k, colour in shown(profiles):
        right.plot(history[k]["lateral_shift"], history[k]["y_wheel"], color=colour, label=names[k])
    right.set(xlabel="lateral shift to the right [mm]", ylabel="y of the contact, right wheel [mm]")
    right.legend(fontsize="small")
    save(figure, folder, "conicity")

    figure, (left, right) = plt.subplots(1, 2, figsize=(9.0, 3.2))
    left.stairs([row["area"] / distance * 1e4 for row in history[:-1]], along, color="black")
    left.set(xlabel="distance [1000 km]", ylabel="removed area [mm² in 10 000 km]", ylim=(0, None))
    right.stairs([row["work"] for row in history[:-1]], along, color="black", baseline=None)
    right.set(xlabel="distance [1000 km]", ylabel="mean frictional work [J/m]", ylim=(0, None))
    save(figure, folder, "rate")
