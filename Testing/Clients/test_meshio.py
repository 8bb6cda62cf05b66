"""Tests meshio: each format that it reads, solved by scikit-fem."""

import numpy as np
import pytest

from ball_in_block import (NAMES, SIDES, check_maximum, check_side, check_volumes, fixed_points,
                           run_recipe, solve, volume_of)

meshio = pytest.importorskip("meshio")


def test_recipe(mesh, tmp_path):
    names = run_recipe("meshio", mesh, tmp_path)
    points, cells, faces = names["read"].points, names["cells"].data, names["faces"].data
    material, side = np.array(names["material"]), np.array(names["side"])
    check_volumes(mesh, {name: volume_of(points, cells[material == name])
                         for name in NAMES.values()})
    for name in SIDES:
        check_side(mesh, name, points[faces[side == name]])
    check_maximum(mesh, solve(points, cells, np.where(material == "ball", 1, 2),
                              np.unique(faces[np.isin(side, SIDES)])))


def gather(read, kind):
    """Returns the elements of this kind, and the block that each is in."""
    blocks = [at for at, block in enumerate(read.cells) if block.type == kind]
    return (np.concatenate([read.cells[at].data for at in blocks]),
            blocks, np.repeat(blocks, [len(read.cells[at].data) for at in blocks]))


@pytest.mark.parametrize("file, choices, key", [
    ("ball.vtu", {"texts": False}, "MaterialId"),
    ("ball.vtk", {}, "material"),
    ("ball.vtk", {"binary": True}, "MaterialId"),
    ("ball.xdmf", {}, "MaterialId"),
    ("ball.med", {}, "MaterialId"),
    ("ball.mesh", {}, "medit:ref"),
    ("ball.avs", {}, "avsucd:material"),
    ("ball.e", {}, "MaterialId"),
    ("ball.msh", {"version": "4.1"}, "gmsh:physical"),
    ("ball.msh", {"version": "4.1", "binary": True}, "gmsh:physical"),
])
def test_materials_of_arrays(mesh, tmp_path, file, choices, key):
    if file.endswith((".xdmf", ".med")):
        pytest.importorskip("h5py")
    mesh.save(tmp_path / file, **choices)
    read = meshio.read(tmp_path / file)
    cells, blocks, _ = gather(read, mesh.kind)
    material = np.concatenate([np.ravel(read.cell_data[key][at]) for at in blocks])
    check_volumes(mesh, {i: volume_of(read.points, cells[material == i]) for i in NAMES})
    check_maximum(mesh, solve(read.points, cells, material, fixed_points(read.points)))


@pytest.mark.parametrize("file", ["ball.inp", "ball.e"])
def test_point_sets(mesh, tmp_path, file):
    mesh.save(tmp_path / file)
    read = meshio.read(tmp_path / file)
    sets = {name.lower(): np.asarray(points) for name, points in read.point_sets.items()}
    for name in SIDES:
        assert len(sets[name]) == len(np.unique(mesh.facets(name).points))
        expected = mesh.points[np.unique(mesh.facets(name).points)]
        assert np.allclose(np.sort(read.points[sets[name]], axis=0), np.sort(expected, axis=0),
                           rtol=0, atol=1e-12)
    fixed = np.unique(np.concatenate([sets[name] for name in SIDES]))
    cells, _, block = gather(read, mesh.kind)
    check_maximum(mesh, solve(read.points, cells, block + 1, fixed))


def test_cell_sets_of_inp(mesh, tmp_path):
    mesh.save(tmp_path / "ball.inp")
    read = meshio.read(tmp_path / "ball.inp")
    found = {}
    for name in ("BALL", "BLOCK"):
        cells = np.concatenate([block.data[np.asarray(chosen, dtype=int)] for block, chosen in zip(
            read.cells, read.cell_sets[name]) if chosen is not None and len(chosen)])
        found[name] = volume_of(read.points, cells)
    check_volumes(mesh, found)
