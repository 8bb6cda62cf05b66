"""Defines the data of a mesh, on which the functions of other modules work."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Dict, Optional

import numpy as np

from ._call import Run
from ._geometry import Curves, Geometry, Surfaces, Vertices


@dataclass(eq=False, repr=False)
class MeshData:
    """Arrays, tables and fields of a mesh. `Mesh` documents them."""

    points: np.ndarray
    cells: np.ndarray
    material: np.ndarray
    fragment: np.ndarray
    point_ids: np.ndarray
    cell_ids: np.ndarray
    partner: Optional[np.ndarray]
    quality: Optional[np.ndarray]
    geometry: Geometry
    surfaces: Surfaces
    curves: Curves
    vertices: Vertices
    state: Dict[str, np.ndarray]
    point_state: Dict[str, np.ndarray]
    materials: Dict[str, Any]
    fields: Dict[str, Any]
    roles: Dict[str, str] = field(default_factory=dict)
    run: Run = field(default_factory=Run)
    original_ids: Optional[np.ndarray] = None
    mids: Optional[np.ndarray] = None
    layer: Optional[np.ndarray] = None
    particles: Dict[str, np.ndarray] = field(default_factory=dict)

    @property
    def is_flat(self) -> bool:
        """Whether the mesh is one of a plane, made with the option `flat`.

        Examples
        --------
        >>> vfm.hexes(np.ones((3, 2))).is_flat
        True
        """
        return "FlatAxis" in self.fields

    @property
    def kind(self) -> str:
        """Type of the elements in meshio: "hexahedron" or "tetra", and with mid nodes
        "hexahedron20", "hexahedron27" or "tetra10"; in a plane "quad" or "triangle".

        Examples
        --------
        >>> vfm.tets(vfm.shapes("sphere radius=4 center=6,6,6", 12)).kind
        'tetra'
        """
        corners = self.cells.shape[1]
        if self.is_flat:
            return "quad" if corners == 4 else "triangle"
        name = "tetra" if corners == 4 else "hexahedron"
        return name if self.mids is None else "%s%d" % (name, corners + self.mids.shape[1])

    def __len__(self) -> int:
        return len(self.cells)
