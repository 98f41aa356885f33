# SPDX-License-Identifier: LGPL-2.1-or-later
"""The searchable site of all pages with the C++, C and Python references: ./rollfem docs."""
import os
import pathlib
import re
import shutil
import subprocess
import sys

root = pathlib.Path(__file__).resolve().parents[2]
build = pathlib.Path(os.environ["ROLLFEM_BUILD"])

project = "rollfem"
author = "the authors of rollfem"
root_doc = "docs/site/index"
include_patterns = ["README.md", "CONTRIBUTING.md", "CHANGELOG.md", "docs/**", "examples/**"]
exclude_patterns = ["docs/site/doxygen*"]
extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon", "sphinx.ext.mathjax", "breathe"]
myst_enable_extensions = ["dollarmath"]
# Debian's copy, so that the site needs no network.
mathjax = pathlib.Path("/usr/share/javascript/mathjax")
mathjax_path = "mathjax/MathJax.js?config=TeX-AMS_CHTML"
myst_update_mathjax = False  # for MathJax 3
mathjax2_config = {"messageStyle": "none", "tex2jax": {"processClass": "math", "ignoreClass": ".*"}}
myst_heading_anchors = 4
html_theme = "alabaster"
html_theme_options = {"page_width": "72em", "sidebar_width": "16em", "description": "wheel-rail rolling contact"}
html_show_sourcelink = False
html_static_path = ["site.css"]
html_css_files = ["site.css"]
html_sidebars = {"**": ["about.html", "searchbox.html", "navigation.html"]}

# The module as built, without a trace of it in the sources.
sys.dont_write_bytecode = True
sys.path.insert(0, str(build / "python"))
autodoc_member_order = "bysource"
autodoc_typehints = "description"
autodoc_typehints_description_target = "documented_params"

breathe_projects = {"rollfem": str(build / "docs" / "doxygen" / "xml")}
breathe_default_project = "rollfem"
breathe_domain_by_extension = {"h": "c", "hpp": "cpp"}

headers = ["bindings/capi/rollfem/rollfem.h", "bindings/interface/rollfem/rollfem.hpp", "case/case.hpp",
           "result/result.hpp", "base/progress.hpp", "result/write/output.hpp"]
(build / "docs" / "doxygen").mkdir(parents=True, exist_ok=True)
subprocess.run(["doxygen", "-"], check=True, cwd=root, text=True, input=f"""
INPUT = {" ".join(headers)}
OUTPUT_DIRECTORY = {build / "docs" / "doxygen"}
GENERATE_XML = YES
GENERATE_HTML = NO
GENERATE_LATEX = NO
EXTRACT_ALL = YES
QUIET = YES
MACRO_EXPANSION = YES
# Comments of the C header are plain: those behind a member belong to it, others to what follows.
FILTER_PATTERNS = *.h="sed -e '/SPDX-License/d' -e 's|^\\( *\\)/\\*|\\1/**|' -e 's|\\([^ ] *\\)/\\* |\\1/**< |'"
""")


def as_written(app, what, name, thing, options, lines):
    """What a docstring sets in columns or indents, but for its sections and examples, stays as it stands."""
    paragraphs = "\n".join(lines).split("\n\n")
    lines.clear()
    for paragraph in paragraphs:
        rows = paragraph.split("\n")
        if re.fullmatch(r"\w+:", rows[0]):  # a section
            lines += [row.replace("|", "\\|") for row in rows] + [""]
        elif rows[0].startswith(">>> "):
            lines += rows + [""]
        elif any(row.startswith(" ") or "  " in row for row in rows):
            lines += ["::", "", *("    " + row for row in rows), ""]
        else:
            lines += [re.sub(r"([*|])", r"\\\1", row) for row in rows] + [""]


def add_mathjax(app, error):
    """The parts of MathJax that typeset the formulas."""
    for part in ("MathJax.js", "config/TeX-AMS_CHTML.js", "extensions", "jax/input/TeX", "jax/element", "jax/output/CommonHTML",
                 "fonts/HTML-CSS/TeX/woff"):
        target = pathlib.Path(app.outdir) / "_static/mathjax" / part
        target.parent.mkdir(parents=True, exist_ok=True)
        if (mathjax / part).is_dir():
            shutil.copytree(mathjax / part, target, dirs_exist_ok=True)
        elif (mathjax / part).exists():
            shutil.copy(mathjax / part, target)


def setup(app):
    app.connect("build-finished", add_mathjax)
    app.connect("autodoc-process-docstring", as_written, priority=100)  # before napoleon
