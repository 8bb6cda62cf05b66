#!/usr/bin/env pvpython
"""Writes ball_and_plate.vti: volume fractions of a ball that has sunk a little into a plate.

usage: pvpython ball_and_plate.py PLUGIN OUT.vti

48 x 48 x 36 cells of 1/24, cell arrays `ball` and `plate` (double), exact to 1e-6 of a cell. The ball keeps its
volume, the plate gets what is left of each cell.
"""
import sys

from paraview import servermanager, simple
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter

SHAPES = """
sphere    material=1 center=0,0,0.875 radius=0.45
halfspace material=2 point=0,0,0.55 normal=0,0,1
"""


def main(plugin, path):
    simple.LoadPlugin(plugin, remote=False, ns=globals())  # defines VolumeFractionShapes
    source = VolumeFractionShapes(
        Shapes=SHAPES, Dimensions=(48, 48, 36), Bounds=(-1, 1, -1, 1, 0, 1.5), Tolerance=1e-6)
    source.UpdatePipeline()
    image = servermanager.Fetch(source)
    for i, name in enumerate(("ball", "plate")):
        image.GetCellData().GetArray("Material%d" % (i + 1)).SetName(name)
    writer = vtkXMLImageDataWriter()
    writer.SetInputData(image)
    writer.SetFileName(path)
    writer.SetDataModeToBinary()
    writer.SetCompressorTypeToZLib()
    if not writer.Write():
        sys.exit("cannot write " + path)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])
