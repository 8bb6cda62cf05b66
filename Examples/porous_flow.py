"""Computes the permeability of pores in a label image by OpenFOAM, on this mesh and on that of
snappyHexMesh.

usage: python porous_flow.py [--case pores|round|square] [--cells 48] [--refine 0] [--seed 1]
       [--no-snappy] [--folder FOLDER] [--picture FILE.png]

The case "pores" is an image of labels from smoothed noise: pores in 60 % of the volume, of which
those that connect x_min to x_max stay. "round" and "square" are straight ducts, whose flow rate is
known. The Python package meshes the pores and writes the case of OpenFOAM. snappyHexMesh starts
from blocks of the same cells and cuts them along the wall of the first mesh, written as .stl.

simpleFoam computes laminar flow: a small difference of pressure between x_min and x_max, no slip
on the wall, slip on the other sides. The permeability is viscosity x flow rate x length / (area of
the box x difference of pressure), in squares of a cell of the image.

Prints a row per mesh: elements and the part of hexahedra, CPU seconds to make the mesh, relative
error of its volume against the image, failed checks and connected regions by checkMesh, largest
non-orthogonality and skewness, permeability, difference of inflow and outflow and change in the
last steps, both relative to inflow, and the CPU seconds of simpleFoam. Lines below name the failed
checks and compare with the exact permeability of a duct. The picture, of the first mesh, requires
pvbatch. Requires volume_fraction_mesh and OpenFOAM (Debian: openfoam).
"""
import argparse
import os
import re
import resource
import subprocess
import sys
import tempfile

import numpy as np

import volume_fraction_mesh as vfm

import openfoam

SIDES = ("x_min", "x_max", "y_min", "y_max", "z_min", "z_max")
PORES = 0.6  # of the volume
DUCT = 2 / 3  # width of a duct, relative to the width of the box
DROP = 1e-3  # of pressure per length of a cell; the Reynolds number is about 1e-3
STEPS = 200  # of simpleFoam
STEADY = 1e-4  # largest change of the flow rate in the last tenth of the steps, relative
CONTROL = """application simpleFoam; startFrom startTime; startTime 0; stopAt endTime;
endTime %d; deltaT 1; writeControl timeStep; writeInterval %d; writeFormat ascii;
writePrecision 12; runTimeModifiable false;
functions
{
  inflow { type surfaceFieldValue; libs ("libfieldFunctionObjects.so"); regionType patch;
    name x_min; operation sum; fields (phi); writeFields false; writePrecision 12; }
  outflow { $inflow; name x_max; }
}
"""
SCHEMES = """ddtSchemes { default steadyState; }
gradSchemes { default leastSquares; }
divSchemes { default none; div(phi,U) bounded Gauss linearUpwind grad(U);
  div((nuEff*dev2(T(grad(U))))) Gauss linear; }
laplacianSchemes { default Gauss linear corrected; }
interpolationSchemes { default linear; }
snGradSchemes { default corrected; }
"""
SOLUTION = """solvers
{
  p { solver GAMG; smoother GaussSeidel; tolerance 1e-14; relTol 0.01; }
  U { solver smoothSolver; smoother symGaussSeidel; tolerance 1e-14; relTol 0.01; }
}
SIMPLE { consistent yes; nNonOrthogonalCorrectors 1; }
relaxationFactors { equations { U 0.95; } }
"""
TRANSPORT = "transportModel Newtonian; nu [0 2 -1 0 0 0 0] 1;\n"
TURBULENCE = "simulationType laminar;\n"
VELOCITY = """dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0);
boundaryField { "x_m.*" { type zeroGradient; } "[yz]_m.*" { type slip; }
  "pores.*" { type noSlip; } }
"""
PRESSURE = """dimensions [0 2 -2 0 0 0 0]; internalField uniform 0;
boundaryField { x_min { type fixedValue; value uniform %g; }
  x_max { type fixedValue; value uniform 0; } ".*" { type zeroGradient; } }
"""
BLOCKS = """convertToMeters 1;
vertices ((0 0 0) ({0} 0 0) ({0} {1} 0) (0 {1} 0) (0 0 {2}) ({0} 0 {2}) ({0} {1} {2}) (0 {1} {2}));
blocks (hex (0 1 2 3 4 5 6 7) ({3} {4} {5}) simpleGrading (1 1 1));
edges (); mergePatchPairs ();
boundary (
  x_min {{ type patch; faces ((0 4 7 3)); }} x_max {{ type patch; faces ((1 2 6 5)); }}
  y_min {{ type patch; faces ((0 1 5 4)); }} y_max {{ type patch; faces ((3 7 6 2)); }}
  z_min {{ type patch; faces ((0 3 2 1)); }} z_max {{ type patch; faces ((4 5 6 7)); }}
);
"""
SNAPPY = """castellatedMesh true; snap true; addLayers false; mergeTolerance 1e-6;
geometry {{ wall.stl {{ type triSurfaceMesh; name pores; }} }}
castellatedMeshControls {{ maxLocalCells 10000000; maxGlobalCells 10000000; minRefinementCells 0;
  nCellsBetweenLevels 1; features (); refinementSurfaces {{ pores {{ level (0 0); }} }}
  resolveFeatureAngle 30; refinementRegions {{ }} locationInMesh ({} {} {});
  allowFreeStandingZoneFaces false; }}
snapControls {{ nSmoothPatch 3; tolerance 2; nSolveIter 30; nRelaxIter 5; nFeatureSnapIter 10;
  implicitFeatureSnap false; explicitFeatureSnap false; multiRegionFeatureSnap false; }}
addLayersControls {{ relativeSizes true; layers {{ }} expansionRatio 1; finalLayerThickness 0.3;
  minThickness 0.1; nGrow 0; featureAngle 60; nRelaxIter 3; nSmoothSurfaceNormals 1;
  nSmoothNormals 3; nSmoothThickness 10; maxFaceThicknessRatio 0.5;
  maxThicknessToMedialRatio 0.3; minMedianAxisAngle 90; nBufferCellsNoExtrude 0; nLayerIter 50; }}
meshQualityControls {{ maxNonOrtho 65; maxBoundarySkewness 20; maxInternalSkewness 4;
  maxConcave 80; minVol 1e-13; minTetQuality 1e-15; minArea -1; minTwist 0.02;
  minDeterminant 0.001; minFaceWeight 0.05; minVolRatio 0.01; minTriangleTwist -1;
  nSmoothScale 4; errorReduction 0.75; }}
"""
ROW = "%-14s %8s %5s %6s %9s %9s %7s %6s %5s %9s %8s %7s %7s"


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--case", choices=("pores", "round", "square"), default="pores")
    parser.add_argument("--cells", type=int, default=48,
                        help="cells of the image along y and z, of pores also along x")
    parser.add_argument("--refine", type=int, default=0,
                        help="number of times that both meshers halve the cells (default: 0)")
    parser.add_argument("--seed", type=int, default=1, help="of the noise (default: 1)")
    parser.add_argument("--no-snappy", action="store_true", help="only the first mesh")
    parser.add_argument("--folder", help="keep the cases of OpenFOAM in this folder")
    parser.add_argument("--picture", metavar="FILE", help="streamlines, .png")
    return parser.parse_args()


def connect(pores):
    """Returns the pores that are connected by faces to both x_min and x_max."""
    kept = pores
    for end in (0, -1):
        found = np.zeros_like(kept)
        found[end] = kept[end]
        count = 0
        while found.sum() > count:
            count = found.sum()
            for axis in range(3):
                spread = np.moveaxis(found, axis, 0)
                spread[1:] |= spread[:-1].copy()
                spread[:-1] |= spread[1:].copy()
            found &= kept
        kept = found
    return kept


def make_noise(cells, seed):
    """Returns smooth periodic noise at the centres of cells; its width is 1/16 of the image."""
    wave = np.fft.fftfreq(cells, 1 / cells)
    square = sum(np.meshgrid(*3 * [wave ** 2], indexing="ij"))
    noise = np.random.default_rng(seed).standard_normal(3 * [cells])
    return np.fft.ifftn(np.fft.fftn(noise) * np.exp(-2 * (np.pi / 16) ** 2 * square)).real


def make_pores(cells, seed):
    """Returns an image of connected pores, where the noise is smallest."""
    noise = make_noise(cells, seed)
    pores = connect(noise < np.quantile(noise, PORES))
    if not pores.any():
        sys.exit("porous_flow.py: no pores connect x_min to x_max; use another --seed")
    return pores


def make_input(case, cells, seed):
    """Returns arguments of the mesher and the volume fractions of the pores."""
    if case == "pores":
        pores = make_pores(cells, seed)
        return {"labels": pores.astype(np.uint8), "names": {1: "pores"},
                "label_smoothing": 3}, pores.astype(float)
    width, length = DUCT * cells, max(cells // 2, 4)
    middle = "center=%g,%g,%g" % (length / 2, cells / 2, cells / 2)
    shape = ("cylinder radius=%.17g height=%d rotation=0,90,0 " % (width / 2, 2 * length)
             if case == "round" else "box size=%d,%.17g,%.17g " % (2 * length, width, width))
    fractions = vfm.shapes(shape + middle, (length, cells, cells), tolerance=1e-6)
    fractions = next(iter(fractions.values()))
    return {"fractions": {"pores": fractions}, "sharp_edges": "on"}, fractions


def exact(case, cells):
    """Returns the exact permeability of a duct by Poiseuille's flow, or None."""
    width = DUCT * cells
    if case == "round":
        return np.pi * (width / 2) ** 4 / 8 / cells ** 2
    if case == "square":
        odd = np.arange(1, 100, 2)
        series = (np.tanh(odd * np.pi / 2) / odd ** 5).sum()
        return width ** 4 / 12 * (1 - 192 / np.pi ** 5 * series) / cells ** 2
    return None


def write_wall(mesh, path):
    """Writes the wall of the pores as triangles, .stl."""
    corners = np.concatenate([mesh.points[mesh.facets(name).points] for name in mesh.facet_sets()
                              if name.startswith("pores_to_")])
    write_triangles(np.concatenate([corners[:, [0, 1, 2]], corners[:, [0, 2, 3]]]), path)


def write_triangles(triangles, path):
    """Writes triangles of shape (triangles, 3, 3) as .stl."""
    records = np.zeros(len(triangles), [("numbers", "<f4", 12), ("end", "<u2")])
    records["numbers"][:, 3:] = triangles.reshape(-1, 9)
    with open(path, "wb") as file:
        file.write(b"wall".ljust(80) + np.uint32(len(triangles)).tobytes() + records.tobytes())


def find_inside(fractions):
    """Returns a point in the pores far from the wall."""
    inside = fractions > 0.999
    while True:
        smaller = inside.copy()
        for axis in range(3):
            for shift in (1, -1):
                smaller &= np.roll(inside, shift, axis)
        if not smaller.any():
            return np.argwhere(inside)[0] + [0.51, 0.47, 0.53]  # not on faces of cells
        inside = smaller


def cpu_seconds():
    return sum(resource.getrusage(who).ru_utime + resource.getrusage(who).ru_stime
               for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))


def write_case(folder, drop):
    """Writes all files of a case except the mesh."""
    openfoam.write(folder, "system/controlDict", CONTROL % (STEPS, STEPS))
    openfoam.write(folder, "system/fvSchemes", SCHEMES)
    openfoam.write(folder, "system/fvSolution", SOLUTION)
    openfoam.write(folder, "constant/transportProperties", TRANSPORT)
    openfoam.write(folder, "constant/turbulenceProperties", TURBULENCE)
    openfoam.write(folder, "0/U", VELOCITY, "volVectorField")
    openfoam.write(folder, "0/p", PRESSURE % drop, "volScalarField")


def run_snappy(folder, wall, fractions, refine):
    """Makes the mesh of snappyHexMesh along the wall, from cells as large as those of the other."""
    os.makedirs(os.path.join(folder, "constant", "triSurface"), exist_ok=True)
    os.replace(wall, os.path.join(folder, "constant", "triSurface", "wall.stl"))
    counts = [count * 2 ** refine for count in fractions.shape]
    openfoam.write(folder, "system/blockMeshDict", BLOCKS.format(*fractions.shape, *counts))
    openfoam.write(folder, "system/snappyHexMeshDict", SNAPPY.format(*find_inside(fractions)))
    openfoam.run("blockMesh", folder)
    openfoam.run("snappyHexMesh -overwrite", folder)


def read_history(folder, name):
    """Returns the values of a function object, one per step."""
    path = os.path.join(folder, "postProcessing", name, "0", "surfaceFieldValue.dat")
    with open(path, encoding="ascii") as file:
        return [float(line.split()[-1]) for line in file if not line.startswith("#")]


def find_number(pattern, text):
    return float(re.search(pattern + r"\s*=?:?\s*([-+.\de]+)", text)[1].rstrip("."))


def measure(name, folder, fractions, seconds, known):
    """Checks the mesh of a case and solves on it. Prints a row, and returns the permeability."""
    report = openfoam.run(openfoam.CHECKS, folder)
    problems = openfoam.find_problems(report)
    volume = find_number("Total volume", report)
    elements, hexes = find_number(r"\n    cells:", report), find_number("hexahedra:", report)
    begin = cpu_seconds()
    openfoam.run("simpleFoam", folder)
    solving = cpu_seconds() - begin
    history, outflow = read_history(folder, "inflow"), read_history(folder, "outflow")[-1]
    inflow, change = -history[-1], abs(history[-1 - STEPS // 10] / history[-1] - 1)
    if not change < STEADY:
        sys.exit("porous_flow.py: the flow rate still changes by %.1e: more STEPS" % change)
    permeability = inflow / DROP / (fractions.shape[1] * fractions.shape[2])
    print(ROW % (name, "%d" % elements, "%.0f%%" % (100 * hexes / elements), "%.1f" % seconds,
                 "%+.4f%%" % (100 * (volume / fractions.sum() - 1)),
                 "%d failed" % len(problems) if problems else "Mesh OK",
                 "%d" % find_number("Number of regions", report),
                 "%.1f" % find_number("non-orthogonality Max", report),
                 "%.2f" % find_number("Max skewness", report), "%.6g" % permeability,
                 "%.0e" % abs(outflow / inflow - 1), "%.0e" % change,
                 "%.0f" % solving), flush=True)
    for problem in problems:
        print("    checkMesh: " + problem.strip(), flush=True)
    if known:
        print("%-14s exact permeability %.6g, error %+.3f%%" % (
            name, known, 100 * (permeability / known - 1)), flush=True)
    return permeability


def run(arguments, folder):
    options, fractions = make_input(arguments.case, arguments.cells, arguments.seed)
    ours, other, wall = (os.path.join(folder, name) for name in ("mesh", "snappy", "wall.stl"))
    drop, known = DROP * fractions.shape[0], exact(arguments.case, arguments.cells)
    for case in (ours, other):
        write_case(case, drop)
    print("%s, %d x %d x %d cells, porosity %.4f" % (
        arguments.case, *fractions.shape, fractions.mean()))
    print(ROW % ("mesh", "elements", "hexes", "CPU s", "volume", "checkMesh", "regions", "nonort",
                 "skew", "permeab.", "balance", "change", "solve s"))
    begin = cpu_seconds()
    if arguments.refine:
        options.update(refinement="uniform", maximum_level=arguments.refine)
    mesh = vfm.hexes(**options)
    mesh.save(os.path.join(ours, "mesh.foam"))
    seconds = cpu_seconds() - begin
    write_wall(mesh, wall)
    found = [measure("this mesh", ours, fractions, seconds, known)]
    if not arguments.no_snappy:
        begin = cpu_seconds()
        run_snappy(other, wall, fractions, arguments.refine)
        found.append(measure("snappyHexMesh", other, fractions, cpu_seconds() - begin, known))
        print("permeability of snappyHexMesh to that of this mesh: %+.3f%%" % (
            100 * (found[1] / found[0] - 1)))
    if arguments.picture:
        script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "porous_streamlines.py")
        subprocess.run(["pvbatch", script, os.path.join(ours, "mesh.foam"), arguments.picture],
                       check=True)


def main():
    arguments = parse_arguments()
    if not openfoam.is_installed():
        sys.exit("porous_flow.py: there is no OpenFOAM: install Debian's openfoam")
    with tempfile.TemporaryDirectory() as folder:
        if arguments.folder:
            os.makedirs(arguments.folder, exist_ok=True)
        run(arguments, arguments.folder or folder)


if __name__ == "__main__":
    main()
