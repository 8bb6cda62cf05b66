"""CalculiX solves on the meshes: a bar of two parts that is stretched."""

import os
import shutil
import subprocess

import numpy as np
import pytest

import volume_fraction_mesh as vfm
from volume_fraction_mesh._abaqus import number

BAR = "box size=2,1,1 material=1; box size=2,1,1 center=2,0,0 material=2"
DECK = """*MATERIAL, NAME=STEEL
*ELASTIC
1000, 0.
*SOLID SECTION, ELSET=MATERIAL1, MATERIAL=STEEL
*SOLID SECTION, ELSET=MATERIAL2, MATERIAL=STEEL
*STEP
*STATIC
*BOUNDARY
SURFACE_%d, 1, 3
SURFACE_%d, 1, 1, 0.4
*NODE PRINT, NSET=SURFACE_%d, TOTALS=ONLY
RF
*END STEP
"""


@pytest.mark.skipif(not shutil.which("ccx"), reason="CalculiX (ccx) is not there")
@pytest.mark.parametrize("make", [vfm.hexes, vfm.tets])
def test_stretched_bar(make, tmp_path):
    """A tenth longer: the force is a tenth of the modulus times the area."""
    mesh = make(vfm.shapes(BAR, (24, 8, 8), bounds=[-1, 3, -0.5, 0.5, -0.5, 0.5]))
    mesh.save(tmp_path / "bar.inp")
    sides = np.asarray(mesh.surfaces.fields["SurfaceSides"])
    fixed, pulled = (1 + int(np.argmax(sides == side)) for side in (0, 1))
    with open(tmp_path / "bar.inp", "a") as file:
        file.write(DECK % (fixed, pulled, fixed))
    told = subprocess.run(
        ["ccx", "bar"], cwd=tmp_path, capture_output=True, text=True, env={**os.environ, "OMP_NUM_THREADS": "1"}
    )
    assert "Job finished" in told.stdout, told.stdout
    force = [float(word) for word in (tmp_path / "bar.dat").read_text().split()[-3:]]
    assert np.allclose(force, [-100, 0, 0], atol=1e-4)


def test_numbers():
    for value in (0.1, -1.2345678901234567e-05, 1e-300 / 3, -np.pi * 1e-200, 123456.789, -7.0):
        text = number(value)
        assert len(text) <= 20 and np.isclose(float(text), value, rtol=5e-13, atol=0)
