# SPDX-License-Identifier: LGPL-2.1-or-later
"""A wheelset in balance, by its conditions: rows for the chapter of the Manchester benchmark."""
import math
from collections import defaultdict

from .. import published
from ..chapter import Row, closest
from ..runs import RunFailed

LOAD, FRICTION, RADIUS = 60e3, 0.3, 460.0
_CASE = """[load]
vertical_force = {load}
[friction]
coefficient = {friction}
[wheel]
rolling_radius = 460.0
profile = "S1002"
{wheel}
[rail]
profile = "60E1"
{wheel}
[track]
inclination = "1:40"
[wheelset]
side = "{side}"
lateral_shift = {shift}
yaw = {yaw}
{wheelset}
[rolling]
{rolling}
[contact_grid]
elements_across = {across}
"""


def _solved(bench, name, shift, yaw, wheelset="", rolling="", side="both", across=40, load=LOAD, friction=FRICTION, wheel=""):
    """The models of all patches, the balance found by the program on few elements."""
    text = _CASE.format(load=load, friction=friction, wheel=wheel, side=side, shift=shift, yaw=yaw, wheelset=wheelset, rolling=rolling,
                        across=across)
    return bench.run_text(f"balance_{name}", text, ["halfspace"]).models


def _sums(models, of):
    """{wheel: sum over its patches}."""
    wheels = defaultdict(float)
    for model in models:
        wheels[model.place["wheel"]] += of(model, model.points[0])
    return wheels


def _vertical(words, models, load=LOAD):
    """Vertical force with friction on every wheel."""
    return closest([Row(f"balance, {words}: vertical force of the {wheel} wheel", "N", load, force, 1e-6)
                    for wheel, force in _sums(models, lambda _, point: point["vertical_force"]).items()])


def _torque(models):
    return _sums(models, lambda model, point: point["longitudinal_force"] * model.place["rolling_radius"])


def balance_rows(bench):
    """On the flange at 54 degrees, of free rolling by force and by torque, where an element comes into contact, and where friction lifts."""
    # At 8 mm the right wheel stands on its flange and slides: 27 % of its normal force more than the load.
    rows = [_vertical(f"{shift:g} mm", _solved(bench, f"{shift:g}", shift, 0.0024 * shift)) for shift in (3.0, 8.0)]
    scale = FRICTION * LOAD * RADIUS
    torque = _torque(_solved(bench, "torque", 3.0, 0.004, 'free_rolling = "torque"'))
    assert abs(torque["left"]) > 0.05 * scale  # the radii differ
    # Forces on 24 across, on which the rotation was found, are good to half a percent of mu F_z on each wheel.
    rows.append(Row("free rolling: torque of both wheels", "N mm", 0.0, sum(torque.values()), 1e-2, of=scale, of_words="mu F_z R"))
    forces, torques = [], []
    for shift, yaw in ((3.0, 0.004), (6.3, 0.0), (6.78, 0.0)):
        for across, rest, found in ((24, forces, lambda _, point: point["longitudinal_force"]), (40, torques, None)):
            models = _solved(bench, f"force_{shift:g}_{across}", shift, yaw, 'free_rolling = "force"', across=across)
            sums = _sums(models, found) if found else _torque(models)
            assert len(sums) == 2
            rest += [Row(f"free rolling, {shift:g} mm: {'force' if found else 'torque'} of the {wheel} wheel", "N" if found else "N mm", 0.0,
                         value, 1e-4 if found else 5e-3, of=scale / (RADIUS if found else 1.0), of_words="mu F_z" + (not found) * " R",
                         by=f"{across} across") for wheel, value in sums.items()]
    rows += [closest(forces), closest(torques)]
    for model in _solved(bench, "given", 2.0, 0.003, rolling="longitudinal_creepage = [0.001, 0.002]"):
        assert [point["longitudinal_creepage"] for point in model.points] == [0.001, 0.002]
        # Yaw turns the wheels against their way.
        rows.append(Row(f"yaw of 3 mrad: creepage across of the {model.place['wheel']} wheel", "", 0.003 / math.cos(model.place["contact_angle"]),
                        model.points[1]["lateral_creepage"], 2e-5, of=1.0, of_words="1"))
    # The elements in contact depend on the load carried by friction, and friction on the elements: here either leads to the other.
    rows.append(closest([_vertical(f"{shift:g} mm", _solved(bench, f"element_{-shift:g}", shift, 0.0, "roll = 0.0", side="left", load=80e3,
                                                            wheel=published.CONTACT_STEEL), 80e3) for shift in (-7.32, -7.321, -8.51)]))
    # A flange that slides down is carried upwards by friction; the other way round friction holds the wheel down.
    held, = _solved(bench, "held", 8.0, 0.02, side="right", friction=2.0)
    assert held.points[0]["normal_force"] < LOAD
    try:
        _solved(bench, "lifted", 8.0, -0.02, side="right", friction=2.0)
    except RunFailed as error:
        assert "Nadal" in str(error), error
        return rows
    raise AssertionError("a wheel that friction lifts is in balance")
