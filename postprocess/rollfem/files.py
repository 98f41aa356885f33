# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files: written completely or not at all, with checksums that detect damage (result/files/seal.hpp)."""
import contextlib
import csv
import io
import json
import math
import os
import stat
import zlib
from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

_SEAL = 512  # bytes of the user block before the HDF5 data


def regular(path: str, flags: int) -> int:
    """An opener for `open` that neither reads a device nor waits for a FIFO."""
    file = os.open(path, flags | os.O_NONBLOCK, 0o666)
    if stat.S_ISREG(os.fstat(file).st_mode):
        return file
    os.close(file)
    raise OSError(f"{path}: is not a regular file")


@contextlib.contextmanager
def whole(path: str) -> Iterator[str]:
    """A temporary name to write to; the file then appears at `path` complete or not at all."""
    part = f"{path}.part-{os.getpid()}"
    try:
        yield part
        os.replace(part, path)
    finally:
        if os.path.exists(part):
            os.remove(part)


def write_whole(path: str, text: str) -> None:
    """Writes a text completely or not at all; bytes of file names that are not UTF-8 become ?."""
    with whole(path) as part, open(part, "w", encoding="utf-8", errors="replace") as file:
        file.write(text)


def folder_of(path: str) -> str:
    """The folder at a path, or of a file there."""
    return path if os.path.isdir(path) else os.path.dirname(os.path.abspath(path))


def _seal(size: int, crc: int) -> bytes:
    """The user block before HDF5 data of this size and checksum."""
    text = (f"rollfem results\nbytes: {size}\ncrc32: {crc:08x}\n"
            f"of the HDF5 data behind this user block of {_SEAL} bytes\n")
    return text.ljust(_SEAL, "\n").encode("ascii")


def results_are_sound(path: str) -> bool:
    """False if the checksum of results.h5 is missing or does not match."""
    with open(path, "rb", opener=regular) as file:
        block, size, crc = file.read(_SEAL), 0, 0
        while part := file.read(1 << 20):
            size, crc = size + len(part), zlib.crc32(part, crc)
    return block == _seal(size, crc)


def seal_results(path: str) -> None:
    """Updates the checksum after h5py or another program has changed results.h5."""
    with open(path, "r+b") as file:
        data = file.read()[_SEAL:]
        file.seek(0)
        file.write(_seal(len(data), zlib.crc32(data)))


def json_is_sound(text: str) -> bool:
    """False if the checksum of a JSON file is missing or does not match."""
    data = text.encode("utf-8")
    at = data.rfind(b'"checksum": "crc32 ')
    return at >= 0 and data[at + 19:] == b'%08x"\n}\n' % zlib.crc32(data[:at])


def _finite(value: Any) -> Any:
    """JSON has no infinite numbers and no nan: they are null."""
    if isinstance(value, Mapping):
        return {name: _finite(each) for name, each in value.items()}
    if isinstance(value, (list, tuple)):
        return [_finite(each) for each in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


def sealed_json(data: Mapping[str, Any], indent: int = 1) -> str:
    """The text of a JSON object with its checksum as the last member."""
    body = json.dumps(_finite(data), indent=indent, ensure_ascii=False).encode("utf-8", "replace").removesuffix(b"\n}") + b",\n  "
    return f'{body.decode()}"checksum": "crc32 {zlib.crc32(body):08x}"\n}}\n'


def cell(value: float | str | None) -> str:
    """A cell of a CSV table: the shortest number that reads the same, or nothing."""
    return "" if value is None else repr(value).removesuffix(".0") if isinstance(value, float) else str(value)


def quoted(text: str) -> str:
    """A cell of text that may hold commas; an apostrophe goes before one that begins like a formula of a spreadsheet."""
    safe = "'" * text.startswith(tuple("=+-@\t\r")) + text.replace('"', '""')
    return f'"{safe}"'


class Rows(NamedTuple):
    """A CSV table, whose columns have names without their units."""

    title: str  # from a comment above it
    rows: list[dict[str, str]]
    units: dict[str, str]


def rows_of(text: str) -> Rows:
    """The table in a text."""
    title, below = (text.partition("\n")[::2] if text.startswith("#") else ("", text))
    rows = list(csv.reader(io.StringIO(below)))
    heads = [column.partition(" [")[::2] for column in rows[0]] if rows else []
    names = [name for name, _ in heads]
    return Rows(title.lstrip("# ").strip(), [dict(zip(names, row)) for row in rows[1:]],
                {name: unit.removesuffix("]") for name, unit in heads})


def read_rows(path: str) -> Rows:
    """The table in a file."""
    with open(path, encoding="utf-8", newline="", opener=regular) as file:
        return rows_of(file.read())
