#!/usr/bin/env pvpython
"""Writes volume fractions of shapes, exact to 1e-6 of a cell.

usage: pvpython shapes.py PLUGIN ball_and_plate|fin OUT.vti

ball_and_plate: a ball sunk a little into a plate. The grid has 48 x 48 x 36 cells of 1/24 and the
cell arrays `ball` and `plate` (double). The ball keeps its volume; the plate gets the rest.

fin: a ball with an oblique plate, 1.2 cells thick, that sticks out of it. The grid has 40 x 32 x 32
cells of 1/16 and the cell array `body` (double).
"""
import os
import sys

from paraview import servermanager
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Examples"))
from load_plugin import load_plugin
from need_files import need_files

SCENES = {
    "ball_and_plate": (("ball", "plate"), (48, 48, 36), (-1, 1, -1, 1, 0, 1.5), """
sphere    material=1 center=0,0,0.875 radius=0.45
halfspace material=2 point=0,0,0.55 normal=0,0,1
"""),
    "fin": (("body",), (40, 32, 32), (-1, 1.5, -1, 1, -1, 1), """
sphere material=1 center=-0.25,0,0 radius=0.55
box    material=1 center=0.55,0,0 size=1.3,0.9,0.075 rotation=0,14,0
"""),
}


def main(plugin, scene, path):
    need_files(plugin)
    names, dimensions, bounds, shapes = SCENES[scene]
    load_plugin(plugin, globals())  # defines VolumeFractionShapes
    source = VolumeFractionShapes(Shapes=shapes, Dimensions=dimensions, Bounds=bounds,
                                  Tolerance=1e-6)
    source.UpdatePipeline()
    image = servermanager.Fetch(source)
    for i, name in enumerate(names):
        image.GetCellData().GetArray("Material%d" % (i + 1)).SetName(name)
    writer = vtkXMLImageDataWriter()
    writer.SetInputData(image)
    writer.SetFileName(path)
    writer.SetDataModeToBinary()
    writer.SetCompressorTypeToZLib()
    if not writer.Write():
        sys.exit("cannot write " + path)


if __name__ == "__main__":
    if len(sys.argv) != 4 or sys.argv[2] not in SCENES:
        sys.exit(__doc__)
    main(*sys.argv[1:])
