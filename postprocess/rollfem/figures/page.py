# SPDX-License-Identifier: LGPL-2.1-or-later
"""The frame of every report: one self-contained file for screens, phones, printers and screen readers,
on light and dark ground; and the drawing of its figures. What rollfem writes is drawn by a module each, of an object of the
package: `captioned` ((file name, caption, function that makes a Figure or returns None) of all figures) and `page`
(the arguments of write_page); a table NAME.csv by `of_table`."""
import importlib
import os
import re
from collections.abc import Sequence
from html import escape
from types import ModuleType
from typing import Any

from ..errors import FileError
from ..files import folder_of, read_rows, write_whole
from ..reader import stored
from . import styles


with open(os.path.join(os.path.dirname(__file__), "page.css"), encoding="utf-8") as _file:
    CSS = _file.read()


def made_by(program, run):
    """The program and the call behind the results, as HTML."""
    made = f"rollfem {program['version']} ({program['commit']}), {run['started']}, {run['host']}"
    if run["processes"] > 1:
        made += f", {run['processes']} processes"
    return f"{escape(made)}<br><code>{escape(run['command'])}</code>"


class Drawn:
    """The figures of a page with their captions, {file name: HTML}."""

    def __init__(self, figures):
        self.figures = figures

    def __call__(self, *starts):
        """The figures whose names begin with `prefix`, in their order."""
        return "".join(html for name, html in self.figures.items() if name.startswith(starts))

    def under(self, prefix):
        """The figures whose names begin with `prefix`, by the rest of their names."""
        return Drawn({name[len(prefix):]: html for name, html in self.figures.items() if name.startswith(prefix)})


# Modules and pages of kinds (reader.KINDS) that are not called as these.
MODULES, PAGES = {"result": "report", "stress": "stresses"}, {"result": "report"}
# (characteristic column of a table, module).
TABLES = (("part", "profiles"), ("conicity_wave", "positions"), ("curvature", "profiles"))
# Starting processes takes longer than drawing fewer figures.
LEAST_SPREAD = 24


def draw_all(captioned, directory):
    """Draws figures, an iterable of (file name, caption, function that makes a Figure or returns None), and writes
    their files to figures/, using all cores for many; returns the drawn ones (Drawn)."""
    captioned = list(captioned)
    folder = os.path.join(directory, "figures")
    os.makedirs(folder, exist_ok=True)

    def draw(number):
        name, caption, function = captioned[number]
        figure = function()
        if figure is None:
            return None
        figure.save(os.path.join(folder, name))
        return f"<figure>{figure.html()}<figcaption>{escape(caption)}</figcaption></figure>"

    workers = len(os.sched_getaffinity(0)) if len(captioned) >= LEAST_SPREAD else 1
    drawn = _spread(draw, len(captioned), workers) if workers > 1 else map(draw, range(len(captioned)))
    return Drawn({name: html for (name, *_), html in zip(captioned, drawn) if html})


_task = None  # shared with the drawing processes, which inherit it when forked


def _spread(task, count, workers):
    """Runs task(0), ..., task(count - 1) in forked processes; each takes the next number when free."""
    import multiprocessing  # pylint: disable=import-outside-toplevel; importing takes half the time of a report

    global _task
    _task = task
    with multiprocessing.get_context("fork").Pool(workers) as pool:
        return pool.map(_do_task, range(count), chunksize=4)


def _do_task(number):
    return _task(number)


def build(path: str, overlays: Sequence[str] = ()) -> None:
    """Draws what lies at a path: the figures and the page of a folder, or NAME.svg of a table NAME.csv. `overlays`: tables of
    measured creep curves, drawn over those of a result."""
    if not path.endswith(".csv"):
        thing = stored(path)
        if overlays and thing.kind != "result":
            raise FileError(f"{path}: measured curves are drawn over the result of rollfem run only")
        if overlays:
            thing.overlays = [_module("curves").read_overlay(overlay) for overlay in overlays]
        draw(thing, folder_of(path))
        return
    columns = next(iter(read_rows(path)[1]), ())
    if not (name := next((module for column, module in TABLES if column in columns), None)):
        raise FileError(f"{path}: no figure exists for this table; allowed: tables of rollfem profile and rollfem wheelset")
    _module(name).of_table(path).save(os.path.splitext(path)[0] + ".svg")


def draw(thing: Any, folder: str) -> Drawn:
    """Draws the figures and the page of an object of the package to a folder; returns the figures."""
    module = drawing(thing)
    drawn = draw_all(module.captioned(thing), folder)
    write_page(os.path.join(folder, f"{PAGES.get(thing.kind, thing.kind)}.html"), *module.page(thing, drawn))
    return drawn


def drawing(thing: Any) -> ModuleType:
    """The module that draws an object of the package, whose models it then calls by their labels."""
    styles.know(thing.labels)
    return _module(MODULES.get(thing.kind, thing.kind))


def _module(name):
    """Loads only the modules of the call, because the user waits for each of them."""
    return importlib.import_module(f".{name}", __package__)


def section(heading, *parts):
    """Parts under a second-level heading; empty if they are empty."""
    body = "".join(parts)
    return f"<h2>{heading}</h2>{body}" if body else ""


def case_file(name, text):
    """The case file, to be opened by the reader."""
    return f"<details><summary>case file {escape(name)}</summary><pre>{escape(text)}</pre></details>"


def folded(words, html):
    """Rows of numbers behind a line that opens them; empty if there are none."""
    return f"<details><summary>{words}</summary>{html}</details>" if html else ""


def hint(text):
    """A remark in small letters; empty if there is none."""
    return f"<p class=hint>{text}</p>" if text else ""


def under(html, note):
    """HTML with a note under it in small letters, as in the cells of tables."""
    return f"{html}<br><span class=d>{note}</span>"


def _slug(text, taken):
    """A unique id for a heading."""
    plain = re.sub(r"<[^>]*>|&[a-z]+;", "", text)
    slug = re.sub(r"[^a-z0-9]+", "-", plain.lower()).strip("-") or "part"
    name, number = slug, 1
    while name in taken:
        number += 1
        name = f"{slug}-{number}"
    taken.add(name)
    return name


def _contents(body):
    """The body with an id on every second-level heading, and a list of links to them."""
    taken = set(re.findall(r'\bid="?([^"\s>]+)', body))
    entries = []

    def name(found):
        given, text = found.groups()
        own = re.search(r'id="?([^"\s>]+)', given)
        slug = own[1] if own else _slug(text, taken)
        entries.append(f'<li><a href="#{slug}">{re.sub("<[^>]*>", "", text)}</a></li>')
        return f"<h2{given}>{text}</h2>" if own else f'<h2 id="{slug}"{given}>{text}</h2>'

    body = re.sub(r"<h2([^>]*)>(.*?)</h2>", name, body, flags=re.S)
    if len(entries) < 3:
        return body, ""
    return body, f'<nav aria-label="Contents"><ul>{"".join(entries)}</ul></nav>'


def write_page(path, title, made, parts, beside=""):
    """Writes a page completely or not at all: its heading, below it `made` (provenance), and the parts with a table of
    contents of their second-level headings; `beside`: other files in the folder, at the end. All texts are HTML."""
    body, contents = _contents("".join(parts))
    # Tables with many columns are printed in landscape format.
    sideways = "@page{size:A4 landscape}" if 'class="wide many"' in body else ""
    footer = f"<footer class=screen><p class=hint>{beside}</p></footer>" if beside else ""
    text = "".join([
        "<!DOCTYPE html><html lang=en><head><meta charset=utf-8>"
        '<meta name=viewport content="width=device-width,initial-scale=1">'
        '<meta name=color-scheme content="light dark">'
        f"<title>{re.sub('<[^>]*>', '', title)}</title><style>{CSS}{sideways}{styles.css()}</style></head>"
        f'<body{" class=toc" if contents else ""}><a class=skip href="#main">to the results</a>'
        f"<header><h1>{title}</h1><p class=meta>{made}</p></header>{contents}<main id=main>{body}</main>{footer}</body></html>\n"])
    write_whole(path, text)
