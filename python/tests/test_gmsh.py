"""Tests files of Gmsh: Gmsh itself reads names, groups, volumes and closed surfaces."""

from contextlib import contextmanager

import numpy as np
import pytest

import volume_fraction_mesh as vfm
from fields import BALL, GRAINS, PLATE

try:
    import gmsh
except (ImportError, OSError) as error:  # OSError: a system library of gmsh is missing
    pytest.skip("gmsh cannot be imported: %s" % error, allow_module_level=True)

FORMS = [{}, {"binary": True}, {"version": "4.1"}, {"version": "4.1", "binary": True}]
MESHES = {
    "hexes": vfm.hexes({"ball": BALL, "plate": PLATE}),
    "tets": vfm.tets({"ball": BALL, "plate": PLATE}),
    "with void": vfm.hexes({"ball": BALL, "plate": PLATE}, mesh_void=True),
    "grains": vfm.hexes(labels=GRAINS, names={1: "first grain", 2: "\u00e9t\u00e9 \"2\""}),
    "edges": vfm.hexes(vfm.shapes("box size=1.1,1,0.9", 12, bounds=[-1, 1] * 3),
                       sharp_edges="on"),
}
SIDES = ["x_min", "x_max", "y_min", "y_max", "z_min", "z_max"]


@pytest.fixture(params=FORMS, ids=["2.2", "2.2 binary", "4.1", "4.1 binary"])
def form(request):
    return request.param


@pytest.fixture(params=MESHES)
def mesh(request):
    return MESHES[request.param]


@contextmanager
def open_file(path):
    """Opens a file in Gmsh and gives {(dimension, name): (tag, entities)}."""
    gmsh.initialize(interruptible=False)
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.logger.start()
        gmsh.open(str(path))
        bad = [line for line in gmsh.logger.get() if line.startswith(("Warning", "Error"))]
        gmsh.logger.stop()
        assert not bad, bad
        yield {
            (dimension, gmsh.model.getPhysicalName(dimension, tag)):
                (tag, gmsh.model.getEntitiesForPhysicalGroup(dimension, tag).tolist())
            for dimension, tag in gmsh.model.getPhysicalGroups()
        }
    finally:
        gmsh.finalize()


@pytest.fixture
def opened(mesh, form, tmp_path):
    mesh.save(tmp_path / "mesh.msh", **form)
    with open_file(tmp_path / "mesh.msh") as groups:
        yield groups


def read_elements(dimension, entities):
    """Returns the ids and nodes of the elements of entities."""
    ids, nodes = [], []
    for entity in entities:
        for kind, own, corners in zip(*gmsh.model.mesh.getElements(dimension, entity)):
            assert kind in (2, 3, 4, 5, 6)
            ids.append(own)
            nodes.append(corners.reshape(len(own), -1))
    return np.concatenate(ids).astype(int), np.concatenate(nodes).astype(int)


def read_points():
    """Returns the ids and coordinates of all nodes, by id."""
    ids, points, _ = gmsh.model.mesh.getNodes()
    order = np.argsort(ids)
    return ids[order].astype(int), points.reshape(-1, 3)[order]


def plain(name):
    return name.replace('"', "_")


def volume_inside(corners):
    """Returns the volume inside faces, shape (faces, corners, 3). A quad is halved both ways."""
    if corners.shape[1] == 3:
        return np.linalg.det(corners).sum() / 6
    halves = np.concatenate([np.roll(corners, turn, axis=1)[:, :3] for turn in range(4)])
    return np.linalg.det(halves).sum() / 12


def test_elements_and_ids(mesh, form, opened):
    """Nodes and elements have the ids, and elements the material, of the mesh."""
    ids, points = read_points()
    assert np.array_equal(ids, mesh.point_ids) and np.array_equal(points, mesh.points)
    materials = dict(zip(mesh.materials["MaterialId"], mesh.materials["Name"]))
    assert {name for dimension, name in opened if dimension == 3} == set(map(
        plain, materials.values()))
    for material, name in materials.items():
        tag, entities = opened[3, plain(name)]
        assert tag == material or material == 0 and tag == max(materials) + 1
        numbers, corners = read_elements(3, entities)
        chosen = mesh.material == material
        order = np.argsort(numbers)
        assert np.array_equal(numbers[order], mesh.cell_ids[chosen])
        assert np.array_equal(corners[order], mesh.point_ids[mesh.cells[chosen]])


def test_volumes(mesh, form, opened):
    """The volume of each material, by Gmsh, is the volume of the mesh."""
    for name, expected in zip(mesh.materials["Name"], mesh.materials["MeshVolume"]):
        ids, _ = read_elements(3, opened[3, plain(name)][1])
        volumes = gmsh.model.mesh.getElementQualities(ids, "volume")
        assert np.isclose(volumes.sum(), expected, rtol=1e-10 if mesh.kind == "tetra" else 1e-3)


def expected_faces(mesh):
    """Returns {name: number of faces} of domain sides and interfaces."""
    names = dict(zip(mesh.materials["MaterialId"], mesh.materials["Name"]))
    names.setdefault(0, "Void")
    faces = {}
    surfaces = mesh.surfaces
    for (a, b), side in zip(surfaces.material_pair.tolist(), surfaces.domain_side.tolist()):
        first, second = (b, a) if a == 0 else (a, b)
        name = SIDES[side] if side >= 0 else plain("%s_to_%s" % (names[first], names[second]))
        faces[name] = faces.get(name, 0) + 1
    return faces


def test_groups_of_faces(mesh, form, opened):
    """Domain sides and interfaces have each face of the geometry once."""
    found = {name: len(read_elements(2, entities)[0])
             for (dimension, name), (_, entities) in opened.items() if dimension == 2}
    expected = expected_faces(mesh)
    if mesh is MESHES["edges"]:
        sides = [name for name in found if name.startswith("Material1_to_Void_")]
        assert len(sides) == 6
        assert sum(found[name] for name in sides) == expected["Material1_to_Void"]
        if form.get("version") != "4.1":
            assert set(found) == set(sides)
            return
    assert {name: found[name] for name in expected} == expected
    ids, _ = read_elements(2, [tag for _, tag in gmsh.model.getEntities(2)])
    assert len(set(ids.tolist())) == len(ids) == sum(expected.values())
    assert not set(ids.tolist()) & set(mesh.cell_ids.tolist())


def test_entities(mesh, form, opened):
    """The entities are fragments and surfaces, in version 4.1 also curves and vertices."""
    counts = [len(gmsh.model.getEntities(dimension)) for dimension in range(4)]
    assert counts[3] == mesh.fragment.max()
    assert counts[2] == len(mesh.surfaces.fields["SurfaceSides"])
    if form.get("version") == "4.1":
        assert counts[:2] == [len(mesh.vertices.points), len(mesh.curves.fields["CurveEnds"])]
        for surface in range(1, counts[2] + 1):
            faces, _ = read_elements(2, [surface])
            assert len(faces) == (mesh.surfaces.surface_id == surface).sum()


def test_skins_are_closed(mesh, form, opened):
    """In version 4.1, skins and interfaces are groups. Skins are closed."""
    if form.get("version") != "4.1":
        pytest.skip("version 2.2 has one group per face")
    ids, points = read_points()
    for material, name in zip(mesh.materials["MaterialId"], mesh.materials["Name"]):
        _, faces = read_elements(2, opened[2, plain(name) + "_skin"][1])
        _, elements = read_elements(3, opened[3, plain(name)][1])
        edges = np.sort(np.stack([faces, np.roll(faces, -1, axis=1)], axis=-1).reshape(-1, 2))
        _, times = np.unique(edges, axis=0, return_counts=True)
        assert (times % 2 == 0).all()
        assert np.isin(faces, elements).all()
    inner = sum(count for name, count in expected_faces(mesh).items()
                if "_to_" in name and (not name.endswith("_to_Void") or 0 in mesh.material))
    if inner:
        assert len(read_elements(2, opened[2, "interfaces"][1])[0]) == inner


def test_normals(mesh, form, opened):
    """Faces point away from the material with the lowest id, which owns all its faces."""
    ids, points = read_points()
    own = (mesh.surfaces.fields["SurfaceMaterials"] == 1).any(axis=1)
    _, faces = read_elements(2, np.flatnonzero(own) + 1)
    volume = dict(zip(mesh.materials["MaterialId"], mesh.materials["MeshVolume"]))[1]
    assert np.isclose(volume_inside(points[np.searchsorted(ids, faces)]), volume)


def test_choices(tmp_path):
    mesh = MESHES["hexes"]
    with pytest.raises(ValueError, match="'3': it must be 2.2 or 4.1"):
        mesh.save(tmp_path / "mesh.msh", version="3")
    with pytest.raises(TypeError, match="time"):
        mesh.save(tmp_path / "mesh.msh", time=1.0)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("make", [vfm.hexes, vfm.tets])
def test_cohesive_elements(make, form, tmp_path):
    """Each block of cohesive elements is a group of volumes with their ids and nodes."""
    mesh = make(labels=GRAINS, split_interfaces="all", split_connection="cohesive")
    mesh.save(tmp_path / "mesh.msh", **form)
    with open_file(tmp_path / "mesh.msh") as groups:
        ids, points = read_points()
        assert np.array_equal(ids, mesh.point_ids) and np.array_equal(points, mesh.points)
        blocks = mesh.cohesive()
        assert len(blocks) >= 3
        for name, block in blocks.items():
            tag, entities = groups[3, name]
            numbers, corners = read_elements(3, entities)
            assert tag == block.block and np.array_equal(numbers, block.ids)
            assert np.array_equal(corners, mesh.point_ids[block.cells])
        for material, name in zip(mesh.materials["MaterialId"], mesh.materials["Name"]):
            _, entities = groups[3, name]
            numbers, _ = read_elements(3, entities)
            assert np.array_equal(np.sort(numbers), mesh.cell_ids[mesh.material == material])
        if "version" in form:  # in 2.2, a face is only in the finest of its groups
            _, faces = read_elements(2, groups[2, "interfaces"][1])
            assert len(faces) == sum(map(len, blocks.values()))
