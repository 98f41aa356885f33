# SPDX-License-Identifier: LGPL-2.1-or-later
"""A wrong line that a test must detect."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Mutation:
    name: str
    file: str
    find: str
    put: str
    breaks: str
    suspects: tuple

    @property
    def fem(self):
        """Whether only finite elements run this line."""
        return self.name.startswith("fem_")
