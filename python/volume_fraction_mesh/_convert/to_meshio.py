"""Converts meshes to meshio."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Dict, List

import numpy as np

from .._data import MeshData
from .._tables import material_names
from .to_pyvista import all_nodes, cell_arrays, point_arrays

if TYPE_CHECKING:
    import meshio


def convert(mesh: MeshData, blocks: bool) -> meshio.Mesh:
    """Implements Mesh.to_meshio."""
    import meshio

    parts = (
        [np.flatnonzero(mesh.material == i) for i in material_names(mesh)] if blocks
        else [np.arange(len(mesh.cells))]
    )
    parts = [part for part in parts if len(part)]
    data = {name: [array[part] for part in parts] for name, array in cell_arrays(mesh).items()}
    return meshio.Mesh(
        mesh.points,
        [(mesh.kind, all_nodes(mesh)[part]) for part in parts],
        point_data=point_arrays(mesh),
        cell_data=data,
        cell_sets=_sets(mesh, parts),
    )


def _sets(mesh: MeshData, parts: List[np.ndarray]) -> Dict[str, Any]:
    """Returns the cells of each material, in each block."""
    return {
        name: [np.flatnonzero(mesh.material[part] == i) for part in parts]
        for i, name in material_names(mesh).items()
    }
