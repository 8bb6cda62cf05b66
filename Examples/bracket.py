"""Meshes a bracket from the volume fractions of a surface of triangles, with edges rounded and with
edges found in the fractions. Prints the distance of the true edges from both meshes, in cells.

usage: pvbatch Examples/bracket.py OUT [--cells N] [--plugin PLUGIN.so] [--no-pictures]

Writes bracket.stl, the meshes bracket_off.vtu and bracket_on.vtu and pictures of both into OUT.
Pictures need an X server.
"""
import argparse
import math
import os
import sys

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import mutable, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData, vtkStaticCellLocator

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)
import bracket_stl
from load_plugin import load_plugin

SIZE = (60.0, 40.0, 50.0)
COLOUR = (0.72, 0.76, 0.82)


def quads_of(surfaces):
    """Returns the points (n, 3) and quads (m, 4) of a surface."""
    return (vtk_to_numpy(surfaces.GetPoints().GetData()),
            vtk_to_numpy(surfaces.GetPolys().GetConnectivityArray()).reshape(-1, 4))


def make_locator(points, quads):
    """Returns a locator of the four triangles around the centre of each quad, with its data."""
    count = len(points)
    centres = count + np.arange(len(quads))
    triangles = np.concatenate([np.stack([quads[:, c], quads[:, (c + 1) % 4], centres], axis=1)
                                for c in range(4)])
    data, cells, places = vtkPolyData(), vtkCellArray(), vtkPoints()
    places.SetData(numpy_to_vtk(np.concatenate([points, points[quads].mean(axis=1)]).astype(float),
                                deep=True))
    cells.SetData(3, numpy_to_vtkIdTypeArray(triangles.astype(np.int64).ravel(), deep=True))
    data.SetPoints(places)
    data.SetPolys(cells)
    locator = vtkStaticCellLocator()
    locator.SetDataSet(data)
    locator.BuildLocator()
    return data, locator


def distances(locator, points):
    nearest, cell, part, square, found = [0.0] * 3, mutable(0), mutable(0), mutable(0.0), []
    for point in points:
        locator.FindClosestPoint(point, nearest, cell, part, square)
        found.append(math.sqrt(square.get()))
    return np.array(found)


def rms(values):
    return math.sqrt(np.mean(np.square(values)))


def mesh_of(fractions, mode):
    return VolumeFractionToHex(Input=fractions, VolumeFractionArrays=["Material1"], SharpEdges=mode,
                               SurfaceTargets="Off")  # edges found in the fractions


def measure(mode, mesh, width):
    """Prints a row of the table and returns the points of the surface."""
    surface = servermanager.Fetch(mesh, idx=1)
    points, quads = quads_of(surface)
    data, locator = make_locator(points, quads)
    found = {kind: distances(locator, samples) / width
             for kind, samples in bracket_stl.edges(0.1 * width).items()}
    fillets = [d / width for d in map(bracket_stl.from_fillet, points) if d is not None]
    field = servermanager.Fetch(mesh, idx=0).GetFieldData()
    quality = [field.GetArray(name).GetValue(0)
               for name in ("MinimumScaledJacobian", "MeanScaledJacobian")]
    print("| %s | %.3f/%.3f | %s | %s | %.4f/%.4f |" % (
        mode, *quality,
        *("%.3f/%.3f (%.3f)" % (d.max(), rms(d), np.percentile(d, 99))
          for d in (found["edges"], found["rims"])),
        max(fillets), rms(fillets)), flush=True)
    return points


def picture(mesh, path):
    import pictures
    view = pictures.make_view((1600, 1200))
    pictures.show(simple.OutputPort(mesh, 1), view, COLOUR)
    pictures.aim(view, (0.0, SIZE[0], 0.0, SIZE[1], 0.0, SIZE[2]), (1.0, -0.9, 0.75), 1.0)
    pictures.save(view, path)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out")
    parser.add_argument("--cells", type=int, default=96,
                        help="number of cells along the longest side (default: %(default)s)")
    parser.add_argument("--plugin",
                        default=os.path.join(HERE, "..", "build", "lib", "VolumeFractionMesh.so"))
    parser.add_argument("--no-pictures", action="store_true")
    arguments = parser.parse_args()
    load_plugin(arguments.plugin, globals())
    simple._DisableFirstRenderCameraReset()
    os.makedirs(arguments.out, exist_ok=True)
    stl = os.path.join(arguments.out, "bracket.stl")
    bracket_stl.write_stl(stl, bracket_stl.bracket())
    width = SIZE[0] / (arguments.cells - 4)  # leaves a margin of two cells on each side
    fractions = VolumeFractionOfSurface(
        Input=simple.STLReader(FileNames=[stl]),
        Dimensions=[math.ceil(size / width) + 4 for size in SIZE])
    print("| SharpEdges | scaled Jacobian min/mean | edges to mesh max/rms (p99) | rims of holes "
          "| fillets to truth |\n|---|---|---|---|---|")
    points = {}
    for mode in ("Off", "On"):
        mesh = mesh_of(fractions, mode)
        points[mode] = measure(mode, mesh, width)
        name = os.path.join(arguments.out, "bracket_" + mode.lower())
        simple.SaveData(name + ".vtu", proxy=mesh, DataMode="Binary")
        if not arguments.no_pictures:
            picture(mesh, name + ".png")
    moved = np.linalg.norm(points["On"] - points["Off"], axis=1) / width
    moved = moved[[bracket_stl.from_fillet(point) is not None for point in points["Off"]]]
    curves = vtk_to_numpy(servermanager.Fetch(mesh, idx=2).GetPoints().GetData())
    print("of %d points on fillets %d moved by more than 0.02 cells, at most %.3f, "
          "along the surface; on curves there: %d" % (
        len(moved), np.sum(moved > 0.02), moved.max(),
        sum(bracket_stl.from_fillet(point) is not None for point in curves)))
    print("surfaces, curves and vertices: %d, %d, %d" % tuple(
        servermanager.Fetch(mesh, idx=0).GetFieldData().GetArray("NumberOf" + name).GetValue(0)
        for name in ("Surfaces", "Curves", "Vertices")))


if __name__ == "__main__":
    main()
