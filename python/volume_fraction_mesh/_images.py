"""Images that know their grid: of PyVista and VTK, nibabel, SimpleITK, and Fractions of shapes.

No package is imported that did not make the image.
"""

from __future__ import annotations

from typing import Any, Dict, List, Mapping, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from ._arrays import as_numbers, check_3d, flatten
from ._grid import AXES, Grid, even_nodes, point_nodes

GHOSTS = "vtkGhostType"


class Image(NamedTuple):
    """arrays: (cells,) or (cells, components), x fastest; chosen: those that hold materials; order:
    in which arrays beside it come."""

    grid: Grid
    arrays: Dict[str, np.ndarray]
    chosen: List[str]
    order: str


class Fractions(Dict[str, np.ndarray]):
    """Volume fractions on a grid, an array a material by its name. hexes() and tets() take the grid
    from it.

    Attributes
    ----------
    coordinates : tuple of three (n + 1,) float arrays
        The nodes of the grid along x, y and z, in the units of what was measured.
    order : {"xyz", "zyx"}
        The axes of the arrays.
    """

    def __init__(self, arrays: Mapping[str, np.ndarray], coordinates: Sequence[np.ndarray],
                 order: str):
        super().__init__(arrays)
        self.coordinates = tuple(coordinates)
        self.order = order

    def __reduce__(self) -> Tuple[Any, ...]:
        return Fractions, (dict(self), self.coordinates, self.order)


def read_image(value: Any, names: Optional[Sequence[str]]) -> Optional[Image]:
    """None of what is no image. names: of the arrays that hold materials, else those that the image
    itself tells."""
    if isinstance(value, Fractions):
        return _read_fractions(value, names)
    kinds = [kind.__module__.split(".")[0] + "." + kind.__name__ for kind in type(value).__mro__]
    if any(kind in ("vtkmodules.vtkImageData", "vtkmodules.vtkRectilinearGrid") for kind in kinds):
        return _read_vtk(value, names)
    reader = _read_nibabel if "nibabel.SpatialImage" in kinds else _read_sitk if "SimpleITK.Image" in kinds else None
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
    """Arrays of cells, or of points where the chosen ones are of points."""
    is_image = hasattr(image, "GetSpacing")
    chosen = [_active_name(image)] if names is None else check_names(names)
    cells, points = image.GetCellData(), image.GetPointData()
    are_points = not all(cells.HasArray(name)
                         for name in chosen) and all(points.HasArray(name) for name in chosen)
    if are_points and not is_image:
        raise ValueError(
            "The input is a %s, and point data are chosen. A point is the centre of a cell in images alone; of other "
            "grids cell data are needed." % type(image).__name__
        )
    arrays = _vtk_arrays(points if are_points else cells)
    if GHOSTS in arrays and arrays[GHOSTS].any():
        raise ValueError(
            "The image has ghost or blanked cells (%s): give arrays without ghosts, and 0 where cells are blanked."
            % GHOSTS
        )
    return Image(_image_grid(image, are_points) if is_image else _rectilinear_grid(image), arrays,
                 chosen, "zyx")


def _active_name(image: Any) -> str:
    """Of the array that is active, or the only one."""
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
            "The image has no active scalars: name the arrays that hold materials, arrays=[...]. It has %s."
            % (", ".join(map(repr, names)) or "none")
        )
    return names[0]


def _vtk_arrays(data: Any) -> Dict[str, np.ndarray]:
    """All that are numeric."""
    from vtkmodules.util.numpy_support import vtk_to_numpy

    arrays = {}
    for i in range(data.GetNumberOfArrays()):
        array = data.GetArray(i)  # None of texts
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
    """Of (cells, components): each an array of its own."""
    if array.ndim == 1:
        return {name: array}
    if array.shape[1] == 1:
        return {name: array[:, 0]}
    return {"%s %d" % (name, i + 1): np.ascontiguousarray(array[:, i])
            for i in range(array.shape[1])}


def _read_nibabel(image: Any) -> Image:
    """In the space of its affine (millimetres, RAS). The volumes of a fourth axis are materials."""
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
            "The image has the shape %r and voxels of %r: there are no cells in it."
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
    """In the space of ITK (millimetres, LPS). The components of pixels are materials."""
    from SimpleITK import GetArrayViewFromImage

    if image.GetDimension() != 3:
        raise ValueError("The image has %d axes: three are needed." % image.GetDimension())
    values = as_numbers(GetArrayViewFromImage(image), "image")
    if values.size == 0:
        raise ValueError("The image has the shape %r: there are no cells in it."
                         % (image.GetSize(),))
    arrays = _components(flatten(values, "zyx"), "Material")
    if len(arrays) == 1:
        arrays = {"Material 1": next(iter(arrays.values()))}
    nodes = point_nodes(image.GetOrigin(), image.GetSpacing(), image.GetSize())
    direction = np.reshape(image.GetDirection(), (3, 3))
    return Image(Grid(nodes, direction, tuple(image.GetOrigin()), True), arrays, list(arrays),
                 "zyx")
