"""Draws streamlines in the pores of a case that porous_flow.py or permeability.py solved.

usage: pvbatch porous_streamlines.py [--zoom 1.1] CASE/mesh.foam FILE.png

One half of the wall is shown. The colour of the streamlines is the speed, relative to its maximum.
Needs an X server.
"""
import argparse
import os
import sys

from paraview import simple

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import pictures
from need_files import need_files

SIZE = (540, 460)
WALL = (0.80, 0.77, 0.70)
LINES = 240


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("case", help="file .foam of the case")
    parser.add_argument("picture", help="file to write, .png")
    parser.add_argument("--zoom", type=float, default=1.1)
    return parser.parse_args()


def read(case, regions):
    """Returns these regions of the case at its last time."""
    reader = simple.OpenFOAMReader(FileName=case, MeshRegions=regions, CellArrays=["U"],
                                   Createcelltopointfiltereddata=1)
    reader.UpdatePipelineInformation()
    last = max(reader.TimestepValues)
    reader.UpdatePipeline(last)
    simple.GetAnimationScene().AnimationTime = last
    return reader


def wall_names(case):
    """Returns the patches of the wall."""
    reader = simple.OpenFOAMReader(FileName=case)
    reader.UpdatePipelineInformation()
    return [name for name in reader.MeshRegions.Available if "_to_Void" in name]


def main():
    arguments = parse_arguments()
    need_files(arguments.case)
    pores = read(arguments.case, ["internalMesh"])
    wall = read(arguments.case, wall_names(arguments.case))
    bounds = pores.GetDataInformation().GetBounds()
    speed = simple.Calculator(Input=pores, AttributeType="Point Data", Function="mag(U)",
                              ResultArrayName="speed")
    speed.UpdatePipeline()
    fastest = speed.PointData["speed"].GetRange()[1]
    relative = simple.Calculator(Input=pores, AttributeType="Point Data",
                                 Function="mag(U)/%.17g" % fastest, ResultArrayName="Speed")
    size = max(bounds[1::2])
    lines = simple.StreamTracer(Input=relative, SeedType="Point Cloud", Vectors=["POINTS", "U"],
                                MaximumStreamlineLength=10 * size)
    lines.SeedType.Center = [size / 2] * 3
    lines.SeedType.Radius, lines.SeedType.NumberOfPoints = 0.8 * size, LINES
    tubes = simple.Tube(Input=lines, Radius=0.004 * size, NumberofSides=8)
    half = simple.Clip(Input=wall, ClipType="Plane", Invert=0)
    half.ClipType.Origin, half.ClipType.Normal = [size / 2] * 3, [0, 1, 0]
    view = pictures.make_view(SIZE)
    simple._DisableFirstRenderCameraReset()
    view.BackgroundColorMode, view.Background = "Single Color", (1.0, 1.0, 1.0)
    pictures.show(half, view, WALL, edges=False)
    display = pictures.show(tubes, view, edges=False)
    pictures.colour_by(display, view, "Speed", "Speed / largest speed", 0.0, kind="POINTS")
    bar = simple.GetScalarBar(simple.GetColorTransferFunction("Speed"), view)
    bar.TitleFontSize, bar.LabelFontSize, bar.ScalarBarThickness, bar.Position = (
        20, 16, 14, (0.25, 0.01))
    pictures.aim(view, bounds, (-0.3, -1.0, 0.35), arguments.zoom, 0.25)
    pictures.save(view, arguments.picture)


if __name__ == "__main__":
    main()
