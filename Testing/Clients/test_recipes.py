"""Recipes of Examples: each figure is compared with a known value."""

import os
import re
import shutil
import subprocess
import sys

import numpy as np
import pytest

from ball_in_block import volume_of

vfm = pytest.importorskip("volume_fraction_mesh")
EXAMPLES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Examples")
NUMBER = r"([-+.\d]+(?:e[-+]?\d+)?)"


def run_example(name, *arguments):
    """Returns what an example prints."""
    run = subprocess.run([sys.executable, os.path.join(EXAMPLES, name), *map(str, arguments)],
                         capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    print(run.stdout)
    return run.stdout


def numbers_of(pattern, text):
    """Returns the numbers of a pattern, in which # stands for each."""
    return [float(found) for found in re.search(
        pattern.replace("#", NUMBER), text).groups()]


@pytest.mark.skipif(not shutil.which("ccx"), reason="CalculiX (ccx) is not installed")
def test_topology_optimisation(tmp_path):
    """The body has the volume of the densities, and nearly the compliance of its voxels."""
    pytest.importorskip("scipy")
    text = run_example("topology_body.py", "--cells", 6, "--steps", 15, "--folder", tmp_path)
    volume, compliance = numbers_of("densities: volume #, compliance #", text)
    assert volume == 0.9  # 40 % of the box of 2.25
    of_body, iso, pieces = numbers_of(r"body: volume #, iso value #, \d+ .* in (\d+) piece", text)
    assert abs(of_body / volume - 1) < 1e-5 and 0.2 < iso < 0.8 and pieces == 1
    found, voxels = numbers_of("of the body #, of its fractions as voxels #", text)
    assert 0.5 * compliance < found < compliance and abs(found / voxels - 1) < 0.05
    assert numbers_of("reactions #, #, #", text) == pytest.approx([0, 1, 0], abs=1e-5)


def test_geology(tmp_path):
    """Volumes of layers, and that below the topography by its formula; both files agree."""
    meshio = pytest.importorskip("meshio")
    text = run_example("geology.py", "--cells", 20, "--folder", tmp_path)
    rows = re.findall(r"(\w+): %s m3 in the mesh, %s in the cells" % (NUMBER, NUMBER), text)
    assert [name for name, _, _ in rows] == ["basement", "limestone", "cover"]
    for _, found, known in rows:
        assert abs(float(found) / float(known) - 1) < 1e-6
    found, known = numbers_of("below the ground: # m3, by the formula #", text)
    assert known == 780 * 2000 * 1600 and abs(found / known - 1) < 1e-7
    read = meshio.read(tmp_path / "geology.msh")
    vtk = pytest.importorskip("pyvista").read(tmp_path / "geology.vtu")
    cells = np.concatenate([block.data for block in read.cells if block.type == "hexahedron"])
    groups = np.concatenate([group for block, group in zip(
        read.cells, read.cell_data["gmsh:physical"]) if block.type == "hexahedron"])
    numbers = {name: number for name, (number, dimension) in read.field_data.items()
               if dimension == 3}
    for name, found, _ in rows:
        volume = float(found)
        assert np.isclose(volume_of(read.points, cells[groups == numbers[name]]), volume, rtol=1e-9)
        chosen = vtk.cell_data["attribute"] == numbers[name]
        assert vtk.cell_data["attribute"].dtype.kind == "i"
        corners = vtk.cells_dict[12][chosen]
        assert np.isclose(volume_of(np.asarray(vtk.points, float), corners), volume, rtol=1e-9)
    # The ground is the free surface: its area on the map is that of the box.
    ground = [block.data[group == number] for block, group in zip(
        read.cells, read.cell_data["gmsh:physical"]) if block.type == "quad"
        for name, (number, dimension) in read.field_data.items()
        if dimension == 2 and "Void" in name]
    a, b, c, d = np.moveaxis(read.points[np.concatenate(ground)], 1, 0)
    upward = 0.5 * np.cross(c - a, d - b)[:, 2]
    assert (upward > 0).all() and np.isclose(upward.sum(), 2000 * 1600, rtol=1e-12)


@pytest.mark.parametrize("kind", ["ExaCA", "SPPARKS"])
def test_solidification(tmp_path, kind):
    """Grains keep their volumes and numbers; a sum of volumes is that of the box."""
    pytest.importorskip("vtk")
    netcdf = pytest.importorskip("netCDF4")
    sys.path.append(EXAMPLES)
    import exaca_grains
    path, array = tmp_path / "in.vtk", {"ExaCA": "GrainID", "SPPARKS": "Spin"}[kind]
    exaca_grains.make_file(path, 12)
    path.write_text(path.read_text().replace("GrainID", array))
    angles = np.random.default_rng(2).uniform(0, 90, (50, 3))
    np.savetxt(tmp_path / "angles.csv", angles, delimiter=",", header="phi1,Phi,phi2")
    text = run_example("exaca_grains.py", path, "--array", array, "--orientations",
                       tmp_path / "angles.csv", "--folder", tmp_path)
    given, meshed = numbers_of(r"(\d+) grains in the file, (\d+) in the mesh", text)
    volume, box, error = numbers_of("volume # of #, largest error of a grain #", text)
    assert given >= meshed > 10 and np.isclose(box, 12 ** 3 * 1e-18) and error < 1e-5
    assert np.isclose(volume, box, rtol=1e-6)
    # Rows of the deck and of Exodus have the orientations that ExaCA's rule gives.
    own = (tmp_path / "orientations.inp").read_text().count("*ORIENTATION")
    assert own == meshed
    with netcdf.Dataset(tmp_path / "grains.e") as data:
        names = list(netcdf.chartostring(data["name_elem_var"][:]))
        for block in range(1, int(meshed) + 1):
            values = {name: np.unique(data["vals_elem_var%deb%d" % (at, block)][0])
                      for at, name in enumerate(names, 1)}
            (number,) = values["GrainID"]
            row = angles[(abs(int(number)) - 1) % 50]
            for axis, angle in zip("XYZ", row):
                assert np.allclose(values["EulerAngles_" + axis], angle)


def test_organs(tmp_path):
    """Names of labels become sets, and each organ keeps the volume of its voxels."""
    nibabel = pytest.importorskip("nibabel")
    text = run_example("organs.py", "--output", tmp_path / "organs.inp")
    rows = re.findall(r"(\w+): %s mm3 in the mesh, %s in the voxels" % (NUMBER, NUMBER), text)
    assert [name for name, _, _ in rows] == ["trunk", "liver", "spleen", "vertebrae_L1"]
    for _, found, known in rows:
        assert abs(float(found) / float(known) - 1) < 1e-6
    # Half axes in mm: the volume of an ellipsoid, but for the steps of its voxels.
    assert abs(float(rows[2][2]) / (4 / 3 * np.pi * 12 * 16 * 14) - 1) < 0.02
    count, volume, grey, least, most = numbers_of(
        r"vertebrae_L1: (\d+) bins, volume # mm3, mean grey value #, E # to # MPa", text)
    assert count == 10 and np.isclose(volume, float(rows[3][1]), rtol=1e-6)
    labels, scan = (nibabel.load(tmp_path / name).get_fdata() for name in (
        "organs.nii.gz", "scan.nii.gz"))
    bone = scan[labels == 26]
    assert abs(grey - bone.mean()) < 0.01 and abs(bone.mean() - (200 + 8 * 50)) < 2
    low, high = (6850 * (0.1 + 0.0008 * end) ** 1.49 for end in (bone.min(), bone.max()))
    assert low < least < 1.1 * low and 0.9 * high < most < high
    deck = (tmp_path / "organs.inp").read_text()
    assert deck.count("*ELASTIC\n") == 10 and "*ELSET, ELSET=VERTEBRAE_L1_BIN_10\n" in deck
    for name in ("LIVER", "SPLEEN", "VERTEBRAE_L1"):
        assert "*ELSET, ELSET=%s\n" % name in deck
        assert "*SURFACE, NAME=TRUNK_TO_%s, TYPE=ELEMENT" % name in deck
