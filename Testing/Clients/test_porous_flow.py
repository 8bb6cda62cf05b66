"""Examples/porous_flow.py: permeability of ducts against Poiseuille's flow, and flow in pores."""

import os
import re
import subprocess
import sys

import numpy as np
import pytest

import foam_files as foam

pytest.importorskip("volume_fraction_mesh")
pytestmark = pytest.mark.skipif(not foam.is_installed(), reason="install Debian's openfoam")
EXAMPLES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Examples")
COLUMNS = ("elements", "hexes", "seconds", "volume", "failed", "regions", "angle", "skewness",
           "permeability", "balance", "change", "solving")
BALANCE = 1e-6  # largest difference of inflow and outflow, relative to inflow


def read_row(name, text):
    """Returns the row of a mesh as a dict of numbers. failed: number of checks."""
    line = re.search(r"^%s +(\d+ .*)$" % name, text, re.MULTILINE)[1]
    values = line.replace("Mesh OK", "0").replace(" failed", "").replace("%", "").split()
    assert len(values) == len(COLUMNS), line
    return dict(zip(COLUMNS, map(float, values)))


def run_example(*arguments):
    """Runs the example, and returns the rows of both meshes. Inflow and outflow must agree."""
    command = [sys.executable, os.path.join(EXAMPLES, "porous_flow.py"), *map(str, arguments)]
    run = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    assert run.returncode == 0, run.stdout
    print(run.stdout)
    rows = [read_row(name, run.stdout) for name in ("this mesh", "snappyHexMesh")]
    assert all(row["balance"] < BALANCE for row in rows), rows
    return rows


def round_duct(cells):
    return np.pi * (cells / 3) ** 4 / 8 / cells ** 2


def square_duct(cells):
    """Flow rate of a square duct by its coefficient 0.035144 (White, Viscous Fluid Flow)."""
    return 0.0351443 * (2 * cells / 3) ** 4 / cells ** 2


@pytest.mark.parametrize("case, exact, limit", [("round", round_duct, 0.01),
                                                ("square", square_duct, 0.015)])
def test_duct(case, exact, limit, tmp_path):
    """The error of the permeability is small and falls with the cell width."""
    errors = []
    for cells in (12, 24):
        ours, snappy = run_example("--case", case, "--cells", cells, "--folder",
                                   tmp_path / str(cells))
        assert ours["failed"] == 0 and ours["regions"] == 1 and ours["hexes"] == 100
        assert abs(ours["volume"]) < 1e-4, ours
        assert abs(snappy["permeability"] / exact(cells) - 1) < 0.1, snappy
        errors.append(ours["permeability"] / exact(cells) - 1)
    print("errors: %.4f, %.4f" % tuple(errors))
    assert abs(errors[1]) < limit and abs(errors[1]) < abs(errors[0]) / 2.5, errors


def test_pores(tmp_path):
    """Refinement brings both meshes to the same permeability, and the volume is the image's."""
    ours, snappy = zip(*(run_example("--cells", 16, "--refine", level, "--folder",
                                     tmp_path / str(level)) for level in (0, 1)))
    ratios = [b["permeability"] / a["permeability"] for a, b in zip(ours, snappy)]
    print("permeability, snappyHexMesh to this mesh: %.3f, %.3f" % tuple(ratios))
    assert all(abs(row["volume"]) < 1e-3 for row in ours), ours
    assert abs(ratios[1] - 1) < abs(ratios[0] - 1) / 1.5 and abs(ratios[1] - 1) < 0.2
    patches = foam.PolyMesh(tmp_path / "1" / "mesh").patches
    assert "pores_to_Void" in patches and int(patches["x_min"]["nFaces"]) > 0, patches
