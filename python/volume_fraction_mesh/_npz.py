"""Writes and reads a whole mesh as a NumPy archive, .npz."""

from __future__ import annotations

import json
from typing import IO, TYPE_CHECKING, Any, Dict

import numpy as np

if TYPE_CHECKING:
    from .mesh import Mesh

FORMAT = "volume_fraction_mesh 1"  # value of the key "format"
ARRAYS = ("points", "cells", "material", "fragment", "point_ids", "cell_ids")
OPTIONAL = ("quality", "partner", "original_ids", "mids", "layer")
PARTS = {
    "geometry": ("dimension", "id"),
    "surfaces": ("cells", "surface_id", "material_pair", "domain_side", "fields"),
    "curves": ("cells", "curve_id", "fields"),
    "vertices": ("points", "vertex_id", "fields"),
}
TABLES = ("state", "point_state", "materials", "fields", "roles")


def write(mesh: Mesh, file: IO[bytes], compress: bool = False) -> None:
    """Writes all arrays of a mesh by key: an attribute, or attribute/name."""
    arrays: Dict[str, Any] = {"format": FORMAT}
    arrays.update((name, getattr(mesh, name)) for name in ARRAYS)
    arrays.update((name, getattr(mesh, name)) for name in OPTIONAL
                  if getattr(mesh, name) is not None)
    for part, names in PARTS.items():
        for name in names:
            _add(arrays, "%s/%s" % (part, name), getattr(getattr(mesh, part), name))
    for name in TABLES:
        _add(arrays, name, getattr(mesh, name))
    arrays["run"] = json.dumps(vars(mesh.run), default=str)
    (np.savez_compressed if compress else np.savez)(file, **arrays)


def _add(arrays: Dict[str, Any], key: str, values: Any) -> None:
    if isinstance(values, dict):
        for name, column in values.items():
            _add(arrays, "%s/%s" % (key, name), column)
    else:
        arrays[key] = np.array(values, dtype=str) if isinstance(values, list) else values


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
    try:
        with np.load(path, allow_pickle=False) as archive:
            arrays = {name: archive[name] for name in archive.files}
        if str(arrays.pop("format")) != FORMAT:
            raise KeyError("format")
        return _make_mesh(arrays)
    except (KeyError, AttributeError, ValueError, EOFError) as problem:
        raise ValueError("%s is not a mesh that Mesh.save wrote as .npz (%s)."
                         % (path, problem)) from None


def _make_mesh(arrays: Dict[str, Any]) -> Mesh:
    from . import mesh as types

    parts = {name: {own: _take(arrays, "%s/%s/" % (name, own)) if own == "fields"
                    else arrays["%s/%s" % (name, own)] for own in names}
             for name, names in PARTS.items()}
    return types.Mesh(
        **{name: arrays[name] for name in ARRAYS},
        **{name: arrays.get(name) for name in OPTIONAL},
        geometry=types.Geometry(**parts["geometry"]),
        surfaces=types.Surfaces(**parts["surfaces"]),
        curves=types.Curves(**parts["curves"]),
        vertices=types.Vertices(**parts["vertices"]),
        run=types.Run(**json.loads(str(arrays["run"]))),
        **{name: _take(arrays, name + "/") for name in TABLES},
    )


def _take(arrays: Dict[str, Any], prefix: str) -> Dict[str, Any]:
    """Returns the arrays whose key begins with a prefix; texts as lists, a single text as str."""
    return {key[len(prefix):]: values.tolist() if values.dtype.kind == "U" else values
            for key, values in arrays.items() if key.startswith(prefix)}
