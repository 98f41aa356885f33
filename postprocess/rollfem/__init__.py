# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rolling contact of wheel and rail, with error bars.

    import rollfem
    result = rollfem.solve("case.toml", model="halfspace")
    result.points[0].max_pressure            # MPa

Units are mm, N, MPa, s, rad. x is the rolling direction, y lateral, z normal and into the wheel; forces and tractions
act on the wheel, and traction_coefficient is -F_x/F_z. `help(rollfem.Point)` lists every quantity with unit and sign.
`python3 -m rollfem PATH` draws the figures and the page of what rollfem has written to PATH.
"""
import importlib
from importlib.machinery import PathFinder
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .api import *  # noqa: F403
    from .api import __all__ as __all__
    from .api import __version__ as __version__
else:
    def __getattr__(name: str) -> Any:
        """A submodule, or a name of `api`, which loads the compiled module: drawing a report does not wait for it."""
        if PathFinder.find_spec(f"{__name__}.{name}", __path__):
            found = importlib.import_module(f".{name}", __name__)
        elif name == "_core":
            raise ImportError("rollfem was built without its compiled Python module; do: build it with ROLLFEM_PYTHON=ON")
        else:
            found = getattr(importlib.import_module(".api", __name__), name)
        globals()[name] = found
        return found

    def __dir__() -> list[str]:
        return sorted({*globals(), *importlib.import_module(".api", __name__).__all__})
