"""scripts/meshers: measures of cells that are known, images, and the tables that are printed."""

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
import images
import measure_mesh as measure
import run_mesher as run

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
    assert measure.find_angles(REGULAR, np.arange(4)[None]) == pytest.approx(
        2 * (np.degrees(np.arccos(1 / 3)),))
    # A corner of the cube: right angles at its edges, and those of the face opposite to it.
    assert measure.find_angles(CUBE[[0, 1, 3, 4]], np.arange(4)[None]) == pytest.approx(
        (np.degrees(np.arccos(1 / 3 ** 0.5)), 90))
    flat = np.array([(0, 0, 0), (2, 0, 0), (1, 1, 0), (1, 0.5, 0.01)])
    smallest, largest = measure.find_angles(flat, np.arange(4)[None])
    assert smallest < 2 and largest > 176
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


def test_volumes():
    """Label 1 has half of its voxels, label 2 its volume, label 4 no element, 3 is not there."""
    labels = np.zeros((4, 4, 4), np.uint8)
    labels[0, 0, :2], labels[1, 0, 0], labels[2, 0, 0] = 1, 2, 4
    points = np.concatenate([CUBE, CUBE + [1, 0, 0]])
    mesh = measure.of_elements(points, np.arange(16).reshape(2, 8), [1, 2])
    errors, is_found = measure.find_volume_errors(mesh, measure.find_volumes(mesh), labels)
    assert errors == pytest.approx([0.5, 0, 1]) and list(is_found) == [True, True, False]


class Slab:
    """Labels 1 and 2 meet at x = 10, and label 3 with both at y = 10, in a box of 20."""

    labels, fills_box = np.empty((20, 20, 20)), True

    @staticmethod
    def distance(points, materials):
        return np.abs(np.where(materials[:, 1] == 3, points[:, 1], points[:, 0]) - 10)


def test_distances():
    """Four points of each plane are off by 0.1, and two on the line where they meet by 0.3."""
    x, y = np.meshgrid([2, 10.1, 18], [2, 10.1, 18], indexing="ij")
    x[1, 1] = y[1, 1] = 10.3
    points = np.concatenate([np.column_stack([x.ravel(), y.ravel(), np.full(9, z)])
                             for z in (2, 18)])
    lower = np.array([(0, 3, 4, 1), (3, 6, 7, 4), (1, 4, 5, 2), (4, 7, 8, 5)])
    mesh = measure.of_elements(points, np.hstack([lower, lower + 9]), [1, 2, 3, 3])
    assert measure.find_distances(mesh, Slab) == pytest.approx((0.1, 0.3))
    mesh.material[2:] = [1, 2]  # without label 3 the line is between two labels
    between, lines = measure.find_distances(mesh, Slab)
    assert between == pytest.approx(((4 * 0.01 + 2 * 0.09) / 6) ** 0.5) and np.isnan(lines)


def test_regions():
    """A region gets the label of most of its volume, here that of the larger of its two cells."""
    labels = np.ones((2, 2, 2), np.uint8)
    labels[1] = 5
    large, small = CUBE[[0, 1, 3, 4]], CUBE[[0, 1, 3, 4]] * 0.5 + [1.2, 0, 0]
    cells = np.arange(12).reshape(3, 4)
    found = run.find_region_labels(np.concatenate([large, small, small]), cells,
                                   np.array([0, 0, 1]), labels)
    assert list(found) == [1, 1, 5]


class Box:
    cells, grains, seed = 15, 3, 1


def test_images():
    """The truth of each image is near to the faces between its voxels."""
    sphere = images.Sphere(Box)
    assert sphere.labels.shape == (20, 20, 20)
    assert sphere.labels.sum() == pytest.approx(4 / 3 * np.pi * 7 ** 3, rel=0.05)
    points = np.array([(17, 10, 10), (10, 10, 2.5)], float)
    assert sphere.distance(points, None) == pytest.approx([0, 0.5])
    grains = images.Grains(Box)
    assert set(np.unique(grains.labels)) == {1, 2, 3}
    middle = grains.seeds[:2].mean(0)
    across = (grains.seeds[1] - grains.seeds[0]) / np.linalg.norm(grains.seeds[1] - grains.seeds[0])
    assert grains.distance(np.array([middle, middle + 0.3 * across]), np.array(
        [(1, 2), (1, 2)])) == pytest.approx([0, 0.3])


def print_tables(*options):
    command = [sys.executable, os.path.join(FOLDER, "compare.py"), "--cells", "16", "--grains", "6",
               *options]
    printed = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    print(printed)
    return printed, [[word.strip() for word in line.split("|")[1:-1]]
                     for line in printed.splitlines()
                     if line.startswith("| ") and not line.startswith("| mesher")]


def test_table():
    """Our meshes are valid, keep the volumes and conform."""
    printed, rows = print_tables("--images", "pores,grains", "--meshers",
                                 "hexahedra, width 1;tetrahedra, width 1, s;width 2;Gmsh")
    ours = ["ours, %s, width %s" % row for row in (
        ("hexahedra", "1"), ("hexahedra", "1.5"), ("hexahedra", "2"), ("hexahedra", "1, smoothed"),
        ("tetrahedra", "2"), ("tetrahedra", "1, smoothed"))]
    assert [row[0] for row in rows] == ours + ["Gmsh"] + ours
    for row in rows:
        is_ours, is_wide = row[0] != "Gmsh", row[0].endswith(("1.5", "2"))
        assert int(row[1]) > (100 if is_wide else 1000), row
        assert float(row[5]) > (0.05 if is_ours else 0) and row[7] == "0", row
        assert float(row[8].strip("% ")) < (1e-3 if is_ours else 0.1), row
        assert row[9:11] == ["0", "0"] and float(row[11]) < (1.2 if is_wide else 0.5), row
        if is_ours and row[2] == "tetrahedra":
            smallest, largest = map(float, row[6].split(" to "))
            assert 20 < smallest < 60 and 90 < largest < 160, row
        assert row[12] == "" or float(row[12]) < (0.5 if is_wide else 0.3), row
    assert [row[12] == "" for row in rows] == 7 * [True] + 6 * [False]
    assert [row[13] for row in rows] == 7 * [""] + 6 * ["0"]
    counts = [int(row[1]) for row in rows[-6:-3]]  # cells twice as wide are an eighth
    assert counts[0] > 2 * counts[1] > 4 * counts[2], counts
    assert "- Gmsh: no mesh: meshes one closed surface here" in printed


def test_absent(monkeypatch):
    """Meshers that are not there, do not mesh an image or take too long are named, and why."""
    monkeypatch.setenv("PYTHON_CLEAVER", "/nowhere/python")
    smoothed = "hexahedra, width 1, smoothed"
    printed, rows = print_tables("--images", "grains", "--meshers", "Cleaver;snappy;" + smoothed,
                                 "--cells", "96", "--seconds", "1")
    assert not rows and "ours, %s: no mesh: ended after 1 s of CPU" % smoothed in printed
    assert "- Cleaver: no mesh: there is no /nowhere/python" in printed
    assert "- snappyHexMesh: no mesh: meshes one closed surface here" in printed


def write_cube(folder, count):
    """Writes a cube as HybridOctree_Hex does: its triangles, and its mesh at another place."""
    pyvista = pytest.importorskip("pyvista")
    cube = pyvista.Cube(center=(3, 4, 5)).triangulate().clean()
    triangles = cube.regular_faces + 1  # point 0 is not used
    for name in ("input boundaries", "our results"):
        (folder / name).mkdir()
    with open(folder / "input boundaries" / "cube_tri.raw", "w", encoding="ascii") as file:
        file.write("%d %d\n" % (len(cube.points) + 1, len(triangles)))
        np.savetxt(file, np.concatenate([cube.points[:1], cube.points]))
        np.savetxt(file, triangles, "%d")
    grid = pyvista.ImageData(dimensions=3 * (count + 1,), spacing=3 * (7 / count,))
    hexahedra = grid.cast_to_structured_grid().cast_to_unstructured_grid()
    hexahedra.save(folder / "our results" / "cube.vtk", binary=False)


def test_published_hexahedra(tmp_path, capsys):
    """Theirs fit after they are moved back onto the triangles; ours have as many elements."""
    write_cube(tmp_path, 8)
    surfaces = pytest.importorskip("surfaces")
    surfaces.compare(str(tmp_path))
    theirs, ours = [line.split("|")[3:8] for line in capsys.readouterr().out.splitlines()
                    if line.startswith("| cube")]
    assert [float(value) for value in theirs] == pytest.approx([512, 1, 0, 0, 0], abs=1e-5)
    count, jacobian, rms, largest, volume = map(float, ours)
    assert count == pytest.approx(512, rel=0.3) and jacobian > 0.4
    assert 0 < rms < largest < 100 and abs(volume) < 1e-5


def test_no_published_hexahedra(tmp_path, capsys):
    pytest.importorskip("pyvista")
    surfaces = pytest.importorskip("surfaces")
    surfaces.compare(str(tmp_path))
    assert "clone https://github.com" in capsys.readouterr().out
