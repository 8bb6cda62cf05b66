"""Reads images that define their grid: PyVista and VTK, nibabel, SimpleITK, and Fractions.

An image is read with the package that made it; no other package is imported.
"""

from __future__ import annotations

from typing import Any, Dict, List, Mapping, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from ._arrays import as_numbers, check_3d, flatten
from ._grid import AXES, Grid, even_nodes, point_nodes

GHOSTS = "vtkGhostType"


class Image(NamedTuple):
    """Grid and arrays of an image.

    arrays: shape (cells,) or (cells, components), x fastest. chosen: names of the arrays that hold
    materials. order: order of the axes of arrays that are given in addition to the image.
    """

    grid: Grid
    arrays: Dict[str, np.ndarray]
    chosen: List[str]
    order: str


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

    Attributes
    ----------
    coordinates : tuple of 3 ndarrays
        The parameter `coordinates`.
    order : {"xyz", "zyx"}
        The parameter `order`.

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
                 order: str):
        super().__init__(arrays)
        self.coordinates = tuple(coordinates)
        self.order = order

    def __reduce__(self) -> Tuple[Any, ...]:
        return Fractions, (dict(self), self.coordinates, self.order)


def read_image(value: Any, names: Optional[Sequence[str]]) -> Optional[Image]:
    """Returns the image, or None if the value is not an image.

    names: arrays that hold materials; None: the default of the image.
    """
    if isinstance(value, Fractions):
        return _read_fractions(value, names)
    kinds = [kind.__module__.split(".")[0] + "." + kind.__name__ for kind in type(value).__mro__]
    if any(kind in ("vtkmodules.vtkImageData", "vtkmodules.vtkRectilinearGrid") for kind in kinds):
        return _read_vtk(value, names)
    reader = (_read_nibabel if "nibabel.SpatialImage" in kinds
              else _read_sitk if "SimpleITK.Image" in kinds else None)
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


def _read_fractions(value: Fractions, names: Optional[Sequence[str]]) -> Image:
    nodes = tuple(np.asarray(x, dtype=np.float64) for x in value.coordinates)
    grid = Grid(nodes, origin=tuple(x[0] for x in nodes))
    arrays = {}
    for name, array in value.items():
        check_3d(array, name)
        arrays[name] = flatten(array, value.order)
    return Image(grid, arrays, list(value) if names is None else check_names(names), value.order)


def _read_vtk(image: Any, names: Optional[Sequence[str]]) -> Image:
    """Returns the cell arrays, or the point arrays if the chosen arrays are point arrays."""
    is_image = hasattr(image, "GetSpacing")
    chosen = [_active_name(image)] if names is None else check_names(names)
    cells, points = image.GetCellData(), image.GetPointData()
    are_points = (not all(cells.HasArray(name) for name in chosen)
                  and all(points.HasArray(name) for name in chosen))
    if are_points and not is_image:
        raise ValueError(
            "The input is a %s, and point data are chosen. Only in images are points the centres "
            "of cells; other grids need cell data." % type(image).__name__
        )
    arrays = _vtk_arrays(points if are_points else cells)
    if GHOSTS in arrays and arrays[GHOSTS].any():
        raise ValueError(
            "The image has ghost or blanked cells (%s): give arrays without ghosts, and 0 where "
            "cells are blanked." % GHOSTS
        )
    return Image(_image_grid(image, are_points) if is_image else _rectilinear_grid(image), arrays,
                 chosen, "zyx")


def _active_name(image: Any) -> str:
    """Returns the name of the active array, or of the only array."""
    for data in (image.GetCellData(), image.GetPointData()):
        if data.GetScalars() is not None and data.GetScalars().GetName():
            return data.GetScalars().GetName()
    names = [
        data.GetArrayName(i)
        for data in (image.GetCellData(), image.GetPointData())
        for i in range(data.GetNumberOfArrays())
    ]
    if len(names) != 1:
        raise ValueError(
            "The image has no active scalars: name the arrays that hold materials, arrays=[...]. "
            "It has %s." % (", ".join(map(repr, names)) or "none")
        )
    return names[0]


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
            raise ValueError("The image is flat: it has no cells along %s." % AXES[a])
    matrix = image.GetDirectionMatrix()
    direction = np.array([[matrix.GetElement(r, c) for c in range(3)] for r in range(3)])
    return Grid(tuple(nodes), direction, tuple(origin), are_points)


def _rectilinear_grid(grid: Any) -> Grid:
    from vtkmodules.util.numpy_support import vtk_to_numpy

    arrays = (grid.GetXCoordinates(), grid.GetYCoordinates(), grid.GetZCoordinates())
    nodes = tuple(np.array(vtk_to_numpy(array), dtype=np.float64) for array in arrays)
    return Grid(nodes, origin=tuple(x[0] for x in nodes))


def _components(array: np.ndarray, name: str) -> Dict[str, np.ndarray]:
    """Splits an array of shape (cells, components) into one array per component."""
    if array.ndim == 1:
        return {name: array}
    if array.shape[1] == 1:
        return {name: array[:, 0]}
    return {"%s %d" % (name, i + 1): np.ascontiguousarray(array[:, i])
            for i in range(array.shape[1])}


def _read_nibabel(image: Any) -> Image:
    """Reads an image in the space of its affine (millimetres, RAS). The volumes along a fourth axis
    are materials."""
    affine = np.asarray(image.affine, dtype=np.float64)
    spacing = np.sqrt((affine[:3, :3] ** 2).sum(axis=0))
    values = as_numbers(image.dataobj, "image")
    if values.ndim == 4:
        volumes = [flatten(values[..., v], "xyz") for v in range(values.shape[3])]
    else:
        check_3d(values, "image")
        volumes = [flatten(values, "xyz")]
    if not volumes or values.size == 0 or not (spacing > 0).all():
        raise ValueError(
            "The image has the shape %r and voxels of %r: it contains no cells."
            % (values.shape, tuple(spacing.tolist()))
        )
    many = len(volumes) > 1
    arrays = {"Material %d" % (v + 1) if many else "Material 1": volume
              for v, volume in enumerate(volumes)}
    nodes = point_nodes(affine[:3, 3], spacing, values.shape)
    return Image(
        Grid(nodes, affine[:3, :3] / spacing, tuple(affine[:3, 3].tolist()), True), arrays,
        list(arrays), "xyz"
    )


def _read_sitk(image: Any) -> Image:
    """Reads an image in the space of ITK (millimetres, LPS). The components of pixels are
    materials."""
    from SimpleITK import GetArrayViewFromImage

    if image.GetDimension() != 3:
        raise ValueError("The image has %d axes: three are required." % image.GetDimension())
    values = as_numbers(GetArrayViewFromImage(image), "image")
    if values.size == 0:
        raise ValueError("The image has the shape %r: it contains no cells."
                         % (image.GetSize(),))
    arrays = _components(flatten(values, "zyx"), "Material")
    if len(arrays) == 1:
        arrays = {"Material 1": next(iter(arrays.values()))}
    nodes = point_nodes(image.GetOrigin(), image.GetSpacing(), image.GetSize())
    direction = np.reshape(image.GetDirection(), (3, 3))
    return Image(Grid(nodes, direction, tuple(image.GetOrigin()), True), arrays, list(arrays),
                 "zyx")
