"""Input of two axes, and meshes of a plane: quadrilaterals and triangles."""

from __future__ import annotations

from typing import Any, Mapping, Tuple

import numpy as np

from ._data import MeshData


def is_plane(*inputs: Any) -> bool:
    """Returns whether the first input that is given is an array of two axes or a picture of one
    slice, or several of them."""
    given = next((value for value in inputs if value is not None), None)
    if hasattr(given, "is_picture"):
        return bool(given.is_picture)
    if isinstance(given, Mapping):
        given = list(given.values())
    if isinstance(given, (list, tuple)) and given:
        given = given[0]
    is_array = isinstance(given, np.ndarray)
    return given.ndim == 2 if is_array else bool(getattr(given, "is_picture", False))


def plane_axes(mesh: MeshData) -> Tuple[int, int]:
    """Returns the axes of the plane of a flat mesh. With the axis across it they are right-handed,
    so the corners of elements are counterclockwise."""
    axis = int(mesh.fields["FlatAxis"][0])
    return (axis + 1) % 3, (axis + 2) % 3


def areas(mesh: MeshData) -> np.ndarray:
    """Returns the area of each element."""
    corners = mesh.points[:, plane_axes(mesh)][mesh.cells]
    following = np.roll(corners, -1, axis=1)
    return 0.5 * (corners[..., 0] * following[..., 1]
                  - corners[..., 1] * following[..., 0]).sum(axis=1)


def edge_points(mesh: MeshData, elements: np.ndarray, sides: np.ndarray) -> np.ndarray:
    """Returns the ends of edges of elements: side s joins corner s and the next one."""
    cells = mesh.cells[elements]
    place = np.arange(len(elements))
    return np.column_stack([cells[place, sides], cells[place, (sides + 1) % cells.shape[1]]])


def neighbours(mesh: MeshData) -> np.ndarray:
    """Returns the element behind each side of each element, -1 at the boundary of the mesh."""
    count = mesh.cells.shape[1]
    ends = np.sort(np.stack([mesh.cells, np.roll(mesh.cells, -1, axis=1)], axis=2), axis=2)
    keys = ends[..., 0].ravel() * max(len(mesh.points), 1) + ends[..., 1].ravel()
    order = np.argsort(keys, kind="stable")
    same = np.flatnonzero(keys[order][1:] == keys[order][:-1])
    behind = np.full(keys.size, -1, np.int64)
    behind[order[same]] = order[same + 1] // count
    behind[order[same + 1]] = order[same] // count
    return behind.reshape(-1, count)
