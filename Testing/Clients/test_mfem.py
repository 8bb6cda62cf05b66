"""Tests MFEM (PyMFEM): .msh in both forms, and legacy .vtk."""

import os

import numpy as np
import pytest
import scipy.sparse
import volume_fraction_mesh as vfm

from ball_in_block import (BLOCK, NAMES, PAGE, SIDES, check_maximum, check_side, check_volumes,
                           recipe, run_recipe, volume_of)

mfem = pytest.importorskip("mfem.ser")


PERIODIC = os.path.join(os.path.dirname(PAGE), "periodic.md")


def make_periodic(kind):
    """Returns the mesh of a ball across the sides, in a cell of length 1."""
    fractions = vfm.shapes("sphere radius=0.35 center=0.5,0.5,0.5", 3 * [8],
                           bounds=(0, 1, 0, 1, 0, 1))
    ball = np.roll(next(iter(fractions.values())), (4, 3, 2), (0, 1, 2))
    return getattr(vfm, kind)({"ball": ball, "block": 1 - ball}, periodic="xyz", spacing=1 / 8)


def range_on_torus(mesh, conductivity, source):
    """Returns the range of the solution by scikit-fem, with points replaced by their partners.

    conductivity, source: by element.
    """
    import skfem
    from skfem.helpers import dot, grad

    solid = mesh.to_skfem()
    basis = skfem.Basis(solid, solid.elem(), intorder=3)
    values = [v[:, None] + np.zeros(basis.dx.shape) for v in (conductivity, source)]
    stiffness = skfem.BilinearForm(lambda u, v, w: w.k * dot(grad(u), grad(v))).assemble(
        basis, k=values[0])
    load = skfem.LinearForm(lambda v, w: w.f * v).assemble(basis, f=values[1])
    partners, families = np.unique(mesh.partner, return_inverse=True)
    join = scipy.sparse.csr_matrix((np.ones(len(families)), (np.arange(len(families)), families)))
    u = skfem.solve(*skfem.condense(join.T @ stiffness @ join, join.T @ load, D=np.array([0])))
    return np.ptp(u)


@pytest.mark.parametrize("kind", ["hexes", "tets"])
def test_periodic(kind, tmp_path, monkeypatch):
    """The heat equation on a torus, with a source in the ball and a sink around it."""
    mesh = make_periodic(kind)
    names = {"mesh": mesh, "np": np}
    monkeypatch.chdir(tmp_path)
    with open(PERIODIC, encoding="utf-8") as file:
        (language, code), = BLOCK.findall(file.read())
    exec(code, names)
    cell = names["cell"]
    volumes = [mesh.volumes()[mesh.material == m].sum() for m in (1, 2)]
    space = mfem.FiniteElementSpace(cell, mfem.H1_FECollection(1, 3))
    assert space.GetTrueVSize() == len(np.unique(mesh.partner))
    a, b, x = mfem.BilinearForm(space), mfem.LinearForm(space), mfem.GridFunction(space)
    k = mfem.PWConstCoefficient(mfem.Vector([10.0, 1.0]))
    f = mfem.PWConstCoefficient(mfem.Vector([1.0, -volumes[0] / volumes[1]]))
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
    inside = mesh.material == 1
    expected = range_on_torus(mesh, np.where(inside, 10.0, 1.0),
                              np.where(inside, 1.0, -volumes[0] / volumes[1]))
    assert abs(np.ptp(x.GetDataArray()) / expected - 1) < 1e-6


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
