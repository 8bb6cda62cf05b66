"""Converts arrays of cells to the form of the core: flat, x fastest, numeric; without a copy if
possible."""

from __future__ import annotations

from typing import Any, Dict, List, Mapping, Optional, Sequence, Tuple

import numpy as np

ORDERS = ("xyz", "zyx")


def check_order(order: Any) -> str:
    """Returns the order if it is valid, otherwise raises an exception."""
    if isinstance(order, str) and order in ORDERS:
        return order
    raise (ValueError if isinstance(order, str) else TypeError)(
        "order is %r: it must be 'xyz' (array[i, j, k], i along x) or 'zyx' (array[k, j, i])."
        % (order,)
    )


def as_numbers(values: Any, name: str) -> np.ndarray:
    """Returns an array of a type that the core supports."""
    if isinstance(values, np.ma.MaskedArray) and np.ma.is_masked(values):
        raise ValueError("The array %r is masked: fill it first, as with array.filled(0)." % name)
    array = np.asarray(values)
    if array.dtype.kind not in "biuf" or array.dtype.itemsize > 8:
        raise TypeError(
            "The array %r is of the type %s: integers or floating-point numbers of up to 8 bytes "
            "are required."
            % (name, array.dtype)
        )
    if array.dtype == np.bool_:
        return array.view(np.uint8)
    if array.dtype == np.float16:
        return array.astype(np.float32)
    return array if array.dtype.isnative else array.astype(array.dtype.newbyteorder("="))


def as_fractions(values: Any, name: str) -> np.ndarray:
    """Returns fractions of a type that the core supports; bool as integers 0 and 1."""
    array = as_numbers(values, name)
    return array.view(np.int8) if np.asarray(values).dtype == np.bool_ else array


def check_3d(array: np.ndarray, name: str) -> None:
    """Raises an exception unless the array has three axes, or two, and at least one cell."""
    if array.ndim not in (2, 3):
        hint = {
            4: " For several materials give a list of arrays, such as list(array).",
        }
        raise ValueError(
            "The array %r has the shape %r: two or three axes are required.%s"
            % (name, array.shape, hint.get(array.ndim, ""))
        )
    if array.size == 0:
        raise ValueError("The array %r has the shape %r: it contains no cells."
                         % (name, array.shape))


def cells_of(array: np.ndarray, order: str) -> Tuple[int, ...]:
    """Returns the numbers of cells along x, y and z."""
    return array.shape[:3] if order == "xyz" else array.shape[2::-1]


def flatten(array: np.ndarray, order: str) -> np.ndarray:
    """Returns an array of shape (cells,) or (cells, components), x fastest, in C order.

    The result is a view if the memory has that order: Fortran order with "xyz", C order with "zyx".
    """
    if order == "xyz":
        array = array.transpose(2, 1, 0, *range(3, array.ndim))
    array = np.ascontiguousarray(array)
    return array.reshape(-1, *array.shape[3:])


def shaped(flat: np.ndarray, cells: Sequence[int], order: str) -> np.ndarray:
    """Returns a view with three axes; flatten() is the inverse."""
    array = flat.reshape(*cells[::-1], *flat.shape[1:])
    return array if order == "zyx" else array.transpose(2, 1, 0, *range(3, array.ndim))


class CellArrays:
    """Arrays by name, of the cells of one grid."""

    def __init__(self, order: str, cells: Optional[Sequence[int]] = None):
        self.order = order
        self.cells: Optional[Tuple[int, ...]] = None if cells is None else tuple(cells)
        self.flat: Dict[str, np.ndarray] = {}
        self.is_plane = False  # whether the first array has two axes

    def _as_layer(self, array: np.ndarray) -> np.ndarray:
        """Returns an array of cells of a plane as one of a layer of cells."""
        if self.cells is None:
            self.is_plane = array.ndim == 2
        if self.is_plane and array.ndim in (2, 3):
            return array[:, :, None] if self.order == "xyz" else array[None]
        return array

    def add(self, name: str, array: np.ndarray) -> None:
        """Adds an array of three axes, or four with components; of a plane one axis less. The first
        array defines the numbers of cells."""
        self._check_name(name)
        array = self._as_layer(array)
        if array.ndim not in (3, 4) or array.size == 0:
            raise ValueError(
                "The array %r has the shape %r: axes for x, y and z are required, and a fourth for "
                "components." % (name, array.shape)
            )
        cells = cells_of(array, self.order)
        if self.cells is None:
            self.cells = cells
        if cells != self.cells:
            expected = self.cells if self.order == "xyz" else self.cells[::-1]
            raise ValueError(
                "The array %r has the shape %r, other arrays of the grid have %r."
                % (name, array.shape, expected)
            )
        self.flat[name] = flatten(array, self.order)

    def add_flat(self, name: str, array: np.ndarray) -> None:
        """Adds an array in the form of the core, shape (cells,) or (cells, components)."""
        self._check_name(name)
        self.flat[name] = np.ascontiguousarray(array)

    def _check_name(self, name: Any) -> None:
        if not isinstance(name, str) or not name:
            raise TypeError("The name of an array is %r: it must be a str." % (name,))
        if name in self.flat:
            raise ValueError("Two arrays are called %r: names must differ." % name)

    def renamed(self, names: Mapping[str, str]) -> CellArrays:
        """Returns the arrays, some of them with other names."""
        arrays = CellArrays(self.order, self.cells)
        arrays.is_plane = self.is_plane
        for name, array in self.flat.items():
            arrays.add_flat(names.get(name, name), array)
        return arrays

    def items(self) -> List[Tuple[str, np.ndarray]]:
        """Returns names and arrays for the core."""
        return list(self.flat.items())
