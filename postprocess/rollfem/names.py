# SPDX-License-Identifier: LGPL-2.1-or-later
"""Names that calls are given: keys of cases, quantities. A wrong one is never taken in silence."""
from collections.abc import Container, Iterator, Mapping
from typing import Any

from . import _core
from .errors import InputError

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
