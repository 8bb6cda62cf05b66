"""Values of VTK's files that are damaged: text, base64, compressed data, types of pieces.

VTK's readers end the program, convert such values silently or shift them. `sculptor` names the
file, the array, the place and the value, on any number of ranks.
"""
import base64
import os
import re
import struct

import numpy as np
from vtkmodules.vtkIOXML import vtkXMLDataSetWriter

from sculptor_program import mesh_file, refused, rows, sculptor
from vfmtest import image, in_folder, main
from vtk_files import ELEMENTS, NAME, cells_of, grids, two_boxes, write_legacy, write_xml

COMPRESSORS = ("ZLib", "LZ4", "LZMA")
STORED = ("inline", "base64", "raw")
INTEGER = "an integer from %d to %d is required"


def replace(path, old, new, count=1):
    """Replaces a part of a file, which must contain it."""
    with open(path, "rb") as file:
        data = file.read()
    assert old in data, old
    with open(path, "wb") as file:
        file.write(data.replace(old, new, count))


def set_value(path, number, word, name=NAME):
    """Replaces a value, counted from 1, of an array that is stored as text. The word may be empty,
    or several words."""
    with open(path) as file:
        text = file.read()
    start = re.search(r'Name="%s"[^>]*>|SCALARS %s .*\n.*\n' % (name, name), text).end()
    found = list(re.finditer(r"\S+", text[start:start + 100000]))[number - 1]
    with open(path, "w") as file:
        file.write(text[:start + found.start()] + word + text[start + found.end():])


def check_refused(path, text, *words, ranks=(1, 3)):
    output = os.path.join(os.path.dirname(path), "out.vtu")
    for count in ranks:
        refused(2, text, path, output, *words, ranks=count)
    assert not os.path.exists(output), path


def check_list(path, text):
    """The list of arrays is refused, too."""
    for ranks in (1, 3):
        result = sculptor("--list", path, ranks=ranks)
        assert result.returncode == 2 and result.stdout == "" and text in result.stderr, result


def write_packed(path, data, mode, compressor, block=1024):
    """Writes a compressed file of several blocks."""
    writer = vtkXMLDataSetWriter()
    writer.SetInputData(data)
    writer.SetFileName(path)
    writer.SetBlockSize(block)
    getattr(writer, "SetCompressorTypeTo" + compressor)()
    if mode == "inline":
        writer.SetDataModeToBinary()
    else:
        writer.SetDataModeToAppended()
        writer.SetEncodeAppendedData(mode == "base64")
    assert writer.Write()
    return path


def write_pvti(path, *pieces, declared="Int16"):
    """Writes a .pvti of two images (7, 12, 10 cells), one file each."""
    names = []
    for number, labels in enumerate(pieces):
        data = image({NAME: labels})
        data.SetExtent(7 * number, 7 * number + labels.shape[2], 0, 12, 0, 10)
        names.append("%s_%d.vti" % (os.path.basename(path)[:-5], number))
        write_xml(os.path.join(os.path.dirname(path), names[-1]), data, "ascii")
    with open(path, "w") as out:
        out.write('<VTKFile type="PImageData" version="0.1"><PImageData Origin="0 0 0" '
                  'WholeExtent="0 14 0 12 0 10" Spacing="1 1 1"><PCellData>'
                  '<PDataArray type="%s" Name="%s"/></PCellData>%s</PImageData></VTKFile>' % (
                      declared, NAME, "".join(
                          '<Piece Extent="%d %d 0 12 0 10" Source="%s"/>' % (
                              7 * number, 7 * number + 7, name)
                          for number, name in enumerate(names))))
    return path


@in_folder
def test_words(at):
    """A word that VTK does not read as one value of the type."""
    integer, single = INTEGER % (-32768, 32767), "a number of single precision is required"
    for _, suffix, data in list(grids(two_boxes()))[:4]:
        for word in ("1.5", "abc", "1e0", "70000", "0x1", "2,", "--1"):
            set_value(write_xml(at("a" + suffix), data, "ascii"), 18, word)
            check_refused(at("a" + suffix), "its array 'GrainID' has '%s' as value 18, where %s."
                          % (word, integer), ranks=(1, 3) if word == "abc" else (1,))
    for word in ("2,0", "1e60", "0x1p3", "nan(1)", "abc"):
        set_value(write_xml(at("a.vti"), image({NAME: two_boxes(dtype="f4")}), "ascii"), 18, word)
        check_refused(at("a.vti"), "has '%s' as value 18, where %s." % (word, single), ranks=(1,))
    check_list(at("a.vti"), "has 'abc' as value 18")


@in_folder
def test_words_that_are_read(at):
    """Words that VTK reads as it should are no errors."""
    for dtype, word in (("i2", "+0"), ("f4", "1e-60"), ("f8", "-0."), ("u1", "000")):
        set_value(write_xml(at("a.vti"), image({NAME: two_boxes(dtype=dtype)}), "ascii"), 18, word)
        found = rows(mesh_file(at("a.vti"), at("out.vtu"), "--labels", NAME))
        assert found["all"][0] == ELEMENTS, (dtype, word, found)


@in_folder
def test_range(at):
    """Numbers that the type does not have are not converted."""
    for dtype, low, high in (("u1", 0, 255), ("i1", -128, 127), ("u2", 0, 65535),
                             ("i4", -2 ** 31, 2 ** 31 - 1), ("u8", 0, 2 ** 64 - 1)):
        data = image({NAME: two_boxes(dtype=dtype)})
        for value in (low - 1, high + 1):
            text = "has '%d' as value 18, where %s." % (value, INTEGER % (low, high))
            set_value(write_xml(at("a.vti"), data, "ascii"), 18, str(value))
            check_refused(at("a.vti"), text, ranks=(1,))
            set_value(write_legacy(at("a.vtk"), data, False, 42), 18, str(value))
            if dtype == "u1":
                text = "has the colour %d, from 0 to 1 are required" % value
            check_refused(at("a.vtk"), text, ranks=(1,))


@in_folder
def test_count(at):
    """One value too many or too few, in text and in bytes."""
    labels = two_boxes()
    for word, count in (("0 0", 1681), ("", 1679)):
        set_value(write_xml(at("a.vti"), image({NAME: labels}), "ascii"), 18, word)
        check_refused(at("a.vti"), "'GrainID' holds %d values, 1680 are required." % count)
    for size in (3358, 3362):
        replace(write_xml(at("a.vti"), image({NAME: labels})), b"_" + struct.pack("<I", 3360),
                b"_" + struct.pack("<I", size))
        check_refused(at("a.vti"), "'GrainID' holds %d bytes, 3360 are required." % size)
    data = image({NAME: labels, "second": labels})
    set_value(write_legacy(at("a.vtk"), data, False, 42), 18, "0 1")
    check_refused(at("a.vtk"), "unknown keyword '0' after its array 'GrainID'.")
    set_value(at("a.vtk"), 18, "")
    set_value(at("a.vtk"), 18, "")
    check_refused(at("a.vtk"), "its array 'GrainID' has 'FIELD' as value 1680")


@in_folder
def test_packed(at):
    """Compressed blocks that are damaged, cut off or of other sizes, in several blocks."""
    data = image({NAME: np.random.default_rng(5).integers(1, 5, (10, 12, 14)).astype("i2")})
    for mode in STORED:
        for compressor in COMPRESSORS:
            path = write_packed(at("a.vti"), data, mode, compressor)
            assert sculptor("--list", path).returncode == 0, (mode, compressor)
            check_damaged_blocks(path, mode, compressor)


def check_damaged_blocks(path, mode, compressor):
    with open(path, "rb") as file:
        whole = file.read()
    begin = (re.search(rb"<DataArray[^>]*>\s*", whole) if mode == "inline"
             else re.search(rb"<AppendedData[^>]*>\s*_", whole)).end()
    decode = base64.b64decode if mode != "raw" else bytes
    head = 40 if mode != "raw" else 28  # three numbers and four sizes, 28 bytes
    table = list(struct.unpack("<7I", decode(whole[begin:begin + head])[:28]))
    assert table[:3] == [4, 1024, 288], table

    def write(content):
        with open(path, "wb") as out:
            out.write(content)

    def set_table(number, value):
        changed = struct.pack("<7I", *table[:number], value, *table[number + 1:])
        changed = base64.b64encode(changed) if mode != "raw" else changed
        write(whole[:begin] + changed + whole[begin + head:])

    for number, value, text in (
            (0, 5, "fewer compressed bytes" if mode == "raw" else "ends inside its header"),
            (1, 1023, "bytes, 3360 are required"),
            (2, 2000, "contradicts itself"), (3, 10 ** 8, "fewer compressed bytes"),
            (4, table[4] - 1, "damaged compressed values in block 2 of 4, which begins at byte "
                              "1024")):
        set_table(number, value)
        check_refused(path, text, ranks=(1,))
    ranks = (1, 3) if compressor == "ZLib" else (1,)
    places = [begin + head + (at * 4 // 3 if mode != "raw" else at)
              for at in (40, table[3] + 50, sum(table[3:6]) + 40)]
    for place in places if compressor != "LZ4" else ():  # LZ4 has no checksum
        byte = whole[place] ^ 8 if mode == "raw" else ord("B" if whole[place] == ord("A") else "A")
        write(whole[:place] + bytes([byte]) + whole[place + 1:])
        check_refused(path, "damaged compressed values in block", ranks=ranks)
    write(whole[:places[1]] + (whole[whole.index(b"</DataArray>"):] if mode == "inline" else b""))
    check_refused(path, "fewer compressed bytes", ranks=ranks)
    if mode != "inline":
        return
    write(whole[:places[1]])
    check_refused(path, "it is not XML", ranks=(1,))


@in_folder
def test_base64(at):
    """Letters that are not base64, texts that are cut and texts that do not end."""
    data = image({NAME: np.random.default_rng(5).integers(1, 5, (10, 12, 14)).astype("i2")})
    for mode in ("inline", "base64"):
        for place, new, text in (
                (0, b"*", "holds '*' after 0 letters of base64"),
                (500, b"!", "holds '!' after 500 letters of base64"),
                (500, b" ", "holds ' ' after 500 letters of base64"),
                (501, b"=", "holds '=' before letter 50"),
                (2000, None, "the data end")):
            path = write_xml(at("a.vti"), data, mode)
            with open(path, "rb") as file:
                whole = file.read()
            begin = (re.search(rb"<DataArray[^>]*>\s*", whole) if mode == "inline"
                     else re.search(rb"<AppendedData[^>]*>\s*_", whole)).end() + place
            end = begin + 1 if new else re.compile(rb"\s*<").search(whole, begin).start()
            with open(path, "wb") as out:
                out.write(whole[:begin] + (new or b"") + whole[end:])
            check_refused(path, text, ranks=(1, 3))
    replace(write_xml(at("a.vti"), data, "inline"), b"</DataArray>", b"AAAA</DataArray>")
    check_refused(at("a.vti"), "holds 'A' after its values", ranks=(1,))


@in_folder
def test_pieces(at):
    """Pieces that are damaged, or differ from the file that names them."""
    labels = two_boxes()
    halves = labels[:, :, :7], labels[:, :, 7:]
    assert mesh_file(write_pvti(at("a.pvti"), *halves), at("out.vtu"), "--labels", NAME)
    os.remove(at("out.vtu"))
    for word in ("1.5", "abc", "1e0", "99999"):
        write_pvti(at("a.pvti"), *halves)
        set_value(at("a_1.vti"), 18, word)
        text = "a_1.vti: the file is truncated or damaged: its array 'GrainID' has '%s' as value 18"
        check_refused(at("a.pvti"), text % word, ranks=(1, 2, 3))
        check_list(at("a.pvti"), text % word)
    for dtype in ("i1", "i4", "f8"):
        write_pvti(at("a.pvti"), halves[0], halves[1].astype(dtype))
        check_refused(at("a.pvti"), "'GrainID' of one of its pieces has the type", ranks=(1, 2, 3))
    write_pvti(at("a.pvti"), *halves, declared="Float64")
    check_refused(at("a.pvti"), "has the type Int16, Float64 is required")
    write_pvti(at("a.pvti"), halves[0], halves[1][:, :, :3])
    check_refused(at("a.pvti"), "its extent is 7 10 0 12 0 10, without its part 7 14 0 12 0 10")
    write_pvti(at("a.pvti"), *halves)
    replace(at("a_1.vti"), NAME.encode(), b"other")
    check_refused(at("a.pvti"), "has no array 'GrainID'")


@in_folder
def test_lists_of_cells(at):
    """Points and ends of the cells of unstructured grids, as text and as bytes."""
    data = cells_of(two_boxes())
    for name, number, word, text in (
            ("connectivity", 18, "13440",
             "has 13440 as value 18, where an integer from 0 to 13439"),
            ("connectivity", 18, "-1", "has -1 as value 18"),
            ("offsets", 3, "7", "has 7 as value 3 after 16; values must not decrease"),
            ("offsets", 1680, "13448", "its cells have 13448 points"),
            ("types", 5, "256", "has '256' as value 5, where an integer from 0 to 255")):
        set_value(write_xml(at("a.vtu"), data, "ascii"), number, word, name)
        check_refused(at("a.vtu"), text)
    for old, new, text in ((40, 13440, "has 13440 as value 41"), (8, -5, "has -5 as value 9")):
        replace(write_xml(at("a.vtu"), data), struct.pack("<3q", old, old + 1, old + 2),
                struct.pack("<3q", new, old + 1, old + 2))
        check_refused(at("a.vtu"), text, ranks=(1,))
    for binary in (False, True):
        path = write_legacy(at("a.vtk"), data, binary, 51)
        old, new = ((struct.pack(">2q", 8, 16), struct.pack(">2q", 8, 7)) if binary
                    else (b"0 8 16 ", b"0 8 7 "))
        replace(path, old, new)
        check_refused(path, "a cell ends at point 7 after 8", ranks=(1,))


@in_folder
def test_legacy(at):
    """Words of legacy files."""
    labels = two_boxes()
    for word in ("1.5", "abc", "1e0", "70000"):
        set_value(write_legacy(at("a.vtk"), image({NAME: labels}), False, 42), 18, word)
        check_refused(at("a.vtk"), "its array 'GrainID' has '%s' as value 18, where an integer"
                      % word)
    for word in ("nan", "inf", "2,0", "1e60"):
        data = image({NAME: labels.astype("f4")})
        set_value(write_legacy(at("a.vtk"), data, False, 42), 18, word)
        check_refused(at("a.vtk"), "has '%s' as value 18, where a finite number" % word, ranks=(1,))
    for old, new in ((b"SPACING 0.25", b"SPACING x"), (b"ORIGIN -1", b"ORIGIN nan")):
        replace(write_legacy(at("a.vtk"), image({NAME: labels}), False, 42), old, new)
        check_refused(at("a.vtk"), "three numbers are required", ranks=(1,))


main(globals())
