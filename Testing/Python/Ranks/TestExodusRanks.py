"""Exodus files saved by all ranks of pvbatch.

usage: mpiexec -n P pvbatch --sym TestExodusRanks.py FOLDER
"""
import os
import sys
import traceback

from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkUnstructuredGrid
from vtkmodules.vtkParallelCore import vtkCommunicator, vtkMultiProcessController

from compare_meshes import read_pieces
from exodus_dump import Dump, check_parts, join
from vfmtest import (
    ball_and_plate, collect, image, held_class, main, producer, reduced, save_data,
    VolumeFractionToHex, VolumeFractionToTet, servermanager, simple)

CONTROLLER = vtkMultiProcessController.GetGlobalController()
RANK, RANKS = CONTROLLER.GetLocalProcessId(), CONTROLLER.GetNumberOfProcesses()
FOLDER = os.path.join(sys.argv[1], "exodus%d" % RANKS)


def on_first_rank(work):
    """Calls work() on rank 0 and fails on all ranks if it fails."""
    problem = ""
    try:
        if RANK == 0:
            work()
    except Exception:
        problem = traceback.format_exc()
    assert reduced(int(bool(problem)), vtkCommunicator.MAX_OP) == 0, problem or "see rank 0"


def mesher_of(make=VolumeFractionToHex, factor=1.0, n=12, **properties):
    """Makes a mesher of the ball and the plate, in slabs along z; `factor` scales the fractions."""
    low, high = n * RANK // RANKS, n * (RANK + 1) // RANKS
    arrays = dict(zip(("ball", "plate"), ball_and_plate(n)))
    blocks = vtkMultiBlockDataSet()
    blocks.SetBlock(0,
                    image({name: factor * array[low:high] for name, array in arrays.items()},
                          (0, 0, low)))
    return make(Input=producer(blocks), VolumeFractionArrays=["ball", "plate"], **properties)


def save(proxy, name):
    """Saves parts, ParaView's pieces and the single file; returns them on rank 0."""
    path = lambda ending: os.path.join(FOLDER, name + ending)
    simple.SaveData(path(".exo"), proxy=proxy)
    simple.SaveData(path("_single.exo"), proxy=proxy, SingleFile=1)
    save_data(path(".pvtu"), proxy)
    CONTROLLER.Barrier()
    if RANK > 0:
        return None, None, None
    parts = [Dump("%s.%d.%d" % (path(".exo"), RANKS, rank)) for rank in range(RANKS)]
    return parts, read_pieces(path(".pvtu")), Dump(path("_single.exo"))


def check(parts, pieces, single):
    check_parts(parts)
    assert join(parts) == join([single])
    filled = [piece.GetNumberOfCells() for piece in pieces if piece.GetNumberOfCells()]
    assert [dump.size("num_elem") for dump in parts if dump.size("num_elem")] == filled
    assert {"ball_to_plate", "plate_to_ball",
            "x_min"} <= set(parts[-1].names("ss")), parts[-1].names("ss")


def make_folder():
    os.makedirs(FOLDER, exist_ok=True)


def test_parts_and_single_file():
    on_first_rank(make_folder)
    for name, mesher in (("hexes", mesher_of()),
                         ("tets", mesher_of(VolumeFractionToTet, Method="Cells", MeshVoid=1))):
        files = save(mesher, name)
        on_first_rank(lambda: check(*files))


def test_rank_without_elements():
    """The part of a rank without elements has all names and arrays."""
    mesher = mesher_of()
    mesher.UpdatePipeline()
    mesh = mesher.GetClientSideObject().GetOutputDataObject(0)
    files = save(producer(mesh if RANK < RANKS - 1 else vtkUnstructuredGrid()), "part")

    def check_empty():
        parts, pieces, single = files
        check(parts, pieces, single)
        assert parts[-1].size("num_elem") == 0 < parts[0].size("num_elem")
        assert parts[-1].names("eb") == ["ball",
                                         "plate"] and parts[-1].globals() == parts[0].globals()
    on_first_rank(check_empty)


def test_refused_on_all_ranks():
    cases = ((mesher_of(), os.path.join("missing", "mesh.exo"), "No such file"),
             (mesher_of(factor=0.0), "void.exo", "mesh is empty"))
    for mesher, name, text in cases:
        for single in (0, 1):
            path = os.path.join(FOLDER, name)
            writer = servermanager.writers.VolumeFractionExodusWriter(
                Input=mesher, FileName=path, SingleFile=single)
            errors, _ = collect(held_class(writer))
            collect(mesher.GetClientSideObject())
            writer.UpdatePipeline()
            assert len(errors) == 1 and text in errors[0], errors
    assert not [name for name in os.listdir(FOLDER) if name.startswith("void")]


main(globals())
