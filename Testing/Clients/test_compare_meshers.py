"""scripts/meshers: measures of cells that are known, and the table of both images."""

import os
import subprocess
import sys

import numpy as np
import pytest

import foam_files as foam
from ball_in_block import make_mesh

vfm = pytest.importorskip("volume_fraction_mesh")
FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts", "meshers")
sys.path.insert(0, FOLDER)
import measure_mesh as measure

CUBE = np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1),
                 (0, 1, 1)], float)
REGULAR = CUBE[[0, 2, 7, 5]]


def measure_one(points):
    """Returns the volume, the smallest scaled Jacobian and whether a cell is inverted."""
    mesh = measure.of_elements(points, np.arange(len(points))[None], [1])
    volumes, corners = measure.find_volumes(mesh), measure.find_corner_jacobians(mesh)
    return volumes[0], corners[1].min(), measure.count_inverted(volumes, *corners)


def test_cells():
    assert measure_one(CUBE) == pytest.approx((1, 1, 0))
    assert measure_one(REGULAR) == pytest.approx((1 / 3, 0.5 ** 0.5, 0))
    assert measure.find_smallest_angle(REGULAR, np.arange(4)[None]) == pytest.approx(
        np.degrees(np.arccos(1 / 3)))
    assert measure_one(CUBE * [1, 1, -1]) == pytest.approx((-1, -1, 1))
    corner = CUBE.copy()
    corner[6] = 0.3  # beyond the plane of its neighbours
    volume, jacobian, inverted = measure_one(corner)
    assert volume > 0 and jacobian < 0 and inverted == 1


def test_gap():
    """Two cells share a face, or have points of their own there."""
    points = np.concatenate([CUBE, CUBE + [1, 0, 0]]) * 10 + 10
    box = (40, 30, 30)  # all faces are far from its sides
    apart = np.arange(16).reshape(2, 8)
    joined = np.where(apart == 8, 1, apart)
    for one, other in ((11, 2), (12, 5), (15, 6)):
        joined[joined == one] = other
    assert [measure.count_open_faces(measure.of_elements(points, cells, [1, 1]), box)
            for cells in (joined, apart)] == [10, 12]


def test_polyhedra(tmp_path):
    """Hexahedra have the same measures as polyhedra of OpenFOAM."""
    mesh = make_mesh("hexes")
    mesh.save(str(tmp_path / "mesh.foam"))
    read = foam.PolyMesh(tmp_path)
    rows = []
    for cells in (measure.of_elements(mesh.points, mesh.cells, mesh.material),
                  measure.of_polyhedra(read.points, read.faces, read.owner, read.neighbour)):
        volumes, corners = measure.find_volumes(cells), measure.find_corner_jacobians(cells)
        rows.append((len(volumes), volumes.min(), volumes.sum(), corners[1].min(),
                     measure.count_inverted(volumes, *corners)))
    assert rows[0] == pytest.approx(rows[1], rel=1e-9)
    assert rows[0][3] > 0.4 and rows[0][4] == 0


def test_table():
    """Our meshes are valid, keep the volumes and conform."""
    command = [sys.executable, os.path.join(FOLDER, "compare.py"), "--cells", "16", "--grains", "6",
               "--meshers", "ours, hexahedra;ours, tetrahedra;Gmsh"]
    table = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    print(table)
    rows = [[word.strip() for word in line.split("|")[1:-1]] for line in table.splitlines()
            if line.startswith("| ") and not line.startswith("| mesher")]
    assert [row[0] for row in rows] == ["ours, hexahedra", "ours, tetrahedra", "Gmsh",
                                        "ours, hexahedra", "ours, tetrahedra"]
    for row in rows:
        ours, volume = row[0] != "Gmsh", float(row[6].strip("% "))
        assert int(row[1]) > 1000 and volume < (1e-3 if ours else 0.1), row
        assert float(row[7]) > (0.05 if ours else 0) and row[9] == "0", row
        assert float(row[10]) < 0.5, row
    assert [row[11] for row in rows] == ["", "", "", "0", "0"]
    assert "- Gmsh: not run: " in table
