"""Reads closed surfaces of triangles from arrays, files, meshio and PyVista."""

from __future__ import annotations

import os
import warnings
from typing import Any, List, Mapping, Optional, Tuple

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._core import Bodies
from ._warning import VolumeFractionMeshWarning

Triangles = Tuple[np.ndarray, np.ndarray]
Patched = Tuple[np.ndarray, np.ndarray, Optional[np.ndarray], List[str]]
NO_NAME = [""]  # of the only patch
PATCHES = ("STLSolidLabeling", "MaterialIds", "GroupIds")  # cell arrays of VTK's readers
FIELDS = ("Points", "Triangles", "Bodies", "Patches", "Names", "PatchNames")
CALLER = 6  # stack level of the caller of surface(), for warnings


def read_bodies(surfaces: Any, triangles: Optional[ArrayLike]) -> Bodies:
    """Returns the bodies of a surface, or of a list of paths or a dict of surfaces."""
    if isinstance(surfaces, (list, tuple)) and surfaces and all(map(is_path, surfaces)):
        return _read_paths([os.fspath(path) for path in surfaces])
    if triangles is not None and isinstance(surfaces, Mapping):
        raise TypeError(
            "triangles belong to one array of points: for several surfaces give a dict "
            "{name: (points, triangles)}."
        )
    named = dict(surfaces) if isinstance(surfaces, Mapping) else {"Material1": surfaces}
    if not named:
        raise ValueError("surfaces are empty: at least one is required.")
    return Bodies([(name, *_read_surface(value, triangles)) for name, value in named.items()])


def is_path(value: Any) -> bool:
    return isinstance(value, (str, os.PathLike))


def _read_paths(paths: List[str]) -> Bodies:
    """Reads files, whose names are those of the bodies."""
    if all(map(_core.is_surface_file, paths)) and all(map(os.path.exists, paths)):
        return _core.read_bodies(paths, _warn)
    names = [os.path.splitext(os.path.basename(path))[0] for path in paths]
    for name in names:
        if names.count(name) > 1:
            raise ValueError("Two surfaces would be the material %s: rename one of the files." % name)
    return Bodies([(name, *_read_file(path)) for name, path in zip(names, paths)])


def _read_surface(value: Any, triangles: Optional[ArrayLike]) -> Patched:
    """Returns points, float64 of shape (n, 3), triangles, int64 of shape (m, 3), patches, int32 of
    shape (m,) or None, and their names."""
    if is_path(value):
        return _read_file(os.fspath(value))
    if hasattr(value, "GetPolys"):
        return _of_polydata(value)
    if isinstance(value, tuple) and len(value) == 2 and triangles is None:
        value, triangles = value
    elif hasattr(value, "cells_dict"):
        value, triangles = _of_meshio(value)
    if triangles is None:
        raise TypeError(
            "The surface is a %s: a path, a pyvista.PolyData, a meshio.Mesh, or points and "
            "triangles are required." % type(value).__name__
        )
    return (*_check(value, triangles), None, NO_NAME)


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


def _read_file(path: str) -> Patched:
    if not os.path.exists(path):
        raise FileNotFoundError("There is no file %s." % path)
    if _core.is_surface_file(path):
        return _core.read_surface(path, _warn)
    try:
        import meshio
    except ImportError:
        raise ImportError("Reading %s requires meshio: pip install meshio" % path) from None
    return (*_check(*_of_meshio(meshio.read(path))), None, NO_NAME)


def _warn(note: str) -> None:
    warnings.warn(note, VolumeFractionMeshWarning, stacklevel=CALLER)


def _of_meshio(mesh: Any) -> Triangles:
    """Returns the triangles, and quadrilaterals cut into two."""
    cells = mesh.cells_dict
    parts = [cells["triangle"]] if "triangle" in cells else []
    if "quad" in cells:
        parts += [cells["quad"][:, [0, 1, 2]], cells["quad"][:, [0, 2, 3]]]
    if not parts:
        raise ValueError("The mesh has no triangles.")
    return mesh.points, np.concatenate(parts)


def _of_polydata(surface: Any) -> Patched:
    """Returns the polygons, cut into triangles, and the patches of VTK's readers."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkFiltersCore import vtkTriangleFilter

    cut = vtkTriangleFilter()
    cut.PassLinesOff()
    cut.PassVertsOff()
    cut.SetInputData(surface)
    cut.Update()
    data = cut.GetOutput()
    polygons = data.GetPolys()
    if polygons.GetNumberOfCells() == 0:
        raise ValueError("The surface has no polygons.")
    corners = vtk_to_numpy(polygons.GetConnectivityArray()).reshape(-1, 3)
    found = _check(vtk_to_numpy(data.GetPoints().GetData()), corners)
    name = next((name for name in PATCHES if data.GetCellData().HasArray(name)), None)
    if name is None:
        return (*found, None, NO_NAME)
    values, patches = np.unique(vtk_to_numpy(data.GetCellData().GetArray(name)),
                                return_inverse=True)
    texts = data.GetFieldData().GetAbstractArray("MaterialNames") if name == "MaterialIds" else None
    names = [texts.GetValue(int(value)) if texts is not None
             and 0 <= value < texts.GetNumberOfValues() else "" for value in values]
    return (*found, patches.ravel().astype(np.int32), names)


def bodies_of_fields(data: Any) -> Optional[Bodies]:
    """Returns the bodies in the field data of a data set of VTK, which Volume Fraction Of Surface
    writes; None if there are none."""
    from vtkmodules.util.numpy_support import vtk_to_numpy

    fields = data.GetFieldData()
    arrays = {name: fields.GetAbstractArray("InputSurface" + name) for name in FIELDS}
    if any(array is None for array in arrays.values()):
        return None
    points, triangles, owners, patches = (vtk_to_numpy(arrays[name]) for name in FIELDS[:4])
    names, patch_names = ([arrays[name].GetValue(i) for i in range(arrays[name].GetNumberOfValues())]
                          for name in FIELDS[4:])
    return Bodies([
        (name, *_check(points, triangles[owners == b]), patches[owners == b].astype(np.int32),
         patch_names) for b, name in enumerate(names)])
