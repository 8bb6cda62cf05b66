"""Reads files of blocks of cells on any number of levels: SpyPlot files of CTH, plotfiles of
AMReX codes."""

from __future__ import annotations

import os
from typing import Optional, Sequence, Union

from . import _core
from ._core import Blocks


def is_block_file(path: str) -> bool:
    """Returns whether read() supports a file or folder."""
    return path.lower().endswith(".spcth") or os.path.isfile(os.path.join(path, "Header"))


def read(path: Union[str, "os.PathLike[str]"], *, step: int = 0,
         arrays: Optional[Sequence[str]] = None) -> Blocks:
    """Read a SpyPlot file of CTH or an AMReX plotfile as input of `hexes` and `tets`.

    Parameters
    ----------
    path : str or path-like
        A case file ``.spcth`` or one of its binary files, versions 101 to 105; or the folder of a
        plotfile.
    step : int, default 0
        Index of the time step; negative values count from the end.
    arrays : list of str, optional
        Names of the arrays to read. Default: all.

    Returns
    -------
    Blocks
        Blocks of cells on all levels, without ghost cells; ``len(blocks)`` is their number.
        Attributes: ``path``, ``times`` (of all steps), ``time``, ``names`` (of the arrays) and
        ``fractions`` (arrays that hold materials, the default of `arrays` in `hexes`).

    Raises
    ------
    FileNotFoundError
        If `path` does not exist.
    ValueError
        If the file is of another format or damaged, or lacks the step or an array. The message
        names the place.

    See Also
    --------
    hexes, tets : Make a mesh of the result.

    Examples
    --------
    An impact in a file of CTH; state arrays are selected by their names:

    >>> blocks = vfm.read("impact.spcth", step=-1)
    >>> len(blocks), len(blocks.times)
    (4, 4)
    >>> blocks.fractions
    ['Material volume fraction - 1', 'Material volume fraction - 2']
    >>> mesh = vfm.hexes(blocks, state=["X velocity"])
    >>> list(mesh.state)
    ['X velocity']
    """
    if isinstance(arrays, str):
        raise TypeError("arrays is %r: it must be a list of names." % (arrays,))
    path = os.fspath(path)
    if not os.path.exists(path):
        raise FileNotFoundError("There is no file %s." % path)
    if not is_block_file(path):
        raise ValueError(
            "%s is neither a SpyPlot file (.spcth) nor a folder with the Header of a plotfile."
            % path)
    return _core.read_blocks(path, step, None if arrays is None else list(arrays))
