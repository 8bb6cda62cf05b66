"""Tests files of XDMF: their XML, and names and tags by meshio."""

import json
from xml.etree import ElementTree

import numpy as np
import pytest

import volume_fraction_mesh as vfm
from fields import BALL, GRAINS, PLATE

MESHES = {
    "hexes": vfm.hexes({"ball": BALL, "plate": PLATE}),
    "tets": vfm.tets({"ball": BALL, "plate": PLATE}),
    "with void": vfm.hexes({"ball": BALL, "plate": PLATE}, mesh_void=True),
    "grains": vfm.hexes(labels=GRAINS, names={1: "first <grain>", 2: "\u00e9t\u00e9 \"2\""}),
    "edges": vfm.hexes(vfm.shapes("box size=1.1,1,0.9", 12, bounds=[-1, 1] * 3),
                       sharp_edges="on"),
}


@pytest.fixture(params=MESHES)
def mesh(request):
    return MESHES[request.param]


@pytest.fixture
def folder(mesh, tmp_path):
    mesh.save(tmp_path / "mesh.xdmf")
    assert {file.name for file in tmp_path.iterdir()} == {"mesh.xdmf", "mesh_facets.xdmf"}
    return tmp_path


def read(path):
    """Returns corners, points, tags and the numbers of names."""
    grid, = ElementTree.parse(path).getroot().iter("Grid")
    corners, points, tags = (np.array(item.text.split(), float).reshape(
        [int(size) for size in item.get("Dimensions").split()]) for item in grid.iter("DataItem"))
    return corners, points, tags, json.loads(grid.find("Information").get("Value"))


def plain(name):
    return name.replace('"', "_")


def test_elements(mesh, folder):
    corners, points, tags, names = read(folder / "mesh.xdmf")
    assert np.array_equal(points, mesh.points)
    assert np.array_equal(corners, mesh.cells)
    assert np.array_equal(tags, mesh.material)
    assert names == dict(zip(map(plain, mesh.materials["Name"]), mesh.materials["MaterialId"]))


def test_facets(mesh, folder):
    corners, points, tags, names = read(folder / "mesh_facets.xdmf")
    assert np.array_equal(points, mesh.points)
    keys = np.sort(corners, axis=1)
    assert len(np.unique(keys, axis=0)) == len(keys)
    assert set(names.values()) == set(tags)
    sets = {plain(name): facets for name, facets in mesh.facet_sets().items()}
    if mesh is MESHES["edges"]:  # smooth sides, the finest surfaces, replace their interface
        assert "Material1_to_Void" in sets and "Material1_to_Void" not in names
        assert sum(len(sets[name]) for name in names if "_to_Void_" in name) == len(
            sets["Material1_to_Void"])
    for name, number in names.items():
        found = corners[tags == number]
        assert np.array_equal(found, sets[name].points), name


def test_meshio(mesh, folder):
    meshio = pytest.importorskip("meshio")
    for name, kind, wanted in (("mesh.xdmf", mesh.kind, mesh.material),
                               ("mesh_facets.xdmf", None, None)):
        again = meshio.read(folder / name)
        corners, points, tags, names = read(folder / name)
        block, = again.cells
        assert block.type == (kind or {"tetra": "triangle", "hexahedron": "quad"}[mesh.kind])
        assert np.array_equal(block.data, corners) and np.array_equal(again.points, points)
        (found,), = again.cell_data.values()
        assert np.array_equal(found, tags)
        dimension = 3 if kind else 2
        assert {key: value.tolist() for key, value in again.field_data.items()} == {
            key: [number, dimension] for key, number in names.items()}


def test_options(mesh, tmp_path):
    with pytest.raises(TypeError, match="time is not an option of .xdmf"):
        mesh.save(tmp_path / "mesh.xdmf", time=1.0)
