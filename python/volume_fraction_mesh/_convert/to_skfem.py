"""Converts meshes to scikit-fem."""

from __future__ import annotations

from typing import Any

import numpy as np

from .._data import MeshData
from .._facets import Facets, facet_sets
from .._flat import plane_axes
from .._tables import material_names, require_linear

# Corners of VTK in the order of scikit-fem's MeshHex, whose last corner is the origin and whose
# corners 4, 5, 6 are next to it along x, y, z.
HEX_ORDER = [6, 2, 5, 7, 1, 3, 4, 0]


def convert(mesh: MeshData) -> Any:
    """Implements Mesh.to_skfem."""
    import skfem

    require_linear(mesh, "scikit-fem")
    if mesh.is_flat:
        return _with_names(mesh, (skfem.MeshQuad if mesh.kind == "quad" else skfem.MeshTri)(
            np.ascontiguousarray(mesh.points[:, plane_axes(mesh)].T),
            np.ascontiguousarray(mesh.cells.T)))
    is_tet = mesh.kind == "tetra"
    cells = mesh.cells if is_tet else mesh.cells[:, HEX_ORDER]
    result = (skfem.MeshTet if is_tet else skfem.MeshHex)(
        np.ascontiguousarray(mesh.points.T), np.ascontiguousarray(cells.T))
    return _with_names(mesh, result)


def _with_names(mesh: MeshData, result: Any) -> Any:
    """Returns the mesh of scikit-fem with names of materials and boundaries."""
    return result.with_subdomains({
        name: np.flatnonzero(mesh.material == i) for i, name in material_names(mesh).items()
    }).with_boundaries({
        name: _boundary(result, facets) for name, facets in facet_sets(mesh).items()
    })


def _boundary(mesh: Any, facets: Facets) -> Any:
    """Returns facets of scikit-fem with the side of their elements, so that normals point out."""
    from skfem.generic_utils import OrientedBoundary

    candidates = mesh.t2f[:, facets.elements]
    corners = np.sort(mesh.facets, axis=0)[:, candidates]
    place = (corners == np.sort(facets.points, axis=1).T[:, None]).all(axis=0).argmax(axis=0)
    found = candidates[place, np.arange(len(facets))]
    return OrientedBoundary(found, mesh.f2t[0, found] != facets.elements)
