"""Reads closed surfaces of triangles from arrays, STL files, meshio and PyVista."""

from __future__ import annotations

import os
from typing import Any, Optional, Tuple

import numpy as np
from numpy.typing import ArrayLike

Triangles = Tuple[np.ndarray, np.ndarray]
# Record of a binary STL file
RECORD = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])


def read_surface(value: Any, triangles: Optional[ArrayLike] = None) -> Triangles:
    """Returns points, float64 of shape (n, 3), and triangles, int64 of shape (m, 3)."""
    if isinstance(value, (str, os.PathLike)):
        return _check(*_read_file(os.fspath(value)))
    if isinstance(value, tuple) and len(value) == 2 and triangles is None:
        return _check(*value)
    if hasattr(value, "GetPolys"):
        return _check(*_of_polydata(value))
    if hasattr(value, "cells_dict"):
        return _check(*_of_meshio(value))
    if triangles is None:
        raise TypeError(
            "The surface is a %s: a path, a pyvista.PolyData, a meshio.Mesh, or points and "
            "triangles are required." % type(value).__name__
        )
    return _check(value, triangles)


def _check(points: Any, triangles: Any) -> Triangles:
    places = np.ascontiguousarray(points, dtype=np.float64)
    corners = np.asarray(triangles)
    if places.ndim != 2 or places.shape[1] != 3:
        raise ValueError("points has the shape %r: (n, 3) is required." % (places.shape,))
    if corners.ndim != 2 or corners.shape[1] != 3 or corners.dtype.kind not in "iu":
        raise ValueError(
            "triangles has the shape %r and the type %s: (m, 3) integers are required."
            % (corners.shape, corners.dtype)
        )
    if len(corners) == 0:
        raise ValueError("The surface has no polygons.")
    return places, np.ascontiguousarray(corners, dtype=np.int64)


def _read_file(path: str) -> Triangles:
    if path.lower().endswith(".stl"):
        return _read_stl(path)
    try:
        import meshio
    except ImportError:
        raise ImportError("Reading %s requires meshio: pip install meshio" % path) from None
    return _of_meshio(meshio.read(path))


def _read_stl(path: str) -> Triangles:
    with open(path, "rb") as file:
        data = file.read()
    count = int.from_bytes(data[80:84], "little")
    if len(data) >= 84 and len(data) == 84 + RECORD.itemsize * count:
        corners = np.frombuffer(data, RECORD, count, 84)["corners"].reshape(-1, 3)
    else:
        lines = (line.split() for line in data.decode("ascii", "replace").splitlines())
        try:
            corners = np.array([line[1:4] for line in lines if line
                                and line[0].lower() == "vertex"], dtype=np.float64)
        except ValueError:
            corners = np.empty((0, 3))
        if corners.ndim != 2 or corners.shape[1:] != (3,) or len(corners) % 3 or not len(corners):
            raise ValueError("%s is not an STL file, or is truncated." % path)
    return np.asarray(corners, dtype=np.float64), np.arange(len(corners)).reshape(-1, 3)


def _of_meshio(mesh: Any) -> Triangles:
    """Returns the triangles, and quadrilaterals cut into two."""
    cells = mesh.cells_dict
    parts = [cells["triangle"]] if "triangle" in cells else []
    if "quad" in cells:
        parts += [cells["quad"][:, [0, 1, 2]], cells["quad"][:, [0, 2, 3]]]
    if not parts:
        raise ValueError("The mesh has no triangles.")
    return mesh.points, np.concatenate(parts)


def _of_polydata(surface: Any) -> Triangles:
    """Returns the polygons, cut into triangles."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkFiltersCore import vtkTriangleFilter

    cut = vtkTriangleFilter()
    cut.PassLinesOff()
    cut.PassVertsOff()
    cut.SetInputData(surface)
    cut.Update()
    polygons = cut.GetOutput().GetPolys()
    if polygons.GetNumberOfCells() == 0:
        raise ValueError("The surface has no polygons.")
    corners = vtk_to_numpy(polygons.GetConnectivityArray()).reshape(-1, 3)
    return vtk_to_numpy(cut.GetOutput().GetPoints().GetData()), corners
