"""Defines Mesh, the result of hexes() and tets()."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Dict, Literal, Optional, Sequence, TYPE_CHECKING, Tuple, Union

import numpy as np

from . import _core, _facets, _flat, _modify, _periodic, _report, _save, _split
from ._convert import plot, to_dolfinx, to_meshio, to_pyvista, to_skfem
from ._convert.to_dolfinx import DolfinxMesh
from ._data import MeshData
from ._facets import Facets, Separated
from ._split import Cohesive
from ._tables import core_fields, core_mesh

if TYPE_CHECKING:
    import meshio
    import pyvista
    import skfem


@dataclass(eq=False, repr=False)
class Mesh(MeshData):
    """Conforming mesh of all materials, made by `hexes` or `tets`.

    The mesh owns its arrays; the package keeps no reference to them. It has n points and m
    elements, and ``len(mesh)`` is m. Lengths are in the unit of the input.

    Attributes
    ----------
    points : ndarray of float64, shape (n, 3)
        Coordinates of the nodes.
    cells : ndarray of int64, shape (m, 8) or (m, 4)
        Corners of hexahedra or tetrahedra, in the order of VTK: indices of `points`.
    material : ndarray of int32, shape (m,)
        Number of the material in the order of the input, from 1, or its label. 0 is void.
    fragment : ndarray of int32, shape (m,)
        Number of the fragment, from 1: a set of elements of one material, connected over faces.
    point_ids, cell_ids : ndarray of int64, shapes (n,) and (m,)
        Unique ids from 1. They follow from the position in the grid and are not consecutive.
    partner : ndarray of int64, shape (n,), or None
        Lowest id among the copies of a point on opposite sides of a periodic mesh, or its own id.
        None without ``periodic``.
    quality : ndarray of float32, shape (m,), or None
        Scaled Jacobian as in Verdict: 1 for a cube or a regular tetrahedron, positive for a valid
        element. None without ``compute_quality``.
    geometry : Geometry
        Volume, surface, curve or vertex of each point.
    surfaces, curves, vertices : Surfaces, Curves, Vertices
        Geometry of the mesh.
    state : dict of str to ndarray
        State arrays of the elements, shape (m,) or (m, components).
    point_state : dict of str to ndarray
        State arrays of the points: the velocity, shape (n, 3), with ``nodal_velocity``.
    materials : dict
        Table with one entry per material in each column: ``Name`` (list of str), ``MaterialId``,
        ``TargetVolume`` (of the fractions), ``MeshVolume``, ``VolumeError`` (relative),
        ``LostCells`` and ``GainedCells`` (cells that changed their material to make interfaces
        manifold), ``Elements``, ``Fragments`` and the quality. Conserved state adds sums over cells
        and over elements, such as ``InputMass``, ``MeshMass``, ``UnmeshedMass``. `particles` add
        ``Particles``, their number, ``ParticleVolume`` and other sums.
    fields : dict
        Values for the whole mesh, such as ``MinimumScaledJacobian``, ``NumberOfFragments`` and
        ``FlippedCells`` (cells moved to another material to make interfaces manifold).
    roles : dict of str to str
        Names in `state` of the "density" (mass per volume of the material) and the "velocity".
    run : Run
        Input, options and warnings of the call that made the mesh.
    original_ids : ndarray of int64, shape (n,), or None
        Id of each point before interfaces were split. None without ``split_interfaces``.
    mids : ndarray of int64, shape (m, 12), (m, 19) or (m, 6), or None
        Mid nodes with ``element_order``, in the order of VTK: indices of `points`, or None.
    layer : ndarray of int32, shape (m,), or None
        Layer of each element along a surface, from 1; 0 for others. None without ``layers``.
    particles : dict of str to ndarray
        Material without elements, with ``unmeshed_material="particles"``; empty without. k
        particles have ``Position``, shape (k, 3), ``Id``, unique and ascending, ``Material``, as
        of elements, ``Radius`` of the sphere with the ``Volume``, with ``density`` the ``Mass``,
        and the state arrays, shape (k,) or (k, components). Sums over elements and particles are
        those of the input.

    See Also
    --------
    fragments : Table of the fragments of a mesh.

    Examples
    --------
    >>> mesh = vfm.hexes(vfm.shapes("sphere radius=0.7", 12, bounds=[-1, 1] * 3))
    >>> mesh.points.shape, mesh.cells.shape, len(mesh)
    ((799, 3), (616, 8), 616)
    >>> bool(mesh.quality.min() > 0)
    True
    """

    def __repr__(self) -> str:
        names = {"tetra": "tetrahedra", "hexahedron": "hexahedra", "quad": "quadrilaterals",
                 "triangle": "triangles"}
        text = "%d %s, %d points, %d materials, %d fragments" % (
            len(self.cells),
            names[self.kind.rstrip("0123456789")],
            len(self.points),
            len(self.materials.get("Name", ())),
            self.fragment.max(initial=0),
        )
        if self.particles:
            text += ", %d particles" % len(self.particles["Id"])
        if self.quality is not None and len(self.quality):
            text += ", scaled Jacobian %.3f to %.3f" % (self.quality.min(), self.quality.max())
        return "Mesh(%s)" % text

    def volumes(self) -> np.ndarray:
        """Compute the exact volume of each element.

        Returns
        -------
        ndarray of float64, shape (m,)
            Volumes, of a mesh of a plane areas. The faces of hexahedra are bilinear. Elements
            across joined sides of a periodic mesh have their volume.

        Examples
        --------
        >>> mesh = vfm.hexes(vfm.shapes("sphere radius=4 center=6,6,6", 12))
        >>> bool(np.isclose(mesh.volumes().sum(), mesh.materials["MeshVolume"][0]))
        True
        """
        if self.is_flat:
            return _flat.areas(self)
        joined = {} if self.partner is not None else core_fields(self.fields)
        return _core.element_volumes(*core_mesh(self), joined)

    def neighbours(self) -> np.ndarray:
        """Find the element behind each side of each element.

        Returns
        -------
        ndarray of int64, shape (m, 6) or (m, 4)
            Element behind each side, -1 at the boundary of the mesh. Sides have the numbering of
            ``vtkHexahedron``, -x, +x, -y, +y, -z, +z, or of ``vtkTetra``.

        Raises
        ------
        ValueError
            If a face belongs to more than two elements.

        Examples
        --------
        >>> mesh = vfm.hexes(np.ones((2, 1, 1)))
        >>> mesh.neighbours().tolist()
        [[-1, 1, -1, -1, -1, -1], [0, -1, -1, -1, -1, -1]]
        """
        return _facets.neighbours(self)

    def periodic_pairs(self) -> Tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Find the points that are copies of another point on an opposite side.

        Returns
        -------
        copies, partners : ndarray of int64, shape (k,)
            Points of each pair. The partner has the lowest id of all copies and is no copy itself,
            so each copy can be eliminated from a system of equations.
        periods : ndarray of int64, shape (k, 3)
            Number of periods along each axis of the input from the partner to the copy.

        Raises
        ------
        ValueError
            If the mesh is not periodic, or its sides are joined.

        Examples
        --------
        >>> mesh = vfm.hexes(np.ones((4, 4, 4)), periodic="x")
        >>> copies, partners, periods = mesh.periodic_pairs()
        >>> len(copies), periods[0].tolist()
        (25, [1, 0, 0])
        >>> np.array_equal(mesh.points[copies], mesh.points[partners] + [4, 0, 0])
        True
        """
        return _periodic.pairs(self)

    def facet_sets(self) -> Dict[str, Facets]:
        """Find the named sides of the mesh: the side sets of its Exodus and Abaqus files.

        Returns
        -------
        dict of str to Facets
            Faces by name:

            - ``x_min`` to ``z_max``: sides of the domain.
            - ``ball_to_plate``: faces of the material ball that touch the plate; ``plate_to_ball``
              are the same faces of the plate.
            - ``ball_to_Void``: the free surface of the ball.
            - ``ball_to_Void_3``: the part of it on surface 3, if edges divide it.

            Sets without faces are left out. Faces on the domain are in no set of two materials.

        See Also
        --------
        facets : One set.
        skin : All faces around a material.

        Examples
        --------
        >>> mesh = vfm.hexes({"ball": vfm.shapes("sphere radius=6", 12)["Material1"]})
        >>> list(mesh.facet_sets())
        ['x_min', 'y_min', 'z_min', 'ball_to_Void', 'ball_skin']
        """
        return _facets.facet_sets(self)

    def facets(self, name: str) -> Facets:
        """Return a named side of the mesh, such as "x_min" or "ball_to_plate".

        Parameters
        ----------
        name : str
            Name, as in `facet_sets`.

        Returns
        -------
        Facets
            Corners, elements and sides of the faces.

        Raises
        ------
        ValueError
            If the mesh has no such side; the message lists the names.

        Examples
        --------
        >>> mesh = vfm.hexes(np.ones((2, 2, 2)))
        >>> facets = mesh.facets("x_max")
        >>> facets.elements
        array([1, 3, 5, 7])
        >>> mesh.points[facets.points][..., 0].min()
        np.float64(2.0)
        """
        return _facets.facets(self, name)

    def skin(self, material: Union[int, str]) -> Facets:
        """Return all faces of a material to other materials, the void and the boundary.

        Parameters
        ----------
        material : int or str
            Number or name of the material.

        Returns
        -------
        Facets
            A closed surface. Its normals point out of the material.

        Raises
        ------
        ValueError
            If the mesh has no such material.

        Examples
        --------
        >>> mesh = vfm.hexes({"steel": np.ones((3, 3, 3))})
        >>> len(mesh.skin("steel")) == len(mesh.skin(1)) == 6 * 9
        True
        """
        return _facets.skin(self, material)

    def cohesive(self) -> Dict[str, Cohesive]:
        """Return the cohesive elements of split interfaces.

        Returns
        -------
        dict of str to Cohesive
            Elements by name, such as ``ball_to_plate_cohesive``. Empty unless the mesh was made
            with ``split_connection="cohesive"``.

        Examples
        --------
        >>> left = np.ones((2, 2, 2)) * [[[1]], [[0]]]
        >>> mesh = vfm.hexes([left, 1 - left], split_interfaces="all", split_connection="cohesive")
        >>> mesh.cohesive()["Material 1_to_Material 2_cohesive"].cells.shape
        (4, 8)
        """
        return _split.cohesive(self)

    def split(self, pairs: str = "all",
              connection: Literal["none", "cohesive", "contact", "tied"] = "none") -> Mesh:
        """Return the mesh with split interfaces, as `split_interfaces` of `hexes` and `tets` does.

        Parameters
        ----------
        pairs : str, default "all"
            Pairs of materials, such as "steel/copper, 1/3, 2/*".
        connection : {"none", "cohesive", "contact", "tied"}, default "none"
            Connection of both sides in files.

        Returns
        -------
        Mesh

        Examples
        --------
        >>> mesh = vfm.hexes(labels=np.ones((2, 2, 2), int) * [[[1]], [[2]]])
        >>> len(mesh.split().points) - len(mesh.points)
        9
        """
        return _modify.modify(self, split_interfaces=pairs, split_connection=connection)

    def cut_layers(self, layers: int, extensive: Sequence[str] = (), **options: Any) -> Mesh:
        """Return the mesh with layers along interfaces, as `layers` of `hexes` makes them.

        Parameters
        ----------
        layers : int
            Number of layers.
        extensive : sequence of str, optional
            Arrays in `state` that are sums over an element: layers share them by volume.
        **options
            ``layer_growth``, ``first_layer`` (a length), ``layer_interfaces``, ``layers_on``,
            ``layer_sides`` of `hexes`.

        Returns
        -------
        Mesh

        Examples
        --------
        >>> int(vfm.hexes(vfm.shapes("sphere radius=4 center=6,6,6", 12)).cut_layers(3).layer.max())
        3
        """
        return _modify.modify(self, extensive, layers=layers, first_layer_unit="length", **options)

    def bin_materials(self, array: str, count: int = 20, *, a: Optional[float] = None,
                      b: float = 1.0, poisson: float = 0.3, c0: float = 0.0, c1: float = 1.0,
                      materials: Union[int, str, Sequence[Union[int, str]]] = ()) -> Mesh:
        """Group the elements by grey values or densities, as materials of files of solvers.

        The range of the array is divided into `count` intervals of equal width. The elements of a
        material in an interval are a bin, such as ``bone_bin_03``: in files a block, part or
        element set with a material of its own. Materials, fragments and named sets stay.

        Parameters
        ----------
        array : str
            Array of `state`, one value per element.
        count : int, default 20
            Number of intervals. Bins without elements are left out.
        a, b : float
            Young's modulus is a * density**b. Without `a` files have no constants of bins.
        poisson : float, default 0.3
            Poisson's ratio.
        c0, c1 : float, default 0 and 1
            The density is c0 + c1 * value, of the mean value of the bin, weighted by volume.
        materials : int, str or sequence, optional
            Materials to divide, by id or name. Default: all but the void.

        Returns
        -------
        Mesh
            The mesh with ``BinId`` in `state`, and ``BinIds``, ``BinNames`` and so on in `fields`.

        Examples
        --------
        >>> density = np.linspace(0.2, 1.8, 8).reshape(8, 1, 1) * np.ones((8, 4, 4))
        >>> mesh = vfm.hexes({"bone": np.ones((8, 4, 4))}, state={"density": density})
        >>> binned = mesh.bin_materials("density", 4, a=6850, b=1.49)
        >>> binned.fields["BinNames"][0], binned.fields["BinModulus"].round().tolist()
        ('bone_bin_01', [1221.0, 4653.0, 9309.0, 14914.0])
        >>> binned.save("bone.inp")
        """
        return _modify.bin_materials(self, array, count, (a, b, poisson, c0, c1), materials)

    def separate(self) -> Separated:
        """Give each material its own points, so that materials can slide and part in contact.

        Returns
        -------
        Separated
            Points, cells in the order of the mesh, and the original number of each point.

        Examples
        --------
        >>> mesh = vfm.hexes(labels=np.ones((2, 2, 2), int) * [[[1]], [[2]]])
        >>> len(mesh.separate().points) - len(mesh.points)
        9
        """
        return _facets.separate(self)

    def to_skfem(self) -> skfem.Mesh:
        """Convert the mesh to scikit-fem.

        Returns
        -------
        skfem.MeshHex or skfem.MeshTet
            Mesh with the elements in the same order, a subdomain per material, and the boundaries
            of `facet_sets`. These have an orientation: normals point out of their elements.

        Raises
        ------
        ImportError
            If scikit-fem is not installed.

        Examples
        --------
        >>> mesh = vfm.hexes({"steel": np.ones((2, 2, 2))}).to_skfem()
        >>> list(mesh.subdomains), list(mesh.boundaries)[:2]
        (['steel'], ['x_min', 'x_max'])
        >>> mesh.p.shape, mesh.t.shape
        ((3, 27), (8, 8))
        """
        return to_skfem.convert(self)

    def to_dolfinx(self, comm: Any) -> DolfinxMesh:
        """Convert the mesh to dolfinx, with tags of materials and named surfaces.

        All ranks of `comm` call it. Rank 0 distributes its whole mesh; the meshes of other ranks
        are ignored. A rank without a mesh calls ``vfm.Mesh.to_dolfinx(None, comm)``.

        Parameters
        ----------
        comm : mpi4py.MPI.Comm
            Ranks that get a part of the mesh, such as ``MPI.COMM_WORLD``.

        Returns
        -------
        DolfinxMesh
            Named tuple of ``mesh``, ``cell_tags``, ``facet_tags``, and of the numbers by name:
            ``materials`` and ``surfaces``. Names of surfaces are those of `facet_sets`, but an
            interface has only one: that of the material with the lower id first. Each facet has
            the tag of its finest surface, so the tags contain neither "interfaces" nor skins.

        Raises
        ------
        ValueError
            If the mesh of rank 0 has no elements; on all ranks.
        ImportError
            If dolfinx is not installed. Tested with version 0.5 of Debian 12 only.

        Examples
        --------
        >>> from mpi4py import MPI  # doctest: +SKIP
        >>> mesh = vfm.hexes({"steel": np.ones((2, 2, 2))})
        >>> made, cells, facets, materials, surfaces = mesh.to_dolfinx(
        ...     MPI.COMM_WORLD)  # doctest: +SKIP
        >>> facets.find(surfaces["x_min"]).size  # doctest: +SKIP
        4
        """
        return to_dolfinx.convert(self, comm)

    def plot(self, array: str = "MaterialId", clip: Optional[str] = None, path: Any = None,
             **options: Any) -> None:
        """Plot the mesh by PyVista, in a window or into a picture.

        Parameters
        ----------
        array : str, default "MaterialId"
            Array of the elements or points for the colours, by its name in `to_pyvista`.
        clip : str, optional
            Normal of a plane through the centre, such as "x" or "-y". Elements behind it are
            shown, and none is cut.
        path : str or path-like, optional
            Picture to write, such as ``mesh.png``, without a window.
        **options
            Arguments of ``pyvista.Plotter.add_mesh``.

        Returns
        -------
        None

        Raises
        ------
        ValueError
            If the mesh has no such array.
        ImportError
            If PyVista is not installed.

        Examples
        --------
        >>> mesh = vfm.hexes(vfm.shapes("sphere radius=4 center=6,6,6", 12))
        >>> mesh.plot("ScaledJacobian", clip="x", path="ball.png")
        """
        plot.plot(self, array, clip, path, **options)

    def to_pyvista(self, part: str = "mesh") -> pyvista.DataSet:
        """Convert the mesh, a part of its geometry, or the particles to PyVista.

        Arrays and field data have the names that the ParaView filters use, such as ``MaterialId``.

        Parameters
        ----------
        part : {"mesh", "surfaces", "curves", "vertices", "particles"}, default "mesh"
            Part to convert.

        Returns
        -------
        pyvista.UnstructuredGrid or pyvista.PolyData
            The mesh is an UnstructuredGrid, any other part a PolyData.

        Raises
        ------
        ValueError
            If `part` is unknown.
        ImportError
            If PyVista is not installed.

        Examples
        --------
        >>> mesh = vfm.hexes(vfm.shapes("sphere radius=4 center=6,6,6", 12))
        >>> mesh.to_pyvista().n_cells == len(mesh)
        True
        >>> mesh.to_pyvista("surfaces").cell_data.keys()
        ['SurfaceId', 'MaterialPair', 'DomainSide']
        """
        return to_pyvista.convert(self, part)

    def to_meshio(self, blocks: bool = False) -> meshio.Mesh:
        """Convert the mesh with its arrays to meshio.

        Parameters
        ----------
        blocks : bool, default False
            True makes one block of cells per material, in the order of their ids. False makes one
            block of all elements.

        Returns
        -------
        meshio.Mesh
            Mesh with one cell set per material, named like it.

        Raises
        ------
        ImportError
            If meshio is not installed.

        Examples
        --------
        >>> mesh = vfm.hexes({"ball": vfm.shapes("sphere radius=4 center=6,6,6", 12)["Material1"]})
        >>> list(mesh.to_meshio().cell_sets)
        ['ball']
        """
        return to_meshio.convert(self, blocks)

    def save(self, path: Any, **options: Any) -> None:
        """Write the mesh to a file. The ending of its name selects the format.

        The package itself writes

        - ``.vtu`` (VTK): all arrays and field data;
        - ``.e``, ``.ex2``, ``.exo`` (Exodus): named blocks, side sets, node sets, ids, variables
          and particles;
        - ``.inp`` (Abaqus and CalculiX): sets of elements and nodes, surfaces; velocities of nodes
          as initial conditions; particles as point masses;
        - ``.k``, ``.key`` (LS-DYNA): parts, sets of nodes and segments, velocities, stresses,
          particles;
        - ``.rad`` (OpenRadioss): parts, groups of nodes, surfaces, velocities, state of elements,
          particles;
        - ``.bdf``, ``.nas`` (Nastran): properties, sets of nodes, a unit pressure on each surface,
          particles as point masses;
        - ``.feb`` (FEBio): version 4.0: elements of each material, sets of nodes, surfaces, element
          data;
        - ``.msh`` (Gmsh): version 2.2 or 4.1, text or binary: named volumes, domain sides and
          interfaces;
        - ``.xdmf`` (XDMF): for dolfinx: materials, and a second file of tagged facets,
          FILE_facets.xdmf;
        - ``.foam`` (OpenFOAM): the folder of the file is a case with patches, zones and a cloud of
          particles;
        - ``.stl`` (STL): only the closed surface of each material; with {} in the name one file per
          material, as in bones_{}.stl;
        - ``.obj`` (OBJ): the same surfaces, one group per material, with common vertices;
        - ``.data`` (LAMMPS): only the particles, as spheres with diameter, density and velocity;
        - ``.npz``: the whole mesh for `load`;
        - ``.vtk``: legacy format 4.2, with the array ``material`` first: the void has the number
          after the greatest.

        Files are equal byte for byte to those of the ParaView plugin and of ``sculptor``. PyVista
        writes ``.vtp`` with the surfaces, meshio other formats such as ``.med``. A file appears
        when it is complete.

        `particles` are in the same file, or, if the format has none, in NAME_particles.vtp beside
        it. A `VolumeFractionMeshWarning` then names this file.

        Parameters
        ----------
        path : str or path-like
            File to write.
        **options
            - ``.vtu``, Exodus, ``.inp``: ``time``, float, the time of the mesh.
            - ``.vtu``: ``texts=False`` leaves out texts such as the names of materials, because
              meshio (5.3.5) cannot read files with them.
            - ``.msh``: ``version``, "2.2" or "4.1", default 2.2, or 4.1 if an id exceeds
              2147483647; ``binary``, bool, default False; ``interfaces=False`` leaves out the
              faces between elements, for deal.II.
            - ``.inp``: ``reduced=True`` writes C3D20R instead of C3D20; with ``.k``, ``.bdf``: in a
              plane, ``plane``, "strain" (default) or "stress".
            - ``.foam``, ``.vtu``: ``polyhedra=True`` writes cells around the nodes of tetrahedra.
            - ``.foam``, ``.vtk``: ``binary=True`` instead of text. ``.npz``: ``compress=True``.
            - Other formats: arguments of ``pyvista.DataSet.save`` or ``meshio.write``.

        Raises
        ------
        ValueError
            If the ending is missing or unknown, or the format cannot hold the mesh. The message
            lists formats that can.
        ImportError
            If the format needs a package that is not installed.
        OSError
            If the file cannot be written; an incomplete file is removed.

        Examples
        --------
        >>> mesh = vfm.hexes(vfm.shapes("sphere radius=4 center=6,6,6", 12))
        >>> mesh.save("ball.e", time=0.5)
        >>> mesh.save("ball.inp")
        >>> mesh.save("ball.msh", version="4.1", binary=True)
        """
        _save.save(self, path, **options)

    def report(self, path: Any, title: str = "Mesh quality") -> None:
        """Write a quality report as one HTML page, which needs no network and no other file.

        The page contains counts, warnings, a table of `materials` with volumes and errors, a
        histogram of `quality` and, of tetrahedra, of dihedral angles, the ten worst elements with
        their centroids, the side sets of `save`, and the input and options of the run. ``sculptor
        --report`` writes the same page.

        Parameters
        ----------
        path : str or path-like
            File to write, ``.html`` or ``.htm``.
        title : str, default "Mesh quality"
            Title of the page.

        Raises
        ------
        ValueError
            If the ending is missing or unknown.
        OSError
            If the file cannot be written; an incomplete file is removed.

        See Also
        --------
        save : Write the mesh.

        Examples
        --------
        >>> mesh = vfm.hexes({"ball": vfm.shapes("sphere radius=4 center=6,6,6", 12)["Material1"]})
        >>> mesh.report("ball.html", title="Ball")
        >>> page = open("ball.html", encoding="utf-8").read()
        >>> "<title>Ball</title>" in page, "ball_to_Void" in page
        (True, True)
        """
        _report.report(self, path, title)
