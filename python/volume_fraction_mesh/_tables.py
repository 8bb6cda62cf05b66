"""Prepares arrays and fields of a mesh for the core, and lists its materials."""

from __future__ import annotations

from typing import Any, Dict, List, Mapping, Tuple

import numpy as np

from ._data import MeshData
from ._convert.to_pyvista import all_nodes, cell_arrays, point_arrays

PARTICLES = {"Position": np.float64, "Id": np.int64, "Material": np.int32, "Radius": np.float64,
             "Volume": np.float64, "Mass": np.float64}
LINEAR = "A mesh with mid nodes is not converted to %s: element_order must be 'linear'."


def core_mesh(mesh: MeshData) -> Tuple[np.ndarray, np.ndarray]:
    """Returns the points and cells in the form of the core."""
    return (np.ascontiguousarray(mesh.points, np.float64),
            np.ascontiguousarray(mesh.cells, np.int64))


def list_arrays(arrays: Mapping[str, Any]) -> List[Tuple[str, np.ndarray]]:
    """Returns names and contiguous values."""
    return [(name, np.ascontiguousarray(values)) for name, values in arrays.items()]


def core_arrays(mesh: MeshData) -> Tuple[Any, ...]:
    """Returns points, cells and arrays as arguments of the core."""
    return (core_mesh(mesh)[0], np.ascontiguousarray(all_nodes(mesh), np.int64),
            list_arrays(point_arrays(mesh)), list_arrays(cell_arrays(mesh)))


def core_particles(mesh: MeshData) -> List[Tuple[str, np.ndarray]]:
    """Returns the arrays of the particles as an argument of the core."""
    return [(name, np.ascontiguousarray(values, PARTICLES.get(name)))
            for name, values in mesh.particles.items()]


def require_linear(mesh: MeshData, target: str) -> None:
    """Raises ValueError for a mesh of second order."""
    if mesh.mids is not None:
        raise ValueError(LINEAR % target)


def field_for_core(values: Any) -> Any:
    """Returns strings as a list, and numbers in a type that fields support."""
    array = np.asarray(values)
    if array.dtype.kind == "U":
        return array.tolist()
    kind = (np.float64 if array.dtype.kind == "f"
            else np.int32 if array.dtype == np.int32 else np.int64)
    return np.ascontiguousarray(np.atleast_1d(array), kind)


def core_fields(fields: Mapping[str, Any]) -> Dict[str, Any]:
    """Returns fields or columns in types that the core supports."""
    return {name: field_for_core(values) for name, values in fields.items()}


def material_names(mesh: MeshData) -> Dict[int, str]:
    """Returns the names of the materials by id."""
    return dict(zip((int(i) for i in mesh.materials["MaterialId"]), mesh.materials["Name"]))


def material_tags(mesh: MeshData) -> Dict[int, int]:
    """Returns the numbers of materials by id in formats that count from 1: the void, 0, gets the
    number after the greatest."""
    ids = list(material_names(mesh))
    return {i: i if i > 0 else max(ids) + 1 for i in ids}
