"""Tests Gmsh: groups and elements of all forms of .msh, solved by scikit-fem."""

import numpy as np
import pytest
import volume_fraction_mesh as vfm

from ball_in_block import (HALF, NAMES, SHAPES, SIDES, check_maximum, check_side, check_volumes,
                           run_recipe, solve, volume_of)

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


@pytest.mark.parametrize("form", FORMS, ids=["2.2", "2.2 binary", "4.1", "4.1 binary"])
@pytest.mark.parametrize("make, order, kind, face", [
    (vfm.hexes, "quadratic", 17, 16), (vfm.hexes, "quadratic27", 12, 10),
    (vfm.tets, "quadratic", 11, 9)])
def test_second_order(tmp_path, form, make, order, kind, face):
    """Gmsh's own bound of the Jacobian is positive, and its volumes are those of the fractions."""
    mesh = make(vfm.shapes(SHAPES, (10, 12, 8), bounds=np.stack([-HALF, HALF], axis=1).ravel()),
                element_order=order)
    mesh.save(tmp_path / "curved.msh", **form)
    gmsh.initialize(interruptible=False)
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.open(str(tmp_path / "curved.msh"))
        assert list(gmsh.model.mesh.getElements(2)[0]) == [face]
        types, (tags, ), _ = gmsh.model.mesh.getElements(3)
        assert list(types) == [kind] and len(tags) == len(mesh)
        assert min(gmsh.model.mesh.getElementQualities(tags, "minDetJac")) > 0
        volume = sum(gmsh.model.mesh.getElementQualities(tags, "volume"))
        assert abs(volume / sum(mesh.materials["TargetVolume"]) - 1) < 1e-6
    finally:
        gmsh.finalize()
