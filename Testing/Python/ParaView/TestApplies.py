"""Apply in the ParaView GUI, by Render only.

usage: pvpython TestApplies.py [FOLDER], or mpiexec -n 3 pvbatch --sym TestApplies.py FOLDER

Filters and sources that failed, even twice in a row, work again as soon as they can. Each failure
is shown once per rank, and no other message follows. A screen is required.
"""
import os
import sys
import tempfile

import numpy as np
from paraview import simple
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow
from vtkmodules.vtkParallelCore import vtkCommunicator, vtkMultiProcessController

from vfmtest import failure_of, fraction_image, labels, main, reduced, write, VolumeFractionToHex
from vfmtest import NumPyVoxelReader, VolumeFractionFragments, VolumeFractionShapes

BALL_AND_PLATE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "Data",
                              "ball_and_plate.vti")
CONTROLLER = vtkMultiProcessController.GetGlobalController()
RANK, RANKS = CONTROLLER.GetLocalProcessId(), CONTROLLER.GetNumberOfProcesses()
FAILING = RANKS // 2  # the rank of failures on one rank
FOLDER = sys.argv[1] if len(sys.argv) > 1 else tempfile.mkdtemp()
VIEW = simple.CreateView("RenderView")


def at(name):
    return os.path.join(FOLDER, name)


def is_everywhere(condition):
    return reduced(int(bool(condition)), vtkCommunicator.MIN_OP) == 1


class Shown:
    """A proxy in the view."""

    def __init__(self, proxy):
        self.proxy, self.display = proxy, None

    def render(self):
        """Renders the view and returns the errors shown on this rank."""
        window, usual = vtkStringOutputWindow(), vtkOutputWindow.GetInstance()
        vtkOutputWindow.SetInstance(window)
        try:
            self.display = self.display or simple.Show(self.proxy, VIEW)
            simple.Render(VIEW)
        finally:
            vtkOutputWindow.SetInstance(usual)
        return window.GetOutput().split("ERROR: ")[1:]

    def cells(self):
        """Returns the number of cells in the view on all ranks."""
        cells = self.display.SMProxy.GetRepresentedDataInformation().GetNumberOfCells()
        return reduced(cells, vtkCommunicator.SUM_OP)

    def failure(self):
        return failure_of(self.proxy.GetClientSideObject().GetOutputDataObject(0))


def check_recovers(shown, fail, mend, words, check=None):
    """Calls fail(time) twice, then mend(), and checks the messages.

    words: part of the single message on this rank;
    check: function that checks all messages instead.
    """
    for time in range(2):
        fail(time)
        errors = shown.render()
        good = check(errors) if check else len(errors) == 1 and words in errors[0]
        assert is_everywhere(good and shown.failure()), (time, errors, shown.failure())
        assert is_everywhere(shown.render() == []), "said again"
    mend()
    errors = shown.render()
    assert is_everywhere(errors == [] and shown.failure() is None), errors
    assert shown.cells() > 0


def ball_and_plate():
    return simple.XMLImageDataReader(FileName=[BALL_AND_PLATE])


def test_three_applies():
    """Apply without any array, after another change, and with selected arrays."""
    hexes = VolumeFractionToHex(Input=ball_and_plate(), VolumeFractionArrays=[])
    check_recovers(Shown(hexes), lambda time: setattr(hexes, "StairStep", time),
                   lambda: setattr(hexes, "VolumeFractionArrays", ["ball", "plate"]),
                   "No array is chosen")


def make_input():
    if RANK == 0:
        os.makedirs(FOLDER, exist_ok=True)
        np.save(at("good.npy"), np.ascontiguousarray(labels(9).transpose(2, 1, 0)).astype(np.int32))
        for time in range(4):
            write(fraction_image(9), at("good%d.vti" % time))
    CONTROLLER.Barrier()


def test_our_reader():
    """The plugin's reader fails on all ranks; the filter downstream adds no message."""
    for behind in (lambda reader: reader,
                   lambda reader: VolumeFractionToHex(Input=reader, MaterialIdArray="MaterialId")):
        reader = NumPyVoxelReader(FileName=["none"])
        check_recovers(Shown(behind(reader)),
                       lambda time: setattr(reader, "FileName", [at("none%d.npy" % time)]),
                       lambda: setattr(reader, "FileName", [at("good.npy")]), "Cannot read")


def test_another_reader():
    """ParaView's reader fails on one rank: it reports there, the filter on the other ranks."""
    reader = simple.XMLImageDataReader(FileName=[at("good3.vti")])
    hexes = VolumeFractionToHex(Input=reader, VolumeFractionArrays=["ball", "plate"])
    shown = Shown(hexes)
    assert is_everywhere(shown.render() == [])

    def set_name(time):
        """Sets a new name on all ranks, which must update together."""
        reader.FileName = [at("%s%d.vti" % ("none" if RANK == FAILING and time < 2 else "good",
                                            time))]

    def check(errors):
        if RANK == FAILING:
            return errors and not any("VolumeFraction" in error or "on rank" in error
                                      for error in errors)
        return len(errors) == 1 and "The input could not be made on rank %d." % FAILING in errors[0]

    check_recovers(shown, set_name, lambda: set_name(2), None, check)


def test_shapes():
    for behind in (lambda shapes: shapes,
                   lambda shapes: VolumeFractionToHex(Input=shapes,
                                                      VolumeFractionArrays=["Material1"])):
        shapes = VolumeFractionShapes(Preset="Sphere")
        check_recovers(Shown(behind(shapes)),
                       lambda time: setattr(shapes, "Dimensions", [time, 0, 0]),
                       lambda: setattr(shapes, "Dimensions", [12, 12, 12]), "Dimensions are")
        check_recovers(Shown(behind(shapes)),
                       lambda time: setattr(shapes, "Shapes", "cat %d" % time),
                       lambda: setattr(shapes, "Shapes", ""), "Shapes, line 1")


def test_filters_behind_add_nothing():
    hexes = VolumeFractionToHex(Input=ball_and_plate(), VolumeFractionArrays=[])
    assert is_everywhere(len(Shown(hexes).render()) == 1)
    for make in (simple.Clip, simple.Slice, simple.Threshold, simple.MeshQuality,
                 simple.ExtractSurface, simple.CellDatatoPointData, VolumeFractionFragments):
        behind = make(Input=hexes)
        shown = Shown(behind)
        if make is not VolumeFractionFragments:
            assert is_everywhere(shown.render() == []), make
        behind.UpdatePipeline()
        assert is_everywhere("No array is chosen" in shown.failure()), make


make_input()
main(globals())
