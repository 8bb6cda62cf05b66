"""Writes a mesh to a file, in the format of its ending."""

from __future__ import annotations

import os
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any, Dict, List, Mapping, Optional, Tuple

import numpy as np

from . import _core
from ._pyvista import cell_arrays, point_arrays

if TYPE_CHECKING:
    from .mesh import Mesh

OWN = (".vtu", ".e", ".ex2", ".exo", ".inp")  # formats that the package itself writes


def save(mesh: Mesh, path: Any, **options: Any) -> None:
    """Implements Mesh.save."""
    path = os.fspath(path)
    suffix = os.path.splitext(path)[1].lower()
    if not suffix:
        raise ValueError(
            "%r has no ending to select the format: give .vtu, .e, .inp, .msh or another." % path
        )
    if suffix in OWN:
        _save_own(mesh, path, **options)
    elif suffix == ".vtk" and find_spec("pyvista"):
        mesh.to_pyvista().save(path, **options)
    elif suffix == ".vtp":
        mesh.to_pyvista("surfaces").save(path, **options)
    elif find_spec("meshio"):
        _save_by_meshio(mesh, path, suffix, **options)
    else:
        raise ImportError("Writing %s requires meshio: pip install meshio" % path)


def _save_own(mesh: Mesh, path: str, time: Optional[float] = None) -> None:
    _core.write_mesh(path, **core_arrays(mesh), time=time)


def core_arrays(mesh: Mesh) -> Dict[str, Any]:
    """Returns the mesh as arguments of the writers of the core."""
    return {
        "points": np.ascontiguousarray(mesh.points, np.float64),
        "cells": np.ascontiguousarray(mesh.cells, np.int64),
        "point_arrays": _arrays(point_arrays(mesh)),
        "cell_arrays": _arrays(cell_arrays(mesh)),
        "fields": core_fields(mesh.fields),
    }


def core_fields(fields: Mapping[str, Any]) -> Dict[str, Any]:
    """Returns fields or columns in types that the core supports."""
    return {name: _field(values) for name, values in fields.items()}


def _arrays(arrays: Mapping[str, Any]) -> List[Tuple[str, np.ndarray]]:
    return [(name, np.ascontiguousarray(values)) for name, values in arrays.items()]


def _field(values: Any) -> Any:
    """Returns strings as a list, and numbers in a type that fields support."""
    array = np.asarray(values)
    if array.dtype.kind == "U":
        return array.tolist()
    kind = (np.float64 if array.dtype.kind == "f"
            else np.int32 if array.dtype == np.int32 else np.int64)
    return np.ascontiguousarray(np.atleast_1d(array), kind)


def _save_by_meshio(mesh: Mesh, path: str, suffix: str, **options: Any) -> None:
    import meshio

    from ._meshio import for_gmsh

    if suffix not in meshio.extension_to_filetypes:
        raise ValueError("%r: the ending %s is not supported." % (path, suffix))

    if suffix == ".msh":
        data = for_gmsh(mesh)
        options = {"file_format": "gmsh22", **options}
    else:
        data = mesh.to_meshio()
    meshio.write(path, data, **options)
