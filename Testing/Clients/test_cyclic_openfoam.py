"""Tests OpenFOAM: checkMesh of periodic meshes, and decomposePar."""

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
    # Flat sides of pores have one or two faces on whose tetrahedra checkMesh reports.
    warped = 2 if name != "array" and make is vfm.hexes and sides == "flat" else 0
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
