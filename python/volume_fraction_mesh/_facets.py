"""Finds neighbours of elements and named sets of faces, and separates materials."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Dict, Union

import numpy as np

from . import _core, _flat
from ._data import MeshData
from ._tables import core_arrays, core_fields, core_mesh, material_names


@dataclass(eq=False)
class Facets:
    """Faces of elements, such as a side of the domain or one side of an interface.

    Attributes
    ----------
    points : ndarray of int64, shape (k, 4) or (k, 3)
        Corners of the faces: indices of points, counterclockwise seen from outside the element.
        So the normal points out of the element.
    elements : ndarray of int64, shape (k,)
        Element of each face, ascending.
    sides : ndarray of int32, shape (k,)
        Side of the element, from 0, in the numbering of ``vtkHexahedron`` or ``vtkTetra``.

    Examples
    --------
    >>> mesh = vfm.hexes(vfm.shapes("sphere radius=0.7", 12, bounds=[-1, 1] * 3))
    >>> facets = mesh.facets("Material1_to_Void")
    >>> facets.points.shape == (len(facets), 4)
    True
    """

    points: np.ndarray
    elements: np.ndarray
    sides: np.ndarray

    def __len__(self) -> int:
        return len(self.elements)


@dataclass(eq=False)
class Separated:
    """Mesh in which materials share no points, for contact. Made by `Mesh.separate`.

    Attributes
    ----------
    points : ndarray of float64, shape (k, 3)
        Coordinates. The points of a material are consecutive; materials follow by id.
    cells : ndarray of int64, shape (m, 8) or (m, 4)
        Corners of the elements, which are in the order of the mesh: indices of `points`.
    original : ndarray of int64, shape (k,)
        Index of each point in ``mesh.points``.
    material : ndarray of int32, shape (k,)
        Material of each point.

    Examples
    --------
    >>> text = "sphere radius=0.5; halfspace point=0,0,0 normal=0,0,1 material=2"
    >>> mesh = vfm.hexes(vfm.shapes(text, 12, bounds=[-1, 1] * 3))
    >>> parts = mesh.separate()
    >>> len(parts.points) > len(mesh.points)
    True
    >>> np.array_equal(parts.points, mesh.points[parts.original])
    True
    """

    points: np.ndarray
    cells: np.ndarray
    original: np.ndarray
    material: np.ndarray

    def corners(self, facets: Facets) -> np.ndarray:
        """Return the corners of facets of the mesh as indices of the separated points.

        Parameters
        ----------
        facets : Facets
            Result of `Mesh.facets`, `Mesh.facet_sets` or `Mesh.skin`.

        Returns
        -------
        ndarray of int64, shape (k, 4) or (k, 3)
            Points of the material that the facets belong to.

        Examples
        --------
        >>> text = "sphere radius=0.5; halfspace point=0,0,0 normal=0,0,1 material=2"
        >>> mesh = vfm.hexes(vfm.shapes(text, 12, bounds=[-1, 1] * 3))
        >>> parts = mesh.separate()
        >>> one = parts.corners(mesh.facets("Material1_to_Material2"))
        >>> other = parts.corners(mesh.facets("Material2_to_Material1"))
        >>> bool(np.isin(one, other).any())
        False
        """
        return _core.face_points(self.cells, facets.elements, facets.sides)


def neighbours(mesh: MeshData) -> np.ndarray:
    """Implements Mesh.neighbours."""
    return _flat.neighbours(mesh) if mesh.is_flat else _core.neighbours(*core_mesh(mesh))


def facet_sets(mesh: MeshData) -> Dict[str, Facets]:
    """Implements Mesh.facet_sets."""
    sets = _core.side_sets(*core_arrays(mesh), core_fields(mesh.fields))
    return {name: _facets(mesh, elements, sides) for _, name, elements, sides in sets}


def facets(mesh: MeshData, name: str) -> Facets:
    """Implements Mesh.facets."""
    sets = facet_sets(mesh)
    if name not in sets:
        raise ValueError("The mesh has no facets %r. Their names: %s."
                         % (name, ", ".join(sets) or "none"))
    return sets[name]


def skin(mesh: MeshData, material: Union[int, str]) -> Facets:
    """Implements Mesh.skin."""
    label = material_id(mesh, material)
    behind = neighbours(mesh)
    other = np.where(behind < 0, label - 1, mesh.material[behind])
    elements, sides = np.nonzero((mesh.material == label)[:, None] & (other != label))
    return _facets(mesh, elements, sides)


def separate(mesh: MeshData) -> Separated:
    """Implements Mesh.separate."""
    ids, place = np.unique(mesh.material, return_inverse=True)
    keys = place.reshape(-1, 1) * len(mesh.points) + mesh.cells
    used, cells = np.unique(keys, return_inverse=True)
    materials, original = np.divmod(used, max(len(mesh.points), 1))
    cells = np.ascontiguousarray(cells.reshape(mesh.cells.shape), np.int64)
    return Separated(mesh.points[original], cells, original, ids[materials])


def _facets(mesh: MeshData, elements: Any, sides: Any) -> Facets:
    elements, sides = elements.astype(np.int64), sides.astype(np.int32)
    if mesh.is_flat:
        return Facets(_flat.edge_points(mesh, elements, sides), elements, sides)
    return Facets(_core.face_points(core_mesh(mesh)[1], elements, sides), elements, sides)


def material_id(mesh: MeshData, material: Union[int, str]) -> int:
    """Returns the id of a material by its id or name."""
    names = material_names(mesh)
    found = [i for i, name in names.items() if material == (name if isinstance(material, str)
                                                             else i)]
    if not found:
        raise ValueError("The mesh has no material %r. Its materials: %s." % (
            material, ", ".join("%d %r" % entry for entry in names.items()) or "none"))
    return found[0]
