# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes rollfem_figures, which reads results and draws them, a package that can be imported wherever it lies."""
import os
import sys
from importlib.util import module_from_spec, spec_from_file_location

from . import _core

if "rollfem_figures" not in sys.modules:
    spec = spec_from_file_location("rollfem_figures", os.path.join(_core.figures_directory(), "__init__.py"))
    assert spec is not None and spec.loader is not None
    sys.modules["rollfem_figures"] = module_from_spec(spec)
    spec.loader.exec_module(sys.modules["rollfem_figures"])
