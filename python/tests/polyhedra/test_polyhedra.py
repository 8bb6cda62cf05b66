"""Tests polyhedra around the nodes of tetrahedra, in cases of OpenFOAM and VTK's files."""

import re

import numpy as np
import pytest

import volume_fraction_mesh as vfm


def ball_in_block(make=vfm.tets, **options):
    fractions = vfm.shapes("sphere radius=0.5; box size=2,2,2 material=2", 12, bounds=[-1, 1] * 3)
    return make(fractions, names=["ball", "block"], **options)


def read_list(path):
    """Returns the lines of the first list of a file of OpenFOAM."""
    text = path.read_text()
    body = re.search(r"\n(\d+)\n\(\n(.*?)\n\)\n", text[text.index("}\n"):], re.DOTALL)
    lines = body.group(2).split("\n")
    assert len(lines) == int(body.group(1))
    return lines


def numbers_of(lines, kind=int):
    return [np.array(re.sub(r"^\d*\(|\)$", "", line).split(), kind) for line in lines]


def read_zones(path):
    """Returns the members of each zone by name."""
    found = re.findall(r"(\w+)\n\{[^(]*List<label>\n\d+\n\(\n(.*?)\)", path.read_text(), re.DOTALL)
    return {name: np.array(members.split(), int) for name, members in found}


def measure_faces(points, faces):
    """Returns areas along normals and centres, of triangles around the mean of the points."""
    areas, centres = [], []
    for face in faces:
        corners = points[face]
        mean, after = corners.mean(axis=0), np.roll(corners, -1, axis=0)
        triangles = np.cross(after - corners, mean - corners) / 2
        sizes = np.linalg.norm(triangles, axis=1)
        areas.append(triangles.sum(axis=0))
        centres.append(sizes @ (corners + after + mean) / 3 / sizes.sum())
    return np.array(areas), np.array(centres)


def test_case(tmp_path):
    """Cells are closed; the volumes of materials are those of the tetrahedra."""
    mesh = ball_in_block()
    mesh.save(tmp_path / "mesh.foam", polyhedra=True)
    folder = tmp_path / "constant" / "polyMesh"
    points = np.array(numbers_of(read_list(folder / "points"), float))
    faces = numbers_of(read_list(folder / "faces"))
    owner = np.array(read_list(folder / "owner"), int)
    neighbour = np.array(read_list(folder / "neighbour"), int)
    count, inner = owner.max() + 1, len(neighbour)
    assert len(mesh.points) <= count < len(mesh.cells) / 3
    areas, centres = measure_faces(points, faces)
    openings, volumes = np.zeros((count, 3)), np.zeros(count)
    parts = np.einsum("fa,fa->f", areas, centres) / 3
    np.add.at(openings, owner, areas)
    np.subtract.at(openings, neighbour, areas[:inner])
    np.add.at(volumes, owner, parts)
    np.subtract.at(volumes, neighbour, parts[:inner])
    assert np.abs(openings).max() < 1e-13 and volumes.min() > 0
    zones = read_zones(folder / "cellZones")
    assert list(zones) == ["ball", "block"] and sum(map(len, zones.values())) == count
    for number, cells in enumerate(zones.values(), 1):
        expected = mesh.volumes()[mesh.material == number].sum()
        assert abs(volumes[cells].sum() / expected - 1) < 1e-12


def test_vtk_file(tmp_path):
    mesh = ball_in_block()
    mesh.save(tmp_path / "mesh.vtu", polyhedra=True)
    text = (tmp_path / "mesh.vtu").read_text()
    cells = int(re.search(r'NumberOfCells="(\d+)"', text).group(1))
    assert len(mesh.points) <= cells < len(mesh.cells) / 3
    for name in ("MaterialId", "FragmentId", "NodeId", "faces", "faceoffsets"):
        assert 'Name="%s"' % name in text, name


def test_messages(tmp_path):
    for mesh, reason in ((ball_in_block(vfm.hexes), "this mesh has hexahedra"),
                         (ball_in_block(element_order="quadratic"), "of second order"),
                         (ball_in_block(split_interfaces="all"), "has split interfaces")):
        with pytest.raises(OSError, match=reason):
            mesh.save(tmp_path / "mesh.vtu", polyhedra=True)
    with pytest.raises(TypeError, match="polyhedra is not an option of .msh"):
        ball_in_block().save(tmp_path / "mesh.msh", polyhedra=True)
    assert not list(tmp_path.iterdir())
