#!/usr/bin/env pvpython
"""Meshes the regions of an atlas of the brain: the Harvard-Oxford cortex, 48 regions in voxels of
1 mm (NIfTI).

usage: pvpython atlas.py --plugin VolumeFractionMesh.so [--atlas FILE.nii.gz] [--every 2]
       [--mesh FILE.exo] [--picture FILE.png]

The atlas is in Debian's package mricron-data. The steps between voxels are smoothed, and regions
below 20 mm^3 are joined to their surroundings. Prints the number of hexahedra and the volume of
each region, the quality, the time and the memory. In .exo and .inp files, blocks and sets have the
names of the regions. The picture shows the front and back half with one colour per region; it needs
a screen or xvfb-run.
"""
import argparse
import gzip
import os
import resource
import struct
import sys
import tempfile
import time

from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import pictures
from load_plugin import load_plugin
from need_files import need_files

ATLAS = "/usr/share/mricron/templates/HarvardOxford-cort-maxprob-thr0-1mm.nii.gz"
SMOOTHING = 3  # passes
CRUMB = 20  # mm^3; smaller regions are removed
CUT, GAP = (0.0, -8.0, 0.0), 70.0  # mm; y points to the front
CAMERA, ASIDE, SIZE = (-1.6, 1.1, 0.7), 25.0, (1600, 1000)


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--plugin", required=True, help="path of VolumeFractionMesh.so")
    parser.add_argument("--atlas", default=ATLAS, help="image of labels (default: %(default)s)")
    parser.add_argument("--every", type=int, default=1, metavar="N",
                        help="use each N-th voxel along each axis (default: all)")
    parser.add_argument("--mesh", metavar="FILE", help="save the mesh: .exo, .inp or .vtu")
    parser.add_argument("--picture", metavar="FILE", help="save a picture of the regions, .png")
    return parser.parse_args()


def read_names(path):
    """Returns the names of labels, which MRIcron stores between header and values of an image. Each
    line has a label and its name."""
    with (gzip.open if path.endswith(".gz") else open)(path, "rb") as file:
        header = file.read(348)
        order = "<" if header[:4] == struct.pack("<i", 348) else ">"
        length = int(struct.unpack(order + "f", header[108:112])[0]) - 348
        return file.read(length).strip(b"\0 \r\n")


def make_mesher(arguments, names):
    """Returns the filter on the atlas. names: path of the table of names, or empty."""
    image = LabelImageReader(FileName=[arguments.atlas])
    image.UpdatePipeline()
    extent = image.GetDataInformation().GetExtent()
    n = arguments.every
    coarse = simple.ExtractSubset(Input=image, VOI=extent, SampleRateI=n, SampleRateJ=n,
                                  SampleRateK=n) if n > 1 else image
    coarse.UpdatePipeline()
    voxel = 1.0
    for edge in coarse.GetClientSideObject().GetOutputDataObject(0).GetSpacing():
        voxel *= edge
    return VolumeFractionToHex(
        Input=coarse, VolumeFractionArrays=[], MaterialIdArray="Labels", LabelNames=names,
        LabelSmoothing=SMOOTHING, MinimumRegionCells=round(CRUMB / voxel))


def field_of(mesh, name):
    array = mesh.GetFieldData().GetAbstractArray(name)
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())]


def print_report(mesh, seconds):
    materials = vtk_to_numpy(mesh.GetCellData().GetArray("MaterialId")).tolist()
    regions = list(zip(*(field_of(mesh, name) for name in (
        "MaterialIds", "MaterialNames", "MeshVolume", "VolumeError"))))
    print("region %-68s %10s %12s" % ("", "hexahedra", "cm^3"))
    for label, name, volume, _ in regions:
        print("%6d %-68s %10d %12.3f" % (label, name, materials.count(label), volume / 1000))
    quality = vtk_to_numpy(mesh.GetCellData().GetArray("ScaledJacobian"))
    print("%d regions, %d hexahedra, scaled Jacobian %.3f to 1, mean %.3f" % (
        len(regions), len(quality), quality.min(), quality.mean()))
    print("worst error of a volume %.1e; %d small regions of %d voxels removed" % (
        max(abs(error) for *_, error in regions), field_of(mesh, "RemovedRegions")[0],
        field_of(mesh, "RemovedCells")[0]))
    print("%.0f s, %.2f GB at most" % (
        seconds, resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 2 ** 20))


def colour_by_region(display, view):
    """Colours the mesh by region and shows the names at the right."""
    simple.ColorBy(display, ("CELLS", "MaterialId"))
    bar = simple.GetScalarBar(simple.GetColorTransferFunction("MaterialId"), view)
    bar.Title, bar.ComponentTitle = "", ""
    bar.LabelColor, bar.LabelFontSize = pictures.TEXT, 12
    bar.TextPosition = "Ticks left/bottom, annotations right/top"
    bar.WindowLocation, bar.Position = "Any Location", (0.72, 0.02)
    bar.ScalarBarThickness, bar.ScalarBarLength = 16, 0.96
    display.SetScalarBarVisibility(view, True)


def save_picture(mesher, path):
    """Saves a picture of both halves, with the front one moved forwards."""
    simple._DisableFirstRenderCameraReset()
    view = pictures.make_view(SIZE)
    for side in (-1, 1):
        display = pictures.show(pictures.cut(mesher, CUT, (0, side, 0)), view, edges=False)
        display.Position = (0, GAP, 0) if side > 0 else (0, 0, 0)
        colour_by_region(display, view)
    bounds = list(mesher.GetDataInformation().GetBounds())
    bounds[3] += GAP
    pictures.aim(view, bounds, CAMERA, 1.45, 0.0)
    # Moving the camera to the right moves the mesh to the left of the picture.
    right = [CAMERA[1] * -ASIDE, CAMERA[0] * ASIDE, 0]
    view.CameraFocalPoint = [a + b for a, b in zip(view.CameraFocalPoint, right)]
    view.CameraPosition = [a + b for a, b in zip(view.CameraPosition, right)]
    pictures.save(view, path)


def main():
    arguments = parse_arguments()
    if arguments.atlas == ATLAS and not os.path.exists(ATLAS):
        sys.exit("atlas.py: %s is missing: apt-get install mricron-data, or name another image of "
                 "labels (--atlas)" % ATLAS)
    need_files(arguments.plugin, arguments.atlas)
    load_plugin(arguments.plugin, globals())  # defines VolumeFractionToHex and the other names
    names = read_names(arguments.atlas)
    with tempfile.NamedTemporaryFile(suffix=".txt") as table:
        table.write(names)
        table.flush()
        start = time.time()
        mesher = make_mesher(arguments, table.name if names else "")
        mesher.UpdatePipeline()
        mesh = mesher.GetClientSideObject().GetOutputDataObject(0)
        if mesh.GetNumberOfCells() == 0:
            sys.exit("atlas.py: no mesh was made")
        print_report(mesh, time.time() - start)
        if arguments.mesh:
            simple.SaveData(arguments.mesh, proxy=mesher)
        if arguments.picture:
            save_picture(mesher, arguments.picture)


main()
