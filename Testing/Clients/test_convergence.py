"""Tests Examples/convergence.py: its exact solution, and its tables on small meshes."""

import os
import re
import subprocess
import sys

import numpy as np
import pytest

pytest.importorskip("skfem")
pytest.importorskip("matplotlib")
FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Examples")
sys.path.append(FOLDER)
import convergence


def test_exact_solution():
    """The stress follows from the displacement, is in equilibrium, and crosses the ball."""
    exact = convergence.Tension()
    x = np.array([0.5, -0.4, 0.3])[:, None]
    step = 1e-4 * np.eye(3)[:, :, None]
    gradient = np.stack([(exact.displacement(x + h) - exact.displacement(x - h)) / 2e-4
                         for h in step], axis=1)
    strain = (gradient + gradient.transpose(1, 0, 2)) / 2
    lame, shear = convergence.moduli(1.0)
    expected = lame * np.trace(strain) * np.eye(3)[:, :, None] + 2 * shear * strain
    assert np.allclose(exact.stress(x), expected, atol=1e-7)
    divergence = sum((exact.stress(x + step[axis]) - exact.stress(x - step[axis]))[:, axis]
                     for axis in range(3)) / 2e-4
    assert np.allclose(divergence, 0, atol=1e-6)
    normal = np.array([0.6, 0.0, 0.8])
    inside, outside = (exact.stress((0.5 + gap) * normal[:, None])[..., 0] @ normal
                       for gap in (-1e-9, 1e-9))
    assert np.allclose(inside, outside, atol=1e-7)
    far = exact.stress(np.array([[300.0], [400.0], [500.0]]))[..., 0]
    assert np.allclose(far, np.diag([0, 0, 1]), atol=1e-7)


def test_tables(tmp_path):
    picture = tmp_path / "convergence.png"
    run = subprocess.run([sys.executable, os.path.join(FOLDER, "convergence.py"), "--quick",
                          "--picture", str(picture)], capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    rows = re.findall(r"^(hexahedra|tetrahedra|voxels) +(.*)$", run.stdout, re.MULTILINE)
    heat = {kind: np.array(text.split(), dtype=float) for kind, text in rows[:3]}
    stress = {kind: np.array(text.split(), dtype=float) for kind, text in rows[3:]}
    for kind in ("hexahedra", "tetrahedra"):
        assert 3.5 < heat[kind][2] < 4.6  # second order
    assert heat["voxels"][2] < 3
    rms = [stress[kind][2] for kind in ("hexahedra", "tetrahedra", "voxels")]
    assert rms[0] < 0.1 and 3 * rms[0] < rms[1] and 2 * rms[1] < rms[2]
    assert picture.stat().st_size > 20000
