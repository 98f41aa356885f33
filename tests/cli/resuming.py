# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs killed at a chosen moment, and the comparison of two results to the last bit."""

import json
import signal

import h5py
import numpy as np


def killed(rollfem, moment, *arguments, **how):
    """Ends rollfem by SIGKILL as soon as `moment` has come, which it must outlast."""
    outcome = rollfem.call(*arguments, watch=lambda: signal.SIGKILL if moment() else 0, **how)
    assert outcome.status == 128 + signal.SIGKILL, outcome


def records(unfinished, begin=""):
    """The number of records whose name begins so."""
    return len(list(unfinished.glob(f"{begin}*.point")))


def timeless(path):
    """A JSON file of a result without times and without data that identify the call."""
    varying = {"seconds", "started", "command", "case_file", "checksum", "choice"}
    return json.loads(path.read_text("utf-8"),
                      object_pairs_hook=lambda pairs: {key: value for key, value in pairs if key not in varying})


def fields(folder):
    """The bytes of the datasets of a result, by name."""
    names, found = [], {}
    with h5py.File(folder / "results.h5") as file:
        file.visit(names.append)
        for name in names:
            if isinstance(file[name], h5py.Dataset) and not name.startswith("provenance") and "seconds" not in name:
                value = np.atleast_1d(file[name][()])
                found[name] = value.tolist() if value.dtype == object else value.tobytes()
    return found


def same_results(one, other):
    """Holds that two results are the same to the last bit."""
    assert timeless(one / "summary.json") == timeless(other / "summary.json")
    first, second = fields(one), fields(other)
    assert len(first) >= 10
    assert [name for name in first if second.get(name) != first[name]] == []
