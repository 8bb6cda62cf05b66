"""Tests OpenFOAM: checkMesh of periodic meshes, decomposePar, and a solution on three ranks."""

import shutil

import numpy as np
import pytest
import volume_fraction_mesh as vfm

import foam_files as foam
from test_openfoam import check_mesh, make_noise, run_sculptor, write_input

pytestmark = pytest.mark.skipif(not foam.is_installed(), reason="install Debian's openfoam")
CELLS = 24
SHIFT = (5, 7, 12)  # the sides cut the sphere


def make_labels(name):
    """Returns labels that repeat: a sphere 2 in 1, pores 1 in void, or pores 2 in 1."""
    if name == "array":
        sphere = vfm.shapes("sphere radius=0.45 center=0.5,0.5,0.5", 3 * [CELLS],
                            bounds=(0, 1, 0, 1, 0, 1))
        return 1 + np.roll(next(iter(sphere.values())) > 0.5, SHIFT, (0, 1, 2)).astype(np.uint8)
    noise = make_noise(CELLS, 2.0)
    pores = (noise < np.quantile(noise, 0.6)).astype(np.uint8)
    return pores if name == "pores" else 1 + pores


@pytest.mark.parametrize("name", ["array", "pores", "two zones"])
@pytest.mark.parametrize("make, sides", [(vfm.hexes, "flat"), (vfm.hexes, "free"),
                                         (vfm.tets, "flat")])
def test_check_mesh(name, make, sides, tmp_path):
    mesh = make(labels=make_labels(name), label_smoothing=3, periodic="xyz", periodic_sides=sides)
    mesh.save(tmp_path / "mesh.foam")
    # Pores have one or two faces on whose tetrahedra checkMesh reports.
    warped = 2 if name != "array" and make is vfm.hexes else 0
    check_mesh(tmp_path, warped=warped)
    patches = foam.PolyMesh(tmp_path).patches
    cyclic = {name for name, patch in patches.items() if patch["type"] == "cyclic"}
    assert cyclic >= {"x_min", "x_max", "y_min", "y_max", "z_min", "z_max"}
    others = patches.keys() - cyclic
    assert others == ({"Material_1_to_Void"} if name == "pores" else set())


@pytest.mark.parametrize("sides", ["Flat", "Free"])
def test_ranks(sides, tmp_path):
    """Three ranks write a decomposed case; its boundaries are those of decomposePar for the same
    cells of each rank."""
    write_input(tmp_path, make_labels("array"))
    case, whole = tmp_path / "case", tmp_path / "whole"
    options = ["--periodic", "xyz", "--periodic-sides", sides]
    run_sculptor(tmp_path, case, 3, *options)
    check_mesh(case, 3)
    run_sculptor(tmp_path, whole, 3, *options, "--single-file")
    parts = [case / ("processor%d" % rank) for rank in range(3)]
    cells = [foam.PolyMesh(part).addressing["cell"] for part in parts]
    ranks = np.empty(sum(map(len, cells)), int)
    for rank, own in enumerate(cells):
        ranks[own] = rank
    foam.write(whole, "constant/ranks", "%d(%s)" % (len(ranks), " ".join(map(str, ranks))),
               "labelList")
    foam.write(whole, "system/decomposeParDict", "numberOfSubdomains 3;\nmethod manual;\n"
               "manualCoeffs { dataFile ranks; }\n")
    foam.run("decomposePar", whole)
    types = set()
    for rank, part in enumerate(parts):
        boundaries = []
        for folder in (part, whole / ("processor%d" % rank)):
            boundary = foam.read_boundary(folder / "constant" / "polyMesh" / "boundary")
            boundaries.append({name: {key: patch.get(key) for key in (
                "type", "nFaces", "neighbourPatch", "myProcNo", "neighbProcNo", "referPatch")}
                for name, patch in boundary.items()})
        assert boundaries[0] == boundaries[1]
        types.update(patch["type"] for patch in boundaries[0].values())
    assert types == {"cyclic", "processor", "processorCyclic"}


def test_decompose(tmp_path):
    """decomposePar decomposes a whole mesh of three ranks, and checkMesh accepts the parts."""
    write_input(tmp_path, make_labels("array"))
    case = tmp_path / "case"
    run_sculptor(tmp_path, case, 3, "--periodic", "xyz", "--single-file")
    foam.write(case, "system/decomposeParDict", "numberOfSubdomains 3;\nmethod simple;\n"
               "simpleCoeffs { n (3 1 1); delta 0.001; }\n")
    foam.run("decomposePar", case)
    check_mesh(case, 3)


TEMPERATURE = """dimensions [0 0 0 1 0 0 0]; internalField uniform 1;
boundaryField { ".*" { type cyclic; } }
"""
SOURCE = """heat { type scalarSemiImplicitSource; selectionMode cellZone; cellZone Material_2;
  volumeMode specific; injectionRateSuSp { T (1 0); } }
"""
SCHEMES = """ddtSchemes { default Euler; } gradSchemes { default Gauss linear; }
divSchemes { default none; } laplacianSchemes { default Gauss linear corrected; }
interpolationSchemes { default linear; } snGradSchemes { default corrected; }
"""
SOLUTION = """solvers { T { solver PCG; preconditioner diagonal; tolerance 1e-14; relTol 0; } }
SIMPLE { nNonOrthogonalCorrectors 1; }
"""


def set_up_diffusion(case):
    """Ten steps of diffusion by laplacianFoam with a source in the sphere, over a length of four
    cells. The first value is uniform: laplacianFoam reads no values of patches processorCyclic."""
    foam.write(case, "0/T", TEMPERATURE, "volScalarField")
    foam.write(case, "constant/fvOptions", SOURCE)
    foam.write(case, "system/fvSchemes", SCHEMES)
    foam.write(case, "system/fvSolution", SOLUTION)
    foam.write(case, "constant/transportProperties", "DT [0 2 -1 0 0 0 0] 1;\n")
    for key, value in (("endTime", 10), ("writeInterval", 10), ("writePrecision", 15)):
        foam.set_entry(case, "system/controlDict", key, value)


def test_diffusion(tmp_path):
    """decomposePar distributes a field to the parts of three ranks, and reconstructPar puts their
    solution together: it is that of one rank."""
    write_input(tmp_path, make_labels("array"))
    three, one = tmp_path / "three", tmp_path / "one"
    options = ["--periodic", "xyz", "--periodic-sides", "Free"]
    run_sculptor(tmp_path, three, 3, *options)
    run_sculptor(tmp_path, three, 3, *options, "--single-file")
    set_up_diffusion(three)
    shutil.copytree(three, one, ignore=shutil.ignore_patterns("processor*"))
    foam.run("decomposePar -fields", three)
    foam.run("laplacianFoam", one)
    foam.run("laplacianFoam", three, 3)
    foam.run("reconstructPar -time 10", three)
    found, expected = (foam.read_field(case / "10" / "T") for case in (three, one))
    print("range of T %.6g to %.6g, greatest difference %.1e" % (
        expected.min(), expected.max(), abs(found - expected).max()))
    assert np.ptp(expected) > 1e-3
    assert abs(found - expected).max() < 1e-10
