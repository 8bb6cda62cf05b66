"""Finds the Cartesian grid that hexahedra or voxels form, in any order."""

from __future__ import annotations

from typing import Any, NamedTuple, Tuple

import numpy as np

from .._grid import AXES

ROUNDING = 1e-3  # of the smallest width: coordinates that are closer are equal
REMEDY = " Resample it onto an image, as with ParaView's filter Resample To Image."


class CartesianCells(NamedTuple):
    """Nodes of the grid along each axis, and the place of each hexahedron in it, x fastest."""

    nodes: Tuple[np.ndarray, ...]
    places: np.ndarray


def find_grid(corners: np.ndarray) -> CartesianCells:
    """Returns the grid. corners: of the hexahedra, shape (cells, 8, 3).

    Raises ValueError that names the first hexahedron that is not a cell of one grid.
    """
    if len(corners) == 0:
        raise ValueError("it has no hexahedra.")
    if not np.isfinite(corners).all():
        raise ValueError("a coordinate is not finite.")
    least, most = corners.min(axis=1), corners.max(axis=1)
    tolerance = _check_boxes(corners, least, most)
    nodes, index = [], np.empty(least.shape, np.int64)
    for a in range(3):
        x = _join(np.concatenate([least[:, a], most[:, a]]), tolerance[a])
        index[:, a] = np.searchsorted(x, least[:, a] + tolerance[a]) - 1
        above = np.searchsorted(x, most[:, a] + tolerance[a]) - 1
        _check(above == index[:, a] + 1, "extends over several layers of other hexahedra along "
               + AXES[a])
        nodes.append(x)
    cells = [len(x) - 1 for x in nodes]
    places = index[:, 0] + cells[0] * (index[:, 1] + cells[1] * index[:, 2])
    _check_places(places, cells)
    return CartesianCells(tuple(nodes), places)


def _check(is_right: np.ndarray, problem: Any) -> None:
    wrong = np.flatnonzero(~is_right)
    if len(wrong):
        raise ValueError("hexahedron %d %s. Its %d hexahedra must be the cells of a Cartesian "
                         "grid.%s" % (wrong[0], problem, len(is_right), REMEDY))


def _check_boxes(corners: np.ndarray, least: np.ndarray, most: np.ndarray) -> np.ndarray:
    """Checks that each hexahedron is a box along the axes, whatever the order of its corners.
    Returns the tolerance along each axis."""
    _check((most > least).all(axis=1), "is flat")
    tolerance = ROUNDING * (most - least).min(axis=0)
    is_upper = corners > 0.5 * (least + most)[:, None]
    ends = np.where(is_upper, most[:, None], least[:, None])
    _check((np.abs(corners - ends) <= tolerance).all(axis=(1, 2)), "is distorted or rotated")
    numbers = np.sort(is_upper @ np.array([1, 2, 4]), axis=1)
    _check((numbers == np.arange(8)).all(axis=1), "has two corners in one place")
    return tolerance


def _join(coordinates: np.ndarray, tolerance: float) -> np.ndarray:
    """Returns the coordinates in increasing order, one of each group of equal ones."""
    x = np.unique(coordinates)
    return x[np.concatenate([[True], np.diff(x) > tolerance])]


def _check_places(places: np.ndarray, cells: Any) -> None:
    """Checks that the hexahedra fill the box of the grid once."""
    total = cells[0] * cells[1] * cells[2]
    found, first = np.unique(places, return_index=True)
    if len(found) < len(places):
        is_first = np.zeros(len(places), bool)
        is_first[first] = True
        _check(is_first, "lies in the place of another one")
    if len(found) < total:
        gap = int(np.flatnonzero(found != np.arange(len(found)))[:1].sum()
                  if found[-1] != len(found) - 1 else len(found))
        i, rest = gap % cells[0], gap // cells[0]
        raise ValueError(
            "its %d hexahedra leave holes in the box of %d x %d x %d cells, the first at cell "
            "(%d, %d, %d): fill them with cells of material 0.%s"
            % (len(places), *cells, i, rest % cells[1], rest // cells[1], REMEDY))
