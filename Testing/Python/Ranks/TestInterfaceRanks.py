"""Interfaces split, and layers cut, in an existing mesh on any number of ranks.

usage: mpiexec -n P pvbatch --sym TestInterfaceRanks.py FOLDER

A run on one rank stores the meshes in FOLDER.
"""
import os
import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader, vtkXMLUnstructuredGridWriter
from vtkmodules.vtkParallelCore import vtkCommunicator, vtkMultiProcessController

from interface_cases import BOTH, GRAINS, LAYERS, SPLIT, compare, hexes, modify, run, tets
from vfmtest import failure_of, main, producer, reduced, write

CONTROLLER = vtkMultiProcessController.GetGlobalController()
RANK, RANKS = CONTROLLER.GetLocalProcessId(), CONTROLLER.GetNumberOfProcesses()
FOLDER = sys.argv[1]
CASES = {"hexes": (hexes, BOTH), "tets": (tets, SPLIT)}


def case(make):
    """Returns the input of a mesher: all cells on rank 0, which distributes them."""
    data = dict(GRAINS) if RANK == 0 else {"labels": GRAINS["labels"][:0]}
    return make(**data, **({"Method": "Lattice"} if make is tets else {}))


def everywhere(check):
    """Calls check() and fails on all ranks if it fails on one."""
    try:
        check()
        failed, text = 0, ""
    except AssertionError as error:
        failed, text = 1, error
    assert reduced(failed, vtkCommunicator.SUM_OP) == 0, text


def at(name):
    return os.path.join(FOLDER, name)


def read(name):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(at(name))
    reader.Update()
    return reader.GetOutput()


def test_same_on_each_rank():
    """The part of each rank is that of the mesher with the options."""
    for make, options in CASES.values():
        mesh = case(make)
        made = run(modify(mesh, **options))
        for name, value in options.items():
            setattr(mesh, name, value)
        if options is BOTH:
            mesh.FirstLayerUnit = "Length"
        expected = run(mesh)
        cells = expected[0].GetNumberOfCells()
        assert reduced(int(cells > 0), vtkCommunicator.SUM_OP) == RANKS, "not distributed"
        everywhere(lambda: compare(made, expected))


def test_file():
    """A file that one rank reads gives the mesh of one rank."""
    for name, (make, options) in CASES.items():
        if RANKS == 1:
            os.makedirs(FOLDER, exist_ok=True)
            mesh = case(make)
            write(run(mesh)[0], at(name + ".vtu"), vtkXMLUnstructuredGridWriter)
            for output, part in zip(run(modify(mesh, **options)), ("mesh", "cohesive")):
                write(output, at("%s_%s.vtu" % (name, part)), vtkXMLUnstructuredGridWriter)
        data = read(name + ".vtu") if RANK == 0 else vtkUnstructuredGrid()
        made = run(modify(producer(data), **options))
        gold = [read("%s_%s.vtu" % (name, part)) for part in ("mesh", "cohesive")]
        assert all(grid.GetNumberOfCells() > 100 for grid in gold)
        everywhere(lambda: check_on_rank_0(made, gold))


def check_on_rank_0(made, gold):
    if RANK == 0:
        compare(made, gold)
    else:
        assert all(grid.GetNumberOfCells() == 0 for grid in made)


def test_any_distribution():
    """Elements that are dealt to the ranks one by one give the same elements."""
    for name, (make, options) in CASES.items():
        whole = read(name + ".vtu")
        chosen = np.flatnonzero(np.arange(whole.GetNumberOfCells()) % RANKS == RANK)
        part = pick(whole, chosen)
        made = run(modify(producer(part), **options))[0]
        gold = read(name + "_mesh.vtu")
        everywhere(lambda: check_part(made, gold))
        counts = reduced(made.GetNumberOfCells(), vtkCommunicator.SUM_OP)
        assert counts == gold.GetNumberOfCells()


def pick(grid, cells):
    """Returns some cells of a grid, with all its points and fields."""
    part = vtkUnstructuredGrid()
    part.SetPoints(grid.GetPoints())
    part.GetPointData().ShallowCopy(grid.GetPointData())
    part.GetFieldData().ShallowCopy(grid.GetFieldData())
    part.GetCellData().CopyAllOn()
    part.GetCellData().CopyAllocate(grid.GetCellData(), len(cells))
    part.Allocate(len(cells))
    for new, old in enumerate(cells):
        points = grid.GetCell(int(old)).GetPointIds()
        part.InsertNextCell(grid.GetCellType(int(old)), points)
        part.GetCellData().CopyData(grid.GetCellData(), int(old), new)
    return part


def corners(grid):
    """Returns the ids and coordinates of the corners of each cell, by its id."""
    ids = vtk_to_numpy(grid.GetPointData().GetArray("GlobalPointIds"))
    cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
    places = vtk_to_numpy(grid.GetPoints().GetData())[cells]
    shape = (grid.GetNumberOfCells(), -1)
    found = zip(vtk_to_numpy(grid.GetCellData().GetArray("GlobalCellIds")),
                ids[cells].reshape(shape), places.reshape(shape))
    return {cell: (tuple(points), tuple(x)) for cell, points, x in found}


def check_part(made, gold):
    expected, mine = corners(gold), corners(made)
    assert mine and all(mine[cell] == expected[cell] for cell in mine)


def test_refused_on_all_ranks():
    """A mesh that is wrong on one rank gives one message on each."""
    plain = read("hexes.vtu")
    wrong = vtkUnstructuredGrid()
    wrong.ShallowCopy(plain)
    wrong.GetCellData().RemoveArray("FragmentId")
    for data, options, words in ((wrong, SPLIT, "has no array FragmentId"),
                                 (read("tets.vtu"), LAYERS, "Layers are for hexahedra"),
                                 (read("hexes_mesh.vtu"), SPLIT, "split already")):
        given = data if RANK == RANKS - 1 else vtkUnstructuredGrid()
        outputs, errors = run(modify(producer(given), **options), fails=True)
        good = len(errors) == 1 and words in errors[0] and words in failure_of(outputs[0])
        assert reduced(int(not good), vtkCommunicator.SUM_OP) == 0, errors
    if RANKS > 1:
        outputs, errors = run(modify(producer(plain), **SPLIT), fails=True)
        good = len(errors) == 1 and "is on several ranks" in errors[0]
        assert reduced(int(not good), vtkCommunicator.SUM_OP) == 0, errors


main(globals())
