"""Tests the section $Periodic of Gmsh's files: Gmsh itself reads the pairs of nodes."""

import numpy as np
import pytest

import volume_fraction_mesh as vfm
from test_gmsh import FORMS, SIDES, gmsh, open_file
from test_periodic import FRACTIONS, GRID, MESHES, vectors


@pytest.fixture(params=[form for form in FORMS if "version" in form], ids=["text", "binary"])
def form(request):
    return request.param


@pytest.fixture(params=MESHES)
def mesh(request):
    return MESHES[request.param]


@pytest.fixture
def links(mesh, form, tmp_path):
    """Opens the file in Gmsh and returns per surface on a side of the domain: the side, the master,
    the nodes, the nodes of the master, and the matrix."""
    mesh.save(tmp_path / "mesh.msh", **form)
    with open_file(tmp_path / "mesh.msh") as groups:
        yield {surface: (side, *gmsh.model.mesh.getPeriodicNodes(2, surface))
               for side in SIDES for surface in groups[2, side][1]}


def test_nodes_of_sides(mesh, links):
    """Each node of an upper side has a master: its copy, one period lower."""
    places = dict(zip(mesh.point_ids.tolist(), mesh.points))
    partners = dict(zip(mesh.point_ids.tolist(), mesh.partner.tolist()))
    for axis, length in enumerate(mesh.fields["PeriodLengths"]):
        seen = set()
        for surface, (side, master, nodes, masters, matrix) in links.items():
            if side == SIDES[2 * axis] or side == SIDES[2 * axis + 1] and length == 0:
                assert master == surface and len(nodes) == 0
            elif side == SIDES[2 * axis + 1]:
                assert links[master][0] == SIDES[2 * axis]
                step = vectors(mesh, np.eye(3)[axis])
                for node, lower in zip(nodes.tolist(), masters.tolist()):
                    assert np.allclose(places[node], places[lower] + step, rtol=0, atol=1e-12)
                    assert partners[node] == partners[lower]
                seen.update(nodes.tolist())
                matrix = np.reshape(matrix, (4, 4))
                assert np.array_equal(matrix[:, :3], np.eye(4)[:, :3])
                assert np.allclose(matrix[:, 3], [*step, 1], rtol=0, atol=1e-14)
        if length > 0:
            points = mesh.facets(SIDES[2 * axis + 1]).points.ravel()
            if mesh.mids is not None:
                x = mesh.points[:, axis]
                points = np.flatnonzero(x == x.max())  # the sides are flat
                assert len(points) > 2 * len(mesh.facets(SIDES[2 * axis + 1]))
            assert seen == set(mesh.point_ids[points].tolist())


def test_files_without_links(form, tmp_path):
    """Meshes without copies have none, and version 2.2."""
    path = tmp_path / "mesh.msh"
    for options in ({}, {"periodic": "xyz", "periodic_sides": "joined"}):
        vfm.hexes(FRACTIONS, **GRID, **options).save(path, **form)
        assert b"$Periodic" not in path.read_bytes()
    MESHES["flat"].save(path, **{**form, "version": "2.2"})
    assert b"$Periodic" not in path.read_bytes()
    MESHES["flat"].save(path, **form)
    assert path.read_bytes().count(b"\n$Periodic\n") == 1
