"""Reads .feb files by the packages pyfebio and febio-python: nodes, elements, sets and materials."""

from dataclasses import replace

import numpy as np
import pytest

POISSON = 0.25


@pytest.fixture(params=["plain", "bins"])
def made(request, mesh, tmp_path):
    """Returns a mesh and the path of its file; with bins each material has several parts."""
    if request.param == "bins":
        grey = 2.0 + mesh.points[mesh.cells].mean(axis=1) @ [0.5, 0.25, 0.125]
        mesh = replace(mesh, state={"grey": grey}).bin_materials("grey", 5, a=3.0, b=2.0,
                                                                 poisson=POISSON)
    path = tmp_path / "ball.feb"
    mesh.save(path)
    return mesh, path


def expected_parts(mesh):
    """Returns {name: (elements, modulus, Poisson's ratio)}."""
    fields = mesh.fields
    if "BinIds" not in fields:
        return {name: (np.flatnonzero(mesh.material == number), 1.0, 0.3)
                for number, name in zip(mesh.materials["MaterialId"], mesh.materials["Name"])}
    return {name: (np.flatnonzero(mesh.state["BinId"] == number), modulus, POISSON)
            for number, name, modulus in zip(fields["BinIds"], fields["BinNames"],
                                             fields["BinModulus"])}


def expected_sides(mesh):
    """Returns the sets of faces that the file has: one of both orientations of an interface."""
    return {name: facets for name, facets in mesh.facet_sets().items()
            if name != "block_to_ball"}


def numbers(text):
    return [int(word) for word in text.split(",")]


def test_pyfebio(made):
    """The model of the package accepts the file: it refuses what it does not know."""
    model = pytest.importorskip("pyfebio.model")
    mesh, path = made
    found = model.Model.from_xml(path.read_bytes())
    nodes = found.mesh_.nodes[0].all_nodes
    assert [node.id for node in nodes] == list(range(1, len(mesh.points) + 1))
    points = np.array([[float(x) for x in node.text.split(",")] for node in nodes])
    assert np.array_equal(points, mesh.points)
    expected = expected_parts(mesh)
    assert [part.name for part in found.mesh_.elements] == list(expected)
    for part in found.mesh_.elements:
        own = expected[part.name][0]
        assert part.type == ("hex8" if mesh.cells.shape[1] == 8 else "tet4")
        assert [one.id for one in part.all_elements] == (own + 1).tolist()
        corners = [numbers(one.text) for one in part.all_elements]
        assert np.array_equal(np.array(corners) - 1, mesh.cells[own])
    for one in found.material_.all_materials:
        assert type(one).__name__ == "IsotropicElastic"
        assert (one.E.text, one.v.text) == expected[one.name][1:]
    assert [(one.name, one.mat) for one in found.meshdomains_.solid_domains] == [
        (name, name) for name in expected]
    sides = {one.name: one.all_quad4 + one.all_tri3 for one in found.mesh_.surfaces}
    assert set(sides) == set(expected_sides(mesh))
    for name, facets in expected_sides(mesh).items():
        corners = {tuple(sorted(numbers(one.text))) for one in sides[name]}
        assert corners == {tuple(sorted(points + 1)) for points in facets.points}
    on_side = {one.name: numbers(one.text) for one in found.mesh_.node_sets}
    low = mesh.points[:, 0] == mesh.points[:, 0].min()
    assert on_side["x_min"] == (np.flatnonzero(low) + 1).tolist()
    sets = {one.name: numbers(one.text) for one in found.mesh_.element_sets}
    assert sets["all_elements"] == list(range(1, len(mesh) + 1))
    if "BinIds" in mesh.fields:
        assert sets["ball"] == (np.flatnonzero(mesh.material == 1) + 1).tolist()


def test_febio_python(made):
    feb = pytest.importorskip("febio_python.feb")
    mesh, path = made
    found = feb.Feb(filepath=path)
    assert found.version == 4.0
    assert np.array_equal(found.get_nodes(dtype=np.float64)[0].coordinates, mesh.points)
    expected = expected_parts(mesh)
    parts = {part.name: part for part in found.get_volume_elements()}
    assert list(parts) == list(expected)
    for name, (own, _, _) in expected.items():
        assert np.array_equal(parts[name].connectivity, mesh.cells[own])
        assert np.array_equal(parts[name].ids, own)
    for one in found.get_materials():
        modulus, poisson = expected[one.name][1:]
        assert (one.parameters["E"], one.parameters["v"]) == (modulus, poisson)
    assert [(one.name, one.mat) for one in found.get_mesh_domains()] == [
        (name, name) for name in expected]
    assert {one.name for one in found.get_surfacesets()} == set(expected_sides(mesh))
    sets = {one.name: one.ids for one in found.get_nodesets()}
    low = mesh.points[:, 0] == mesh.points[:, 0].min()
    assert np.array_equal(sets["x_min"], np.flatnonzero(low))
