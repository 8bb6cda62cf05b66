"""The table of fragments is the same on any number of ranks.

usage: mpiexec -n P pvbatch --sym TestFragmentRanks.py FOLDER

A run on one rank stores the table in FOLDER.
"""
import json
import os
import sys

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
from vtkmodules.vtkParallelCore import vtkCommunicator, vtkMultiProcessController

from vfmtest import (
    VolumeFractionFragments, VolumeFractionToHex, VolumeFractionToTet, collect, image, main,
    producer, reduced)

CONTROLLER = vtkMultiProcessController.GetGlobalController()
RANK, RANKS = CONTROLLER.GetLocalProcessId(), CONTROLLER.GetNumberOfProcesses()
N = 12
RANDOM = np.random.default_rng(5)
# Fragments extend over several ranks.
IDS = np.kron(RANDOM.integers(0, 9, (4, 4, 4)), np.ones((3, 3, 3), int)).astype(np.int32)
DENSITY = RANDOM.random((N, N, N))
# Meshes of TetGen depend on the number of ranks.
METHODS = {VolumeFractionToHex: {}, VolumeFractionToTet: {"Method": "Lattice"}}


def slab():
    """Returns the cells of this rank; the last of several ranks has none."""
    data, owners = vtkMultiBlockDataSet(), max(RANKS - 1, 1)
    if RANK < owners:
        begin, end = N * RANK // owners, N * (RANK + 1) // owners
        data.SetBlock(0,
                      image({"id": IDS[begin:end].copy(), "density": DENSITY[begin:end].copy()},
                            first=(0, 0, begin)))
    return data


def table_of(data, make, **properties):
    mesher = make(Input=producer(data), MaterialIdArray="id", StateArrays=["density"],
                  **METHODS[make])
    table = VolumeFractionFragments(Input=mesher, **properties)
    errors, _ = collect(table.GetClientSideObject())
    table.GetClientSideObject().Update()
    output = table.GetClientSideObject().GetOutputDataObject(0)
    columns = [output.GetColumn(c) for c in range(output.GetNumberOfColumns())]
    return {column.GetName(): [column.GetValue(row) for row in range(output.GetNumberOfRows())]
            for column in columns}, errors


def test_same_table():
    for make in METHODS:
        table, errors = table_of(slab(), make, DensityArrays=["density"])
        gold = os.path.join(sys.argv[1], "fragments_%s.json" % make.__name__)
        if RANKS == 1:
            os.makedirs(sys.argv[1], exist_ok=True)
            with open(gold, "w") as file:
                json.dump(table, file)
        with open(gold) as file:
            expected = json.load(file)
        good = not errors and len(expected["FragmentId"]) > 10 and table == (
            expected if RANK == 0 else {})
        assert reduced(int(not good), vtkCommunicator.SUM_OP) == 0, errors


def test_error_on_all():
    _, errors = table_of(slab(), VolumeFractionToHex, DensityArrays=["nothing"])
    assert len(errors) == 1 and "no array nothing" in errors[0], errors


main(globals())
