# SPDX-License-Identifier: LGPL-2.1-or-later
"""Kalker's linear theory."""
import numpy as np
from matplotlib import pyplot as plt

from .. import linear_theory, published, style
from ..chapter import Chapter, Cost, Row, Table

# Tolerances of the half-space at 40 across. The edge of its ellipse is a staircase, with an error of 0.5 % in the size
# of the patch; forces depend on its square, forces of spin on its cube, the moment of spin on its fourth power.
_STAIRCASE = {"C11": 0.01, "C22": 0.01, "C23": 0.015, "C33": 0.02, "C32": 0.015}
# a/b above which 40 elements along rolling are longer than b/8 and too few for C33.
_LONG = 2.5
_NAMES = ("C11", "C22", "C23", "C33")
_POISSON = ((0.0, 0.0), (0.25, 0.25), (0.5, 0.4999))  # as printed and as used
# a/b at which the series is recomputed; 0.45 and 4 lie between the entries of the program's table.
_SUMMED = (0.1, 0.45, 1.0, 4.0, 10.0)
# a/b of the half-space that are also solved on finer elements for C33, and of a test.
_FINE = (0.1, 0.5, 1.0, 2.0, 5.0, 10.0)


def _coefficients_of(model, g=82e3, c=6.0):
    """C11, C22, C23, C33, -C32 of three load points: xi = 1e-5, eta = 1e-5, phi = 1e-6."""
    along, aside, spin = model.points
    return (-along["longitudinal_force"] / (g * c**2 * 1e-5), -aside["lateral_force"] / (g * c**2 * 1e-5),
            -spin["lateral_force"] / (g * c**3 * 1e-6), -spin["spin_moment"] / (g * c**4 * 1e-6),
            aside["spin_moment"] / (g * c**3 * 1e-5))


def _ellipse(ratio, nu, g=82e3, c=6.0):
    """Settings of the case."""
    return {"given_pressure.semi_axis_x": c * ratio**0.5, "given_pressure.semi_axis_y": c / ratio**0.5,
            "wheel.young_modulus": 2 * g * (1 + nu), "rail.young_modulus": 2 * g * (1 + nu),
            "wheel.poisson_ratio": nu, "rail.poisson_ratio": nu}


def _finer(bench, found, ratio, nu, used, along):
    """C33 of the half-space on this many elements along rolling and 40 across, over that of the table."""
    case = bench.text_file("kalker_cells.toml", bench.case_text("cases/verification/kalker.toml").replace(
        "elements_across = 40", "cell_size = [0.3, 0.3]"))
    cells = f"[{12 * ratio**0.5 / along}, {12 / ratio**0.5 / 40}]"
    model = bench.run(f"kalker_{nu:g}_{ratio:.3f}_{along}", case, ["halfspace"],
                      {**_ellipse(ratio, used), "contact_grid.cell_size": cells})["halfspace"]
    return _coefficients_of(model)[3] / found[ratio, nu]["linear"][3]


def _fine_rows(bench, found):
    """C33 on elements of b/8, and the order with which long patches come to it."""
    rows = []
    for ratio in _FINE:
        for nu, used in _POISSON:
            words = f"C33, nu = {used:g}, a/b = {ratio:g}"
            if ratio > 1.001 * _LONG:
                coarse = abs(found[ratio, nu]["halfspace"][3] / found[ratio, nu]["linear"][3] - 1)
                rows += [Row(f"{words}, {times} times as many along", "", 1, _finer(bench, found, ratio, nu, used, 40 * times),
                             _STAIRCASE["C33"] + coarse / times**2, by="half-space, 40 across") for times in (2, 4)]
            fine = (_finer(bench, found, ratio, nu, used, round(16 * ratio)) if ratio > 1.001 * _LONG else
                    found[ratio, nu]["halfspace"][3] / found[ratio, nu]["linear"][3])
            rows.append(Row(words, "", 1, fine, _STAIRCASE["C33"], by="half-space, elements of b/8"))
    return rows


def _ellipses(bench):
    """({(a/b, nu): {model: coefficients}}, seconds) of the linear theory and of the half-space."""
    found, seconds = {}, 0.0
    for nu, used in _POISSON:
        for ratio in sorted({*published.KALKER[nu], *_SUMMED} if not bench.small else _FINE):
            result = bench.run(f"kalker_{nu:g}_{ratio:.3f}", "cases/verification/kalker.toml", ["linear", "halfspace"],
                               _ellipse(ratio, used))
            seconds += result["halfspace"].seconds["total"]
            found[ratio, nu] = {m.name: _coefficients_of(m) for m in result.models}
    return found, seconds


def _farthest(found, chosen, allowed, by):
    """For every coefficient and nu the row of the largest difference; `chosen` returns (reference, value) or None.

    Differences of C33 are fractions of its value at nu = 0, because Poisson's effect cancels a part of it.
    """
    worst = {}
    for (ratio, nu), models in found.items():
        for k, name in enumerate(_NAMES):
            pair = chosen(ratio, nu, k, models)
            if not pair:
                continue
            whole = {"of": found[ratio, 0.0]["linear"][k], "of_words": "C33 at nu = 0"} if k == 3 and nu else {}
            row = Row(f"{name}, nu = {nu:g}: farthest, at a/b = {ratio:.3g}", "", *pair, allowed(name), by=by, **whole)
            if (name, nu) not in worst or abs(row.difference) > abs(worst[name, nu].difference):
                worst[name, nu] = row
    return list(worst.values())


def _printed_table(found):
    """Kalker's printed values with errors of more than a unit of their third digit."""
    rows = []
    for (ratio, nu), models in sorted(found.items()):
        for k, value in enumerate(published.KALKER[nu].get(ratio, ())):
            computed = models["linear"][k]
            if abs(value - computed) > 10.0**(np.floor(np.log10(value)) - 2):
                rows.append([f"{ratio:.3g}", f"{nu:g}", _NAMES[k], f"{value:g}", f"{computed:.4g}",
                             f"{100 * (value / computed - 1):+.2f} %"])
    count = sum(len(values) for table in published.KALKER.values() for values in table.values())
    return Table(f"The {len(rows)} of {count} printed values with errors of more than a unit of their third digit (computed "
                 "for nu = 0.4999 where 0.5 is printed):", ["a/b", "nu", "", "printed", "computed", "printed minus computed"], rows)


def _long_patches(found):
    """C33 of the half-space on 40 elements along and across, where that is too coarse along rolling."""
    ratios = sorted({ratio for ratio, _ in found if ratio > 1.001 * _LONG})
    rows = [[f"{nu:g}"] + [f"{100 * (found[ratio, nu]['halfspace'][3] / found[ratio, nu]['linear'][3] - 1):+.2f} %" for ratio in ratios]
            for nu in (0.0, 0.25, 0.5)]
    return Table("C33 of long patches, the half-space on 40 by 40 elements against the computed table:",
                 ["nu", *(f"a/b = {ratio:.3g}" for ratio in ratios)], rows)


def _draw_kalker(found):
    """Printed values and the half-space's against the computed table, nu = 0.25."""
    figure, axes = plt.subplots(1, 2, figsize=(8.8, 3.5), sharey=True)
    values = {"Kalker's printed table": {r: published.KALKER[0.25][r] for r in sorted(published.KALKER[0.25])}}
    values["half-space, 40 across"] = {r: found[r, 0.25]["halfspace"] for r in values["Kalker's printed table"]}
    for axis, (words, by_ratio) in zip(axes, values.items()):
        for k, (ink, mark) in enumerate(zip(("#0072B2", "#D55E00", "#009E73", "#CC79A7"), "os^D")):
            axis.semilogx(list(by_ratio), [100 * (by_ratio[r][k] / found[r, 0.25]["linear"][k] - 1) for r in by_ratio], color=ink,
                          linewidth=1.0, marker=mark, markersize=4, label=f"$C_{{{_NAMES[k][1:]}}}$")
        axis.axhline(0, color=style.GREY, linewidth=0.8)
        axis.set_yscale("symlog", linthresh=1)
        axis.set_yticks([-1, -0.5, 0, 0.5, 1, 2, 5, 10], ["-1", "-0.5", "0", "0.5", "1", "2", "5", "10"])
        axis.set_title(words)
        axis.set_xticks([0.1, 0.2, 0.5, 1, 2, 5, 10], ["0.1", "0.2", "0.5", "1", "2", "5", "10"])
        axis.minorticks_off()
        axis.set_xlabel("a/b (a along rolling)")
    axes[0].set_ylabel("difference from the computed table [%]")
    axes[0].legend(ncol=2)
    figure.tight_layout()
    return figure


def kalker(bench):
    """Kalker's linear theory: small creepage and spin"""
    found, seconds = _ellipses(bench)
    rows = [Row("C11 of a circle, nu = 0: 32/(3 pi)", "", 32 / (3 * np.pi), found[1.0, 0.0]["linear"][0], 2e-5,
                by="model linear"),
            Row("C23 of a circle, nu = 0: 4/3", "", 4 / 3, found[1.0, 0.0]["linear"][2], 2e-5, by="model linear")]
    summed = {ratio: linear_theory.coefficients(ratio, (0.0, 0.25, 0.4999), degree=10)
              for ratio in ([1.0] if bench.small else _SUMMED)}

    def of_series(ratio, nu, name):
        return summed[ratio][0.4999 if nu == 0.5 else nu][name][0]
    rows += _farthest(found, lambda ratio, nu, k, models: ratio in summed and
                      (of_series(ratio, nu, _NAMES[k]), models["linear"][k]), lambda name: 2e-4, "model linear against series")
    rows += _farthest(found, lambda ratio, nu, k, models: (k < 3 or ratio < 1.001 * _LONG) and
                      (models["linear"][k], models["halfspace"][k]),
                      _STAIRCASE.get, f"half-space, 40 across, C33 to a/b = {_LONG:g}")
    rows += _fine_rows(bench, found)
    far = max((models["halfspace"][4] / models["linear"][2] - 1 for models in found.values()), key=abs)
    rows.append(Row("-C32 over C23 (reciprocity), farthest", "", 1, 1 + far, _STAIRCASE["C32"], by="half-space, 40 across"))
    name = bench.save(None if bench.small else _draw_kalker(found), "kalker")
    return Chapter(
        "kalker", "Kalker's linear theory: small creepage and spin",
        "Ellipses with a b = 36 mm² under a given pressure, friction effectively unbounded "
        "([case](../../cases/verification/kalker.toml)), nu = 0, 0.25 and 0.4999: the coefficients of the model `linear`, "
        "which come from the program's table (25 ratios, five Poisson's ratios), and of the half-space on 40 "
        "elements across.",
        "Kalker's problem solved by an independent series (`benchmarks/book/linear_theory.py`: no grid, no edge, no printed "
        "value; two degrees agree to five digits, and C32 = -C23 to six, which the series does not assume); for nu = 0 a "
        "circle has closed forms. `benchmarks/kalker_table.py` makes the program's table with it. Kalker's printed table "
        "(1967; 1990, table E.3; C11, C22 and C23 as two public codes have them, C33 checked by CONTACT only) is shown "
        "beside it.",
        rows, tables=[_long_patches(found), _printed_table(found)],
        figures=[(name, "Kalker's printed values (left) and the half-space at 40 across (right) against the computed table, "
                        "nu = 0.25; logarithmic beyond 1 %")],
        cost=[Cost(f"half-space, {len(found)} ellipses of three load points", seconds)],
        tests=["unit.KalkerCoefficients.AreThoseOfTheSeriesBetweenTheEntriesOfTheTable",
               "unit.KalkerCoefficients.AreTheClosedFormsOfACircleWithoutPoissonsEffect",
               "unit.KalkerCoefficients.ArePrintedWithinTheirDigitsWhereThePatchIsNearlyRound",
               "unit.KalkerCoefficients.MeetTheAsymptotes"],
        after="C33 of a long patch is small: as large as the lateral force of spin at a distance of 0.04 to 0.2 b. "
              "Behind the leading edge the difference errs over two or three elements, which puts that force some 0.02 "
              "elements too far ahead. C33 is within 2 % on elements along rolling of at most b/8, that is 16 a/b of them; "
              "on coarser ones its error falls with their square, and the error bar of the moment covers it. "
              "The asymptotes of slender patches are consistent with the table: of short ones all four, with a remainder of "
              "some g^2 ln(16/g), g = a/b; of long ones C11 and C22 to (1.614/L)^2, L = ln(16 a^2/b^2), C23 to 1e-4. C33 of "
              "long patches is (pi/4) [1 - nu (L - 4)/((1 - nu) L - 2 + 4 nu)]^2, which the series follows to 1e-3 at b/a = "
              "0.01 and 1e-4 at 0.001; the form without the square and with L - 2, used before, has an error of 19 % at 0.02 and "
              "nu = 0.25. Finer elements bring the half-space closer: C11 of the circle at nu = 0.25 is 0.67, 0.20, 0.32 and "
              "0.14 % low at 20, 40, 80 and 160 across, within its bar.")
