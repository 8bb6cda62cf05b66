"""The filter in a pipeline: writers, time steps, abort, progress, plain VTK."""
import os
import tempfile

import numpy as np
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkIOExodus import vtkExodusIIReader
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

from exodus_dump import Dump
from vfmtest import (
    collect, digest, failure_of, fraction_image, ghost_cells, has_tetgen, main, mesh_of, producer,
    Result, save_data, VolumeFractionShapes, VolumeFractionToHex, VolumeFractionToTet, simple)


N = 10
DATA = fraction_image(N)

# A layer that grows by one cell per time step. RequestInformation uses the same variables.
GROWING_INFORMATION = """
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as p
info = self.GetOutputInformation(0)
info.Set(p.WHOLE_EXTENT(), (0, 4, 0, 4, 0, 8), 6)
info.Set(p.TIME_STEPS(), [0.0, 1.0, 2.0], 3)
info.Set(p.TIME_RANGE(), [0.0, 2.0], 2)
"""
GROWING = """
import numpy as np
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as p
time = self.GetOutputInformation(0).Get(p.UPDATE_TIME_STEP())
image = self.GetImageDataOutput()
image.SetDimensions(5, 5, 9)
filled = np.repeat(np.arange(8) < 3 + time, 16).astype(float)
output.CellData.append(filled, "water")
"""


def hex_filter():
    return VolumeFractionToHex(Input=producer(DATA), VolumeFractionArrays=["ball", "plate"])


def count_runs(hexes):
    runs = []
    hexes.GetClientSideObject().AddObserver("StartEvent", lambda *_: runs.append(1))
    return runs


def test_one_run_for_all_ports_and_writers():
    """The filter runs once for all ports and writers, also with a filter for ghost cells."""
    hexes = hex_filter()
    runs = count_runs(hexes)
    with tempfile.TemporaryDirectory() as folder:
        save_data(os.path.join(folder, "mesh.pvtu"), hexes)
        save_data(os.path.join(folder, "mesh.vtu"), hexes)
        for port in ("Surfaces", "Curves", "Vertices"):
            save_data(os.path.join(folder, port + ".vtp"), simple.OutputPort(hexes, port))
        hexes.UpdatePipeline()
        again = simple.XMLPartitionedUnstructuredGridReader(
            FileName=[os.path.join(folder, "mesh.pvtu")])
        again.UpdatePipeline()
        assert (again.GetDataInformation().GetNumberOfCells()
                == hexes.GetDataInformation().GetNumberOfCells())
    assert len(runs) == 1, len(runs)
    ghosts = ghost_cells(hexes)
    ghosts.UpdatePipeline()
    assert (ghosts.GetDataInformation().GetNumberOfCells()
            == hexes.GetDataInformation().GetNumberOfCells())
    assert len(runs) == 1, len(runs)


def test_vtu_round_trip():
    result = mesh_of(DATA)
    hexes = hex_filter()
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "mesh.vtu")
        save_data(path, hexes)
        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(path)
        reader.Update()
    again = mesh_of(DATA)
    again.mesh = reader.GetOutput()
    assert digest(again) == digest(result)
    for name in ("MaterialNames", "MaterialIds", "MeshVolume", "FlippedCells"):
        assert again.field(name) == result.field(name)


def test_exodus_round_trip():
    result = mesh_of(DATA, MeshVoid=1)
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "mesh.e")
        simple.SaveData(path, proxy=producer(result.mesh))
        reader = vtkExodusIIReader()
        reader.SetFileName(path)
        reader.UpdateInformation()
        reader.GenerateGlobalElementIdArrayOn()
        reader.SetAllArrayStatus(vtkExodusIIReader.ELEM_BLOCK, 1)
        reader.Update()
        blocks = reader.GetOutput().GetBlock(0)
    assert blocks.GetNumberOfBlocks() == 3
    ids = []
    # The void has the largest block number.
    for i, (material, name) in enumerate(((1, "ball"), (2, "plate"), (0, "Void"))):
        assert blocks.GetMetaData(i).Get(blocks.NAME()) == name
        block = blocks.GetBlock(i)
        found = [block.GetCellData().GetArray("GlobalElementId").GetValue(c)
                 for c in range(block.GetNumberOfCells())]
        assert len(found) == (result.cells("MaterialId") == material).sum()
        assert set(found) == set(
            result.cells("GlobalCellIds")[result.cells("MaterialId") == material])
        ids += found
    assert len(ids) == result.mesh.GetNumberOfCells()


def test_exodus_series():
    """A series has one file per time step, each with its time."""
    source = simple.ProgrammableSource(
        OutputDataSetType="vtkImageData", Script=GROWING,
        ScriptRequestInformation=GROWING_INFORMATION)
    hexes = VolumeFractionToHex(Input=source, VolumeFractionArrays=["water"])
    with tempfile.TemporaryDirectory() as folder:
        simple.SaveData(os.path.join(folder, "mesh.exo"), proxy=hexes, Writetimestepsasfileseries=1)
        dumps = [Dump(os.path.join(folder, "mesh_%d.exo" % step)) for step in range(3)]
        assert len(os.listdir(folder)) == 3 + os.path.exists(
            os.path.join(folder, "mesh.exo.series"))
    assert [dump.get("time_whole")[0] for dump in dumps] == [0, 1, 2]
    assert dumps[0].size("num_elem") < dumps[1].size("num_elem") < dumps[2].size("num_elem")


def test_progress_and_abort():
    """An abort leaves empty outputs without an error; progress increases from 0 to 1."""
    hexes = hex_filter()
    algorithm = hexes.GetClientSideObject()
    seen = []

    def on_progress(caller, _):
        seen.append((caller.GetProgress(), caller.GetProgressText()))
        if caller.GetProgress() > stop_at[0]:
            caller.SetAbortExecute(1)

    algorithm.AddObserver("ProgressEvent", on_progress)
    errors, _ = collect(algorithm)
    stop_at = [0.0]
    algorithm.Update()
    assert not errors and len([fraction for fraction, _ in seen if 0 < fraction < 1]) == 1, seen
    for port in range(2):
        assert algorithm.GetOutputDataObject(port).GetNumberOfPoints() == 0
    stop_at[0] = 2.0
    algorithm.Modified()
    seen.clear()
    algorithm.Update()
    assert not errors and algorithm.GetOutputDataObject(0).GetNumberOfCells() > 0
    fractions = [fraction for fraction, _ in seen]
    assert fractions == sorted(fractions) and fractions[0] == 0 and fractions[-1] == 1
    assert len({text for _, text in seen if text}) >= 3, seen


class Progress:
    """Records the progress of an algorithm and aborts it beyond a fraction."""

    def __init__(self, algorithm):
        self.seen, self.stop_beyond = [], 2.0
        algorithm.AddObserver("ProgressEvent", self.see)

    def see(self, caller, _):
        self.seen.append((caller.GetProgress(), caller.GetProgressText()))
        if self.stop_beyond < caller.GetProgress() < 1:
            caller.SetAbortExecute(1)


def check_long_stage(proxy, text, least, threads):
    """Checks progress and abort within a stage.

    The stage reports at least `least` values, in order. An abort ends it without error or output.
    """
    proxy.NumberOfThreads = threads
    proxy.UpdateVTKObjects()
    algorithm = proxy.GetClientSideObject()
    errors, _ = collect(algorithm)
    progress = Progress(algorithm)
    algorithm.Update()
    fractions = [fraction for fraction, _ in progress.seen]
    own = [fraction for fraction, stage in progress.seen if stage == text and fraction < 1]
    assert fractions == sorted(fractions) and fractions[-1] == 1 and not errors
    assert len(set(own)) >= least and own[-1] - own[0] > 0.7, own
    assert np.diff(own).max() < 0.3, own
    middle = progress.stop_beyond = own[len(own) // 2]
    progress.seen.clear()
    algorithm.Modified()
    algorithm.Update()
    output = algorithm.GetOutputDataObject(0)
    assert not errors and failure_of(output) is None
    assert output.GetNumberOfPoints() == 0 or output.GetCellData().GetNumberOfArrays() == 0
    assert len([fraction for fraction, _ in progress.seen
                if middle < fraction < 1]) == 1, progress.seen
    progress.stop_beyond = 2.0
    algorithm.Modified()
    algorithm.Update()
    assert algorithm.GetOutputDataObject(0).GetCellData().GetNumberOfArrays() > 0


def test_long_stages():
    for threads in (1, 2):
        check_long_stage(VolumeFractionShapes(Preset="Sphere", Dimensions=[64, 64, 64]),
                         "Computing fractions", 20, threads)
    if has_tetgen():
        tets = VolumeFractionToTet(Input=producer(DATA), VolumeFractionArrays=["ball", "plate"],
                                   Method="TetGen")
        check_long_stage(tets, "Filling with TetGen", 20, 2)


def test_input_is_not_changed():
    before = [DATA.GetCellData().GetArray(i).GetRange() for i in range(2)]
    modified = DATA.GetMTime()
    mesh_of(DATA)
    assert [DATA.GetCellData().GetArray(i).GetRange() for i in range(2)] == before
    assert DATA.GetCellData().GetNumberOfArrays() == 2 and DATA.GetMTime() == modified


def test_state_survives_a_second_run():
    """A second run gives the same mesh."""
    hexes = hex_filter()
    hexes.UpdatePipeline()
    algorithm = hexes.GetClientSideObject()
    first = digest(Result(algorithm, [], []))
    algorithm.Modified()
    algorithm.Update()
    assert digest(Result(algorithm, [], [])) == first


def test_time_steps():
    """Meshes of several times, in any order.

    This must be the last test of the script: ParaView runs the
    source in this module and hides max, sorted and others.
    """
    source = simple.ProgrammableSource(
        OutputDataSetType="vtkImageData", Script=GROWING,
        ScriptRequestInformation=GROWING_INFORMATION)
    hexes = VolumeFractionToHex(Input=source, VolumeFractionArrays=["water"])
    hexes.UpdatePipelineInformation()
    steps = hexes.GetClientSideObject().GetOutputInformation(0).Get(
        vtkStreamingDemandDrivenPipeline.TIME_STEPS())
    assert list(steps) == [0, 1, 2]
    for time in (0, 2, 1):
        hexes.UpdatePipeline(time)
        information = hexes.GetDataInformation()
        volume = hexes.FieldData["TargetVolume"].GetRange()[0]
        assert abs(volume - 16 * (3 + time)) < 1e-9, (time, volume)
        bounds = information.GetBounds()
        assert abs(bounds[5] - bounds[4] - (3 + time)) < 0.05, (time, bounds)


main(globals())
