"""Tests MFEM (PyMFEM): .msh in both forms, and legacy .vtk."""

import numpy as np
import pytest

from ball_in_block import (NAMES, SIDES, check_maximum, check_side, check_volumes, recipe,
                           run_recipe, volume_of)

mfem = pytest.importorskip("mfem.ser")


def test_poisson(mesh, tmp_path):
    check_maximum(mesh, run_recipe("MFEM", mesh, tmp_path)["u"])


def test_poisson_of_vtk(mesh, tmp_path, monkeypatch):
    """Legacy .vtk has one boundary attribute, for the whole skin."""
    (language, code), = recipe("MFEM")
    code = code.replace("ball.msh", "ball.vtk").replace("[1] * 6 + [0] * (solid.bdr_attributes"
                                                        ".Max() - 6)", "[1]")
    names = {"mesh": mesh, "np": np}
    monkeypatch.chdir(tmp_path)
    exec(code, names)
    assert names["solid"].bdr_attributes.ToList() == [1]
    check_maximum(mesh, names["u"])


@pytest.mark.parametrize("binary", [False, True])
def test_materials_and_sides(mesh, tmp_path, binary):
    mesh.save(tmp_path / "ball.msh", binary=binary)
    solid = mfem.Mesh(str(tmp_path / "ball.msh"), 1, 1)
    attributes = np.array(solid.GetAttributeArray())
    points = np.array(solid.GetVertexArray())
    cells = np.array([solid.GetElementVertices(i) for i in range(solid.GetNE())])
    check_volumes(mesh, {i: volume_of(points, cells[attributes == i]) for i in NAMES})
    assert sorted(solid.attribute_sets.GetAttributeSetNames()) == sorted(NAMES.values())
    on_boundary = np.array(solid.GetBdrAttributeArray())
    for number, name in enumerate(SIDES, 1):
        assert solid.bdr_attribute_sets.GetAttributeSet(name).ToList() == [number]
        corners = [solid.GetBdrElementVertices(int(i)) for i in np.flatnonzero(
            on_boundary == number)]
        check_side(mesh, name, points[np.array(corners)])
