"""Tests scikit-fem: the recipe, from arrays by Mesh.to_skfem."""

import numpy as np
import pytest

from ball_in_block import (HALF, NAMES, SIDES, area_of, check_maximum, check_volumes, run_recipe,
                           side_faces)

skfem = pytest.importorskip("skfem")

import flat_cases as flat  # noqa: E402


def test_poisson(mesh, tmp_path):
    check_maximum(mesh, run_recipe("scikit-fem", mesh, tmp_path)["u"])


def test_materials_and_sides(mesh):
    made = mesh.to_skfem()
    volumes = skfem.Basis(made, made.elem(), intorder=4).dx.sum(axis=1)
    check_volumes(mesh, {name: volumes[made.subdomains[name]].sum() for name in NAMES.values()})
    for name in SIDES:
        side = skfem.FacetBasis(made, made.elem(), facets=name)
        place = HALF["xyz".index(name[0])] * (1 if name.endswith("max") else -1)
        assert np.allclose(side.global_coordinates()["xyz".index(name[0])], place, rtol=0,
                           atol=1e-12)
        assert len(side.find) == side_faces(mesh, name)
        assert np.isclose(side.dx.sum(), area_of(name), rtol=1e-12)


def error_of(mesh, boundaries, load, exact):
    """Returns the error of u in L2, with -div(grad u) = load and u = 0 on the boundaries."""
    from skfem.models.poisson import laplace

    made = mesh.to_skfem()
    element = skfem.ElementQuad1() if mesh.kind == "quad" else skfem.ElementTriP1()
    basis = skfem.Basis(made, element, intorder=4)
    right = skfem.LinearForm(lambda v, w: load(w.x) * v).assemble(basis)
    held = basis.get_dofs(set(boundaries))
    u = skfem.solve(*skfem.condense(laplace.assemble(basis), right, D=held))
    square = skfem.Functional(lambda w: (w.u - exact(w.x)) ** 2)
    return np.sqrt(square.assemble(basis, u=basis.interpolate(u)))


@pytest.mark.parametrize("kind", ["hexes", "tets"])
@pytest.mark.parametrize("name", ["square", "disc"])
def test_order_in_a_plane(kind, name):
    """The error in L2 falls by the square of the cell width, also where the boundary is round.
    Round boundaries of triangles are less smooth, so that the order there is lower."""
    case = {"square": (flat.make_square, flat.SIDES, lambda x: 2 * np.pi ** 2 * flat.wave(x),
                       flat.wave),
            "disc": (flat.make_disc, ["disc_to_Void"], lambda x: 1 + 0 * x[0], flat.bump)}[name]
    errors = [error_of(case[0](kind, cells), *case[1:]) for cells in (16, 32, 64)]
    found = flat.orders(errors)
    print("%s, %s: errors %s, orders %s" % (
        name, kind, " ".join("%.3g" % error for error in errors),
        " ".join("%.2f" % order for order in found)))
    least = 1.4 if (name, kind) == ("disc", "tets") else 1.75
    assert (least < found).all() and (found < 2.3).all(), found


@pytest.mark.parametrize("kind", ["hexes", "tets"])
def test_materials_and_sides_of_a_plane(kind):
    mesh = flat.make_square(kind, 16)
    made = mesh.to_skfem()
    areas = skfem.Basis(made, made.elem(), intorder=2).dx.sum(axis=1)
    disc = flat.disc_fractions(16).mean()
    for name, expected in zip(flat.NAMES, (disc, 1 - disc)):
        assert np.isclose(areas[made.subdomains[name]].sum(), expected, rtol=1e-6)
    for name in flat.SIDES:
        side = skfem.FacetBasis(made, made.elem(), facets=name)
        place = 1.0 if name.endswith("max") else 0.0
        assert np.allclose(side.global_coordinates()["xy".index(name[0])], place, atol=1e-12)
        assert np.isclose(side.dx.sum(), 1.0, rtol=1e-12)
    between = skfem.FacetBasis(made, made.elem(), facets="disc_to_square")
    assert np.isclose(between.dx.sum(), 2 * np.pi * flat.RADIUS, rtol=0.03)
