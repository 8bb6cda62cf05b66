"""Reads .feb files by pyfebio and febio-python: nodes, elements, sets and materials."""

from dataclasses import replace

import numpy as np
import pytest

vfm = pytest.importorskip("volume_fraction_mesh")
POISSON = 0.25


@pytest.fixture(params=["hexes plain", "hexes bins", "tets plain", "tets bins"])
def made(request, tmp_path):
    """Returns a mesh and the path of its file; with bins each material has several parts.

    It is small: the time of pyfebio grows with the third power of the number of elements.
    """
    kind, variant = request.param.split()
    labels = np.ones((4, 3, 2) if kind == "hexes" else (2, 1, 1), int)
    labels[len(labels) // 2:] = 2
    mesh = getattr(vfm, kind)(labels=labels, names={1: "ball", 2: "block"}, spacing=0.7,
                              **({"method": "cells"} if kind == "tets" else {}))
    if variant == "bins":
        grey = 2.0 + mesh.points[mesh.cells].mean(axis=1) @ [0.5, 0.25, 0.125]
        mesh = replace(mesh, state={"grey": grey}).bin_materials("grey", 5, a=3.0, b=2.0,
                                                                 poisson=POISSON)
        mesh.state.pop("grey")  # values: <elem> in pyfebio, <e> in febio-python; FEBio reads both
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


def get(feb, name, **options):
    """Calls a method without its cache, which mixes up files in febio-python 0.2.1."""
    return getattr(type(feb), "get_" + name).__wrapped__(feb, **options)


def test_febio_python(made):
    feb = pytest.importorskip("febio_python.feb")
    mesh, path = made
    found = feb.Feb(filepath=path)
    assert found.version == 4.0
    assert np.array_equal(get(found, "nodes", dtype=np.float64)[0].coordinates, mesh.points)
    expected = expected_parts(mesh)
    parts = {part.name: part for part in get(found, "elements")}
    assert list(parts) == list(expected)
    for name, (own, _, _) in expected.items():
        assert np.array_equal(parts[name].connectivity, mesh.cells[own])
        assert np.array_equal(parts[name].ids, own)
    for one in get(found, "materials"):
        modulus, poisson = expected[one.name][1:]
        assert (one.parameters["E"], one.parameters["v"]) == (modulus, poisson)
    assert [(one.name, one.mat) for one in get(found, "mesh_domains")] == [
        (name, name) for name in expected]
    sets = {one.name: one.ids for one in get(found, "nodesets")}
    low = mesh.points[:, 0] == mesh.points[:, 0].min()
    assert np.array_equal(sets["x_min"], np.flatnonzero(low))
