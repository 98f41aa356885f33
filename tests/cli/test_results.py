# SPDX-License-Identifier: LGPL-2.1-or-later
"""The files of a result: one number in summary.json, results.h5, and the tables; units and meanings; files for ParaView
that hold the fields; long lists; folders that get a result completely or not at all."""

import base64
import os
import xml.etree.ElementTree
import zlib

import h5py
import numpy as np
import program
import pytest
from program import PROGRAM, SMALL, SOURCE, WHEEL_ON_RAIL, refused, rolling, says

CASE = {"title": "thesis case a", "models": ["hertz", "polach", "halfspace"]} | SMALL
CREEPAGES = [0.0, 0.001, 0.002]
P0, A, B = 578.967, 3.79236, 10.87295  # Hertz


@pytest.fixture(scope="module")
def solved():
    """A folder with a result, which no test changes."""
    with program.folder() as made:
        made.done("run", made.case(CASE | rolling(CREEPAGES, 16)), "-o", "out", "--no-report", "-q")
        yield made


@pytest.fixture(scope="module")
def stored(solved):
    """Its results.h5."""
    with h5py.File(solved.work / "out/results.h5") as file:
        yield file


def points_of(solved, stored):
    """(scalars of summary.json, group of results.h5, row of creep_curve.csv) of every load point."""
    rows = iter(solved.rows("out/creep_curve.csv"))
    for model in solved.models("out"):
        for k, point in enumerate(model["points"]):
            row = next(rows)
            assert (row["model"], row["point"]) == (model["name"], str(k + 1))  # as people count
            yield point, stored[f"models/{model['name']}/points/{k:04}"], row
    assert not list(rows)


def test_every_scalar_is_one_number_in_all_files(solved, stored):
    names = stored["quantities/name"].asstr()[()]
    always = set(names)
    for point, group, row in points_of(solved, stored):
        always &= point.keys()
        for name in names:
            value = point.get(name)
            assert group.attrs.get(name) == value and (float(row[name]) if row[name] else None) == value, name
            assert isinstance(value, bool) == (name == "converged")
        others = point.keys() - set(names)
        assert {"error_estimate", "no_bar"} <= others <= {"error_estimate", "no_bar", "model_error", "richardson"}
        for kind in others:
            assert dict(group[kind].attrs) == point[kind]
            for name, bar in point[kind].items():
                cell = row.get(f"{kind.replace('no_bar', 'error_estimate')} {name}")
                assert cell is None or cell == bar or float(cell) == bar, name
    assert {"longitudinal_creepage", "normal_force", "max_pressure", "residual", "converged"} <= always


def test_the_summary_has_the_documented_keys_and_no_others(solved):
    summary = solved.json("out/summary.json")
    assert list(summary) == "format title case_file case_checksum program verdict models checksum".split()
    assert summary["format"] == 3 and list(summary["program"]) == ["version", "commit"]
    for model in summary["models"]:
        assert list(model) == "name label unknowns contact_elements seconds notes headline points".split()


def test_scalars_are_described_in_results_h5_in_headings_and_in_the_documentation(solved, stored):
    columns = [stored["quantities"][name].asstr()[()] for name in ("name", "unit", "title", "meaning")]
    heading = solved.text("out/creep_curve.csv").partition("\n")[0].split(",")
    assert heading[2:2 + len(columns[0])] == [f"{name} [{unit}]" for name, unit, _, _ in zip(*columns)]
    page = solved.done("docs", "quantities").out
    for name, _, _, meaning in zip(*columns):
        says(page, f"`{name}`", meaning)
    assert page in (SOURCE / "docs/results.md").read_text("utf-8"), "put there what `rollfem docs quantities` prints"


def test_results_h5_is_complete_and_describes_itself(stored):
    assert (stored.attrs["format"], stored.attrs["format_version"], stored.attrs["complete"]) == ("rollfem results", 3, 1)

    def described(name, part):
        assert stored.id.get_comment(name.encode()), name
        if isinstance(part, h5py.Dataset) and name.startswith("models") and "/notes/" not in name:
            assert {"unit", "description"} <= set(part.attrs), name
    stored.visititems(described)
    assert stored["case/text"].asstr()[()].startswith('title = "thesis case a"\n')
    assert stored["case/keys"].attrs["rail.transverse_radius"] == 2000.0
    model = stored["models/halfspace"]
    point, area = model["points/0002"], model["grid"].attrs["dx"] * model["grid"].attrs["dy"]
    assert point["pressure"].shape == (len(model["grid/y"]), len(model["grid/x"])) and point["pressure"].attrs["unit"] == "MPa"
    for field, force in ("traction_x", "longitudinal_force"), ("pressure", "normal_force"):
        assert area * point[field][()].sum() == pytest.approx(point.attrs[force], abs=1e-6)


@pytest.mark.parametrize("path, axis", [("x", A), ("y", B)])
def test_paths_are_the_middle_lines_of_the_fields(solved, stored, path, axis):
    rows = [row for row in solved.rows(f"out/path_{path}.csv") if (row["model"], row["point"]) == ("halfspace", "2")]
    model = stored["models/halfspace"]
    across = np.abs(model["grid/y" if path == "x" else "grid/x"][()])
    middle = across < across.min() + 1e-9
    for name in "pressure", "traction_x", "slip_x":
        field = model["points/0001"][name][()]
        line = field[middle].mean(axis=0) if path == "x" else field[:, middle].mean(axis=1)
        assert [float(row[name]) for row in rows] == pytest.approx(line.tolist(), rel=1e-15), name
    # The integral of a semi-ellipse.
    step = model["grid"].attrs["d" + path]
    assert step * sum(float(row["pressure"]) for row in rows) == pytest.approx(np.pi / 2 * P0 * axis, rel=0.02)
    # Cells of fields that a model does not have are empty.
    polach = [row for row in solved.rows(f"out/path_{path}.csv") if row["model"] == "polach"]
    assert polach[5]["pressure"] and not polach[5]["displacement_x"]


def vtk_arrays(path):
    """The arrays of a VTK file by their names, decoded by hand: base64 of blocks that zlib has packed."""
    types = {"Float64": "<f8", "Float32": "<f4", "Int32": "<i4", "Int64": "<i8", "UInt8": "u1"}
    found = {}
    for array in xml.etree.ElementTree.parse(path).iter("DataArray"):
        text = array.text.strip()
        blocks = int.from_bytes(base64.b64decode(text[:12])[:8], "little")
        end = (8 * (3 + blocks) + 2) // 3 * 4
        _, size, last, *packed = np.frombuffer(base64.b64decode(text[:end])[:8 * (3 + blocks)], "<u8").tolist()
        data, plain = base64.b64decode(text[end:]), b""
        for length in packed:
            plain += zlib.decompress(data[:length])
            data = data[length:]
        assert len(plain) == (blocks - (last > 0)) * size + last
        values = np.frombuffer(plain, types[array.get("type")])
        found[array.get("Name")] = values.reshape(-1, int(array.get("NumberOfComponents", 1))).squeeze()
    return found


def test_files_for_paraview_are_the_fields(solved, stored):
    for k in range(len(CREEPAGES)):
        found, point = vtk_arrays(solved.work / f"out/fields/halfspace_contact_{k:04}.vtu"), stored[f"models/halfspace/points/{k:04}"]
        assert (found["pressure [MPa]"] == point["pressure"][()].ravel()).all()
        assert (found["tangential traction on the wheel [MPa]"][:, 0] == point["traction_x"][()].ravel()).all()
        state = next(values for name, values in found.items() if name.startswith("state"))
        assert (state == point["state"][()].ravel()).all()


def test_fields_of_many_blocks_are_whole(rollfem):
    rollfem.done("run", rollfem.case(CASE | {"contact_grid.elements_across": 200}), "-m", "hertz", "-o", "out", "--no-report")
    found = vtk_arrays(rollfem.work / "out/fields/hertz_contact.vtu")["pressure [MPa]"]
    with h5py.File(rollfem.work / "out/results.h5") as file:
        pressure = file["models/hertz/points/0000/pressure"][()].ravel()
    assert found.size > 2**15 and (found == pressure).all()


def test_series_are_read_by_vtk(solved, stored):
    reader = pytest.importorskip("vtkmodules.vtkIOXML").vtkXMLUnstructuredGridReader
    root = xml.etree.ElementTree.parse(solved.work / "out/fields/halfspace_contact.pvd").getroot()
    assert (root.tag, root.get("type")) == ("VTKFile", "Collection")
    assert [float(part.get("timestep")) for part in root.iter("DataSet")] == CREEPAGES
    for k, part in enumerate(root.iter("DataSet")):
        file = reader()
        file.SetFileName(str(solved.work / "out/fields" / part.get("file")))
        file.Update()
        grid = file.GetOutput()
        pressure = stored[f"models/halfspace/points/{k:04}/pressure"]
        assert grid.GetNumberOfCells() == pressure.size and grid.GetCell(0).GetClassName() == "vtkQuad"
        cells = grid.GetCellData()
        names = [cells.GetArrayName(n) for n in range(cells.GetNumberOfArrays())]
        for wanted in "pressure", "tangential traction", "gap", "slip", "state (0 exterior, 1 adhesion, 2 slip, 3 plastic)":
            assert any(name.startswith(wanted) for name in names), names
        values = cells.GetArray("pressure [MPa]")
        assert sum(values.GetValue(n) for n in range(pressure.size)) == pytest.approx(pressure[()].sum(), rel=1e-12)


@pytest.mark.parametrize("grid_fields, count, kept", [
    ("auto", 101, [k * 100 // 24 for k in range(25)]), ("some", 26, [k * 25 // 24 for k in range(25)]),
    ("some", 7, [*range(7)]), ("none", 7, []), ("all", 101, [*range(101)])])
def test_long_lists_keep_the_fields_of_some_load_points(rollfem, grid_fields, count, kept):
    rollfem.done("run", rollfem.case(SMALL | rolling([1e-5 * k for k in range(count)], 8) | {"output.grid_fields": grid_fields}),
                 "-m", "fastsim", "-o", "out", "--no-report")
    with h5py.File(rollfem.work / "out/results.h5") as file:
        points = file["models/fastsim/points"]
        assert len(points) == count and [k for k, name in enumerate(sorted(points)) if "pressure" in points[name]] == kept
    # One file for each, the last once more, and the series.
    assert len(list(rollfem.work.glob("out/fields/*"))) == (len(kept) + 2 if kept else 0)


def test_one_patch_of_profiles_has_the_figures_of_a_case_with_radii(rollfem):
    rollfem.done("run", rollfem.case(WHEEL_ON_RAIL | {"wheelset.side": "left"} | rolling(0.001, 12)), "-m", "strip", "halfspace",
                 "-o", "out")
    assert rollfem.holds("out/figures/contact_area.svg") and rollfem.holds("out/figures/pair_left_1.svg")
    assert not rollfem.holds("out/figures/positions.svg")


# Folders.
HERTZ = CASE | {"rolling.longitudinal_creepage": 0.001}


def write(rollfem, directory, keys=HERTZ, model="hertz"):
    return rollfem.call("run", rollfem.case(keys), "-m", model, "-o", directory, "--no-report", "-q")


def test_a_folder_holds_what_the_case_asks_for_and_nothing_is_left_beside(rollfem):
    (rollfem.work / "out").mkdir()
    assert write(rollfem, "out", model="fastsim").status == 0
    assert sorted(os.listdir(rollfem.work / "out")) == ["case.toml", "creep_curve.csv", "fields", "pass_work.csv", "path_x.csv",
                                                        "path_y.csv", "results.h5", "summary.json"]
    assert rollfem.text("out/case.toml") == (rollfem.path / "case.toml").read_text()
    assert os.listdir(rollfem.work) == ["out"]
    assert write(rollfem, "one/two/", HERTZ | {"output.paths": ["y"], "output.fields": False}).status == 0
    assert sorted(os.listdir(rollfem.work / "one/two")) == ["case.toml", "creep_curve.csv", "path_y.csv", "results.h5",
                                                            "summary.json"]


def test_another_result_takes_the_place_of_an_earlier_one_and_files_of_others_stay(rollfem):
    write(rollfem, "out")
    written = ["figures/old.svg", "pass_work.csv", "wheelset_rigid.csv"]
    others = ["notes.txt", "figures/mine.png", "fields/my.txt"]
    for name in written + others:
        rollfem.file(f"work/out/{name}", "earlier")
    assert write(rollfem, "out", HERTZ | {"title": "second", "output.paths": ["x"]}).status == 0
    says(rollfem.text("out/summary.json"), '"title": "second"')
    assert [name for name in [*written, "path_y.csv"] if rollfem.holds(f"out/{name}")] == []
    assert {rollfem.text(f"out/{name}") for name in others} == {"earlier"}
    assert os.listdir(rollfem.work) == ["out"]


def test_a_folder_whose_summary_is_another_programs_is_refused(rollfem):
    rollfem.file("work/out/thesis.doc", "precious")
    rollfem.file("work/out/summary.json", '{"other": 1}')
    refused(write(rollfem, "out"), "not an earlier result")
    assert rollfem.text("out/thesis.doc") == "precious" and len(rollfem.made()) == 3


def test_a_link_is_followed(rollfem):
    (rollfem.work / "disk").mkdir()
    (rollfem.work / "out").symlink_to("disk")
    assert write(rollfem, "out").status == 0
    assert (rollfem.work / "out").is_symlink() and rollfem.holds("disk/summary.json")


def test_a_file_that_cannot_be_written_whole_leaves_the_earlier_result_as_it_was(rollfem):
    write(rollfem, "out")
    before = (rollfem.work / "out/results.h5").read_bytes()
    made = rollfem.made()
    for directory in "out", "new/folder":
        outcome = rollfem.execute("/bin/sh", "-c", 'ulimit -f 40; exec "$0" "$@"', PROGRAM, "run", rollfem.case(HERTZ), "-m",
                                  "hertz", "-o", directory, "--no-report", "-q")
        assert outcome.status == 1
        says(outcome.err, "File too large")
    assert (rollfem.work / "out/results.h5").read_bytes() == before and rollfem.made() == made
