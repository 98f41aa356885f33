# SPDX-License-Identifier: LGPL-2.1-or-later
"""A figure: panels side by side under one legend, as a file (SVG) and as part of a page, where the panels fill the
available width."""
from html import escape

from ..files import write_whole
from . import labels, styles
from .panel import Panel, marker_path, strokes


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
        if text and all(text != other[0] for other in self.legend):
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
        (Panel.line). Returns the panels."""
        for title, across, up, least, curves in rows:
            panel = self.add(*size, title, across, up)
            panel.y.least = least
            for x, y, look in curves:
                panel.line(x, y, **look)
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
            filled = None if hollow == "open" or marker in "xP+" else "ground" if hollow else colour
            text += f'<path {strokes(colour, 1.2, (), filled)} d="{marker_path(marker, [13], [6], 3)}"/>'
        return text

    def html(self):
        """Legend and panels as part of a page."""
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
        drawn = [panel.svg() for panel in self.panels]
        rows = [drawn[k:k + self.columns] for k in range(0, len(drawn), self.columns)]
        widths = [max(row[k][0] for row in rows if k < len(row)) for k in range(len(rows[0]))] if rows else []
        wide = max(sum(widths), 240)
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
