"""Writes intact inputs for the fuzzers of the readers: FOLDER/HARNESS/FILE.

usage: make_seeds.py FOLDER

Needs only the standard library; seeds of Dream3d also need h5py, one of Exodus
needs the program nccopy; they are left out without them.
"""
import gzip
import io
import os
import shutil
import struct
import subprocess
import sys
import tempfile
import zipfile
import zlib
from base64 import b64encode

SIZE = (4, 3, 2)  # values along x, y and z
VALUES = bytes(i % 5 for i in range(24))  # labels, x fastest
SHORTS = struct.pack("<24h", *VALUES)


def write(folder, harness, name, data):
    path = os.path.join(folder, harness)
    os.makedirs(path, exist_ok=True)
    with open(os.path.join(path, name), "wb") as file:
        file.write(data.encode() if isinstance(data, str) else data)


def numpy_file(kind, shape, data, version=1, fortran=False):
    text = "{'descr': '%s', 'fortran_order': %s, 'shape': %s, }" % (kind, fortran, shape)
    size = struct.pack("<H" if version == 1 else "<I", 118 - (0 if version == 1 else 2))
    body = text.ljust(117 - (0 if version == 1 else 2)) + "\n"
    return b"\x93NUMPY" + bytes([version, 0]) + size + body.encode() + data


def numpy_seeds():
    yield "bytes", numpy_file("|u1", SIZE, VALUES)
    yield "big", numpy_file(">i2", SIZE, struct.pack(">24h", *VALUES), 2, True)
    yield "fractions", numpy_file("<f4", (2,) + SIZE, struct.pack("<48f", *[0.5] * 48))
    yield "bool", numpy_file("|b1", SIZE, bytes(i % 2 for i in range(24)), 3)


def text_seeds():
    yield "lines", "\n".join(map(str, VALUES)) + "\n"
    yield "rows", " ".join(str(7 * v) for v in VALUES)


def label_name_seeds():
    yield "spaces", "# comment\n0 Void\n17 Left Hippocampus\n18\tAmygdala\n"
    yield "commas", "label,name,group\n1,liver,a\n2,kidney,b\n"
    yield "snap", '1 255 0 0 1 1 1 "Liver"\n2 0 255 0 1 1 1 "Left kidney"\n'
    yield "colours", "17 Left-Hippocampus 220 216 20 0\n18 Left-Amygdala 103 255 255 0\n"
    yield "atlas", ('<?xml version="1.0"?>\n<atlas><header><name>a</name><type>Probabilistic</type>'
                    '</header><data><label index="0" x="1">Pole &amp; Cortex</label>'
                    '<label index="3">Gyrus</label></data></atlas>\n')


def exodus_file(version):
    """Returns an Exodus file of two hexahedra with one variable at two times."""
    wide = version == 5
    count = lambda n: struct.pack(">q" if wide else ">i", n)
    place = lambda n: struct.pack(">i" if version == 1 else ">q", n)
    name = lambda text: count(len(text)) + text.encode() + b"\0" * (-len(text) % 4)
    tag = lambda kind, n: struct.pack(">i", kind) + count(n)
    text = lambda key, value: (tag(12, 1) + name(key) + struct.pack(">i", 2) + name(value))
    lengths = {"time_step": 0, "num_dim": 3, "num_nodes": 12, "num_el_in_blk1": 2,
               "num_nod_per_el1": 8, "num_el_blk": 1, "num_elem_var": 1, "len_name": 4}
    head = b"CDF" + bytes([version]) + count(2) + tag(10, len(lengths))
    head += b"".join(name(key) + count(length) for key, length in lengths.items())
    head += text("title", "seeds")
    points = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1, 2)]
    corners = [first + step for first in (1, 2) for step in (0, 1, 4, 3, 6, 7, 10, 9)]
    items = [("coord" + "xyz"[a], [2], 6, struct.pack(">12d", *(p[a] for p in points)))
             for a in range(3)]
    items += [("connect1", [3, 4], 4, struct.pack(">16i", *corners)),
              ("eb_prop1", [5], 4, struct.pack(">i", 7)), ("name_elem_var", [6, 7], 2, b"VOL\0")]
    records = [("time_whole", [0], (0.5, 1.5)), ("vals_elem_var1eb1", [0, 3], (1, 0, .25, .5))]

    def variables(at):
        result = tag(11, len(items) + len(records))
        def item(key, dims, kind, size):
            more = text("elem_type", "HEX8") if key == "connect1" else tag(0, 0)
            return (name(key) + count(len(dims)) + b"".join(map(count, dims)) + more
                    + struct.pack(">i", kind) + count(size) + place(at))
        for key, dims, kind, data in items:
            result += item(key, dims, kind, len(data))
            at += len(data)
        for key, dims, numbers in records:
            result += item(key, dims, 6, 4 * len(numbers))
            at += 4 * len(numbers)
        return result

    at = len(head + variables(0))
    values = b"".join(struct.pack(">d%dd" % (len(records[1][2]) // 2), records[0][2][i],
                                  *records[1][2][2 * i:2 * i + 2]) for i in (0, 1))
    return head + variables(at) + b"".join(data for *_, data in items) + values


def netcdf4_file(data):
    """Returns an Exodus file in the format netCDF-4; nothing without the program nccopy."""
    if not shutil.which("nccopy"):
        return None
    with tempfile.TemporaryDirectory() as folder:
        paths = [os.path.join(folder, name) for name in ("a.e", "b.e")]
        with open(paths[0], "wb") as file:
            file.write(data)
        subprocess.run(["nccopy", "-k", "nc4", *paths], check=True)
        with open(paths[1], "rb") as file:
            return file.read()


def meta_image(values, kind, extra=""):
    return ("ObjectType = Image\nNDims = 3\nDimSize = 4 3 2\nElementSpacing = 1 1 2\n"
            "Offset = 0 0 0\nTransformMatrix = 1 0 0 0 1 0 0 0 1\n%sElementType = %s\n"
            "ElementDataFile = LOCAL\n" % (extra, kind)).encode() + values


def meta_seeds():
    packed = zlib.compress(VALUES)
    binary = "BinaryData = True\nBinaryDataByteOrderMSB = False\n"
    yield "raw", meta_image(VALUES, "MET_UCHAR", binary)
    yield "big", meta_image(struct.pack(">24h", *VALUES), "MET_SHORT",
                            binary.replace("MSB = False", "MSB = True"))
    yield "zlib", meta_image(packed, "MET_UCHAR", binary + "CompressedData = True\n"
                             "CompressedDataSize = %d\n" % len(packed))
    yield "text", meta_image(" ".join(map(str, VALUES)).encode(), "MET_INT", "BinaryData = False\n")


def nrrd(values, kind, encoding="raw", extra=""):
    return ("NRRD0004\n# comment\ntype: %s\ndimension: 3\nspace: left-posterior-superior\n"
            "sizes: 4 3 2\nspace directions: (1,0,0) (0,1,0) (0,0,2)\nkinds: domain domain domain\n"
            "endian: little\nencoding: %s\nspace origin: (0,0,0)\n%s\n" % (kind, encoding, extra)
            ).encode() + values


def nrrd_seeds():
    yield "raw", nrrd(VALUES, "unsigned char")
    yield "gzip", nrrd(gzip.compress(SHORTS), "short", "gzip")
    yield "skip", nrrd(bytes(7) + VALUES, "uchar", extra="byte skip: 7\n")
    yield "keys", nrrd(VALUES, "uchar", extra="Segment0_Name:=liver\nSegment0_LabelValue:=1\n")
    yield "segments", (
        b"NRRD0004\ntype: uchar\ndimension: 4\nsizes: 2 4 3 2\n"
        b"space directions: none (1,0,0) (0,1,0) (0,0,2)\nkinds: list domain domain domain\n"
        b"encoding: raw\nspace: left-posterior-superior\nspace origin: (0,0,0)\n"
        b"Segment0_Name:=liver\nSegment0_LabelValue:=1\nSegment0_Layer:=0\n"
        b"Segment1_Name:=kidney\nSegment1_LabelValue:=1\nSegment1_Layer:=1\n\n"
        + bytes(i % 2 if i % 4 < 2 else 0 for i in range(48)))
    yield "spacings", (b"NRRD0001\ntype: float\ndimension: 3\nsizes: 4 3 2\nspacings: 1 2 3\n"
                       b"encoding: raw\nendian: big\n\n" + struct.pack(">24f", *VALUES))


def nifti(version, code, bits, values, swap="<"):
    head = bytearray(348 if version == 1 else 540)
    put = lambda form, at, *numbers: struct.pack_into(swap + form, head, at, *numbers)
    put("i", 0, len(head))
    if version == 1:
        put("8h", 40, 3, *SIZE, 1, 1, 1, 1)
        put("2h", 70, code, bits)
        put("8f", 76, 1, 1, 1, 2, 1, 1, 1, 1)
        put("f", 108, 352)
        head[123] = 2
        put("2h", 252, 1, 1)
        for row in range(3):
            put("4f", 280 + 16 * row, *[float(row == c) for c in range(3)], 0)
        head[344:348] = b"n+1\0"
    else:
        head[4:12] = b"n+2\0\r\n\x1a\n"
        put("2h", 12, code, bits)
        put("8q", 16, 3, *SIZE, 1, 1, 1, 1)
        put("8d", 104, 1, 1, 1, 2, 1, 1, 1, 1)
        put("q", 168, 544)
        put("2i", 344, 1, 1)
        for row in range(3):
            put("4d", 400 + 32 * row, *[float(row == c) for c in range(3)], 0)
        put("i", 500, 2)
    return bytes(head) + b"\0\0\0\0" + values


def nifti_seeds():
    yield "bytes", nifti(1, 2, 8, VALUES)
    yield "big", nifti(1, 4, 16, struct.pack(">24h", *VALUES), ">")
    yield "second", nifti(2, 8, 32, struct.pack("<24i", *VALUES))
    caret = (b"<CaretExtension><VolumeInformation Index='0'><LabelTable><Label Key='1'>liver"
             b"</Label></LabelTable></VolumeInformation></CaretExtension>")
    caret += bytes(-(len(caret) + 8) % 16)
    named = bytearray(nifti(1, 2, 8, b""))
    struct.pack_into("<f", named, 108, 360 + len(caret))
    yield "names", bytes(named[:348]) + b"\1\0\0\0" + struct.pack(
        "<2i", len(caret) + 8, 30) + caret + VALUES
    yield "reals", nifti(2, 64, 64, struct.pack("<24d", *VALUES))


def mgh_seeds():
    for name, kind, form in (("bytes", 0, ">24B"), ("shorts", 4, ">24h"), ("reals", 3, ">24f")):
        axes = (1, 0, 0, 0, 1, 0, 0, 0, 1)
        head = struct.pack(">7ih15f", 1, *SIZE, 1, kind, 0, 1, 1, 1, 2, *axes, 2, 1.5, 2)
        yield name, head.ljust(284, b"\0") + struct.pack(form, *VALUES)


def png(colour, depth, rows, before=b""):
    chunk = lambda kind, data: (struct.pack(">I", len(data)) + kind + data
                                + struct.pack(">I", zlib.crc32(kind + data)))
    samples = {0: 1, 2: 3, 3: 1, 6: 4}[colour]
    head = struct.pack(">2I5B", 8 * len(rows[0]) // (samples * depth), len(rows), depth, colour,
                       0, 0, 0)
    data = zlib.compress(b"".join(b"\0" + row for row in rows))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + before + chunk(b"IDAT", data)
            + chunk(b"IEND", b""))


def png_seeds():
    rows = [VALUES[4 * j:4 * j + 4] for j in range(6)]
    yield "grey", png(0, 8, rows)
    yield "deep", png(0, 16, rows)
    yield "colours", png(2, 8, [row * 3 for row in rows])
    yield "transparent", png(6, 8, [row * 4 for row in rows])
    palette = b"\0\0\0" + bytes(range(12))
    yield "palette", png(3, 8, rows, struct.pack(">I", len(palette)) + b"PLTE" + palette
                         + struct.pack(">I", zlib.crc32(b"PLTE" + palette)))


def tiff(bits, pack=1, order="<", pages=2):
    """Returns a file of one strip per page. pack: 1 none, 8 zlib, 32773 packed bits."""
    out = bytearray((b"II*\0" if order == "<" else b"MM\0*") + b"\0\0\0\0")
    link = 4
    for page in range(pages):
        data = struct.pack(order + "12" + {8: "B", 16: "H", 32: "I"}[bits],
                           *VALUES[12 * page:12 * page + 12])
        if pack == 8:
            data = zlib.compress(data)
        elif pack == 32773:
            data = b"".join(b"\3" + data[row:row + 4] for row in (0, 4, 8))
        at = len(out)
        out += data + b"\0" * (len(data) % 2)
        out += struct.pack(order + "2I", 25400, 1000)
        tags = [(256, 4, SIZE[0]), (257, 4, SIZE[1]), (258, 3, bits), (259, 3, pack), (262, 3, 1),
                (273, 4, at), (277, 3, 1), (278, 4, SIZE[1]), (279, 4, len(data)),
                (282, 5, len(out) - 8), (283, 5, len(out) - 8), (296, 3, 2)]
        struct.pack_into(order + "I", out, link, len(out))
        out += struct.pack(order + "H", len(tags))
        for tag, kind, value in tags:
            field = struct.pack(order + ("Hxx" if kind == 3 else "I"), value)
            out += struct.pack(order + "HHI", tag, kind, 1) + field
        link = len(out)
        out += bytes(4)
    return bytes(out)


def tiff_seeds():
    yield "bytes", tiff(8)
    yield "big", tiff(16, order=">")
    yield "zlib", tiff(8, 8)
    yield "runs", tiff(8, 32773)
    yield "wide", tiff(32, pages=1)


def spyplot(version, blocks):
    """Returns a file of one time: blocks of 4 x 3 x 3 cells with ghost cells, two arrays."""
    ints = lambda *numbers: struct.pack(">%di" % len(numbers), *numbers)
    reals = lambda *numbers: struct.pack(">%dd" % len(numbers), *numbers)
    text = lambda name, size: name.encode().ljust(size, b"\0")
    chunk = lambda code: ints(len(code)) + code
    table = lambda name, number: ints(1) + text("F", 30) + text(name, 80) + ints(number)
    content = b"spydata\0" + text("seed", 128) + ints(version)
    content += (ints(64) if version >= 102 else b"") + ints(0, 0, 1, 30, 3, 1, 1)
    content += reals(0, 0, 0, 2, 1, 1) + ints(blocks) + (ints(0) if version >= 105 else b"")
    content += ints(1) + (ints(*[0] * 5) if version >= 105 else b"")
    content += table("Density", 0) + table("Material volume fraction", 100)
    content += reals(len(content) + 8)
    start = len(content) + 4 + 100 * (20 + (8 if version >= 102 else 0))
    content += ints(1, *[0] * 100) + reals(0.5, *[0] * 99)
    content += reals(*[1e-6] * 100) if version >= 102 else b""
    content += reals(start, *[0] * 99)
    plane = chunk(bytes([10]) + struct.pack(">f", 0.5) + bytes([130]) + struct.pack(">2f", 0, 1))
    values = plane * 3 * blocks
    bounds = ints(*[0] * 6) if version >= 103 else b""
    grids = ints(0, 0, blocks) + (ints(4, 3, 3, 1, 1, 0) + bounds) * blocks
    for block in range(blocks):
        for axis, count in enumerate((5, 4, 4)):
            first = -1.0 + (2 * block if axis == 0 else 0)
            grids += chunk(struct.pack(">2f", first, 1) + bytes([count]) + struct.pack(">f", first))
    head = ints(2, 0, 101)
    first = start + len(head) + 16 + len(grids)
    return content + head + reals(first, first + len(values)) + grids + 2 * values


def spyplot_seeds():
    for version in (101, 103, 105):
        yield "v%d" % version, spyplot(version, 1 + version % 2)


def plotfile():
    """Returns the files of a plotfile of one level with one box, in the order of FuzzBlocks.cxx."""
    header = ("HyperCLaw-V1.1\n1\nphi\n3\n0.5\n0\n0 0 0\n4 3 2\n\n((0,0,0) (3,2,1) (0,0,0))\n3\n"
              "1 1 1\n0\n0\n0 1 0.5\n3\n0 4\n0 3\n0 2\nLevel_0/Cell\n")
    cells = ("1\n1\n1\n0\n(1 0\n((0,0,0) (3,2,1) (0,0,0))\n)\n1\nFabOnDisk: Cell_D_00000 0\n\n"
             "1,1\n0,\n\n1,1\n4,\n")
    fab = ("FAB ((8, (64 11 52 0 1 12 0 1023)),(8, (8 7 6 5 4 3 2 1)))"
           "((0,0,0) (3,2,1) (0,0,0)) 1\n").encode() + struct.pack("<24d", *VALUES)
    return b"\n@@\n".join([header.encode(), cells.encode(), fab])


CORNERS = [(i, j, k) for k in (0, 1) for j in (0, 1) for i in (0, 1)]  # of a voxel


def legacy(form, body, version="3.0"):
    return ("# vtk DataFile Version %s\nseed\n%s\n" % (version, form)).encode() + body


def legacy_seeds():
    labels = b"CELL_DATA 24\nSCALARS id short 1\nLOOKUP_TABLE default\n"
    image = b"DATASET STRUCTURED_POINTS\nDIMENSIONS 5 4 3\nORIGIN 0 0 0\nSPACING 1 1 1\n"
    yield "text", legacy("ASCII", image + labels + " ".join(map(str, VALUES)).encode() + b"\n")
    yield "binary", legacy("BINARY", image + labels + struct.pack(">24h", *VALUES) + b"\n")
    axes = b"".join(b"%s_COORDINATES %d float\n%s\n" % (axis, n, b"0 1 2 3 4"[:2 * n - 1])
                    for axis, n in ((b"X", 5), (b"Y", 4), (b"Z", 3)))
    field = b"CELL_DATA 24\nFIELD FieldData 1\nid 1 24 int\n" + b"1 " * 24
    yield "axes", legacy("ASCII", b"DATASET RECTILINEAR_GRID\nDIMENSIONS 5 4 3\n" + axes + field)
    points = "POINTS 8 float\n%s\n" % " ".join("%d %d %d" % corner for corner in CORNERS)
    cells = "CELLS 1 9\n8 0 1 2 3 4 5 6 7\nCELL_TYPES 1\n11\n"
    data = "CELL_DATA 1\nGLOBAL_IDS ids int\n7\nMETADATA\nINFORMATION 0\n\nVECTORS v float\n0 1 2\n"
    grid = "DATASET UNSTRUCTURED_GRID\n"
    yield "cells", legacy("ASCII", (grid + points + cells + data).encode())
    cells = ("CELLS 2 8\nOFFSETS vtktypeint64\n0 8\nCONNECTIVITY vtktypeint64\n0 1 2 3 4 5 6 7\n"
             "CELL_TYPES 1\n11\n")
    yield "offsets", legacy("ASCII", (grid + points + cells + data).encode(), "5.1")


def vtu(kind, values, more=""):
    """Returns a file of one voxel whose labels are stored in some way."""
    array = '<DataArray type="%s" Name="%s" %sformat="ascii">%s</DataArray>'
    points = " ".join("%d %d %d" % corner for corner in CORNERS)
    return ('<?xml version="1.0"?>\n<VTKFile type="UnstructuredGrid" version="1.0" %s'
            'byte_order="LittleEndian" header_type="UInt32"><UnstructuredGrid>'
            '<Piece NumberOfPoints="8" NumberOfCells="1"><CellData>'
            '<DataArray type="Int16" Name="id" %s</CellData><Points>%s</Points><Cells>%s%s%s'
            "</Cells></Piece></UnstructuredGrid>" % (
                more, values, array % ("Float32", "p", 'NumberOfComponents="3" ', points),
                array % ("Int64", "connectivity", "", "0 1 2 3 4 5 6 7"),
                array % ("Int64", "offsets", "", "8"), array % ("UInt8", "types", "", "11"))
            ).encode() + kind + b"</VTKFile>"


def xml_seeds():
    value = struct.pack("<Ih", 2, 7)
    appended = lambda form, data: (b'<AppendedData encoding="%s">\n_' % form + data
                                   + b"</AppendedData>")
    at = 'format="appended" offset="0"/>'
    yield "ascii", vtu(b"", 'format="ascii">7</DataArray>')
    yield "inline", vtu(b"", 'format="binary">%s</DataArray>' % b64encode(value).decode())
    yield "raw", vtu(appended(b"raw", value), at)
    yield "base64", vtu(appended(b"base64", b64encode(value)), at)
    head, packed = pack(value[4:], 2)
    yield "zlib", vtu(appended(b"raw", head + packed), at, 'compressor="vtkZLibDataCompressor" ')
    inline = 'format="binary">%s</DataArray>'
    yield "zlib64", vtu(b"", inline % (b64encode(head) + b64encode(packed)).decode(),
                        'compressor="vtkZLibDataCompressor" ')
    texts = ('format="ascii">7</DataArray><Array type="String" Name="t" format="ascii">97 0'
             '</Array><DataArray type="Bit" Name="b" format="ascii">1</DataArray>')
    yield "texts", vtu(b"", texts)


def pack(values, size):
    """Returns the header and the blocks of compressed values."""
    blocks = [zlib.compress(values[at:at + size]) for at in range(0, len(values), size)]
    last = len(values) % size
    return struct.pack("<%dI" % (3 + len(blocks)), len(blocks), size, last,
                       *map(len, blocks)), b"".join(blocks)


def vti(*pieces, more=""):
    """Returns a file of 4 x 3 x 2 cells in two pieces, with their arrays."""
    return ('<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian" '
            'header_type="UInt32" %s><ImageData WholeExtent="0 4 0 3 0 2" Origin="0 0 0" '
            'Spacing="1 1 1">%s</ImageData></VTKFile>' % (more, "".join(
                '<Piece Extent="%d %d 0 3 0 2"><CellData><DataArray type="Float32" Name="a" %s'
                "</CellData></Piece>" % (2 * number, 2 * number + 2, piece)
                for number, piece in enumerate(pieces)))).encode()


def vti_seeds():
    values = struct.pack("<12f", *range(12))
    head, packed = pack(values, 20)
    text = 'format="ascii">%s</DataArray>' % " ".join("%g" % (0.5 * x) for x in range(12))
    inline = 'format="binary">%s</DataArray>'
    yield "ascii", vti(text, text)
    yield "mixed", vti(text, inline % b64encode(struct.pack("<I", 48) + values).decode())
    block = inline % (b64encode(head) + b64encode(packed)).decode()
    yield "zlib", vti(block, block, more='compressor="vtkZLibDataCompressor"')


def block_seeds():
    """Yields refined grids without data; their parts would be other files."""
    yield "levels", (
        '<VTKFile type="vtkOverlappingAMR" version="1.1" byte_order="LittleEndian">'
        '<vtkOverlappingAMR origin="0 0 0" grid_description="XYZ"><Block level="0" '
        'spacing="1 1 1"><DataSet index="0" amr_box="0 3 0 3 0 3"/></Block><Block level="1" '
        'spacing="0.5 0.5 0.5"><DataSet index="0" amr_box="0 3 0 3 0 3"/><DataSet index="1" '
        'amr_box="4 7 0 3 0 3"/></Block></vtkOverlappingAMR></VTKFile>\n')


def option_seeds():
    yield "hexes", "Smoothing=3\nVoidFraction=0.4\nStairStep=On\nRefinement=Automatic\n"
    yield "tets", "Method=Lattice\nMinimumAngle=20\nSecondOrder=1\nMaximumLevel=2\n"
    yield "lists", "MaterialNames=ball,plate\nRefinementBoxes=0,1,0,1,0,1\nPeriodic=x,y\n"


def argument_seeds():
    yield "mesh", "--input\na.vti\n--output\nb.e\n--fractions\nball,plate\n--iso=0.4\n--quiet\n"
    yield "labels", "a.nrrd\nb.pvtu\n--labels\nGrainID\n--material\n1,2\n--label-smoothing\n3\n"
    yield "voxels", "a.spn\nb.msh\n--dimensions\n4,3,2\n--origin\n0,0,0\n--spacing\n1,1,2\n"
    yield "test", "test\n--tetmesh\nLattice\n--refine=1\n--no-smooth\n"
    yield "options", "a.vti\nb.e\n--tetmesh\n--set\nMinimumDihedralAngle=20\n--step\n1\n"
    yield "list", "--list\na.e\n--time\n1e-3\n"


def shape_seeds():
    yield "solids", ("sphere radius=0.4 center=0,0,0\nellipsoid radii=0.4,0.3,0.2 rotation=0,0,45\n"
                     "box size=1,1,0.5 material=2 cut=0,0,0,1,1,1\n"
                     "cylinder radius=0.2 height=1 rotation=90,0,0\n")
    yield "others", ("cone bottom=0.4 top=0.1 height=1; torus ring=0.5 tube=0.2 # comment\n"
                     "halfspace point=0,0,0 normal=0,0,1\nplate thickness=0.1 normal=1,1,0\n")
    yield "fields", "gyroid period=1 level=0.1\npolycrystal grains=3 seed=1 material=4\n"


def surface(points, triangles):
    """Returns points and triangles in the form of FuzzSurface.cxx."""
    numbers = [x for point in points for x in point]
    return (bytes([len(points)]) + struct.pack("<%dd" % len(numbers), *numbers)
            + bytes(corner for triangle in triangles for corner in triangle))


def surface_seeds():
    tet = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)]
    yield "tet", surface([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], tet)
    yield "flat", surface([(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 1e-300)], tet)
    sides = [(0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6)]
    cube = [(a, b, c) for p, q, r, s in sides for a, b, c in ((p, q, r), (p, r, s))]
    yield "cube", surface(CORNERS, cube)
    inner = [[0.25 + 0.5 * x for x in corner] for corner in CORNERS]
    yield "cavity", surface(CORNERS + inner, cube + [(8 + a, 8 + c, 8 + b) for a, b, c in cube])


TET = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
SIDES = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)]


def stl_seeds():
    corners = [[TET[p] for p in side] for side in SIDES]
    records = b"".join(struct.pack("<12fH", 0, 0, 0, *(x for c in three for x in c), 0x801f + t)
                       for t, three in enumerate(corners))
    yield "binary", b"solid binary".ljust(80) + struct.pack("<I", 4) + records
    yield "magics", b"COLOR=abcd".ljust(80) + struct.pack("<I", 4) + records + b"trailing"
    facets = ["facet normal 0 0 0\nouter loop\n%sendloop\nendfacet\n" % "".join(
        "vertex %g %g %g\n" % c for c in three) for three in corners]
    yield "text", "solid a\n%sendsolid a\nsolid b\n%sendsolid b\n" % (
        "".join(facets[:2]), "".join(facets[2:]))


def obj_seeds():
    points = "".join("v %g %g %g\n" % p for p in CORNERS)
    yield "cube", "o cube\n" + points + (
        "usemtl a\nf 1 3 4 2\nf 5/1 6/2 8/3 7/4\ng side\nf 1//1 2//1 6//1 \\\n5\nusemtl b\n"
        "f -6 -2 -1 -5\nf 1 5 7 3\nf 2 4 8 6\n")
    yield "bent", "v 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nv 0 0 0\nv 2 0 0\nf 1 2 3 4 5 6\n"


def ply_seeds():
    for form, order in (("ascii", ""), ("binary_little_endian", "<"), ("binary_big_endian", ">")):
        head = ("ply\nformat %s 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                "property double z\nproperty uchar red\nelement face 4\n"
                "property list uchar int vertex_indices\nend_header\n" % form)
        if order:
            body = b"".join(struct.pack(order + "ffdB", *p, 7) for p in TET) + b"".join(
                struct.pack(order + "B3i", 3, *side) for side in SIDES)
        else:
            body = ("".join("%g %g %g 7\n" % p for p in TET)
                    + "".join("3 %d %d %d\n" % side for side in SIDES)).encode()
        yield form, head.encode() + body


def off_seeds():
    yield "tet", "OFF # comment\n4 4 6\n%s%s" % (
        "".join("%g %g %g\n" % p for p in TET), "".join("3 %d %d %d 1 0 0\n" % s for s in SIDES))


def vtp_seeds():
    points = struct.pack("<12d", *(x for p in TET for x in p))
    corners = struct.pack("<12q", *(p for side in SIDES for p in side))
    arrays = (("Points", "Float64", "p", points), ("Polys", "Int64", "connectivity", corners),
              ("Polys", "Int64", "offsets", struct.pack("<4q", 3, 6, 9, 12)))

    def file(form, more, values, tail=b""):
        lists = {"Points": "", "Polys": ""}
        for (place, kind, name, _), value in zip(arrays, values):
            lists[place] += '<DataArray type="%s" Name="%s" %sformat="%s"%s</DataArray>' % (
                kind, name, 'NumberOfComponents="3" ' if place == "Points" else "", form, value)
        return ('<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" '
                'header_type="UInt32" %s><PolyData><Piece NumberOfPoints="4" NumberOfPolys="4">'
                "<Points>%s</Points><Polys>%s</Polys></Piece></PolyData>" % (
                    more, lists["Points"], lists["Polys"])).encode() + tail + b"</VTKFile>"

    yield "ascii", file("ascii", "", [
        ">" + " ".join("%g" % x for x in struct.unpack("<%d%s" % (len(data) // 8, code), data))
        for (*_, data), code in zip(arrays, "dqq")])
    sized = [struct.pack("<I", len(data)) + data for *_, data in arrays]
    yield "inline", file("binary", "", [">" + b64encode(data).decode() for data in sized])
    offsets = [sum(map(len, sized[:n])) for n in range(3)]
    yield "raw", file("appended", "", [' offset="%d">' % at for at in offsets],
                      b'<AppendedData encoding="raw">_' + b"".join(sized) + b"</AppendedData>")
    packed = [pack(data, 64) for *_, data in arrays]
    yield "zlib", file("binary", 'compressor="vtkZLibDataCompressor" ', [
        ">" + (b64encode(head) + b64encode(data)).decode() for head, data in packed])


def threemf_seeds():
    mesh = "<mesh><vertices>%s</vertices><triangles>%s</triangles></mesh>" % (
        "".join('<vertex x="%g" y="%g" z="%g"/>' % p for p in TET),
        "".join('<triangle v1="%d" v2="%d" v3="%d" pid="9" p1="0"/>' % s for s in SIDES))
    model = ('<?xml version="1.0"?><model><resources><basematerials id="9"><base name="a"/>'
             '</basematerials><object id="1" name="tet">%s</object><object id="2"><components>'
             '<component objectid="1" transform="2 0 0 0 2 0 0 0 2 5 0 0"/></components></object>'
             '</resources><build><item objectid="1"/><item objectid="2"/></build></model>' % mesh)
    for name, method in (("stored", zipfile.ZIP_STORED), ("packed", zipfile.ZIP_DEFLATED)):
        bytes_ = io.BytesIO()
        with zipfile.ZipFile(bytes_, "w", method) as archive:
            archive.writestr(zipfile.ZipInfo("3D/3dmodel.model"), model, method)
        yield name, bytes_.getvalue()


def dream3d_seeds(folder):
    """Writes files of DREAM.3D 6 and DREAM3D-NX."""
    import h5py

    os.makedirs(folder, exist_ok=True)
    values = [[[[VALUES[4 * (3 * k + j) + i]] for i in range(4)] for j in range(3)]
              for k in range(2)]
    spacing, origin = [1.0, 1.0, 2.0], [0.0, 0.0, 0.0]
    with h5py.File(os.path.join(folder, "six"), "w", libver="earliest") as file:
        image = file.create_group("DataContainers/Image")
        image.create_dataset("_SIMPL_GEOMETRY/DIMENSIONS", data=SIZE, dtype="i8")
        image.create_dataset("_SIMPL_GEOMETRY/SPACING", data=spacing, dtype="f4")
        image.create_dataset("_SIMPL_GEOMETRY/ORIGIN", data=origin, dtype="f4")
        image.create_dataset("CellData/FeatureIds", data=values, dtype="i4")
    with h5py.File(os.path.join(folder, "nx"), "w", libver="earliest") as file:
        file.attrs.create("FileVersion", b"8.0")
        image = file.create_group("DataStructure/Image Geometry")
        image.attrs.create("ObjectType", b"ImageGeom")
        image.attrs.create("_DIMENSIONS", SIZE, dtype="u8")
        image.attrs.create("_SPACING", spacing, dtype="f4")
        image.attrs.create("_ORIGIN", origin, dtype="f4")
        image.create_dataset("Cell Data/FeatureIds", data=values, dtype="i4", compression="gzip")


def write_all(folder):
    for harness, seeds in (
            ("NumPy", numpy_seeds), ("LabelText", text_seeds), ("LabelNames", label_name_seeds),
            ("MetaImage", meta_seeds), ("Nrrd", nrrd_seeds), ("Nifti", nifti_seeds),
            ("Tiff", tiff_seeds), ("Png", png_seeds), ("Mgh", mgh_seeds),
            ("SpyPlot", spyplot_seeds), ("Options", option_seeds),
            ("Shapes", shape_seeds), ("Surface", surface_seeds), ("VtkLegacy", legacy_seeds),
            ("VtkXml", xml_seeds), ("VtkImage", vti_seeds), ("VtkBlocks", block_seeds),
            ("Arguments", argument_seeds), ("SurfaceStl", stl_seeds), ("SurfaceObj", obj_seeds),
            ("SurfacePly", ply_seeds), ("SurfaceOff", off_seeds), ("SurfaceVtp", vtp_seeds),
            ("Surface3mf", threemf_seeds)):
        for name, data in seeds():
            write(folder, harness, name, data)
            if harness == "Nifti":
                write(folder, "NiftiGzip", name, gzip.compress(data, mtime=0))
            if harness == "SurfaceStl":
                bytes_ = data.encode() if isinstance(data, str) else data
                write(folder, "SurfaceGzip", name, gzip.compress(bytes_, mtime=0))
    for version in (1, 2, 5):
        write(folder, "Exodus", "cdf%d" % version, exodus_file(version))
    wide = netcdf4_file(exodus_file(5))
    if wide:
        write(folder, "Exodus", "netcdf4", wide)
    else:
        print("no seed of netCDF-4: there is no nccopy")
    write(folder, "Plotfile", "level", plotfile())
    try:
        dream3d_seeds(os.path.join(folder, "Dream3d"))
    except ImportError:
        print("no seeds of Dream3d: there is no h5py")


write_all(sys.argv[1])
