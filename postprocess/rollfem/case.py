# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cases: the contents of a case file as values in Python. Names that calls are given, keys of cases: a wrong one is never
taken in silence."""
import copy
import json
import math
import numbers
import os
import string
import tomllib
from collections.abc import Container, Iterator, Mapping, Sequence
from html import escape
from types import SimpleNamespace
from typing import Any

import numpy as np

from . import _core
from .errors import InputError
from .frames import InFile, forwarded


#: (section, key) of case files.
KEYS = [(section, key) for section, key, _ in _core.keys()]
_UNITS = {key: unit for _, key, unit in _core.keys()}
SECTIONS = {section.split(".")[0] for section, _ in KEYS} - {""}
#: Keys of [rolling] that take lists; all their combinations become load points of one solution.
CREEPAGES = ("longitudinal_creepage", "lateral_creepage", "spin")
_SOLVING = tuple(SECTIONS - {"load", "wheel", "rail", "wheel_profile", "rail_profile", "track", "wheelset"})
#: Sections and keys of a case that a call does not use.
UNUSED: dict[str, tuple[str, ...]] = {
    "solve": ("table",), "sweep": ("table",), "contact_points": _SOLVING,
    "wheelset": (*_SOLVING, "wheelset.lateral_shift"),
    "table": ("history", "output", "subsurface", *(f"rolling.{name}" for name in CREEPAGES),
              *(f"wheelset.{name}" for name in ("lateral_shift", "free_rolling", "rotation_change", "lateral_velocity",
                                                "yaw_velocity")))}


def with_unit(name: str) -> str:
    """A key as the label of an axis: "normal_force (N)"."""
    unit = _UNITS.get(name.replace("__", ".").rpartition(".")[2])
    return f"{name} ({unit})" if unit else name


def path_of(name: str, value: Any = None, sections: Container[str] = (), call: str = "") -> list[str]:
    """Section and name of a key given by its name alone: "spin" is ["rolling", "spin"]. An unknown one is returned as it
    is, and the reader rejects it. InputError where it fits several keys, of those that the call uses; keys of [history]
    and [table] fit where there is such a section."""
    fits = [section for section, key in KEYS if key == name]
    if name in SECTIONS:
        if value is None:
            return [name]
        first = next(key for section, key in KEYS if section.split(".")[0] == name)
        raise InputError(f"{name} = {value!r}: {name} is a section; allowed: {name}={{{first!r}: ...}} and its other keys"
                         + "".join(f", or {section}.{name}" for section in fits) + "; do: name the key that is meant")
    if "" in fits or not fits:
        return [name]
    if len(fits) > 1:
        used = [section for section in fits if not is_unused(f"{section}.{name}", call)
                and (section not in ("history", "table") or section in sections or section == call)]
        if len(used) > 1:
            raise InputError(f"{name}: several sections have this key; allowed: "
                             + ", ".join(f"{section}.{name}" for section in used)
                             + f"; do: write {used[0]}={{'{name}': ...}} or **{{'{used[0]}.{name}': ...}}")
        fits = used or fits
    return [fits[0], name]


def is_unused(key: str, call: str) -> bool:
    """Whether a call does nothing with a key "section.name"."""
    return any(f"{key}.".startswith(f"{unused}.") for unused in UNUSED.get(call, ()))


def refuse_unused(asked: Mapping[str, Any], data: Mapping[str, Any], call: str) -> None:
    """InputError for keys that were given to a call which does not use them; every case needs a friction."""
    for key in paths(asked):
        if is_unused(key, call) and (key.split(".")[0] != "friction" or "friction" in data):
            raise InputError(f"{key}: rollfem.{call} does not use this key; do: leave it out"
                             + (", or call rollfem.table" if key.startswith("table.") else ""))


def paths(tree: Mapping[str, Any], above: str = "") -> Iterator[str]:
    """"section.name" of all values in sections that are not None."""
    for name, value in tree.items():
        if isinstance(value, dict):
            yield from paths(value, f"{above}{name}.")
        elif value is not None:
            yield f"{above}{name}"


BARE = {*string.ascii_letters, *string.digits, *"_-"}


def _key(name: str) -> str:
    return name if name and BARE.issuperset(name) else json.dumps(name, ensure_ascii=False)


def _value(value: Any, where: str) -> str:
    """A value as TOML."""
    if isinstance(value, numbers.Real):  # true, 5, 1e-05, nan, -inf
        return str(value if isinstance(value, bool) else int(value) if isinstance(value, numbers.Integral) else float(value)).lower()
    if isinstance(value, (str, os.PathLike)):
        return json.dumps(os.fspath(value), ensure_ascii=False).replace("\x7f", "\\u007F")
    if isinstance(value, (list, tuple, range)):
        return "[" + ", ".join(_value(each, where) for each in value) + "]"
    raise InputError(f"{where}: {value!r} is not a value of a case; allowed: numbers, strings, true or false, and lists "
                     "of these; do: leave the key out where its default is meant")


def toml_lines(table: Mapping[str, Any], path: Sequence[str] = ()) -> Iterator[str]:
    """Lines of a table: its own values first, then the tables in it."""
    later: list[str] = []
    for name, value in table.items():
        if not isinstance(name, str):
            raise InputError(f"{'.'.join(path)}: {name!r} is not a key; allowed: strings")
        here = [*path, name]
        if isinstance(value, dict):
            later += ["", f"[{'.'.join(map(_key, here))}]", *toml_lines(value, here)]
        elif isinstance(value, (list, tuple)) and value and all(isinstance(each, dict) for each in value):
            for each in value:
                later += ["", f"[[{'.'.join(map(_key, here))}]]", *toml_lines(each, here)]
        else:
            yield f"{_key(name)} = {_value(value, '.'.join(here))}"
    yield from later


def _plain(value: Any) -> Any:
    """A copy with plain Python values instead of numpy's, whose arrays cannot be compared as a whole."""
    if isinstance(value, (np.ndarray, np.generic)):
        return value.tolist()
    if isinstance(value, (list, tuple, range)):
        return [_plain(each) for each in value]
    if isinstance(value, dict):
        return {name: _plain(each) for name, each in value.items()}
    return copy.deepcopy(value)


def _merge(into: dict[str, Any], other: Mapping[str, Any], removing: bool = False) -> None:
    """Merges `other` into a dict of sections: sections key by key, everything else as it is; `removing`: None removes a
    key."""
    for name, value in other.items():
        if value is None and removing:
            into.pop(name, None)
        elif isinstance(value, dict):
            kept = into.setdefault(name, {})
            if not isinstance(kept, dict):
                raise InputError(f"{name} is not a section")
            _merge(kept, value, removing)
        else:
            into[name] = _plain(value)


def nested(changes: Mapping[str, Any], data: Mapping[str, Any], call: str = "") -> dict[str, Any]:
    """{"friction.coefficient": 0.3} and {"friction__coefficient": 0.3} as sections; a name without a section is
    looked for in those that `call` uses (names.path_of)."""
    found: dict[str, Any] = {}
    given = {name for name, value in changes.items() if isinstance(value, dict)}
    once: dict[str, str] = {}
    for name, value in changes.items():
        if not isinstance(name, str):
            raise InputError(f"{name!r} is not a key; allowed: strings")
        parts = name.replace("__", ".").split(".")
        if len(parts) == 1 and not isinstance(value, dict):
            parts = path_of(name, value, {*data, *given}, call)
        if (other := once.setdefault(".".join(parts), name)) != name:
            raise InputError(f"{name}: is the same key as {other}; do: give it once")
        for part in reversed(parts):
            value = {part: value}
        _merge(found, value)
    return found


def merged(data: dict[str, Any], changes: Mapping[str, Any], call: str = "") -> dict[str, Any]:
    """`data` with changed keys; those that are None are removed."""
    asked = nested(changes, data, call)
    refuse_unused(asked, data, call)
    _merge(data, asked, removing=True)
    return data


class Case(InFile):
    """A problem to solve: the sections and keys of a case file (docs/case-file.md), with the same checks.

    A case never changes; `with_` makes another.

    Args:
        source: A case file, or the sections of one.
        **sections: Sections as dicts, or single keys as in `with_`. They replace those of `source`; None removes a key.
    Raises:
        FileError: The case file cannot be read.
        InputError: A key or value is wrong.

    >>> case = rollfem.Case("cases/thesis_a.toml", load={"normal_force": 60e3})
    """

    _file: str
    _data: dict[str, Any]
    _read: Any  # the case of the library, or title and text of a stored one

    def __init__(self, source: "str | os.PathLike[str] | Mapping[str, Any] | Case | None" = None, /, **sections: Any) -> None:
        self._take(source, sections)

    def _take(self, source: Any, sections: Mapping[str, Any], call: str = "") -> None:
        """`call`: for which the case is made, with sections that it must use."""
        self._file, data, core = "", {}, None
        if isinstance(source, Case):
            self._file, data = source._file, source.data
        elif isinstance(source, (str, os.PathLike)):
            self._file = os.fspath(source)
            core = _core.read_case(self._file, [])
            data = tomllib.loads(core.text)
        elif source is not None and not isinstance(source, dict):
            raise InputError(f"{source!r} is not a case; allowed: a case file, a dict of sections, a rollfem.Case")
        try:
            if isinstance(source, dict):
                data = _plain(source)
            self._data = merged(data, sections, call)
            self._read = core if core is not None and not sections else self._parsed()
        except RecursionError:
            raise InputError("the case contains itself, or its sections nest too deeply") from None

    @classmethod
    def of(cls, file: str, data: dict[str, Any]) -> "Case":
        """From the contents of a case file, whose name is "" where there is none."""
        case = cls.__new__(cls)
        case._file, case._data = file, data
        case._read = case._parsed()
        return case

    @classmethod
    def for_call(cls, call: str, source: Any, sections: Mapping[str, Any]) -> "Case":
        """The case of a call that is given a case and keys."""
        made = cls.__new__(cls)
        made._take(source, sections, call)
        return made

    @classmethod
    def from_ellipse(cls, semi_axis_x: float, semi_axis_y: float, normal_force: float, **sections: Any) -> "Case":
        """A case whose bodies touch in a given Hertzian ellipse.

        The wheel gets the rolling radius and a flat tread, the rail the transverse radius that follow from Hertz's
        theory (Johnson, Contact Mechanics, 1985, equations 4.25).

        Args:
            semi_axis_x, semi_axis_y: Along rolling and across, mm.
            normal_force: The load, N.
            **sections: As of `Case`; materials are taken from there.
        Raises:
            InputError: A semi-axis or the force is not positive, or a key is wrong.

        >>> case = rollfem.Case.from_ellipse(3.8, 10.9, 50e3, friction={"coefficient": 0.5})
        """
        if not all(math.isfinite(value) and value > 0 for value in (semi_axis_x, semi_axis_y, normal_force)):
            raise InputError(f"from_ellipse({semi_axis_x!r}, {semi_axis_y!r}, {normal_force!r}): allowed: semi-axes and a "
                             "force > 0; do: give them in mm and N")
        bodies = {"load.normal_force": normal_force, "wheel.rolling_radius": 1.0, "wheel.transverse_radius": math.inf,
                  "rail.transverse_radius": 300.0}
        case = cls.of("", merged(nested(sections, {}), bodies))
        along, across = case.core.curvatures_of_ellipse(semi_axis_x, semi_axis_y, normal_force)
        return case.with_({"wheel.rolling_radius": 0.5 / along, "rail.transverse_radius": 0.5 / across})

    def _parsed(self) -> _core.Case:
        return _core.case_of_values("\n".join(toml_lines(self._data)).lstrip("\n") + "\n", self._file or "case")

    def with_(self, changes: Mapping[str, Any] | None = None, /, **keys: Any) -> "Case":
        """Another case with changed keys.

        Args:
            changes: {"friction.coefficient": 0.3}; a key without its section where it fits one only (keys of [history]
                and [table] where the case has these): {"spin": 1e-4}; or whole sections.
            **keys: The same with __ in place of the dot: friction__coefficient=0.3. A key set to None is removed.
        Raises:
            InputError: A key or value is wrong.

        >>> wet = case.with_(friction__coefficient=0.2, spin=None)
        """
        if changes is not None and not isinstance(changes, dict):
            raise InputError(f"with_({changes!r}): allowed: a dict of keys, or keywords")
        return Case.of(self._file, merged(self.data, {**(changes or {}), **keys}))

    def __getitem__(self, name: str) -> Any:
        """case["friction.coefficient"], or a section as a dict. KeyError for keys the case does not set."""
        if not isinstance(name, str):
            raise InputError(f"case[{name!r}]: allowed: names of keys and sections, as \"friction.coefficient\"")
        found: Any = self._data
        for part in name.split("."):
            if not isinstance(found, dict):
                raise KeyError(name)
            found = found[part]
        return copy.deepcopy(found)

    @property
    def core(self) -> _core.Case:
        """The case of the library."""
        core: _core.Case = self._read
        return core

    @property
    def data(self) -> dict[str, Any]:
        """All keys as a dict of sections; a copy."""
        return copy.deepcopy(self._data)

    file: str = forwarded("_file", 'The case file, or "" for a case made in Python.')
    title: str = forwarded("_read.title", "As the case has it.")
    text: str = forwarded("_read.text", "The case as TOML.")
    models: list[str] = forwarded("core.models", "Names of the models that the case requests.")
    load_points: int = forwarded("core.load_points", "Number of load points of every scene.")

    def describe(self) -> str:
        """Every key as it was understood.

        Returns:
            Value, unit and whether it is the default, as `rollfem check` prints it.

        >>> print(case.describe())
        """
        return self.core.describe()

    def _text_in(self, folder: str) -> str:
        return self.core.text_in_folder(folder)

    def _repr_html_(self) -> str:
        return f"<p>{escape(repr(self))}</p><details><summary>keys</summary><pre>{escape(self.text)}</pre></details>"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Case) and (self._data, self._file) == (other._data, other._file)

    def __hash__(self) -> int:
        return hash(self.text)

    def __reduce__(self) -> tuple[Any, ...]:
        return Case.of, (self._file, self.data)

    def __repr__(self) -> str:
        count = self.load_points
        return f"<rollfem.Case {self.title or self._file or 'without a title'!r}: {count} load point{'s' * (count > 1)}>"


class StoredCase(Case):
    """The case of a stored result. It is parsed only if more than title and text is needed, because missing files of
    the case must not prevent showing the result."""

    def __init__(self, file: str, title: str, text: str) -> None:
        self._file, self._data, self._read = file, tomllib.loads(text), SimpleNamespace(title=title, text=text)

    def __reduce__(self) -> tuple[Any, ...]:
        return StoredCase, (self._file, self.title, self.text)

    @property
    def core(self) -> _core.Case:
        """Reads the case."""
        return Case.of(self._file, self._data).core

    def __repr__(self) -> str:
        return f"<rollfem.Case {self.title!r}, stored>"


#: What stands for a case in calls: a case file, a dict of sections, or a case.
CaseLike = str | os.PathLike[str] | dict[str, Any] | Case
