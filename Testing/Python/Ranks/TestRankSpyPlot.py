"""SpyPlot files read by several ranks with ParaView's reader.

usage: mpiexec -n 3 pvbatch --sym TestRankSpyPlot.py FOLDER

Each rank reads its part, or none; the mesh is that of an image.
"""
import os
import sys

from paraview import simple
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkParallelCore import vtkCommunicator, vtkMultiProcessController

from compare_meshes import difference, merge, read_pieces
from spyplot import split, write_spyplot
from spyplot_cases import (
    LAYOUTS, NODES, SPY, STATE, TIMES, data_of_step, refined_blocks, steps, without_reader_fields)
from vfmtest import VolumeFractionToHex, collect, main, producer, reduced, save_data, uniform

CONTROLLER = vtkMultiProcessController.GetGlobalController()
RANK, RANKS = CONTROLLER.GetLocalProcessId(), CONTROLLER.GetNumberOfProcesses()
FOLDER = os.path.join(sys.argv[1], "spyplot%d" % RANKS)
if RANK == 0:
    os.makedirs(FOLDER, exist_ok=True)


def write_case(name, blocks, files=1):
    """Writes the files on rank 0."""
    if RANK == 0:
        write_spyplot(FOLDER, name, TIMES, blocks, files)
    CONTROLLER.Barrier()
    return os.path.join(FOLDER, name + ".spcth")


def save(source, step, **properties):
    """Saves the mesh of a time step and returns its path; checks that no rank has messages."""
    hexes = VolumeFractionToHex(Input=source, VolumeFractionArrays=SPY, **properties)
    errors, warnings = collect(hexes.GetClientSideObject())
    path = os.path.join(FOLDER, "mesh.pvtu")
    hexes.UpdatePipeline(TIMES[step])
    save_data(path, hexes)
    assert reduced(len(errors + warnings), vtkCommunicator.SUM_OP) == 0, errors + warnings
    return path


def merged(path):
    """Returns the merged mesh on rank 0."""
    return merge([without_reader_fields(piece)
                  for piece in read_pieces(path)]) if RANK == 0 else None


def check(path, reference, what):
    problem = difference(merged(path), reference) if RANK == 0 else ""
    failed = reduced(int(bool(problem)), vtkCommunicator.SUM_OP)
    assert not failed, (what, problem)


def test_same_as_image():
    paths = [write_case("case%d" % i, split(NODES, steps(), counts), files)
             for i, (counts, files) in enumerate(LAYOUTS)]
    for to_bytes, step in ((True, 1), (False, 0), (False, 1)):
        whole = producer(data_of_step(step, to_bytes=to_bytes) if RANK == 0 else vtkImageData())
        reference = merged(save(whole, step, StateArrays=[STATE]))
        CONTROLLER.Barrier()
        for path, layout in zip(paths, LAYOUTS):
            for by_file in (0, 1):
                reader = simple.OpenDataFile(path)
                reader.CellArrays = [*SPY, STATE]
                reader.DistributeFiles, reader.DownConvertVolumeFraction = by_file, int(to_bytes)
                check(save(reader, step, StateArrays=[STATE]), reference,
                      (layout, by_file, to_bytes, step))


def test_refined():
    """The fine blocks repeat the coarse cells."""
    properties = dict(StateArrays=[STATE], ChildFractions="Parent")
    path = write_case("refined", refined_blocks(), files=2)
    whole = producer(data_of_step(0) if RANK == 0 else vtkImageData())
    reference = merged(save(whole, 0, **properties, **uniform(1)))
    CONTROLLER.Barrier()
    reader = simple.OpenDataFile(path)
    reader.CellArrays, reader.DownConvertVolumeFraction = [*SPY, STATE], 0
    check(save(reader, 0, **properties, **uniform(-1)), reference, "refined")


main(globals())
