"""Meshes of the debris of Examples/impact have the volume of the ball, near its place, in elements
of limited quality.

usage: pvpython TestDebris.py IMPACT FOLDER      VFM_SCULPTOR: path of sculptor

Prints for each mesh the error of the ball's volume, its displaced share (blocks of 4^3 cells) and
the smallest scaled Jacobian of all elements.
"""
import os
import shutil
import sys

from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(os.path.dirname(HERE), "Python"))
from mpi_run import mpi_run
from sculptor_program import sculptor

CELLS, LAST = "40", "300"
TETS, PARTICLES = ["--tetmesh", "Lattice"], ["--unmeshed", "particles"]
VOLUME = 1e-5  # largest relative error
# step: largest displaced share of the ball in hexahedra, without and with particles, and smallest
# scaled Jacobian
LIMITS = {180: (0.08, 0.07, 0.39), 240: (0.08, 0.06, 0.42), 300: (0.12, 0.09, 0.42)}


def measure(dump, folder, options):
    """Returns volume error and displaced share of the ball, and the smallest scaled Jacobian."""
    path = os.path.join(folder, "mesh.vtu")
    run = sculptor(dump, path, "--fractions", "ball,plate", "--quiet", *options)
    assert run.returncode == 0, run
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    data = reader.GetOutput().GetFieldData()
    values = [data.GetArray(name).GetValue(0)
              for name in ("VolumeError", "DisplacedVolume", "MinimumScaledJacobian")]
    print("%s %s: volume %+.1e, displaced %.2f %%, scaled Jacobian %.3f" % (
        os.path.basename(dump), " ".join(options), values[0], 100 * values[1], values[2]),
        flush=True)
    return values


def main(impact, folder):
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    run = mpi_run(1, [impact, "--cells", CELLS, "--steps", LAST, "--every", "60", "--dump", folder])
    assert run.returncode == 0, run
    for step, (most, most_beside_particles, quality) in LIMITS.items():
        dump = os.path.join(folder, "impact_%04d.pvti" % step)
        for options, displaced in (([], most), (PARTICLES, most_beside_particles)):
            error, share, jacobian = measure(dump, folder, options)
            assert abs(error) < VOLUME and share < displaced and jacobian > quality
            error, share, _ = measure(dump, folder, TETS + options)
            assert abs(error) < VOLUME and share < 0.25


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
