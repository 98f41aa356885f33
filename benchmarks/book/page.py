# SPDX-License-Identifier: LGPL-2.1-or-later
"""The book as Markdown, one page per chapter, with every number also in book.json."""
import json
import math
import os

from rollfem.files import write_whole

from .tolerances import BASIS, spent_on

INTRO = """# Verification book

How accurate rollfem is: every benchmark is recomputed and compared with a closed form, a published value or an
independent method. References are computed by the book's own formulas (`benchmarks/book/closed_forms.py`) or quoted
with their source (`benchmarks/book/published.py`); the values reached come from the runs and tests named. *Difference*
is (reached − reference) in percent of the reference, or of the quantity stated. *Allowed* is the book's tolerance,
taken from the named test if it checks this number; if empty, the difference is only shown for information.
`./rollfem book` regenerates this page and fails when a number exceeds its tolerance. Requirements and the tests that
check them: [verification](../verification.md).
"""


def number(value, digits=6):
    """A number in reader's form: 6 digits, no exponent between 1e-4 and 1e7."""
    if value is None:
        return ""
    if not math.isfinite(value):
        return str(value)
    if value == 0:
        return "0"
    if 1e-4 <= abs(value) < 1e7:
        text = f"{value:.{max(0, digits - 1 - math.floor(math.log10(abs(value))))}f}"
        return (text.rstrip("0").rstrip(".") if "." in text else text).replace("-", "−")
    return f"{value:.{digits - 1}e}".replace("-", "−")


def percent(fraction, digits=2):
    """Signed, with `digits` significant digits."""
    value = 100 * fraction
    if not math.isfinite(value):
        return "none"
    if abs(value) < 5e-7:
        return "0 %"
    places = max(0, digits - 1 - math.floor(math.log10(abs(value))))
    return f"{value:+.{min(places, 6)}f} %".replace("-", "−")


def _allowed(row):
    if row.allowed is None:
        return ""
    words = f" of {row.of_words}" if row.of_words else ""
    return f"{100 * row.allowed:.2g} %{words}" + ("" if row.holds else " **beyond**")


def _table(head, rows):
    def line(cells):
        return "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |"
    return "\n".join([line(head), "|" + "---|" * len(head)] + [line(row) for row in rows])


def _rows(chapter):
    named = any(row.by for row in chapter.rows)
    judged = any(row.allowed is not None for row in chapter.rows)
    head = ["quantity"] + (["by"] if named else []) + ["reference", "reached", "difference"]
    head += ["allowed"] if judged else []
    rows = []
    for row in chapter.rows:
        unit = f", {row.unit}" if row.unit else ""
        rows.append([row.quantity + unit] + ([row.by] if named else [])
                    + [number(row.reference), number(row.reached), percent(row.difference)]
                    + ([_allowed(row)] if judged else []))
    return _table(head, rows)


def _cost(chapter):
    parts = []
    for cost in chapter.cost:
        size = f" ({cost.unknowns:,} unknowns)".replace(",", " ") if cost.unknowns else ""
        parts.append(f"{cost.what} {number(cost.seconds, 2)} s{size}")
    return "Cost: " + "; ".join(parts) + "." if parts else ""


def chapter_text(chapter, place):
    """The page of one chapter; `place` is its number in the book."""
    parts = [f"# {place}. {chapter.title}", chapter.setup.strip(), f"**Against** {chapter.source.strip()}"]
    if chapter.rows:
        parts.append(_rows(chapter))
    if chapter.name in BASIS:
        parts.append(f"*Tolerances:* {BASIS[chapter.name]}")
    for file, caption in chapter.figures:
        parts.append(f"![{caption}]({file})\n\n*{caption}*")
    for table in chapter.tables:
        parts.append(f"{table.caption}\n\n" + _table(table.head, table.rows))
    if chapter.after:
        parts.append(chapter.after.strip())
    held = ", ".join(f"`{name}`" for name in chapter.tests)
    parts.append(" ".join(p for p in [f"Held by {held}." if held else "", _cost(chapter)] if p))
    parts.append(f"[All chapters](README.md); alone: `./rollfem book --only {chapter.name}`")
    return "\n\n".join(parts) + "\n"


def _file(chapter):
    return f"{chapter.name}.md"


def worst(chapter):
    """The row nearest to, or farthest beyond, its tolerance; None if none is judged."""
    judged = [row for row in chapter.rows if row.allowed]
    return max(judged, key=lambda r: abs(r.difference) / r.allowed if math.isfinite(r.difference)
               else math.inf, default=None)


CLOSE = 0.8


def _close(chapters):
    """Rows that use most of their tolerance, with reasons."""
    rows = []
    for place, chapter in enumerate(chapters, 1):
        for row in chapter.rows:
            if row.allowed and CLOSE < abs(row.difference) / row.allowed:
                rows.append((abs(row.difference) / row.allowed,
                             [str(place), f"{row.quantity}{f' ({row.by})' if row.by else ''}", percent(row.difference),
                              _allowed(row), spent_on(chapter.name, row)]))
    rows.sort(key=lambda entry: -entry[0])
    return _table(["chapter", "quantity", "difference", "allowed", "spent on"], [cells for _, cells in rows])


def _contents(chapters, left_out):
    rows = []
    for place, chapter in enumerate(chapters, 1):
        row = worst(chapter)
        judged = [r for r in chapter.rows if r.allowed is not None]
        rows.append([f"[{place}. {chapter.title}]({_file(chapter)})",
                     f"{sum(r.holds for r in judged)} of {len(judged)}" if judged else "shown",
                     f"{row.quantity}{f' ({row.by})' if row.by else ''}: {percent(row.difference)}, "
                     f"allowed {_allowed(row)}" if row else "",
                     number(sum(c.seconds for c in chapter.cost), 2)])
    text = _table(["chapter", "numbers held", "nearest to its limit", "seconds"], rows)
    if left_out:
        text += "\n\nLeft out: " + "; ".join(f"{name} ({reason})" for name, reason in left_out) + "."
    return text


def book_text(chapters, left_out, made):
    """The first page; `made`: command, version, machine and date."""
    judged = [row for chapter in chapters for row in chapter.rows if row.allowed is not None]
    beyond = sum(not row.holds for row in judged)
    close = sum(row.holds and row.allowed > 0 and abs(row.difference) > CLOSE * row.allowed for row in judged)
    summary = (f"{len(judged)} numbers are judged; {beyond or 'none'} of them {'is' if beyond < 2 else 'are'} beyond its "
               f"tolerance and {close} use more than {100 * CLOSE:.0f} % of it ([below](#close-to-their-tolerance)). "
               f"Each chapter states the expected errors of both sides, from which its tolerances follow. Made by "
               f"`{made['command']}` with {made['version']} on {made['host']}, {made['date']}; the computations took "
               f"{number(made['seconds'], 3)} s.")
    return "\n\n".join([INTRO.strip(), summary, _contents(chapters, left_out),
                        "## Close to their tolerance\n\nThe rows of this run of `./rollfem book` that use more than "
                        f"{100 * CLOSE:.0f} % of theirs, and the reasons.\n\n{_close(chapters)}"]) + "\n"


def book_json(chapters, left_out, made):
    """The same as data: chapters with their rows, fractions not percent."""
    def row_of(row):
        return {"quantity": row.quantity, "by": row.by, "unit": row.unit, "reference": row.reference,
                "reached": row.reached, "difference": row.difference, "allowed": row.allowed,
                "of": row.of_words or "the reference", "holds": row.holds}
    return {"format": 1, "kind": "book", **made,
            "left_out": [{"chapter": name, "reason": reason} for name, reason in left_out],
            "chapters": [{"name": c.name, "title": c.title, "holds": c.holds, "tests": c.tests,
                          "rows": [row_of(r) for r in c.rows],
                          "cost": [{"what": k.what, "seconds": k.seconds, "unknowns": k.unknowns}
                                   for k in c.cost]} for c in chapters]}


def write_book(directory, chapters, left_out, made):
    """Writes README.md, which repository browsers show for a folder, the chapters and book.json."""
    for place, chapter in enumerate(chapters, 1):
        write_whole(os.path.join(directory, _file(chapter)), chapter_text(chapter, place))
    write_whole(os.path.join(directory, "README.md"), book_text(chapters, left_out, made))
    write_whole(os.path.join(directory, "book.json"),
                json.dumps(book_json(chapters, left_out, made), indent=1, ensure_ascii=False) + "\n")
