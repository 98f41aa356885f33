"""Writes files completely or not at all."""
import contextlib
import os


@contextlib.contextmanager
def whole(path):
    """A temporary name to write to; the file then appears at `path` complete or not at all."""
    part = f"{path}.part-{os.getpid()}"
    try:
        yield part
        os.replace(part, path)
    finally:
        if os.path.exists(part):
            os.remove(part)


def write_whole(path, text):
    """Writes a text completely or not at all."""
    with whole(path) as part, open(part, "w", encoding="utf-8") as file:
        file.write(text)
