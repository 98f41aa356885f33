"""Figures in words: alternative texts for readers who hear the page."""
import numpy as np


def span(curve):
    """"-3.8 and 3.8 mm", where a curve (positions, values) begins and ends."""
    positions = [] if curve is None else curve[0][np.isfinite(curve[0])]
    if not len(positions):
        return "no place"
    return f"{positions[0]:.3g} and {positions[-1]:.3g} mm".replace("-", "−")


def patch_size(model, point):
    """"7.6 by 21.7 mm", the patch of a load point."""
    return f"{point['contact_length']:.3g} by {point['contact_width']:.3g} mm"


def adhering(point):
    """"sticks in 62 % of the patch"."""
    share = 100 * point["adhesion_area"] / point["contact_area"] if point["contact_area"] else 0.0
    return "slips everywhere" if share < 0.05 else f"sticks in {share:.0f} % of the patch"
