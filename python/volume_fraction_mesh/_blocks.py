"""Files of blocks of cells, on any number of levels: SpyPlot cases of CTH and plotfiles of codes on
AMReX."""

from __future__ import annotations

import os
from typing import Optional, Sequence, Union

from . import _core
from ._core import Blocks


def is_block_file(path: str) -> bool:
    """Whether read() takes it."""
    return path.lower().endswith(".spcth") or os.path.isfile(os.path.join(path, "Header"))


def read(path: Union[str, "os.PathLike[str]"], *, step: int = 0,
         arrays: Optional[Sequence[str]] = None) -> Blocks:
    """Read a SpyPlot case of CTH, or an AMReX plotfile, as input of `hexes` and `tets`.

    Parameters
    ----------
    path : str or path
        A case file ``.spcth`` or one of its binary files, versions 101 to 105; or the folder of a
        plotfile.
    step : int, default 0
        Which of the times of the file; negative ones count from the end.
    arrays : list of str, optional
        Names of the arrays to read. Default: all.

    Returns
    -------
    Blocks
        Blocks of cells on all levels, without ghost cells. Attributes: ``path``, ``times``,
        ``time``; ``names`` of the arrays; ``fractions``, those that hold materials if `hexes` is
        given none by ``arrays=``. ``len(blocks)``: number of blocks.

    Raises
    ------
    ValueError
        If the file is damaged, or has no such step or array; the message names the place.

    Examples
    --------
    >>> blocks = vfm.read("impact.spcth", step=-1)                        # doctest: +SKIP
    >>> vfm.hexes(blocks, state=["X velocity"]).save("impact.vtu")        # doctest: +SKIP
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
