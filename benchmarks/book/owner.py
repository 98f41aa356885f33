# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ensures that one process at a time writes a folder, with the same lock file as the program's results."""
import contextlib
import fcntl
import os
import socket
import time

_HEAD = "rollfem is writing the result beside this file.\n"


class Owned(Exception):
    """Raised if another process is writing the folder; names it."""


def _owner_of(file):
    """The owner's description of itself; empty if not yet written."""
    for _ in range(10):
        file.seek(0)
        text = file.read()
        if text.startswith(_HEAD) and text.endswith("\n") and text != _HEAD:
            return text.removeprefix(_HEAD).strip()
        time.sleep(0.05)
    return "an unknown process"


@contextlib.contextmanager
def owner(folder, command):
    """Holds DIR.lock. The lock ends with its process; the file left by a killed process is reused."""
    path = os.path.realpath(folder) + ".lock"
    os.makedirs(os.path.dirname(path), exist_ok=True)
    while True:
        file = open(path, "a+", encoding="utf-8")
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise Owned(f"another run is writing {folder}: {_owner_of(file)}; do: wait for it, or name other "
                        "folders with -o and --results") from None
        # Its owner may have removed the file in between.
        with contextlib.suppress(FileNotFoundError):
            if os.path.samestat(os.fstat(file.fileno()), os.stat(path)):
                break
        file.close()
    file.truncate(0)
    start = time.strftime("%Y-%m-%dT%H:%M:%SZ", time.gmtime())
    file.write(f"{_HEAD}process {os.getpid()} on {socket.gethostname()}, started {start}: {command}\n")
    file.flush()
    try:
        yield
    finally:
        os.unlink(path)
        file.close()
