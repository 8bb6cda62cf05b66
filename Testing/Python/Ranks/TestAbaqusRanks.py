"""Abaqus files written by several ranks.

usage: mpiexec -n P pvbatch --sym TestAbaqusRanks.py FOLDER

A run on one rank stores its file in FOLDER. Runs on more ranks
must write the same bytes and report errors on all ranks.
"""
import os
import sys

from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
from vtkmodules.vtkParallelCore import vtkCommunicator, vtkMultiProcessController

from vfmtest import (
    ball_and_plate, collect, image, main, producer, reduced, VolumeFractionToHex,
    VolumeFractionToTet, simple)

CONTROLLER = vtkMultiProcessController.GetGlobalController()
RANK, RANKS = CONTROLLER.GetLocalProcessId(), CONTROLLER.GetNumberOfProcesses()
FOLDER = sys.argv[1]
N = 12


def mesher(make=VolumeFractionToHex, ranks=RANKS, **properties):
    """Makes a mesher of one slab along z per rank of `ranks`; other ranks have no cells."""
    data = vtkMultiBlockDataSet()
    if RANK < ranks:
        begin, end = N * RANK // ranks, N * (RANK + 1) // ranks
        parts = {name: values[begin:end]
                 for name, values in zip(("ball", "plate"), ball_and_plate(N))}
        data.SetBlock(0, image(parts, (0, 0, begin)))
    return make(Input=producer(data), VolumeFractionArrays=["ball", "plate"], **properties)


def path_of(name):
    os.makedirs(FOLDER, exist_ok=True)
    return os.path.join(FOLDER, name)


def check(proxy, name):
    path = path_of("%s_%d.inp" % (name, RANKS))
    simple.SaveData(path, proxy=proxy)
    CONTROLLER.Barrier()
    with open(path, "rb") as file, open(path_of(name + "_1.inp"), "rb") as gold:
        same = file.read() == gold.read()
    assert same, path


def test_hexes():
    check(mesher(), "hexes")


def test_hexes_of_one_slab():
    """The file of a mesh whose input is on one rank is the same."""
    check(mesher(ranks=1), "hexes")


def test_tets():
    check(mesher(VolumeFractionToTet, Method="Lattice"), "tets")


def failed_on_all(mesh, path, text):
    """Checks that all ranks report one equal message."""
    writer = simple.CreateWriter(path, producer(mesh))
    writer.UpdateVTKObjects()
    algorithm = writer.GetClientSideObject()
    errors, _ = collect(algorithm)
    good = algorithm.Write() == 0 and len(errors) == 1 and text in errors[0]
    assert reduced(int(good), vtkCommunicator.MIN_OP) == 1, errors
    assert not os.path.exists(path)


def output(proxy):
    proxy.UpdatePipeline()
    return proxy.GetClientSideObject().GetOutputDataObject(0)


def test_errors():
    hexes = output(mesher())
    failed_on_all(hexes, path_of("missing/mesh.inp"), "No such file")
    tets = output(mesher(VolumeFractionToTet, Method="Cells"))
    if RANKS > 1:
        failed_on_all(tets if RANK == 1 else hexes, path_of("mixed.inp"),
                      "all hexahedra or all tetrahedra")
    bare = hexes.NewInstance()
    bare.ShallowCopy(hexes)
    if RANK == RANKS - 1:
        bare.GetCellData().RemoveArray("MaterialId")
    failed_on_all(bare, path_of("bare.inp"), "no array MaterialId")
    failed_on_all(hexes.NewInstance(), path_of("empty.inp"), "empty")


main(globals())
