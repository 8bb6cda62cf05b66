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


def write_nifti(path, values, origin, steps=STRAIGHT, forms="s", slope=(1, 0), dim=None, order="<"):
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
    put(108, "3f", 352, *slope)
    put(123, "b", 2)  # unit: millimetres
    put(252, "2h", "q" in forms, "s" in forms)
    if "q" in forms:
        put(256, "6f", *quaternion(axes), *origin)
    if "s" in forms:
        put(280, "12f", *np.column_stack([steps.T, origin]).ravel())
    header[344:348] = b"n+1\0"
    return save(path, bytes(header), values.astype(order + kind(values)).tobytes())


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


def write_dream3d(path, values, origin, spacing, name="FeatureIds", more=()):
    """Writes a file like DREAM.3D 6; `origin` is the corner of the first cell.

    more: names of further containers with the same contents.
    """
    with h5py.File(path, "w") as file:
        for container in ("ImageDataContainer", *more):
            group = file.create_group("DataContainers/" + container)
            geometry = group.create_group("_SIMPL_GEOMETRY")
            geometry["DIMENSIONS"] = np.array(values.shape[::-1], "i8")
            geometry["SPACING"], geometry["ORIGIN"] = np.array(spacing, "f4"), np.array(
                origin, "f4")
            group["CellData/" + name] = values[..., None]
            group["CellData/EulerAngles"] = np.zeros(values.shape + (3,), "f4")
            group["CellFeatureData/Volumes"] = np.zeros((4, 1), "f4")
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
