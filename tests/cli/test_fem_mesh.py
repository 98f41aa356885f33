# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command `mesh`: its files, their use in a case, and its refusals."""

import pytest
from program import SMALL, says

COARSE = SMALL | {"fem.cell_size": 1.88}


def with_mesh(file, keys=SMALL):
    return keys | {"wheel.mesh": file}


def row(table, name):
    """The number after a row's name, of the wheel."""
    assert name in table, table
    return float(table[table.index(name) + 34:].split()[0])


@pytest.mark.parametrize("family", ["structured", "gmsh"])
def test_writes_meshes_that_a_case_takes_again(rollfem, family):
    first = rollfem.done("mesh", rollfem.case(COARSE | {"fem.mesh": family}), "-o", "made").out
    for name in "wheel.msh", "rail.msh", "wheel.vtu", "rail.vtu":
        assert rollfem.holds(f"made/{name}")
    says(rollfem.text("made/wheel.vtu"), "UnstructuredGrid")
    assert row(first, "unknowns") > 5000 and row(first, "smallest scaled Jacobian (1: box)") > 0.3
    assert row(first, "size of cells in the patch, mm") <= 1.8801 and row(first, "times halved at the patch") <= 7
    # The files are the coarse mesh: refined again they give the same cells.
    second = rollfem.done("mesh", rollfem.case(with_mesh("work/made/wheel.msh", COARSE)), "-o", "again").out
    for name in "coarse cells", "cells", "unknowns", "shortest edge, mm":
        assert row(second, "\n" + name) == row(first, "\n" + name)
    assert len(rollfem.text("made/wheel.msh")) == len(rollfem.text("again/wheel.msh"))


@pytest.mark.parametrize("words, mesh, said", [
    ("mesh CASE", None, 'wheel.mesh = "a.msh": there is no such mesh file'),
    ("check CASE", None, "there is no such mesh file"),
    ("mesh CASE", "Point(1) = {0, 0, 0};\n", "is not a gmsh mesh"),
    ("run CASE --model fem", "$MeshFormat\n", "line 2: is not a gmsh mesh"),
    ("mesh", None, "case is required")])
def test_bad_meshes_are_refused_and_nothing_is_written(rollfem, words, mesh, said):
    if mesh is not None:
        rollfem.file("a.msh", mesh)
    rollfem.refuses(*words.replace("CASE", rollfem.case(with_mesh("a.msh"))).split(), says=said)
    assert rollfem.made() == []


def test_a_folder_that_cannot_be_made_is_refused(rollfem):
    rollfem.refuses("mesh", rollfem.case(COARSE), "-o", "/proc/nowhere", says="cannot create the folder")


def test_runs_no_script_of_the_users_folders(rollfem):
    rollfem.done("mesh", rollfem.case(COARSE | {"fem.mesh": "gmsh"}), "-o", "made")
    # gmsh would run the first beside the mesh, and the others at its start.
    for name in ("work/made/wheel.msh.opt", "work/made/rail.msh.opt", "work/.gmshrc", "work/.gmsh-options",
                 "work/gmsh-options", "home/.gmshrc", "home/.gmsh-options", "home/.gmshrc.opt"):
        rollfem.file(name, f'SystemCall "touch {rollfem.path}/ran";\n')
    rollfem.file("work/.petscrc", "-help\n")  # PETSc would print its options, or start a debugger
    own = rollfem.case(with_mesh("work/made/wheel.msh", COARSE | {"fem.mesh": "gmsh"}))
    outcome = rollfem.done("mesh", own, "-o", "again", HOME=f"{rollfem.path}/home")
    assert not (rollfem.path / "ran").exists() and "petsc" not in outcome.out and outcome.err == ""


def test_spares_the_mesh_that_the_case_names(rollfem):
    rollfem.file("wheel.msh", "$MeshFormat\n")
    rollfem.refuses("mesh", rollfem.case(with_mesh("wheel.msh")), "-o", "..", says="would be overwritten")
    assert (rollfem.path / "wheel.msh").read_text() == "$MeshFormat\n"
