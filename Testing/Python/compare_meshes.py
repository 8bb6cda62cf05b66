#!/usr/bin/env pvpython
"""Merges the pieces of a mesh by their global ids and compares two meshes byte by byte.

usage: pvpython compare_meshes.py MESH.pvtu GOLD.pvtu
       also .vtu; .pvtp and .vtp for surfaces, curves and vertices

Points shared by several pieces must be equal in all of them; a cell may be in one piece only; field
data must be equal in all pieces. The order of points and cells does not matter.
"""
import os
import sys
import xml.etree.ElementTree

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader


def read_pieces(path):
    """Reads the data sets of a file in a VTK XML format, serial or in pieces."""
    paths = [path]
    if os.path.splitext(path)[1].startswith(".pv"):
        pieces = xml.etree.ElementTree.parse(path).iter("Piece")
        paths = [os.path.join(os.path.dirname(path), piece.get("Source")) for piece in pieces]
    result = []
    for name in paths:
        reader = vtkXMLPolyDataReader() if name.endswith("p") else vtkXMLUnstructuredGridReader()
        reader.SetFileName(name)
        reader.Update()
        result.append(reader.GetOutput())
    return result


def arrays_of(attributes):
    arrays = [attributes.GetArray(i) for i in range(attributes.GetNumberOfArrays())]
    return {array.GetName(): vtk_to_numpy(array) for array in arrays}


def field_of(data):
    arrays = [data.GetFieldData().GetAbstractArray(i)
              for i in range(data.GetFieldData().GetNumberOfArrays())]
    return {a.GetName(): [a.GetValue(v) for v in range(a.GetNumberOfValues())] for a in arrays}


def piece_of(data):
    """Returns points and cells of one piece as {name: array}; connectivity in global point ids."""
    points = arrays_of(data.GetPointData())
    points["Points"] = vtk_to_numpy(data.GetPoints().GetData())
    cells = arrays_of(data.GetCellData())
    kinds = [data.GetCells()] if data.IsA("vtkUnstructuredGrid") else [
        data.GetVerts(), data.GetLines(), data.GetPolys()]
    filled = max(kinds, key=lambda kind: kind.GetNumberOfCells())
    ids = points["GlobalPointIds"][vtk_to_numpy(filled.GetConnectivityArray())]
    cells["Connectivity"] = ids.reshape(data.GetNumberOfCells(), -1)
    return points, cells


def joined(pieces):
    assert len({tuple(sorted(piece)) for piece in pieces}) == 1, "the pieces have different arrays"
    return {name: np.concatenate([piece[name] for piece in pieces]) for name in pieces[0]}


def rows_as_bytes(arrays, order):
    """Joins all arrays to one row of raw bytes per item, for a bitwise comparison."""
    parts = [np.ascontiguousarray(arrays[name][order]).reshape(len(order), -1).view(np.uint8)
             for name in sorted(arrays)]
    return np.concatenate(parts, axis=1)


def merge(pieces):
    """Merges data sets to one mesh.

    Returns {"points", "cells": rows of bytes in the order of the ids, "field": text}.
    """
    filled = [piece for piece in pieces if piece.GetNumberOfCells() > 0]
    fields = [field_of(piece) for piece in pieces]
    assert all(repr(field) == repr(fields[0])
               for field in fields), "the pieces have different field data"
    if not filled:
        return {"points": np.zeros((0, 0), np.uint8), "cells": np.zeros((0, 0), np.uint8),
                "field": repr(fields[0])}
    points, cells = (joined(parts) for parts in zip(*map(piece_of, filled)))
    order = np.argsort(points["GlobalPointIds"], kind="stable")
    rows = rows_as_bytes(points, order)
    ids = points["GlobalPointIds"][order]
    repeated = ids[1:] == ids[:-1]
    assert (rows[1:][repeated] == rows[:-1][
        repeated]).all(), "copies of a point differ between pieces"
    kept = np.concatenate([[True], ~repeated])
    if "GlobalCellIds" in cells:
        assert len(np.unique(cells["GlobalCellIds"])) == len(
            cells["GlobalCellIds"]), "a cell is in two pieces"
        cell_order = np.argsort(cells["GlobalCellIds"])
    else:
        cell_order = np.lexsort(np.sort(cells["Connectivity"], axis=1).T)
    return {"points": rows[kept], "cells": rows_as_bytes(cells, cell_order),
            "field": repr(fields[0])}


def difference(one, other):
    """Returns a description of the first difference of two merged meshes, or an empty text."""
    for part in ("points", "cells"):
        if one[part].shape != other[part].shape:
            return "%s %s instead of %s" % (part, one[part].shape, other[part].shape)
        differ = (one[part] != other[part]).any(axis=1)
        if differ.any():
            return "%d of %d %s differ" % (differ.sum(), len(differ), part)
    return "" if one["field"] == other["field"] else "field data %s instead of %s" % (
        one["field"], other["field"])


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(difference(merge(read_pieces(sys.argv[1])), merge(read_pieces(sys.argv[2]))) or 0)
