"""Tests MFEM (PyMFEM): .msh in both forms, and legacy .vtk."""

import numpy as np
import pytest

from ball_in_block import (NAMES, SIDES, check_maximum, check_side, check_volumes, recipe,
                           run_recipe, volume_of)
from periodic_ball import check_range, make_cell, run_cell_recipe, sources

mfem = pytest.importorskip("mfem.ser")


@pytest.mark.parametrize("kind", ["hexes", "tets"])
def test_periodic(kind, tmp_path, monkeypatch):
    """The heat equation on a torus, with a source in the ball and a sink around it."""
    mesh = make_cell(kind)
    names = {"mesh": mesh, "np": np}
    monkeypatch.chdir(tmp_path)
    run_cell_recipe("mfem", names)
    cell = names["cell"]
    space = mfem.FiniteElementSpace(cell, mfem.H1_FECollection(1, 3))
    assert space.GetTrueVSize() == len(np.unique(mesh.partner))
    a, b, x = mfem.BilinearForm(space), mfem.LinearForm(space), mfem.GridFunction(space)
    k = mfem.PWConstCoefficient(mfem.Vector([10.0, 1.0]))
    f = mfem.PWConstCoefficient(mfem.Vector(list(sources(mesh))))
    integrators = [mfem.DiffusionIntegrator(k), mfem.DomainLFIntegrator(f)]
    for integrator in integrators:
        integrator.SetIntRule(mfem.IntRules.Get(cell.GetElementGeometry(0), 3))
    a.AddDomainIntegrator(integrators[0])
    b.AddDomainIntegrator(integrators[1])
    a.Assemble()
    b.Assemble()
    x.Assign(0.0)
    A, B, X = mfem.OperatorPtr(), mfem.Vector(), mfem.Vector()
    a.FormLinearSystem(mfem.intArray([0]), x, b, A, X, B)
    matrix = mfem.OperatorHandle2SparseMatrix(A)
    mfem.PCG(matrix, mfem.GSSmoother(matrix), B, X, 0, 2000, 1e-26, 0.0)
    a.RecoverFEMSolution(X, b, x)
    check_range(mesh, x.GetDataArray())


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
