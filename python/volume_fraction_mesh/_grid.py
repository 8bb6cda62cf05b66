"""Defines the grid of cells: coordinates of its nodes, and its position in space."""

from __future__ import annotations

from typing import Any, Iterable, NamedTuple, Sequence, Tuple, Union

import numpy as np

AXES = "xyz"
UNIT = (1.0, 1.0, 1.0)
NOWHERE = (0.0, 0.0, 0.0)


class Grid(NamedTuple):
    """Cartesian grid of cells, possibly rotated.

    nodes: coordinates along x, y and z, increasing. direction: orthonormal matrix (3, 3) with the
    axes of the grid in its columns. origin: centre of that rotation. are_points: whether the cells
    are the points of an image.
    """

    nodes: Tuple[np.ndarray, ...]
    direction: np.ndarray = np.eye(3)
    origin: Tuple[float, ...] = NOWHERE
    are_points: bool = False

    @property
    def cells(self) -> Tuple[int, ...]:
        """Numbers of cells along x, y and z."""
        return tuple(len(x) - 1 for x in self.nodes)

    def is_same(self, other: Grid) -> bool:
        """Returns whether two grids are equal up to rounding."""
        if self.cells != other.cells or not np.allclose(self.direction, other.direction, rtol=0,
                                                        atol=1e-5):
            return False
        widths = [(x[-1] - x[0]) / (len(x) - 1) for x in self.nodes]
        return all(np.abs(a - b).max() <= 1e-3 * width
                   for a, b, width in zip(self.nodes, other.nodes, widths))


def even_nodes(start: float, spacing: float, first: int, last: int) -> np.ndarray:
    """Returns the nodes first to last, where node 0 is at start. They are bitwise identical to the
    nodes in the ParaView filters."""
    return start + np.arange(first, last + 1) * spacing


def point_nodes(origin: Iterable[float], spacing: Iterable[float],
                counts: Sequence[int]) -> Tuple[np.ndarray, ...]:
    """Returns the nodes of cells whose centres are points, counts along each axis, from origin."""
    return tuple(even_nodes(o - 0.5 * s, s, 0, n) for o, s, n in zip(origin, spacing, counts))


def _numbers(name: str, value: Any, count: int) -> np.ndarray:
    text = "%s is %r" % (name, value.tolist() if isinstance(value, np.ndarray) else value)
    try:
        numbers = np.asarray(value, dtype=np.float64)
    except (TypeError, ValueError):
        raise TypeError("%s: %d numbers are required." % (text, count)) from None
    if numbers.size != count:
        raise ValueError("%s: %d numbers are required." % (text, count))
    if not np.isfinite(numbers).all():
        raise ValueError("%s: it must be finite." % text)
    return numbers.ravel()


def check_spacing(spacing: Union[float, Sequence[float]]) -> np.ndarray:
    """Returns the widths of cells along three axes; one number applies to all."""
    is_one = np.ndim(spacing) == 0 and not isinstance(spacing, str)
    numbers = _numbers("spacing", [spacing] * 3 if is_one else spacing, 3)
    if not (numbers > 0).all():
        raise ValueError("spacing is %r: widths of cells must be greater than 0." % (spacing,))
    return numbers


def _given_nodes(coordinates: Any, cells: Sequence[int]) -> Tuple[np.ndarray, ...]:
    try:
        nodes = tuple(np.asarray(x, dtype=np.float64) for x in coordinates)
    except (TypeError, ValueError):
        raise TypeError(
            "coordinates must be three arrays of numbers, the nodes along x, y and z.") from None
    if len(nodes) != 3:
        raise ValueError("coordinates has %d arrays: nodes along x, y and z are required."
                         % len(nodes))
    for axis, x, count in zip(AXES, nodes, cells):
        if x.shape != (count + 1,):
            raise ValueError(
                "coordinates along %s has the shape %r: %d cells have %d nodes."
                % (axis, x.shape, count, count + 1)
            )
        if not (np.isfinite(x).all() and (np.diff(x) > 0).all()):
            raise ValueError("coordinates along %s do not increase, or are not finite." % axis)
    return nodes


def _of_layer(cells: Sequence[int], origin: Any, spacing: Any,
              coordinates: Any) -> Tuple[Any, Any, Any]:
    """Returns origin, spacing and coordinates of a layer of cells along z: those with two entries,
    of x and y, get a third one. The layer is as thick as its cells are wide on average."""
    if cells[2] != 1:
        return origin, spacing, coordinates

    def has_two(value: Any) -> bool:
        return not isinstance(value, str) and hasattr(value, "__len__") and len(value) == 2

    if has_two(origin):
        origin = (*origin, 0.0)
    if has_two(spacing):
        widths = check_spacing((*spacing, 1.0))
        spacing = (widths[0], widths[1], 0.5 * (widths[0] + widths[1]))
    if has_two(coordinates):
        lengths = [np.ptp(np.asarray(x, dtype=np.float64)) for x in coordinates]
        width = 0.5 * (lengths[0] / cells[0] + lengths[1] / cells[1])
        coordinates = (*coordinates, np.array([0.0, width]))
    return origin, spacing, coordinates


def make_grid(cells: Sequence[int], spacing: Any, origin: Any, coordinates: Any,
              direction: Any) -> Grid:
    """Makes the grid from the arguments of hexes(). cells: numbers along x, y and z."""
    origin, spacing, coordinates = _of_layer(cells, origin, spacing, coordinates)
    corner = _numbers("origin", origin, 3)
    turned = np.eye(3) if direction is None else _numbers("direction", direction, 9).reshape(3, 3)
    if coordinates is None:
        widths = check_spacing(spacing)
        nodes = tuple(even_nodes(o, s, 0, n) for o, s, n in zip(corner, widths, cells))
    else:
        if not (is_default(spacing, UNIT) and is_default(origin, NOWHERE)):
            raise ValueError(
                "coordinates define the nodes: spacing and origin cannot be given too.")
        nodes = _given_nodes(coordinates, cells)
        corner = np.array([x[0] for x in nodes])
    return Grid(nodes, turned, tuple(corner.tolist()))


def is_default(value: Any, default: Sequence[float]) -> bool:
    """Returns whether a value is the default of the signature."""
    return np.array_equal(np.asarray(value, dtype=object), np.asarray(default, dtype=object))
