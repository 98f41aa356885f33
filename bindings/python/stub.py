# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes the types of the compiled module for mypy and editors, as the signatures of its functions state them.
Call, with rollfem on PYTHONPATH: stub.py _core.pyi"""
import inspect
import re
import sys

HEAD = '''# SPDX-License-Identifier: LGPL-2.1-or-later
"""Types of the compiled module."""
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Optional, overload

import numpy as np
'''
WORDS = {"Tuple": "tuple", "object": "Any", "tuple": "tuple[Any, ...]", "dict": "dict[str, Any]", "list": "list[Any]",
         "Callable": "Callable[..., object]", "function": "Callable[..., object]"}


def typed(text, **lists):
    """A signature of pybind11 in Python's types; `lists`: of List and Dict."""
    text = re.sub(r"numpy\.ndarray\[[^\]]*\]", "np.ndarray", text).replace("rollfem._core.", "")
    return re.sub(r"\b\w+\b", lambda word: {**WORDS, **lists}.get(word[0], word[0]), re.sub(r"\[\d+\]", "", text))


def functions(name, item):
    """The lines of a function, which may be overloaded."""
    found = re.findall(rf"^(?:\d+\. )?{name}\((.*)\) -> (.*)$", item.__doc__ or "", re.MULTILINE)
    for taken, given in found:
        if len(found) > 1:
            yield "@overload"
        yield f"def {name}({typed(taken, List='Sequence', Dict='Mapping')}) -> {typed(given, List='list', Dict='dict')}: ..."


def members(kind):
    """The lines of a class."""
    for name, item in vars(kind).items():
        if isinstance(item, property):
            yield f"{name}: {typed((item.fget.__doc__ or '-> object').rpartition('-> ')[2].strip(), List='list', Dict='dict')}"
        elif name == "__init__" or not name.startswith("_"):
            yield from functions(name, item)


def main():
    from rollfem import _core
    lines = [HEAD]
    for name, item in vars(_core).items():
        if inspect.isclass(item):
            lines += [f"class {name}:", *(f"    {line}" for line in [*members(item)] or ["..."]), ""]
        elif not name.startswith("_"):
            lines += [f"{name}: int"] if isinstance(item, int) else functions(name, item)
    with open(sys.argv[1], "w", encoding="utf-8") as file:
        file.write("\n".join([*lines, ""]))


if __name__ == "__main__":
    main()
