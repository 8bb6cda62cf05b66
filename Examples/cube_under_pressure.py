#!/usr/bin/env pvpython
"""Loads one face of a machined part: a rotated cube of steel, clamped at the face towards -x and
pressed on the face towards +x. Volume fractions contain no faces. SharpEdges finds them, and the
table of surfaces identifies them.

usage: pvpython cube_under_pressure.py --plugin VolumeFractionMesh.so [--cells 32] [--tets Lattice]
       [--out DIR]

Writes the mesh, OUT/cube.inp, and the input of CalculiX, OUT/press.inp, which includes the mesh and
gives material, support and load. Prints the surfaces. If CalculiX is installed (Debian:
calculix-ccx), also prints the reaction at the clamped face and the pressure times the true area.
"""
import argparse
import os
import shutil
import sys

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import calculix
from load_plugin import load_plugin
from need_files import need_files

EDGE = 1.2  # metres, in a grid from -1.3 to 1.3
SHAPES = "box size=%g,%g,%g rotation=25,20,15 material=1" % (EDGE, EDGE, EDGE)
MATERIALS = {"MATERIAL1": (210e9, 0.3)}  # steel: Young's modulus in Pa, Poisson's ratio
PRESSURE = 10e6  # Pa


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--plugin", required=True, help="path of VolumeFractionMesh.so")
    parser.add_argument("--cells", type=int, default=32,
                        help="number of cells along each axis (default: 32)")
    parser.add_argument("--tets", choices=("TetGen", "Cells", "Lattice"),
                        help="make tetrahedra with this method instead of hexahedra")
    parser.add_argument("--out", default=".",
                        help="folder of the files (default: the current folder)")
    return parser.parse_args()


def make_mesher(arguments):
    field = VolumeFractionShapes(Shapes=SHAPES, Bounds=[-1.3, 1.3] * 3,
                                 Dimensions=[arguments.cells] * 3)
    options = dict(Input=field, VolumeFractionArrays=["Material1"], SharpEdges="On")
    return (VolumeFractionToTet(Method=arguments.tets, **options) if arguments.tets
            else VolumeFractionToHex(**options))


class Surfaces:
    """Table of surfaces: areas (m^2), centroids, and mean normals that point out of the part."""

    def __init__(self, mesher):
        field = servermanager.Fetch(mesher, idx=1).GetFieldData()
        self.areas, self.centroids, self.normals = (
            vtk_to_numpy(field.GetArray("Surface" + name))
            for name in ("Areas", "Centroids", "Normals"))

    def find(self, direction):
        """Returns the number of the surface whose mean normal is nearest to a direction. The mean
        normal of a closed surface is short."""
        return int(np.argmax(self.normals @ direction)) + 1

    def show(self):
        for s, (area, centroid, normal) in enumerate(
                zip(self.areas, self.centroids, self.normals), 1):
            print("MATERIAL1_TO_VOID_%d: area %.4f m^2, centroid (%5.2f %5.2f %5.2f), "
                  "normal (%5.2f %5.2f %5.2f)" % (s, area, *centroid, *normal))


def main():
    arguments = parse_arguments()
    need_files(arguments.plugin)
    load_plugin(arguments.plugin, globals())  # defines VolumeFractionToHex and the other names
    os.makedirs(arguments.out, exist_ok=True)
    mesh, deck = (os.path.join(arguments.out, name) for name in ("cube.inp", "press.inp"))
    mesher = make_mesher(arguments)
    simple.SaveData(mesh, proxy=mesher)
    surfaces = Surfaces(mesher)
    surfaces.show()
    clamped, loaded = surfaces.find([-1, 0, 0]), surfaces.find([1, 0, 0])
    support, load = ("MATERIAL1_TO_VOID_%d" % s for s in (clamped, loaded))
    calculix.write_deck(deck, mesh, MATERIALS, [(support, 1, 3, 0)], pressures=[(load, PRESSURE)],
                        reactions=[support])
    if not shutil.which("ccx"):
        sys.exit("wrote %s and %s; CalculiX (ccx) is not installed" % (mesh, deck))
    calculix.run(deck, threads=os.cpu_count())
    results = calculix.read_results(deck)
    reaction = results.reactions[support]
    exact = PRESSURE * EDGE ** 2
    print("%d elements, %s clamped, %s loaded: reaction %.6g N, pressure times area of the face "
          "%.6g N (%+.2f %%), of its facets %.6g N" % (
        len(results.stresses), support, load, np.linalg.norm(reaction), exact,
        100 * (np.linalg.norm(reaction) / exact - 1),
        PRESSURE * surfaces.areas[loaded - 1] * np.linalg.norm(surfaces.normals[loaded - 1])))


if __name__ == "__main__":
    main()
