"""Exact volume fractions: of shapes written as text, and of what closed surfaces hold."""

from __future__ import annotations

from numbers import Real
from typing import Any, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._arrays import check_order, shaped
from ._grid import make_grid
from ._images import Fractions
from ._progress import shown
from ._surfaces import read_surface
from ._types import Order, Progress, Triple

TOLERANCES = (1e-8, 0.1)
MARGIN = 2  # cells around surfaces


def _check_tolerance(value: Any) -> float:
    text = "tolerance is %r: it must be a number from %g to %g." % (value, *TOLERANCES)
    if not isinstance(value, Real):
        raise TypeError(text)
    if not TOLERANCES[0] <= value <= TOLERANCES[1]:  # nor NaN
        raise ValueError(text)
    return float(value)


def shapes(
    text: str,
    cells: Union[int, Sequence[int]] = 32,
    *,
    spacing: Triple = (1.0, 1.0, 1.0),
    origin: Sequence[float] = (0.0, 0.0, 0.0),
    bounds: Optional[Sequence[float]] = None,
    coordinates: Optional[Sequence[ArrayLike]] = None,
    order: Order = "xyz",
    tolerance: float = 1e-4,
    threads: int = 0,
    progress: Progress = None,
) -> Fractions:
    """Volume fractions of solid shapes, an array a material, which hexes() and tets() take as they
    are.

    Parameters
    ----------
    text : str
        One shape a line, or parted by semicolons, values without spaces; the first that contains a
        point owns it::

            sphere radius=0.4 center=0,0,0        ellipsoid radii=0.4,0.3,0.2      box size=1,1,0.5
            cylinder radius=0.2 height=1          cone bottom=0.4 top=0.1 height=1  torus ring=0.5
            tube=0.2
            halfspace point=0,0,0 normal=0,0,1    plate thickness=0.1 normal=1,1,0  gyroid period=1
            level=0
            polycrystal grains=20 seed=1

        All take material=1 and cut=x,y,z,nx,ny,nz (the part behind a plane); all but halfspace and
        polycrystal a center, those with axes of their own a rotation (degrees about x, y, z).
    cells : int or three
        How many along x, y and z.
    spacing, origin, coordinates
        The grid, as of hexes().
    bounds : six floats
        Instead: minimum and maximum of x, y and z.
    order : {"xyz", "zyx"}
        The axes of the arrays.
    tolerance : float
        The largest error of a fraction where curved surfaces cut a cell, 1e-8 to 0.1.
    threads, progress
        As of hexes().

    Returns
    -------
    Fractions
        A dict of float64 arrays, "Material1", "Material2", ..

    Raises
    ------
    ValueError
        Of text that is no shape: the message tells line and word.
    """
    if not isinstance(text, str):
        raise TypeError("text is a %s: shapes are told by a str." % type(text).__name__)
    error, thread_count = _check_tolerance(tolerance), _core.Options(False, threads=threads).threads
    nodes = _nodes(_counts(cells), spacing, origin, bounds, coordinates)
    check_order(order)
    with shown(progress) as call:
        found = _core.shape_fractions(text, list(nodes), error, thread_count, call)
    return _pack({"Material%d" % (m + 1): flat for m, flat in enumerate(found)}, nodes, order)


def surface(
    surfaces: Any,
    cells: Union[int, Sequence[int]] = 64,
    *,
    triangles: Optional[ArrayLike] = None,
    bounds: Optional[Sequence[float]] = None,
    coordinates: Optional[Sequence[ArrayLike]] = None,
    order: Order = "xyz",
    tolerance: float = 1e-4,
    threads: int = 0,
    progress: Progress = None,
) -> Fractions:
    """Volume fractions of what closed surfaces of triangles hold, which hexes() and tets() take as
    they are.

    Parameters
    ----------
    surfaces : path, pyvista.PolyData, meshio.Mesh, (n, 3) points, or a dict of them
        A closed surface, or one a material by name; these must not overlap. STL files need
        numpy alone, others meshio or PyVista.
    cells : int or three
        How many along x, y and z; one number is that along the longest side, and cells are cubes.
    triangles : (m, 3) int array
        Of points that are given as an array.
    bounds, coordinates
        The grid, else one with cubic cells around the surfaces and two cells between them and its
        sides.
    order, tolerance, threads, progress
        As of shapes().

    Returns
    -------
    Fractions
        A dict of float64 arrays, "Material1" unless a dict names them.

    Raises
    ------
    ValueError
        Of a surface that is open or not manifold, or a file that is none.
    """
    named = dict(surfaces) if isinstance(surfaces, Mapping) else {"Material1": surfaces}
    if triangles is not None and isinstance(surfaces, Mapping):
        raise TypeError(
            "triangles are those of one array of points; of several surfaces give pairs, name: (points, triangles)."
        )
    if not named:
        raise ValueError("surfaces are empty: at least one is needed.")
    error, thread_count = _check_tolerance(tolerance), _core.Options(False, threads=threads).threads
    found = {name: read_surface(value, triangles) for name, value in named.items()}
    if bounds is None and coordinates is None:
        nodes = _fit([points for points, _ in found.values()], cells)
    else:
        nodes = _nodes(_counts(cells), 1.0, (0, 0, 0), bounds, coordinates)
    check_order(order)
    flat = {}
    with shown(progress) as call:
        for name, (points, corners) in found.items():
            flat[name] = _core.triangle_fractions(points, corners, list(nodes), error, thread_count,
                                                  call)
    return _pack(flat, nodes, order)


def _pack(flat: Mapping[str, np.ndarray], nodes: Sequence[np.ndarray], order: str) -> Fractions:
    counts = [len(x) - 1 for x in nodes]
    return Fractions({name: shaped(array, counts, order) for name, array in flat.items()}, nodes,
                     order)


def _counts(cells: Any, least: int = 1) -> Tuple[int, ...]:
    """Along x, y and z."""
    numbers = np.asarray(cells)
    if numbers.shape not in ((), (3,)) or numbers.dtype.kind not in "iu":
        raise TypeError("cells is %r: a whole number is needed, or three." % (cells,))
    if (numbers < least).any():
        raise ValueError("cells is %r: at least %d are needed along every axis." % (cells, least))
    return tuple(int(n) for n in np.broadcast_to(numbers, 3))


def _nodes(counts: Sequence[int], spacing: Any, origin: Any, bounds: Any,
           coordinates: Any) -> Tuple[np.ndarray, ...]:
    if coordinates is not None:
        counts = [len(x) - 1 for x in coordinates]
    if bounds is None:
        return make_grid(counts, spacing, origin, coordinates, None).nodes
    if coordinates is not None:
        raise ValueError("Both bounds and coordinates are given: give one or the other.")
    sides = np.asarray(bounds, dtype=np.float64)
    if sides.shape != (6,) or not (sides[1::2] > sides[::2]).all() or not np.isfinite(sides).all():
        raise ValueError(
            "bounds is %r: minimum and maximum of x, y and z are needed, every minimum below its maximum." % (bounds,)
        )
    return make_grid(counts, (sides[1::2] - sides[::2]) / counts, sides[::2], None, None).nodes


def _fit(surfaces: List[np.ndarray], cells: Any) -> Tuple[np.ndarray, ...]:
    """Cubic cells around all surfaces, centred."""
    lower = np.min([points.min(axis=0) for points in surfaces], axis=0)
    upper = np.max([points.max(axis=0) for points in surfaces], axis=0)
    counts = np.array(_counts(cells, 2 * MARGIN + 1))
    width = ((upper - lower) / (counts - 2 * MARGIN)).max()
    if not (np.isfinite(width) and width > 0):
        raise ValueError("The surfaces have no extent, or points that are not finite.")
    if np.ndim(cells) == 0:  # as few as hold the surfaces
        counts = np.minimum(counts,
                            np.ceil((upper - lower) / width * (1 - 1e-9)).astype(int) + 2 * MARGIN)
    corner = 0.5 * (lower + upper) - 0.5 * width * counts
    return make_grid(counts.tolist(), width, corner, None, None).nodes
