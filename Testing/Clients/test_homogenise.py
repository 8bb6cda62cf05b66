"""Examples/homogenise.py: effective stiffnesses by CalculiX against exact and other solutions."""

import os
import re
import shutil
import subprocess
import sys

import numpy as np
import pytest

pytest.importorskip("volume_fraction_mesh")
pytest.importorskip("pyvista")
EXAMPLES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Examples")
SCREEN = [shutil.which("xvfb-run"),
          "-a"] if shutil.which("xvfb-run") and not os.environ.get("DISPLAY") else []
sys.path.append(EXAMPLES)
import homogenise
import voxel_stiffness


def test_rotated_crystals():
    """A quarter turn leaves a cubic crystal, and any turn the bulk modulus."""
    crystal = homogenise.cubic(*homogenise.COPPER)
    quarter = np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1.0]])
    assert np.allclose(homogenise.rotated(crystal, quarter), crystal)
    turn, _ = np.linalg.qr(np.arange(9.0).reshape(3, 3) ** 2 + np.eye(3))
    turned = homogenise.rotated(crystal, turn)
    assert not np.allclose(turned, crystal, rtol=0.1) and np.allclose(turned, turned.T)
    assert np.allclose(homogenise.moduli(turned), homogenise.moduli(crystal))
    even = homogenise.isotropic(3.0, 0.3)
    assert np.allclose(homogenise.rotated(even, turn), even)
    assert np.allclose(homogenise.moduli(even), (3 / 1.2, 3 / 2.6))


def test_voxels():
    """Equal materials are exact. 32 voxels per side are within 0.3 % of 128."""
    even = homogenise.isotropic(1.0, voxel_stiffness.POISSON)
    assert np.allclose(voxel_stiffness.cubic_stiffness(9, 1.0, 0.2),
                       (even[0, 0], even[0, 1], even[3, 3]))
    for contrast, expected in homogenise.REFERENCES.items():
        found = voxel_stiffness.cubic_stiffness(32, contrast, homogenise.SPHERES)
        assert np.allclose(found, expected, rtol=3e-3)


def test_conductivity(capsys):
    """Stiff and soft spheres converge to the published series with the square of the width."""
    pytest.importorskip("skfem")
    for contrast in homogenise.REFERENCES:
        for cells in (8, 16):
            homogenise.run_conduction(cells, contrast)
    errors = np.array(re.findall(r"error (\S+) %", capsys.readouterr().out), float).reshape(2, 2)
    assert abs(errors).max() < 1
    assert (abs(errors[:, 1]) < 0.35 * abs(errors[:, 0])).all()


@pytest.mark.skipif(not shutil.which("ccx"), reason="CalculiX (ccx) is not installed")
def test_example(tmp_path):
    picture = tmp_path / "homogenise.png"
    run = subprocess.run(
        [*SCREEN, sys.executable, os.path.join(EXAMPLES, "homogenise.py"), "--quick", "--picture",
         str(picture)], cwd=tmp_path, capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    print(run.stdout)
    asymmetries = [float(text) for text in re.findall(r"asymmetry (\S+)", run.stdout)]
    assert len(asymmetries) == 6 and max(asymmetries) < 1e-6
    assert float(re.search(r"relative to the largest value: (\S+)", run.stdout)[1]) < 1e-6
    errors = np.array([line.replace("%", "").split(",") for line in re.findall(
        r"errors (.*)", run.stdout)], float)
    assert errors.shape == (4, 3)
    for coarse, fine in (errors[:2], errors[2:]):
        assert np.linalg.norm(fine) < 0.7 * np.linalg.norm(coarse) and abs(fine).max() < 1
    bulk, shear, lower, upper = (float(text) for text in re.search(
        r"error (\S+); shear modulus (\S+) GPa, bounds (\S+) and (\S+)", run.stdout).groups())
    assert bulk < 1e-6 and lower < shear < upper
    assert picture.stat().st_size > 20000
