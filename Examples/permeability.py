"""Computes Stokes flow through a cubic array of spheres by OpenFOAM on a periodic mesh.

usage: python permeability.py [--cells 32] [--solid 0.064 0.125 0.216] [--sides flat|free]
       [--at corner|middle] [--extrapolate] [--folder FOLDER] [--picture FILE.png]

The mesh is the fluid in one cube of the array, periodic along x, y, z: opposite sides are patches
of type cyclic. A sphere is in the middle of the cube, or an eighth of it at each corner. A body
force on the fluid drives slow flow along x, which simpleFoam computes; spheres do not slip.

The drag coefficient K is the force on a sphere, body force x volume of the cube, divided by Stokes'
drag 6 pi viscosity x radius x mean velocity in the cube. It is compared with table 2 of A. A. Zick
and G. M. Homsy, Stokes flow through periodic arrays of spheres, Journal of Fluid Mechanics 115
(1982) 13-26. The permeability in squares of the radius is 2 / (9 x solid fraction x K).

Prints a row per solid fraction: elements, relative error of the volume of the mesh, failed checks
by checkMesh, permeability, K, K of the table and the relative difference, change of K in the last
steps, and CPU seconds of simpleFoam. --extrapolate: also meshes two thirds as many cells along
each axis, and prints the limit of K for small cells. The picture, of the last fraction, requires
pvbatch. Requires
volume_fraction_mesh and OpenFOAM (Debian: openfoam).
"""
import argparse
import os
import shutil
import subprocess
import sys
import tempfile

import numpy as np

import volume_fraction_mesh as vfm

import openfoam
from porous_flow import (SCHEMES, STEADY, TRANSPORT, TURBULENCE, cpu_seconds, find_number)

PUBLISHED = {0.027: 2.008, 0.064: 2.810, 0.125: 4.292, 0.216: 7.442, 0.343: 15.4, 0.45: 28.1}
FORCE = 1e-3  # on a unit of volume; density, viscosity and the width of the cube are 1
STEPS = 500  # of simpleFoam
CONTROL = """application simpleFoam; startFrom startTime; startTime 0; stopAt endTime;
endTime %d; deltaT 1; writeControl timeStep; writeInterval %d; writeFormat ascii;
writePrecision 12; runTimeModifiable false;
functions
{
  flow { type volFieldValue; libs ("libfieldFunctionObjects.so"); regionType all;
    operation volIntegrate; fields (U); writeFields false; writePrecision 12; }
}
""" % (STEPS, STEPS)
SOLUTION = """solvers
{
  p { solver GAMG; smoother GaussSeidel; tolerance 1e-14; relTol 0.01; }
  U { solver smoothSolver; smoother symGaussSeidel; tolerance 1e-14; relTol 0.01; }
}
SIMPLE { consistent yes; nNonOrthogonalCorrectors 1; pRefCell 0; pRefValue 0; }
relaxationFactors { equations { U 0.95; } }
"""
OPTIONS = """force
{
  type vectorSemiImplicitSource; selectionMode all; volumeMode specific;
  injectionRateSuSp { U ((%g 0 0) 0); }
}
""" % FORCE
VELOCITY = """dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0);
boundaryField { "[xyz]_m.*" { type cyclic; } "fluid.*" { type noSlip; } }
"""
PRESSURE = """dimensions [0 2 -2 0 0 0 0]; internalField uniform 0;
boundaryField { "[xyz]_m.*" { type cyclic; } "fluid.*" { type zeroGradient; } }
"""
ROW = "%-7s %9s %9s %9s %9s %8s %8s %8s %7s %7s"


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cells", type=int, default=32,
                        help="cells of the cube along an axis, even")
    parser.add_argument("--solid", type=float, nargs="+", default=[0.064, 0.125, 0.216],
                        choices=PUBLISHED, help="volume fractions of the spheres")
    parser.add_argument("--sides", choices=("flat", "free"), default="flat")
    parser.add_argument("--at", choices=("corner", "middle"), default="corner",
                        help="position of the sphere (default: corner)")
    parser.add_argument("--extrapolate", action="store_true",
                        help="mesh two grids, and print the limit of K for small cells")
    parser.add_argument("--folder", help="keep the cases of OpenFOAM in this folder")
    parser.add_argument("--picture", metavar="FILE", help="streamlines, .png")
    return parser.parse_args()


def radius_of(solid):
    return (3 * solid / (4 * np.pi)) ** (1 / 3)


def make_fluid(solid, cells, at):
    """Returns the volume fractions of the fluid in the unit cube."""
    sphere = "sphere radius=%.17g center=0.5,0.5,0.5" % radius_of(solid)
    fractions = vfm.shapes(sphere, 3 * [cells], bounds=(0, 1, 0, 1, 0, 1), tolerance=1e-6)
    shift = cells // 2 if at == "corner" else 0
    return 1 - np.roll(next(iter(fractions.values())), 3 * [shift], (0, 1, 2))


def write_case(folder):
    """Writes all files of a case except the mesh."""
    openfoam.write(folder, "system/controlDict", CONTROL)
    openfoam.write(folder, "system/fvSchemes", SCHEMES)
    openfoam.write(folder, "system/fvSolution", SOLUTION)
    openfoam.write(folder, "system/fvOptions", OPTIONS)
    openfoam.write(folder, "constant/transportProperties", TRANSPORT)
    openfoam.write(folder, "constant/turbulenceProperties", TURBULENCE)
    openfoam.write(folder, "0/U", VELOCITY, "volVectorField")
    openfoam.write(folder, "0/p", PRESSURE, "volScalarField")


def read_velocities(folder):
    """Returns the mean velocity along x in the cube after each step."""
    path = os.path.join(folder, "postProcessing", "flow", "0", "volFieldValue.dat")
    with open(path, encoding="ascii") as file:
        return [float(line.replace("(", " ").split()[1]) for line in file if line[0] != "#"]


def measure(solid, cells, folder, arguments):
    """Meshes and solves a solid fraction. Prints a row, and returns the drag coefficient."""
    fluid = make_fluid(solid, cells, arguments.at)
    write_case(folder)
    mesh = vfm.hexes({"fluid": fluid}, spacing=3 * [1 / cells], periodic="xyz",
                     periodic_sides=arguments.sides)
    mesh.save(os.path.join(folder, "mesh.foam"))
    report = openfoam.run(openfoam.CHECKS, folder)
    problems = openfoam.find_problems(report)
    begin = cpu_seconds()
    shutil.rmtree(os.path.join(folder, "postProcessing"), ignore_errors=True)  # of an earlier run
    openfoam.run("simpleFoam", folder)
    solving = cpu_seconds() - begin
    velocities = read_velocities(folder)
    change = abs(velocities[-1 - STEPS // 10] / velocities[-1] - 1)
    if not change < STEADY:
        sys.exit("permeability.py: the flow still changes by %.1e: more STEPS" % change)
    drag = FORCE / (6 * np.pi * radius_of(solid) * velocities[-1])
    print(ROW % ("%.3f" % solid, "%d" % len(mesh.cells),
                 "%+.4f%%" % (100 * (find_number("Total volume", report) / (1 - solid) - 1)),
                 "%d failed" % len(problems) if problems else "Mesh OK",
                 "%.5g" % (2 / (9 * solid * drag)), "%.4f" % drag, "%.5g" % PUBLISHED[solid],
                 "%+.2f%%" % (100 * (drag / PUBLISHED[solid] - 1)), "%.0e" % change,
                 "%.0f" % solving), flush=True)
    for problem in problems:
        print("    checkMesh: " + problem.strip(), flush=True)
    return drag


def extrapolate(solid, drag, folder, arguments):
    """Prints the drag coefficient for cells of no width: the error falls with the square of the
    width. drag: on the given cells."""
    cells = arguments.cells * 2 // 3 // 2 * 2
    coarse = measure(solid, cells, folder, arguments)
    limit = drag + (drag - coarse) / ((arguments.cells / cells) ** 2 - 1)
    print("    K of %d and %d cells, extrapolated: %.4f, error %+.2f%%" % (
        cells, arguments.cells, limit, 100 * (limit / PUBLISHED[solid] - 1)), flush=True)


def run(arguments, folder):
    print("%d x %d x %d cells, sides %s, sphere: %s" % (*3 * [arguments.cells], arguments.sides,
                                                        arguments.at))
    print(ROW % ("solid", "elements", "volume", "checkMesh", "permeab.", "K", "table", "error",
                 "change", "solve s"))
    for solid in arguments.solid:
        case = os.path.join(folder, "%.3f" % solid)
        drag = measure(solid, arguments.cells, case, arguments)
        if arguments.extrapolate:
            extrapolate(solid, drag, case + "_coarse", arguments)
    if arguments.picture:
        script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "porous_streamlines.py")
        subprocess.run(["pvbatch", script, "--zoom", "0.95", os.path.join(case, "mesh.foam"),
                        arguments.picture], check=True)


def main():
    arguments = parse_arguments()
    if not openfoam.is_installed():
        sys.exit("permeability.py: there is no OpenFOAM: install Debian's openfoam")
    if arguments.cells % 2:
        sys.exit("permeability.py: the number of cells must be even")
    with tempfile.TemporaryDirectory() as folder:
        run(arguments, arguments.folder or folder)


if __name__ == "__main__":
    main()
