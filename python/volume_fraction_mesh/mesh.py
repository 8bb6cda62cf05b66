"""The mesh that hexes() and tets() make."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Dict, Mapping, Optional

import numpy as np

from . import _core

if TYPE_CHECKING:
    import meshio
    import pyvista


@dataclass(eq=False)
class Geometry:
    """What each point lies in.

    Attributes
    ----------
    dimension : (points,) int32
        3 inside a volume, 2 on a surface, 1 on a curve, 0 at a vertex.
    id : (points,) int32
        Which volume, surface, curve or vertex, from 1.
    """

    dimension: np.ndarray
    id: np.ndarray


@dataclass(eq=False)
class Surfaces:
    """The facets of all surfaces: between two materials, around what is meshed, on the sides of the
    domain.

    Attributes
    ----------
    cells : (facets, 4 or 3) int64
        Points of the mesh, quadrilaterals or triangles.
    surface_id : (facets,) int32
        From 1.
    material_pair : (facets, 2) int32
        The smaller first, 0 void or outside; the normal points from the second to the first.
    domain_side : (facets,) int32
        -1 inside, 0..5 on the side -x +x -y +y -z +z of the domain.
    fields : dict
        Of each surface its SurfaceVolumes, SurfaceMaterials, SurfaceSides, SurfaceParts,
        SurfaceAreas, SurfaceCentroids, SurfaceNormals, and the pairs VolumeSurfaces.
    """

    cells: np.ndarray
    surface_id: np.ndarray
    material_pair: np.ndarray
    domain_side: np.ndarray
    fields: Dict[str, Any] = field(default_factory=dict)


@dataclass(eq=False)
class Curves:
    """The edges of all curves, where the same surfaces meet.

    Attributes
    ----------
    cells : (edges, 2) int64
        Points of the mesh, in the order of their curves.
    curve_id : (edges,) int32
        From 1.
    fields : dict
        CurveEnds of each curve, and the pairs SurfaceCurves.
    """

    cells: np.ndarray
    curve_id: np.ndarray
    fields: Dict[str, Any] = field(default_factory=dict)


@dataclass(eq=False)
class Vertices:
    """The points where curves meet or end.

    Attributes
    ----------
    points : (vertices,) int64
        Points of the mesh.
    vertex_id : (vertices,) int32
        From 1.
    fields : dict
        The pairs CurveVertices.
    """

    points: np.ndarray
    vertex_id: np.ndarray
    fields: Dict[str, Any] = field(default_factory=dict)


@dataclass(eq=False, repr=False)
class Mesh:
    """A conforming mesh of every material. Lengths are in the units of the input.

    Attributes
    ----------
    points : (points, 3) float64
    cells : (elements, 8 or 4) int64
        Corners of hexahedra or tetrahedra in the order of VTK.
    material : (elements,) int32
        Number of the material as given, from 1, or the label; 0 void.
    fragment : (elements,) int32
        Piece of one material whose elements are connected over faces, from 1.
    point_ids, cell_ids : (points,), (elements,) int64
        Unique, made from the place in the grid, from 1, not consecutive.
    quality : (elements,) float32 or None
        Scaled Jacobian (verdict's): 1 of a cube or a regular tetrahedron, above 0 of a valid
        element.
    geometry : Geometry
    surfaces, curves, vertices : Surfaces, Curves, Vertices
    state : dict
        Arrays of the elements, (elements,) or (elements, components).
    point_state : dict
        Arrays of the points: the velocity of the nodes, if it was asked for.
    materials : dict
        A column a name, a row a material: Name, MaterialId, TargetVolume, MeshVolume, VolumeError,
        Elements, Fragments, ..; with conserved state its sums, InputMass, MeshMass, UnmeshedMass
        and so on.
    fields : dict
        What is told of the whole mesh: MinimumScaledJacobian, NumberOfFragments, FlippedCells, ..
    roles : dict
        Which arrays of state are the "density" (mass per volume of the material) and the
        "velocity", if any are.
    """

    points: np.ndarray
    cells: np.ndarray
    material: np.ndarray
    fragment: np.ndarray
    point_ids: np.ndarray
    cell_ids: np.ndarray
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

    @property
    def kind(self) -> str:
        """ "hexahedron" or "tetra", as meshio calls them."""
        return "tetra" if self.cells.shape[1] == 4 else "hexahedron"

    def __repr__(self) -> str:
        names = {"tetra": "tetrahedra", "hexahedron": "hexahedra"}
        text = "%d %s, %d points, %d materials, %d fragments" % (
            len(self.cells),
            names[self.kind],
            len(self.points),
            len(self.materials.get("Name", ())),
            self.fragment.max(initial=0),
        )
        if self.quality is not None and len(self.quality):
            text += ", scaled Jacobian %.3f to %.3f" % (self.quality.min(), self.quality.max())
        return "Mesh(%s)" % text

    def __len__(self) -> int:
        return len(self.cells)

    def volumes(self) -> np.ndarray:
        """The exact volume of each element, (elements,), in length units cubed."""
        points, cells = np.ascontiguousarray(self.points,
                                             np.float64), np.ascontiguousarray(self.cells, np.int64)
        return _core.element_volumes(points, cells)

    def to_pyvista(self, part: str = "mesh") -> pyvista.DataSet:
        """The mesh, or its "surfaces", "curves" or "vertices", with the arrays and field data of
        the filters of ParaView.

        Returns
        -------
        pyvista.UnstructuredGrid, of the other parts pyvista.PolyData
        """
        from ._pyvista import convert

        return convert(self, part)

    def to_meshio(self, blocks: bool = False) -> meshio.Mesh:
        """The mesh with its arrays.

        Parameters
        ----------
        blocks
            A block of cells a material, in the order of their ids, instead of one of all elements.
        """
        from ._meshio import convert

        return convert(self, blocks)

    def save(self, path: Any, **options: Any) -> None:
        """Write a file, whose kind its ending tells.

        The package itself writes .vtu (ParaView), .e, .ex2 and .exo (Exodus: blocks, side sets and
        node sets with names, global ids, variables) and .inp (Abaqus, CalculiX), as the plugin
        writes them; PyVista writes .vtk and .vtp (the surfaces); meshio writes all others: .msh
        (Gmsh), .xdmf, .med, ..

        Parameters
        ----------
        path : str or os.PathLike
        **options
            Of a file by the package itself: time, a float, the time of the mesh. Of others those of
            pyvista.DataSet.save or meshio.write.

        Raises
        ------
        OSError
            If the file cannot be written; then it is removed.
        """
        from ._save import save

        save(self, path, **options)


def make_mesh(result: Mapping[str, Any], roles: Dict[str, str]) -> Mesh:
    """Of what the core returns."""
    result = dict(result)
    surfaces, curves, vertices = result.pop("surfaces"), result.pop("curves"), result.pop(
        "vertices")
    nodal = result.pop("nodal_velocity")
    return Mesh(
        points=result["points"],
        cells=result["cells"],
        material=result["material"],
        fragment=result["fragment"],
        point_ids=result["point_ids"],
        cell_ids=result["cell_ids"],
        quality=result["scaled_jacobian"],
        geometry=Geometry(result["geometry_dimension"], result["geometry_id"]),
        surfaces=Surfaces(**surfaces, fields=result["surface_fields"]),
        curves=Curves(**curves, fields=result["curve_fields"]),
        vertices=Vertices(**vertices, fields=result["vertex_fields"]),
        state=result["state"],
        point_state=dict([nodal]) if nodal else {},
        materials=result["materials"],
        fields=result["fields"],
        roles=roles,
    )
