# SPDX-License-Identifier: LGPL-2.1-or-later
"""The finite-element model after a kill, in one process and in two: the run resumes from the coarse level of the error
estimate and every finished load point, with a result identical to the last bit. And the hybrid, whose correction is then
in the cache."""

import shutil
import time

import pytest
from program import SMALL, says
from resuming import killed, records, same_results


def coarse(solver, creepages):
    """Small bodies; `solver` decides whether two processes can take the case."""
    return {"models": ["fem"]} | SMALL | {
        "rail.transverse_radius": 500.0, "rolling.longitudinal_creepage": creepages, "fem.cell_size": 1.8, "fem.extent": 20,
        "fem.linear_solver": solver}


@pytest.mark.parametrize("processes, solver, creepages, moments", [
    # On the level of the error estimate, after one load point; in the middle of the curve.
    (1, "factorisation", [0.0, 0.001, 0.002], {"fem-3.6mm": 1, "fem-1.8mm": 2}),
    (2, "multigrid", [0.0, 0.002], {"fem-3.6mm": 2})])
def test_the_result_is_the_same_to_the_last_bit(rollfem, processes, solver, creepages, moments):
    run = "run", rollfem.case(coarse(solver, creepages)), "--no-report", "-o"
    rollfem.done(*run, "whole", processes=processes)
    unfinished = rollfem.work / "killed.unfinished"
    for level, more_than in moments.items():
        killed(rollfem, lambda: records(unfinished, level) > more_than, *run, "killed", processes=processes)
        assert not rollfem.holds("killed")
        for _ in range(20):
            outcome = rollfem.call(*run, "killed", "--resume", processes=processes)
            if "another run is writing" not in outcome.err:
                break
            time.sleep(1)  # The processes of a killed mpirun end when they notice: until then the folder is theirs.
        assert outcome.status == 0, outcome
        says(outcome.err, "solutions of an earlier run")
        same_results(rollfem.work / "whole", rollfem.work / "killed")
        assert not unfinished.exists()
        shutil.rmtree(rollfem.work / "killed")


def test_the_hybrid_takes_up_load_points_and_its_correction(rollfem):
    # On a grid so fine that load points are kept, which they are after half a second.
    file = rollfem.case({"models": ["hybrid"]} | SMALL | {
        "wheel.transverse_radius": 405.0, "contact_grid.elements_across": 80, "fem.degree": 1, "fem.extent": 25,
        "rolling.longitudinal_creepage": [0.0, 0.0003, 0.0006, 0.0009, 0.0012, 0.0015, 0.002, 0.0025, 0.003, 0.004]})
    run = "run", file, "--no-report", "-o"
    cache = {"ROLLFEM_CACHE": "cache"}
    killed(rollfem, lambda: records(rollfem.work / "killed.unfinished", "hybrid") > 2, *run, "killed", **cache)
    says(rollfem.done(*run, "killed", "--resume", **cache).err, "solutions of an earlier run")
    rollfem.done(*run, "whole", **cache)
    # Notes are compared as well: in both the correction is the one that the killed run has found.
    same_results(rollfem.work / "whole", rollfem.work / "killed")
    says(rollfem.text("killed/summary.json"), "comes from the cache")
