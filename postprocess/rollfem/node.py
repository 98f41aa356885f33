# SPDX-License-Identifier: LGPL-2.1-or-later
"""A part of a result by the names of its files, from the library or from results.h5: one way to both."""
from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

import numpy as np

from .errors import FileError


class Node(NamedTuple):
    """Numbers and words; arrays, lines and texts; parts, all by name."""

    attributes: dict[str, Any]
    entries: Mapping[str, Any]
    parts: "dict[str, Node]"

    @classmethod
    def of(cls, contents: Any) -> "Node":
        """From the library."""
        attributes, entries, parts = contents
        return cls(attributes, entries, {name: cls.of(part) for name, part in parts.items()})

    @classmethod
    def in_file(cls, group: Any, later: bool = False) -> "Node":
        """From a group of a file. Values of bodies are large: they are read `later`, when they are looked up."""
        arrays = {name: item for name, item in group.items() if hasattr(item, "shape")}
        entries = Later(group.file.filename, group.name, list(arrays)) if later else {
            name: _read(item) for name, item in arrays.items()}
        return cls({name: _plain(value) for name, value in group.attrs.items()}, entries,
                   {name: cls.in_file(item, later or name == "bodies") for name, item in group.items() if name not in arrays})

    def rows(self, table: str) -> list[dict[str, Any]]:
        """The rows of a part that is a table."""
        columns = self.parts[table].entries if table in self.parts else {}
        return [dict(zip(columns, row)) for row in zip(*columns.values())]


class Later(Mapping[str, np.ndarray]):
    """Arrays of a group that are read from the file at every look-up."""

    def __init__(self, file: str, group: str, names: list[str]) -> None:
        self._file, self._group, self._names = file, group, names

    def __getitem__(self, name: str) -> np.ndarray:
        if name not in self._names:
            raise KeyError(name)
        try:
            with hdf5().File(self._file, "r") as file:
                found: np.ndarray = file[self._group][name][()]
                return found
        except (OSError, KeyError) as error:
            raise FileError(f"{self._file}: {self._group}/{name} cannot be read: {error}") from error

    def __iter__(self) -> Iterator[str]:
        return iter(self._names)

    def __len__(self) -> int:
        return len(self._names)


def hdf5() -> Any:
    """h5py, loaded by whoever reads a file: `import rollfem` does not wait for it."""
    try:
        import h5py  # pylint: disable=import-outside-toplevel
    except ImportError as error:
        raise ImportError(f"figures need numpy and h5py: {error}; do: apt install python3-numpy python3-h5py") from error
    return h5py


def _plain(value: Any) -> Any:
    """An HDF5 attribute as a Python value."""
    if isinstance(value, bytes):
        return value.decode("utf-8", "replace")
    return value.item() if isinstance(value, np.generic) else value


def _read(dataset: Any) -> Any:
    """Numbers, a text, or lines."""
    value = dataset[()] if dataset.shape != (0,) else np.empty(0)
    if isinstance(value, np.ndarray) and value.dtype.kind != "O":
        return value if dataset.dtype.kind != "O" else []
    return [_plain(line) for line in value] if isinstance(value, np.ndarray) else _plain(value)
