# SPDX-License-Identifier: LGPL-2.1-or-later
"""The figures of hunting.py."""
import matplotlib

matplotlib.use("Agg")
matplotlib.rcParams.update({"svg.fonttype": "none", "svg.hashsalt": "rollfem", "path.simplify_threshold": 0.5,
                            "axes.spines.top": False, "axes.spines.right": False, "axes.grid": True, "grid.color": "#dddddd",
                            "axes.axisbelow": True, "legend.frameon": False})
import matplotlib.pyplot as plt

import runs


def draw(folder, contact, critical, series, speeds, curve):
    """hunting.svg: growth over speed and two time series; curve.svg: shift and forces."""
    figure, (left, right) = plt.subplots(1, 2, figsize=(9.0, 3.2))
    left.plot(speeds, [runs.mode_at(speed, contact)[0] for speed in speeds], color="black", label="linear")
    left.axhline(0.0, color="gray", linewidth=0.8)
    for (factor, (t, y)), colour in zip(series.items(), ("#0072B2", "#D55E00")):
        left.plot(factor * critical, runs.growth(t, y[0]), "o", color=colour, label=f"time series, {factor * critical:.0f} m/s")
        right.plot(t, 1e3 * y[0], color=colour, label=f"{factor * critical:.0f} m/s")
    left.set(xlabel="speed [m/s]", ylabel="growth of hunting [1/s]")
    left.legend()
    right.set(xlabel="time [s]", ylabel="lateral shift [mm]")
    right.legend(loc="upper left")
    figure.tight_layout()
    figure.savefig(folder / "hunting.svg", metadata={"Date": None})

    t, y, times, forces = curve
    figure, (left, right) = plt.subplots(1, 2, figsize=(9.0, 3.2))
    left.plot(t, 1e3 * y[0], color="#0072B2", label="lateral shift")
    left.plot(t, 1e3 * y[2], "--", color="#D55E00", label="yaw")
    left.set(xlabel="time [s]", ylabel="lateral shift [mm], yaw [mrad]")
    left.legend()
    for wheel, name in enumerate(("outer", "inner")):
        for axis, (way, style) in enumerate((("along", "-"), ("across", "--"))):
            right.plot(times, 1e-3 * forces[:, wheel, axis], style, color=("#D55E00", "#0072B2")[wheel], label=f"{name}, {way}")
    right.set(xlabel="time [s]", ylabel="force on the wheel [kN]")
    right.legend(fontsize="small")
    figure.tight_layout()
    figure.savefig(folder / "curve.svg", metadata={"Date": None})
