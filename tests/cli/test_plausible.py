# SPDX-License-Identifier: LGPL-2.1-or-later
"""Values in wrong units are doubted, each with the advice to give it in the right one; intended values are not."""

import math

import pytest
from program import SOURCE, package, says, toml

ROLLING = {"load.normal_force": 80e3, "friction.coefficient": 0.3, "wheel.rolling_radius": 460,
           "wheel.transverse_radius": math.inf, "rail.transverse_radius": 300, "rolling.longitudinal_creepage": 0.001}
PLACED = {"load.vertical_force": 80e3, "friction.coefficient": 0.3, "wheel.rolling_radius": 460, "wheel.profile": "S1002",
          "rail.profile": "60E1"}
LEANING = PLACED | {"track.inclination": "1:20"}


def soft(modulus):
    return ROLLING | {"wheel.young_modulus": modulus, "rail.young_modulus": modulus}


@pytest.mark.parametrize("keys, doubts", [
    (ROLLING | {"wheel.rolling_radius": 0.46, "load.normal_force": 1.0}, ["wheel.rolling_radius = 0.46 mm"]),
    (ROLLING | {"rail.transverse_radius": 0.3}, ["rail.transverse_radius = 0.3 mm"]),
    (ROLLING | {"load.normal_force": 80.0}, ["load.normal_force = 80 N: a wheel of 460 mm carries more than 1058 N"]),
    (ROLLING | {"rolling.longitudinal_creepage": [0.1, -0.6]}, ["rolling.longitudinal_creepage = -0.6"]),
    (ROLLING | {"rolling.spin": 1.0}, ["rolling.spin = 1 rad/mm"]),
    (ROLLING | {"friction.coefficient": 30.0}, ["friction.coefficient = 30: dry steel has"]),
    (soft(2.1e8), ["wheel.young_modulus", "rail.young_modulus"]),
    (soft(210.0), ["wheel.young_modulus = 210 MPa", "rail.young_modulus"]),
    (soft(2100.0), ["wheel.young_modulus = 2100 MPa", "rail.young_modulus"]),
    (LEANING | {"track.gauge": 1.435}, ["track.gauge = 1.435 mm"]),
    (LEANING | {"wheelset.flange_back_distance": 1.36}, ["wheelset.flange_back_distance = 1.36 mm"]),
    (PLACED | {"track.inclination": 0.4}, ["track.inclination = 0.4 rad"]),
    (ROLLING, []), (LEANING | {"track.gauge": 1000.0}, []), (PLACED | {"track.inclination": "none"}, []),
    (ROLLING | {"wheel.rolling_radius": 100.0, "rail.transverse_radius": 20.0, "load.normal_force": 60.0,
                "rolling.longitudinal_creepage": 0.3, "rolling.spin": 0.1}, []),  # a roller rig
    (soft(5.0) | {"wheel.rolling_radius": 250.0, "load.normal_force": 80.0, "rolling.longitudinal_creepage": 0.1}, [])])  # rubber
def test_wrong_units_are_doubted(keys, doubts):
    found = package()._core.parse_case(toml(keys), "slip.toml").doubts
    assert len(found) == len(doubts)
    for said, doubt in zip(found, doubts):
        says(said, "slip.toml: " + doubt, "do: give it ")
        if keys.get("wheel.young_modulus") in (210.0, 2100.0):
            says(said, "do: give it in MPa if this is in GPa")


@pytest.mark.parametrize("file", sorted((SOURCE / "cases").rglob("*.toml")), ids=lambda file: file.stem)
def test_cases_of_ours_are_not_doubted(file):
    assert package()._core.read_case(str(file), []).doubts == []
