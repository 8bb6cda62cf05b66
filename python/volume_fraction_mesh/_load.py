"""Reads a mesh that Mesh.save wrote."""

from __future__ import annotations

from typing import Any

from ._npz import read
from .mesh import Mesh


def load(path: Any) -> Mesh:
    """Read a mesh that `Mesh.save` wrote as ``.npz``.

    Parameters
    ----------
    path : str or path-like
        File to read.

    Returns
    -------
    Mesh
        Mesh with all arrays, tables and state of the mesh that was saved.

    Raises
    ------
    ValueError
        If the file is not an archive of a mesh, or lacks an array.
    OSError
        If the file cannot be read.

    See Also
    --------
    Mesh.save : Writes the file.

    Examples
    --------
    >>> mesh = vfm.hexes(vfm.shapes("sphere radius=4 center=6,6,6", 12))
    >>> mesh.save("ball.npz")
    >>> again = vfm.load("ball.npz")
    >>> np.array_equal(again.cells, mesh.cells), again.materials["Name"]
    (True, ['Material1'])
    """
    return Mesh(**read(path))
