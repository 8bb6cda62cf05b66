#!/usr/bin/env pvpython
"""Merges the pieces of a mesh by their global ids and compares meshes bit for bit.

usage: pvpython compare_meshes.py MESH.pvtu GOLD.pvtu     also .vtu, and .pvtp and .vtp for
       surfaces, curves, vertices

Points that several pieces share must be the same in all; a cell may be in one piece only; field
data must be the same in all pieces. The order of points and cells is of no matter.
"""
import os
import sys
import xml.etree.ElementTree

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader


def read_pieces(path):
    """The data sets of a file of the XML formats, in serial or in pieces."""
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
    """Points and cells of one piece as {name: array}; connectivity in global point ids."""
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
    """All arrays side by side, a row an item, each row as raw bytes: compares bit for bit."""
    parts = [np.ascontiguousarray(arrays[name][order]).reshape(len(order), -1).view(np.uint8)
             for name in sorted(arrays)]
    return np.concatenate(parts, axis=1)


def merge(pieces):
    """The whole of a mesh from its data sets: {"points", "cells": bytes a row in the order of the
    ids, "field"}."""
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
    """What differs between two merged meshes, or an empty text."""
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
