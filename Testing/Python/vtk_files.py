"""Files of VTK with labels of cells: each kind of grid, each form of storage, and damaged files."""
import os

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (
    VTK_HEXAHEDRON, VTK_VOXEL, vtkCellArray, vtkMultiBlockDataSet, vtkStructuredGrid,
    vtkUnstructuredGrid)
from vtkmodules.vtkIOLegacy import (
    vtkRectilinearGridWriter, vtkStructuredGridWriter, vtkStructuredPointsWriter,
    vtkUnstructuredGridWriter)
from vtkmodules.vtkIOXML import vtkXMLDataSetWriter, vtkXMLMultiBlockDataWriter

from exodus_grids import CORNERS, VOXEL_CORNERS
from vfmtest import add_array, image, rectilinear

NAME = "GrainID"
ELEMENTS = 952  # of the mesh of two_boxes
TURNED = [1, 2, 3, 0, 5, 6, 7, 4]  # corners of a hexahedron, turned about z
MODES = ("ascii", "inline", "raw", "base64", "zlib")


def two_boxes(first=1, second=2, dtype=np.int16):
    """Returns labels (z, y, x) of two boxes side by side in void, 240 cells each."""
    labels = np.zeros((10, 12, 14), dtype)
    labels[2:8, 2:10, 2:7] = first
    labels[2:8, 2:10, 7:12] = second
    return labels


def nodes_of(labels):
    return [np.arange(n + 1.0) for n in labels.shape[::-1]]


def structured(labels, coordinates=None):
    """Returns a curvilinear grid; coordinates: points (z, y, x, 3)."""
    if coordinates is None:
        coordinates = np.stack(np.meshgrid(*nodes_of(labels)[::-1], indexing="ij")[::-1], axis=-1)
    grid, points = vtkStructuredGrid(), vtkPoints()
    grid.SetDimensions([n + 1 for n in labels.shape[::-1]])
    points.SetData(numpy_to_vtk(coordinates.reshape(-1, 3), deep=1))
    grid.SetPoints(points)
    add_array(grid.GetCellData(), NAME, labels)
    return grid


def cells_of(labels, kind=VTK_HEXAHEDRON, chosen=None, turns=False):
    """Returns cells with their labels, each with its own eight points.

    chosen: numbers of the cells, in their order; turns: corners begin anywhere
    """
    chosen = np.arange(labels.size) if chosen is None else chosen
    z, y, x = np.unravel_index(chosen, labels.shape)
    corners = CORNERS if kind == VTK_HEXAHEDRON else VOXEL_CORNERS
    points = np.stack([x, y, z], axis=1)[:, None] + corners[None]
    if turns:
        points[::2] = points[::2][:, TURNED]
    grid, holder, cells = vtkUnstructuredGrid(), vtkPoints(), vtkCellArray()
    holder.SetData(numpy_to_vtk(points.reshape(-1, 3).astype(np.float64), deep=1))
    cells.SetData(8, numpy_to_vtkIdTypeArray(np.arange(8 * len(chosen)), deep=1))
    grid.SetPoints(holder)
    grid.SetCells(kind, cells)
    add_array(grid.GetCellData(), NAME, labels.ravel()[chosen])
    return grid


def grids(labels):
    """Yields (name, suffix, data) of each kind of grid."""
    shuffled = np.random.default_rng(2).permutation(labels.size)
    yield "image", ".vti", image({NAME: labels})
    yield "rectilinear", ".vtr", rectilinear({NAME: labels}, nodes_of(labels))
    yield "structured", ".vts", structured(labels)
    yield "hexes", ".vtu", cells_of(labels)
    yield "voxels", ".vtu", cells_of(labels, VTK_VOXEL)
    yield "turned", ".vtu", cells_of(labels, VTK_HEXAHEDRON, shuffled, True)


def write_legacy(path, data, binary, version=51):
    """Writes a legacy file. Version 4.2 has SCALARS and lists of cells, 5.1 FIELD and offsets."""
    writer = {"vtkImageData": vtkStructuredPointsWriter,
              "vtkRectilinearGrid": vtkRectilinearGridWriter,
              "vtkStructuredGrid": vtkStructuredGridWriter,
              "vtkUnstructuredGrid": vtkUnstructuredGridWriter}[data.GetClassName()]()
    data.GetCellData().SetActiveScalars(NAME if version == 42 else None)
    writer.SetInputData(data)
    writer.SetFileName(path)
    writer.SetFileVersion(version)
    writer.SetFileTypeToBinary() if binary else writer.SetFileTypeToASCII()
    assert writer.Write()
    return path


def write_xml(path, data, mode="raw"):
    """Writes a file in one of the MODES."""
    writer = vtkXMLDataSetWriter()
    writer.SetInputData(data)
    writer.SetFileName(path)
    writer.SetCompressorTypeToNone()
    if mode == "ascii":
        writer.SetDataModeToAscii()
    elif mode == "inline":
        writer.SetDataModeToBinary()
    else:
        writer.SetDataModeToAppended()
        writer.SetEncodeAppendedData(mode == "base64")
        if mode == "zlib":
            writer.SetCompressorTypeToZLib()
    assert writer.Write()
    return path


def write_pieces(path, labels, count=3):
    """Writes a .pvtu of some pieces."""
    lines = []
    for number, chosen in enumerate(np.array_split(np.arange(labels.size), count)):
        name = "%s_%d.vtu" % (os.path.basename(path)[:-5], number)
        write_xml(os.path.join(os.path.dirname(path), name), cells_of(labels, chosen=chosen))
        lines.append('<Piece Source="%s"/>' % name)
    with open(path, "w") as out:
        out.write('<VTKFile type="PUnstructuredGrid" version="0.1" byte_order="LittleEndian">'
                  '<PUnstructuredGrid GhostLevel="0"><PCellData>'
                  '<PDataArray type="Int16" Name="%s"/></PCellData><PPoints>'
                  '<PDataArray type="Float64" NumberOfComponents="3"/></PPoints>'
                  "%s</PUnstructuredGrid></VTKFile>" % (NAME, "".join(lines)))
    return path


def write_blocks(path, *data):
    blocks = vtkMultiBlockDataSet()
    for number, block in enumerate(data):
        blocks.SetBlock(number, block)
    writer = vtkXMLMultiBlockDataWriter()
    writer.SetInputData(blocks)
    writer.SetFileName(path)
    assert writer.Write()
    return path
