# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures: panels, which are axes and their content as SVG with classes for colours (styles.css), so that the surrounding page
decides on light or dark ground; side by side under one legend, as a file (SVG) and as part of a page, where the panels fill the
available width."""
import functools
import math
import re
from html import escape

import numpy as np

from ..files import write_whole
from . import labels, styles


MINUS = "−"


def widened(low, high, least=0.0, part=0.02):
    """Limits that do not magnify a constant: apart by at least `least` and by `part` of the larger one, so that
    rounding differences look like a straight line."""
    room = max(least, part * max(abs(low), abs(high))) or 1.0
    if high - low >= room:
        return low, high
    middle = 0.5 * (low + high)
    return middle - 0.5 * room, middle + 0.5 * room


def nice_step(span, most):
    """The smallest step of 1, 2 or 5 times a power of ten that divides a span into at most `most` parts."""
    power = 10.0 ** math.floor(math.log10(span / most))
    return next(s * power for s in (1, 2, 5, 10) if s * power * most >= 0.999999 * span)


def _raised(exponent):
    return "".join("⁰¹²³⁴⁵⁶⁷⁸⁹"[int(c)] if c.isdigit() else "⁻" for c in str(exponent))


def tick_text(value, step):
    """The text of a tick with the digits required by the step."""
    if abs(value) < 1e-6 * step:
        return "0"
    digits = max(0, -math.floor(math.log10(step) + 1e-9))
    if digits > 5 or abs(value) >= 1e6:
        mantissa, exponent = f"{value:.3e}".split("e")
        return f"{float(mantissa):g}·10{_raised(int(exponent))}".replace("-", MINUS)
    return f"{value:.{digits}f}".replace("-", MINUS)


def even_marks(low, high, step):
    """[(value, text)] of ticks at the multiples of a step."""
    return [(n * step, tick_text(n * step, step))
            for n in range(math.ceil(low / step - 1e-6), math.floor(high / step + 1e-6) + 1)]


def span_text(values):
    """"0 to 0.55", or the one value."""
    low, high = min(values), max(values)
    return " to ".join(dict.fromkeys("0" if abs(v) < 1e-9 * (high - low) else f"{v:.3g}" for v in (low, high)))


def broken(text, room):
    """The label in rows that fit into a width in px, broken at spaces outside symbols."""
    rows = []
    for given in text.split("\n"):
        rows.append("")
        for word in re.split(r" (?=[^$]*(?:\$[^$]*\$[^$]*)*$)", given):
            if rows[-1] and labels.width(f"{rows[-1]} {word}") > room:
                rows.append(word)
            else:
                rows[-1] += " " * bool(rows[-1]) + word
    return rows


class Axis:
    """`limits`: (low, high); None: from the content with a margin, at least `least` apart. `ticks`: [(value, text)]
    instead of even ones."""

    def __init__(self, label="", log=False, margin=0.05, least=0.0):
        self.label, self.log, self.margin, self.least = label, log, margin, least
        self.limits, self.ticks, self.flipped = (None, None), None, False
        self._low, self._high = math.inf, -math.inf

    def see(self, values):
        """Adds values that the limits must include."""
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
        given = self.limits
        span = (high if given[1] is None else given[1]) - (low if given[0] is None else given[0])
        room = self.margin * max(span, high - low)  # of the whole axis: markers at its ends are not cut
        low, high = (low - room if given[0] is None else given[0]), (high + room if given[1] is None else given[1])
        return (low, high) if high > low else (low, low + (abs(low) or 1.0))

    def words(self):
        """Its limits."""
        return span_text(self.range()) if self.ticks is None else " to ".join(
            text for _, text in self.marks(1, False)[::max(1, len(self.ticks) - 1)])

    def shares(self, values):
        """Relative position of values between the limits: 0 to 1."""
        low, high = self.range()
        values = np.asarray(values, dtype=float)
        if self.log:
            values, low, high = np.log10(np.maximum(values, 1e-300)), math.log10(low), math.log10(high)
        share = (values - low) / (high - low)
        return 1.0 - share if self.flipped else share

    def marks(self, pixels, across):
        """[(value, text)] of the ticks of an axis of a length in pixels; `across`: its labels stand side by side."""
        low, high = self.range()
        if self.ticks is not None:
            return [(value, text) for value, text in self.ticks if low <= value <= high]
        if self.log:
            first, last = round(math.log10(low)), round(math.log10(high))
            every = max(1, math.ceil((last - first) * (34 if across else 22) / pixels))
            plain = -3 <= first and last <= 4  # never both on one axis
            return [(10.0 ** e, f"{10.0 ** e:g}" if plain else "10" + _raised(e)) for e in range(first, last + 1, every)]
        step = nice_step(high - low, max(2, pixels / (20 if across else 30)))
        while True:
            found = even_marks(low, high, step)
            if len(found) < 2 or not across:
                return found
            least = max(max(labels.width(text) for _, text in found) + 7, pixels / 9)
            if least <= pixels * step / (high - low):
                return found
            step = nice_step(step * 1.01, 1)


_SCALE = 10  # content between the axes is in whole tenths of a pixel


def _number(value):
    return f"{value:.1f}".rstrip("0").rstrip(".") if value else "0"


def _moves(points, close):
    steps = np.diff(points, axis=0)
    steps = steps[steps.any(axis=1)]
    text = " ".join(map(str, steps.ravel().tolist())).replace(" -", "-") if len(steps) else "0 0"
    return f"M{points[0, 0]} {points[0, 1]}l{text}{'z' * close}"


def _spots(marker, r):
    """The corners of a marker of radius r about 0 and whether it is closed; for open markers pairs of ends."""
    k = 0.8 * r
    return {"o": None, "s": [(-k, -k), (k, -k), (k, k), (-k, k)], "D": [(0, -r), (r, 0), (0, r), (-r, 0)],
            "^": [(0, -r), (r, k), (-r, k)], "v": [(0, r), (r, -k), (-r, -k)],
            "<": [(-r, 0), (k, -r), (k, r)], ">": [(r, 0), (-k, -r), (-k, r)],
            "h": [(0, -r), (k, -r / 2), (k, r / 2), (0, r), (-k, r / 2), (-k, -r / 2)],
            "*": [(0, -r), (r / 3, -r / 3), (r, 0), (r / 3, r / 3), (0, r), (-r / 3, r / 3), (-r, 0),
                  (-r / 3, -r / 3)],
            "+": [(-r, 0), (r, 0), (0, 0), (0, -r), (0, r), (0, 0)],
            "x": [(-k, -k), (k, k), (0, 0), (-k, k), (k, -k), (0, 0)]}[marker]


def marker_path(marker, x, y, r):
    """Markers at (x, y), whole numbers, as the data of one path."""
    corners = _spots(marker, r)
    out = []
    for a, b in zip(x, y):
        if corners is None:
            out.append(f"M{a - r} {b}a{r} {r} 0 1 0 {2 * r} 0a{r} {r} 0 1 0-{2 * r} 0z")
        else:
            out.append(_moves(np.rint(np.array(corners) + (a, b)).astype(int), True))
    return "".join(out)


def strokes(colour, width, dash=(), fill=None, scale=1):
    """Attributes of a path; no stroke for colour None."""
    names = [f"s-{colour}"] if colour else []
    names.append(f"f-{fill}" if fill else "n")
    text = f'class="{" ".join(names)}"'
    if colour:
        text += f' stroke-width="{_number(width * scale)}"'
    if dash and colour:
        text += f' stroke-dasharray="{" ".join(_number(d * scale) for d in dash)}"'
    return text


def _path(look, data, opacity=1):
    shade = f' opacity="{opacity:g}"' if opacity != 1 else ""
    return f'<path {look}{shade} d="{data}"/>' if data else ""


def _later(order, text=False):
    """Adds a method's result to the panel. It is drawn when the limits of the axes are known, after content with a
    smaller `order`."""
    def wrap(draw):
        @functools.wraps(draw)
        def add(self, *arguments, order=order, **options):
            self._marks.append((order, len(self._marks), text, lambda: draw(self, *arguments, **options)))
        return add
    return wrap


class Panel:
    """`width`, `height` of the field between the axes, px. `equal`: equal scales on both axes, so that the height
    follows from the limits, which must be given. `bare`: no axes."""

    def __init__(self, width, height, title="", xlabel="", ylabel="", equal=False, bare=False):
        self.width, self.height, self.title = width, height, title
        self.x, self.y = Axis(xlabel, margin=0.03), Axis(ylabel)
        self.equal, self.bare, self.room_left, self.head = equal, bare, 54, 0  # head: least rows above the field
        self.entry = lambda *look: None  # entries of the figure's legend
        self._marks, self._curves = [], {}

    def _tenths(self, x, y):
        points = np.stack([self.x.shares(x) * self.width, (1.0 - self.y.shares(y)) * self.height], axis=-1)
        return np.rint(np.clip(points, -3000, 6000) * _SCALE).astype(int)

    def line(self, x, y, colour="ink", width=1.6, dash=(), marker=None, size=3.2, hollow=False, order=2,
             opacity=1, see=True, joined=True, name=""):
        """A curve with markers, interrupted at NaN; only markers unless `joined`. `hollow`: filled with the ground;
        "open": unfilled. `name`: legend entry; no entry without a name or without points."""
        x, y = np.asarray(x, dtype=float), np.asarray(y, dtype=float)
        if not len(x):
            return
        whole = np.isfinite(x) & np.isfinite(y)
        self.entry(name, colour, dash, width if joined else 0, marker, hollow)
        self._curves.setdefault(name, []).extend(y[np.isfinite(y)])
        if see:
            self.x.see(np.where(np.isfinite(y), x, np.nan)), self.y.see(y)
        known = np.flatnonzero(whole)
        runs = np.split(known, np.flatnonzero(np.diff(known) > 1) + 1) if joined else []
        self.paths([np.stack([x[run], y[run]], axis=1) for run in runs], colour, width, dash, opacity, order=order)
        if marker:
            fill = None if hollow == "open" or marker in "x+" else "ground" if hollow else colour
            self._markers(x[whole], y[whole], marker, size, strokes(colour, 1.2, (), fill, _SCALE), opacity, order=order)

    def spots(self, pairs, joined=False, **look):
        """A line through pairs of coordinates; only markers unless `joined`."""
        self.line(*(zip(*pairs) if pairs else ((), ())), joined=joined, **look)

    def bars(self, x, y, errors, colour):
        """Error bars with caps."""
        self.y.see(y - errors), self.y.see(y + errors)
        self._bars(x, y - errors, y + errors, colour)

    @_later(2)
    def _markers(self, x, y, marker, size, look, opacity):
        return _path(look, marker_path(marker, *self._tenths(x, y).T.tolist(), round(size * _SCALE)), opacity)

    @_later(2)
    def _bars(self, x, low, high, colour):
        data = "".join(f"M{a} {b}V{c}m-25 0h50M{a - 25} {b}h50" for (a, b), (_, c) in
                       zip(self._tenths(x, low).tolist(), self._tenths(x, high).tolist()) if b - c > 4)
        return _path(strokes(colour, 1, (), None, _SCALE), data)

    @_later(1)
    def area(self, rings, fill, opacity=1):
        """Areas within closed lines [n, 2]; a line inside another one makes a hole."""
        data = "".join(_moves(self._tenths(*ring.T), True) for ring in rings if len(ring) > 2)
        what = f'fill="{fill}"' if fill.startswith("#") else strokes(None, 1, (), fill)
        return _path(f'fill-rule="evenodd" {what}', data, opacity)

    @_later(2)
    def paths(self, lines, colour, width=1.2, dash=(), opacity=1):
        """Several lines [n, 2] of equal look, as one path."""
        data = "".join(_moves(self._tenths(*part.T), False) for part in lines if len(part) > 1)
        return _path(strokes(colour, width, dash, None, _SCALE), data, opacity)

    @_later(1)
    def level(self, value, colour="soft", dash=(1.5, 2.2), width=1.0, upright=False):
        """A line across the whole panel."""
        share = (self.x if upright else self.y).shares([value])[0]
        wide, high = self.width * _SCALE, self.height * _SCALE
        return _path(strokes(colour, width, dash, None, _SCALE),
                     f"M{share * wide:.0f} 0v{high:.0f}" if upright else f"M0 {(1 - share) * high:.0f}h{wide:.0f}")

    @_later(0)
    def band(self, low, high, fill="band"):
        """A shaded band between two values of y."""
        top, bottom = ((1 - s) * self.height * _SCALE for s in np.clip(self.y.shares([high, low]), 0, 1))
        wide = self.width * _SCALE
        return _path(f'class="f-{fill}"', f"M0 {top:.0f}h{wide:.0f}V{bottom:.0f}h-{wide:.0f}z")

    @_later(5, text=True)
    def text(self, x, y, text, anchor="start", colour="soft", shift=(0, 0), share=(False, False)):
        """A word at a place, moved by `shift` px to the right and down; `share`: x, y are fractions of the panel from
        the lower left corner."""
        across = x if share[0] else self.x.shares([x])[0]
        up = y if share[1] else self.y.shares([y])[0]
        return (f'<text x="{_number(across * self.width + shift[0])}" y="{_number((1 - up) * self.height + shift[1])}" '
                f'text-anchor="{anchor}" class="sm f-{colour}">{labels.svg(text)}</text>')

    def seen(self):
        """The content in words: ranges of the axes and of each named curve."""
        title, known = self.title.replace("\n", ", "), {name: values for name, values in self._curves.items() if values}
        up = span_text(sum(known.values(), [])) if known and self.y.ticks is None else self.y.words()
        named = ", ".join(f"{name} {span_text(values)}" for name, values in known.items() if name)
        return (f"{title}{': ' * bool(title)}{self.x.label} {self.x.words()}, {self.y.label} {up}"
                + (f" ({named})" if named else ""))

    def fit(self):
        """With equal axes, the height (or the width, if it was None) that follows from the limits."""
        if self.equal:
            (left, right), (low, high) = self.x.range(), self.y.range()
            self.height = self.width * (high - low) / (right - left)

    def _title(self):
        """The rows of the title."""
        return broken(self.title, max(self.width + 60, 120)) if self.title else []

    def _across(self):
        """The rows of the label of x."""
        return broken(self.x.label, self.width + 60) if self.x.label else []

    def _frame(self):
        """(grid and axes, words, width on the left) of the ticks."""
        across = self.x.marks(self.width, True)
        up = self.y.marks(self.height, False)
        grid, names = [], []
        for value, text in across:
            at = self.x.shares([value])[0] * self.width
            grid.append(f"M{_number(at)} 0V{_number(self.height)}")
            names.append(f'<text x="{_number(at)}" y="{_number(self.height + 15)}" text-anchor="middle">{text}</text>')
        for value, text in up:
            at = (1 - self.y.shares([value])[0]) * self.height
            grid.append(f"M0 {_number(at)}H{_number(self.width)}")
            names.append(f'<text x="-6" y="{_number(at + 4)}" text-anchor="end">{text}</text>')
        left = max([labels.width(text) for _, text in up] + [0]) + 9
        for number, row in enumerate(self._across()):
            names.append(f'<text x="{_number(self.width / 2)}" y="{_number(self.height + 32 + 14 * number)}" '
                         f'text-anchor="middle">{labels.svg(row)}</text>')
        rows = broken(self.y.label, self.height + 50) if self.y.label else []
        for number, row in enumerate(reversed(rows)):
            names.append(f'<text transform="translate({_number(-left - 7 - 14 * number)} '
                         f'{_number(self.height / 2)})rotate(-90)" text-anchor="middle">{labels.svg(row)}</text>')
        left += (5 + 14 * len(rows)) * bool(rows)
        axes = f'<path class="s-soft n" stroke-width=".8" d="M0 0V{_number(self.height)}H{_number(self.width)}"/>'
        return f'<path class="s-grid n" stroke-width=".8" d="{"".join(grid)}"/>', axes, "".join(names), left

    def svg(self):
        """(width, height, content) of the panel with its words."""
        self.fit()
        rows = self._title()
        top, bottom, left = 8 + 16 * max(len(rows), self.head), 4, 4
        grid = axes = names = ""
        if not self.bare:
            grid, axes, names, left = self._frame()
            left, bottom = max(left + 6, self.room_left), 26 + 14 * len(self._across()) if self.x.label else 22
        # Words wider than the field get room on both sides.
        beside = 0.5 * (max([1.15 * labels.width(row) for row in [*rows, *([] if self.bare else self._across())]], default=0) - self.width)
        ticks = [] if self.bare else self.x.marks(self.width, True)
        ends = [self.x.shares([value])[0] * self.width + 0.6 * labels.width(text) - self.width for value, text in ticks]
        left, right = max(left, beside + 4), max(12, beside + 4, *ends)
        marks = sorted(self._marks, key=lambda mark: mark[:2])
        inner = "".join(draw() for _, _, text, draw in marks if not text)
        texts = "".join(draw() for _, _, text, draw in marks if text)
        names += "".join(
            f'<text class="t" x="{_number(self.width / 2)}" y="{_number(-6 - 16 * (len(rows) - 1 - k))}" '
            f'text-anchor="middle">{labels.svg(row)}</text>' for k, row in enumerate(rows))
        field = (f'<svg width="{_number(self.width)}" height="{_number(self.height)}" overflow="hidden" '
                 f'viewBox="0 0 {_number(self.width * _SCALE)} {_number(self.height * _SCALE)}">{inner}</svg>')
        return (left + self.width + right, top + self.height + bottom,
                f'<g transform="translate({_number(left)} {_number(top)})">{grid}{field}{axes}'
                f'<g class="f-ink">{names}</g>{texts}</g>')


class Figure:
    """`columns`: panels per row of the file, and of the page too if `in_rows`."""

    def __init__(self, columns=3, heading="", in_rows=False):
        self.panels, self.columns, self.heading, self.in_rows = [], columns, heading, in_rows
        self.legend, self.said = [], ""

    def add(self, *arguments, **options):
        """Adds a panel (Panel), whose named curves have entries in the legend."""
        self.panels.append(Panel(*arguments, **options))
        self.panels[-1].entry = self.entry
        return self.panels[-1]

    def entry(self, text, colour=None, dash=(), width=1.6, marker=None, hollow=False, fill=None, opacity=1):
        """Adds an entry to the legend unless the name exists: a line of this look, an area, or text only."""
        if text and all((text, colour) != other[:2] for other in self.legend):
            self.legend.append((text, colour, dash, width, marker, hollow, fill, opacity))

    def model(self, model):
        """Adds the legend entry of a model."""
        self.entry(styles.label(model), *styles.of_model(model)[:2])

    def tell(self, what, said):
        """Sets the alternative text if it is not made from the panels: the content of the figure and remarks."""
        self.said = f"{what}{'; '.join(said)}."
        return self

    @property
    def seen(self):
        """The figure in words, for screen readers."""
        return labels.plain(self.said or "; ".join(panel.seen() for panel in self.panels) + ".")

    def charts(self, size, rows):
        """Adds a panel of that size for each row of title, label of x, of y, least span of y, and curves: x, y and look
        (Panel.line, and `bars`). Returns the panels."""
        for title, across, up, least, curves in rows:
            panel = self.add(*size, title, across, up)
            panel.y.least = least
            for x, y, look in curves:
                errors = np.asarray(look.get("bars", ()), dtype=float)
                panel.line(x, y, **{name: part for name, part in look.items() if name != "bars"})
                if errors.any():
                    panel.bars(np.asarray(x, dtype=float), np.asarray(y, dtype=float), errors, look["colour"])
        return self.panels[-len(rows):]

    def _key(self, entry):
        """The symbol of an entry, 26 by 12 px; empty for text only."""
        _, colour, dash, width, marker, hollow, fill, opacity = entry
        if fill:
            return f'<path class="f-{fill}" opacity="{opacity:g}" d="M3 1h20v10h-20z"/>'
        if not colour:
            return ""
        text = f'<path {strokes(colour, width, dash)} d="M1 6h24"/>' if width else ""
        if marker:
            filled = None if hollow == "open" or marker in "x+" else "ground" if hollow else colour
            text += f'<path {strokes(colour, 1.2, (), filled)} d="{marker_path(marker, [13], [6], 3)}"/>'
        return text

    def _align(self):
        """Fields of panels side by side begin at the same height."""
        for panel in self.panels:
            panel.head = max(len(each._title()) for each in self.panels)

    def html(self):
        """Legend and panels as part of a page."""
        self._align()
        items = []
        for entry in self.legend:
            key = self._key(entry)
            key = f'<svg class="plot" width="26" height="12" aria-hidden="true">{key}</svg>' if key else ""
            items.append(f"<li>{key}{labels.html(entry[0])}</li>")
        parts = [f'<ul class="legend">{"".join(items)}</ul>'] if items else []
        if self.heading:
            parts.insert(0, f'<p class="name">{labels.html(self.heading)}</p>')
        for number, panel in enumerate(self.panels):
            if self.in_rows and number and number % self.columns == 0:
                parts.append("<span class=row></span>")
            wide, high, content = panel.svg()
            parts.append(f'<svg class="plot" width="{wide:.0f}" height="{high:.0f}" '
                         f'viewBox="0 0 {wide:.0f} {high:.0f}" aria-hidden="true">{content}</svg>')
        seen = escape(self.seen, quote=True)
        return f'<div class="panels" role="img" aria-label="{seen}">{"".join(parts)}</div>'

    def _legend_rows(self, room):
        """The legend within a width in px: (height, content)."""
        x, y, out = 8.0, 16.0, []
        for entry in self.legend:
            key = self._key(entry)
            need = (32 if key else 0) + labels.width(entry[0]) + 20
            if x > 8 and x + need > room:
                x, y = 8.0, y + 19
            if key:
                out.append(f'<g transform="translate({x:.0f} {y - 10:.0f})">{key}</g>')
            out.append(f'<text class="f-ink" x="{x + (32 if key else 0):.0f}" y="{y:.0f}">'
                       f"{labels.svg(entry[0])}</text>")
            x += need
        return (y + 8 if self.legend else 0.0), "".join(out)

    def svg(self):
        """The whole figure as the text of a file."""
        self._align()
        drawn = [panel.svg() for panel in self.panels]
        rows = [drawn[k:k + self.columns] for k in range(0, len(drawn), self.columns)]
        widths = [max(row[k][0] for row in rows if k < len(row)) for k in range(len(rows[0]))] if rows else []
        wide = max(sum(widths), 240, labels.width(self.heading) + 24,
                   *((32 if self._key(entry) else 0) + labels.width(entry[0]) + 24 for entry in self.legend))
        top = 20 if self.heading else 0
        high, legend = self._legend_rows(wide)
        parts = [f'<g transform="translate(0 {top})">{legend}</g>']
        if self.heading:
            parts.append(f'<text class="f-ink t" x="8" y="16">{labels.svg(self.heading)}</text>')
        at = top + high
        for row in rows:
            x = 0.0
            for (_, _, content), width in zip(row, widths):
                parts.append(f'<g transform="translate({x:.0f} {at:.0f})">{content}</g>')
                x += width
            at += max(part[1] for part in row)
        return (f'<svg xmlns="http://www.w3.org/2000/svg" class="plot" width="{wide:.0f}" height="{at:.0f}" '
                f'viewBox="0 0 {wide:.0f} {at:.0f}" role="img"><title>{escape(self.seen)}</title>'
                f'<style>{styles.css()}</style><rect class="f-ground" width="100%" height="100%"/>'
                f'{"".join(parts)}</svg>\n')

    def _repr_svg_(self):
        """As notebooks show it."""
        return self.svg()

    def save(self, path):
        """Writes the file completely or not at all."""
        write_whole(path, self.svg())
