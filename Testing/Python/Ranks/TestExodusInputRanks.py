"""Hexahedra that form a Cartesian grid, distributed to ranks in ragged parts.

usage: mpiexec -n 3 pvbatch --sym TestExodusInputRanks.py

The mesh is that of whole blocks. An error on one rank is reported on all.
"""
import functools
import zlib

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import (
    VTK_TETRA, VTK_VOXEL, vtkMultiBlockDataSet, vtkUnstructuredGrid)
from vtkmodules.vtkParallelCore import vtkCommunicator, vtkMultiProcessController

from exodus_grids import GRADED, N, fields, hexes, ragged
from vfmtest import check_error, main, rectilinear, reduced, run

CONTROLLER = vtkMultiProcessController.GetGlobalController()
RANK, RANKS = CONTROLLER.GetLocalProcessId(), CONTROLLER.GetNumberOfProcesses()
MINE = ragged(RANK, RANKS)
CHOSEN = {"VolumeFractionArrays": ["MAT_10", "MAT_20"], "StateArrays": ["number"]}
check_input_error = functools.partial(check_error, **CHOSEN)


def blocks(*data):
    result = vtkMultiBlockDataSet()
    for i, block in enumerate(data):
        result.SetBlock(i, block)
    return result


def mine_of(result):
    """Returns sums over this rank's elements of points, ids and arrays.

    The sums over all ranks differ for different meshes, and do not depend on the order of elements.
    """
    rows = [vtk_to_numpy(result.mesh.GetPoints().GetData())[
        vtk_to_numpy(result.mesh.GetCells().GetConnectivityArray())].reshape(-1, 24)]
    rows += [result.cells(name).reshape(-1, 1).astype(float)
             for name in ("GlobalCellIds", "MaterialId", "number", "ScaledJacobian")]
    table = (np.ascontiguousarray(np.concatenate(rows, axis=1)) if result.mesh.GetNumberOfCells()
             else np.zeros((0, 28)))
    return sum(zlib.crc32(row.tobytes()) for row in table), len(table)


def of_mesh(data):
    result = run(data, **CHOSEN)
    # All ranks reduce before any of them may fail.
    failed = reduced(len(result.errors), vtkCommunicator.SUM_OP)
    assert failed == 0, result.errors
    return [reduced(int(value), vtkCommunicator.SUM_OP) for value in mine_of(result)]


def whole(rank=0):
    return blocks(*([rectilinear(fields(), GRADED)] if RANK == rank else []))


def test_ragged_parts():
    expected = of_mesh(whole())
    assert expected[1] > 1000
    assert of_mesh(hexes(fields(), MINE, GRADED)) == expected
    assert of_mesh(blocks(hexes(fields(), MINE[:9], GRADED),
                          hexes(fields(), MINE[9:], GRADED, VTK_VOXEL))) == expected


def test_ranks_without_cells():
    expected = of_mesh(whole(1))
    for rank in (0, 2):
        cells = np.random.default_rng(rank).permutation(N ** 3)
        assert of_mesh(hexes(fields(), cells, GRADED) if RANK == rank
                       else vtkUnstructuredGrid()) == expected
        assert of_mesh(blocks(*([hexes(fields(), cells, GRADED)] if RANK == rank
                                else []))) == expected


def spoilt(rank, change):
    """Returns the parts, after change(points, connectivity) on one rank."""
    data = hexes(fields(), MINE, GRADED)
    if RANK == rank:
        change(vtk_to_numpy(data.GetPoints().GetData()),
               vtk_to_numpy(data.GetCells().GetConnectivityArray()))
    return data


def test_shape_on_one_rank():
    def skew(points, connectivity):
        points[connectivity[40], 2] += 0.1

    def double(points, connectivity):
        connectivity[:8] = connectivity[80:88]

    for rank in range(RANKS):
        check_input_error(spoilt(rank, skew), "The input of rank %d: cell" % rank, "is not a box",
                          "Transform")
        check_input_error(spoilt(rank, double),
                          "The input of rank %d: cell 0 and cell 10 lie in the same place" % rank)


def test_tetrahedron_on_one_rank():
    for rank in range(RANKS):
        data = hexes(fields(), MINE, GRADED)
        if RANK == rank:
            data.InsertNextCell(VTK_TETRA, 4, [0, 1, 2, 3])
        check_input_error(blocks(data),
                          "Block 0 of rank %d: cell %d is a vtkTetra"
                          % (rank, len(ragged(rank, RANKS))))


def test_parts_that_do_not_tile():
    for rank in range(RANKS):
        check_input_error(hexes(fields(), MINE[1:] if RANK == rank else MINE, GRADED),
                          "leave a gap: 1 of the 1728")
        other = ragged((rank + 1) % RANKS, RANKS)[:1]
        check_input_error(hexes(fields(), np.append(MINE, other) if RANK == rank else MINE, GRADED),
                          "The input of rank ", "overlap")


def test_array_missing_on_one_rank():
    for rank in range(RANKS):
        data = hexes(fields(), MINE, GRADED)
        if RANK == rank:
            data.GetCellData().RemoveArray("MAT_20")
        check_input_error(data, "The input of rank %d has no numeric cell array 'MAT_20'" % rank)


main(globals())
