#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""results.h5 as Python reads it: every number of the result in memory to the last bit, and one clear message for each kind of
incomplete or damaged file. Call: reading.py; rollfem is found by PYTHONPATH."""
import pathlib
import random
import sys
import tempfile
import unittest

import h5py
import numpy as np

import rollfem
from rollfem.files import seal_results
from rollfem.reader import read_result

CASE = {"title": "a crown", "load": {"normal_force": 50e3}, "friction": {"coefficient": 0.5}, "contact_grid": {"elements_across": 50},
        "wheel": {"rolling_radius": 400.0, "transverse_radius": float("inf"), "young_modulus": 207e3, "poisson_ratio": 0.28},
        "rail": {"transverse_radius": 400.0}, "rolling": {"longitudinal_creepage": [0.0, 0.001], "spin": 1e-4},
        "output": {"stress_maxima": True}, "subsurface": {"line": [{"body": "rail", "from": [0, 0, 0], "to": [0, 0, -5], "points": 5}]}}
#: (what is done to the file, part of the message)
CHANGES = [
    ("f.attrs['format'] = 'something'", "but not a result of rollfem"), ("del f.attrs['format']", "but not a result of rollfem"),
    ("f.attrs['format_version'] = 1", "format version 1, this program reads 3"),
    ("f.attrs['format_version'] = 4", "format version 4, this program reads 3"),
    ("del f.attrs['complete']", "is incomplete, because writing it was interrupted"),
    ("f.attrs['complete'] = 0", "is incomplete, because writing it was interrupted"),
    ("del f['case']", "cannot be read as a result of rollfem"), ("del f['models/hertz/grid']", "cannot be read as a result of rollfem"),
    ("d = f['models/halfspace/points/0001']; del d['pressure']; d['pressure'] = [1.0]", "pressure has the shape (1,) on a grid of (")]


class Reading(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.result = rollfem.solve(CASE, models=["hertz", "halfspace"])
        cls.result.write(cls.folder / "r")
        cls.whole = (cls.folder / "r/results.h5").read_bytes()

    def same(self, a, b, where):
        """Whether dicts, lists, arrays and numbers are equal to the last bit."""
        if isinstance(a, dict):
            self.assertLessEqual(set(a), set(b), where)  # files have more beside stresses
            for name in a:
                self.same(a[name], b[name], f"{where}.{name}")
        elif isinstance(a, list) and a and isinstance(a[0], dict):
            self.assertEqual(len(a), len(b), where)
            for k, each in enumerate(a):
                self.same(each, b[k], f"{where}[{k}]")
        else:
            np.testing.assert_array_equal(a, b, where)

    def test_what_was_written_comes_back(self):
        read = read_result(str(self.folder / "r"))
        self.assertEqual((read.title, read.case_text), (self.result.title, self.result.case_text))
        self.assertEqual((read.inputs["wheel.young_modulus"], read.inputs["rail.poisson_ratio"]), (207e3, 0.3))
        for one, other in zip(self.result.models, read.models, strict=True):
            for name in ("name", "label", "key", "x", "y", "dx", "dy", "unknowns", "contact_elements", "seconds", "notes", "place",
                         "traits"):
                self.same(getattr(one, name), getattr(other, name), name)
            for point, stored in zip(one.points, other.points, strict=True):
                for name in ("scalars", "fields", "error_estimate", "no_bar", "model_error", "richardson", "stress_maxima", "subsurface",
                             "pass_work"):
                    self.same(getattr(point, name), getattr(stored, name), name)
        self.assertTrue("frictionless" in read["hertz"].traits and "has_stress" in read["halfspace"].traits)
        self.assertTrue(read["halfspace"].points[1].stress_maxima and read["halfspace"].points[1].subsurface)

    def refused(self, data):
        """What is said about a file with these bytes."""
        path = self.folder / "broken.h5"
        path.write_bytes(data)
        with self.assertRaises(rollfem.FileError) as caught:
            read_result(str(path))
        self.assertIn("do: ", str(caught.exception))
        self.assertNotIn("\n", str(caught.exception))
        return str(caught.exception)

    def test_truncated_and_damaged_files_are_refused(self):
        for part in range(1, 40):
            self.assertIn("truncated or damaged", self.refused(self.whole[:len(self.whole) * part // 40]))
        chance = random.Random(1)
        for _ in range(100):
            damaged = bytearray(self.whole)
            damaged[chance.randrange(len(damaged))] ^= 1 << chance.randrange(8)
            self.refused(bytes(damaged))
        for data in (self.whole + b"x", self.whole[512:]):
            self.assertIn("its checksum is missing or does not match", self.refused(data))
        for data in (b"", b'title = "a case"'):
            self.assertIn("not a result of rollfem", self.refused(data))

    def test_files_that_are_none_are_refused(self):
        for path, words in (("no/such/folder", "no/such/folder: there is no such file"), ("/dev/null", "is not a regular file"),
                            (str(self.folder), "results.h5: there is no such file")):
            with self.assertRaisesRegex(rollfem.FileError, words):
                read_result(path)

    def changed(self, change):
        """A file changed on purpose, with the checksum of what it is now."""
        path = self.folder / "changed.h5"
        path.write_bytes(self.whole)
        with h5py.File(path, "a") as f:
            exec(change, {"f": f})
        self.assertIn("its checksum is missing or does not match", self.refused(path.read_bytes()))
        seal_results(str(path))
        return path

    def test_other_formats_and_incomplete_files_are_refused(self):
        for change in ("f.attrs['note'] = 'more of it'", "f.attrs['format_minor'] = 7", "del f.attrs['format_minor']"):
            self.assertEqual(len(read_result(str(self.changed(change)))), 2)
        for change, part in CHANGES:
            with self.subTest(change):
                self.assertIn(part, self.refused(self.changed(change).read_bytes()))

    def test_damaged_fields_are_refused(self):
        # Bytes of a compressed field overwritten. (HDF5 does not guard its own structures like that.)
        path = self.folder / "r/results.h5"
        with h5py.File(path) as f:
            chunk = f["models/halfspace/points/0001/pressure"].id.get_chunk_info(0)
        at, length = chunk.byte_offset + chunk.size // 2, min(64, chunk.size // 2)
        data = self.whole[:at] + b"\xff" * length + self.whole[at + length:]
        (self.folder / "field.h5").write_bytes(data)
        seal_results(str(self.folder / "field.h5"))
        self.assertIn("truncated or damaged", self.refused((self.folder / "field.h5").read_bytes()))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
