"""Prints the sha256 of many meshes, to compare two builds on one machine.

usage: VFM_PLUGIN=build/lib/VolumeFractionMesh.so pvpython mesh_digests.py > new.txt
       mpiexec -n 3 pvbatch --sym mesh_digests.py > new3.txt

Each line covers every bit of a mesh and its surfaces, except field data. On several ranks rank 0
has the input, and the pieces are hashed in the order of the ranks. A change that must keep meshes
bitwise identical must not change the output.
"""
import hashlib
import os

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
from vtkmodules.vtkIOXML import vtkXMLImageDataReader
from vtkmodules.vtkParallelCore import vtkMultiProcessController
from vtkmodules.util.numpy_support import vtk_to_numpy

from amr_cases import fields, multiblock, nested, overlapping
from vfmtest import (
    TET_METHODS, VolumeFractionToTet, ball_and_plate, digest, image, labels, main, rectilinear, run)

CONTROLLER = vtkMultiProcessController.GetGlobalController()
RANK, RANKS = CONTROLLER.GetLocalProcessId(), CONTROLLER.GetNumberOfProcesses()
DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Data")


def grains(n=16, count=11):
    centres = np.random.default_rng(5).random((count, 3)) * n
    z, y, x = np.meshgrid(*[np.arange(3 * n) / 3 + 1 / 6] * 3, indexing="ij")
    nearest = np.argmin([(x - c[0]) ** 2 + (y - c[1]) ** 2 + (z - c[2]) ** 2 for c in centres],
                        axis=0)
    return {"g%d" % g: (nearest == g).reshape(n, 3, n, 3, n, 3).mean(axis=(1, 3, 5))
            for g in range(count)}


def cells_of(file, name):
    """Returns a cell array of an image in Data, (z, y, x)."""
    reader = vtkXMLImageDataReader()
    reader.SetFileName(os.path.join(DATA, file))
    reader.Update()
    size = [n - 1 for n in reader.GetOutput().GetDimensions()]
    return vtk_to_numpy(reader.GetOutput().GetCellData().GetArray(name)).reshape(size[::-1])


def noise(n=10):
    return {"id": np.random.default_rng(7).choice([0, 2, 3, 5, 11],
                                                  (n + 2, n, n + 1)).astype(np.int32)}


def stretched():
    ball, plate = ball_and_plate(12)
    steps = [0.25 + 0.1 * np.sin(np.arange(12) + a) for a in range(3)]
    return rectilinear({"ball": ball, "plate": plate},
                       [np.concatenate([[0], np.cumsum(step)]) for step in steps])


def fractions(n=16):
    return image(dict(zip(("ball", "plate"), ball_and_plate(n))))


def levels(count=2):
    return (overlapping if RANKS == 1 else multiblock)(fields(count), nested(count))


BOTH, GRAINS, ID = {}, {"VolumeFractionArrays": ["g%d" % g
                                                 for g in range(11)]}, {"MaterialIdArray": "id"}
INPUTS = {
    "ball and plate": (fractions, BOTH), "grains": (lambda: image(grains()), GRAINS),
    "splash": (lambda: image({"water": cells_of("splash_3500us.vti", "water")[4:28, 16:44, 18:44]}),
               {"VolumeFractionArrays": ["water"]}),
    "fin": (lambda: image({"body": cells_of("fin.vti", "body")}),
            {"VolumeFractionArrays": ["body"]}),
    "large": (lambda: fractions(40), BOTH), "noise": (lambda: image(noise()), ID),
    "labels": (lambda: image({"id": labels(16).astype(np.int32)}), ID),
    "rectilinear": (stretched, BOTH), "AMR": (levels, BOTH)}

SMOOTHED = {"LabelSmoothing": 3, "MinimumRegionCells": 3}
AUTOMATIC = {"Refinement": "Automatic", "MaximumLevel": 1}
HEXES = [
    ("ball and plate", {}), ("ball and plate", {"Smoothing": "Geometry Based"}),
    ("ball and plate", {"Smoothing": "Off"}),
    ("ball and plate", {"StairStep": 1}), ("ball and plate", {"MeshVoid": 1}),
    ("ball and plate", {"ConserveVolume": 0, "IsoValue": 0.4}),
    ("ball and plate", {"Refinement": "Uniform", "MaximumLevel": 1}), ("fin", AUTOMATIC),
    ("fin", {**AUTOMATIC, "FineInterfaces": 0}),
    ("large", {"Refinement": "Coarsen", "MaximumLevel": 1, "MeshVoid": 1}),
    ("grains", {}), ("grains", {"TargetScaledJacobian": 0.4}), ("splash", {}),
    ("splash", {"MeshVoid": 1}), ("noise", {}),
    ("noise", {"MeshVoid": 1}), ("noise", SMOOTHED), ("labels", {}),
    ("labels", {"LabelSmoothing": 3}), ("rectilinear", {}),
    ("AMR", {}), ("AMR", {"FineInterfaces": 0}), ("AMR", {"FineInterfaces": 0, "MeshVoid": 1}),
    ("AMR", {"MeshVoid": 1}),
    ("AMR", {"FineInterfaces": 0, "StairStep": 1}), ("AMR", {"StairStep": 1}),
    ("AMR", {"FineInterfaces": 0, "Smoothing": "Geometry Based"})]
TETS = [
    ("ball and plate", {}), ("ball and plate", {"MeshVoid": 1}),
    ("ball and plate", {"StairStep": 1}), ("grains", {}), ("noise", {}),
    ("rectilinear", {}), ("AMR", {}), ("AMR", {"MeshVoid": 1}),
    ("ball and plate", {"Smoothing": "Geometry Based"}), ("fin", AUTOMATIC)]


def print_digest(name, data, make, properties):
    if RANKS > 1:
        blocks = vtkMultiBlockDataSet()
        if RANK == 0:
            blocks.SetBlock(0, data)
        data = blocks
    result = run(data, make, **properties)
    assert not result.errors and (RANKS > 1
                                  or result.mesh.GetNumberOfCells() > 0), (name, result.errors)
    mine = digest(result)
    gathered = [mine]
    if RANKS > 1:
        from mpi4py import MPI  # the mpi4py of Debian, like ParaView
        gathered = MPI.COMM_WORLD.gather(mine)
    if RANK == 0:
        print("%s  %s" % (gathered[0] if RANKS == 1
                          else hashlib.sha256("".join(gathered).encode()).hexdigest(), name),
                          flush=True)


def test_print():
    cases = [(case, None, options) for case, options in HEXES]
    cases += [(case, VolumeFractionToTet, {"Method": method, **options}) for method in TET_METHODS
              for case, options in TETS]
    for case, make, options in cases:
        make_input, chosen = INPUTS[case]
        name = " ".join([case,
                         "tet" if make else "hex"] + ["%s=%s" % option
                                                      for option in options.items()])
        print_digest(name, make_input(), make, {**chosen, **options})


main(globals())
