# SPDX-License-Identifier: LGPL-2.1-or-later
"""What calls raise; the compiled module raises these too."""


class InputError(ValueError):
    """A case, a file or a call is wrong."""


class FileError(InputError, OSError):
    """A file cannot be read or written, or is not what it should be."""


class OutputError(FileError):
    """The call is right, but what it found cannot be written."""


class SolveError(RuntimeError):
    """No solution was reached."""
