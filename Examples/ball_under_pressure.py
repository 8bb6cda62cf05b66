#!/usr/bin/env pvpython
"""Computes stresses from volume fractions: a steel ball in a block of epoxy, pressed from above.

usage: pvpython ball_under_pressure.py --plugin VolumeFractionMesh.so [--cells 24] [--tets Lattice]
       [--out DIR] [--picture FILE.png]

Writes the mesh, OUT/ball.inp, and the input of CalculiX, OUT/press.inp, which includes the mesh and
gives materials, supports and load. If CalculiX is installed (Debian: calculix-ccx), solves it and
writes OUT/press.vtu: the mesh with Displacement, the mean Stress per element (Pa; xx yy zz xy xz
yz) and VonMises. The picture shows half of the mesh, coloured by von Mises stress; it needs a
screen or xvfb-run.
"""
import argparse
import os
import shutil
import sys

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import calculix
import pictures
from load_plugin import load_plugin
from need_files import need_files

# The block reaches from -1 to 1 m.
SHAPES = "sphere radius=0.5 material=1; box size=2,2,2 material=2"
# Steel and epoxy: Young's modulus in Pa, Poisson's ratio.
MATERIALS = {"MATERIAL1": (210e9, 0.3), "MATERIAL2": (3e9, 0.35)}
PRESSURE = 10e6  # Pa, on the upper side
# These sides can move only within their planes.
SUPPORTS = [("Z_MIN", 3, 3, 0), ("X_MIN", 1, 1, 0), ("Y_MIN", 2, 2, 0)]


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--plugin", required=True, help="path of VolumeFractionMesh.so")
    parser.add_argument("--cells", type=int, default=24,
                        help="number of cells along each axis (default: 24)")
    parser.add_argument("--tets", choices=("TetGen", "Cells", "Lattice"),
                        help="make tetrahedra with this method instead of hexahedra")
    parser.add_argument("--out", default=".",
                        help="folder of the files (default: the current folder)")
    parser.add_argument("--picture", metavar="FILE", help="save a picture of the stress, .png")
    return parser.parse_args()


def make_mesher(arguments):
    field = VolumeFractionShapes(Shapes=SHAPES, Bounds=[-1, 1] * 3,
                                 Dimensions=[arguments.cells] * 3)
    options = dict(Input=field, VolumeFractionArrays=["Material1", "Material2"])
    return (VolumeFractionToTet(Method=arguments.tets, **options) if arguments.tets
            else VolumeFractionToHex(**options))


def von_mises(stress):
    xx, yy, zz, xy, xz, yz = stress.T
    return np.sqrt(((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2) / 2
                   + 3 * (xy ** 2 + xz ** 2 + yz ** 2))


def add_values(data, name, values):
    """Adds an array to the points or cells of the mesh. values: one row per node or element in the
    order of the numbers in the file, which is the order of global ids."""
    ids = vtk_to_numpy(data.GetGlobalIds())
    array = numpy_to_vtk(np.ascontiguousarray(values[np.searchsorted(np.sort(ids), ids)]), deep=1)
    array.SetName(name)
    data.AddArray(array)


def save_results(mesh, results, path):
    stress = results.stresses.mean(axis=1)
    add_values(mesh.GetPointData(), "Displacement", results.displacements)
    add_values(mesh.GetCellData(), "Stress", stress)
    add_values(mesh.GetCellData(), "VonMises", von_mises(stress))
    writer = vtkXMLUnstructuredGridWriter()
    writer.SetInputData(mesh)
    writer.SetFileName(path)
    writer.SetDataModeToBinary()
    if not writer.Write():
        sys.exit("cannot write " + path)


def save_picture(vtu, path):
    """Saves a picture of the elements behind the plane x = 0, coloured by von Mises stress in
    MPa."""
    stress = simple.Calculator(Input=simple.OpenDataFile(vtu), AttributeType="Cell Data",
                               Function="VonMises/1000000",
                               ResultArrayName="von Mises stress [MPa]")
    half = simple.Clip(Input=stress, ClipType="Plane", Crinkleclip=1, Invert=1)
    half.ClipType.Origin, half.ClipType.Normal = [0.001, 0, 0], [1, 0, 0]
    view = simple.CreateRenderView(ViewSize=[1100, 900], Background=[1, 1, 1],
                                   UseColorPaletteForBackground=0, OrientationAxesVisibility=0)
    shown = simple.Show(half, view, Representation="Surface With Edges",
                        EdgeColor=[0.15, 0.15, 0.15], Ambient=0.6,
                        Diffuse=0.45, Interpolation="Flat")
    simple.ColorBy(shown, ("CELLS", "von Mises stress [MPa]"))
    shown.RescaleTransferFunctionToDataRange()
    colours = simple.GetColorTransferFunction("von Mises stress [MPa]")
    colours.ApplyPreset(pictures.VIRIDIS, True)
    bar = simple.GetScalarBar(colours, view)
    bar.TitleColor = bar.LabelColor = [0, 0, 0]
    bar.WindowLocation, bar.Position, bar.ScalarBarLength = "Any Location", [0.88, 0.3], 0.45
    bar.RangeLabelFormat, bar.LabelFormat, bar.AutomaticLabelFormat = (
        pictures.number_format(1), pictures.number_format(0), 0)
    shown.SetScalarBarVisibility(view, True)
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = (
        [4.3, 2.1, 1.7], [-0.2, 0.2, -0.05], [0, 0, 1])
    simple.SaveScreenshot(path, view)


def main():
    arguments = parse_arguments()
    need_files(arguments.plugin)
    load_plugin(arguments.plugin, globals())  # defines VolumeFractionToHex and the other names
    os.makedirs(arguments.out, exist_ok=True)
    mesh, deck, vtu = (os.path.join(arguments.out, name)
                       for name in ("ball.inp", "press.inp", "press.vtu"))
    mesher = make_mesher(arguments)
    simple.SaveData(mesh, proxy=mesher)
    calculix.write_deck(deck, mesh, MATERIALS, SUPPORTS, pressures=[("Z_MAX", PRESSURE)],
                        reactions=["Z_MIN"])
    if not shutil.which("ccx"):
        sys.exit("wrote %s and %s; CalculiX (ccx) is not installed" % (mesh, deck))
    calculix.run(deck, threads=os.cpu_count())
    results = calculix.read_results(deck)
    save_results(mesher.GetClientSideObject().GetOutputDataObject(0), results, vtu)
    print("%s: %d elements, sinks by %.4g m, highest von Mises stress %.4g Pa, "
          "reaction below %.6g N" % (
        vtu, len(results.stresses), -results.displacements[:, 2].min(),
        von_mises(results.stresses.mean(axis=1)).max(), results.reactions["Z_MIN"][2]))
    if arguments.picture:
        save_picture(vtu, arguments.picture)


if __name__ == "__main__":
    main()
