"""Reads closed surfaces of triangles from arrays, files, meshio and PyVista."""

from __future__ import annotations

import os
import warnings
import zlib
from typing import Any, Dict, List, Mapping, NamedTuple, Optional

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._core import Bodies
from ._readers import step_files
from ._warning import VolumeFractionMeshWarning

PATCHES = ("STLSolidLabeling", "MaterialIds", "GroupIds")  # cell arrays of VTK's readers
FIELDS = ("Points", "Triangles", "Bodies", "Patches", "Names", "PatchNames")
CALLER = 5  # stack level of the caller of surface(), for warnings


class Body(NamedTuple):
    """Triangles of one body: corners may be repeated, and the surface may be open."""

    name: Optional[str]  # of the body in its file
    points: np.ndarray  # float64, (n, 3)
    triangles: np.ndarray  # int64, (m, 3)
    patches: np.ndarray  # int32, (m,): patch of each triangle
    patch_names: List[str]  # empty texts for patches without a name


def read_bodies(surfaces: Any, triangles: Optional[ArrayLike]) -> Bodies:
    """Returns the bodies of a surface, of a list of paths, or of a dict of surfaces."""
    if isinstance(surfaces, (list, tuple)) and surfaces and all(map(_is_path, surfaces)):
        named = _name_files([os.fspath(path) for path in surfaces])
    elif triangles is not None and isinstance(surfaces, Mapping):
        raise TypeError(
            "triangles belong to one array of points: for several surfaces give a dict "
            "{name: (points, triangles)}."
        )
    else:
        named = dict(surfaces) if isinstance(surfaces, Mapping) else {"Material1": surfaces}
    if not named:
        raise ValueError("surfaces are empty: at least one is required.")
    found = {}
    for name, value in named.items():
        if not isinstance(name, str) or not name:
            raise TypeError("The name of a surface is %r: it must be a str." % (name,))
        found[name] = read_surface(value, triangles)
    bodies = Bodies([body._replace(name=name) for name, body in name_bodies(found).items()])
    if bodies.note:
        warnings.warn(bodies.note, VolumeFractionMeshWarning, stacklevel=CALLER - 2)
    return bodies


def _is_path(value: Any) -> bool:
    return isinstance(value, (str, os.PathLike))


def _name_files(paths: List[str]) -> Dict[str, str]:
    """Returns the paths by the names of their files without suffixes."""
    named: Dict[str, str] = {}
    for path in paths:
        whole = path[:-3] if path.lower().endswith(".gz") else path
        name = os.path.splitext(os.path.basename(whole))[0]
        if name in named:
            raise ValueError("The surfaces %s and %s would both be the material %s: rename one of "
                             "the files." % (named[name], path, name))
        named[name] = path
    return named


def read_surface(value: Any, triangles: Optional[ArrayLike] = None) -> List[Body]:
    """Returns the bodies of a path, an object of PyVista or meshio, points, or (points, triangles).

    There are several if a STEP or 3MF file has several solids. Notes about a file are a warning.
    """
    if _is_path(value):
        return _read_file(os.fspath(value))
    if isinstance(value, tuple) and len(value) == 2 and triangles is None:
        return [_body(*value)]
    if hasattr(value, "GetPolys"):
        return [_of_polydata(value)]
    if hasattr(value, "cells_dict"):
        return [_of_meshio(value)]
    if triangles is None:
        raise TypeError(
            "The surface is a %s: a path, a pyvista.PolyData, a meshio.Mesh, or points and "
            "triangles are required." % type(value).__name__
        )
    return [_body(value, triangles)]


def name_bodies(surfaces: Mapping[str, List[Body]]) -> Dict[str, Body]:
    """Returns the bodies by unique names: the key if its surface has one body, else their own."""
    named: Dict[str, Body] = {}
    for key, bodies in surfaces.items():
        for number, body in enumerate(bodies, 1):
            name = first = key if len(bodies) == 1 else body.name or "%s %d" % (key, number)
            copy = 1
            while name in named:
                copy += 1
                name = "%s %d" % (first, copy)
            named[name] = body
    return named


def _body(points: Any, triangles: Any) -> Body:
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
    return Body(None, places, np.ascontiguousarray(corners, dtype=np.int64),
                np.zeros(len(corners), dtype=np.int32), [""])


def _read_file(path: str) -> List[Body]:
    with open(path, "rb"):  # raises the OSError of a file that cannot be read
        pass
    if step_files.is_step_file(path):
        return [Body(*body) for body in step_files.read(path)]
    if _core.is_surface_file(path):
        found = _core.read_surface(path, _inflate)
        notes = [note for *_, note in found if note]
        if notes:
            warnings.warn("%s: %s" % (path, " ".join(notes)), VolumeFractionMeshWarning,
                          stacklevel=CALLER)
        return [Body(name or None, *rest) for name, *rest, _ in found]
    try:
        import meshio
    except ImportError:
        raise ImportError("Reading %s requires meshio: pip install meshio" % path) from None
    return [_of_meshio(meshio.read(path))]


def _inflate(packed: bytes, window_bits: int, most: int) -> bytes:
    """Returns unpacked bytes, of all members of gzip."""
    parts, left, size = [], packed, 0
    try:
        while left or not parts:
            inflater = zlib.decompressobj(window_bits)
            parts.append(inflater.decompress(left, most - size + 1))
            size += len(parts[-1])
            if size > most:
                raise ValueError("its compressed data are larger than announced.")
            if not inflater.eof:
                raise ValueError("its compressed data are truncated.")
            left = inflater.unused_data if window_bits == 31 else b""
    except zlib.error:
        raise ValueError("its compressed data are damaged.") from None
    return b"".join(parts)


def _of_meshio(mesh: Any) -> Body:
    """Returns the triangles, and quadrilaterals cut into two."""
    cells = mesh.cells_dict
    parts = [cells["triangle"]] if "triangle" in cells else []
    if "quad" in cells:
        parts += [cells["quad"][:, [0, 1, 2]], cells["quad"][:, [0, 2, 3]]]
    if not parts:
        raise ValueError("The mesh has no triangles.")
    return _body(mesh.points, np.concatenate(parts))


def _of_polydata(surface: Any) -> Body:
    """Returns the polygons, cut into triangles, with the patches of VTK's readers."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkFiltersCore import vtkTriangleFilter

    cut = vtkTriangleFilter()
    cut.PassLinesOff()
    cut.PassVertsOff()
    cut.SetInputData(surface)
    cut.Update()
    data = cut.GetOutput()
    polygons, arrays = data.GetPolys(), data.GetCellData()
    if polygons.GetNumberOfCells() == 0:
        raise ValueError("The surface has no polygons.")
    corners = vtk_to_numpy(polygons.GetConnectivityArray()).reshape(-1, 3)
    body = _body(vtk_to_numpy(data.GetPoints().GetData()), corners)
    found = next((name for name in PATCHES if arrays.HasArray(name)), None)
    if found is None:
        return body
    values, patches = np.unique(vtk_to_numpy(arrays.GetArray(found)), return_inverse=True)
    texts = data.GetFieldData().GetAbstractArray("MaterialNames")
    count = texts.GetNumberOfValues() if texts is not None and found == "MaterialIds" else 0
    names = [texts.GetValue(int(value)) if 0 <= value < count else "" for value in values]
    return body._replace(patches=patches.ravel().astype(np.int32), patch_names=names)


def bodies_of_fields(data: Any) -> Optional[Bodies]:
    """Returns the bodies in the field data of a data set of VTK, which Volume Fraction Of Surface
    writes; None if there are none."""
    from vtkmodules.util.numpy_support import vtk_to_numpy

    fields = data.GetFieldData()
    arrays = {name: fields.GetAbstractArray("InputSurface" + name) for name in FIELDS}
    if any(array is None for array in arrays.values()):
        return None
    points, triangles, owners, patches = (vtk_to_numpy(arrays[name]) for name in FIELDS[:4])
    names, patch_names = ([texts.GetValue(i) for i in range(texts.GetNumberOfValues())]
                          for texts in (arrays[name] for name in FIELDS[4:]))
    return Bodies([
        _body(points, triangles[owners == b])._replace(
            name=name, patches=patches[owners == b].astype(np.int32), patch_names=patch_names)
        for b, name in enumerate(names)])
