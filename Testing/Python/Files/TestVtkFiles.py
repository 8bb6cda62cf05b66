"""Files of VTK with hexahedra and voxels, in the legacy and the XML formats; damaged files.

All grids with the same labels give the same mesh, in `sculptor` on any number of ranks and by
ParaView's readers.
"""
import os
import re
import struct

import numpy as np
from vtkmodules.vtkCommonDataModel import VTK_TETRA, vtkUnstructuredGrid

from amr_files import make_amr, write_vthb
from sculptor_program import mesh_file, refused, rows
from vfmtest import (
    VolumeFractionToHex, add_array, collect, image, in_folder, main, mesh_of, simple)
from vtk_files import (
    ELEMENTS, MODES, NAME, cells_of, grids, nodes_of, structured, two_boxes, write_blocks,
    write_legacy, write_pieces, write_xml)

TYPES = ("i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8", "f4", "f8")


def elements_of(path, output, ranks=1, name=NAME):
    """Returns the number of elements that sculptor makes of a file."""
    return int(rows(mesh_file(path, output, "--labels", name, ranks=ranks))["all"][0])


def read_by_paraview(path):
    """Returns elements and errors of the mesh that the filter makes of ParaView's reader."""
    source = simple.OpenDataFile(path)
    mesher = VolumeFractionToHex(Input=source, VolumeFractionArrays=[], MaterialIdArray=NAME)
    errors, _ = collect(mesher.GetClientSideObject())
    mesher.UpdatePipeline()
    return mesher.GetClientSideObject().GetOutputDataObject(0).GetNumberOfCells(), errors


def write_all(at):
    """Yields the path of each kind of file."""
    for name, suffix, data in grids(two_boxes()):
        for binary, version in ((False, 42), (True, 42), (True, 51)):
            yield write_legacy(at("%s_%d_%d.vtk" % (name, binary, version)), data, binary, version)
        for mode in MODES:
            yield write_xml(at("%s_%s%s" % (name, mode, suffix)), data, mode)
    yield write_pieces(at("pieces.pvtu"), two_boxes())
    yield write_blocks(at("blocks.vtm"), cells_of(two_boxes()))


@in_folder
def test_all_grids(at):
    """Each kind of file gives the same number of elements in sculptor and in ParaView."""
    paths = list(write_all(at))
    found = {os.path.basename(path): (elements_of(path, at("out.vtu")), read_by_paraview(path)[0])
             for path in paths}
    print(len(found), "files:", sorted(set(found.values())))
    assert set(found.values()) == {(ELEMENTS, ELEMENTS)}, found
    for path in paths[1::7]:
        assert elements_of(path, at("ranks.vtu"), ranks=3) == ELEMENTS, path


@in_folder
def test_types_of_labels(at):
    """Labels may have any numeric type."""
    for kind in TYPES:
        data = cells_of(two_boxes(dtype=np.dtype(kind)))
        for path in (write_legacy(at("a.vtk"), data, True), write_xml(at("a.vtu"), data)):
            assert elements_of(path, at("out.vtu")) == ELEMENTS, (kind, path)


@in_folder
def test_several_arrays(at):
    """All arrays of a legacy file are read, also the second one and fields."""
    data = image({NAME: np.zeros((10, 12, 14), "i4"), "second": two_boxes()})
    path = write_legacy(at("a.vtk"), data, False)
    assert elements_of(path, at("out.vtu"), name="second") == ELEMENTS


@in_folder
def test_no_grid(at):
    """Cells that form no Cartesian grid, and negative ids, give a message that says what to do."""
    labels = two_boxes()
    nodes = np.stack(np.meshgrid(*nodes_of(labels)[::-1], indexing="ij")[::-1], axis=-1)
    bent = nodes + 0.2 * np.sin(nodes[..., :1])
    tets = vtkUnstructuredGrid()
    tets.SetPoints(structured(labels).GetPoints())
    tets.InsertNextCell(VTK_TETRA, 4, [0, 1, 20, 300])
    add_array(tets.GetCellData(), NAME, np.ones(1, "i4"))
    negative = cells_of(two_boxes(1, -7))
    for data, text in ((structured(labels, bent), "is not a box with sides along the axes"),
                       (tets, "is a vtkTetra"),
                       (negative, "holds -7 in cell .*Calculator")):
        for path in (write_legacy(at("a.vtk"), data, True), write_legacy(at("b.vtk"), data, False)):
            for ranks in (1, 3):
                message = "" if ".*" in text else text
                refused(3, message or "Calculator", path, at("out.vtu"), "--labels", NAME,
                        ranks=ranks)
            count, errors = read_by_paraview(path)
            assert count == 0 and len(errors) == 1 and re.search(text, errors[0]), errors


def test_advice_on_negative_ids():
    """The formula of the message makes a mesh of both materials."""
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(cells_of(two_boxes(1, -7)))
    formula = "if(%s < 0, 1000000 - %s, %s)" % (NAME, NAME, NAME)
    shifted = simple.Calculator(Input=source, AttributeType="Cell Data", Function=formula,
                                ResultArrayName="shifted")
    shifted.UpdatePipeline()
    result = mesh_of(shifted.GetClientSideObject().GetOutputDataObject(0),
                     VolumeFractionArrays=[], MaterialIdArray="shifted")
    assert result.mesh.GetNumberOfCells() == ELEMENTS and not result.errors, result.errors
    assert sorted(result.field("MaterialIds")) == [1, 1000007], result.field("MaterialIds")


def change(path, old, new):
    """Replaces a text of a file once."""
    with open(path, "rb") as file:
        data = file.read()
    assert old in data, old
    with open(path, "wb") as file:
        file.write(data.replace(old, new, 1))


def check_refused(path, text, *words):
    for ranks in (1, 3):
        refused(2, text, path, os.path.join(os.path.dirname(path), "out.vtu"), *words, ranks=ranks)


@in_folder
def test_damaged_heads(at):
    """Type, version, byte order and compressor of each format are checked."""
    labels = two_boxes()
    damages = ((b'type="', b'type="x', "of the type that its suffix requires"),
               (b'" version="', b'" version="x', "its version \"x"),
               (b'byte_order="', b'byte_order="x', "its byte_order \"x"),
               (b"<VTKFile", b"<VTKFile compressor='none'", "Cannot read the input"),
               (b"<VTKFile", b"<!DOCTYPE a><VTKFile", "document type definition"),
               (b"</VTKFile>", b"", "is not XML"))
    writers = [(name, suffix, lambda path, data=data: write_xml(path, data, "inline"))
               for name, suffix, data in list(grids(labels))[:4]]
    writers += [("pieces", ".pvtu", lambda path: write_pieces(path, labels)),
                ("blocks", ".vtm", lambda path: write_blocks(path, image({NAME: labels}))),
                ("levels", ".vthb", lambda path: write_vthb(path, make_amr(levels=1)))]
    for name, suffix, make in writers:
        for old, new, text in damages:
            change(make(at(name + suffix)), old, new)
            refused(2, text, at(name + suffix), at("out.vtu"))
    change(write_vthb(at("old.vthb"), make_amr(levels=1)), b'version="1.1"', b'version="1.0"')
    check_refused(at("old.vthb"), "its version is 1.0, 1.1 is required")


@in_folder
def test_damaged_grids(at):
    """Extents, numbers of cells, and places and lengths of arrays are checked."""
    labels = two_boxes()
    for old, new, text in (
            (b'WholeExtent="0 14', b'WholeExtent="0 99999999999', "six integers in the allowed"),
            (b'WholeExtent="0 14 0 12 0 10"',
             b'WholeExtent="%s"' % b" ".join([b"0 2000000000"] * 3), "has too many points"),
            (b'WholeExtent="0 14', b'WholeExtent="0 20', "fewer cells than its WholeExtent"),
            (b'WholeExtent="0 14', b'WholeExtent="1 14', "is not inside"),
            (b'<Piece Extent="0 14', b'<Piece Extent="0 1400000', "is not inside"),
            (b'Spacing="0.25', b'Spacing="nan', "has Spacing="),
            (b'Origin="-1', b'Origin="x', "has Origin="),
            (b'offset="0"', b'offset="99999"', "begins at offset 99999"),
            (b'type="Int16"', b'type="Int17"', "has the unknown type 'Int17'"),
            (b'encoding="raw"', b'encoding="none"', "have no encoding")):
        change(write_xml(at("a.vti"), image({NAME: labels})), old, new)
        check_refused(at("a.vti"), text)
    for old, new, text in (
            (b'NumberOfCells="1680"', b'NumberOfCells="168000000"', "are required"),
            (b'NumberOfPoints="13440"', b'NumberOfPoints="-1"', "in the allowed range")):
        change(write_xml(at("a.vtu"), cells_of(labels)), old, new)
        check_refused(at("a.vtu"), text)
    for mode in MODES:
        with open(write_xml(at("a.vtu"), cells_of(labels), mode), "rb") as file:
            data = file.read()
        with open(at("a.vtu"), "wb") as file:
            file.write(data[:len(data) // 2])
        refused(2, "Cannot read the input", at("a.vtu"), at("out.vtu"))


@in_folder
def test_contradictory_cells(at):
    """Offsets and types of cells that contradict each other are reported by both front ends."""
    data = cells_of(two_boxes())
    path = write_xml(at("a.vtu"), data, "ascii")
    change(path, b"\n          8 16 24", b"\n          8 99999999 24")
    with open(path, "rb") as file:
        assert b"99999999" in file.read()
    refused(2, "a.vtu", path, at("out.vtu"), "--labels", NAME)
    for kind, code in ((99, 3), (300, 2)):
        path = write_legacy(at("a.vtk"), data, False, 42)
        change(path, b"CELL_TYPES 1680\n12", b"CELL_TYPES 1680\n%d" % kind)
        refused(code, "is of the type %d" % kind, path, at("out.vtu"), "--labels", NAME)


@in_folder
def test_damaged_legacy_files(at):
    """Dimensions, numbers and types of a legacy file are checked before VTK reads it."""
    labels, name = two_boxes(), NAME.encode()
    changes = {
        "image": ((b"# vtk", b"# VTK", "is not a legacy VTK file"),
                  (b"Version 4.2", b"Version 4.x", "its version is '4.x'"),
                  (b"ASCII", b"ASCIX", "its third line is 'ascix'"),
                  (b"STRUCTURED_POINTS", b"POLYDATA", "its data set is 'polydata'"),
                  (b"DIMENSIONS 15", b"DIMENSIONS 1500000000", "values of 1680 cells"),
                  (b"DIMENSIONS 15", b"DIMENSIONS -15", "its dimension is '-15'"),
                  (b"CELL_DATA 1680", b"CELL_DATA 1681", "values of 1681 cells"),
                  (b"GrainID short", b"GrainID shirt", "has the unknown type 'shirt'"),
                  (b"CELL_DATA", b"CELLS_DATA", "has the unknown keyword 'cells_data'")),
        "hexes": ((b"POINTS 13440", b"POINTS 1344000000000", "its number of points"),
                  (b"CELLS 1680 15120", b"CELLS 1680 15119", "its list of cells"),
                  (b"CELLS 1680 15120\n8", b"CELLS 1680 15120\n9", "its list of cells"),
                  (b"8 0 1 2 3 4", b"8 0 99999 2 3 4", "a cell has the point 99999"),
                  (b"CELL_TYPES 1680", b"CELL_TYPES 168", "its number of types"))}
    for kind, _, data in grids(labels):
        for old, new, text in changes.get(kind, ()):
            change(write_legacy(at("a.vtk"), data, False, 42), old, new)
            refused(2, text, at("a.vtk"), at("out.vtu"), "--labels", NAME)
    change(write_legacy(at("a.vtk"), image({NAME: labels}), True), name, b"x" * 2000)
    check_refused(at("a.vtk"), "Cannot read the input")


@in_folder
def test_files_of_files(at):
    """Parts that are missing, of another format, or the file itself; nesting and numbers."""
    labels = two_boxes()
    make = lambda: write_blocks(at("a.vtm"), image({NAME: labels}))
    for new, text in ((b"a.vtm", "can be parts"), (b"none.vti", "none.vti: No such file"),
                      (b"", "meshed"), (b"/dev/zero", "outside of its folder"),
                      (b"a/../../b.vti", "outside of its folder"),
                      (b"folder.vti", "not a regular file")):
        os.makedirs(at("folder.vti"), exist_ok=True)
        make()
        change(at("a.vtm"), b'file="a/a_0.vti"', b'file="%s"' % new)
        check_refused(at("a.vtm"), text if new else "cell")
    make()
    change(at("a.vtm"), b'file="a/a_0.vti"', b'file="/dev/zero"')
    check_refused(at("a.vtm"), "can be parts", "--trust-input")
    make()
    change(at("a.vtm"), b'index="0"', b'index="2000000000"')
    check_refused(at("a.vtm"), "has the index 2000000000")
    make()
    change(at("a.vtm"), b"<DataSet", b"<Block>" * 100 + b"<DataSet")
    check_refused(at("a.vtm"), "nested too deeply")
    write_pieces(at("a.pvtu"), labels)
    os.remove(at("a_1.vtu"))
    check_refused(at("a.pvtu"), "a_1.vtu: No such file")
    change(write_vthb(at("a.vthb"), make_amr(levels=2)), b'level="1"', b'level="1000000000"')
    check_refused(at("a.vthb"), "has the level 1000000000")


@in_folder
def test_damaged_netcdf_header(at):
    """A variable with a dimension that does not exist, and numbers that overflow."""
    put = struct.pack

    def header(dimension, length=3, records=0, begin=0):
        text = b"CDF\x05" + put(">q", records) + put(">iq", 10, 1) + put(">q", 4) + b"dimx"
        text += put(">q", length) + put(">iq", 0, 0) + put(">iq", 11, 1) + put(">q", 4) + b"varx"
        text += put(">q", 1) + put(">q", dimension) + put(">iq", 0, 0) + put(">i", 4)
        return text + put(">q", 12) + put(">q", begin) + bytes(12)

    for case in (dict(dimension=-100000000), dict(dimension=1), dict(dimension=2 ** 62),
                 dict(dimension=0, length=-1), dict(dimension=0, length=2 ** 62),
                 dict(dimension=0, length=0, records=2 ** 50), dict(dimension=0, begin=-1),
                 dict(dimension=0, begin=2 ** 63 - 1), dict(dimension=0, records=2 ** 62)):
        with open(at("a.e"), "wb") as out:
            out.write(header(**case))
        for ranks in (1, 3):
            refused(2, "the file is truncated or damaged", at("a.e"), at("out.vtu"), ranks=ranks)


main(globals())
