"""Tests that damaged values of VTK's files give a message with array, place and value, and that
VTK's readers, which crash or convert them, are not called."""

import base64
import re
import struct

import numpy as np
import pytest

import volume_fraction_mesh as vfm
from images import legacy_vtk, two_boxes
from volume_fraction_mesh.__main__ import main

pytest.importorskip("vtkmodules")
LABELS = two_boxes()  # (7, 12, 10) cells
NOISE = np.random.default_rng(5).integers(1, 5, LABELS.shape)


def make_image(labels, first=0):
    """Returns an image of VTK with labels (x, y, z) from a node on along x."""
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkCommonDataModel import vtkImageData

    image = vtkImageData()
    x, y, z = labels.shape
    image.SetExtent(first, first + x, 0, y, 0, z)
    array = numpy_to_vtk(labels.ravel(order="F"), deep=1)
    array.SetName("ids")
    image.GetCellData().AddArray(array)
    return image


def write_image(path, labels, mode="Ascii", compressor="None", encodes=False, first=0):
    from vtkmodules.vtkIOXML import vtkXMLImageDataWriter

    writer = vtkXMLImageDataWriter()
    writer.SetInputData(make_image(labels, first))
    writer.SetFileName(str(path))
    writer.SetBlockSize(512)
    writer.SetEncodeAppendedData(encodes)
    getattr(writer, "SetDataModeTo" + mode)()
    getattr(writer, "SetCompressorTypeTo" + compressor)()
    assert writer.Write()
    return path


def set_word(path, number, word):
    """Replaces a value, counted from 1, of the first array of a file of text."""
    text = path.read_text()
    start = re.search(r"<DataArray[^>]*>|LOOKUP_TABLE.*\n", text).end()
    found = list(re.finditer(r"\S+", text[start:]))[number - 1]
    path.write_text(text[:start + found.start()] + word + text[start + found.end():])


def rejected(path, capsys):
    """Returns the message of read(); vfmesh must give the same one."""
    with pytest.raises(ValueError) as caught:
        vfm.read(path)
    text = str(caught.value)
    assert text.startswith("Cannot read ") and str(path) in text and "\n" not in text, text
    out = path.parent / "out.npz"
    assert main([str(path), str(out), "--quiet"]) and not out.exists()
    assert capsys.readouterr().err == "vfmesh: %s\n" % text
    return text


def same_labels(arrays, labels=LABELS):
    return np.array_equal(np.asarray(arrays["ids"]).ravel(), labels.ravel(order="F"))


@pytest.mark.parametrize("word", ["1.5", "abc", "1e0", "40000", "-1", "2,", "0x1"])
def test_words(tmp_path, capsys, word):
    path = write_image(tmp_path / "a.vti", LABELS.astype(np.uint8))
    assert same_labels(vfm.read(path))
    set_word(path, 18, word)
    assert ("its array 'ids' has '%s' as value 18, where an integer from 0 to 255 is required."
            % word) in rejected(path, capsys)


def test_numbers_out_of_range(tmp_path, capsys):
    for kind in ("i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8"):
        for value in (np.iinfo(kind).min - 1, np.iinfo(kind).max + 1):
            path = write_image(tmp_path / "a.vti", LABELS.astype(kind))
            set_word(path, 18, str(value))
            assert "has '%d' as value 18" % value in rejected(path, capsys)
    path = write_image(tmp_path / "a.vti", LABELS.astype("f4"))
    set_word(path, 18, "1e60")
    assert "has '1e60' as value 18, where a number of single" in rejected(path, capsys)


def test_numbers_of_values(tmp_path, capsys):
    path = write_image(tmp_path / "a.vti", LABELS.astype("i4"))
    set_word(path, 18, "0 0")
    assert "holds %d values, %d are required" % (LABELS.size + 1,
                                                 LABELS.size) in rejected(path, capsys)


@pytest.mark.parametrize("mode, encodes", [("Binary", True), ("Appended", True),
                                           ("Appended", False)])
@pytest.mark.parametrize("compressor", ["ZLib", "LZ4", "LZMA"])
def test_packed(tmp_path, capsys, mode, encodes, compressor):
    path = write_image(tmp_path / "a.vti", NOISE.astype("i2"), mode, compressor, encodes)
    assert same_labels(vfm.read(path), NOISE)
    whole = path.read_bytes()
    begin = re.search(rb"<DataArray[^>]*>\s*" if mode == "Binary" else rb"<AppendedData[^>]*>\s*_",
                      whole).end()
    blocks = -(-2 * NOISE.size // 512)
    table = 4 * (3 + blocks)  # bytes of the header
    head = -(-table // 3) * 4 if encodes else table
    text = base64.b64decode(whole[begin:begin + head]) if encodes else whole[begin:begin + head]
    assert struct.unpack("<2I", text[:8]) == (blocks, 512)
    for place in (begin + head + 40, begin + head + 200):
        byte = whole[place] ^ 8 if not encodes else ord("B" if whole[place:place + 1] != b"B"
                                                       else "C")
        if compressor != "LZ4":  # which has no checksum
            path.write_bytes(whole[:place] + bytes([byte]) + whole[place + 1:])
            assert re.search("damaged compressed values in block [12] of %d" % blocks,
                             rejected(path, capsys))
    rest = b"</DataArray>" + whole.split(b"</DataArray>")[1] if mode == "Binary" else b""
    path.write_bytes(whole[:begin + head + 100] + rest)
    assert "fewer compressed bytes" in rejected(path, capsys)


@pytest.mark.parametrize("mode", ["Binary", "Appended"])
def test_base64(tmp_path, capsys, mode):
    whole = write_image(tmp_path / "a.vti", NOISE.astype("i2"), mode, encodes=True).read_bytes()
    begin = re.search(rb"<DataArray[^>]*>\s*" if mode == "Binary" else rb"<AppendedData[^>]*>\s*_",
                      whole).end()
    path = tmp_path / "a.vti"
    path.write_bytes(whole[:begin + 500] + b"*" + whole[begin + 501:])
    assert "holds '*' after 500 letters of base64" in rejected(path, capsys)


def test_pieces(tmp_path, capsys):
    """Files that are named must have the announced types, and intact values."""
    path = tmp_path / "a.pvti"
    split, (x, y, z) = 3, LABELS.shape

    def write(kind, declared="Int16"):
        write_image(tmp_path / "a_0.vti", LABELS[:split].astype("i2"))
        write_image(tmp_path / "a_1.vti", LABELS[split:].astype(kind), first=split)
        pieces = "".join('<Piece Extent="%d %d 0 %d 0 %d" Source="a_%d.vti"/>'
                         % (first, last, y, z, number)
                         for number, (first, last) in enumerate(((0, split), (split, x))))
        path.write_text('<VTKFile type="PImageData" version="0.1"><PImageData Origin="0 0 0" '
                        'WholeExtent="0 %d 0 %d 0 %d" Spacing="1 1 1"><PCellData><PDataArray '
                        'type="%s" Name="ids"/></PCellData>%s</PImageData></VTKFile>'
                        % (x, y, z, declared, pieces))

    write("i2")
    assert same_labels(vfm.read(path))
    for kind in ("i1", "i4", "f8"):
        write(kind)
        assert "one of its pieces has the type" in rejected(path, capsys)
    for word in ("1.5", "abc", "99999"):
        write("i2")
        set_word(tmp_path / "a_1.vti", 18, word)
        assert "a_1.vti: the file is truncated or damaged: its array 'ids' has '%s' as value 18" % (
            word) in rejected(path, capsys)
    (tmp_path / "a_1.vti").unlink()
    assert "a_1.vti: No such file" in rejected(path, capsys)


@pytest.mark.parametrize("word", ["1.5", "abc", "1e0", "99999999999", "1 1"])
def test_legacy(tmp_path, capsys, word):
    path = tmp_path / "a.vtk"
    legacy_vtk(path, LABELS)
    set_word(path, 18, word)
    wanted = ("its array 'ids' has '%s' as value 18" % word if word != "1 1"
              else "unknown keyword")
    assert wanted in rejected(path, capsys)
