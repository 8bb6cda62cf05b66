"""Voxels read in parts by several ranks.

usage: mpiexec -n 3 pvbatch --sym TestVoxelRanks.py FOLDER

The mesh is that of an image file. A damaged file is reported on all ranks.
"""
import os
import sys
import zlib

import numpy as np
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter
from vtkmodules.vtkParallelCore import vtkCommunicator

from compare_meshes import difference
from gold_meshes import CONTROLLER, RANK, RANKS, whole_mesh
from vfmtest import (
    ORIGIN, SPACING, NumPyVoxelReader, SculptVoxelReader, VolumeFractionToHex, VolumeFractionToTet,
    collect, image, held_class, main, reduced, simple)
from voxels import SIZE, grains, turned, write_numpy, write_text

FOLDER = os.path.join(sys.argv[1], "voxels%d" % RANKS)  # tests with other ranks run beside this
GRAINS = grains()
PLACE = dict(Origin=ORIGIN, Spacing=SPACING)
TEXT = dict(Dimensions=SIZE, **PLACE)


def at(name):
    return os.path.join(FOLDER, name)


def write_files():
    os.makedirs(FOLDER, exist_ok=True)
    writer = vtkXMLImageDataWriter()
    writer.SetInputData(image({"MaterialId": turned(GRAINS, "ZYX").astype(np.int32)}))
    writer.SetFileName(at("a.vti"))
    writer.SetDataModeToBinary()
    writer.Write()
    write_text(at("a.spn"), GRAINS)
    write_numpy(at("a.npy"), GRAINS)
    write_numpy(at("b.npy"), GRAINS, ">i8", "ZYX", True)
    write_text(at("small.spn"), np.array([[[1, 2]]]))
    write_text(at("bad_small.spn"), np.array([[[1, -2]]]))
    bad = GRAINS.astype(np.int32)
    bad[SIZE[0] - 1, SIZE[1] - 1, SIZE[2] - 1] = -4
    write_text(at("bad.spn"), bad)
    write_numpy(at("bad.npy"), bad, np.int32)


if RANK == 0:
    write_files()
CONTROLLER.Barrier()


def labels_mesher(source, make=VolumeFractionToHex, **properties):
    return make(Input=source, VolumeFractionArrays=[], MaterialIdArray="MaterialId", **properties)


def mesh(source, make, **properties):
    """Returns the merged mesh on rank 0."""
    mesher = labels_mesher(source, make, **properties)
    errors, _ = collect(mesher.GetClientSideObject())
    mesher.UpdatePipeline()
    mine = source.GetClientSideObject().GetOutputDataObject(0).GetNumberOfCells()
    assert reduced(int(not errors), vtkCommunicator.MIN_OP) == 1, errors
    assert reduced(mine, vtkCommunicator.SUM_OP) == GRAINS.size
    # Each rank reads only its part.
    assert reduced(mine, vtkCommunicator.MAX_OP) <= GRAINS.size // RANKS + GRAINS[:, :, 0].size
    return whole_mesh(mesher, at("mesh.pvtu"))


def test_same_mesh():
    for make, properties in ((VolumeFractionToHex, {}),
                             (VolumeFractionToTet, {"Method": "Lattice"})):
        gold = mesh(simple.OpenDataFile(at("a.vti")), make, **properties)
        for name, options in (("a.spn", TEXT), ("a.npy", PLACE),
                              ("b.npy", dict(AxisOrder="ZYX", **PLACE))):
            merged = mesh(simple.OpenDataFile(at(name), **options), make, **properties)
            problem = difference(merged, gold) if RANK == 0 else ""
            assert not problem, "%s: %s" % (name, problem)


def test_more_ranks_than_cells():
    source = simple.OpenDataFile(at("small.spn"), Dimensions=(1, 1, 2))
    mesher = labels_mesher(source, StairStep=1)
    errors, _ = collect(mesher.GetClientSideObject())
    mesher.UpdatePipeline()
    cells = mesher.GetClientSideObject().GetOutputDataObject(0).GetNumberOfCells()
    assert reduced(cells, vtkCommunicator.SUM_OP) == 2 and not errors, errors


def is_same_everywhere(texts):
    value = zlib.crc32(repr(texts).encode())
    return reduced(value, vtkCommunicator.MIN_OP) == reduced(value, vtkCommunicator.MAX_OP)


def check_refused(source, text):
    """Checks that reader and filter fail on all ranks with one message, and that no rank waits."""
    mesher = labels_mesher(source)
    errors, _ = collect(held_class(source))
    source.GetClientSideObject().GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
    filter_errors, _ = collect(mesher.GetClientSideObject())
    mesher.UpdatePipeline()
    # The path may differ between ranks.
    same = is_same_everywhere([error.split("Cannot read ")[1].split(": ", 1)[1]
                               for error in errors])
    same_filter = is_same_everywhere([error.split("): ", 1)[1] for error in filter_errors])
    assert same and len(set(errors)) == 1 and text in errors[0], (same, errors)
    assert same_filter and len(errors) == len(filter_errors) == 1, (
        same_filter, errors, filter_errors)
    assert "The input could not be made: Cannot read " in filter_errors[0], filter_errors
    assert mesher.GetClientSideObject().GetOutputDataObject(0).GetNumberOfCells() == 0


def test_refused():
    check_refused(SculptVoxelReader(FileName=[at("none.spn")], **TEXT), "No such file")
    check_refused(NumPyVoxelReader(FileName=[at("none.npy")]), "No such file")
    check_refused(simple.OpenDataFile(at("a.spn")), "Set Dimensions")
    check_refused(simple.OpenDataFile(at("a.spn"), Dimensions=(9, 11, 14)), "holds 1287 values")
    check_refused(simple.OpenDataFile(at("bad_small.spn"), Dimensions=(1, 1, 2)),
                  "the label -2 is negative")
    check_refused(simple.OpenDataFile(at("bad.spn"), **TEXT), "the label -4 is negative")
    check_refused(simple.OpenDataFile(at("bad.npy")), "the label of cell (8, 10, 12) is -4.")


def test_missing_on_one_rank():
    for rank in range(RANKS):
        name = at("none.npy" if RANK == rank else "a.npy")
        check_refused(NumPyVoxelReader(FileName=[name]), "No such file")


main(globals())
