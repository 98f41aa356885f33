# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cases: the contents of a case file as values in Python."""
import copy
import json
import math
import numbers
import os
import re
import tomllib

import numpy as np

from . import _core
from ._core import InputError

BARE_KEY = re.compile(r"[A-Za-z0-9_-]+")


def _key(name):
    return name if BARE_KEY.fullmatch(name) else json.dumps(name, ensure_ascii=False)


def _value(value, where):
    """A value as TOML."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, numbers.Integral):
        return str(int(value))
    if isinstance(value, numbers.Real):
        value = float(value)
        return repr(value) if math.isfinite(value) else "nan" if math.isnan(value) else "inf" if value > 0 else "-inf"
    if isinstance(value, (str, os.PathLike)):
        return json.dumps(os.fspath(value), ensure_ascii=False).replace("\x7f", "\\u007F")
    if isinstance(value, (list, tuple, range)):
        return "[" + ", ".join(_value(each, where) for each in value) + "]"
    raise InputError(f"{where}: {value!r} is not a value of a case; allowed: numbers, strings, true or false, and lists "
                     "of these; do: leave the key out where its default is meant")


def _tables(table, path):
    """Lines of a table: its own values first, then the tables in it."""
    later = []
    for name, value in table.items():
        if not isinstance(name, str):
            raise InputError(f"{'.'.join(path)}: {name!r} is not a key; allowed: strings")
        here = [*path, name]
        if isinstance(value, dict):
            later += ["", f"[{'.'.join(map(_key, here))}]", *_tables(value, here)]
        elif isinstance(value, (list, tuple)) and value and all(isinstance(each, dict) for each in value):
            for each in value:
                later += ["", f"[[{'.'.join(map(_key, here))}]]", *_tables(each, here)]
        else:
            yield f"{_key(name)} = {_value(value, '.'.join(here))}"
    yield from later


def _plain(value):
    """A copy with plain Python values instead of numpy's, whose arrays cannot be compared as a whole."""
    if isinstance(value, (np.ndarray, np.generic)):
        return value.tolist()
    if isinstance(value, (list, tuple, range)):
        return [_plain(each) for each in value]
    if isinstance(value, dict):
        return {name: _plain(each) for name, each in value.items()}
    return copy.deepcopy(value)


def _merge(into, other):
    """Merges `other` into a dict of sections: sections key by key; other values replace existing ones."""
    for name, value in other.items():
        if isinstance(value, dict):
            kept = into.setdefault(name, {})
            if not isinstance(kept, dict):
                raise InputError(f"{name} is not a section")
            _merge(kept, value)
        else:
            into[name] = _plain(value)


def nested(changes):
    """{"friction.coefficient": 0.3} and {"friction__coefficient": 0.3} as sections; a name without a section is looked
    up in all sections."""
    found = {}
    for name, value in changes.items():
        if not isinstance(name, str):
            raise InputError(f"{name!r} is not a key; allowed: strings")
        parts = name.replace("__", ".").split(".")
        if len(parts) == 1 and not isinstance(value, dict):
            parts = path_of(name)
        for part in reversed(parts):
            value = {part: value}
        _merge(found, value)
    return found


def path_of(name):
    """Section and name of a key given only by its name: "spin" is ["rolling", "spin"]. An unknown name is returned
    unchanged for the reader to reject. Raises InputError if several sections have the key."""
    sections = [section for section, key in _core.keys() if key == name]
    if "" in sections or not sections:
        return [name]
    if len(sections) > 1 and "history" in sections:
        sections.remove("history")  # its keys of the same name are for single steps
    if len(sections) > 1:
        raise InputError(f"{name}: several sections have this key; allowed: "
                         + ", ".join(f"{section}.{name}" for section in sections)
                         + f"; do: write {sections[0]}={{'{name}': ...}} or **{{'{sections[0]}.{name}': ...}}")
    return [sections[0], name]


class Case:
    """A problem to solve: the sections and keys of a case file (docs/case-file.md), with the same checks.

    rollfem.Case("case.toml"), rollfem.Case({"load": {"normal_force": 50e3}, ...}), rollfem.Case(load={...}, ...), or a
    file or dict with keywords, which then replace single keys. A case is immutable; `with_` returns a changed copy.
    Raises rollfem.InputError.
    """

    def __init__(self, source=None, /, **sections):
        self._file, data, core = "", {}, None
        if isinstance(source, Case):
            self._file, data = source._file, source.data
        elif isinstance(source, (str, os.PathLike)):
            self._file = os.fspath(source)
            core = _core.read_case(self._file)
            data = tomllib.loads(core.text)
        elif source is not None and not isinstance(source, dict):
            raise InputError(f"{source!r} is not a case; allowed: a case file, a dict of sections, a rollfem.Case")
        try:
            if isinstance(source, dict):
                data = _plain(source)
            _merge(data, nested(sections))
            self._data = data
            self.core = core if core is not None and not sections else self._parsed()
        except RecursionError:
            raise InputError("the case contains itself, or its sections nest too deeply") from None

    @classmethod
    def of(cls, file, data):
        """A case from the contents of a case file, whose name is "" if there is none."""
        case = cls.__new__(cls)
        case._file, case._data = file, data
        case.core = case._parsed()
        return case

    def _parsed(self):
        name = self._file or "case"
        text = "\n".join(_tables(self._data, [])).lstrip("\n") + "\n"
        try:
            return _core.parse_case(text, name)
        except InputError as error:
            # Lines and columns would refer to generated text.
            raise InputError(re.sub(rf"^{re.escape(name)}:\d+:\d+:", f"{name}:", str(error))) from None

    def with_(self, changes=None, /, **keys):
        """A copy with changed keys: with_(friction__coefficient=0.3), with_(spin=1e-4), with_({"load.normal_force":
        60e3}), with_(rolling={"spin": 0.0}). A key set to None is removed."""
        if changes is not None and not isinstance(changes, dict):
            raise InputError(f"with_({changes!r}): allowed: a dict of keys, or keywords")
        asked = nested({**(changes or {}), **keys})
        data = self.data
        _drop(data, asked)
        _merge(data, asked)
        return Case.of(self._file, data)

    def __getitem__(self, name):
        """case["friction.coefficient"], or a section as a dict. KeyError for keys the case does not set."""
        found = self._data
        for part in name.split("."):
            found = found[part]
        return copy.deepcopy(found)

    @property
    def data(self):
        """All keys as a dict of sections; a copy."""
        return copy.deepcopy(self._data)

    @property
    def file(self):
        """The case file, or "" for a case made in Python."""
        return self._file

    @property
    def title(self):
        """The title in the case."""
        return self.core.title

    @property
    def text(self):
        """The case as TOML."""
        return self.core.text

    @property
    def models(self):
        """Names of the models that the case requests."""
        return list(self.core.models)

    @property
    def load_points(self):
        """Number of load points of every scene."""
        return self.core.load_points

    def describe(self):
        """Every key with its value, unit and whether it is the default, as `rollfem check` prints it."""
        return self.core.describe()

    def write(self, file):
        """Writes the case file and returns its name."""
        with open(file, "w", encoding="utf-8") as out:
            out.write(self.text)
        return file

    def __eq__(self, other):
        return isinstance(other, Case) and (self._data, self._file) == (other._data, other._file)

    def __hash__(self):
        return hash(self.text)

    def __reduce__(self):
        return Case.of, (self._file, self.data)

    def __repr__(self):
        count = self.load_points
        return f"<rollfem.Case {self.title or self._file or 'without a title'!r}: {count} load point{'s' * (count > 1)}>"


def _drop(data, asked):
    """Removes keys that are None from both."""
    for name in list(asked):
        if asked[name] is None:
            del asked[name]
            data.pop(name, None)
        elif isinstance(asked[name], dict) and isinstance(data.get(name, {}), dict):
            _drop(data.get(name, {}), asked[name])
