"""Reads rollfem results and draws them.

    from rollfem_figures import read_result
    result = read_result("results/thesis_a")
    point = result.model("halfspace").nearest(longitudinal_creepage=0.002)
    point.fields["traction_x"]          # numpy array [ny, nx], MPa, on the wheel

`python3 -m rollfem_figures DIR` draws DIR/figures/*.svg and writes DIR/report.html.
Needs numpy and h5py to read, matplotlib to draw.
"""
from .reader import Model, Point, Result, ResultError, read_result

__all__ = ["Model", "Point", "Result", "ResultError", "read_result"]
