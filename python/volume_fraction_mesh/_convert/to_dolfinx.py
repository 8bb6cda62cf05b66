"""Converts meshes to dolfinx."""

from __future__ import annotations

from inspect import signature
from typing import Any, Dict, NamedTuple, Optional, Tuple

import numpy as np

from .. import _core
from .._data import MeshData
from .._facets import neighbours
from .._flat import plane_axes
from .._tables import LINEAR, core_arrays, core_fields, material_names

# By kind of elements, in the numbering of dolfinx: the corner of VTK, and for each facet the side
# of VTK.
CORNERS = {"hexahedron": [0, 1, 3, 2, 4, 5, 7, 6], "tetra": [0, 1, 2, 3],
           "quad": [0, 1, 3, 2], "triangle": [0, 1, 2]}
SIDES = {"hexahedron": [4, 2, 0, 1, 3, 5], "tetra": [1, 2, 0, 3],
         "quad": [0, 3, 1, 2], "triangle": [1, 2, 0]}
CELLS = {"hexahedron": "hexahedron", "tetra": "tetrahedron", "quad": "quadrilateral",
         "triangle": "triangle"}
NO_TAG = np.iinfo(np.int32).min


class DolfinxMesh(NamedTuple):
    """Mesh of dolfinx with tags. Made by `Mesh.to_dolfinx`.

    Attributes
    ----------
    mesh : dolfinx.mesh.Mesh
        Mesh, distributed over the ranks, with ghosts of the cells behind shared facets.
    cell_tags : dolfinx.mesh.MeshTags
        Material of each cell.
    facet_tags : dolfinx.mesh.MeshTags
        Named surface of each facet on a side of the domain or an interface: the finest, so the
        facets of a smooth side have its number instead of that of the interface.
    materials, surfaces : dict of str to int
        Number of each name in `cell_tags` and in `facet_tags`.

    Examples
    --------
    >>> from mpi4py import MPI  # doctest: +SKIP
    >>> found = mesh.to_dolfinx(MPI.COMM_WORLD)  # doctest: +SKIP
    >>> found.facet_tags.find(found.surfaces["x_min"])  # doctest: +SKIP
    """

    mesh: Any
    cell_tags: Any
    facet_tags: Any
    materials: Dict[str, int]
    surfaces: Dict[str, int]


def convert(mesh: Optional[MeshData], comm: Any) -> DolfinxMesh:
    """Implements Mesh.to_dolfinx."""
    from dolfinx.mesh import meshtags

    is_first = comm.rank == 0
    table = comm.bcast(_list_tags(mesh) if is_first else None)
    if isinstance(table, Exception):
        raise table
    kind, materials, tags, names = table
    size = 2 if kind in ("quad", "triangle") else 3
    axes = plane_axes(mesh) if is_first and size == 2 else (0, 1, 2)
    points = (np.ascontiguousarray(mesh.points[:, axes], np.float64) if is_first
              else np.empty((0, size)))
    cells = (np.ascontiguousarray(mesh.cells[:, CORNERS[kind]], np.int64) if is_first
             else np.empty((0, len(CORNERS[kind])), np.int64))
    made = _create_mesh(comm, points, cells, CELLS[kind])
    original = np.asarray(made.topology.original_cell_index)
    cell_tags = meshtags(made, size, np.arange(len(original), dtype=np.int32), materials[original])
    facets, values = _tag_facets(made, tags[original][:, SIDES[kind]])
    return DolfinxMesh(made, cell_tags, meshtags(made, size - 1, facets, values), *names)


def _list_tags(mesh: Optional[MeshData]) -> Any:
    """Returns the kind of elements, the material of each element, the tag of each of its sides or
    NO_TAG, and the numbers of the names; or an exception, which all ranks raise."""
    if mesh is None or not len(mesh):
        return ValueError("Rank 0 has no mesh with elements to convert.")
    if mesh.mids is not None:
        return ValueError(LINEAR % "dolfinx")
    elements, sides, ids, surfaces = _core.tagged_faces(
        *core_arrays(mesh), core_fields(mesh.fields))
    behind = neighbours(mesh)
    tags = np.full(behind.shape, NO_TAG, np.int32)
    tags[elements, sides] = ids
    is_inside = behind[elements, sides] >= 0
    elements, ids = elements[is_inside], ids[is_inside]
    others = behind[elements, sides[is_inside]]
    tags[others, (behind[others] == elements[:, None]).argmax(axis=1)] = ids
    names = ({name: number for number, name in material_names(mesh).items()},
             {name: number for number, name in surfaces.items()})
    return mesh.kind, np.asarray(mesh.material, np.int32), tags, names


def _create_mesh(comm: Any, points: np.ndarray, cells: np.ndarray, cell: str) -> Any:
    """Creates a mesh with ghosts, by dolfinx 0.5 and later."""
    import ufl
    from dolfinx.mesh import GhostMode, create_cell_partitioner, create_mesh

    arguments = signature(create_mesh).parameters
    size = points.shape[1]
    if "ghost_mode" in arguments:  # 0.5
        element = ufl.VectorElement("Lagrange", ufl.Cell(cell, geometric_dimension=size), 1)
        return create_mesh(comm, cells, points, ufl.Mesh(element), GhostMode.shared_facet)
    if hasattr(ufl, "VectorElement"):  # 0.6
        element = ufl.VectorElement("Lagrange", ufl.Cell(cell, geometric_dimension=size), 1)
    else:
        import basix.ufl

        element = basix.ufl.element("Lagrange", cell, 1, shape=(size,))
    try:
        partitioner = create_cell_partitioner(GhostMode.shared_facet)
    except TypeError:  # 0.11: also the number of cells at a facet
        partitioner = create_cell_partitioner(GhostMode.shared_facet, 2)
    return create_mesh(comm, cells, x=points, partitioner=partitioner,
                       **{"domain" if "domain" in arguments else "e": ufl.Mesh(element)})


def _tag_facets(mesh: Any, tags: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """Returns the tagged facets of this rank, ascending, and their tags.

    tags: of each facet of each cell of this rank, or NO_TAG.
    """
    size = mesh.topology.dim
    mesh.topology.create_connectivity(size, size - 1)
    facets = np.asarray(mesh.topology.connectivity(size, size - 1).array).reshape(tags.shape)
    is_tagged = tags != NO_TAG
    found, place = np.unique(facets[is_tagged], return_index=True)
    return found.astype(np.int32), tags[is_tagged][place]
