"""Tests Akantu: .msh with materials by name."""

import numpy as np
import pytest

from ball_in_block import (SIDES, check_maximum, check_side, check_volumes, elastic_reference,
                           run_recipe)

aka = pytest.importorskip("akantu")
# Akantu names groups by number only: sides 1 and 2 are in the groups of materials 1 and 2.
GROUPS = dict(zip(SIDES, ("ball", "block") + SIDES[2:]))


def test_recipe(mesh, tmp_path):
    names = run_recipe("Akantu", mesh, tmp_path)
    check_maximum(mesh, names["u"], elastic_reference)
    solid, element, face = (names[name] for name in ("solid", "element", "face"))
    volumes = names["load"].sum(axis=1)
    found = {}
    for name in ("ball", "block"):
        elements = solid.getElementGroup(name).getElements()(element).ravel()
        found[name] = volumes[elements].sum()
    check_volumes(mesh, found)
    for side, name in GROUPS.items():
        faces = solid.getElementGroup(name).getElements()(face).ravel()
        check_side(mesh, side, solid.getNodes()[solid.getConnectivity(face)[faces]])


def test_faces_between_materials(mesh, tmp_path):
    """Cohesive elements need this group."""
    mesh.save(tmp_path / "ball.msh")
    solid = aka.Mesh(3)
    solid.read(str(tmp_path / "ball.msh"))
    face = aka._triangle_3 if mesh.kind == "tetra" else aka._quadrangle_4
    found = solid.getElementGroup("ball_to_block").getElements()(face)
    assert len(np.unique(found)) == len(mesh.facets("ball_to_block"))
