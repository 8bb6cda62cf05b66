"""Defines the geometry of a mesh: its surfaces, curves and vertices."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Dict

import numpy as np


@dataclass(eq=False)
class Geometry:
    """Volume, surface, curve or vertex of each of the n points of a mesh.

    Attributes
    ----------
    dimension : ndarray of int32, shape (n,)
        3 inside a volume, 2 on a surface, 1 on a curve, 0 at a vertex.
    id : ndarray of int32, shape (n,)
        Number of that volume (fragment), surface, curve or vertex, from 1.

    Examples
    --------
    >>> mesh = vfm.hexes(vfm.shapes("box size=1,1,1", 12, bounds=[-1, 1] * 3))
    >>> np.unique(mesh.geometry.dimension)
    array([0, 1, 2, 3], dtype=int32)
    """

    dimension: np.ndarray
    id: np.ndarray


@dataclass(eq=False)
class Surfaces:
    """Facets of all surfaces: between materials, around the meshed volume, on the domain boundary.

    Attributes
    ----------
    cells : ndarray of int64, shape (facets, 4) or (facets, 3)
        Corners of quadrilaterals (hexahedral mesh) or triangles: indices of points of the mesh.
        The normal points from the second material of the pair to the first.
    surface_id : ndarray of int32, shape (facets,)
        Number of the surface, from 1.
    material_pair : ndarray of int32, shape (facets, 2)
        The two materials, the smaller number first; 0 is void or outside.
    domain_side : ndarray of int32, shape (facets,)
        -1 inside the domain, 0 to 5 on its side -x, +x, -y, +y, -z, +z.
    fields : dict
        Arrays with one row per surface:

        - ``SurfaceVolumes``: volumes on its two sides, in the order of its material pair; 0: void
          or outside.
        - ``SurfaceMaterials``, ``SurfaceSides``: its material pair and domain side.
        - ``SurfaceParts``: number of the smooth side of an interface with edges, from 1; 0
          without edges.
        - ``PatchNames``: its name in the surface of a body, or empty; only if there are any.
        - ``SurfaceAreas`` in length**2, ``SurfaceCentroids``, ``SurfaceNormals``: the mean normal
          has length 1 on a plane.

        ``VolumeSurfaces`` has a row per pair of a volume and a surface around it.

    Examples
    --------
    >>> mesh = vfm.hexes(vfm.shapes("box size=1,1,1", 12, bounds=[-1, 1] * 3))
    >>> mesh.surfaces.fields["SurfaceAreas"].round(2)
    array([1., 1., 1., 1., 1., 1.])
    """

    cells: np.ndarray
    surface_id: np.ndarray
    material_pair: np.ndarray
    domain_side: np.ndarray
    fields: Dict[str, Any] = field(default_factory=dict)


@dataclass(eq=False)
class Curves:
    """Edges of all curves: edges on which the same surfaces meet are one curve.

    Attributes
    ----------
    cells : ndarray of int64, shape (edges, 2)
        Ends of each edge: indices of points of the mesh. The edges of a curve are consecutive.
    curve_id : ndarray of int32, shape (edges,)
        Number of the curve, from 1.
    fields : dict
        ``CurveEnds``: number of ends at vertices per curve, 0 for a closed curve. ``SurfaceCurves``
        has a row per pair of a surface and a curve on it.

    Examples
    --------
    >>> mesh = vfm.hexes(vfm.shapes("box size=1,1,1", 12, bounds=[-1, 1] * 3))
    >>> int(mesh.curves.curve_id.max())
    12
    """

    cells: np.ndarray
    curve_id: np.ndarray
    fields: Dict[str, Any] = field(default_factory=dict)


@dataclass(eq=False)
class Vertices:
    """Points where curves meet or end, or where surfaces touch.

    Attributes
    ----------
    points : ndarray of int64, shape (vertices,)
        Indices of points of the mesh.
    vertex_id : ndarray of int32, shape (vertices,)
        Number of the vertex, from 1.
    fields : dict
        ``CurveVertices`` has a row per pair of a curve and a vertex at its end.

    Examples
    --------
    >>> mesh = vfm.hexes(vfm.shapes("box size=1,1,1", 12, bounds=[-1, 1] * 3))
    >>> mesh.points[mesh.vertices.points[:2]].round(2)
    array([[-0.5, -0.5, -0.5],
           [ 0.5, -0.5, -0.5]])
    """

    points: np.ndarray
    vertex_id: np.ndarray
    fields: Dict[str, Any] = field(default_factory=dict)
