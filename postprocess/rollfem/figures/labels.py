# SPDX-License-Identifier: LGPL-2.1-or-later
"""Labels of figures: plain text with symbols between dollars, as $p_n$ or $\\xi$, for SVG, HTML and screen readers."""
import re
from html import escape

GREEK = {"xi": "ξ", "eta": "η", "varphi": "φ", "mu": "μ", "int": "∫", "rightarrow": "→"}


def math(symbol):
    """Converts a symbol of the files ("F_x", "xi") to one of a label."""
    return "$" + re.sub(r"\b(xi|eta|phi|mu)\b", lambda found: "\\" + found[1].replace("phi", "varphi"), symbol) + "$"


def _parts(text):
    """(whether symbols, text) for the pieces of a label outside and within dollars."""
    for number, part in enumerate(text.split("$")):
        if part:
            yield number % 2 == 1, part if number % 2 else re.sub(r"(?<![\w.])-(?=\d)", "−", part)


def _pieces(symbols):
    """(kind, text) of symbols: it (a letter), sub (an index) or empty."""
    for word, index, other in re.findall(r"(\\[a-z]+|[A-Za-z])|_\{?([A-Za-z0-9]+)\}?|([^A-Za-z_\\{}])", symbols):
        if word.startswith("\\") and word[1:] not in GREEK:
            yield "", " "  # \, and similar
        elif word:
            yield ("" if word in ("\\int", "\\rightarrow") else "it"), GREEK.get(word[1:], word)
        elif index:
            yield "sub", index
        else:
            yield "", other.replace("-", "−")


def _written(text, plain, forms):
    """The label with its pieces converted by these functions."""
    return "".join("".join(forms.get(kind, plain)(piece) for kind, piece in _pieces(part)) if symbols else plain(part)
                   for symbols, part in _parts(text.replace("\\,", " ")))


def svg(text):
    """The label as content of <text>."""
    return _written(text, escape, {
        "it": lambda piece: f'<tspan class="it">{escape(piece)}</tspan>',
        "sub": lambda piece: f'<tspan class="sub" dy="3">{escape(piece)}</tspan><tspan dy="-3">&#8203;</tspan>'})


def html(text):
    return _written(text, escape, {"it": lambda piece: f"<i>{escape(piece)}</i>",
                                   "sub": lambda piece: f"<sub>{escape(piece)}</sub>"})


def symbol(text):
    """A symbol of the files ("F_x", "xi", "-F_x/F_z", "mu p_0") as upright HTML for tables."""
    return _written(math(text), escape, {"sub": lambda piece: f"<sub>{escape(piece)}</sub>"})


def plain(text):
    """The label as read aloud."""
    return _written(text, str, {})


def width(text):
    """Approximate width of the label in letters of 12 px, px."""
    return sum(0.3 if c in " .,:;|il'()[]" else 0.66 if c.isupper() or c in "−+=%→mw" else 0.57
               for c in plain(text)) * 12.0
