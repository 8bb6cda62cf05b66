"""Reads the cell arrays of DREAM.3D 6 and DREAM3D-NX by h5py."""

from __future__ import annotations

from typing import Any, Dict, Iterator, List, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from .._arrays import as_numbers
from .._grid import Grid, even_nodes
from .named_files import TRUST
from .report import load_library

ENDING = ".dream3d"
DEFAULT = "FeatureIds"
DEEPEST = 4  # levels of nested groups that are searched
# Names of sizes, spacing and origin, and the group that holds them.
NAMES = (("_SIMPL_GEOMETRY", ("DIMENSIONS", "SPACING", "ORIGIN")),
         ("", ("_DIMENSIONS", "_SPACING", "_ORIGIN")))


class CellData(NamedTuple):
    """Grid of an image geometry and its cell arrays, x fastest, by name."""

    grid: Grid
    arrays: Dict[str, np.ndarray]


def read(path: str, names: Optional[Sequence[str]], is_trusted: bool) -> CellData:
    """Reads the arrays of the image geometry that has the selected arrays, or FeatureIds.
    is_trusted: values may be in other files."""
    h5py = load_library("h5py", path)
    wanted = list(names or [DEFAULT])
    with h5py.File(path, "r") as file:
        found = [(group, grid, dict(list_arrays(h5py, group, grid, is_trusted)))
                 for group, grid in find_geometries(h5py, file, DEEPEST)]
        if not found:
            raise ValueError("it has no image geometry.")
        fitting = [each for each in found if all(name in each[2] for name in wanted)]
        if len(fitting) > 1:
            raise ValueError("%d of its image geometries have the array '%s': %s."
                             % (len(fitting), wanted[0], ", ".join(g.name for g, _, _ in fitting)))
        if not fitting and names is not None:
            raise ValueError("it has no cell arrays %s. Its cell arrays: %s." % (
                ", ".join(map(repr, wanted)),
                ", ".join(repr(name) for _, _, arrays in found for name in arrays) or "none"))
        _, grid, arrays = (fitting or found)[0]
        return CellData(grid, {name: _flatten(data, grid.cells) for name, data in arrays.items()})


def find_geometries(h5py: Any, group: Any, depth: int) -> Iterator[Tuple[Any, Grid]]:
    for name in group:
        if not isinstance(group.get(name, getlink=True), h5py.HardLink):
            continue
        child = group[name]
        if not isinstance(child, h5py.Group):
            continue
        grid = _read_grid(child)
        if grid is not None:
            yield child, grid
        elif depth > 0:
            yield from find_geometries(h5py, child, depth - 1)


def _read_grid(group: Any) -> Optional[Grid]:
    for place, names in NAMES:
        holder = group.get(place) if place else group
        if holder is None:
            continue
        values = [holder[name][()] if name in holder else holder.attrs.get(name) for name in names]
        if all(value is not None and np.size(value) == 3 for value in values):
            sizes, widths, origin = (np.ravel(value).astype(float) for value in values)
            if not ((sizes >= 1).all() and (widths > 0).all() and np.isfinite(values).all()):
                raise ValueError("the sizes or spacing of %s are not above 0." % group.name)
            nodes = tuple(even_nodes(o, w, 0, int(n)) for o, w, n in zip(origin, widths, sizes))
            return Grid(nodes, origin=tuple(origin))
    return None


def list_arrays(h5py: Any, group: Any, grid: Grid,
                 is_trusted: bool) -> Iterator[Tuple[str, Any]]:
    """Yields names and data sets of numbers with one tuple per cell. DREAM.3D 6 also stores them
    flat, as (cells, components)."""
    shape, count = grid.cells[::-1], int(np.prod(grid.cells))
    for matrix in group:
        inner = open_member(h5py, group, matrix, is_trusted)
        for name in inner if hasattr(inner, "keys") else []:
            data = open_member(h5py, inner, name, is_trusted)
            if getattr(data, "shape", None) and data.dtype.kind in "biuf" and (
                    data.shape[:3] == shape or data.shape[0] == count and data.ndim <= 2):
                yield name, data


def open_member(h5py: Any, group: Any, name: str, is_trusted: bool) -> Any:
    """Returns a member of a group. Raises ValueError if it is in another file."""
    if not is_trusted and isinstance(group.get(name, getlink=True), h5py.ExternalLink):
        raise ValueError("its link %r leads to another file. %s" % (name, TRUST))
    member = group[name]
    if not is_trusted and isinstance(member, h5py.Dataset) and (
            member.is_virtual or member.external):
        raise ValueError("%s has its values in other files. %s" % (member.name, TRUST))
    return member


def _flatten(data: Any, cells: List[int]) -> np.ndarray:
    values = as_numbers(data[()], data.name)
    values = values.reshape(int(np.prod(cells)), -1)
    return np.ascontiguousarray(values[:, 0] if values.shape[1] == 1 else values)
