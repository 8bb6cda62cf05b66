#!/usr/bin/env pvpython
"""Writes four times of a ball that strikes a plate as SpyPlot files: impact.spcth,
impact/impact.spcth.0 and impact/impact.spcth.1.

usage: impact --cells 32 --dump DUMPS
       pvpython impact.py DUMPS FOLDER

The grid has 32 x 19 x 14 cells of 1/32 cm, in two blocks per file. Material 1 is the ball, 2 the
plate. Values are Float32, as the format requires; times are in seconds, velocities in cm/s.
"""
import os
import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLImageDataReader

for folder in (("Testing", "Python"), ("Examples",)):
    sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", *folder))
from need_files import need_files
from spyplot import split, write_spyplot

STEPS = (0, 40, 80, 120)
TIME_STEP = 1.3227651193689396e-8  # seconds
CM = 0.1  # centimetres per millimetre


def read_step(path):
    """Returns node coordinates in cm and the arrays, {name: (z, y, x)}."""
    reader = vtkXMLImageDataReader()
    reader.SetFileName(path)
    reader.Update()
    image = reader.GetOutput()
    size = [n - 1 for n in image.GetDimensions()]
    cells = {name: vtk_to_numpy(image.GetCellData().GetArray(name))
             for name in ("ball", "plate", "velocity")}
    arrays = {"Material volume fraction - 1": cells["ball"],
              "Material volume fraction - 2": cells["plate"]}
    for i, axis in enumerate("XYZ"):
        arrays[axis + " velocity"] = 1e5 * cells["velocity"][:, i]  # km/s
    nodes = [(image.GetOrigin()[a] + np.arange(size[a] + 1) * image.GetSpacing()[a]) * CM
             for a in range(3)]
    return nodes, {name: values.astype(np.float32).reshape(size[::-1])
                   for name, values in arrays.items()}


def main(dumps, folder):
    nodes, steps = None, []
    paths = [os.path.join(dumps, "impact_%04d_0.vti" % step) for step in STEPS]
    need_files(*paths)
    for path in paths:
        nodes, arrays = read_step(path)
        steps.append(arrays)
    write_spyplot(folder, "impact", [step * TIME_STEP for step in STEPS],
                  split(nodes, steps, (2, 1, 2)), files=2, parts="impact")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])
