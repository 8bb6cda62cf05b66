"""Cohesive elements between both sides of split interfaces."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Dict, Tuple

import numpy as np

from . import _core
from ._data import MeshData
from ._tables import core_arrays, core_fields


@dataclass(eq=False)
class Cohesive:
    """Elements of zero thickness between two materials. Made by `Mesh.cohesive`.

    Attributes
    ----------
    cells : ndarray of int64, shape (k, 8) or (k, 6)
        Corners of hexahedra or wedges: indices of points. The first half are the nodes of the
        first material, counterclockwise seen from the second, then come those of the second.
    ids : ndarray of int64, shape (k,)
        Unique ids, above those of the elements of the mesh.
    materials : tuple of int
        First and second material.
    block : int
        Id of the block in files.

    Examples
    --------
    >>> left = np.ones((2, 2, 2)) * [[[1]], [[0]]]
    >>> mesh = vfm.hexes([left, 1 - left], split_interfaces="all", split_connection="cohesive")
    >>> elements, = mesh.cohesive().values()
    >>> elements.materials, len(elements)
    ((1, 2), 4)
    >>> first, second = np.split(mesh.points[elements.cells], 2, axis=1)
    >>> np.array_equal(first, second)
    True
    """

    cells: np.ndarray
    ids: np.ndarray
    materials: Tuple[int, int]
    block: int

    def __len__(self) -> int:
        return len(self.ids)


def cohesive(mesh: MeshData) -> Dict[str, Cohesive]:
    """Implements Mesh.cohesive."""
    blocks = _core.cohesive_blocks(*core_arrays(mesh), core_fields(mesh.fields))
    return {name: Cohesive(cells, ids, materials, block)
            for block, name, materials, cells, ids in blocks}
