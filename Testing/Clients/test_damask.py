"""Examples/grains_to_damask.py: files of grains with orientations, read by DAMASK's Python package
and Gmsh; stresses by CalculiX against the turned crystal and bounds."""

import os
import re
import shutil
import subprocess
import sys

import numpy as np
import pytest

vfm = pytest.importorskip("volume_fraction_mesh")
pytest.importorskip("h5py")
EXAMPLES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Examples")
sys.path.append(EXAMPLES)
import grains_to_damask
import homogenise

needs_calculix = pytest.mark.skipif(not shutil.which("ccx"),
                                    reason="CalculiX (ccx) is not installed")


def run_example(folder, *options):
    """Returns the stress over the strain and its bounds."""
    run = subprocess.run(
        [sys.executable, os.path.join(EXAMPLES, "grains_to_damask.py"), "--folder", str(folder),
         "--cells", "8", "--grains", "6", *options], capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    print(run.stdout)
    return [float(text) for text in re.search(
        r"x: (\S+) GPa, bounds (\S+) and (\S+) GPa", run.stdout).groups()]


@needs_calculix
def test_grains(tmp_path):
    found, lower, upper = run_example(tmp_path)
    assert lower * 1.001 < found < upper * 0.999


@needs_calculix
def test_one_orientation(tmp_path):
    """The stress is that of the turned crystal; that of the inverse turn is another one."""
    found, lower, upper = run_example(tmp_path, "--one")
    axes = vfm.read_grains(tmp_path / "grains.dream3d").axes()[0]
    crystal = homogenise.cubic(*homogenise.COPPER)
    assert np.isclose(found, homogenise.rotated(crystal, axes.T)[0, 0], rtol=2e-6)
    assert not np.isclose(found, homogenise.rotated(crystal, axes)[0, 0], rtol=0.01)
    assert np.isclose(lower, found, rtol=2e-6) and np.isclose(upper, found, rtol=2e-6)


@pytest.fixture
def files(tmp_path):
    """Returns the mesh and the grains of the files in the folder."""
    path = tmp_path / "grains.dream3d"
    grains_to_damask.make_file(path, 8, 6)
    grains, mesh = vfm.read_grains(path), vfm.tets(labels=vfm.read(path), arrays=["FeatureIds"])
    grains_to_damask.write_inputs(mesh, grains, tmp_path)
    return mesh, grains


def test_material_yaml(files, tmp_path):
    damask = pytest.importorskip("damask")
    mesh, grains = files
    assert grains_to_damask.complete_for_damask(tmp_path, grains.phase_names.values())
    config = damask.ConfigMaterial.load(tmp_path / "material.yaml")
    assert config.is_complete and config.is_valid and len(config["material"]) == 7
    theirs = damask.ConfigMaterial.load_DREAM3D(
        tmp_path / "grains.dream3d", "CellFeatureData", Euler_angles="AvgEulerAngles")
    for ours, other in zip(config["material"][1:], theirs["material"][1:], strict=True):
        own, known = ours["constituents"][0], other["constituents"][0]
        assert own["phase"] == known["phase"] == "copper"
        assert np.allclose(own["O"], np.asarray(known["O"]) * np.sign(known["O"][0]))
    turns = damask.Rotation.from_Euler_angles(grains.euler_angles)
    assert np.allclose(turns.as_matrix(), grains.axes())


def test_numbers_of_gmsh(files, tmp_path):
    """A volume has the number of its grain, which is its entry in material.yaml from 0."""
    gmsh = pytest.importorskip("gmsh")
    mesh, _ = files
    gmsh.initialize(interruptible=False)
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.open(str(tmp_path / "grains.msh"))
        found = {}
        for dimension, number in gmsh.model.getPhysicalGroups(3):
            for entity in gmsh.model.getEntitiesForPhysicalGroup(dimension, number):
                kinds, tags, _ = gmsh.model.mesh.getElements(dimension, entity)
                assert list(kinds) == [4]  # tetrahedra: DAMASK takes only simplices
                found[number] = found.get(number, 0) + len(tags[0])
        sides = {gmsh.model.getPhysicalName(2, number): number
                 for _, number in gmsh.model.getPhysicalGroups(2)}
    finally:
        gmsh.finalize()
    assert found == {number: (mesh.material == number).sum() for number in range(1, 7)}
    assert [sides[name] for name in grains_to_damask.SIDES] == [1, 2, 3, 4, 5, 6]
