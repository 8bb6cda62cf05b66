"""Image files with one value per voxel, for tests of their readers.

Programs for medical images and grain structures write such files. Values are (z, y, x);
origin is the centre of the first voxel; steps are the vectors to the next voxel along x, y and z.
"""
import gzip
import os
import struct
import zlib

import h5py
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkTIFFWriter

NIFTI_TYPES = {"u1": 2, "i2": 4, "i4": 8, "f4": 16, "f8": 64, "i1": 256, "u2": 512, "u4": 768,
               "i8": 1024, "u8": 1280}
NRRD_TYPES = {"u1": "unsigned char", "i1": "signed char", "u2": "ushort", "i2": "short",
              "u4": "uint32", "i4": "int", "f4": "float", "f8": "double"}
CARET = (b'<?xml version="1.0" encoding="UTF-8"?><CaretExtension><VolumeInformation Index="0">'
         b'<LabelTable><Label Key="0"><![CDATA[???]]></Label><Label Key="1" Red="0">'
         b'<![CDATA[liver]]></Label><Label Key="2"> left&#10;kidney </Label>'
         b'<Label Key="3">liver</Label></LabelTable></VolumeInformation></CaretExtension>')
META_TYPES = {"u1": "MET_UCHAR", "i1": "MET_CHAR", "u2": "MET_USHORT", "i2": "MET_SHORT",
              "i4": "MET_INT", "f4": "MET_FLOAT", "f8": "MET_DOUBLE"}
STRAIGHT = np.diag([0.25, 0.25, 0.5])  # step vectors


def kind(values):
    return values.dtype.str[1:]


def save(path, *parts):
    """Writes a file and returns its path. A path in .gz is compressed, without a date."""
    data = b"".join(parts)
    with open(path, "wb") as file:
        file.write(gzip.compress(data, mtime=0) if path.endswith(".gz") else data)
    return path


def quaternion(axes):
    """Returns b, c, d of the rotation whose columns are the rows of `axes`."""
    r = np.transpose(axes)
    a = np.sqrt(max(0.0, 1 + np.trace(r))) / 2
    if a > 0.1:
        return [(r[2, 1] - r[1, 2]) / (4 * a), (r[0, 2] - r[2, 0]) / (4 * a),
                (r[1, 0] - r[0, 1]) / (4 * a)]
    b, c, d = np.sqrt(np.maximum(0.0, 1 + 2 * np.diag(r) - np.trace(r))) / 2
    return [b, np.copysign(c, r[0, 1]), np.copysign(d, r[0, 2])]  # b is positive


def write_nifti(path, values, origin, steps=STRAIGHT, forms="s", slope=(1, 0), dim=None, order="<",
                extension=b""):
    """Writes a NIfTI file; `forms`: transforms that give the position: "s", "q", "sq" or ""."""
    steps = np.asarray(steps, float)
    spacing = np.linalg.norm(steps, axis=1)
    handed = -1.0 if np.linalg.det(steps) < 0 else 1.0
    axes = steps / spacing[:, None] * np.array([1, 1, handed])[:, None]
    header = bytearray(352)

    def put(offset, form, *numbers):
        struct.pack_into(order + form, header, offset, *numbers)

    put(0, "i", 348)
    put(40, "8h", *(dim or (3, *values.shape[::-1], 1, 1, 1, 1)))
    put(70, "2h", NIFTI_TYPES[kind(values)], 8 * values.itemsize)
    put(76, "8f", handed, *spacing, 0, 0, 0, 0)
    extension += bytes(-(len(extension) + 8) % 16)
    extension = struct.pack(order + "2i", len(extension) + 8, 30) + extension if any(
        extension) else b""
    put(108, "3f", 352 + len(extension), *slope)
    header[348] = bool(extension)
    put(123, "b", 2)  # unit: millimetres
    put(252, "2h", "q" in forms, "s" in forms)
    if "q" in forms:
        put(256, "6f", *quaternion(axes), *origin)
    if "s" in forms:
        put(280, "12f", *np.column_stack([steps.T, origin]).ravel())
    header[344:348] = b"n+1\0"
    return save(path, bytes(header), extension, values.astype(order + kind(values)).tobytes())


def write_mgh(path, values, origin, steps=STRAIGHT, kind_of_values=None):
    """Writes an MGH file of FreeSurfer; values: (z, y, x), or (n, z, y, x) for several images."""
    steps = np.asarray(steps, float)
    spacing = np.linalg.norm(steps, axis=1)
    size = np.array(values.shape[-3:][::-1])
    middle = np.asarray(origin) + (size / 2) @ steps
    number = {"u1": 0, "i4": 1, "f4": 3, "i2": 4}[kind(values)]
    header = struct.pack(">7ih15f", 1, *size, values.size // size.prod(),
                         number if kind_of_values is None else kind_of_values, 0, 1, *spacing,
                         *(steps / spacing[:, None]).ravel(), *middle)
    data = header + bytes(284 - len(header)) + values.astype(">" + kind(values)).tobytes()
    return save(path, gzip.compress(data, mtime=0) if path.endswith(".mgz") else data)


def write_nrrd(path, values, origin, steps=STRAIGHT, encoding="gzip",
               space="left-posterior-superior", more="", data=None):
    """Writes an NRRD file; `data`: name of a separate file for the values, in the same folder."""
    vector = lambda v: "(%s)" % ",".join(repr(float(x)) for x in v)
    head = "NRRD0005\n# by a test\ntype: %s\ndimension: 3\n" % NRRD_TYPES[kind(values)]
    head += "space: %s\n" % space if space else ""
    head += "sizes: %d %d %d\n" % values.shape[::-1]
    head += "space directions: %s\nspace origin: %s\n" % (" ".join(map(vector, steps)),
                                                          vector(origin)) if space else (
        "spacings: %r %r %r\n" % tuple(np.diag(steps)))
    head += "kinds: domain domain domain\nendian: little\nencoding: %s\n%s" % (encoding, more)
    values = values.astype("<" + kind(values)).tobytes()
    values = gzip.compress(values, mtime=0) if encoding == "gzip" else values
    if not data:
        return save(path, head.encode(), b"\n", values)
    save(os.path.join(os.path.dirname(path), data), values)
    return save(path, head.encode(), b"data file: %s\n" % data.encode())


def write_meta(path, values, origin, steps=STRAIGHT, packed=False):
    """Writes .mha, or .mhd with the values in a .raw or .zraw file."""
    steps = np.asarray(steps, float)
    spacing = np.linalg.norm(steps, axis=1)
    numbers = lambda v: " ".join(repr(float(x)) for x in np.ravel(v))
    data = values.astype("<" + kind(values)).tobytes()
    data = zlib.compress(data) if packed else data
    local = path.endswith(".mha")
    raw = "LOCAL" if local else os.path.basename(path)[:-4] + (".zraw" if packed else ".raw")
    head = ("ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
            "CompressedData = %s\n" % bool(packed))
    head += "CompressedDataSize = %d\n" % len(data) if packed else ""
    head += ("TransformMatrix = %s\nOffset = %s\nElementSpacing = %s\nDimSize = %d %d %d\n"
             "ElementType = %s\nElementDataFile = %s\n" % (
                 numbers(steps / spacing[:, None]), numbers(origin), numbers(spacing),
                 *values.shape[::-1], META_TYPES[kind(values)], raw))
    if not local:
        save(os.path.join(os.path.dirname(path), raw), data)
    return save(path, head.encode(), data if local else b"")


def write_tiff(path, values):
    """Writes one page per slice by VTK; x points right, y up."""
    data = vtkImageData()
    data.SetDimensions(values.shape[::-1])
    data.GetPointData().SetScalars(numpy_to_vtk(np.ascontiguousarray(values).ravel(), deep=1))
    writer = vtkTIFFWriter()
    writer.SetInputData(data)
    writer.SetFileName(path)
    writer.Write()
    return path


def write_pages(path, values, bits=8, tile=0, white_first=False, colours=1, resolution=None,
                unit=1, description=None, big=False, reverse_bits=False, order="<"):
    """Writes a TIFF of one page per slice; values: (z, y, x), or (z, y, x, samples) for colours.

    tile: side of tiles, 0 for one strip; resolution: points per unit (1 none, 2 inch, 3 cm);
    big: offsets of 64 bits.
    """
    wide, head = ("Q", 16) if big else ("I", 8)
    out = bytearray(struct.pack(order + ("2s3HQ" if big else "2sHI"),
                                b"II" if order == "<" else b"MM",
                                *((43, 8, 0, 0) if big else (42, 0))))
    link = head - struct.calcsize(wide)

    def add(data):
        at = len(out)
        out.extend(data + bytes(-len(data) % 8))
        return at

    def pack(rows):
        if bits >= 8:
            return rows.astype(order + rows.dtype.str[1:]).tobytes()
        expanded = (rows[..., None] >> np.arange(bits)[::-1]) & 1
        packed = np.packbits(expanded.reshape(len(rows), -1).astype("u1"), axis=1)
        if reverse_bits:
            packed = np.packbits(np.unpackbits(packed.ravel()).reshape(-1, 8)[:, ::-1], axis=1)
        return packed.tobytes()

    formats = {"u": 1, "i": 2, "f": 3}
    for number, page in enumerate(values):
        page = 2 ** bits - 1 - page if white_first else page
        height, width = page.shape[:2]
        if tile:
            padded = np.zeros((-(-height // tile) * tile, -(-width // tile) * tile,
                               *page.shape[2:]), page.dtype)
            padded[:height, :width] = page
            parts = [padded[y:y + tile, x:x + tile] for y in range(0, len(padded), tile)
                     for x in range(0, padded.shape[1], tile)]
        else:
            parts = [page]
        parts = [pack(part) for part in parts]
        offsets, lengths = [add(part) for part in parts], [len(part) for part in parts]
        tags = {256: ("I", [width]), 257: ("I", [height]), 258: ("H", [bits] * colours),
                259: ("H", [1]), 262: ("H", [2 if colours > 1 else int(not white_first)]),
                277: ("H", [colours]), 339: ("H", [formats[kind(values)[0]]] * colours)}
        tags.update({322: ("I", [tile]), 323: ("I", [tile]), 324: (wide, offsets),
                     325: ("I", lengths)} if tile else
                    {273: (wide, offsets), 278: ("I", [height]), 279: ("I", lengths)})
        if colours == 4:
            tags[338] = "H", [2]
        if reverse_bits:
            tags[266] = "H", [2]
        if description and number == 0:
            tags[270] = "s", [description.encode() + b"\0"]
        if resolution:
            tags.update({282: ("2I", [resolution * 1000, 1000]),
                         283: ("2I", [resolution * 1000, 1000]), 296: ("H", [unit])})
        entries = b""
        for tag, (form, content) in sorted(tags.items()):
            count = len(content[0]) if form == "s" else 1 if form == "2I" else len(content)
            data = content[0] if form == "s" else struct.pack(
                "%s%d%s" % (order, len(content), form[-1]), *content)
            inline = struct.calcsize(wide)
            data = data.ljust(inline, b"\0") if len(data) <= inline else struct.pack(
                order + wide, add(data))
            entries += struct.pack(order + "HH" + wide, tag,
                                   {"H": 3, "I": 4, "s": 2, "2I": 5, "Q": 16}[form], count) + data
        struct.pack_into(order + wide, out, link, len(out))
        out += struct.pack(order + ("Q" if big else "H"), len(tags)) + entries
        link = len(out)
        out += bytes(struct.calcsize(wide))
    return save(path, bytes(out))


def write_png(path, values, palette=None, depth=None):
    """Writes grey values (y, x), indices of a palette, or colours (y, x, 2 to 4 samples)."""
    depth = depth or 8 * values.itemsize
    colour = 3 if palette else {2: 4, 3: 2, 4: 6}[values.shape[2]] if values.ndim == 3 else 0

    def chunk(name, data):
        check = struct.pack(">I", zlib.crc32(name + data))
        return struct.pack(">I", len(data)) + name + data + check

    rows = values.astype(">" + kind(values)).reshape(len(values), -1)
    if depth < 8:
        bits = (rows[..., None] >> np.arange(depth)[::-1]) & 1
        rows = np.packbits(bits.reshape(len(rows), -1).astype("u1"), axis=1)
    data = b"".join(b"\0" + row.tobytes() for row in rows)
    return save(path, b"\x89PNG\r\n\x1a\n",
                chunk(b"IHDR", struct.pack(">2I5B", values.shape[1], len(values), depth, colour,
                                           0, 0, 0)),
                chunk(b"PLTE", bytes(palette)) if palette else b"",
                chunk(b"IDAT", zlib.compress(data)), chunk(b"IEND", b""))


def write_imagej(path, values):
    """Writes one page followed by the other slices, as ImageJ does with stacks above 4 GB."""
    depth, height, width = values.shape
    text = b"ImageJ=1.53t\nimages=%d\nslices=%d\n\0" % (depth, depth)
    tags = {256: width, 257: height, 258: 8, 259: 1, 262: 1, 270: 0, 273: 0, 277: 1, 278: height,
            279: width * height}
    start = 8 + 2 + 12 * len(tags) + 4
    tags[270], tags[273] = start, start + len(text)
    entries = [struct.pack("<HHII", tag, 2 if tag == 270 else 4, len(text) if tag == 270 else 1,
                           tags[tag]) for tag in sorted(tags)]
    return save(path, struct.pack("<2sHIH", b"II", 42, 8, len(tags)), *entries, bytes(4), text,
                values.astype("u1").tobytes())


def write_dream3d(path, values, origin, spacing, name="FeatureIds", more=(), shape=None):
    """Writes a file like DREAM.3D 6; `origin` is the corner of the first cell.

    more: names of further containers with the same contents. shape: (-1,) or (-1, 1) for arrays
    without indices of cells.
    """
    with h5py.File(path, "w") as file:
        for container in ("ImageDataContainer", *more):
            group = file.create_group("DataContainers/" + container)
            geometry = group.create_group("_SIMPL_GEOMETRY")
            geometry["DIMENSIONS"] = np.array(values.shape[::-1], "i8")
            geometry["SPACING"], geometry["ORIGIN"] = np.array(spacing, "f4"), np.array(
                origin, "f4")
            group["CellData/" + name] = values.reshape(shape) if shape else values[..., None]
            group["CellData/EulerAngles"] = np.zeros(values.shape + (3,), "f4")
            group["CellFeatureData/Volumes"] = np.zeros((4, 1), "f4")
    return path


def write_old_dream3d(path, values, origin, spacing):
    """Writes a file like DREAM.3D 4, with flat arrays."""
    with h5py.File(path, "w") as file:
        group = file.create_group("VoxelDataContainer")
        group["DIMENSIONS"] = np.array(values.shape[::-1], "i8")
        group["SPACING"], group["ORIGIN"] = np.array(spacing, "f4"), np.array(origin, "f4")
        group["CELL_DATA/GrainIds"] = values.ravel()
    return path


def write_dream3d_nx(path, values, origin, spacing):
    """Writes a file like DREAM3D-NX: in a group, compressed."""
    with h5py.File(path, "w") as file:
        file.attrs["FileVersion"] = np.bytes_("8.0")
        geometry = file.create_group("DataStructure/Small IN100/Image Geometry")
        geometry.attrs["ObjectType"] = np.bytes_("ImageGeom")
        geometry.attrs["_DIMENSIONS"] = np.array(values.shape[::-1], "u8")
        geometry.attrs["_SPACING"], geometry.attrs["_ORIGIN"] = np.array(spacing, "f4"), np.array(
            origin, "f4")
        geometry.create_dataset("Cell Data/FeatureIds", data=values[..., None], compression="gzip")
        geometry.create_dataset("Cell Data/Phases", data=np.ones(values.shape + (1,), "i4"))
    return path
