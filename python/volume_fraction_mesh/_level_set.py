"""Computes the volume fractions of level sets, such as signed distances."""

from __future__ import annotations

from typing import Any, Optional, Sequence

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._arrays import shaped
from ._images import Fractions
from ._input import Source, read_field
from ._progress import shown
from ._types import Order, Progress, Triple


def level_set(
    phi: Any,
    *,
    rule: str = "priority",
    inside: str = "negative",
    spacing: Triple = (1.0, 1.0, 1.0),
    origin: Sequence[float] = (0.0, 0.0, 0.0),
    coordinates: Optional[Sequence[ArrayLike]] = None,
    order: Order = "xyz",
    names: Optional[Sequence[str]] = None,
    arrays: Optional[Sequence[str]] = None,
    threads: int = 0,
    progress: Progress = None,
) -> Fractions:
    """Compute the volume fractions of level sets, one array per material.

    The part of each cell where a level set is negative becomes its fraction: exactly for planes,
    with an error of fourth order in the width of the cells for smooth surfaces. `hexes` and `tets`
    do the same with the option ``level_sets``, also for blocks of files.

    Parameters
    ----------
    phi : array_like, list or dict of them, or image
        Signed distances, or other functions that are negative inside their material, at the centres
        of the cells; shapes and images as in `hexes`.
    rule : {"priority", "lowest", "fill"}, default "priority"
        Material of a point where several level sets are negative: the first of them, so that each
        may contain those before it, as layers of films do; or that of the lowest value. With
        "fill" each point belongs to the lowest value, even if it is positive.
    inside : {"negative", "positive"}, default "negative"
        Sign of the level sets inside their material.
    spacing, origin, coordinates : see hexes
        Grid.
    order : {"xyz", "zyx"}, default "xyz"
        Order of the axes of the arrays.
    names, arrays : see hexes
        Names of the materials; arrays of an image.
    threads, progress : see hexes
        Run.

    Returns
    -------
    Fractions
        Dict of float64 arrays, named as those of `phi`. `hexes` and `tets` accept it.

    Raises
    ------
    ValueError
        If no value is inside, or a word is unknown, or an array has the wrong shape.
    TypeError
        If an argument has the wrong type.

    See Also
    --------
    hexes : Its option ``level_sets`` meshes level sets directly.
    shapes, surface : Fractions of shapes and closed surfaces.

    Examples
    --------
    A ball under a film of 0.02, which is thinner than the cells:

    >>> x, y, z = np.meshgrid(*[np.linspace(-0.95, 0.95, 20)] * 3, indexing="ij")
    >>> r = np.sqrt(x**2 + y**2 + z**2)
    >>> parts = vfm.level_set({"ball": r - 0.6, "film": r - 0.62}, spacing=0.1, origin=(-1, -1, -1))
    >>> volumes = [float(part.sum()) * 0.1**3 for part in parts.values()]
    >>> exact = np.diff([0, 0.6**3, 0.62**3]) * 4 / 3 * np.pi
    >>> bool(np.allclose(volumes, exact, rtol=1e-3))
    True
    """
    given = _core.Options(False, threads=threads)
    field = read_field(Source(phi, None, spacing, origin, coordinates, None, order, names, arrays))
    if field.blocks is not None:
        raise TypeError("phi are blocks of a file: hexes(.., level_sets=%r) meshes them." % rule)
    if not np.allclose(field.grid.direction, np.eye(3), rtol=0, atol=1e-12):
        raise ValueError("The image is rotated: hexes(.., level_sets=%r) meshes it." % rule)
    if field.labels:
        raise ValueError("%r holds integers from 0: a level set is negative inside its material."
                         % field.labels)
    chosen = [(name, flat) for name, flat in field.arrays.items() if name in field.fractions]
    with shown(progress) as call:
        found = _core.level_set_fractions(chosen, list(field.grid.nodes), rule, inside,
                                          given.threads, call)
    cells = field.grid.cells
    return Fractions({name: shaped(flat, cells, order) for (name, _), flat in zip(chosen, found)},
                     field.grid.nodes, order)
