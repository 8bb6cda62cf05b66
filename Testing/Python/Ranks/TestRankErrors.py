"""Errors of the input on one rank or on all ranks.

usage: mpiexec -n 3 pvbatch --sym TestRankErrors.py

All ranks report the same message, all outputs are empty, and no rank waits.
"""
import zlib

import numpy as np
from vtkmodules.vtkCommonDataModel import (
    vtkImageData, vtkMultiBlockDataSet, vtkNonOverlappingAMR, vtkPolyData, vtkUniformGrid)
from vtkmodules.vtkParallelCore import vtkCommunicator, vtkMultiProcessController

from amr_cases import set_boxes
from vfmtest import (
    ORIGIN, SPACING, TET_METHODS, at_points, ball_and_plate, check_error, collect, image, labels,
    main, producer, reduced, run, VolumeFractionToHex,
    VolumeFractionToTet)

N = 9
CONTROLLER = vtkMultiProcessController.GetGlobalController()
RANK, RANKS = CONTROLLER.GetLocalProcessId(), CONTROLLER.GetNumberOfProcesses()
BALL, PLATE = ball_and_plate(N)
FIELD = {"ball": BALL, "plate": PLATE, "id": labels(N)}


def slab(change=None, rank=RANK, shift=0.0, kind=vtkImageData):
    """Returns this rank's third of the field along z; change(arrays) may alter its arrays."""
    begin, end = N * rank // RANKS, N * (rank + 1) // RANKS
    arrays = {name: values[begin:end].copy() for name, values in FIELD.items()}
    if change:
        change(arrays)
    data = image(arrays, kind=kind)
    data.SetOrigin(*ORIGIN[:2], ORIGIN[2] + (begin + shift) * SPACING[2])
    return data


def blocks(*data):
    result = vtkMultiBlockDataSet()
    for i, block in enumerate(data):
        result.SetBlock(i, block)
    return result


def on(rank, change):
    """Returns the change on one rank, None on the others."""
    return change if RANK == rank else None


def is_same_everywhere(text):
    value = zlib.crc32(text.encode())
    return reduced(value, vtkCommunicator.MIN_OP) == reduced(value, vtkCommunicator.MAX_OP)


def set_value(name, cell, value):
    def change(arrays):
        arrays[name][cell] = value
    return change


def test_nan_on_one_rank():
    for rank in range(RANKS):
        begin = N * rank // RANKS
        check_error(blocks(slab(on(rank, set_value("ball", (1, 4, 5), np.nan)))),
                    "'ball' holds nan", "cell (5, 4, %d)" % (begin + 1))


def test_bad_values_on_all_ranks():
    check_error(blocks(slab(set_value("plate", (0, 0, 0), 2.0 + RANK))), "'plate' holds",
                "cell (0, 0, ")


def test_sum_over_one():
    turned = (RANK + 2) % RANKS  # rank 1 has the lowest slab, which is filled by the plate
    check_error(blocks(slab(on(1, set_value("ball", (0, 1, 2), 1.0)), rank=turned)),
                "cell (2, 1, 0) sum to 2")


def test_labels_out_of_range():
    check_error(blocks(slab(on(2, set_value("id", (2, 3, 4), -6)))),
                "'id' holds -6 in cell (4, 3, 8)", MaterialIdArray="id")


def test_array_missing_on_one_rank():
    data = slab()
    if RANK == 1:
        data.GetCellData().RemoveArray("plate")
    check_error(blocks(data), "Block 0 of rank 1 has no numeric cell array 'plate'")


def test_wrong_wishes():
    """Invalid requests for refinement on one rank, a missing array, and an invalid box."""
    wishes = {"RefinementArray": "wish", "Refinement": "Automatic"}
    hold = lambda value: lambda arrays: arrays.update(wish=np.full(arrays["ball"].shape, value))
    check_error(slab(hold(-1.0 if RANK == 1 else 1.0)), "'wish' holds -1", "cell (0, 0, 3)",
                **wishes)
    check_error(slab(hold(1.0) if RANK != 2 else None), "no numeric cell array 'wish'", **wishes)
    check_error(slab(), "refinement box 1", Refinement="Automatic",
                RefinementBoxes=[1, 0, 0, 0, 1, 1, 1])


def set_state(dtype, components):
    def change(arrays):
        arrays["state"] = np.zeros((*arrays["ball"].shape, components), dtype)
    return change


def test_state_arrays_of_different_layouts():
    for one, other, words in (
            ((np.float64, 3), (np.float32, 3),
             ("3 components of type float,", "3 components of type double")),
            ((np.float32, 2), (np.float32, 1),
             ("1 component of type float,", "2 components of type float"))):
        for rank in (1, 2):
            change = set_state(*(other if RANK == rank else one))
            check_error(blocks(slab(change)),
                        "Block 0 of rank %d: the state array 'state' has" % rank, *words,
                        StateArrays=["ball", "state"])
    change = set_state(np.uint8, 1 + min(RANK, 1))
    check_error(blocks(slab(change)), "Block 0 of rank 1: the state array 'state'",
                StateArrays=["state"])


def test_state_array_missing_on_one_rank():
    for rank in range(RANKS):
        change = None if RANK == rank else set_state(np.float64, 1)
        check_error(blocks(slab(change)),
                    "Block 0 of rank %d has no numeric cell array 'state'" % rank,
                    StateArrays=["state"])


def test_state_array_with_a_name_of_the_mesh():
    check_error(blocks(slab()), "state array 'FragmentId'", StateArrays=["ball", "FragmentId"])


def test_state_arrays_of_ranks_without_blocks():
    change = set_state(np.int16, 2)
    data = [slab(change, rank) for rank in range(RANKS)] if RANK == 1 else []
    result = run(blocks(*data), StateArrays=["state"])
    array = result.mesh.GetCellData().GetArray("state")
    fits = (not result.errors and array.GetNumberOfComponents() == 2
            and array.GetNumberOfTuples() == result.mesh.GetNumberOfCells())
    assert reduced(int(fits), vtkCommunicator.MIN_OP) == 1, result.errors


def test_other_kind_on_one_rank():
    check_error(blocks(vtkPolyData() if RANK == 1 else slab()),
                "Block 0 of rank 1 is a vtkPolyData")


def test_points_and_matrices_of_ranks():
    """Arrays and matrices that determine the grid must agree on all ranks."""
    check_error(blocks(at_points(slab()) if RANK == 1 else slab()),
                "'ball' is cell data in some blocks, and point data")
    turned = [[0, -1, 0], [1, 0, 0], [0, 0, 1]]
    check_error(blocks(at_points(slab(), turned if RANK == 2 else None)),
                "different direction matrices")
    check_error(blocks(at_points(slab(), np.diag([1, 1, 2]) if RANK == 0 else None)),
                "Block 0 of rank 0 has the direction matrix")
    check_error(blocks(slab()), "No array is chosen", VolumeFractionArrays=[])


def test_single_array_on_some_ranks():
    data = slab(lambda arrays: [arrays.pop(name) for name in ("plate", "id")])
    result = run(blocks(data), VolumeFractionArrays=[])
    assert reduced(int(not result.errors and result.mesh.GetNumberOfCells() > 0),
                   vtkCommunicator.MAX_OP) == 1, result.errors
    more = slab(lambda arrays: [arrays.pop(name) for name in ("plate", "id") if RANK != 1])
    check_error(blocks(more), "No array is chosen", "'plate' is missing in some blocks",
                VolumeFractionArrays=[])


def test_levels_that_are_not_loaded():
    """A level without data gives one warning, unless another rank has data of that level."""
    for missing in (True, False):
        amr = vtkNonOverlappingAMR()
        set_boxes(amr, [RANKS, 1])
        amr.SetDataSet(0, RANK, slab(kind=vtkUniformGrid))
        if RANK == 2 and not missing:
            fine = slab(rank=0, kind=vtkUniformGrid)
            fine.SetSpacing([h / 2 for h in SPACING])
            amr.SetDataSet(1, 0, fine)
        told = sum("without data on level 1" in warning for warning in run(amr).warnings)
        assert reduced(told, vtkCommunicator.SUM_OP) == int(missing)


def test_gap_between_ranks():
    check_error(blocks(*([] if RANK == 1 else [slab()])), "leave a gap", "cell (0, 0, 3)")
    check_error(blocks(slab(shift=3 if RANK == 2 else 0)), "leave a gap", "cell (0, 0, 6)")


def test_overlap_of_ranks():
    check_error(blocks(slab(shift=-1 if RANK == 2 else 0)),
                "Block 0 of rank 1 and Block 0 of rank 2 overlap")


def test_no_cells_on_any_rank():
    check_error(blocks(), "no cells")


def test_levels_on_different_ranks():
    amr, part = vtkNonOverlappingAMR(), slab(kind=vtkUniformGrid)
    set_boxes(amr, [1, 1])
    amr.SetDataSet(RANK % 2, 0, part)
    if RANK == 1:
        part.SetSpacing([h / 2 for h in SPACING])
    check_error(amr, "leave a gap", "of level 0")


def test_option_out_of_range():
    check_error(blocks(slab()), "IsoValue", IsoValue=2.0)
    check_error(blocks(slab()), "IsoValue", make=VolumeFractionToTet, Method="Cells", IsoValue=2.0)


def test_tetgen_that_was_not_built_in():
    if "TetGen" not in TET_METHODS:
        check_error(blocks(slab()), "no TetGen", "Lattice", make=VolumeFractionToTet,
                    Method="TetGen")


def test_normalised_cells_are_counted_once():
    """A cell in the ghost layers of all ranks is counted once."""
    result = run(blocks(slab(on(0, set_value("ball", (1, 0, 0), 5e-4)))))
    assert not result.errors and result.field("NormalisedCells") == [1]
    assert len(result.warnings) == (1 if RANK == 0 else 0), result.warnings


def test_empty_field_is_no_error():
    result = run(blocks(slab(lambda arrays: [array.fill(0) for array in arrays.values()])))
    assert not result.errors and result.mesh.GetNumberOfCells() == 0
    assert result.field("MaterialNames") == ["ball", "plate"]


def test_the_same_filter_works_after_an_error():
    hexes = VolumeFractionToHex(Input=producer(blocks(slab())),
                                VolumeFractionArrays=["ball", "none"])
    algorithm = hexes.GetClientSideObject()
    errors, _ = collect(algorithm)
    hexes.UpdatePipeline()
    assert len(errors) == 1 and algorithm.GetOutputDataObject(0).GetNumberOfCells() == 0
    hexes.VolumeFractionArrays = ["ball", "plate"]
    hexes.UpdatePipeline()
    cells = reduced(algorithm.GetOutputDataObject(0).GetNumberOfCells(), vtkCommunicator.SUM_OP)
    assert len(errors) == 1 and cells > 100


main(globals())
