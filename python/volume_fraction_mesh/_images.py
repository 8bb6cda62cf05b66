"""Reads images that define their grid: PyVista and VTK, nibabel, SimpleITK, Fractions and Arrays.

An image is read with the package that made it; no other package is imported.
"""

from __future__ import annotations

from typing import Any, Dict, List, Mapping, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from ._arrays import as_numbers, check_3d, flatten, shaped
from ._choice import has_materials
from ._core import Bodies
from ._grid import AXES, Grid, even_nodes, point_nodes
from ._readers.cartesian_cells import REMEDY, find_grid
from ._readers.label_names import find_caret_names, find_segments, join_segments, unique_names
from ._surfaces import bodies_of_fields

GHOSTS = "vtkGhostType"
VTK_CLASSES = ("vtkImageData", "vtkRectilinearGrid", "vtkStructuredGrid", "vtkUnstructuredGrid")
CELLS = {10: "tetrahedron", 13: "wedge", 14: "pyramid", 24: "tetrahedron of 10 nodes",
         25: "hexahedron of 20 nodes", 29: "hexahedron of 27 nodes", 42: "polyhedron"}
HEXAHEDRON, VOXEL, LAST_FLAT = 12, 11, 9  # types of cells of VTK; smaller ones are flat
CHOOSE_VOLUME = "Choose one volume: volume=N of read(), --volume N of vfmesh, from 0."


class Image(NamedTuple):
    """Grid and arrays of an image.

    arrays: shape (cells,) or (cells, components), x fastest. chosen: names of the arrays that hold
    materials; None: the core chooses them. order: order of the axes of arrays that are given in
    addition to the image. names: of labels, from the file. has_labels: bytes are labels, as in
    files of images, not fractions of 255. hint: what to do if the arrays cannot be used together.
    note: text of a warning if no spacing is given; warning: text of one that does not depend on it.
    surfaces: from which the fractions were computed. is_picture: one slice of a picture, which is
    meshed as a plane.
    """

    grid: Grid
    arrays: Dict[str, np.ndarray]
    chosen: Optional[List[str]]
    order: str
    names: Dict[int, str] = {}
    has_labels: bool = False
    hint: str = ""
    note: str = ""
    warning: str = ""
    surfaces: Optional[Bodies] = None
    is_picture: bool = False


class Fractions(Dict[str, np.ndarray]):
    """Volume fractions on a grid: a dict with one array per material, by its name.

    `shapes` and `surface` return it; `hexes` and `tets` accept it and use its grid.

    Parameters
    ----------
    arrays : dict of str to ndarray
        Volume fractions in [0, 1], shape (nx, ny, nz), or (nz, ny, nx) with `order` "zyx".
    coordinates : sequence of 3 arrays
        Nodes along x, y and z, shapes (nx + 1,), (ny + 1,) and (nz + 1,), increasing.
    order : {"xyz", "zyx"}
        Order of the axes of the arrays.
    surfaces : Bodies, optional
        Surfaces from which the fractions were computed, by the names of the arrays.

    Attributes
    ----------
    coordinates : tuple of 3 ndarrays
        The parameter `coordinates`.
    order : {"xyz", "zyx"}
        The parameter `order`.
    surfaces : Bodies or None
        The parameter `surfaces`.

    See Also
    --------
    shapes, surface : Make Fractions.

    Examples
    --------
    >>> ball = vfm.shapes("sphere radius=0.7", 12, bounds=[-1, 1] * 3)
    >>> {name: array.shape for name, array in ball.items()}
    {'Material1': (12, 12, 12)}
    >>> [float(x[0]) for x in ball.coordinates]
    [-1.0, -1.0, -1.0]
    >>> half = vfm.Fractions({"half": 0.5 * ball["Material1"]}, ball.coordinates, ball.order)
    >>> mesh = vfm.hexes(half, iso_value=0.25)
    """

    def __init__(self, arrays: Mapping[str, np.ndarray], coordinates: Sequence[np.ndarray],
                 order: str, surfaces: Optional[Bodies] = None):
        super().__init__(arrays)
        self.coordinates = tuple(coordinates)
        self.order = order
        self.surfaces = surfaces

    def __reduce__(self) -> Tuple[Any, ...]:
        return Fractions, (dict(self), self.coordinates, self.order, self.surfaces)

    def copy(self) -> Fractions:
        """Return a copy with the same arrays, grid and surfaces.

        Returns
        -------
        Fractions
            The arrays are not copied.

        Examples
        --------
        >>> ball = vfm.shapes("sphere radius=0.7", 12, bounds=[-1, 1] * 3)
        >>> other = ball.copy()
        >>> other["Material1"] is ball["Material1"], len(other.coordinates)
        (True, 3)
        """
        return Fractions(self, self.coordinates, self.order, self.surfaces)


class Arrays(Dict[str, np.ndarray]):
    """Arrays of a file on a grid of cells, by name: the result of `read`.

    `hexes` and `tets` accept it and use its grid. They choose the arrays of the materials by their
    contents, unless `arrays` names them.

    Attributes
    ----------
    path : str
        Path of the file or folder.
    coordinates : tuple of 3 ndarrays
        Nodes along x, y and z, shapes (nx + 1,), (ny + 1,) and (nz + 1,).
    direction : ndarray of shape (3, 3)
        Orthonormal matrix with the axes of the grid in its columns.
    order : {"xyz", "zyx"}
        Order of the axes of the arrays.
    names : dict of int to str
        Names of labels that the file contains.
    is_picture : bool
        Whether the file is one picture (PNG, TIFF, ..), which becomes a mesh of a plane, as with
        ``flat=True``. Set it to False for a layer of solid elements.

    See Also
    --------
    read : Makes Arrays.

    Examples
    --------
    >>> labels = np.zeros((6, 5, 4), np.uint8)
    >>> labels[1:5, 1:4, 1:3] = 7
    >>> np.save("labels.npy", labels)
    >>> arrays = vfm.read("labels.npy", spacing=0.5)
    >>> {name: array.shape for name, array in arrays.items()}
    {'Material 1': (6, 5, 4)}
    >>> [float(x[-1]) for x in arrays.coordinates]
    [3.0, 2.5, 2.0]
    """

    def __init__(self, image: Image, path: str):
        super().__init__((name, shaped(flat, image.grid.cells, image.order))
                         for name, flat in image.arrays.items())
        self.path = path
        self.coordinates = image.grid.nodes
        self.direction = image.grid.direction
        self.order = image.order
        self.names = dict(image.names)
        self.is_picture = image.is_picture
        self._image = image._replace(arrays={})

    def __reduce__(self) -> Tuple[Any, ...]:
        return Arrays, (_arrays_image(self, None), self.path)


def read_image(value: Any, names: Optional[Sequence[str]]) -> Optional[Image]:
    """Returns the image, or None if the value is not an image.

    names: arrays that hold materials; None: the default of the image.
    """
    if isinstance(value, Fractions):
        return _read_fractions(value, names)
    if isinstance(value, Arrays):
        return _arrays_image(value, names)
    kinds = [kind.__module__.split(".")[0] + "." + kind.__name__ for kind in type(value).__mro__]
    if any("vtkmodules." + name in kinds for name in VTK_CLASSES):
        return read_vtk(value, names)
    reader = (read_nibabel if "nibabel.SpatialImage" in kinds
              else read_sitk if "SimpleITK.Image" in kinds else None)
    if reader is None:
        return None
    if names is not None:
        raise ValueError("arrays is %r: a %s has no names of arrays."
                         % (names, type(value).__name__))
    return reader(value)


def check_names(names: Any) -> List[str]:
    if isinstance(names, str) or not all(isinstance(name, str) for name in names):
        raise TypeError("arrays is %r: it must be a list of names." % (names,))
    return list(names)


def _arrays_image(value: Arrays, names: Optional[Sequence[str]]) -> Image:
    return value._image._replace(
        arrays={name: flatten(array, value.order) for name, array in value.items()},
        chosen=value._image.chosen if names is None else check_names(names), names=value.names,
        is_picture=value.is_picture)


def _read_fractions(value: Fractions, names: Optional[Sequence[str]]) -> Image:
    nodes = tuple(np.asarray(x, dtype=np.float64) for x in value.coordinates)
    grid = Grid(nodes, origin=tuple(x[0] for x in nodes))
    arrays = {}
    for name, array in value.items():
        check_3d(array, name)
        arrays[name] = flatten(array, value.order)
    return Image(grid, arrays, list(value) if names is None else check_names(names), value.order,
                 surfaces=value.surfaces)


def read_vtk(data: Any, names: Optional[Sequence[str]], is_file: bool = False) -> Image:
    """Returns the cell arrays, or the point arrays if the chosen arrays are point arrays.

    names: arrays that hold materials; None: the active scalars, or the choice of the core, which is
    the default of files.
    """
    if not any(data.IsA(name) for name in VTK_CLASSES):
        raise ValueError("it holds a %s, which is not one of %s." % (
            data.GetClassName(), ", ".join(VTK_CLASSES)))
    chosen = _active_names(data) if names is None else check_names(names)
    if is_file and names is None:
        chosen = None
    is_image = hasattr(data, "GetSpacing")
    cells, points = data.GetCellData(), data.GetPointData()
    are_points = not _has_all(cells, chosen) and _has_all(points, chosen)
    if chosen is None and is_image and not are_points and _has_all(points, None):
        are_points = not has_materials(_vtk_arrays(cells))
    if are_points and not is_image:
        raise ValueError(
            "The input is a %s, and point data are chosen. Only in images are points the centres "
            "of cells; other grids need cell data: save an image (.vti, STRUCTURED_POINTS in "
            ".vtk), or data of cells." % type(data).__name__
        )
    arrays = _vtk_arrays(points if are_points else cells)
    if GHOSTS in arrays and arrays[GHOSTS].any():
        raise ValueError(
            "The image has ghost or blanked cells (%s): give arrays without ghosts, and 0 where "
            "cells are blanked." % GHOSTS
        )
    if is_image:
        grid = _image_grid(data, are_points)
    elif hasattr(data, "GetXCoordinates"):
        grid = _rectilinear_grid(data)
    else:
        grid, arrays = _join_cells(data, arrays)
    return Image(grid, arrays, None if is_file else chosen, "zyx", surfaces=bodies_of_fields(data))


def _has_all(data: Any, names: Optional[Sequence[str]]) -> bool:
    """Returns whether the data have the arrays, or any array without names."""
    if names is None:
        return data.GetNumberOfArrays() > 0
    return all(data.HasArray(name) for name in names)


def _active_names(data: Any) -> Optional[List[str]]:
    """Returns the name of the active array, if there is one."""
    for owner in (data.GetCellData(), data.GetPointData()):
        if owner.GetScalars() is not None and owner.GetScalars().GetName():
            return [owner.GetScalars().GetName()]
    if data.GetCellData().GetNumberOfArrays() + data.GetPointData().GetNumberOfArrays() == 0:
        raise ValueError("The %s has no arrays." % type(data).__name__)
    return None


def _vtk_arrays(data: Any) -> Dict[str, np.ndarray]:
    """Returns the numeric arrays by name."""
    from vtkmodules.util.numpy_support import vtk_to_numpy

    arrays = {}
    for i in range(data.GetNumberOfArrays()):
        array = data.GetArray(i)  # None for arrays of strings
        if array is not None and array.GetName():
            arrays[array.GetName()] = as_numbers(vtk_to_numpy(array), array.GetName())
    return arrays


def _image_grid(image: Any, are_points: bool) -> Grid:
    extent, origin, spacing = image.GetExtent(), image.GetOrigin(), image.GetSpacing()
    nodes = []
    for a in range(3):
        start = origin[a] - 0.5 * spacing[a] if are_points else origin[a]
        nodes.append(even_nodes(start, spacing[a], extent[2 * a], extent[2 * a + 1] + are_points))
        if len(nodes[a]) < 2:
            raise ValueError("The image is flat: it has no cells along %s. read() reads pictures "
                             "and slices as layers of cells." % AXES[a])
    matrix = image.GetDirectionMatrix()
    direction = np.array([[matrix.GetElement(r, c) for c in range(3)] for r in range(3)])
    return Grid(tuple(nodes), direction, tuple(origin), are_points)


def _rectilinear_grid(grid: Any) -> Grid:
    from vtkmodules.util.numpy_support import vtk_to_numpy

    arrays = (grid.GetXCoordinates(), grid.GetYCoordinates(), grid.GetZCoordinates())
    nodes = tuple(np.array(vtk_to_numpy(array), dtype=np.float64) for array in arrays)
    return Grid(nodes, origin=tuple(x[0] for x in nodes))


def _join_cells(data: Any, arrays: Dict[str, np.ndarray]) -> Tuple[Grid, Dict[str, np.ndarray]]:
    """Returns the Cartesian grid that hexahedra form, and their arrays in the order of the grid."""
    from vtkmodules.util.numpy_support import vtk_to_numpy

    if data.GetPoints() is None:
        raise ValueError("it has no points.")
    points = np.asarray(vtk_to_numpy(data.GetPoints().GetData()), np.float64)
    if hasattr(data, "GetDimensions"):
        extent = data.GetExtent()
        corners = _structured_hexahedra([extent[a + 1] - extent[a] + 1 for a in (0, 2, 4)])
        rows = np.arange(len(corners))
    else:
        rows, corners = _hexahedra(data)
    if corners.size and not 0 <= corners.min() <= corners.max() < len(points):
        raise ValueError("a cell has a point that does not exist.")
    found = find_grid(points[corners])
    ordered = {}
    for name, array in arrays.items():
        ordered[name] = np.empty((len(rows), *array.shape[1:]), array.dtype)
        ordered[name][found.places] = array[rows]
    return Grid(found.nodes, origin=tuple(x[0] for x in found.nodes)), ordered


def _hexahedra(data: Any) -> Tuple[np.ndarray, np.ndarray]:
    """Returns the numbers of the hexahedra and voxels of an unstructured grid, and their points,
    shape (n, 8). Flat cells are ignored, other cells are errors."""
    from vtkmodules.util.numpy_support import vtk_to_numpy

    if data.GetNumberOfCells() == 0:
        raise ValueError("it has no cells.")
    types = vtk_to_numpy(data.GetCellTypesArray())
    rows = np.flatnonzero(types > LAST_FLAT)
    other = rows[~np.isin(types[rows], (HEXAHEDRON, VOXEL))]
    if len(other):
        raise ValueError(
            "cell %d is a %s: the cells must be hexahedra or voxels that form a Cartesian grid.%s"
            % (other[0], CELLS.get(int(types[other[0]]), "cell of type %d of VTK"
                                   % types[other[0]]), REMEDY))
    starts = np.asarray(vtk_to_numpy(data.GetCells().GetOffsetsArray()))
    points = np.asarray(vtk_to_numpy(data.GetCells().GetConnectivityArray()))
    if len(starts) != len(types) + 1 or len(points) < starts[-1] or (
            np.diff(starts)[rows] != 8).any():
        raise ValueError("a hexahedron has not 8 points.")
    return rows, points[starts[:-1][rows, None] + np.arange(8)].astype(np.int64)


def _structured_hexahedra(dimensions: Sequence[int]) -> np.ndarray:
    """Returns the points of the cells of a structured grid, x fastest."""
    nx, ny, _ = dimensions
    k, j, i = np.meshgrid(*(np.arange(n - 1) for n in dimensions[::-1]), indexing="ij")
    first = (i + nx * (j + ny * k)).ravel()
    return first[:, None] + np.array([0, 1, nx, nx + 1, nx * ny, nx * ny + 1, nx * ny + nx,
                                      nx * ny + nx + 1])


def choose_volume(volumes: List[np.ndarray], volume: Optional[int]) -> Dict[str, np.ndarray]:
    """Returns the volumes, or only the selected one, as arrays "Material 1", "Material 2", .."""
    if volume is not None:
        if not 0 <= volume < len(volumes):
            raise ValueError("there is no volume %d: it has %d, counted from 0."
                             % (volume, len(volumes)))
        volumes = [volumes[volume]]
    return {"Material %d" % (v + 1): values for v, values in enumerate(volumes)}


def volume_hint(arrays: Mapping[str, np.ndarray]) -> str:
    """Returns how to choose one of several volumes."""
    return CHOOSE_VOLUME if len(arrays) > 1 else ""


def read_nibabel(image: Any, volume: Optional[int] = None) -> Image:
    """Reads an image in the space of its affine (millimetres, RAS). The volumes along a fourth axis
    are materials; volume: index of the only one that is read."""
    affine = np.asarray(image.affine, dtype=np.float64)
    spacing = np.sqrt((affine[:3, :3] ** 2).sum(axis=0))
    values = as_numbers(image.dataobj, "image")
    if values.ndim == 2:
        values = values[:, :, None]
    if values.ndim < 3:
        raise ValueError("The image has %d axes: three are required." % values.ndim)
    if values.size == 0 or not (spacing > 0).all() or not np.isfinite(affine).all():
        raise ValueError(
            "The image has the shape %r and voxels of %r: it contains no cells."
            % (values.shape, tuple(spacing.tolist()))
        )
    values = values.reshape(*values.shape[:3], -1, order="F")
    volumes = [flatten(values[..., v], "xyz") for v in range(values.shape[3])]
    arrays = choose_volume(volumes, volume)
    nodes = point_nodes(affine[:3, 3], spacing, values.shape[:3])
    names = find_caret_names(getattr(image.header, "extensions", []), volume or 0)
    return Image(
        Grid(nodes, affine[:3, :3] / spacing, tuple(affine[:3, 3].tolist()), True), arrays,
        list(arrays), "xyz", names, hint=volume_hint(arrays)
    )


def read_sitk(image: Any, volume: Optional[int] = None) -> Image:
    """Reads an image in the space of ITK (millimetres, LPS). The components of pixels, or the
    volumes along a fourth axis, are materials; volume: index of the only one that is read. Layers
    of segments of 3D Slicer become one array of labels."""
    from SimpleITK import GetArrayViewFromImage

    axes, components = image.GetDimension(), image.GetNumberOfComponentsPerPixel()
    values = as_numbers(GetArrayViewFromImage(image), "image")
    if values.size == 0:
        raise ValueError("The image has the shape %r: it contains no cells."
                         % (image.GetSize(),))
    values = values.reshape(*values.shape[:axes], components)
    if axes == 2:
        values = values[None]
    volumes = [flatten(values[(*lead, ..., c)], "zyx") for c in range(components)
               for lead in np.ndindex(*values.shape[:-4])]
    segments = find_segments({key: image.GetMetaData(key) for key in image.GetMetaDataKeys()})
    joined = None
    if segments and len(volumes) > 1 and volume is None:
        joined = join_segments(segments, volumes)
    arrays = choose_volume(volumes, volume) if joined is None else {"Material 1": joined}
    names = unique_names((number if joined is not None else segment.value, segment.name)
                         for number, segment in enumerate(segments, 1)
                         if joined is not None or segment.layer == (volume or 0))
    spacing, origin = list(image.GetSpacing())[:3], list(image.GetOrigin())[:3]
    direction = np.eye(3)
    turned = np.reshape(image.GetDirection(), (axes, axes))[:3, :3]
    direction[:len(turned), :len(turned)] = turned
    if axes == 2:
        spacing.append(spacing[0])
        origin.append(0.0)
    nodes = point_nodes(origin, spacing, values.shape[-2:-5:-1])
    return Image(Grid(nodes, direction, tuple(origin), True), arrays, list(arrays), "zyx", names,
                 hint=volume_hint(arrays))
