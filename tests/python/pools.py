#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Python module in pools of threads and of processes: every thread gets what it gets alone, and values travel between
processes. Call: pools.py SOURCE_FOLDER; rollfem is found by PYTHONPATH."""
import multiprocessing
import os
import pathlib
import pickle
import subprocess
import sys
import tempfile
import unittest
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor

import numpy as np

import rollfem

if __name__ == "__main__":
    ROOT = pathlib.Path(sys.argv[1]).resolve()
SMALL = {"load": {"normal_force": 50e3}, "friction": {"coefficient": 0.5},
         "wheel": {"rolling_radius": 460.0, "transverse_radius": np.inf}, "rail": {"transverse_radius": 300.0},
         "rolling": {"longitudinal_creepage": 0.001}, "contact_grid": {"elements_across": 8}}
TABLE = {"axis_ratio": [0.5, 2.0], "points": [3, 3, 3], "largest": [2.0, 2.0, 2.0], "check_points": 5}


def in_threads(job, count=16):
    with ThreadPoolExecutor(8) as pool:
        return list(pool.map(job, range(count)))


class Threads(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def test_results_are_the_same_for_any_number_of_threads(self):
        case = rollfem.Case(SMALL).with_(longitudinal_creepage=list(np.linspace(0, 0.01, 6)))
        self.assertEqual(rollfem.threads(), 1)
        self.addCleanup(rollfem.threads, 1)
        told, found = [], []
        for number in (1, 2, 8):
            self.assertEqual(rollfem.threads(number), number)
            found.append(rollfem.solve(case, model="halfspace", progress=lambda event: told.append(event.point))[0])
        for other in found[1:]:
            np.testing.assert_array_equal(found[0].traction_coefficient, other.traction_coefficient)
            for one, another in zip(found[0].points, other.points):
                np.testing.assert_array_equal(one.traction_x, another.traction_x)
        self.assertIn(6, told)

    def test_an_exception_of_progress_ends_all_threads(self):
        case = rollfem.Case(SMALL).with_(longitudinal_creepage=list(np.linspace(0, 0.01, 6)))
        self.addCleanup(rollfem.threads, rollfem.threads(4) and 1)

        def stop(event):
            if event.point > 2:
                raise ZeroDivisionError("enough")
        with self.assertRaisesRegex(ZeroDivisionError, "enough"):
            rollfem.solve(case, model="halfspace", progress=stop)
        with self.assertRaisesRegex(rollfem.InputError, "allowed: 1 to 1024"):
            rollfem.threads(0)

    def test_the_interpreter_ends_in_silence_while_a_daemon_thread_solves(self):
        script = ("import rollfem, threading, time\n"
                  f"case = rollfem.Case({SMALL!r}).with_(elements_across=60)\n"
                  "threading.Thread(target=lambda: [rollfem.solve(case) for _ in range(1000)], daemon=True).start()\n"
                  "time.sleep(0.5)\n").replace("inf", "float('inf')")
        for _ in range(4):
            ended = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True)
            self.assertEqual((ended.returncode, ended.stderr), (0, ""))

    def test_results_are_written_read_and_evaluated(self):
        result = rollfem.solve(SMALL, model="halfspace")
        result.write(f"{self.folder}/first")
        stress = rollfem.stress(f"{self.folder}/first").contents["stress.csv"]

        def job(number):
            # Several threads at the same folder, too.
            written = rollfem.read(result.write(f"{self.folder}/{number % 8}"))
            np.testing.assert_array_equal(written[0].max_pressure, result[0].max_pressure)
            return rollfem.stress(f"{self.folder}/first").contents["stress.csv"]
        self.assertEqual(set(in_threads(job)), {stress})
        self.assertEqual(set(os.listdir(self.folder)), {"first", *map(str, range(8))})

    def test_tables_and_studies(self):
        table = rollfem.table(SMALL, table=TABLE)
        table.write(f"{self.folder}/table")
        study = rollfem.study(SMALL, levels=2).columns()

        def job(number):
            same = rollfem.Table(f"{self.folder}/table")
            np.testing.assert_array_equal(same.longitudinal_force, table.longitudinal_force)
            same.write(f"{self.folder}/{number % 4}")
            again = rollfem.study(SMALL, levels=2).columns()
            np.testing.assert_array_equal(again["value"], study["value"])
        in_threads(job, 8)

    @unittest.skipUnless("fem" in rollfem.models(), "built without finite elements")
    def test_finite_elements_wait_for_each_other(self):
        coarse = rollfem.Case(SMALL, fem={"degree": 1, "mesh": "gmsh"}, contact_grid={"elements_across": 4})
        alone = rollfem.solve(coarse, model="fem").points[0].max_pressure
        self.assertEqual(set(in_threads(lambda _: rollfem.solve(coarse, model="fem").points[0].max_pressure, 3)), {alone})


def solved(force):
    return rollfem.solve(SMALL, model="halfspace", normal_force=force)


class Processes(unittest.TestCase):
    def expect_same(self, thing, again):
        for name, column in thing.columns().items():
            np.testing.assert_array_equal(again.columns()[name], column, name)

    def test_everything_that_is_computed_can_be_pickled(self):
        result = solved(50e3)
        with tempfile.TemporaryDirectory() as folder:
            result.write(f"{folder}/result")
            things = [result, rollfem.read(f"{folder}/result"), rollfem.sweep(SMALL, spin=[0.0, 1e-4], model="fastsim"),
                      rollfem.compare(SMALL, models=["hertz", "fastsim"]), rollfem.study(SMALL, levels=2),
                      rollfem.table(SMALL, table=TABLE), rollfem.stress(f"{folder}/result"), rollfem.Profile("S1002"),
                      rollfem.solve(ROOT / "cases/s1002_uic60_left.toml", model="hertz"), result[0],
                      rollfem.wheelset(ROOT / "cases/manchester_A22.toml", reach=2.0)]
            for thing in things:
                again = pickle.loads(pickle.dumps(thing))
                self.expect_same(thing, again)
                self.assertIs(type(again), type(thing))
            again = pickle.loads(pickle.dumps(things[:4]))
            np.testing.assert_array_equal(again[2].values("longitudinal_force"), things[2].longitudinal_force)
            self.expect_same(next(iter(again[3].results.values())), next(iter(things[3].results.values())))
            again[0].write(f"{folder}/again")
            for name in ("summary.json", "results.h5", "path_x.csv"):
                contents = [pathlib.Path(folder, each, name).read_bytes() for each in ("result", "again")]
                self.assertEqual(*contents, name)
        np.testing.assert_array_equal(again[0].points[0].pressure, result.points[0].pressure)

    def test_a_pool_of_processes_returns_results(self):
        forces = [40e3, 50e3]
        with ProcessPoolExecutor(2, multiprocessing.get_context("spawn")) as pool:
            for force, found in zip(forces, pool.map(solved, forces)):
                np.testing.assert_array_equal(found[0].points[0].traction_x, solved(force)[0].points[0].traction_x)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
