# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a chapter of the book holds: rows of numbers beside their reference, figures, cost, tests."""
import math
from dataclasses import dataclass, field


@dataclass
class Row:
    """One number beside its reference.

    `allowed`: largest |difference| that is held, a fraction of `of`, which is the reference itself
    unless it is small or zero; `of_words` says what it is then ("mu F_z"). None where the book shows
    a difference and holds none, as of a figure that others have read from a diagram.
    """

    quantity: str
    unit: str
    reference: float
    reached: float
    allowed: float = None
    of: float = None
    of_words: str = ""
    by: str = ""  # whose number: model, grid

    def __post_init__(self):
        # Numpy's numbers are no JSON.
        self.reference, self.reached = float(self.reference), float(self.reached)

    @property
    def difference(self):
        """(reached - reference) as a fraction of `of`."""
        scale = self.reference if self.of is None else self.of
        return (self.reached - self.reference) / abs(scale)

    @property
    def holds(self):
        """False also for a number that is none."""
        if self.allowed is None:
            return True
        return bool(math.isfinite(self.difference) and abs(self.difference) <= self.allowed)


@dataclass
class Cost:
    """What one computation took: wall-clock `seconds` of the model, number of `unknowns`."""

    what: str
    seconds: float
    unknowns: int = None


@dataclass
class Table:
    """Numbers that are shown and not held, e.g. models side by side. `rows` are lists of text."""

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
    tests: list = field(default_factory=list)  # as CTest prints them, without parameters
    after: str = ""

    @property
    def holds(self):
        return all(row.holds for row in self.rows)
