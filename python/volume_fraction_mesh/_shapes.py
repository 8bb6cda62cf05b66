"""Computes exact volume fractions of shapes described by text, and inside closed surfaces."""

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
from ._surfaces import read_bodies
from ._types import Order, Progress, Triple

TOLERANCES = (1e-8, 0.1)
LEAST_CELLS = 5  # along each axis of a grid around surfaces
DEFAULT_CELLS = 64  # along the longest side of surfaces


def _check_tolerance(value: Any) -> float:
    text = "tolerance is %r: it must be a number from %g to %g." % (value, *TOLERANCES)
    if not isinstance(value, Real):
        raise TypeError(text)
    if not TOLERANCES[0] <= value <= TOLERANCES[1]:  # rejects NaN, too
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
    """Compute the volume fractions of solid shapes, one array per material.

    Parameters
    ----------
    text : str
        Shapes, one per line or separated by semicolons, as ``name parameter=value ..`` without
        spaces in a value::

            sphere      radius=0.4
            ellipsoid   radii=0.4,0.3,0.2
            box         size=1,1,0.5
            cylinder    radius=0.2 height=1
            cone        bottom=0.4 top=0.1 height=1
            torus       ring=0.5 tube=0.2
            halfspace   point=0,0,0 normal=0,0,1
            plate       thickness=0.1 normal=1,1,0
            gyroid      period=1 level=0
            polycrystal grains=20 seed=1

        All shapes except halfspace and polycrystal accept ``center=0,0,0``. Ellipsoids, boxes,
        cylinders, cones, tori and gyroids accept ``rotation=0,0,0``, in degrees about x, y and z,
        applied in the order y, x, z. All shapes accept ``material=1``, and any number of
        ``cut=x,y,z,nx,ny,nz``. A cut keeps the part behind the plane through (x, y, z) with the
        normal (nx, ny, nz). The first shape that contains a point owns it. Each grain of a
        polycrystal is a material. Text after # is a comment.
    cells : int or sequence of 3 ints, default 32
        Numbers of cells along x, y and z.
    spacing, origin, coordinates : see hexes
        Grid.
    bounds : sequence of 6 floats, optional
        Grid by its bounds instead: xmin, xmax, ymin, ymax, zmin, zmax.
    order : {"xyz", "zyx"}, default "xyz"
        Order of the axes of the arrays.
    tolerance : float, default 1e-4
        Maximum error of a fraction where curved surfaces cut a cell, 1e-8 to 0.1.
    threads : int, default 0
        Number of threads; 0 uses all cores.
    progress : bool or callable, default None
        Report of progress; see `hexes`.

    Returns
    -------
    Fractions
        Dict of float64 arrays, named "Material1", "Material2" and so on. `hexes` and `tets` accept
        it.

    Raises
    ------
    ValueError
        If the text does not describe shapes; the message names the line and the word. Also if the
        grid or the tolerance is invalid.
    TypeError
        If an argument has the wrong type.

    See Also
    --------
    surface : Volume fractions inside closed surfaces.

    Examples
    --------
    >>> text = "sphere radius=0.5; halfspace point=0,0,-0.6 normal=0,0,1 material=2"
    >>> fractions = vfm.shapes(text, (16, 12, 10), bounds=[-1, 1] * 3)
    >>> {name: array.shape for name, array in fractions.items()}
    {'Material1': (16, 12, 10), 'Material2': (16, 12, 10)}
    >>> volume = fractions["Material1"].sum() * 8 / (16 * 12 * 10)
    >>> round(float(volume), 3)  # pi / 6
    0.524
    """
    if not isinstance(text, str):
        raise TypeError("text is a %s: a str of shapes is required." % type(text).__name__)
    error, thread_count = _check_tolerance(tolerance), _core.Options(False, threads=threads).threads
    nodes = _nodes(_counts(cells), spacing, origin, bounds, coordinates)
    check_order(order)
    with shown(progress) as call:
        found = _core.shape_fractions(text, list(nodes), error, thread_count, call)
    return _pack({"Material%d" % (m + 1): flat for m, flat in enumerate(found)}, nodes, order)


def surface(
    surfaces: Any,
    cells: Union[int, Sequence[int]] = DEFAULT_CELLS,
    *,
    cell_width: Optional[Triple] = None,
    triangles: Optional[ArrayLike] = None,
    bounds: Optional[Sequence[float]] = None,
    coordinates: Optional[Sequence[ArrayLike]] = None,
    order: Order = "xyz",
    tolerance: float = 1e-4,
    threads: int = 0,
    progress: Progress = None,
) -> Fractions:
    """Compute the volume fractions inside closed surfaces of triangles, one array per surface.

    Parameters
    ----------
    surfaces : path, pyvista.PolyData, meshio.Mesh, array_like or tuple, or dict or list
        A closed surface: a file, an object of PyVista or meshio, points of shape (n, 3), or a tuple
        (points, triangles). A dict holds one surface per material, by name; a list of files gives
        the materials the names of the files. Where surfaces overlap, the first one keeps its
        volume. Files of formats other than those of `sculptor` require meshio.
    cells : int or sequence of 3 ints, default 64
        Numbers of cells along x, y and z. One number is the number along the longest side, with
        cubic cells.
    cell_width : float or three of them, optional
        Width of the cells instead, in the unit of the surfaces.
    triangles : array_like of int, shape (m, 3), optional
        Triangles of an array of points.
    bounds, coordinates : see shapes
        Grid. Default: cubic cells around the surfaces, with two cells between them and each side.
    order, threads, progress : see shapes
        Order of axes, and run.
    tolerance : float, default 1e-4
        No effect: the fractions are exact, except where boundaries of bodies that overlap cut one
        cell: there the overlap is measured on 55 rays.

    Returns
    -------
    Fractions
        Dict of float64 arrays, named as in `surfaces`, or "Material1". `hexes` and `tets` accept
        it, and place nodes, edges and sides by the triangles, which are its attribute `surfaces`.

    Raises
    ------
    ValueError
        If a surface is open, or a file does not hold a surface.
    TypeError
        If an argument has the wrong type.
    ImportError
        If a file requires meshio, and meshio is not installed.

    See Also
    --------
    shapes : Volume fractions of shapes.

    Examples
    --------
    A tetrahedron:

    >>> points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], float)
    >>> triangles = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]
    >>> fractions = vfm.surface({"steel": (points, triangles)}, 12)
    >>> mesh = vfm.hexes(fractions, sharp_edges="on")
    >>> mesh.materials["Name"], mesh.materials["MeshVolume"].round(4)  # 1 / 6
    (['steel'], array([0.1667]))
    """
    _check_tolerance(tolerance)
    thread_count = _core.Options(False, threads=threads).threads
    if cell_width is not None and (
            bounds is not None or np.any(np.not_equal(cells, DEFAULT_CELLS))):
        raise ValueError("Both cell_width and cells or bounds are given: give one or the other.")
    bodies = read_bodies(surfaces, triangles)
    if bounds is None and coordinates is None:
        nodes = _fit(bodies, cells, cell_width)
    else:
        nodes = _nodes(_counts(cells), (1.0, 1.0, 1.0), (0, 0, 0), bounds, coordinates)
    check_order(order)
    with shown(progress) as call:
        arrays = _core.surface_fractions(bodies, list(nodes), thread_count, call)
    return _pack(dict(zip(bodies.names, arrays)), nodes, order, bodies)


def _pack(flat: Mapping[str, np.ndarray], nodes: Sequence[np.ndarray], order: str,
          bodies: Optional[_core.Bodies] = None) -> Fractions:
    counts = [len(x) - 1 for x in nodes]
    return Fractions({name: shaped(array, counts, order) for name, array in flat.items()}, nodes,
                     order, bodies)


def _counts(cells: Any, least: int = 1) -> Tuple[int, ...]:
    """Returns the numbers of cells along x, y and z."""
    numbers = np.asarray(cells)
    if numbers.shape not in ((), (3,)) or numbers.dtype.kind not in "iu":
        raise TypeError("cells is %r: an integer is required, or three." % (cells,))
    if (numbers < least).any():
        raise ValueError("cells is %r: at least %d are required along every axis." % (cells, least))
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
            "bounds is %r: minimum and maximum of x, y and z are required, each minimum below its "
            "maximum." % (bounds,)
        )
    return make_grid(counts, (sides[1::2] - sides[::2]) / counts, sides[::2], None, None).nodes


def _fit(bodies: _core.Bodies, cells: Any, width: Any) -> Tuple[np.ndarray, ...]:
    """Returns the nodes of a grid around all bodies, with these in its centre."""
    if width is None:
        counts = _counts(cells, LEAST_CELLS)
        return tuple(bodies._place(counts[:1] if np.ndim(cells) == 0 else counts, None))
    text = "cell_width is %r: one number above 0 is required, or three." % (width,)
    try:
        widths = np.broadcast_to(np.asarray(width, np.float64), 3)
    except (TypeError, ValueError):
        raise TypeError(text) from None
    if not (np.isfinite(widths) & (widths > 0)).all():
        raise ValueError(text)
    return tuple(bodies._place([], widths.tolist()))
