# SPDX-License-Identifier: LGPL-2.1-or-later
import pytest

import program


@pytest.fixture
def rollfem():
    with program.folder() as made:
        yield made
