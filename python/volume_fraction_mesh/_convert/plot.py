"""Plots meshes by PyVista."""

from __future__ import annotations

import os
from typing import Any, Optional

from .._data import MeshData
from .._tables import material_names
from .to_pyvista import convert


def plot(mesh: MeshData, array: str, clip: Optional[str], path: Any, **options: Any) -> None:
    """Implements Mesh.plot."""
    import pyvista

    grid = convert(mesh, "mesh")
    names = [*grid.cell_data.keys(), *grid.point_data.keys()]
    if array not in names:
        raise ValueError("The mesh has no array %r. Its arrays: %s." % (array, ", ".join(names)))
    if clip is not None:
        grid = grid.clip(clip, crinkle=True)
    if array == "MaterialId":
        options = {"annotations": material_names(mesh), "cmap": "viridis", **options}
    plotter = pyvista.Plotter(off_screen=path is not None)
    plotter.add_mesh(grid, scalars=array, **{"show_edges": True, **options})
    plotter.show(screenshot=False if path is None else os.fspath(path))
