"""Examples/permeability.py: drag of a cubic array of spheres against Zick and Homsy."""

import os
import re
import subprocess
import sys

import pytest

import foam_files as foam

pytest.importorskip("volume_fraction_mesh")
pytestmark = pytest.mark.skipif(not foam.is_installed(), reason="install Debian's openfoam")
EXAMPLES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Examples")
ZICK_HOMSY = {0.125: 4.292, 0.216: 7.442}


def run_example(*arguments):
    """Runs the example, and returns the drag coefficient K of each solid fraction."""
    command = [sys.executable, os.path.join(EXAMPLES, "permeability.py"), *map(str, arguments)]
    run = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    assert run.returncode == 0, run.stdout
    print(run.stdout)
    rows = re.findall(r"^(0\.\d+) +\d+ +[-+.\d]+% +Mesh OK +[.\d]+ +([.\d]+) ", run.stdout,
                      re.MULTILINE)
    return {float(solid): float(drag) for solid, drag in rows}


def test_drag():
    """The error is below 2 % and falls with the square of the cell width."""
    errors = []
    for cells in (16, 32):
        drags = run_example("--cells", cells, "--solid", *ZICK_HOMSY)
        assert drags.keys() == ZICK_HOMSY.keys()
        errors.append([drags[solid] / known - 1 for solid, known in ZICK_HOMSY.items()])
    print("errors: %s" % errors)
    assert all(abs(fine) < 0.02 and abs(fine) < abs(coarse) / 3
               for coarse, fine in zip(*errors)), errors


def test_extrapolation():
    """The limit of coarse grids is within 2 %, where neither grid is."""
    command = [sys.executable, os.path.join(EXAMPLES, "permeability.py"), "--cells", "16",
               "--solid", "0.125", "--extrapolate"]
    run = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True)
    print(run.stdout)
    limit, = re.findall(r"extrapolated: ([.\d]+)", run.stdout)
    assert abs(float(limit) / ZICK_HOMSY[0.125] - 1) < 0.02


def test_position_and_sides(tmp_path):
    """Drag depends neither on where the sides cut the array nor on their kind."""
    choices = (("flat", "middle"), ("flat", "corner"), ("free", "corner"))
    drags = [run_example("--cells", 16, "--solid", 0.216, "--sides", sides, "--at", at, "--folder",
                         tmp_path / (sides + at))[0.216] for sides, at in choices]
    assert max(drags) / min(drags) - 1 < 1e-3, drags
    patches = foam.PolyMesh(tmp_path / "flatcorner" / "0.216").patches
    assert {name: patch["type"] for name, patch in patches.items()} == {
        **{side: "cyclic" for side in ("x_min", "x_max", "y_min", "y_max", "z_min", "z_max")},
        "fluid_to_Void": "wall"}
