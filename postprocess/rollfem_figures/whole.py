"""Files that stand whole or not at all."""
import contextlib
import os


@contextlib.contextmanager
def whole(path):
    """The name to write a file under, which then stands at `path` whole or not at all."""
    part = f"{path}.part-{os.getpid()}"
    try:
        yield part
        os.replace(part, path)
    finally:
        if os.path.exists(part):
            os.remove(part)
