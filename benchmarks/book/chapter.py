# SPDX-License-Identifier: LGPL-2.1-or-later
"""The content of a chapter: rows of numbers with their references, figures, cost, tests."""
import math
from dataclasses import dataclass, field


@dataclass
class Row:
    """One number with its reference.

    `allowed`: tolerance of |difference| as a fraction of `of`, which is the reference itself unless that is small or
    zero; `of_words` then names it ("mu F_z"). None if the book shows a difference without judging it, as for a value
    read from a diagram.
    """

    quantity: str
    unit: str
    reference: float
    reached: float
    allowed: float = None
    of: float = None
    of_words: str = ""
    by: str = ""  # origin of the number: model, grid

    def __post_init__(self):
        # JSON does not accept numpy's numbers.
        self.reference, self.reached = float(self.reference), float(self.reached)

    @property
    def difference(self):
        """(reached - reference) as a fraction of `of`."""
        scale = self.reference if self.of is None else self.of
        return (self.reached - self.reference) / abs(scale)

    @property
    def holds(self):
        """False also for NaN."""
        if self.allowed is None:
            return True
        return bool(math.isfinite(self.difference) and abs(self.difference) <= self.allowed)


def closest(rows):
    """Of rows that say the same of different places, the one closest to its tolerance or farthest beyond."""
    return max(rows, key=lambda row: abs(row.difference) / row.allowed if math.isfinite(row.difference) else math.inf)


def printed(quantity, unit, reference, reached, digits=4, by="CONTACT"):
    """A row of a number that is printed to so many digits, which hold to half a unit of the last."""
    last = 10.0 ** (math.floor(math.log10(abs(reference))) - digits + 1)
    return Row(quantity, unit, reference, reached, 0.501 * last / abs(reference), by=by)


def at_most(quantity, unit, reached, limit, by=""):
    """A row of a number that has to stay below a limit, in parts of it."""
    return Row(quantity, unit, 0.0, reached, 1.0, of=limit, of_words=f"{limit:.3g}", by=by)


@dataclass
class Cost:
    """Cost of one computation: wall time of the model in `seconds`, number of `unknowns`."""

    what: str
    seconds: float
    unknowns: int = None


@dataclass
class Table:
    """Numbers shown without being judged, e.g. models side by side. `rows` are lists of text."""

    caption: str
    head: list
    rows: list


@dataclass
class Chapter:
    """One benchmark. `setup`, `source` and `after` are Markdown; `figures` are (file, caption)."""

    name: str
    title: str
    setup: str
    source: str
    rows: list = field(default_factory=list)
    tables: list = field(default_factory=list)
    figures: list = field(default_factory=list)
    cost: list = field(default_factory=list)
    tests: list = field(default_factory=list)  # names as printed by CTest, without parameters
    after: str = ""

    @property
    def holds(self):
        return all(row.holds for row in self.rows)
