"""Tests Gmsh: groups and elements of all forms of .msh, solved by scikit-fem."""

import numpy as np
import pytest

from ball_in_block import (NAMES, SIDES, check_maximum, check_side, check_volumes, run_recipe,
                           solve, volume_of)

try:
    import gmsh
except (ImportError, OSError) as error:  # OSError: a system library of gmsh is missing
    pytest.skip("gmsh cannot be imported: %s" % error, allow_module_level=True)

FORMS = [{}, {"binary": True}, {"version": "4.1"}, {"version": "4.1", "binary": True}]


@pytest.mark.parametrize("form", FORMS, ids=["2.2", "2.2 binary", "4.1", "4.1 binary"])
def test_recipe(mesh, tmp_path, form, monkeypatch):
    save = type(mesh).save
    monkeypatch.setattr(type(mesh), "save", lambda self, path: save(self, path, **form))
    names = run_recipe("Gmsh", mesh, tmp_path)
    points, nodes = names["points"], names["nodes"]
    check_volumes(mesh, {name: volume_of(points, nodes[name]) for name in NAMES.values()})
    for name in SIDES:
        check_side(mesh, name, points[nodes[name]])
    material = np.repeat(list(NAMES), [len(nodes[name]) for name in NAMES.values()])
    check_maximum(mesh, solve(
        points, np.concatenate([nodes[name] for name in NAMES.values()]), material,
        np.unique(np.concatenate([nodes[name].ravel() for name in SIDES]))))
