"""Arrays of cells as the core takes them: flat, x fastest, numeric, and where it can be not
copied."""

from __future__ import annotations

from typing import Any, Dict, List, Optional, Sequence, Tuple

import numpy as np

ORDERS = ("xyz", "zyx")


def check_order(order: Any) -> str:
    """One of ORDERS."""
    if isinstance(order, str) and order in ORDERS:
        return order
    raise (ValueError if isinstance(order, str) else TypeError)(
        "order is %r: it must be 'xyz' (array[i, j, k], i along x) or 'zyx' (array[k, j, i])."
        % (order,)
    )


def as_numbers(values: Any, name: str) -> np.ndarray:
    """An array of a type that the core knows."""
    if isinstance(values, np.ma.MaskedArray) and np.ma.is_masked(values):
        raise ValueError("The array %r is masked: fill it first, as by array.filled(0)." % name)
    array = np.asarray(values)
    if array.dtype.kind not in "biuf" or array.dtype.itemsize > 8:
        raise TypeError(
            "The array %r is of the type %s: whole or real numbers of up to 8 bytes are needed."
            % (name, array.dtype)
        )
    if array.dtype == np.bool_:
        return array.view(np.uint8)
    if array.dtype == np.float16:
        return array.astype(np.float32)
    return array if array.dtype.isnative else array.astype(array.dtype.newbyteorder("="))


def as_fractions(values: Any, name: str) -> np.ndarray:
    """Of real numbers or bytes, 255 for 1."""
    if np.asarray(values).dtype == np.bool_:
        return np.multiply(values, 255, dtype=np.uint8)
    array = as_numbers(values, name)
    if array.dtype.kind != "f" and array.dtype != np.uint8:
        raise TypeError(
            "The array %r of fractions is of the type %s: volume fractions are real numbers in "
            "[0, 1], bool, or uint8 from 0 to 255. "
            "Whole numbers that name materials are given as labels=." % (name, array.dtype)
        )
    return array


def check_3d(array: np.ndarray, name: str) -> None:
    """Of a material: three axes, none empty."""
    if array.ndim != 3:
        hint = {
            2: " Of a single layer of cells array[:, :, None].",
            4: " Of one array a material give a list, as list(array).",
        }
        raise ValueError(
            "The array %r has the shape %r: three axes are needed.%s"
            % (name, array.shape, hint.get(array.ndim, ""))
        )
    if array.size == 0:
        raise ValueError("The array %r has the shape %r: there are no cells in it."
                         % (name, array.shape))


def cells_of(array: np.ndarray, order: str) -> Tuple[int, ...]:
    """How many along x, y and z."""
    return array.shape[:3] if order == "xyz" else array.shape[2::-1]


def flatten(array: np.ndarray, order: str) -> np.ndarray:
    """(cells,) or (cells, components), x fastest, in C order.

    A view where memory is so, as of Fortran order with "xyz" and of C order with "zyx".
    """
    if order == "xyz":
        array = array.transpose(2, 1, 0, *range(3, array.ndim))
    array = np.ascontiguousarray(array)
    return array.reshape(-1, *array.shape[3:])


def shaped(flat: np.ndarray, cells: Sequence[int], order: str) -> np.ndarray:
    """The view that flatten() turns back."""
    array = flat.reshape(*cells[::-1], *flat.shape[1:])
    return array if order == "zyx" else array.transpose(2, 1, 0, *range(3, array.ndim))


class CellArrays:
    """Arrays of the cells of one grid, by name."""

    def __init__(self, order: str, cells: Optional[Sequence[int]] = None):
        self.order = order
        self.cells: Optional[Tuple[int, ...]] = None if cells is None else tuple(cells)
        self.flat: Dict[str, np.ndarray] = {}

    def add(self, name: str, array: np.ndarray) -> None:
        """Of three axes and, if it has several components, a fourth. The first one tells the
        cells."""
        self._check_name(name)
        if array.ndim not in (3, 4) or array.size == 0:
            raise ValueError(
                "The array %r has the shape %r: an axis each for x, y and z is needed, and one more for components."
                % (name, array.shape)
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
        """(cells,) or (cells, components), as the core takes it."""
        self._check_name(name)
        self.flat[name] = np.ascontiguousarray(array)

    def _check_name(self, name: Any) -> None:
        if not isinstance(name, str) or not name:
            raise TypeError("The name of an array is %r: it must be a text." % (name,))
        if name in self.flat:
            raise ValueError("Two arrays are called %r: each needs a name of its own." % name)

    def items(self) -> List[Tuple[str, np.ndarray]]:
        """As the core takes them."""
        return list(self.flat.items())
