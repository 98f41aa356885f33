"""One coordinate of a panel: its limits, its ticks, and where a value is."""
import math

import numpy as np

from .words import width

MINUS = "−"


def widened(low, high, least=0.0, part=0.02):
    """Limits that do not blow up a constant: at least `least` apart, and `part` of the larger of
    both, so that what differs by rounding is a straight line."""
    room = max(least, part * max(abs(low), abs(high))) or 1.0
    if high - low >= room:
        return low, high
    middle = 0.5 * (low + high)
    return middle - 0.5 * room, middle + 0.5 * room


def nice_step(span, most):
    """The smallest of 1, 2, 5 times a power of ten that divides a span into `most` parts at most."""
    power = 10.0 ** math.floor(math.log10(span / most))
    return next(s * power for s in (1, 2, 5, 10) if s * power * most >= 0.999999 * span)


def _raised(exponent):
    return "".join("⁰¹²³⁴⁵⁶⁷⁸⁹"[int(c)] if c.isdigit() else "⁻" for c in str(exponent))


def tick_text(value, step):
    """A tick with as many digits as the step needs."""
    if abs(value) < 1e-6 * step:
        return "0"
    digits = max(0, -math.floor(math.log10(step) + 1e-9))
    if digits > 5 or abs(value) >= 1e6:
        mantissa, exponent = f"{value:.3e}".split("e")
        return f"{float(mantissa):g}·10{_raised(int(exponent))}".replace("-", MINUS)
    return f"{value:.{digits}f}".replace("-", MINUS)


def decade_text(exponent):
    if -3 <= exponent <= 4:
        return f"{10.0 ** exponent:g}"
    return "10" + _raised(exponent)


class Axis:
    """`limits`: (low, high), either may be None: from what is drawn with a margin, never less than
    `least` apart. `ticks`: [(value, text)] instead of even ones."""

    def __init__(self, label="", log=False, margin=0.05, least=0.0):
        self.label, self.log, self.margin, self.least = label, log, margin, least
        self.limits, self.ticks, self.flipped = (None, None), None, False
        self._low, self._high = math.inf, -math.inf

    def see(self, values):
        """Values that the limits shall hold."""
        values = np.asarray(values, dtype=float)
        values = values[np.isfinite(values) & ((values > 0) | (not self.log))]
        if values.size:
            self._low, self._high = min(self._low, values.min()), max(self._high, values.max())

    def range(self):
        low, high = (self._low, self._high) if self._low <= self._high else (0.0, 1.0)
        if self.log:
            low, high = (low, high) if self._low <= self._high else (0.1, 1.0)
            return 10 ** math.floor(math.log10(low) + 1e-9), 10 ** max(
                math.ceil(math.log10(high) - 1e-9), math.floor(math.log10(low) + 1e-9) + 1)
        low, high = widened(low, high, self.least)
        room = self.margin * (high - low)
        low, high = low - room, high + room
        given = self.limits
        low, high = (low if given[0] is None else given[0]), (high if given[1] is None else given[1])
        return (low, high) if high > low else (low, low + (abs(low) or 1.0))

    def shares(self, values):
        """Where values are between the limits: 0 to 1."""
        low, high = self.range()
        values = np.asarray(values, dtype=float)
        if self.log:
            values, low, high = np.log10(np.maximum(values, 1e-300)), math.log10(low), math.log10(high)
        share = (values - low) / (high - low)
        return 1.0 - share if self.flipped else share

    def marks(self, pixels, across):
        """[(value, text)] of the ticks of an axis so many pixels long; `across`: its labels stand beside
        each other."""
        low, high = self.range()
        if self.ticks is not None:
            return [(value, text) for value, text in self.ticks if low <= value <= high]
        if self.log:
            first, last = round(math.log10(low)), round(math.log10(high))
            every = max(1, math.ceil((last - first) * (34 if across else 22) / pixels))
            return [(10.0 ** e, decade_text(e)) for e in range(first, last + 1, every)]
        step = nice_step(high - low, max(2, pixels / (20 if across else 30)))
        while True:
            numbers = range(math.ceil(low / step - 1e-6), math.floor(high / step + 1e-6) + 1)
            found = [(n * step, tick_text(n * step, step)) for n in numbers]
            if len(found) < 2 or not across:
                return found
            least = max(max(width(text) for _, text in found) + 7, pixels / 9)
            if least <= pixels * step / (high - low):
                return found
            step = nice_step(step * 1.01, 1)
