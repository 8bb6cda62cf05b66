"""Tests scikit-fem: the recipe, from arrays by Mesh.to_skfem."""

import numpy as np
import pytest

from ball_in_block import (HALF, NAMES, SIDES, area_of, check_maximum, check_volumes, run_recipe,
                           side_faces)

skfem = pytest.importorskip("skfem")


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
