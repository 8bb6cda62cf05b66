"""Tests fedoo: arrays."""

import numpy as np
import pytest

from ball_in_block import SIDES, check_maximum, check_volumes, run_recipe, volume_of

pytest.importorskip("fedoo")


def test_recipe(mesh, tmp_path):
    names = run_recipe("fedoo", mesh, tmp_path)
    check_maximum(mesh, names["u"])
    solid = names["solid"]
    for name in SIDES:
        assert np.array_equal(np.sort(solid.node_sets[name]),
                              np.unique(mesh.facets(name).points))
    check_volumes(mesh, {name: volume_of(solid.nodes, solid.elements[solid.element_sets[name]])
                         for name in ("ball", "block")})
