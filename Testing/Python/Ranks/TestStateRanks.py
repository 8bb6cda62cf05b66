"""State arrays on several ranks follow the rule, also where elements moved far.

usage: mpiexec -n P pvbatch --sym TestStateRanks.py

Each rank checks its elements against the fields of all ranks. TestRanks.py compares them bitwise.
"""
import numpy as np
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
from vtkmodules.vtkParallelCore import vtkCommunicator, vtkMultiProcessController

from state_rule import graded_coordinates, of_labels, specks, state_cells, with_void
from vfmtest import TET_METHODS, main, rectilinear, reduced, run, VolumeFractionToTet

N = 9
CONTROLLER = vtkMultiProcessController.GetGlobalController()
RANK, RANKS = CONTROLLER.GetLocalProcessId(), CONTROLLER.GetNumberOfProcesses()
COORDINATES = graded_coordinates(N)
FIELDS = {
    "number": np.arange(N ** 3, dtype=np.int64).reshape(N, N, N), "speck": specks(N),
    "id": np.random.default_rng(3).choice([0, 2, 3, 5], (N, N, N)).astype(np.int32),
    "velocity": np.random.default_rng(4).normal(size=(N, N, N, 3)).astype(np.float32)}
KINDS = [{}] + [{"make": VolumeFractionToTet, "Method": method} for method in TET_METHODS]


def slabs(ranks=RANKS):
    """Returns two separate slabs per rank; other ranks mesh most of their cells."""
    data = vtkMultiBlockDataSet()
    for block, slab in enumerate(range(RANK, 2 * ranks, ranks) if RANK < ranks else ()):
        begin, end = N * slab // (2 * ranks), N * (slab + 1) // (2 * ranks)
        parts = {name: values[begin:end].copy() for name, values in FIELDS.items()}
        part = rectilinear(parts, [*COORDINATES[:2], COORDINATES[2][begin:end + 1]])
        part.GetCellData().GetArray("velocity").SetComponentName(1, "v")
        data.SetBlock(block, part)
    return data


def find_problem(result, fractions, limited):
    if result.errors:
        return str(result.errors)
    velocity = result.mesh.GetCellData().GetArray("velocity")
    if velocity.GetNumberOfComponents() != 3 or velocity.GetComponentName(1) != "v":
        return "the layout of the velocity is lost"
    if result.mesh.GetNumberOfCells() == 0:
        return ""
    expected, _ = state_cells(result, COORDINATES, fractions, limited)
    if (result.cells("number") != expected).any():
        return "%d of %d cells are wrong" % ((result.cells("number") != expected).sum(),
                                             len(expected))
    return "" if (
        result.cells("velocity") == FIELDS["velocity"].reshape(-1, 3)[
            expected]).all() else "wrong velocity"


def check(data, fractions, **properties):
    result = run(data, StateArrays=["velocity", "number"], **properties)
    problem = find_problem(result, fractions, properties.get("Method") != "TetGen")
    # All ranks reduce before any of them may fail.
    failed = reduced(int(bool(problem)), vtkCommunicator.SUM_OP)
    filled = reduced(int(result.mesh.GetNumberOfCells() > 0), vtkCommunicator.SUM_OP)
    assert failed == 0, problem or "see the other ranks"
    assert filled == RANKS


def test_fractions():
    for kind in KINDS:
        check(slabs(), with_void({1: FIELDS["speck"]}), VolumeFractionArrays=["speck"], **kind)


def test_labels():
    for kind in KINDS:
        check(slabs(), of_labels(FIELDS["id"]), MaterialIdArray="id", **kind)


def test_ranks_without_blocks():
    check(slabs(1), of_labels(FIELDS["id"]), MaterialIdArray="id", MeshVoid=1)


main(globals())
