"""Tests second-order meshes."""

import meshio
import numpy as np
import pytest

import volume_fraction_mesh as vfm

KINDS = [(vfm.hexes, "quadratic", 12, "hexahedron20"),
         (vfm.hexes, "quadratic27", 19, "hexahedron27"),
         (vfm.tets, "quadratic", 6, "tetra10")]


@pytest.fixture(scope="module")
def ball():
    return vfm.shapes("sphere radius=0.7", 12, bounds=[-1, 1] * 3)


@pytest.mark.parametrize("make, order, mids, kind", KINDS)
def test_nodes(ball, make, order, mids, kind):
    """Mid nodes on the surface are nearer to the sphere than the middles of their edges."""
    mesh = make(ball, element_order=order)
    assert mesh.kind == kind and mesh.mids.shape == (len(mesh), mids)
    assert mesh.cells.max() < mesh.mids.min()
    assert np.array_equal(np.unique(np.hstack([mesh.cells, mesh.mids])),
                          np.arange(len(mesh.points)))
    middles = mesh.points[mesh.cells[:, :2]].mean(axis=1)
    nodes = mesh.mids[:, 0]
    on_surface = mesh.geometry.dimension[nodes] == 2
    off = [np.abs(np.linalg.norm(points[on_surface], axis=1) - 0.7).max()
           for points in (mesh.points[nodes], middles)]
    assert 3 * off[0] < off[1]
    inside = mesh.geometry.dimension[nodes] == 3
    assert np.array_equal(mesh.points[nodes[inside]], middles[inside])


@pytest.mark.parametrize("cells", [8, 16, 32])
def test_faces_are_as_near_as_edges(cells):
    """The nodes of faces follow from the edges, and are nearer to the sphere than those."""
    ball = vfm.shapes("sphere radius=0.7", cells, bounds=[-1, 1] * 3)
    mesh = vfm.hexes(ball, element_order="quadratic27")
    off = []
    for nodes in (mesh.mids[:, :12], mesh.mids[:, 12:18]):
        nodes = np.unique(nodes)
        points = mesh.points[nodes[mesh.geometry.dimension[nodes] == 2]]
        off.append((((np.linalg.norm(points, axis=1) - 0.7) ** 2).mean()) ** 0.5 * cells / 2)
    print("%d cells: %.5f at edges, %.5f in faces" % (cells, *off))
    assert off[1] < off[0]


@pytest.mark.parametrize("make, order, mids, kind", KINDS)
def test_files(ball, tmp_path, make, order, mids, kind):
    mesh = make(ball, element_order=order)
    for name in ("ball.vtu", "ball.vtk", "ball.msh"):
        mesh.save(tmp_path / name, **({"texts": False} if name == "ball.vtu" else {}))
        read = meshio.read(tmp_path / name)
        assert read.cells_dict[kind].shape == (len(mesh), mesh.cells.shape[1] + mids), name
        volumes = read.points[read.cells_dict[kind]]
        made = mesh.points[np.hstack([mesh.cells, mesh.mids])]
        assert np.array_equal(np.sort(volumes, axis=1), np.sort(made, axis=1)), name
    mesh.save(tmp_path / "ball.npz")
    assert np.array_equal(vfm.load(tmp_path / "ball.npz").mids, mesh.mids)


def test_reduced_integration(ball, tmp_path):
    mesh = vfm.hexes(ball, element_order="quadratic")
    for reduced, name in ((False, "C3D20"), (True, "C3D20R")):
        mesh.save(tmp_path / "ball.inp", reduced=reduced)
        assert "TYPE=%s, " % name in (tmp_path / "ball.inp").read_text()


def test_refused(ball, tmp_path):
    with pytest.raises(ValueError, match="Cohesive is for meshes of ElementOrder Linear"):
        vfm.hexes(ball, element_order="quadratic", split_interfaces="all",
                  split_connection="cohesive")
    mesh = vfm.hexes(ball, element_order="quadratic27")
    with pytest.raises(OSError, match="not written with elements of 27 nodes"):
        mesh.save(tmp_path / "ball.inp")
