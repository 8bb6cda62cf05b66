"""Readers of voxels, .spn and .npy.

The proxies, the class and `sculptor` give the mesh of
the same image in memory. Damaged files give one message.
"""
import os
import struct
import sys

import numpy as np
from numpy.lib import format as numpy_format
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline

from compare_meshes import difference, merge, read_pieces
from mpi_run import mpi_run
from sculptor_program import SCULPTOR
from vfmtest import (
    ORIGIN, SPACING, VolumeFractionToHex, VolumeFractionToTet, ball_and_plate, collect, failure_of,
    image, in_folder, main, mesh_of, simple)
from voxels import ORDERS, SIZE, grains, turned, write_numpy, write_text

sys.path.insert(0, os.environ["VFM_WRAPPERS"])
from volumefractionmesh.vtkVolumeFractionMeshFilters import vtkVolumeFractionToHex
from volumefractionmesh.vtkVolumeFractionMeshIO import vtkVolumeFractionVoxelReader

GRAINS = grains()
PLACE = dict(Origin=ORIGIN, Spacing=SPACING)
PLACED = ["--origin", ",".join(map(str, ORIGIN)), "--spacing", ",".join(map(str, SPACING))]
SIZED = ["--dimensions", ",".join(map(str, SIZE))]
# {NumPy type: VTK type that it is read as}
DTYPES = {"?": 3, "u1": 3, "i1": 15, "u2": 5, "i2": 4, "u4": 6, "i4": 6, "u8": 6, "i8": 6}


def grain_image():
    return image({"MaterialId": turned(GRAINS, "ZYX").astype(np.int32)})


def meshes(source, make=VolumeFractionToHex, **properties):
    """Returns the merged mesh of the labels of a source."""
    mesher = make(Input=source, VolumeFractionArrays=[], MaterialIdArray="MaterialId", **properties)
    errors, _ = collect(mesher.GetClientSideObject())
    mesher.UpdatePipeline()
    assert not errors, errors
    return merge([mesher.GetClientSideObject().GetOutputDataObject(0)])


def expected(make=VolumeFractionToHex, **properties):
    result = mesh_of(grain_image(), make, MaterialIdArray="MaterialId", **properties)
    assert sorted(set(result.cells("MaterialId"))) == [1, 2, 3, 4]
    return merge([result.mesh])


def check_same(one, other, what):
    problem = difference(one, other)
    assert not problem, "%s: %s" % (what, problem)


def reader(path, size=SIZE, order="XYZ"):
    it = vtkVolumeFractionVoxelReader()
    it.SetFileName(path)
    it.SetDimensions(size)
    it.SetOrigin(ORIGIN)
    it.SetSpacing(SPACING)
    it.SetAxisOrder(ORDERS.index(order))
    return it


def read(path, **options):
    """Returns the image that the reader class reads."""
    it = reader(path, **options)
    errors, _ = collect(it)
    it.Update()
    assert not errors, errors
    return it.GetOutput()


def values(data, name="MaterialId"):
    """Returns the cell array as a[x, y, z]."""
    return vtk_to_numpy(data.GetCellData().GetArray(name)).reshape(
        [max(n - 1, 1) for n in data.GetDimensions()], order="F")


@in_folder
def test_same_mesh_by_the_proxies(at):
    """ParaView opens each file with the right reader; the mesh is that of the image."""
    for make, properties in ((VolumeFractionToHex, {}),
                             (VolumeFractionToTet, {"Method": "Lattice"})):
        gold = expected(make, **properties)
        for path, options in (
                (write_text(at("a.spn"), GRAINS), dict(Dimensions=SIZE)),
                (write_text(at("b.spn"), GRAINS, "ZYX"), dict(Dimensions=SIZE, AxisOrder="ZYX")),
                (write_numpy(at("c.npy"), GRAINS), {}),
                (write_numpy(at("D.NPY"), GRAINS, ">i8", fortran=True), {}),
                (write_numpy(at("e.npy"), GRAINS, "i2", "ZYX"), dict(AxisOrder="ZYX"))):
            source = simple.OpenDataFile(path, **PLACE, **options)
            assert type(source).__name__ == ("SculptVoxelReader" if path.endswith("spn")
                                             else "NumPyVoxelReader")
            check_same(meshes(source, make, **properties), gold, path)


@in_folder
def test_same_mesh_by_sculptor(at):
    """sculptor gives the mesh of the image on 1 and 3 ranks, for each order of axes."""
    text, array = write_text(at("a.spn"), GRAINS), write_numpy(at("a.npy"), GRAINS)
    turned_text = write_text(at("z.spn"), GRAINS, "ZYX")
    for make, options, properties in ((VolumeFractionToHex, [], {}),
                                      (VolumeFractionToTet, ["--tetmesh", "lattice"],
                                       {"Method": "Lattice"})):
        gold = expected(make, **properties)
        for arguments in ([text, *SIZED], [array], [turned_text, *SIZED, "--axis-order", "zyx"]):
            for ranks in (1, 3):
                output = at("out.vtu")
                result = mpi_run(ranks,
                                 [SCULPTOR, "--input", *arguments, *PLACED, *options, "--output",
                                  output])
                assert result.returncode == 0 and result.stderr.count("\n") == 1, result
                assert "Label 0 of the array 'MaterialId' is read as void" in result.stderr
                assert "materials from MaterialId (labels, the only array of" in result.stdout
                check_same(merge(read_pieces(output)), gold, (arguments, ranks))
                os.remove(output)


@in_folder
def test_sculptor_keeps_materials(at):
    """--material selects labels."""
    path = write_numpy(at("a.npy"), GRAINS)
    result = mpi_run(1,
                     [SCULPTOR, "--input", path, *PLACED, "--material", "2,3", "--output",
                      at("out.vtu")])
    assert result.returncode == 0, result
    data = image({"MaterialId": np.where(np.isin(turned(GRAINS, "ZYX"), (2, 3)),
                                         turned(GRAINS, "ZYX"), 0).astype(np.int32)})
    check_same(merge(read_pieces(at("out.vtu"))),
               merge([mesh_of(data, MaterialIdArray="MaterialId").mesh]), "2,3")


@in_folder
def test_same_mesh_by_the_class(at):
    """The reader class gives the mesh of the image."""
    hexes = vtkVolumeFractionToHex()
    hexes.SetMaterialIdArray("MaterialId")
    source = reader(write_text(at("a.spn"), GRAINS))
    hexes.SetInputConnection(source.GetOutputPort())
    hexes.Update()
    check_same(merge([hexes.GetOutputDataObject(0)]), expected(), "class")


@in_folder
def test_types_and_orders(at):
    """All types, byte orders and orders of axes give the same labels."""
    for dtype, kind in DTYPES.items():
        for end in "<>":
            for order in ORDERS:
                for fortran in (False, True):
                    given = GRAINS > 1 if dtype == "?" else GRAINS + (
                        100 if kind == 15 else 250 if kind == 3 else 30000)
                    data = read(write_numpy(at("a.npy"), given, end + dtype, order, fortran),
                                order=order)
                    assert ((values(data) == given).all() and data.GetOrigin() == ORIGIN
                            and data.GetSpacing() == SPACING)
                    assert data.GetCellData().GetArray(0).GetDataType() == kind, dtype
    for order in ORDERS:
        data = read(write_text(at("a.spn"), GRAINS, order), order=order)
        assert (values(data) == GRAINS).all() and data.GetCellData().GetArray(0).GetDataType() == 6


@in_folder
def test_versions(at):
    """All versions of the .npy format are read."""
    for version in ((1, 0), (2, 0), (3, 0)):
        with open(at("a.npy"), "wb") as file:
            numpy_format.write_array(file, GRAINS.astype("<u2"), version)
        assert (values(read(at("a.npy"))) == GRAINS).all()


@in_folder
def test_white_space(at):
    """Any white space separates the labels of a text."""
    words = list(map(str, GRAINS.ravel()))
    for text in (" ".join(words), "\r\n".join(words) + "\r\n",
                 "\n\n \t" + "\t ".join(words) + " \n\n", "\v\f".join(words)):
        with open(at("a.spn"), "w", newline="") as file:
            file.write(text)
        assert (values(read(at("a.spn"))) == GRAINS).all()


@in_folder
def test_numbers_across_buffers(at):
    """Numbers that cross the limits of the read buffer are read correctly, in several megabytes."""
    size = (70, 80, 90)
    given = np.random.default_rng(3).integers(0, 2 ** 31,
                                              size) // 10 ** np.random.default_rng(4).integers(
                                                  0, 10, size)
    assert (values(read(write_text(at("a.spn"), given), size=size)) == given).all()


@in_folder
def test_sub_extents(at):
    """Parts of the extent are read, also flat ones."""
    size = [n + 1 for n in SIZE]
    for path in (write_text(at("a.spn"), GRAINS, "YZX"),
                 write_numpy(at("a.npy"), GRAINS, "i4", "YZX"),
                 write_numpy(at("b.npy"), GRAINS, "u1", "YZX", True)):
        for extent in ((2, 5, 0, 11, 3, 4), (0, 9, 0, 11, 12, 13), (4, 4, 0, 11, 0, 13),
                       (9, 9, 11, 11, 13, 13)):
            it = reader(path, order="YZX")
            it.UpdateInformation()
            info = it.GetOutputInformation(0)
            assert info.Get(vtkStreamingDemandDrivenPipeline.WHOLE_EXTENT()) == (
                0, 9, 0, 11, 0, 13), size
            it.UpdateExtent(extent)
            # A flat extent holds the cells next to it.
            lower = [min(extent[2 * a], SIZE[a] - 1) for a in range(3)]
            x, y, z = (slice(lower[a], max(extent[2 * a + 1], lower[a] + 1)) for a in range(3))
            assert it.GetOutput().GetExtent() == extent
            assert (values(it.GetOutput()) == GRAINS[x, y, z]).all()


@in_folder
def test_fractions(at):
    """A 3-D or 4-D array of floating point holds one or several fractions."""
    parts = [part.transpose(2, 1, 0) for part in ball_and_plate()]
    gold = merge(
        [mesh_of(image({"VolumeFraction%d" % (i + 1): p.transpose(2, 1, 0)
                        for i, p in enumerate(parts)}),
                          VolumeFractionArrays=["VolumeFraction1", "VolumeFraction2"]).mesh])
    np.save(at("two.npy"), np.stack(parts))
    hexes = VolumeFractionToHex(Input=simple.OpenDataFile(at("two.npy"), **PLACE),
                                VolumeFractionArrays=["VolumeFraction1", "VolumeFraction2"])
    hexes.UpdatePipeline()
    check_same(merge([hexes.GetClientSideObject().GetOutputDataObject(0)]), gold, "proxy")
    result = mpi_run(3, [SCULPTOR, "--input", at("two.npy"), *PLACED, "--output", at("out.vtu")])
    assert result.returncode == 0 and "VolumeFraction1, VolumeFraction2" in result.stdout, result
    check_same(merge(read_pieces(at("out.vtu"))), gold, "sculptor")
    for dtype, kind in ((">f4", 10), ("<f8", 11)):
        np.save(at("one.npy"), np.asfortranarray(parts[0].astype(dtype)))
        data = read(at("one.npy"))
        assert (values(data, "VolumeFraction") == parts[0].astype(dtype)).all()
        assert data.GetCellData().GetNumberOfArrays() == 1 and data.GetCellData().GetArray(
            0).GetDataType() == kind


@in_folder
def test_file_series(at):
    """Numbered files are time steps."""
    steps = [np.roll(GRAINS, step, axis=0) for step in range(3)]
    for suffix, write, options in (("spn", write_text, dict(Dimensions=SIZE)),
                                   ("npy", write_numpy, {})):
        files = [write(at("a_%d.%s" % (i, suffix)), step) for i, step in enumerate(steps)]
        source = simple.OpenDataFile(files, **options)
        assert list(source.TimestepValues) == [0, 1, 2]
        for i in (0, 2, 1):
            source.UpdatePipeline(i)
            assert (values(source.GetClientSideObject().GetOutputDataObject(0)) == steps[i]).all()


def test_properties():
    """Properties are set, limited and printed."""
    it = reader("a.spn")
    assert (it.GetAxisOrder() == it.AXIS_ORDER_XYZ and it.GetDimensions() == SIZE
            and it.GetFileName() == "a.spn")
    it.SetAxisOrder(99)
    assert it.GetAxisOrder() == it.AXIS_ORDER_ZYX
    assert "Dimensions: 9 11 13" in str(it) and "AxisOrder: 5" in str(it)


def check_refused(path, *words, size=SIZE, change=None):
    """Checks that the reader fails with one message with the file and the words, without labels."""
    it = reader(path, size)
    if change:
        change(it)
    errors, _ = collect(it)
    it.Update()
    assert len(errors) == 1, errors
    for word in ("Cannot read %s: " % path, *words):
        assert word in errors[0], (word, errors)
    assert it.GetOutput().GetCellData().GetNumberOfArrays() == 0 and failure_of(
        it.GetOutput()) in errors[0]


def test_refused_files():
    """Missing files and folders are reported."""
    check_refused("/no/such.spn", "No such file")
    check_refused("/no/such.npy", "No such file")
    check_refused("/tmp", "directory")
    check_refused("", "No such file")


@in_folder
def test_refused_text(at):
    """Wrong counts, words and options of texts are reported."""
    def text(content, *words, size=(2, 3, 4), mode="w", **options):
        with open(at("a.spn"), mode) as file:
            file.write(content)
        check_refused(at("a.spn"), *words, size=size, **options)

    good = "1\n" * 24
    text("1 " * 23, "holds 23 values, but 2 x 3 x 4 cells require 24")
    text("1 " * 25, "holds 25 values, but 2 x 3 x 4 cells require 24")
    text("123456789 " * 23, "holds 23 values")
    text("7", "holds 1 value, but")
    text("", "the file is empty")
    text(" \n\n " * 24, "holds 0 values")
    text(good[:-4] + "\n-3\n1", "line 24: the label -3 is negative")
    text(good[:-4] + "2147483648\n1", "line 23: the label 2147483648 is larger than 2147483647")
    text("1 1 " + "9" * 40 + good, "line 1: the label 999999999999999999999999 is larger")
    text("-" + "9" * 40 + good, "line 1: the label -99999999999999999999999 is negative")
    text("1\n1.5\n" + good, "line 2: '1.5' is not an integer", "fmt='%d'")
    text("1\n1.000000000000000000e+00\n" + good, "line 2: '1.000000000000000000e+00' is not")
    text("1,2,3 " + good, "'1,2,3' is not an integer")
    text("0x1f " + good, "'0x1f' is not")
    text("+1 " + good, "'+1' is not")
    text(good[:-4] + "\n\n1 one", "line 25: 'one' is not")
    text(b"\x93NUMPY\x01\x00" + 60 * b"\xff\x00", "line 1: '?NUMPY??", mode="wb")
    text("x" * 3_000_000, "line 1: 'xxxxxxxxxxxxxxxxxxxxxxxx..' is not")
    text("1 " * 27, "Set Dimensions", "holds 27 values, which fit 3 x 3 x 3 cells.", size=(0, 0, 0))
    text("1 " * 26, "Set Dimensions", "holds 26 values.", size=(5, 0, 5))
    text("1 " * 26, "Set Dimensions", size=(-2, 3, 4))
    text(good, "holds 24 values, but", size=(2 ** 18, 2 ** 19, 2 ** 19))
    text(good, "is too large; at most 2^56 values", size=(2 ** 20, 2 ** 20, 2 ** 20))
    text(good, "is too large", size=(2 ** 31 - 2,) * 3)
    for wrong in (0.0, -1.0, np.nan, np.inf):
        text(good, "Spacing must be above 0", change=lambda it,
             wrong=wrong: it.SetSpacing(1, wrong, 1))
    text(good, "Origin finite", change=lambda it: it.SetOrigin(np.nan, 0, 0))


def header(text, version=1):
    size = struct.pack("<H" if version == 1 else "<I", len(text))
    return b"\x93NUMPY" + bytes([version, 0]) + size + text.encode()


@in_folder
def test_refused_arrays(at):
    """Wrong headers, types, shapes and labels of arrays are reported."""
    def array(content, *words):
        if isinstance(content, np.ndarray):
            np.save(at("a.npy"), content)
        else:
            with open(at("a.npy"), "wb") as file:
                file.write(content)
        check_refused(at("a.npy"), *words)

    cells = np.zeros((2, 3, 4), "u1")
    np.save(at("good.npy"), cells)
    with open(at("good.npy"), "rb") as file:
        good = file.read()
    words = "{'descr': %s, 'fortran_order': False, 'shape': %s, }"
    array(good[:-1], "is truncated: it holds 23", "shape (2, 3, 4) and type '|u1' has 24 bytes")
    array(good + b"1", "the file holds 25")
    array(good[:60], "header is truncated")
    array(good[:9], "header is truncated")
    array(good[:7], "not a NumPy file")
    array(b"", "the file is empty")
    array(b"NUMPY" + good, "not a NumPy file")
    array(b"\x93NUMPY\x04" + good[7:], "version 4")
    array(header("{'fortran_order': False, 'shape': (2, 3, 4), }"), "no 'descr'")
    array(header("{'descr': '|u1', 'fortran_order': False}"), "no 'shape'")
    array(header("{'descr': '|u1', 'shape': (2, 3, 4)}"), "no 'fortran_order'")
    array(header(words % ("'|u1'", "(2, 3")), "no shape")
    array(header(words % ("'|u1'", "(2, x, 4)")), "no shape of integers")
    array(header(words % ("'|u1'", "(-2, 3, 4)")), "no shape of integers")
    array(header("{'descr':"), "no 'descr'")
    array(header(words % ("'<u8'", "(%d, %d, %d)" % ((2 ** 31 - 2,) * 3))),
          "is truncated: it holds 0")
    array(header(words % ("'<u8'", "(3000000000, 1, 1)")), "too large")
    array(b"\x93NUMPY\x02\x00\xff\xff\xff\xff" + bytes(100), "header is truncated")
    for dtype in ("<c8", "<f2", "<U3", "|S2", "<M8[s]", "|V4", "<f16"):
        array(cells.astype(dtype), "of the NumPy type '%s" % np.dtype(dtype).str)
    array(np.zeros((2, 3, 4), [("a", "u1")]), "of the NumPy type with fields")
    array(cells.astype(object), "Python objects", "astype")
    array(cells.ravel(), "shape (24,)", "3-D")
    array(cells[0], "shape (3, 4)")
    array(np.array(3), "shape ()")
    array(cells[None], "shape (1, 2, 3, 4)", "save a.astype('float32') of masks, or one 3-D array")
    array(np.zeros((1, 1, 2, 3, 4)), "shape (1, 1, 2, 3, 4)", "or a 4-D")
    array(np.asfortranarray(np.zeros((2, 3, 4, 5))), "Fortran order", "ascontiguousarray")
    array(np.zeros((2, 0, 4)), "no cells")
    for dtype, wrong in (("i1", -7), ("<i2", -7), (">i4", -7), ("<i8", -2 ** 40), ("<i8", 2 ** 31),
                         (">u4", 2 ** 31), ("<u8", 2 ** 64 - 1)):
        for fortran in (False, True):
            bad = np.zeros((2, 3, 4), dtype, order="F" if fortran else "C")
            bad[1, 0, 2] = wrong
            array(bad, "the label of cell (1, 0, 2) is %d." % wrong)


@in_folder
def test_refused_by_sculptor(at):
    """sculptor reports the messages of the reader on 1 and 3 ranks."""
    def refused(code, text, *arguments, ranks=1):
        result = mpi_run(ranks, [SCULPTOR, *arguments, "--output", at("out.vtu")])
        lines = result.stderr.splitlines()
        assert result.returncode == code and len(lines) == 1 and text in lines[
            0] and result.stdout == "", (text, result)

    text = write_text(at("a.spn"), GRAINS)
    bad_text, bad_array = write_text(at("b.spn"),
                                     GRAINS - 1), write_numpy(at("b.npy"), GRAINS - 1, "i4")
    for ranks in (1, 3):
        refused(2, "sculptor: Cannot read %s: it holds 1287 values, but 9 x 11 x 12" % text,
                "--input", text, "--dimensions", "9,11,12", ranks=ranks)
        refused(2, "sculptor: Cannot read %s: line " % bad_text, "--input", bad_text, *SIZED,
                ranks=ranks)
        refused(2, "sculptor: Cannot read %s: the label of cell (" % bad_array, "--input",
                bad_array, ranks=ranks)
    assert not os.path.exists(at("out.vtu"))


main(globals())
