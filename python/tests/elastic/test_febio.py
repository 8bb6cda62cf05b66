"""Files of FEBio 4.0, read back by ElementTree: nodes, elements, sets, surfaces and data."""

from xml.etree import ElementTree

import numpy as np
import pytest

import volume_fraction_mesh as vfm
from fields import BALL, PLATE, STATE

FRACTIONS = {"ball": BALL, "plate, lower": PLATE}
MESHES = {
    "hexes": vfm.hexes(FRACTIONS, state={"modulus": STATE["temperature"]}),
    "tets": vfm.tets(FRACTIONS, state={"modulus": STATE["temperature"]}),
    "curved": vfm.tets(FRACTIONS, element_order="quadratic"),
}
TYPES = {"hexes": ("hex8", "quad4"), "tets": ("tet4", "tri3"), "curved": ("tet10", "tri6")}


@pytest.fixture(params=MESHES)
def case(request, tmp_path):
    mesh = MESHES[request.param]
    path = tmp_path / "mesh.feb"
    mesh.save(path)
    return mesh, ElementTree.parse(path).getroot(), TYPES[request.param]


def numbers(text):
    return np.array([int(word) for word in text.split(",")])


def test_head_and_materials(case):
    mesh, root, _ = case
    assert root.tag == "febio_spec" and root.get("version") == "4.0"
    assert [part.tag for part in root] == ["Module", "Material", "Mesh", "MeshDomains", "MeshData"]
    materials = root.find("Material")
    assert [one.get("name") for one in materials] == ["ball", "plate__lower"]
    assert [one.get("id") for one in materials] == ["1", "2"]
    domains = [(one.get("name"), one.get("mat")) for one in root.find("MeshDomains")]
    parts = [one.get("name") for one in root.find("Mesh").findall("Elements")]
    assert domains == [(name, name) for name in parts] == [("ball",) * 2, ("plate__lower",) * 2]


def test_nodes_and_elements(case):
    mesh, root, (kind, _) = case
    nodes = root.find("Mesh").find("Nodes")
    assert [int(node.get("id")) for node in nodes] == list(range(1, len(nodes) + 1))
    points = np.array([[float(x) for x in node.text.split(",")] for node in nodes])
    assert sorted(map(tuple, points)) == sorted(map(tuple, mesh.points))
    found = {}
    for part in root.find("Mesh").findall("Elements"):
        assert part.get("type") == kind
        corners = {int(one.get("id")): numbers(one.text) for one in part}
        assert not found.keys() & corners.keys()
        found.update(corners)
        material = {"ball": 1, "plate__lower": 2}[part.get("name")]
        assert len(corners) == np.count_nonzero(mesh.material == material)
    assert sorted(found) == list(range(1, len(mesh) + 1))
    means = sorted(points[found[e] - 1][:mesh.cells.shape[1]].mean(axis=0).round(9).tolist()
                   for e in found)
    assert means == sorted(mesh.points[mesh.cells].mean(axis=1).round(9).tolist())


def test_sets_and_surfaces(case):
    mesh, root, (_, kind) = case
    sets = {one.get("name"): numbers(one.text) for one in root.find("Mesh").findall("NodeSet")}
    sides = {name: 0 if name[2:] == "min" else 12 for name in mesh.facet_sets()
             if name[1:] in ("_min", "_max")}
    assert len(sides) == 5 and set(sets) == set(sides)  # the bodies leave out a side
    for name, end in sides.items():
        on_side = mesh.points[:, "xyz".index(name[0])] == end
        assert np.array_equal(sets[name], np.flatnonzero(on_side) + 1)
    assert {one.get("name") for one in root.find("Mesh").findall("ElementSet")} == {"all_elements"}
    surfaces = {one.get("name"): one for one in root.find("Mesh").findall("Surface")}
    assert {"ball_to_plate__lower", "ball_skin"} <= surfaces.keys()
    points = {int(node.get("id")): [float(x) for x in node.text.split(",")]
              for node in root.find("Mesh").find("Nodes")}
    volume = 0.0
    for face in surfaces["ball_skin"]:
        assert face.tag == kind
        corners = np.array([points[n] for n in numbers(face.text)[:int(kind[-1]) // (
            2 if kind == "tri6" else 1)]])
        first = corners[0]
        for a, b in zip(corners[1:], corners[2:]):
            volume += np.dot(first, np.cross(a, b)) / 6
    ball = mesh.materials["MeshVolume"][0]
    assert abs(volume - ball) < 0.03 * ball  # normals point out; mid nodes are left out


def test_element_data(case):
    mesh, root, _ = case
    data = {one.get("name"): one for one in root.find("MeshData")}
    assert set(data) == ({"modulus"} if "modulus" in mesh.state else set())
    for one in data.values():
        assert one.get("elem_set") == "all_elements"
        values = [float(e.text) for e in one]
        assert [int(e.get("lid")) for e in one] == list(range(1, len(mesh) + 1))
        assert sorted(values) == sorted(mesh.state["modulus"])
