"""What Apply does in the window, by Render alone: filters and sources that failed, even twice in a
row, work again once they can; each failure is shown once on a rank, with nothing after it. On a
screen; alone or mpiexec -n 3 pvbatch --sym TestApplies.py FOLDER."""
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
FAILING = RANKS // 2  # the rank where one alone fails
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
        """The errors that are shown on this rank."""
        window, usual = vtkStringOutputWindow(), vtkOutputWindow.GetInstance()
        vtkOutputWindow.SetInstance(window)
        try:
            self.display = self.display or simple.Show(self.proxy, VIEW)
            simple.Render(VIEW)
        finally:
            vtkOutputWindow.SetInstance(usual)
        return window.GetOutput().split("ERROR: ")[1:]

    def cells(self):
        """In the view, on all ranks."""
        cells = self.display.SMProxy.GetRepresentedDataInformation().GetNumberOfCells()
        return reduced(cells, vtkCommunicator.SUM_OP)

    def failure(self):
        return failure_of(self.proxy.GetClientSideObject().GetOutputDataObject(0))


def check_recovers(shown, fail, mend, words, check=None):
    """fail(time), twice; mend(). words: of the one message on this rank; or check: of its
    messages."""
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
    """Nothing is ticked; another property changes; the arrays are ticked."""
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
    """It shares with the other ranks what fails; the filter behind it has nothing to add."""
    for behind in (lambda reader: reader,
                   lambda reader: VolumeFractionToHex(Input=reader, MaterialIdArray="MaterialId")):
        reader = NumPyVoxelReader(FileName=["none"])
        check_recovers(Shown(behind(reader)),
                       lambda time: setattr(reader, "FileName", [at("none%d.npy" % time)]),
                       lambda: setattr(reader, "FileName", [at("good.npy")]), "Cannot read")


def test_another_reader():
    """ParaView's, that fails on one rank: there it says so, and the filter on the others."""
    reader = simple.XMLImageDataReader(FileName=[at("good3.vti")])
    hexes = VolumeFractionToHex(Input=reader, VolumeFractionArrays=["ball", "plate"])
    shown = Shown(hexes)
    assert is_everywhere(shown.render() == [])

    def set_name(time):
        """Another one on all ranks, which must update together."""
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
