# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws what rollfem has written, for reports and for `rollfem.read`, which users call. Without the compiled module:

    from rollfem_figures import read_result
    result = read_result("results/thesis_a")
    point = result.model("halfspace").nearest(longitudinal_creepage=0.002)
    point.fields["traction_x"]          # numpy array [ny, nx], MPa, on the wheel

`python3 -m rollfem_figures DIR` draws DIR/figures/*.svg and writes DIR/report.html. `read_stress(DIR)` reads a folder of
`rollfem stress`. Needs numpy and h5py.
"""
from .reader import ResultError, StressModel, StressResult, StressSet, read_result, read_stress
from .results import Model, Point, Result

__all__ = ["Model", "Point", "Result", "ResultError", "StressModel", "StressResult", "StressSet", "read_result",
           "read_stress"]
