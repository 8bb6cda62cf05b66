"""Images read by several ranks, each a part, or distributed by rank 0.

usage: mpiexec -n 3 pvbatch --sym TestImageRanks.py FOLDER

The mesh is that of the same labels as cells. A damaged file is reported on all ranks.
"""
import os
import sys
import zlib

from vtkmodules.vtkParallelCore import vtkCommunicator

import numpy as np

from compare_meshes import difference
from gold_meshes import CONTROLLER, RANK, RANKS, whole_mesh
from image_files import (
    CARET, save, write_dream3d, write_meta, write_nifti, write_nrrd, write_pages, write_tiff)
from vfmtest import (
    ORIGIN, SPACING, LabelImageReader, LabelSlicesReader, VolumeFractionToHex, collect, image,
    held_class, main, reduced, write, simple)
from voxels import grains, turned

FOLDER = os.path.join(sys.argv[1], "images")
LABELS = turned(grains(), "ZYX").astype("u1")
MIDDLE = np.add(ORIGIN, np.multiply(SPACING, 0.5))  # centre of the first voxel


def at(name):
    return os.path.join(FOLDER, name)


def write_files():
    os.makedirs(FOLDER, exist_ok=True)
    write(image({"Labels": LABELS.astype("i4")}), at("cells.vti"))
    write_nifti(at("a.nii.gz"), LABELS, MIDDLE)
    write_nrrd(at("a.nrrd"), LABELS, MIDDLE, encoding="raw")
    write_nrrd(at("b.nrrd"), LABELS, MIDDLE)
    write_meta(at("a.mha"), LABELS, MIDDLE)
    write_dream3d(at("a.dream3d"), LABELS, ORIGIN, SPACING)
    write_tiff(at("a.tif"), LABELS)
    write_nifti(at("names.nii.gz"), LABELS, MIDDLE, extension=CARET)
    for number, page in enumerate(LABELS):
        write_pages(at("slice_%d.tif" % number), page[None])
    with open(write_nrrd(at("cut.nrrd"), LABELS, MIDDLE), "r+b") as file:
        file.truncate(400)
    save(at("text.nii"), b"hello\n" * 99)


if RANK == 0:
    write_files()
CONTROLLER.Barrier()


def mesher_of(source, name="Labels"):
    return VolumeFractionToHex(Input=source, VolumeFractionArrays=[], MaterialIdArray=name)


def mesh(source, name="Labels"):
    """Returns the merged mesh on rank 0."""
    mesher = mesher_of(source, name)
    errors, _ = collect(mesher.GetClientSideObject())
    mesher.UpdatePipeline()
    assert reduced(int(not errors), vtkCommunicator.MIN_OP) == 1, errors
    mine = source.GetClientSideObject().GetOutputDataObject(0).GetNumberOfCells()
    assert reduced(mine,
                   vtkCommunicator.MAX_OP) <= LABELS.size // RANKS + LABELS[
                       0].size, "a rank keeps more than its part"
    return whole_mesh(mesher, at("mesh.pvtu"))


def test_same_mesh():
    gold = mesh(simple.OpenDataFile(at("cells.vti")))
    for name in ("a.nii.gz", "a.nrrd", "b.nrrd", "a.mha", "a.dream3d"):
        merged = mesh(simple.OpenDataFile(at(name)),
                      "FeatureIds" if name.endswith("dream3d") else "Labels")
        problem = difference(merged, gold) if RANK == 0 else ""
        assert not problem, "%s: %s" % (name, problem)
    gold = mesh(LabelImageReader(FileName=[at("a.tif")], Spacing=SPACING))
    assert reduced(int(gold is None), vtkCommunicator.SUM_OP) == RANKS - 1
    slices = [at("slice_%d.tif" % number) for number in range(len(LABELS))]
    for files in (slices, [at("slice_*.tif")]):
        merged = mesh(LabelSlicesReader(FileNames=files, Spacing=SPACING))
        problem = difference(merged, gold) if RANK == 0 else ""
        assert not problem, "%s: %s" % (files[0], problem)


def test_names():
    """All ranks name the materials as the file does."""
    mesher = mesher_of(simple.OpenDataFile(at("names.nii.gz")))
    mesher.UpdatePipeline()
    names = mesher.GetClientSideObject().GetOutputDataObject(0).GetFieldData().GetAbstractArray(
        "MaterialNames")
    found = [names.GetValue(i) for i in range(names.GetNumberOfValues())]
    same = reduced(int(found == ["liver", "left kidney", "liver (3)", "Material 4"]),
                   vtkCommunicator.MIN_OP)
    assert same == 1, found


def is_same_everywhere(texts):
    value = zlib.crc32(repr(texts).encode())
    return reduced(value, vtkCommunicator.MIN_OP) == reduced(value, vtkCommunicator.MAX_OP)


def test_refused():
    """All ranks report an error in the header, or in the values that rank 0 reads."""
    for name, text in (("text.nii", "it is not a NIfTI file"),
                       ("cut.nrrd", "its compressed values are truncated"),
                       ("none.mha", "No such file")):
        source = LabelImageReader(FileName=[at(name)])
        errors, _ = collect(held_class(source))
        source.GetClientSideObject().GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
        mesher = mesher_of(source)
        collect(mesher.GetClientSideObject())
        mesher.UpdatePipeline()
        same = is_same_everywhere([error.split("Cannot read ")[1] for error in errors])
        assert same and len(set(errors)) == 1 and text in errors[0], (name, same, errors)


main(globals())
