"""Tests the meshes in CalculiX, which stretches a bar of two parts."""

import os
import shutil
import subprocess

import numpy as np
import pytest

import volume_fraction_mesh as vfm

BAR = "box size=2,1,1 material=1; box size=2,1,1 center=2,0,0 material=2"
DECK = """*MATERIAL, NAME=STEEL
*ELASTIC
1000, 0.
*SOLID SECTION, ELSET=MATERIAL1, MATERIAL=STEEL
*SOLID SECTION, ELSET=MATERIAL2, MATERIAL=STEEL
*STEP
*STATIC
*BOUNDARY
X_MIN, 1, 3
X_MAX, 1, 1, 0.4
*NODE PRINT, NSET=X_MIN, TOTALS=ONLY
RF
*END STEP
"""


@pytest.mark.skipif(not shutil.which("ccx"), reason="CalculiX (ccx) is not installed")
@pytest.mark.parametrize("make", [vfm.hexes, vfm.tets])
def test_stretched_bar(make, tmp_path):
    """At a strain of 0.1, the force is 0.1 times the modulus times the area."""
    mesh = make(vfm.shapes(BAR, (24, 8, 8), bounds=[-1, 3, -0.5, 0.5, -0.5, 0.5]))
    mesh.save(tmp_path / "bar.inp")
    with open(tmp_path / "bar.inp", "a") as file:
        file.write(DECK)
    told = subprocess.run(
        ["ccx", "bar"], cwd=tmp_path, capture_output=True, text=True,
        env={**os.environ, "OMP_NUM_THREADS": "1"}
    )
    assert "Job finished" in told.stdout, told.stdout
    force = [float(word) for word in (tmp_path / "bar.dat").read_text().split()[-3:]]
    assert np.allclose(force, [-100, 0, 0], atol=1e-4)
