"""Converts meshes to data sets of PyVista. Arrays have the names that the ParaView filters use."""

from __future__ import annotations

from typing import Any, Dict, Mapping

import numpy as np

from .._data import MeshData

PARTS = ("mesh", "surfaces", "curves", "vertices", "particles")
# Numbers of the cell types of VTK, by their names in meshio.
TYPES = {"hexahedron": 12, "tetra": 10, "hexahedron20": 25, "hexahedron27": 29, "tetra10": 24,
         "quad": 9, "triangle": 5}


def convert(mesh: MeshData, part: str) -> Any:
    """Implements Mesh.to_pyvista."""
    import pyvista

    if part not in PARTS:
        raise ValueError("part is %r: it must be one of %s." % (part, ", ".join(map(repr, PARTS))))
    if part == "mesh":
        return _volume(mesh, pyvista)
    if part == "surfaces":
        own = mesh.surfaces
        arrays = {"SurfaceId": own.surface_id, "MaterialPair": own.material_pair,
                  "DomainSide": own.domain_side}
        return _flat(mesh, own.cells, "faces", arrays, own.fields)
    if part == "curves":
        return _flat(mesh, mesh.curves.cells, "lines", {"CurveId": mesh.curves.curve_id},
                     mesh.curves.fields)
    if part == "particles":
        return _particles(mesh)
    return _flat(
        mesh, mesh.vertices.points[:, None], "verts", {"VertexId": mesh.vertices.vertex_id},
        mesh.vertices.fields
    )


def all_nodes(mesh: MeshData) -> np.ndarray:
    """Returns the corners and mid nodes of the elements, in the order of VTK."""
    return mesh.cells if mesh.mids is None else np.hstack([mesh.cells, mesh.mids])


def cell_arrays(mesh: MeshData) -> Dict[str, np.ndarray]:
    """Returns the arrays of the elements, by their names in the ParaView filters."""
    arrays = {"MaterialId": mesh.material, "FragmentId": mesh.fragment,
              "GlobalCellIds": mesh.cell_ids}
    if mesh.quality is not None:
        arrays["ScaledJacobian"] = mesh.quality
    if mesh.layer is not None:
        arrays["Layer"] = mesh.layer
    return {**arrays, **mesh.state}


def point_arrays(mesh: MeshData) -> Dict[str, np.ndarray]:
    """Returns the arrays of the points, by their names in the ParaView filters."""
    arrays = {"GlobalPointIds": mesh.point_ids, "GeometryDimension": mesh.geometry.dimension,
              "GeometryId": mesh.geometry.id}
    if mesh.partner is not None:
        arrays["PeriodicPartner"] = mesh.partner
    if mesh.original_ids is not None:
        arrays["OriginalPointIds"] = mesh.original_ids
    return {**arrays, **mesh.point_state}


def _volume(mesh: MeshData, pyvista: Any) -> Any:
    grid = pyvista.UnstructuredGrid({TYPES[mesh.kind]: all_nodes(mesh)}, mesh.points)
    for name, array in point_arrays(mesh).items():
        grid.point_data.set_array(array, name)
    for name, array in cell_arrays(mesh).items():
        grid.cell_data.set_array(array, name)
    grid.GetPointData().SetGlobalIds(grid.GetPointData().GetArray("GlobalPointIds"))
    grid.GetCellData().SetGlobalIds(grid.GetCellData().GetArray("GlobalCellIds"))
    _add_fields(grid, mesh.fields)
    grid.set_active_scalars("MaterialId", preference="cell")
    return grid


def _flat(mesh: MeshData, cells: np.ndarray, kind: str, arrays: Mapping[str, np.ndarray],
          fields: Mapping[str, Any]) -> Any:
    """Returns facets, edges or vertices as PolyData with only the points that they use."""
    import pyvista

    used, corners = np.unique(cells, return_inverse=True)
    corners = corners.reshape(cells.shape)
    padded = np.column_stack([np.full(len(cells), cells.shape[1]), corners])
    given: Dict[str, Any] = {kind: padded.ravel()} if len(cells) else {}
    data = pyvista.PolyData(mesh.points[used], **given)
    if len(cells):
        data.point_data.set_array(mesh.point_ids[used], "GlobalPointIds")
        data.GetPointData().SetGlobalIds(data.GetPointData().GetArray("GlobalPointIds"))
    for name, array in arrays.items():
        if len(array):
            data.cell_data.set_array(array, name)
    _add_fields(data, fields)
    return data


def _particles(mesh: MeshData) -> Any:
    import pyvista

    if not len(mesh.particles.get("Position", ())):
        return pyvista.PolyData()
    data = pyvista.PolyData(mesh.particles["Position"])  # a vertex at each point
    for name, array in mesh.particles.items():
        if name != "Position":
            data.point_data.set_array(array, name)
    _add_fields(data, {name: mesh.fields[name] for name in ("MaterialNames", "MaterialIds")})
    return data


def _add_fields(data: Any, fields: Mapping[str, Any]) -> None:
    for name, values in fields.items():
        if len(values):
            data.field_data.set_array(values, name)
