"""Tests meshlane, the successor of meshio: elements and materials of each format that it reads."""

import numpy as np
import pytest

from ball_in_block import NAMES, check_volumes, volume_of

meshlane = pytest.importorskip("meshlane")


@pytest.mark.parametrize("file, choices, key", [
    ("ball.vtu", {"texts": False}, "MaterialId"),
    ("ball.vtk", {}, "material"),
    ("ball.xdmf", {}, "MaterialId"),
    ("ball.e", {}, "MaterialId"),
    ("ball.msh", {}, "gmsh:physical"),
    ("ball.msh", {"version": "4.1", "binary": True}, "gmsh:physical"),
])
def test_materials(mesh, tmp_path, file, choices, key):
    if file.endswith(".xdmf"):
        pytest.importorskip("h5py")
    mesh.save(tmp_path / file, **choices)
    read = meshlane.read(tmp_path / file)
    blocks = [at for at, block in enumerate(read.cells) if block.type == mesh.kind]
    cells = np.concatenate([read.cells[at].data for at in blocks])
    material = np.concatenate([np.ravel(read.cell_data[key][at]) for at in blocks])
    check_volumes(mesh, {i: volume_of(read.points, cells[material == i]) for i in NAMES})


def test_sets_of_inp(mesh, tmp_path):
    mesh.save(tmp_path / "ball.inp")
    read = meshlane.read(tmp_path / "ball.inp")
    found = {}
    for name in ("BALL", "BLOCK"):
        cells = np.concatenate([block.data[np.asarray(chosen, dtype=int)] for block, chosen in zip(
            read.cells, read.cell_sets[name]) if chosen is not None and len(chosen)])
        found[name] = volume_of(read.points, cells)
    check_volumes(mesh, found)
    assert len(read.point_sets["X_MIN"]) == len(np.unique(mesh.facets("x_min").points))
